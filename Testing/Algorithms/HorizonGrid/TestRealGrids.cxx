// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that programs wrote, from the folder that the environment variable SEISMICHORIZONS_REAL_DATA names.

#include "GridSamples.h"
#include "Writers/HorizonGrid/GridWriters.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace GridSamples;
using namespace SeismicHorizons;

namespace
{
constexpr int Skipped = 77;

std::filesystem::path Folder()
{
  const char* const folder = std::getenv("SEISMICHORIZONS_REAL_DATA");
  return folder ? std::filesystem::path(folder) / "formats" : std::filesystem::path();
}

HorizonGrid ReadReal(const std::string& name)
{
  std::ifstream stream(Folder() / name, std::ios::binary);
  return ReadHorizonGrid(stream);
}

struct Figures
{
  int Count = 0;
  double Least = std::numeric_limits<double>::infinity();
  double Largest = -std::numeric_limits<double>::infinity();
};

Figures Measure(const HorizonGrid& grid)
{
  Figures figures;
  for (const double z : grid.Z)
  {
    if (!std::isnan(z))
    {
      ++figures.Count;
      figures.Least = std::min(figures.Least, z);
      figures.Largest = std::max(figures.Largest, z);
    }
  }
  return figures;
}

/// The binary form has single precision throughout.
void TextAndBinaryAreTheSameSurface()
{
  const HorizonGrid text = ReadReal("topreek_rota.fgr");
  const HorizonGrid binary = ReadReal("topreek_rota.gri");
  CHECK_EQUAL(text.Lattice.Columns[0], 554);
  CHECK_EQUAL(text.Lattice.Columns[1], 451);
  CHECK(text.Lattice.Columns == binary.Lattice.Columns);
  CHECK(text.Lattice.Origin == Eigen::Vector2d(468895.125, 5932889.5));
  CHECK((text.Lattice.Origin - binary.Lattice.Origin).norm() == 0.0);
  CHECK((text.Lattice.ColumnStep - binary.Lattice.ColumnStep).norm() < 1e-6);
  CHECK((text.Lattice.RowStep - binary.Lattice.RowStep).norm() < 1e-6);
  CHECK(std::equal(text.Z.begin(), text.Z.end(), binary.Z.begin(), binary.Z.end(),
    [](double a, double b) { return std::isnan(a) ? std::isnan(b) : std::fabs(a - b) < 2e-4; }));
  const Figures figures = Measure(text);
  CHECK_EQUAL(figures.Count, 178851);
  CHECK_EQUAL(figures.Least, 1547.1963);
  CHECK_EQUAL(figures.Largest, 1933.3654);
}

void ZmapOfRmsIsRead()
{
  const HorizonGrid grid = ReadReal("topreek_nonrota.zmap");
  CHECK_EQUAL(grid.Name, "topreek_nonrota.zmap");
  CHECK_EQUAL(grid.Lattice.Columns[0], 205);
  CHECK_EQUAL(grid.Lattice.Columns[1], 209);
  CHECK(HasLattice(grid, { 457599.125, 5927939 }, { 50, 0 }, { 0, 50 }));
  const Figures figures = Measure(grid);
  CHECK_EQUAL(figures.Count, 28507);
  CHECK_EQUAL(figures.Least, 1554.6122);
  CHECK_EQUAL(figures.Largest, 1932.127);
}

/// The same surface on two lattices: that tells orders and rotations that are wrong.
void RotatedAndUnrotatedLieOnEachOther()
{
  const HorizonGrid rotated = ReadReal("topreek_rota.fgr");
  const HorizonGrid unrotated = ReadReal("topreek_nonrota.zmap");
  Eigen::Matrix2d steps;
  steps << rotated.Lattice.ColumnStep, rotated.Lattice.RowStep;
  std::vector<double> differences;
  for (int j = 0; j < unrotated.Lattice.Columns[1]; ++j)
  {
    for (int i = 0; i < unrotated.Lattice.Columns[0]; ++i)
    {
      const Eigen::Vector2d place =
        unrotated.Lattice.Origin + i * unrotated.Lattice.ColumnStep + j * unrotated.Lattice.RowStep;
      const Eigen::Vector2d node = (steps.inverse() * (place - rotated.Lattice.Origin)).array().round();
      const bool isInside = node.minCoeff() >= 0.0 && node.x() < 554.0 && node.y() < 451.0;
      const double difference = isInside ? unrotated.Z[static_cast<std::size_t>(i + j * 205)] -
          rotated.Z[static_cast<std::size_t>(node.x() + node.y() * 554)]
                                         : None;
      if (!std::isnan(difference))
      {
        differences.push_back(std::fabs(difference));
      }
    }
  }
  CHECK(differences.size() > 28000);
  std::sort(differences.begin(), differences.end());
  CHECK(differences[differences.size() / 2] < 1.0); // metres; nodes are up to 14 m apart, any other order gives 30
}

void SmallZmapFilesAreRead()
{
  const HorizonGrid first = ReadReal("zmap_example.zmap");
  CHECK(HasLattice(first, { 459218.9063, 5924787 }, { 500, 0 }, { 0, 250 }));
  CHECK_EQUAL(Measure(first).Count, 17);
  CHECK_EQUAL(first.Z[0], 46.5453);
  CHECK_EQUAL(first.Z[2 + 1 * 4], 55.6271);
  const HorizonGrid second = ReadReal("zmap_example2.zmap");
  CHECK_EQUAL(Measure(second).Count, 11);
  CHECK_EQUAL(second.Z[1 + 3 * 3], 44.0108);
  CHECK(std::isnan(second.Z[0 + 3 * 3]));
}

void WrittenAgainTheyAreTheSame()
{
  for (const std::string name : { "topreek_rota.fgr", "topreek_rota.gri", "topreek_nonrota.zmap" })
  {
    const HorizonGrid grid = ReadReal(name);
    std::ostringstream stream;
    WriteIrapText(stream, grid);
    const HorizonGrid again = Read(stream.str());
    CHECK(HasLattice(again, grid.Lattice.Origin, grid.Lattice.ColumnStep, grid.Lattice.RowStep));
    CHECK(HasValues(again, grid.Z));
  }
  const HorizonGrid grid = ReadReal("topreek_nonrota.zmap");
  std::ostringstream stream;
  WriteZmap(stream, grid);
  CHECK(HasValues(Read(stream.str()), grid.Z));
}
}

int TestRealGrids(int, char*[])
{
  if (!std::filesystem::exists(Folder() / "topreek_rota.fgr"))
  {
    return Skipped;
  }
  TextAndBinaryAreTheSameSurface();
  ZmapOfRmsIsRead();
  RotatedAndUnrotatedLieOnEachOther();
  SmallZmapFilesAreRead();
  WrittenAgainTheyAreTheSame();
  return Check::Result();
}
