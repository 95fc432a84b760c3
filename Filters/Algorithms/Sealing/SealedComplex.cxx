// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedComplex.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/PlaceText.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// An edge of a triangle, from its corner of this number.
struct ComplexEdge
{
  EdgeKey Key;
  std::int32_t Triangle;
  int Corner;
};

template <typename Triangles>
std::vector<ComplexEdge> SortEdges(const Triangles& triangles)
{
  std::vector<ComplexEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      edges.push_back(
        { KeyOf(triangles[n].Corners[corner], triangles[n].Corners[(corner + 1) % 3]), std::int32_t(n), int(corner) });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const ComplexEdge& a, const ComplexEdge& b)
    { return std::tie(a.Key, a.Triangle) < std::tie(b.Key, b.Triangle); });
  return edges;
}

template <typename Visitor>
void ForEachEdge(const std::vector<ComplexEdge>& edges, Visitor&& visit)
{
  for (std::size_t first = 0; first < edges.size();)
  {
    std::size_t last = first;
    while (last < edges.size() && edges[last].Key == edges[first].Key)
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

Eigen::Vector3d CrossOf(const std::vector<Eigen::Vector3d>& vertices, const SheetCorners& corners)
{
  const Eigen::Vector3d& a = vertices[std::size_t(corners[0])];
  return (vertices[std::size_t(corners[1])] - a).cross(vertices[std::size_t(corners[2])] - a);
}

/// Groups triangles of one sheet that no line parts. Sheets that are not cut by each other may have an edge in common
/// nevertheless.
DisjointSets PartsBetweenLines(const Arrangement& arrangement)
{
  const std::vector<ArrangedTriangle>& triangles = arrangement.Triangles;
  DisjointSets parts(triangles.size());
  const std::vector<ComplexEdge> edges = SortEdges(triangles);
  ForEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t n = first; n < last && arrangement.Lines.count(edges[first].Key) == 0; ++n)
      {
        for (std::size_t other = n + 1; other < last; ++other)
        {
          if (triangles[std::size_t(edges[n].Triangle)].Sheet == triangles[std::size_t(edges[other].Triangle)].Sheet)
          {
            parts.Join(edges[n].Triangle, edges[other].Triangle);
          }
        }
      }
    });
  return parts;
}

/// A side of a triangle at an edge, seen along it.
struct EdgeSide
{
  double Angle;
  std::int32_t Triangle;
  int Rising; // the side that faces rising angles
};

/// Triangles at an edge in the order of their angles around it.
std::vector<EdgeSide> SidesAround(
  const SealedComplex& complex, const std::vector<ComplexEdge>& edges, std::size_t first, std::size_t last)
{
  const auto from = std::int32_t(edges[first].Key >> 32U), to = std::int32_t(edges[first].Key & 0xFFFFFFFFU);
  const Eigen::Vector3d& origin = complex.Vertices[std::size_t(from)];
  const Eigen::Vector3d axis = (complex.Vertices[std::size_t(to)] - origin).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<EdgeSide> around;
  for (std::size_t n = first; n < last; ++n)
  {
    const SheetCorners& corners = complex.Triangles[std::size_t(edges[n].Triangle)].Corners;
    const auto corner = std::size_t(edges[n].Corner);
    const Eigen::Vector3d across = complex.Vertices[std::size_t(corners[(corner + 2) % 3])] - origin;
    // Seen against the axis, a triangle that runs along it has its front where angles rise.
    around.push_back({ std::atan2(across.dot(v), across.dot(u)), edges[n].Triangle, corners[corner] == from ? 0 : 1 });
  }
  std::sort(around.begin(), around.end(), [](const EdgeSide& a, const EdgeSide& b) { return a.Angle < b.Angle; });
  return around;
}

