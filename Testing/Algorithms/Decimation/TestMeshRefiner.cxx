// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The insertion of points into meshes whose heights were changed.

#include "DecimationChecker.h"
#include "Filters/Algorithms/Decimation/MeshRefiner.h"
#include "Tools/Check.h"

#include <cmath>

using namespace SeismicHorizons;

namespace
{
/// A vertex that is farther from its own column than the bound cannot be inserted there: it goes back to its height,
/// and the insertion ends within the bound.
void TestFarVertices()
{
  const Patches::Columns columns = Patches::FromPicture(std::vector<std::string>(40, std::string(40, '#')));
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    horizon.Height[point] = 8.0 * std::sin(0.2 * columns[point].X) * std::cos(0.17 * columns[point].Y);
  }
  constexpr double bound = 0.5;
  HeightMesh mesh(horizon, Monitor());
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  refiner.InsertWhereFar(bound, Monitor());
  std::vector<InnerHeights> all = mesh.HeightsOf(mesh.InnerVertices());
  InnerHeights& heights = all.front();
  CHECK(heights.Vertices.size() > 20);
  for (std::size_t n = 0; n < heights.Vertices.size(); n += 3)
  {
    heights.Heights[n] += n % 2 == 0 ? 3.0 * bound : -20.0 * bound;
  }
  mesh.SetAllHeights(all);
  refiner.InsertWhereFar(bound, Monitor());
  refiner.InsertAtEdges(bound, bound, Monitor());
  for (TriangleId triangle = 0; triangle < mesh.Triangles().Size(); ++triangle)
  {
    CHECK(mesh.RasterOf(triangle).Measure(mesh.RaisedCorners(triangle)).Largest <= bound + 1e-9);
  }
}
}

int TestMeshRefiner(int, char*[])
{
  TestFarVertices();
  return Check::Result();
}
