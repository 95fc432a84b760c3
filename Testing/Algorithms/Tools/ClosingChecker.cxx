// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ClosingChecker.h"

#include "CutLattice.h"
#include "ExactPlane.h"

#include <algorithm>
#include <array>

namespace ClosingChecker
{
using namespace ExactPlane;
using CutChecker::CutLattice;
using SeismicHorizons::Loops;

namespace
{
using HalfEdge = std::pair<PointId, PointId>;
using Corners = std::array<PlanePoint, 3>;

/// Calls visit(from, to) for the sides of triangles.
template <typename Visitor>
void ForEachSide(const RawVector<PointId>& triangles, Visitor&& visit)
{
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    visit(triangles[n], triangles[n % 3 == 2 ? n - 2 : n + 1]);
  }
}

std::set<HalfEdge> SidesOf(const RawVector<PointId>& triangles)
{
  std::set<HalfEdge> sides;
  ForEachSide(triangles, [&sides](PointId from, PointId to) { sides.insert({ from, to }); });
  return sides;
}

std::set<HalfEdge> EdgesOf(const Loops& loops)
{
  std::set<HalfEdge> edges;
  loops.ForEachEdge([&edges](PointId from, PointId to) { edges.insert({ from, to }); });
  return edges;
}

PlanePoint ColumnOf(const BoundedHorizon& horizon, PointId point)
{
  const PlanePoint& place = horizon.Plane[std::size_t(point)];
  return { place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn };
}

std::vector<Corners> PlacesOf(const BoundedHorizon& horizon, const RawVector<PointId>& triangles)
{
  std::vector<Corners> places;
  for (std::size_t n = 0; n < triangles.size(); n += 3)
  {
    const auto at = [&](std::size_t corner) { return horizon.Plane[std::size_t(triangles[n + corner])]; };
    places.push_back({ at(0), at(1), at(2) });
  }
  return places;
}

Wide TwiceArea(const Corners& triangle)
{
  return Turn(triangle[0], triangle[1], triangle[2]);
}

/// Whether a side of the first has all of the second on its right, or on it.
bool IsParted(const Corners& a, const Corners& b)
{
  for (std::size_t n = 0; n < 3; ++n)
  {
    const PlanePoint& from = a[n];
    const PlanePoint& to = a[(n + 1) % 3];
    if (std::all_of(b.begin(), b.end(), [&](const PlanePoint& corner) { return Turn(from, to, corner) <= 0; }))
    {
      return true;
    }
  }
  return false;
}

bool Overlap(const Corners& a, const Corners& b)
{
  return !IsParted(a, b) && !IsParted(b, a);
}

std::string CheckOverlaps(const std::vector<Corners>& mesh, const std::vector<Corners>& closing)
{
  for (std::size_t n = 0; n < closing.size(); ++n)
  {
    const auto overlaps = [&](const Corners& other) { return Overlap(closing[n], other); };
    if (TwiceArea(closing[n]) <= 0)
    {
      return "closing triangle " + std::to_string(n) + " does not turn counter-clockwise";
    }
    if (std::any_of(mesh.begin(), mesh.end(), overlaps))
    {
      return "closing triangle " + std::to_string(n) + " overlaps the mesh";
    }
    if (std::any_of(closing.begin() + std::ptrdiff_t(n) + 1, closing.end(), overlaps))
    {
      return "closing triangle " + std::to_string(n) + " overlaps another one";
    }
  }
  return {};
}

std::string CheckSides(const RawVector<PointId>& mesh, const RawVector<PointId>& closing)
{
  std::set<HalfEdge> sides;
  std::string wrong;
  const auto add = [&](PointId from, PointId to)
  {
    if (!sides.insert({ from, to }).second && wrong.empty())
    {
      wrong = "two triangles to the left of the edge from " + std::to_string(from) + " to " + std::to_string(to);
    }
  };
  ForEachSide(mesh, add);
  ForEachSide(closing, add);
  return wrong;
}

/// Whether what cuts took from the surface is to the left of a hop to a neighbour.
bool IsCrackToTheLeft(const CutLattice& lattice, const PlanePoint& from, const PlanePoint& to)
{
  const PlanePoint step{ to.X - from.X, to.Y - from.Y };
  const PlanePoint left{ -step.Y, step.X };
  // The middle of the block to the left, in halves of columns, is half a step ahead and to the left.
  const PlanePoint ahead =
    std::abs(step.X) + std::abs(step.Y) == 2 ? step : PlanePoint{ step.X + left.X, step.Y + left.Y };
  const PlanePoint block{ (2 * from.X + ahead.X - 1) / 2, (2 * from.Y + ahead.Y - 1) / 2 };
  const int points = lattice.NumberOfPoints(block);
  const int lost = std::max(points - 2, 0) - lattice.TwiceArea(block);
  if (lost <= 0)
  {
    return false;
  }
  if (std::abs(step.X) + std::abs(step.Y) == 2)
  {
    // The corner of the block to the left of the diagonal.
    const PlanePoint corner{ from.X + (step.X + left.X) / 2, from.Y + (step.Y + left.Y) / 2 };
    return lattice.Has(corner);
  }
  const int lone = lattice.LoneCorner(block);
  const PlanePoint corner = lone < 0 ? from : CutLattice::Corners(block)[std::size_t(lone)];
  return points < 4 || lone < 0 || corner == from || corner == to;
}

/// The numbers of the points of a simplified loop in the full one; empty where they do not follow each other there.
std::vector<std::size_t> Align(const std::vector<PlanePoint>& full, const std::vector<PlanePoint>& simplified)
{
  for (std::size_t start = 0; start < full.size(); ++start)
  {
    std::vector<std::size_t> numbers;
    for (std::size_t n = 0; n < full.size() && numbers.size() < simplified.size(); ++n)
    {
      if (full[(start + n) % full.size()] == simplified[numbers.size()])
      {
        numbers.push_back((start + n) % full.size());
      }
    }
    if (numbers.size() == simplified.size() && numbers.front() == start)
    {
      return numbers;
    }
  }
  return {};
}

std::vector<PlanePoint> PlacesOfLoop(const BoundedHorizon& horizon, std::size_t loop)
{
  std::vector<PlanePoint> places;
  std::transform(horizon.Boundary.begin(loop), horizon.Boundary.end(loop), std::back_inserter(places),
    [&horizon](PointId point) { return ColumnOf(horizon, point); });
  return places;
}
}