/// By the first side of each set.
std::vector<double> SumVolumes(const SealedComplex& complex, DisjointSets& sides)
{
  const std::vector<LabelledTriangle>& triangles = complex.Triangles;
  std::vector<double> volumes(2 * triangles.size(), 0.0);
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    const SheetCorners& corners = triangles[n].Corners;
    const Eigen::Vector3d& first = complex.Vertices[std::size_t(corners[0])];
    const double volume = first.dot(CrossOf(complex.Vertices, corners)) / 6.0;
    volumes[std::size_t(sides.Find(std::int32_t(2 * n)))] -= volume;
    volumes[std::size_t(sides.Find(std::int32_t(2 * n + 1)))] += volume;
  }
  return volumes;
}

/// Whether sets have triangles with another set behind; others are faults that touch no other surface.
std::vector<unsigned char> FindShells(std::size_t triangles, DisjointSets& sides)
{
  std::vector<unsigned char> isShell(2 * triangles, 0);
  for (std::size_t n = 0; n < triangles; ++n)
  {
    const auto before = std::size_t(sides.Find(std::int32_t(2 * n))),
               behind = std::size_t(sides.Find(std::int32_t(2 * n + 1)));
    isShell[before] = isShell[before] != 0 || before != behind ? 1 : 0;
    isShell[behind] = isShell[behind] != 0 || before != behind ? 1 : 0;
  }
  return isShell;
}

/// The body with the label around a place, by the turns of its surface around it (van Oosterom & Strackee 1983, "The solid
/// angle of a plane triangle"). bodyOf(2 * triangle + side) gives numbers.
template <typename BodyOf>
std::int32_t FindBodyAt(const SealedComplex& complex, const Eigen::Vector3d& place, SealedLabel label, BodyOf&& bodyOf)
{
  std::map<std::int32_t, double> turns;
  for (std::size_t n = 0; n < complex.Triangles.size(); ++n)
  {
    const LabelledTriangle& triangle = complex.Triangles[n];
    std::array<Eigen::Vector3d, 3> to;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      to[corner] = complex.Vertices[std::size_t(triangle.Corners[corner])] - place;
    }
    const std::array<double, 3> far = { to[0].norm(), to[1].norm(), to[2].norm() };
    const double angle = std::atan2(to[0].dot(to[1].cross(to[2])),
      far[0] * far[1] * far[2] + to[0].dot(to[1]) * far[2] + to[1].dot(to[2]) * far[0] + to[2].dot(to[0]) * far[1]);
    for (std::size_t side = 0; side < 2; ++side)
    {
      if (triangle.Labels[side] == label && bodyOf(2 * n + side) >= 0)
      {
        turns[bodyOf(2 * n + side)] += side == 0 ? -angle : angle;
      }
    }
  }
  return std::max_element(turns.begin(), turns.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}
}

//----------------------------------------------------------------------------------------------------------------------
void DropUnused(SealedComplex& complex)
{
  std::vector<std::int32_t> numbers(complex.Vertices.size(), -1);
  std::vector<Eigen::Vector3d> used;
  for (LabelledTriangle& triangle : complex.Triangles)
  {
    for (std::int32_t& corner : triangle.Corners)
    {
      std::int32_t& number = numbers[std::size_t(corner)];
      if (number < 0)
      {
        number = std::int32_t(used.size());
        used.push_back(complex.Vertices[std::size_t(corner)]);
      }
      corner = number;
    }
  }
  complex.Vertices = std::move(used);
}

