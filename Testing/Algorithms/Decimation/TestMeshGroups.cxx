// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes of several groups: the bound, few vertices, and what stays.

#include "DecimationChecker.h"
#include "Filters/Algorithms/Decimation/MeshGroups.h"
#include "Filters/Algorithms/Decimation/MeshImprover.h"
#include "Tools/Check.h"

#include <cmath>
#include <memory>

using namespace SeismicHorizons;
using namespace DecimationChecker;

namespace
{
Patches::Columns Square(int side)
{
  return Patches::FromPicture(std::vector<std::string>(std::size_t(side), std::string(std::size_t(side), '#')));
}

/// Folds with noise on a slope.
BoundedHorizon MakeHorizon(int side, double noise, double slope = 0.0)
{
  Patches::Random random(41);
  const Patches::Columns columns = Square(side);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    const double x = columns[point].X;
    const double y = columns[point].Y;
    horizon.Height[point] =
      9.0 * std::sin(0.06 * x + 0.02 * y) + 0.0004 * x * x * std::cos(0.09 * y) + noise * random.Fraction() + slope * x;
  }
  return horizon;
}

/// The bound holds at columns and inner edges, in floats and where only doubles are exact enough.
void TestBound()
{
  constexpr double error = 0.5;
  for (const double slope : { 0.0, 1e5 })
  {
    for (const bool fitHeights : { true, false })
    {
      const BoundedHorizon horizon = MakeHorizon(90, 1.2, slope);
      const Decimation result = Decimate(horizon, Best(Within(error, fitHeights)));
      CHECK_EQUAL(Checker(horizon, result).Check(error, MeshChecker::Kind::Any), std::string());
      CHECK(result.LargestError > 0.95 * error && result.LargestEdgeError <= error + 1e-9);
    }
  }
}

/// Smooth heights have a few groups, noise has many, and both need far fewer vertices than the fast effort.
void TestFewVertices()
{
  const auto share = [](const BoundedHorizon& horizon, double error)
  {
    const double fast = double(Decimate(horizon, Within(error, true)).Points.Source.size());
    return double(Decimate(horizon, Best(Within(error, true))).Points.Source.size()) / fast;
  };
  CHECK(share(MakeHorizon(250, 0.0), 0.02) < 0.55);
  CHECK(share(MakeHorizon(250, 1.0), 0.5) < 0.35);
}

/// Whole heights need about as many vertices for a range of errors and far fewer for a little more, so that searches
/// have few hints. No error that is much smaller leaves as few vertices. Near the 396 of the loops, angles
/// decide.
void TestLargestErrorOfWholeHeights()
{
  for (const double noise : { 0.0, 0.6 })
  {
    BoundedHorizon horizon = MakeHorizon(100, noise);
    std::for_each(horizon.Height.begin(), horizon.Height.end(), [](double& height) { height = std::round(height); });
    for (const std::size_t most : { 450, 500, 600, 800, 1100, 1500, 2500 })
    {
      DecimationOptions options = Best(AtMost(most, true));
      options.Priority = DecimationPriority::LargestError;
      const Decimation result = Decimate(horizon, options);
      CHECK(result.Points.Source.size() <= most);
      CHECK_EQUAL(Checker(horizon, result).Check(1e9, MeshChecker::Kind::Any), std::string());
      const double smaller = 0.9 * std::max(result.LargestError, result.LargestEdgeError);
      CHECK(Decimate(horizon, Best(Within(smaller, true))).Points.Source.size() > most);
    }
  }
}

/// Heights that are far from 0 have the mesh of the same heights around 0.
void TestOffset()
{
  const BoundedHorizon horizon = MakeHorizon(120, 1.0);
  BoundedHorizon far = horizon;
  for (double& height : far.Height)
  {
    height += double(1 << 20);
  }
  const auto near = double(Decimate(horizon, Best(Within(0.5, true))).Points.Source.size());
  const auto moved = double(Decimate(far, Best(Within(0.5, true))).Points.Source.size());
  CHECK(std::abs(near - moved) < 0.03 * near);
}

