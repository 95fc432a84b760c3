// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files as programs have written them, where there are any: their counts and values, and one surface that is in all
// text exports of OpendTect.

#include "Common/Survey/PickPlacement.h"
#include "TextTables.h"
#include "Tools/Check.h"
#include "Tools/RealHorizons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace TextTables;

namespace
{
constexpr int Skipped = 77;

PickTable ReadFile(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  const TextLayout layout = ReadTextLayout(stream, TextOptions());
  return ReadPicks(stream, layout);
}

struct Expected
{
  const char* File;
  std::size_t Picks, Horizons;
  const char* Columns;
  double LeastZ, LargestZ, TenthZ;
};

constexpr std::array<Expected, 4> Files = { {
  { "opendtect/F3_Multi-H2-H4_ILXL_Single-line-header.dat", 16517, 2, "il xl z", 633.5012316703796, 998.6216425895691,
    864.8542165756226 },
  { "opendtect/Test_Multi_XY-and-ILXL_Z-only.dat", 20, 2, "il xl x y z", 1290.0543212890625, 1305.0181865692139,
    1305.0181865692139 },
  { "ijxyz1.dat", 2578, 1, "il xl x y z", 1654.4211, 16008.13, 1669.507 },
  { "ijxyz1.map", 2578, 1, "il xl x y z", 1654.4211, 16008.13, 1669.507 },
} };

void TestFiles(const std::filesystem::path& folder)
{
  for (const Expected& expected : Files)
  {
    const PickTable picks = ReadFile(folder / expected.File);
    std::cerr << expected.File << ", if anything is wrong below\n";
    CHECK_EQUAL(picks.Size(), expected.Picks);
    CHECK_EQUAL(picks.Names.size(), expected.Horizons);
    CHECK_EQUAL(Columns(picks).Names, std::string(expected.Columns));
    CHECK_EQUAL(*std::min_element(picks.Z.begin(), picks.Z.end()), expected.LeastZ);
    CHECK_EQUAL(*std::max_element(picks.Z.begin(), picks.Z.end()), expected.LargestZ);
    CHECK_EQUAL(ToText(picks.Z[9]), ToText(expected.TenthZ));
  }
}

/// The header of OpenWorks says more than the columns, which are the same without it.
void TestOpenWorks(const std::filesystem::path& folder)
{
  const PickTable picks = ReadFile(folder / "ijxyz1.dat");
  const PickTable others = ReadFile(folder / "ijxyz1.map");
  CHECK(picks.Inline == others.Inline && picks.Crossline == others.Crossline && picks.Z == others.Z);
  CHECK(picks.X == others.X && picks.Y == others.Y);
  CHECK_EQUAL(picks.Survey.CoordinateSystem, std::string("ST_ED50_UTM31N_P23031_T1133"));
  CHECK_EQUAL(picks.Survey.HorizontalUnit, std::string("m"));
  const SurveyHorizons placed = PlacePicks(picks, {});
  CHECK(placed.LargestDistance < 1e-5);
  CHECK(placed.Lattice.Columns[0] > 1 && placed.Lattice.Lines->CrosslineStep == 1.0);
}

std::vector<std::filesystem::path> Segments(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "opendtect"))
  {
    if (entry.path().filename().string().rfind("Segment_", 0) == 0)
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A point of a surface in the world.
using Point = std::array<double, 3>;

/// The points of a surface, by z and then x.
std::vector<Point> WorldPoints(const SurveyHorizons& survey)
{
  std::vector<Point> points;
  const LatticeHorizon& horizon = survey.Horizons.front();
  for (std::size_t n = 0; n < horizon.RealZ.size(); ++n)
  {
    const Eigen::Vector2d place = survey.Lattice.Origin + survey.Lattice.ColumnStep * horizon.Column[n].X +
      survey.Lattice.RowStep * horizon.Column[n].Y;
    points.push_back({ horizon.RealZ[n], place.x(), place.y() });
  }
  std::sort(points.begin(), points.end());
  return points;
}

double LargestDistance(const std::vector<Point>& points, const std::vector<Point>& others)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    largest = std::max(largest, std::hypot(points[n][1] - others[n][1], points[n][2] - others[n][2]));
  }
  return largest;
}

