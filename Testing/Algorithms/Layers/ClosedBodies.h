// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether triangles are the surface of a body, and how large solids are, from points in space alone.

#ifndef SeismicHorizonsClosedBodies_h
#define SeismicHorizonsClosedBodies_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ClosedBodies
{
using Point = std::array<double, 3>;
using Corners = std::array<int, 3>;

inline Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Positive where d sees a, b, c counter-clockwise from behind: the normal of a, b, c points to d.
inline double TetrahedronVolume(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return Dot(Cross(Minus(b, a), Minus(c, a)), Minus(d, a)) / 6.0;
}

/// What lies inside a closed surface whose normals point outwards.
inline double EnclosedVolume(const std::vector<Point>& points, const std::vector<Corners>& triangles)
{
  double volume = 0.0;
  for (const Corners& t : triangles)
  {
    // From a point of the body, as far ones cost digits.
    volume -= TetrahedronVolume(
      points[std::size_t(t[0])], points[std::size_t(t[1])], points[std::size_t(t[2])], points.front());
  }
  return volume;
}

/// Whether the triangles around each point follow each other in one ring. `rings` has for each triangle at a point its
/// other two corners.
inline std::string CheckRing(int point, const std::vector<std::pair<int, int>>& ring)
{
  std::map<int, int> next(ring.begin(), ring.end());
  if (next.size() != ring.size())
  {
    return "point " + std::to_string(point) + ": two triangles go on to the same point";
  }
  int at = ring.front().first;
  std::size_t steps = 0;
  do
  {
    const auto found = next.find(at);
    if (found == next.end())
    {
      return "point " + std::to_string(point) + ": ring is open";
    }
    at = found->second;
    ++steps;
  } while (at != ring.front().first && steps <= ring.size());
  return steps == ring.size() ? "" : "point " + std::to_string(point) + ": several rings";
}

/// Empty where the surface is closed, oriented and a manifold; else what is wrong first.
inline std::string CheckClosed(const std::vector<Point>& points, const std::vector<Corners>& triangles)
{
  std::set<std::pair<int, int>> edges;
  std::map<int, std::vector<std::pair<int, int>>> rings;
  for (const Corners& t : triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      const int a = t[n];
      const int b = t[(n + 1) % 3];
      if (a < 0 || std::size_t(a) >= points.size() || a == b)
      {
        return "a triangle has wrong corners";
      }
      if (!edges.insert({ a, b }).second)
      {
        return "edge " + std::to_string(a) + " " + std::to_string(b) + " twice";
      }
      rings[a].push_back({ b, t[(n + 2) % 3] });
    }
    const Point normal = Cross(Minus(points[std::size_t(t[1])], points[std::size_t(t[0])]),
      Minus(points[std::size_t(t[2])], points[std::size_t(t[0])]));
    if (!(Dot(normal, normal) > 0.0))
    {
      return "a triangle has no area";
    }
  }
  for (const auto& [a, b] : edges)
  {
    if (edges.count({ b, a }) == 0)
    {
      return "edge " + std::to_string(a) + " " + std::to_string(b) + " open";
    }
  }
  if (rings.size() != points.size())
  {
    return "points without triangles";
  }
  for (const auto& [point, ring] : rings)
  {
    const std::string wrong = CheckRing(point, ring);
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return "";
}

/// A solid as tetrahedra, all of which must be positive for it to be turned as VTK wants it: a wedge, a pyramid or a
/// tetrahedron by its number of points. (A side that four points of one plane span may be cut either way.)
inline std::vector<std::array<Point, 4>> CutIntoTetrahedra(const std::vector<Point>& p)
{
  switch (p.size())
  {
    case 6: // 0 1 2 points outwards: away from 3 4 5
      return { { p[0], p[2], p[1], p[3] }, { p[1], p[3], p[5], p[4] }, { p[1], p[2], p[5], p[3] } };
    case 5: // 0 1 2 3 points to 4
      return { { p[0], p[1], p[2], p[4] }, { p[0], p[2], p[3], p[4] } };
    default:
      return { { p[0], p[1], p[2], p[3] } };
  }
}

/// The part of a tetrahedron where z > contact, by cutting it.
inline double VolumeAbove(std::array<Point, 4> p, double contact)
{
  std::sort(p.begin(), p.end(), [](const Point& a, const Point& b) { return a[2] > b[2]; });
  const double all = std::abs(TetrahedronVolume(p[0], p[1], p[2], p[3]));
  const auto at = [&](std::size_t a, std::size_t b)
  {
    const double part = (p[a][2] - contact) / (p[a][2] - p[b][2]);
    return Point{ p[a][0] + part * (p[b][0] - p[a][0]), p[a][1] + part * (p[b][1] - p[a][1]), contact };
  };
  const auto above = std::count_if(p.begin(), p.end(), [&](const Point& one) { return one[2] > contact; });
  if (above == 0 || above == 4)
  {
    return above == 0 ? 0.0 : all;
  }
  if (above == 1)
  {
    return std::abs(TetrahedronVolume(p[0], at(0, 1), at(0, 2), at(0, 3)));
  }
  if (above == 3)
  {
    return all - std::abs(TetrahedronVolume(p[3], at(0, 3), at(1, 3), at(2, 3)));
  }
  const std::array<Point, 3> one = { p[0], at(0, 2), at(0, 3) };
  const std::array<Point, 3> two = { p[1], at(1, 2), at(1, 3) };
  return std::abs(TetrahedronVolume(one[0], one[1], one[2], two[0])) +
    std::abs(TetrahedronVolume(one[1], one[2], two[0], two[1])) +
    std::abs(TetrahedronVolume(one[2], two[0], two[1], two[2]));
}
}

#endif