/// Two patches so far apart that no box around both could be held in memory.
void TestFarPatches()
{
  BoundedHorizon horizon = MakeHorizon(40, 1.0);
  const std::size_t points = horizon.Height.size();
  const Loops first = horizon.Boundary;
  for (std::size_t point = 0; point < points; ++point)
  {
    horizon.Plane.push_back({ horizon.Plane[point].X + (1 << 24), horizon.Plane[point].Y + (1 << 24) });
    horizon.Height.push_back(horizon.Height[point]);
    horizon.Patch.push_back(horizon.Patch[point] + 1);
    horizon.Count.push_back(1);
  }
  for (std::size_t loop = 0; loop < first.Size(); ++loop)
  {
    for (const PointId* point = first.begin(loop); point != first.end(loop); ++point)
    {
      horizon.Boundary.Append(*point + PointId(points));
    }
    horizon.Boundary.Close();
  }
  const Decimation result = Decimate(horizon, Best(Within(0.5, true)));
  const auto half = std::ptrdiff_t(result.Points.Height.size() / 2);
  CHECK(
    std::equal(result.Points.Height.begin(), result.Points.Height.begin() + half, result.Points.Height.begin() + half));
}

/// Kept edges, fixed vertices and loops stay; the rule has the last word on heights.
void TestWhatStays()
{
  const BoundedHorizon horizon = MakeHorizon(80, 1.0);
  HeightMesh mesh(horizon, Monitor());
  const DecimationOptions options = Best(Within(0.6, true));
  InsertToError(mesh, options, Monitor());
  const std::vector<VertexId> inner = mesh.InnerVertices();
  const std::size_t onLoops = mesh.NumberOfVertices() - inner.size();
  const PointId fixed = mesh.SourceOf(inner[inner.size() / 2]);
  mesh.Fix(inner[inner.size() / 2]);
  std::vector<std::array<PointId, 2>> kept;
  for (TriangleId triangle = 0; triangle < mesh.Triangles().Size(); triangle += 50)
  {
    const VertexId from = mesh.Triangles().Corner(triangle, 0);
    const VertexId to = mesh.Triangles().Corner(triangle, 1);
    mesh.Triangles().Keep(from, to);
    kept.push_back({ mesh.SourceOf(from), mesh.SourceOf(to) });
  }
  int calls = 0;
  const ColumnRule rule = [&](const PlanePoint& column, std::vector<double>& heights)
  {
    ++calls;
    heights.front() = column.X % 2 == 0 ? 0.25 * std::round(4.0 * heights.front()) : heights.front();
  };
  const std::vector<double> before = mesh.HeightsOf(inner).front().Heights;
  const int threads = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1; // for the count
  ImproveInGroups(mesh, options, rule, Monitor());
  Detail::NumberOfThreads() = threads;
  CHECK(calls > 1000);
  CHECK_EQUAL(mesh.NumberOfVertices() - mesh.NumberOfInnerVertices(), onLoops);
  CHECK(mesh.NumberOfInnerVertices() < inner.size() / 2);
  CHECK(mesh.IsVertex(fixed));
  const std::vector<VertexId> vertices = mesh.VerticesByPoint();
  for (const auto& [from, to] : kept)
  {
    CHECK(mesh.IsVertex(from) && mesh.IsVertex(to));
    CHECK(mesh.Triangles().IsKept(vertices[std::size_t(from)], vertices[std::size_t(to)]));
  }
  int ruled = 0;
  for (const VertexId vertex : mesh.InnerVertices())
  {
    const double height = mesh.Height(vertex);
    const bool isOld = std::find(before.begin(), before.end(), height) != before.end();
    CHECK(isOld || mesh.Raised(vertex).Column.X % 2 != 0 || 4.0 * height == std::round(4.0 * height));
    ruled += isOld ? 0 : 1;
  }
  CHECK(ruled > 50);
}
}

int TestMeshGroups(int, char*[])
{
  TestBound();
  TestFewVertices();
  TestLargestErrorOfWholeHeights();
  TestOffset();
  TestFarPatches();
  TestWhatStays();
  return Check::Result();
}
