// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops of meshes that move to other points: the mesh is the one that the new loops and its inner vertices give.

#include "DecimationChecker.h"
#include "Filters/Algorithms/Decimation/MeshRefiner.h"
#include "Tools/Check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

using namespace SeismicHorizons;

namespace
{
using Corners = std::array<PointId, 3>;

/// Each from its least point.
std::set<Corners> TrianglesOf(const HeightMesh& mesh, const std::vector<TriangleId>& triangles)
{
  std::set<Corners> all;
  for (const TriangleId triangle : triangles)
  {
    const auto& [a, b, c] = mesh.Triangles().Corners(triangle);
    Corners corners = { mesh.SourceOf(a), mesh.SourceOf(b), mesh.SourceOf(c) };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    CHECK(all.insert(corners).second);
  }
  return all;
}

/// Keeps some points of the boundary, whatever the tolerances.
BoundarySimplification SimplifyAtRandom(const BoundedHorizon& horizon, Patches::Random& random)
{
  BoundarySimplificationOptions options;
  options.Method = OutlineMethod::FewestPoints;
  options.OutlineTolerance = 2.0 * random.Fraction();
  options.DistanceThreshold = 2.0 * random.Fraction();
  const double kept = 0.2 * random.Fraction();
  horizon.Boundary.ForEachPoint(
    [&](PointId point)
    {
      if (random.Chance(kept))
      {
        options.Fixed.push_back(point);
      }
    });
  return SimplifyBoundary(horizon, horizon.Boundary, options);
}

class MovedMesh
{
public:
  MovedMesh(const BoundedHorizon& horizon, Patches::Random& random)
    : Given(horizon)
    , Mesh(TestHorizons::Leave(horizon, SimplifyAtRandom(horizon, random)), Monitor())
  {
    MeshRefiner(this->Mesh, 0, DecimationPriority::LargestError).InsertWhereFar(random.Fraction(), Monitor());
    std::vector<InnerHeights> heights = this->Mesh.HeightsOf(this->Mesh.InnerVertices());
    for (double& height : heights.front().Heights)
    {
      height += random.Fraction();
    }
    this->Mesh.SetAllHeights(heights);
  }

  /// Returns the number of triangles that stay.
  std::size_t Move(const BoundarySimplification& simplified)
  {
    const std::set<Corners> before = TrianglesOf(this->Mesh, this->Mesh.AllTriangles());
    const std::vector<double> heights = this->HeightsByPoint();
    const auto changed = this->Mesh.ChangeLoops(simplified.Boundary, simplified.Dropped);
    if (!CHECK(changed.has_value()))
    {
      return 0;
    }
    const std::set<Corners> now = TrianglesOf(this->Mesh, this->Mesh.AllTriangles());
    std::vector<TriangleId> listed = *changed;
    std::sort(listed.begin(), listed.end());
    listed.erase(std::unique(listed.begin(), listed.end()), listed.end());
    const std::set<Corners> told = TrianglesOf(this->Mesh, listed);
    std::vector<Corners> stay;
    std::set_intersection(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(stay));
    for (const Corners& corners : now)
    {
      CHECK(before.count(corners) + told.count(corners) > 0);
    }
    this->CheckAgainst(HeightMesh(TestHorizons::Leave(this->Given, simplified), Monitor()), now);
    for (const auto& [point, vertex] : this->Vertices())
    {
      CHECK_EQUAL(this->Mesh.Height(vertex),
        this->Mesh.IsOnLoop(vertex) ? this->Given.Height[std::size_t(point)] : heights[std::size_t(point)]);
    }
    return stay.size();
  }

private:
  std::vector<double> HeightsByPoint() const
  {
    std::vector<double> heights(this->Given.Height.size(), NoValue);
    for (const auto& [point, vertex] : this->Vertices())
    {
      heights[std::size_t(point)] = this->Mesh.Height(vertex);
    }
    return heights;
  }

  std::map<PointId, VertexId> Vertices() const
  {
    std::map<PointId, VertexId> vertices;
    for (VertexId vertex = 0; vertex < this->Mesh.EndOfVertices(); ++vertex)
    {
      if (!this->Mesh.IsRemoved(vertex))
      {
        CHECK(vertices.emplace(this->Mesh.SourceOf(vertex), vertex).second);
      }
    }
    return vertices;
  }

  /// The point, and the height of the dropped point, there; patches are numbered in any order.
  static std::pair<PointId, double> ColumnOf(const HeightMesh& mesh, PointId point)
  {
    std::pair<PointId, double> found = { NoPoint, -1e9 };
    for (std::size_t patch = 0; patch < mesh.NumberOfPatches(); ++patch)
    {
      const HeightRaster& raster = mesh.RasterOfPatch(patch);
      found.first = std::max(found.first, raster.PointAt(mesh.Column(point)));
      const double dropped = raster.DroppedHeight(mesh.Column(point));
      found.second = std::isnan(dropped) ? found.second : std::max(found.second, dropped);
    }
    return found;
  }

  /// A constrained Delaunay mesh is the only one of its vertices.
  void CheckAgainst(HeightMesh fresh, const std::set<Corners>& now) const
  {
    std::vector<unsigned char> marks(this->Given.Height.size(), 0);
    for (const VertexId vertex : this->Mesh.InnerVertices())
    {
      marks[std::size_t(this->Mesh.SourceOf(vertex))] = 1;
    }
    MeshRefiner(fresh, 0, DecimationPriority::LargestError).InsertMarked(marks);
    CHECK(TrianglesOf(fresh, fresh.AllTriangles()) == now);
    CHECK_EQUAL(this->Mesh.NumberOfVertices(), fresh.NumberOfVertices());
    CHECK_EQUAL(this->Mesh.NumberOfInnerVertices(), fresh.NumberOfInnerVertices());
    CHECK_EQUAL(this->Mesh.NumberOfPoints(), fresh.NumberOfPoints());
    for (PointId point = 0; point < PointId(marks.size()); ++point)
    {
      CHECK_EQUAL(this->Mesh.IsVertex(point), fresh.IsVertex(point));
      CHECK_EQUAL(this->Mesh.HasPoint(point), fresh.HasPoint(point));
      CHECK(ColumnOf(this->Mesh, point) == ColumnOf(fresh, point));
    }
  }

  const BoundedHorizon& Given;
  HeightMesh Mesh;
};

/// Loops move several times, most triangles stay where few points of the boundary are kept more.
void TestRandomLoops()
{
  Patches::Random random(31);
  std::size_t stay = 0;
  for (int n = 0; n < 300; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    std::vector<double> heights;
    const double roughness = 3.0 * random.Fraction();
    for (const PlanePoint& column : columns)
    {
      heights.push_back(8.0 * std::sin(0.2 * column.X) * std::cos(0.17 * column.Y) + roughness * random.Fraction());
    }
    const BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, heights));
    MovedMesh mesh(horizon, random);
    for (int move = 0; move < 3; ++move)
    {
      stay += mesh.Move(SimplifyAtRandom(horizon, random));
    }
  }
  CHECK(stay > 1000);
}
}

int TestLoopChange(int, char*[])
{
  TestRandomLoops();
  return Check::Result();
}
