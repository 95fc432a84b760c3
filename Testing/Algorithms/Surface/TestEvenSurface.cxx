// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Even meshes: lengths of edges and angles, measured anew, on folds with holes, bays, noise and steep flanks.

#include "Filters/Algorithms/Surface/Surface.h"
#include "SurfaceInputs.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int Side = 150;

enum class Shape
{
  Square,
  Disc, // with a hole
  Bays
};

bool IsIn(Shape shape, int x, int y)
{
  const double radius = std::hypot(x - 0.5 * Side, y - 0.5 * Side);
  return shape == Shape::Square ? true
    : shape == Shape::Disc      ? radius < 0.48 * Side && radius > 0.1 * Side
                                : y < 0.6 * Side + 0.3 * Side * std::sin(0.12 * x);
}

SurfaceInputs::Points MakePoints(Shape shape, double steepness, double noise)
{
  Patches::Random random(17);
  SurfaceInputs::Points points;
  for (int n = 0; n < Side * Side; ++n)
  {
    const int x = n % Side;
    const int y = n / Side;
    if (IsIn(shape, x, y))
    {
      points.Columns.push_back({ x, y });
      points.Height.push_back(
        steepness * std::sin(0.05 * x) * std::cos(0.04 * y) + noise * (random.Fraction() - random.Fraction()));
    }
  }
  return points;
}

struct Measure
{
  std::size_t Triangles = 0;
  double LongestInside = 0.0;
  double SmallestInside = 180.0; // of triangles without a corner on a loop
  std::size_t BelowAngle = 0; // of the others
  double MeanQuality = 0.0; // 1 for equilateral triangles
};

Measure MeasureMesh(const Surface& surface)
{
  const std::vector<PlanePoint>& plane = surface.Mesh.Points.Plane;
  const std::vector<unsigned char> onLoops = surface.Mesh.Points.Boundary.MarkPoints(plane.size());
  Measure measure;
  const RawVector<PointId>& corners = surface.Mesh.Triangles;
  for (std::size_t n = 0; n < corners.size(); n += 3)
  {
    std::array<double, 3> lengths = {};
    int fixed = 0;
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const PointId from = corners[n + edge];
      const PointId to = corners[n + (edge + 1) % 3];
      lengths[edge] = std::hypot(double(plane[from].X) - plane[to].X, double(plane[from].Y) - plane[to].Y);
      fixed += onLoops[from];
      measure.LongestInside =
        onLoops[from] + onLoops[to] < 2 ? std::max(measure.LongestInside, lengths[edge]) : measure.LongestInside;
    }
    std::sort(lengths.begin(), lengths.end());
    const auto& [a, b, c] = lengths;
    const double angle = std::acos((b * b + c * c - a * a) / (2.0 * b * c)) * 45.0 / std::atan(1.0);
    if (fixed == 0)
    {
      measure.SmallestInside = std::min(measure.SmallestInside, angle);
    }
    measure.BelowAngle += fixed > 0 && angle < 25.0 - 1e-9 ? 1 : 0;
    const double half = 0.5 * (a + b + c);
    const double area = std::sqrt(half * (half - a) * (half - b) * (half - c));
    measure.MeanQuality += 4.0 * std::sqrt(3.0) * area / (a * a + b * b + c * c);
    ++measure.Triangles;
  }
  measure.MeanQuality /= double(measure.Triangles);
  return measure;
}

/// Smooth ones have triangles near equilateral; the error of steep and rough ones takes smaller triangles.
void TestShapes()
{
  for (const Shape shape : { Shape::Square, Shape::Disc, Shape::Bays })
  {
    for (const double length : { 6.0, 12.0, 25.0 })
    {
      for (const bool isRough : { false, true })
      {
        SurfaceOptions options;
        options.MaximumError = isRough ? 1.0 : 2.0;
        options.EdgeLength = length;
        const SurfaceInputs::Points points = MakePoints(shape, isRough ? 60.0 : 5.0, isRough ? 1.5 : 0.0);
        const Surface surface = MakeSurface(points, options);
        const Measure measure = MeasureMesh(surface);
        CHECK(measure.LongestInside <= length + 1e-9);
        CHECK(measure.SmallestInside >= 25.0 - 1e-9);
        CHECK(double(measure.BelowAngle) <= 0.02 * double(measure.Triangles));
        CHECK(measure.MeanQuality > (isRough || shape != Shape::Square ? 0.8 : 0.95));
        CHECK(surface.Mesh.LargestError <= options.MaximumError + 1e-9);
        CHECK(surface.Mesh.LargestEdgeError <= options.MaximumError + 1e-9);
      }
    }
  }
}

/// Edges are short at outlines, and grow with the distance from these.
void TestGrowth()
{
  SurfaceOptions options;
  options.MaximumError = 3.0;
  options.EdgeLength = 25.0;
  options.EdgeGrowth = 0.3;
  const SurfaceInputs::Points points = MakePoints(Shape::Square, 5.0, 0.0);
  const Surface surface = MakeSurface(points, options);
  const std::vector<PlanePoint>& plane = surface.Mesh.Points.Plane;
  double longest = 0.0;
  for (std::size_t n = 0; n < surface.Mesh.Triangles.size(); ++n)
  {
    const PlanePoint& from = plane[surface.Mesh.Triangles[n]];
    const PlanePoint& to = plane[surface.Mesh.Triangles[n % 3 == 2 ? n - 2 : n + 1]];
    const double length = std::hypot(double(from.X) - to.X, double(from.Y) - to.Y);
    const int distance = std::max(std::min({ from.X, from.Y, Side - 1 - from.X, Side - 1 - from.Y }),
      std::min({ to.X, to.Y, Side - 1 - to.X, Side - 1 - to.Y }));
    CHECK(length <= 3.0 + 0.3 * (distance + 1.0) + 1e-9);
    longest = std::max(longest, length);
  }
  CHECK(longest > 12.0 && MeasureMesh(surface).SmallestInside >= 25.0 - 1e-9);
}

void TestErrors()
{
  const auto refuse = [](double length, double growth, std::size_t triangles, const char* message)
  {
    SurfaceOptions options;
    options.EdgeLength = length;
    options.EdgeGrowth = growth;
    options.MaximumNumberOfTriangles = triangles;
    const SurfaceInputs::Points points = MakePoints(Shape::Square, 5.0, 0.0);
    CHECK_THROWS_WITH(MakeSurface(points, options), message);
  };
  refuse(3.0, 0.0, 0, "edge length 3, expected at least 4 columns, or 0 for any");
  refuse(8.0, 1.5, 0, "edge growth 1.5, expected 0 to 1");
  refuse(8.0, 0.0, 500,
    "an edge length and a number of points or triangles, expected an error as the target of even meshes");
}
}

int TestEvenSurface(int, char*[])
{
  TestShapes();
  TestGrowth();
  TestErrors();
  return Check::Result();
}
