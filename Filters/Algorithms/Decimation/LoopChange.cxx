// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LoopChange.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using Corners = std::array<PlanePoint, 3>;
/// The surface is to the left, as of edges of triangles.
using Side = std::pair<PointId, PointId>;
using Sides = std::vector<Side>;

bool IsIn(const Sides& sides, const Side& side)
{
  return std::binary_search(sides.begin(), sides.end(), side);
}

/// Sorted. Edges in both directions have no surface on either side.
Sides SidesOf(const Loops& loops)
{
  Sides all;
  loops.ForEachEdge([&all](PointId from, PointId to) { all.emplace_back(to, from); });
  std::sort(all.begin(), all.end());
  Sides sides;
  std::copy_if(all.begin(), all.end(), std::back_inserter(sides),
    [&all](const Side& side) {
      return !IsIn(all, { side.second, side.first });
    });
  return sides;
}

bool Enters(const std::array<PlanePoint, 2>& line, const Corners& corners)
{
  const auto isInside = [&](const PlanePoint& end)
  {
    return std::find(corners.begin(), corners.end(), end) == corners.end() &&
      SignedArea(corners[0], corners[1], end) >= 0 && SignedArea(corners[1], corners[2], end) >= 0 &&
      SignedArea(corners[2], corners[0], end) >= 0;
  };
  bool enters = isInside(line[0]) || isInside(line[1]);
  for (std::size_t n = 0; n < 3 && !enters; ++n)
  {
    enters =
      ProperlyCross(line[0], line[1], corners[n], corners[(n + 1) % 3]) || OnOpenSegment(line[0], line[1], corners[n]);
  }
  return enters;
}

/// Lines by their least row.
class LineList
{
public:
  LineList(const Sides& sides, PlanePoints places)
  {
    for (const auto& [from, to] : sides)
    {
      const bool isUp = places[from].Y <= places[to].Y;
      this->Lines.push_back({ places[isUp ? from : to], places[isUp ? to : from] });
      this->Tallest = std::max(this->Tallest, std::int64_t(this->Lines.back()[1].Y) - this->Lines.back()[0].Y);
    }
    std::sort(
      this->Lines.begin(), this->Lines.end(), [](const Line& a, const Line& b) { return PrecedesByRow(a[0], b[0]); });
  }

  bool AnyEnters(const Corners& corners) const
  {
    const auto [left, right] = std::minmax({ corners[0].X, corners[1].X, corners[2].X });
    const auto [low, high] = std::minmax({ corners[0].Y, corners[1].Y, corners[2].Y });
    auto line = std::lower_bound(this->Lines.begin(), this->Lines.end(), std::int64_t(low) - this->Tallest,
      [](const Line& one, std::int64_t row) { return one[0].Y < row; });
    for (; line != this->Lines.end() && (*line)[0].Y <= high; ++line)
    {
      const auto [first, last] = std::minmax((*line)[0].X, (*line)[1].X);
      if ((*line)[1].Y >= low && last >= left && first <= right && Enters(*line, corners))
      {
        return true;
      }
    }
    return false;
  }

private:
  using Line = std::array<PlanePoint, 2>;

  std::vector<Line> Lines;
  std::int64_t Tallest = 0;
};

/// Joins sides to closed loops, at vertices with several in any order.
Loops LoopsOf(Sides sides)
{
  std::sort(sides.begin(), sides.end());
  std::vector<unsigned char> isUsed(sides.size(), 0);
  Loops loops;
  for (std::size_t start = 0; start < sides.size(); ++start)
  {
    std::vector<PointId> loop;
    for (std::size_t next = start; next < sides.size() && isUsed[next] == 0;)
    {
      isUsed[next] = 1;
      loop.push_back(sides[next].first);
      const PointId to = sides[next].second;
      next = std::size_t(std::lower_bound(sides.begin(), sides.end(), Side(to, 0)) - sides.begin());
      while (next < sides.size() && sides[next].first == to && isUsed[next] != 0)
      {
        ++next;
      }
      next = next < sides.size() && sides[next].first == to ? next : sides.size();
    }
    std::for_each(loop.rbegin(), loop.rend(), [&loops](PointId point) { loops.Append(point); });
    if (!loop.empty())
    {
      loops.Close();
    }
  }
  return loops;
}

class LoopChanger
{
public:
  LoopChanger(const PlaneMesh& mesh, const std::vector<PointId>& sources, PlanePoints places, const Loops& boundary)
    : Mesh(mesh)
    , Sources(sources)
    , Places(places)
    , Boundary(SidesOf(boundary))
  {
  }

