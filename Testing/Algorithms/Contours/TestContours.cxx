// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contours of random surfaces with holes and cuts, against what a contour has to be: it crosses each edge that has a
// point below a level and one at or above it once, and no other, at the level; neighbours are on one triangle, the higher
// side to the left; ends are on edges of one triangle alone. Squares between columns, counted by hand.

#include "Filters/Algorithms/Contours/Contours.h"

#include "Tools/Check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Crossing = std::tuple<std::int64_t, PointId, PointId>; // level and edge

struct Surface
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Heights;
};

/// Some columns are missing, and heights may be whole, so that many are at a level.
Surface MakeSurface(std::mt19937& random, bool areWhole)
{
  Surface surface;
  std::uniform_real_distribution<double> height(-6.0, 9.0);
  for (int j = 0; j < 9; ++j)
  {
    for (int i = 0; i < 11; ++i)
    {
      if (random() % 7 != 0)
      {
        surface.Columns.push_back({ i + 40, j + 3 });
        const double z = height(random);
        surface.Heights.push_back(areWhole ? std::round(z) : z);
      }
    }
  }
  std::shuffle(surface.Columns.begin(), surface.Columns.end(), random);
  return surface;
}

LinkCuts MakeCuts(std::mt19937& random)
{
  PlaneBox box;
  box.Add(PlanePoint{ 30, 0 });
  box.Add(PlanePoint{ 60, 20 });
  LinkCuts cuts(box);
  for (int n = 0; n < 12; ++n)
  {
    const PlanePoint column = { int(40 + random() % 11), int(3 + random() % 9) };
    n % 2 == 0 ? cuts.CutEast(column) : cuts.CutNorth(column);
  }
  return cuts;
}

double Turn(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

using Edges = std::map<std::pair<PointId, PointId>, int>; // and how many triangles have them

Edges ListEdges(const PlanTriangles& triangles)
{
  Edges edges;
  for (const auto& triangle : triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      ++edges[std::minmax(triangle[n], triangle[(n + 1) % 3])];
    }
  }
  return edges;
}

std::set<Crossing> ListCrossings(const Edges& edges, const std::vector<double>& heights, double interval)
{
  std::set<Crossing> crossings;
  for (const auto& [edge, count] : edges)
  {
    for (int level = -40; level <= 40; ++level)
    {
      const double at = level * interval;
      if ((heights[std::size_t(edge.first)] >= at) != (heights[std::size_t(edge.second)] >= at))
      {
        crossings.insert({ level, edge.first, edge.second });
      }
    }
  }
  return crossings;
}

/// One triangle has both edges; its points at or above the level are not on the right, those below not on the left.
void CheckStep(const Surface& surface, const PlanTriangles& triangles, double at, const ContourPoint& before,
  const ContourPoint& point)
{
  const std::set<PointId> corners = { point.Crossed.From, point.Crossed.To, before.Crossed.From, before.Crossed.To };
  CHECK_EQUAL(corners.size(), 3u);
  CHECK(std::any_of(triangles.begin(), triangles.end(),
    [&corners](const auto& triangle) { return std::set<PointId>(triangle.begin(), triangle.end()) == corners; }));
  const auto placeOf = [&](const ContourPoint& one)
  {
    const PlanePoint a = surface.Columns[std::size_t(one.Crossed.From)];
    const PlanePoint b = surface.Columns[std::size_t(one.Crossed.To)];
    return std::array<double, 2>{ a.X + one.Fraction * (b.X - a.X), a.Y + one.Fraction * (b.Y - a.Y) };
  };
  for (const PointId corner : corners)
  {
    const PlanePoint column = surface.Columns[std::size_t(corner)];
    const double turn = Turn(placeOf(before), placeOf(point), { double(column.X), double(column.Y) });
    CHECK(surface.Heights[std::size_t(corner)] >= at ? turn >= -1e-12 : turn <= 1e-12);
  }
}

void CheckContours(const Surface& surface, const PlanTriangles& triangles, double interval)
{
  const Edges edges = ListEdges(triangles);
  std::set<Crossing> found;
  std::int64_t last = -1000;
  for (const Contour& contour : FindContours(triangles, surface.Heights, interval))
  {
    CHECK(contour.Level >= last);
    last = contour.Level;
    const double at = double(contour.Level) * interval;
    const auto keyOf = [&contour](const ContourPoint& point) {
      return Crossing{ contour.Level, point.Crossed.From, point.Crossed.To };
    };
    const ContourPoint &first = contour.Points.front(), &end = contour.Points.back();
    const bool isClosed = keyOf(first) == keyOf(end);
    CHECK(contour.Points.size() >= (isClosed ? 4u : 2u));
    for (const ContourPoint& one : { first, end })
    {
      CHECK(isClosed || edges.at({ one.Crossed.From, one.Crossed.To }) == 1);
    }
    for (std::size_t n = 0; n < contour.Points.size(); ++n)
    {
      const ContourPoint& point = contour.Points[n];
      CHECK((n == 0 && isClosed) || found.insert(keyOf(point)).second);
      const double low = surface.Heights[std::size_t(point.Crossed.From)];
      const double high = surface.Heights[std::size_t(point.Crossed.To)];
      CHECK(
        point.Fraction >= 0.0 && point.Fraction <= 1.0 && std::abs(low + point.Fraction * (high - low) - at) < 1e-12);
      if (n > 0)
      {
        CheckStep(surface, triangles, at, contour.Points[n - 1], point);
      }
    }
  }
  CHECK(found == ListCrossings(edges, surface.Heights, interval));
}