/// Bit by bit, where both have a number.
bool AgreeInNumbers(const std::vector<double>& values, const std::vector<double>& others)
{
  return std::equal(values.begin(), values.end(), others.begin(), others.end(),
    [](double value, double other) { return value == other || std::isnan(value) || std::isnan(other); });
}

/// All files have the picks in the same order. One of them lacks some z.
void TestSegment(const std::filesystem::path& path, PickTable whole)
{
  const PickTable picks = ReadFile(path);
  CHECK(AgreeInNumbers(picks.Z, whole.Z));
  for (std::size_t n = 0; n < picks.Size(); ++n)
  {
    whole.Z[n] = picks.Z[n];
  }
  CHECK(!picks.HasLines() || (picks.Inline == whole.Inline && picks.Crossline == whole.Crossline));
  for (std::size_t n = 0; n < picks.Attributes.size(); ++n)
  {
    CHECK(AgreeInNumbers(picks.Attributes[n].Values, whole.Attributes[n].Values));
  }
  const SurveyHorizons placed = PlacePicks(picks, {});
  CHECK_EQUAL(std::max(placed.Lattice.Columns[0], placed.Lattice.Columns[1]), 57);
  CHECK_EQUAL(std::min(placed.Lattice.Columns[0], placed.Lattice.Columns[1]), 54);
  CHECK_EQUAL(
    placed.Horizons.front().RealZ.size() + std::size_t(placed.Horizons.front().DroppedNulls), std::size_t(829));
  if (picks.HasPlaces())
  {
    const double step = 50.0;
    const bool isIesx = path.filename().string().find("IESX") != std::string::npos; // places have other digits there
    const double distance = LargestDistance(WorldPoints(placed), WorldPoints(PlacePicks(whole, {})));
    CHECK(distance < (isIesx ? 1e-4 : 1e-6) * step);
  }
}

void TestSegments(const std::filesystem::path& folder)
{
  const PickTable whole = ReadFile(folder / "opendtect/Segment_XY-and-ILXL_Multi-line-header.dat");
  CHECK_EQUAL(whole.Attributes.size(), std::size_t(4));
  const std::vector<std::filesystem::path> paths = Segments(folder);
  CHECK_EQUAL(paths.size(), std::size_t(11));
  for (const std::filesystem::path& path : paths)
  {
    std::cerr << path.filename() << ", if anything is wrong below\n";
    TestSegment(path, whole);
  }
  const PickTable nulls = ReadFile(folder / "opendtect/Segment_XY_No-header_NULLs.dat");
  CHECK(std::isnan(nulls.Attributes[1].Values[0]) && !std::isnan(nulls.Attributes[0].Values[0]));
  CHECK_EQUAL(std::count_if(nulls.Z.begin(), nulls.Z.end(), [](double z) { return std::isnan(z); }), 4);
}

/// The .ijz files are read by another reader, too.
void TestLatticeIndices()
{
  const std::vector<std::filesystem::path> files = RealHorizons::Files();
  CHECK(files.size() >= 7);
  for (const std::filesystem::path& file : files)
  {
    std::vector<double> heights;
    const Patches::Columns columns = RealHorizons::Read(file, &heights);
    const PickTable picks = ReadFile(file);
    CHECK_EQUAL(picks.Size(), columns.size());
    CHECK(std::equal(picks.Z.begin(), picks.Z.end(), heights.begin(), heights.end()));
    CHECK(std::equal(picks.Crossline.begin(), picks.Crossline.end(), columns.begin(),
      [](double i, const PlanePoint& column) { return i == double(column.X); }));
    CHECK(std::equal(picks.Inline.begin(), picks.Inline.end(), columns.begin(),
      [](double j, const PlanePoint& column) { return j == double(column.Y); }));
  }
}
}

int TestRealTexts(int argc, char* argv[])
{
  const std::filesystem::path folder = std::filesystem::path(argc > 2 ? argv[2] : "") / "formats";
  if (!std::filesystem::is_directory(folder))
  {
    return Skipped;
  }
  TestFiles(folder);
  TestOpenWorks(folder);
  TestSegments(folder);
  TestLatticeIndices();
  return Check::Result();
}