  std::optional<ChangedMesh> Run(const std::vector<unsigned char>& isLeft)
  {
    this->FindStaying(isLeft);
    this->Take();
    try
    {
      this->Fill();
    }
    catch (const InputError&)
    {
      return {};
    }
    if (!this->IsCovered())
    {
      return {};
    }
    return std::move(this->Result);
  }

private:
  Side SideOf(TriangleId triangle, int edge) const
  {
    return { this->Sources[this->Mesh.Corner(triangle, edge)],
      this->Sources[this->Mesh.Corner(triangle, NextCorner(edge))] };
  }

  Sides NewSides() const
  {
    Sides before;
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        if (this->Mesh.Neighbour(triangle, edge) == NoTriangle)
        {
          before.push_back(this->SideOf(triangle, edge));
        }
      }
    }
    std::sort(before.begin(), before.end());
    Sides added;
    std::set_difference(
      this->Boundary.begin(), this->Boundary.end(), before.begin(), before.end(), std::back_inserter(added));
    return added;
  }

  void FindStaying(const std::vector<unsigned char>& isLeft)
  {
    const LineList lines(this->NewSides(), this->Places);
    this->Stays.resize(std::size_t(this->Mesh.Size()));
    ParallelFor(this->Mesh.Size(), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto triangle = TriangleId(first); triangle < TriangleId(last); ++triangle)
        {
          const auto& [a, b, c] = this->Mesh.Corners(triangle);
          const bool areLeft = isLeft[a] != 0 && isLeft[b] != 0 && isLeft[c] != 0;
          this->Stays[triangle] =
            areLeft && !lines.AnyEnters({ this->Mesh.Place(a), this->Mesh.Place(b), this->Mesh.Place(c) }) ? 1 : 0;
        }
      });
  }

  /// Finds the boundary of the rest, too.
  void Take()
  {
    Sides covered;
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      if (this->Stays[triangle] == 0)
      {
        continue;
      }
      for (int edge = 0; edge < 3; ++edge)
      {
        const Side side = this->SideOf(triangle, edge);
        this->Result.Triangles.push_back(side.first);
        const TriangleId beyond = this->Mesh.Neighbour(triangle, edge);
        if (beyond == NoTriangle || this->Stays[beyond] == 0)
        {
          const bool isOnBoundary = IsIn(this->Boundary, side);
          (isOnBoundary ? covered : this->Open).push_back(isOnBoundary ? side : Side(side.second, side.first));
        }
      }
    }
    this->Result.FirstNew = TriangleId(this->Result.Triangles.size() / 3);
    std::sort(covered.begin(), covered.end());
    std::set_difference(
      this->Boundary.begin(), this->Boundary.end(), covered.begin(), covered.end(), std::back_inserter(this->Open));
  }

  void Fill()
  {
    if (this->Open.empty())
    {
      return;
    }
    std::vector<PointId> points;
    std::transform(
      this->Open.begin(), this->Open.end(), std::back_inserter(points), [](const Side& side) { return side.first; });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    BoundedHorizon rest;
    std::transform(points.begin(), points.end(), std::back_inserter(rest.Plane),
      [this](PointId point) { return this->Places[std::size_t(point)]; });
    rest.Patch.assign(points.size(), 0);
    rest.Boundary = LoopsOf(this->Open)
                      .RenumberedBy([&points](PointId point)
                        { return PointId(std::lower_bound(points.begin(), points.end(), point) - points.begin()); });
    for (const PointId corner : Triangulate(rest).Triangles)
    {
      this->Result.Triangles.push_back(points[std::size_t(corner)]);
    }
  }

  /// No triangle has a negative area, so that the sum is right only if all cover the inside once.
  bool IsCovered() const
  {
    const PlanePoint origin = this->Places.front();
    std::int64_t area = 0;
    for (const auto& [from, to] : this->Boundary)
    {
      area += SignedArea(origin, this->Places[from], this->Places[to]);
    }
    const RawVector<PointId>& corners = this->Result.Triangles;
    for (std::size_t n = 0; n < corners.size(); n += 3)
    {
      area -= SignedArea(this->Places[corners[n]], this->Places[corners[n + 1]], this->Places[corners[n + 2]]);
    }
    return area == 0;
  }

  const PlaneMesh& Mesh;
  const std::vector<PointId>& Sources;
  const PlanePoints Places;
  const Sides Boundary;
  std::vector<unsigned char> Stays; // per triangle
  Sides Open; // around the rest
  ChangedMesh Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<ChangedMesh> ChangeLoops(const PlaneMesh& mesh, const std::vector<PointId>& sources,
  const std::vector<unsigned char>& isLeft, PlanePoints places, const Loops& boundary)
{
  return LoopChanger(mesh, sources, places, boundary).Run(isLeft);
}
}