void TestRandomSurfaces()
{
  std::mt19937 random(5);
  for (int round = 0; round < 400; ++round)
  {
    const Surface surface = MakeSurface(random, round % 2 == 0);
    const LinkCuts cuts = MakeCuts(random);
    const PlanTriangles triangles = JoinColumns(surface.Columns, surface.Heights, round % 3 == 0 ? &cuts : nullptr);
    CHECK(triangles.size() > 10);
    CheckContours(surface, triangles, round % 5 == 0 ? 0.7 : round % 5 == 1 ? 2.0 : 1.0);
  }
}

double AreaOf(const PlanTriangles& triangles, const std::vector<PlanePoint>& columns)
{
  double area = 0.0;
  for (const auto& triangle : triangles)
  {
    std::array<std::array<double, 2>, 3> at;
    for (std::size_t n = 0; n < 3; ++n)
    {
      at[n] = { double(columns[std::size_t(triangle[n])].X), double(columns[std::size_t(triangle[n])].Y) };
    }
    const double own = Turn(at[0], at[1], at[2]) / 2.0;
    CHECK_EQUAL(own, 0.5); // counter-clockwise
    area += own;
  }
  return area;
}

/// Three by three columns, without one or two; a cut takes a square on each side of its link.
void TestSquares()
{
  const auto areaWithout = [](const std::set<std::pair<int, int>>& missing, const LinkCuts* cuts)
  {
    std::vector<PlanePoint> columns;
    for (int n = 0; n < 9; ++n)
    {
      if (missing.count({ n % 3, n / 3 }) == 0)
      {
        columns.push_back({ n % 3, n / 3 });
      }
    }
    return AreaOf(JoinColumns(columns, std::vector<double>(columns.size(), 2.0), cuts), columns);
  };
  CHECK_EQUAL(areaWithout({}, nullptr), 4.0);
  CHECK_EQUAL(areaWithout({ { 0, 0 } }, nullptr), 3.5);
  CHECK_EQUAL(areaWithout({ { 1, 1 } }, nullptr), 2.0);
  CHECK_EQUAL(areaWithout({ { 1, 1 }, { 0, 0 } }, nullptr), 1.5);
  CHECK_EQUAL(areaWithout({ { 2, 2 }, { 0, 2 } }, nullptr), 3.0);
  PlaneBox box;
  box.Add(PlanePoint{ 0, 0 });
  box.Add(PlanePoint{ 2, 2 });
  LinkCuts cuts(box);
  cuts.CutNorth({ 1, 0 });
  CHECK_EQUAL(areaWithout({}, &cuts), 2.0);
  CHECK_EQUAL(areaWithout({ { 0, 0 } }, &cuts), 2.0);
}

/// The contours of a cone are closed and run around its top; too many are refused.
void TestCone()
{
  Surface cone;
  for (int n = 0; n < 41 * 41; ++n)
  {
    cone.Columns.push_back({ n % 41, n / 41 });
    cone.Heights.push_back(20.5 - std::hypot(n % 41 - 20.0, n / 41 - 20.0));
  }
  const PlanTriangles triangles = JoinColumns(cone.Columns, cone.Heights, nullptr);
  const std::vector<Contour> contours = FindContours(triangles, cone.Heights, 5.0);
  CHECK_EQUAL(contours.size(), 12u); // one each for 5 to 20, and at 0 and -5 four around the corners
  for (const Contour& contour : contours)
  {
    const Edge &first = contour.Points.front().Crossed, &last = contour.Points.back().Crossed;
    CHECK_EQUAL(first.From == last.From && first.To == last.To, contour.Level >= 1);
  }
  CheckContours(cone, triangles, 5.0);
  CHECK_THROWS_WITH(FindContours(triangles, cone.Heights, 1e-3), "an interval of 0.001 for z from");
  CHECK(FindContours({}, {}, 1.0).empty());
}
}

int TestContours(int, char*[])
{
  TestRandomSurfaces();
  TestSquares();
  TestCone();
  return Check::Result();
}
