// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/MeshSampling.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>

using namespace SeismicHorizons;

namespace
{
using Triangles = std::vector<std::array<PointId, 3>>;

double Plane(double x, double y)
{
  return 100.0 + 2.0 * x - 3.0 * y;
}

SpacePoint OnPlane(double x, double y)
{
  return { x, y, Plane(x, y) };
}

/// The heights of all columns of a lattice, that of column (i, j) at i + j * columns[0]; nan where there is none.
std::vector<double> Sample(
  const std::vector<SpacePoint>& points, const Triangles& triangles, const std::array<int, 2>& columns)
{
  MeshSampling sampling(columns);
  sampling.AddTriangles(points, triangles);
  std::vector<double> heights(columns[0] * columns[1], std::numeric_limits<double>::quiet_NaN());
  sampling.Tiles.ForEachPlace(
    [&](int i, int j, std::size_t place)
    {
      if (i < columns[0] && j < columns[1])
      {
        heights[i + j * columns[0]] = sampling.Heights[place];
      }
    });
  return heights;
}

/// The columns within a square and on its sides, both diagonals of which are tried, have the height of the plane.
void TestSquare()
{
  const std::vector<SpacePoint> points = { OnPlane(1, 1), OnPlane(4, 1), OnPlane(4, 3), OnPlane(1, 3) };
  for (const Triangles& triangles : { Triangles{ { 0, 1, 2 }, { 0, 2, 3 } }, Triangles{ { 0, 3, 1 }, { 3, 2, 1 } } })
  {
    const std::vector<double> heights = Sample(points, triangles, { 6, 5 });
    CHECK_EQUAL(heights.size(), std::size_t(30));
    for (int j = 0; j < 5; ++j)
    {
      for (int i = 0; i < 6; ++i)
      {
        const double height = heights[std::size_t(i + 6 * j)];
        const bool isInside = i >= 1 && i <= 4 && j >= 1 && j <= 3;
        CHECK(isInside ? std::abs(height - Plane(i, j)) < 1e-12 : std::isnan(height));
      }
    }
  }
}

/// Corners may be anywhere, also outside the lattice and off by rounding; what has no area covers nothing.
void TestCorners()
{
  const std::vector<SpacePoint> points = { OnPlane(-7.5, -3), OnPlane(20, -3), OnPlane(2.5, 9), OnPlane(1 - 1e-9, 1),
    OnPlane(3 + 1e-9, 1), OnPlane(2, 1 - 1e-9) };
  const std::vector<double> all = Sample(points, { { 0, 1, 2 } }, { 4, 3 });
  CHECK_EQUAL(std::count_if(all.begin(), all.end(), [](double z) { return std::isnan(z); }), 0);
  CHECK(std::abs(all[6] - Plane(2, 1)) < 1e-12);
  const std::vector<double> needle = Sample(points, { { 3, 5, 4 } }, { 4, 3 });
  CHECK(std::abs(needle[5] - Plane(1, 1)) < 1e-6 && std::abs(needle[7] - Plane(3, 1)) < 1e-6);
  const std::vector<double> nothing = Sample(points, { { 3, 3, 4 } }, { 4, 3 });
  CHECK(std::isnan(nothing[5]));
}

/// A fan of triangles with any corners leaves no column inside out, and gives none outside.
void TestFans()
{
  Patches::Random random(1);
  for (int trial = 0; trial < 300; ++trial)
  {
    std::vector<SpacePoint> points = { OnPlane(10, 10) };
    Triangles triangles;
    const int corners = 3 + random.Below(9);
    for (int n = 0; n < corners; ++n)
    {
      const double angle = 6.283185307179586 * (n + 0.3 * random.Fraction()) / corners;
      const double radius = 3.0 + 6.0 * random.Fraction();
      points.push_back(OnPlane(10 + radius * std::cos(angle), 10 + radius * std::sin(angle)));
      triangles.push_back({ 0, n + 1, (n + 1) % corners + 1 });
    }
    const std::vector<double> heights = Sample(points, triangles, { 21, 21 });
    for (int j = 0; j < 21; ++j)
    {
      for (int i = 0; i < 21; ++i)
      {
        const double height = heights[std::size_t(i + 21 * j)];
        const double distance = std::hypot(i - 10.0, j - 10.0);
        CHECK(std::isnan(height) || std::abs(height - Plane(i, j)) < 1e-9);
        CHECK(distance > 0.9 || !std::isnan(height));
        CHECK(distance < 9.1 || std::isnan(height));
      }
    }
  }
}

/// A closed body has two heights, whether its corners are columns or not. Parts at one height are one, and so are those
/// side by side at a fault.
void TestSeveralHeights()
{
  const std::vector<SpacePoint> sides = { { 0, 0, 10 }, { 0, 2, 10 }, { 2, 0, 10 }, { 2, 2, 10 }, { 2, 0, 30 },
    { 2, 2, 30 }, { 4, 0, 30 }, { 4, 2, 30 } };
  const std::vector<double> atFault = Sample(sides, { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 6, 7 }, { 4, 7, 5 } }, { 5, 3 });
  CHECK(std::equal(atFault.begin(), atFault.begin() + 5, std::vector<double>{ 10, 10, 10, 30, 30 }.begin()));
  for (const double shift : { 0.0, 0.3 })
  {
    std::vector<SpacePoint> points;
    for (const double z : { 10.0, 30.0, 10.0 })
    {
      for (const int corner : { 0, 1, 2, 3 })
      {
        points.push_back({ shift + (corner == 1 || corner == 2 ? 6.0 : 0.0), shift + (corner > 1 ? 2.0 : 0.0), z });
      }
    }
    const Triangles one = { { 0, 1, 2 }, { 0, 2, 3 } };
    for (const PointId other : { 4, 8 })
    {
      Triangles both = one;
      both.insert(both.end(),
        { { other, other + 3, other + 1 }, { other + 3, other + 2, other + 1 }, { 0, 1, other },
          { 1, other + 1, other } });
      if (other == 8)
      {
        const std::vector<double> twice = Sample(points, both, { 9, 4 });
        const std::vector<double> once = Sample(points, one, { 9, 4 });
        CHECK(std::equal(twice.begin(), twice.end(), once.begin(),
          [](double a, double b) { return std::abs(a - b) < 1e-12 || (std::isnan(a) && std::isnan(b)); }));
        continue;
      }
      CHECK_THROWS_WITH(Sample(points, both, { 9, 4 }),
        "heights 10 and 30 (vertical indices) of a mesh in column (1, 1), expected one in each column");
    }
  }
}
}

int TestMeshSampling(int, char*[])
{
  TestSquare();
  TestCorners();
  TestFans();
  TestSeveralHeights();
  return Check::Result();
}