//----------------------------------------------------------------------------------------------------------------------
Outline FindOutline(const BoundedHorizon& horizon, const RawVector<PointId>& closing)
{
  const std::set<HalfEdge> sides = SidesOf(closing);
  const std::set<HalfEdge> edges = EdgesOf(horizon.Boundary);
  Outline outline;
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to) {
      outline.IsCutoff.push_back(sides.count({ from, to }) != 0);
    });
  for (const HalfEdge& side : sides)
  {
    if (sides.count({ side.second, side.first }) == 0 && edges.count(side) == 0)
    {
      outline.OpenEnds.insert({ ColumnOf(horizon, side.first), ColumnOf(horizon, side.second) });
    }
  }
  return outline;
}

//----------------------------------------------------------------------------------------------------------------------
Outline FindOutlineOfBlocks(const CrackedPatch& patch, const BoundedHorizon& horizon)
{
  const CutLattice lattice(patch);
  Outline outline;
  horizon.Boundary.ForEachEdge([&](PointId from, PointId to)
    { outline.IsCutoff.push_back(IsCrackToTheLeft(lattice, ColumnOf(horizon, from), ColumnOf(horizon, to))); });
  const std::set<HalfEdge> edges = EdgesOf(horizon.Boundary);
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    for (int n = 0; n < 9; ++n)
    {
      const PlanePoint from = ColumnOf(horizon, PointId(point));
      const PlanePoint to{ from.X + n % 3 - 1, from.Y + n / 3 - 1 };
      const bool isHop = from != to && lattice.Has(to) && edges.count({ PointId(point), lattice.At(to) }) == 0;
      const PlanePoint block{ std::min(from.X, to.X), std::min(from.Y, to.Y) };
      const bool isInside = from.X != to.X && from.Y != to.Y && lattice.NumberOfPoints(block) == 4;
      if (isHop && !isInside && IsCrackToTheLeft(lattice, from, to) && !IsCrackToTheLeft(lattice, to, from) &&
        edges.count({ lattice.At(to), PointId(point) }) == 0)
      {
        outline.OpenEnds.insert({ from, to });
      }
    }
  }
  return outline;
}

//----------------------------------------------------------------------------------------------------------------------
Outline SimplifyOutline(const BoundedHorizon& full, const Outline& outline, const BoundedHorizon& simplified)
{
  Outline result;
  result.OpenEnds = outline.OpenEnds;
  std::size_t first = 0;
  for (std::size_t loop = 0; loop < full.Boundary.Size(); ++loop)
  {
    if (full.Boundary.Length(loop) > 1)
    {
      for (const std::size_t n : Align(PlacesOfLoop(full, loop), PlacesOfLoop(simplified, loop)))
      {
        result.IsCutoff.push_back(outline.IsCutoff[first + n]);
      }
      first += full.Boundary.Length(loop);
    }
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckClosing(const BoundedHorizon& horizon, const RawVector<PointId>& mesh,
  const RawVector<PointId>& closing, const Outline& outline)
{
  const std::string overlaps = CheckOverlaps(PlacesOf(horizon, mesh), PlacesOf(horizon, closing));
  const std::string sides = overlaps.empty() ? CheckSides(mesh, closing) : overlaps;
  if (!sides.empty())
  {
    return sides;
  }
  const Outline found = FindOutline(horizon, closing);
  if (found.IsCutoff != outline.IsCutoff)
  {
    return "cutoffs that are closed";
  }
  return found.OpenEnds == outline.OpenEnds ? std::string() : "open ends of cracks";
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckBlocks(const CrackedPatch& patch, const BoundedHorizon& horizon, const RawVector<PointId>& closing)
{
  const CutLattice lattice(patch);
  const std::vector<Corners> triangles = PlacesOf(horizon, closing);
  Wide area = 0;
  for (const Corners& triangle : triangles)
  {
    area += TwiceArea(triangle);
  }
  const Wide scale = Wide(horizon.SubVoxelsPerColumn) * horizon.SubVoxelsPerColumn;
  std::string wrong;
  CutChecker::ForEachBlock(lattice.Extent(),
    [&](const PlanePoint& block)
    {
      area -= scale * (std::max(lattice.NumberOfPoints(block) - 2, 0) - lattice.TwiceArea(block));
      const PlanePoint place{ block.X * horizon.SubVoxelsPerColumn, block.Y * horizon.SubVoxelsPerColumn };
      const auto isIn = [&place](const Corners& triangle)
      {
        return Turn(triangle[0], triangle[1], place) >= 0 && Turn(triangle[1], triangle[2], place) >= 0 &&
          Turn(triangle[2], triangle[0], place) >= 0;
      };
      if (!lattice.Has(block) && std::any_of(triangles.begin(), triangles.end(), isIn))
      {
        wrong = "closed over a missing column";
      }
    });
  return wrong.empty() && area != 0 ? "area of the cracks" : wrong;
}
}