//----------------------------------------------------------------------------------------------------------------------
SealedComplex KeepDifferent(Arrangement arrangement, const LabelFinder& labelAt, const Monitor& monitor)
{
  const std::vector<ArrangedTriangle>& triangles = arrangement.Triangles;
  DisjointSets parts = PartsBetweenLines(arrangement);
  std::vector<std::int32_t> largest(triangles.size(), -1);
  std::vector<double> areas(triangles.size());
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    areas[n] = CrossOf(arrangement.Vertices, triangles[n].Corners).squaredNorm();
    std::int32_t& best = largest[std::size_t(parts.Find(std::int32_t(n)))];
    best = best < 0 || areas[n] > areas[std::size_t(best)] ? std::int32_t(n) : best;
  }
  std::vector<std::array<SealedLabel, 2>> labels(triangles.size());
  SealedComplex complex;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    const auto part = std::size_t(parts.Find(std::int32_t(n)));
    if (part == n)
    {
      monitor.Progress(double(n) / double(triangles.size()));
      const ArrangedTriangle& triangle = triangles[std::size_t(largest[n])];
      const Eigen::Vector3d middle = CentreOf(arrangement.Vertices, triangle.Corners);
      labels[n] = { labelAt(middle, triangle.Sheet, 0), labelAt(middle, triangle.Sheet, 1) };
    }
    if (labels[part][0] != labels[part][1])
    {
      complex.Triangles.push_back({ triangles[n].Corners, triangles[n].Sheet, labels[part] });
    }
  }
  complex.Vertices = std::move(arrangement.Vertices);
  DropUnused(complex);
  return complex;
}

//----------------------------------------------------------------------------------------------------------------------
ComplexBodies FindBodies(const SealedComplex& complex)
{
  const std::vector<LabelledTriangle>& triangles = complex.Triangles;
  ComplexBodies bodies;
  DisjointSets sides(2 * triangles.size());
  const std::vector<ComplexEdge> edges = SortEdges(triangles);
  ForEachEdge(edges,
    [&](std::size_t first, std::size_t last)
    {
      const std::vector<EdgeSide> around = SidesAround(complex, edges, first, last);
      for (std::size_t n = 0; n < around.size(); ++n)
      {
        const EdgeSide &here = around[n], &next = around[(n + 1) % around.size()];
        const SealedLabel risen = triangles[std::size_t(here.Triangle)].Labels[std::size_t(here.Rising)];
        const SealedLabel met = triangles[std::size_t(next.Triangle)].Labels[std::size_t(1 - next.Rising)];
        if (risen != met) // of one triangle, too
        {
          throw InputError("surfaces that do not close at " +
            PlaceText(complex.Vertices[std::size_t(edges[first].Key >> 32U)]) + ", expected a body on each side");
        }
        sides.Join(2 * here.Triangle + here.Rising, 2 * next.Triangle + 1 - next.Rising);
        const double gap = next.Angle - here.Angle + (n + 1 == around.size() ? 360.0 / DegreesPerRadian : 0.0);
        bodies.LeastAngle = std::min(bodies.LeastAngle, gap * DegreesPerRadian);
      }
    });
  const std::vector<double> volumes = SumVolumes(complex, sides);
  const std::vector<unsigned char> isShell = FindShells(triangles.size(), sides);
  std::vector<std::int32_t> numbers(2 * triangles.size(), -1);
  for (std::size_t n = 0; n < 2 * triangles.size(); ++n)
  {
    const SealedLabel label = triangles[n / 2].Labels[n % 2];
    if (sides.Find(std::int32_t(n)) != std::int32_t(n) || label == OutsideLabel || isShell[n] == 0)
    {
      continue;
    }
    if (!(volumes[n] > 0.0))
    {
      throw InputError("a body inside another one at " +
        PlaceText(complex.Vertices[std::size_t(triangles[n / 2].Corners[0])]) + ", expected one beside it");
    }
    numbers[n] = std::int32_t(bodies.Labels.size());
    bodies.Labels.push_back(label);
    bodies.Volumes.push_back(volumes[n]);
  }
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    const auto own = std::size_t(sides.Find(std::int32_t(2 * n)));
    if (isShell[own] == 0 && numbers[own] < 0)
    {
      const Eigen::Vector3d& place = complex.Vertices[std::size_t(triangles[n].Corners[0])];
      numbers[own] = FindBodyAt(complex, place, triangles[n].Labels[0],
        [&](std::size_t side) { return numbers[std::size_t(sides.Find(std::int32_t(side)))]; });
    }
  }
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    bodies.OfTriangles.push_back({ numbers[std::size_t(sides.Find(std::int32_t(2 * n)))],
      numbers[std::size_t(sides.Find(std::int32_t(2 * n + 1)))] });
  }
  return bodies;
}
}
