// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The stages on interpreted horizons, which are not part of the project. Skipped where they are absent. Arguments: the
// folder of the project's data, and that of the real horizons with files `<survey>/*.vsm` and `<survey>/*.ijz` (lattice
// points as text: comments with #, a line `nX nY n`, then a line `i j z` for each point).

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"
#include "Tools/Check.h"
#include "Tools/TestHorizons.h"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

using namespace TestHorizons;

namespace
{
constexpr int Skipped = 77;

void CheckStages(const std::string& name, const Patches::Columns& columns, const std::vector<double>& heights)
{
  const BoundedHorizon full = MakeHorizon(columns, heights);
  std::cout << name << ": " << columns.size() << " points, " << full.Boundary.Size() << " patches\n";
  CHECK_EQUAL(MeshChecker::CheckMesh(full, Triangulate(full).Triangles), std::string());
  const BoundedHorizon straight = Drop(full, SimplifyBoundary(full, full.Boundary, 0.4));
  const BoundedHorizon rough = Reduce(straight, SimplifyRough(straight, 3));
  CHECK_EQUAL(MeshChecker::CheckMesh(rough, Triangulate(rough).Triangles), std::string());
  CHECK_EQUAL(std::accumulate(rough.Count.begin(), rough.Count.end(), std::int64_t(0)), std::int64_t(columns.size()));
  CHECK(rough.Plane.size() < columns.size() / 2);
}

void CheckLatticePoints(const std::filesystem::path& path)
{
  std::ifstream file(path);
  Patches::Columns columns;
  std::vector<double> heights;
  std::string line;
  for (bool header = true; std::getline(file, line);)
  {
    if (line.empty() || line.front() == '#')
    {
      continue;
    }
    PlanePoint column;
    double height = 0.0;
    if (!header && std::istringstream(line) >> column.X >> column.Y >> height)
    {
      columns.push_back(column);
      heights.push_back(height);
    }
    header = false;
  }
  CheckStages(path.filename().string(), columns, heights);
}

void CheckSparseMatrix(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  for (const LatticeHorizon& voxels : ReadSparseMatrix(stream).Horizons)
  {
    Patches::Columns columns;
    for (std::size_t voxel = 0; voxel < voxels.Column.size(); ++voxel)
    {
      columns.push_back({ voxels.Column[voxel].X, voxels.Column[voxel].Y });
    }
    CheckStages(path.filename().string() + " horizon " + std::to_string(voxels.SurfaceId), columns,
      std::vector<double>(voxels.K.begin(), voxels.K.end()));
  }
}
}

int TestRealHorizons(int argc, char* argv[])
{
  const std::filesystem::path folder = argc > 2 ? argv[2] : "";
  if (!std::filesystem::is_directory(folder))
  {
    std::cout << "no real horizons in " << folder << ", skipped\n";
    return Skipped;
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    if (entry.path().extension() == ".vsm")
    {
      CheckSparseMatrix(entry.path());
    }
    else if (entry.path().extension() == ".ijz")
    {
      CheckLatticePoints(entry.path());
    }
  }
  return Check::Result();
}
