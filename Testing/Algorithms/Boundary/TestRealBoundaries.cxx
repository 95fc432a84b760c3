// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/RealHorizons.h"
#include "Tools/TestHorizons.h"

using namespace TestHorizons;

namespace
{
constexpr int Skipped = 77;

BoundaryOptions With(int radius, GrowthStrategy growth, bool holes)
{
  BoundaryOptions options;
  options.Radius = radius;
  options.Growth = growth;
  options.KeepHoles = holes;
  return options;
}

/// Larger radii join patches, and clockwise growth takes no more points.
void TestRadii(const std::string& name, const Patches::Columns& columns)
{
  for (const GrowthStrategy growth : { GrowthStrategy::Distance, GrowthStrategy::Clockwise })
  {
    std::size_t patches = columns.size();
    std::size_t length = 0;
    for (int radius = 1; radius <= 5; ++radius)
    {
      const ExteriorBoundary boundary = FindExteriorBoundary(columns, With(radius, growth, false));
      std::cout << name << ": radius " << radius << ", growth " << int(growth) << ", patches "
                << boundary.NumberOfPatches << ", boundary points " << boundary.Boundary.TotalLength() << '\n';
      CHECK(boundary.NumberOfPatches <= patches);
      CHECK(radius == 1 || growth == GrowthStrategy::Distance || boundary.Boundary.TotalLength() <= length);
      patches = boundary.NumberOfPatches;
      length = boundary.Boundary.TotalLength();
    }
  }
}

void TestMesh(const Patches::Columns& columns, const BoundaryOptions& options)
{
  const BoundedHorizon horizon = MakeLevelHorizon(columns, options);
  CHECK_EQUAL(MeshChecker::CheckMesh(horizon, Triangulate(horizon).Triangles), std::string());
}
}

int TestRealBoundaries(int, char*[])
{
  const std::vector<std::filesystem::path> files = RealHorizons::Files();
  for (const std::filesystem::path& file : files)
  {
    const Patches::Columns columns = RealHorizons::Read(file);
    TestRadii(file.stem().string(), columns);
    TestMesh(columns, With(2, GrowthStrategy::Distance, true));
    TestMesh(columns, With(3, GrowthStrategy::Clockwise, true));
  }
  return files.empty() ? Skipped : Check::Result();
}
