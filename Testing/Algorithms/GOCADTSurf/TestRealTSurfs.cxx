// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults and horizons as programs wrote them, in formats/tsurf of the folder of real data.

#include "Readers/GOCADTSurf/TSurfParser.h"
#include "Tools/Check.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int Skipped = 77;

struct Expected
{
  std::string Name; // also that of the file
  std::size_t Vertices;
  std::size_t Triangles;
  std::size_t Borders;
  std::array<double, 3> LastVertex;
};

// Counted with grep in the files.
const std::vector<Expected> Files = {
  { "F5", 44, 65, 0, { 459651.376465, 5936259.713867, 1721.204224 } },
  { "GVFA-WWFZ-EAST-Scodie_Lineament-CFM1", 6, 4, 4, { 410852.8125, 3956959, -13036.85546875 } },
  { "PNRA-SJFZ-SBRN-Glen_Helen_fault-CFM4_1000m", 315, 562, 0, { 454027.68750, 3791150.25000, 1046.00000 } },
  { "RedMtn-east-link-top", 51, 72, 1, { 263568.34375, 3804624.46875, -1262.825927734375 } },
  { "SAFS-SAFZ-MULT-San_Andreas_fault-single-M3M4", 1247, 2162, 14, { 179036.34375, 3989825.25, -10148.0107421875 } },
  { "WTRA-NCVS-VNTB-Ventura_fault-lower-alt1-CFM5", 64, 100, 1, { 298969.8125, 3804656.359375, -8701.6728515625 } },
  { "WTRA-SFFS-LABS-North_Salt_Lake_blind_fault-CFM3", 21, 19, 0, { 375046.00000, 3772993.00000, -1500.00000 } },
};

void CheckFile(const std::filesystem::path& folder, const Expected& expected)
{
  std::ifstream stream(folder / (expected.Name + ".ts"), std::ios::binary);
  const std::vector<TSurf> surfaces = LoadTSurfs(stream, [](std::size_t) { return true; });
  CHECK_EQUAL(surfaces.size(), 1u);
  const TSurf& surface = surfaces.at(0);
  CHECK_EQUAL(surface.Name, expected.Name);
  CHECK_EQUAL(surface.Vertices.size(), expected.Vertices);
  CHECK_EQUAL(surface.Triangles.size(), expected.Triangles);
  CHECK_EQUAL(surface.Borders.size(), expected.Borders);
  CHECK(surface.Vertices.back() == expected.LastVertex);
  CHECK_EQUAL(surface.Survey.VerticalUnit, "m");
  CHECK((surface.Positive == VerticalPositive::Depth) == (expected.Name == "F5"));
}

/// Sections of a border run against the triangles beside them; the writer goes by that.
void CheckBorders(const std::filesystem::path& folder, const Expected& expected)
{
  std::ifstream stream(folder / (expected.Name + ".ts"), std::ios::binary);
  const std::vector<TSurf> surfaces = LoadTSurfs(stream, [](std::size_t) { return true; });
  const TSurf& surface = surfaces.at(0);
  for (const std::array<PointId, 2>& border : surface.Borders)
  {
    CHECK(std::any_of(surface.Triangles.begin(), surface.Triangles.end(),
      [&border](const TSurf::Triangle& triangle)
      {
        const auto first = std::find(triangle.begin(), triangle.end(), border[1]);
        return first != triangle.end() && triangle[std::size_t(first - triangle.begin() + 1) % 3] == border[0];
      }));
  }
}
}

int TestRealTSurfs(int argc, char* argv[])
{
  const std::filesystem::path folder = std::filesystem::path(argc > 2 ? argv[2] : "") / "formats" / "tsurf";
  if (!std::filesystem::is_directory(folder))
  {
    std::cout << "no real surfaces in " << folder << ", skipped\n";
    return Skipped;
  }
  for (const Expected& expected : Files)
  {
    CheckFile(folder, expected);
    CheckBorders(folder, expected);
  }
  return Check::Result();
}
