// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LoopChange.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/EdgeLoops.h"
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
using PlaneCorners = std::array<PlanePoint, 3>;
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

bool Enters(const std::array<PlanePoint, 2>& line, const PlaneCorners& corners)
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

/// Lines by bands of rows.
class LineList
{
public:
  LineList(const Sides& sides, PlanePoints places)
  {
    for (const auto& [from, to] : sides)
    {
      const auto [low, high] = std::minmax({ BandOf(places[from]), BandOf(places[to]) });
      for (std::int32_t band = low; band <= high; ++band)
      {
        this->Bands.emplace_back(band, this->Lines.size());
      }
      this->Lines.push_back({ places[from], places[to] });
    }
    std::sort(this->Bands.begin(), this->Bands.end());
  }

  bool AnyEnters(const PlaneCorners& corners) const
  {
    PlaneBox box;
    std::for_each(corners.begin(), corners.end(), [&box](const PlanePoint& corner) { box.Add(corner); });
    auto band =
      std::lower_bound(this->Bands.begin(), this->Bands.end(), std::make_pair(BandOf(box.Least), std::size_t(0)));
    for (; band != this->Bands.end() && band->first <= BandOf(box.Greatest); ++band)
    {
      const Line& line = this->Lines[band->second];
      const auto [left, right] = std::minmax({ line[0].X, line[1].X });
      if (right >= box.Least.X && left <= box.Greatest.X && Enters(line, corners))
      {
        return true;
      }
    }
    return false;
  }

private:
  using Line = std::array<PlanePoint, 2>;

  static std::int32_t BandOf(const PlanePoint& place) { return place.Y >> 6; }

  std::vector<Line> Lines;
  std::vector<std::pair<std::int32_t, std::size_t>> Bands; // and numbers of lines
};

/// Loops have the surface to their right, sides to their left.
Loops LoopsOf(const Sides& sides)
{
  std::vector<Edge> edges;
  std::transform(sides.begin(), sides.end(), std::back_inserter(edges),
    [](const Side& side) {
      return Edge{ side.first, side.second };
    });
  const Loops joined = JoinEdges(std::move(edges));
  Loops loops;
  for (std::size_t loop = 0; loop < joined.Size(); ++loop)
  {
    std::for_each(std::make_reverse_iterator(joined.end(loop)), std::make_reverse_iterator(joined.begin(loop)),
      [&loops](PointId point) { loops.Append(point); });
    loops.Close();
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

  std::optional<LoopChange> Run(const std::vector<unsigned char>& mayStay)
  {
    this->FindOuter();
    this->FindGone(mayStay);
    this->FindOpen();
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
  using OuterSide = std::pair<Side, TriangleId>;

  Side SideOf(TriangleId triangle, int edge) const
  {
    return { this->Sources[this->Mesh.Corner(triangle, edge)],
      this->Sources[this->Mesh.Corner(triangle, NextCorner(edge))] };
  }

  void FindOuter()
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        if (this->Mesh.Neighbour(triangle, edge) == NoTriangle)
        {
          this->Outer.emplace_back(this->SideOf(triangle, edge), triangle);
        }
      }
    }
  }

  void FindGone(const std::vector<unsigned char>& mayStay)
  {
    Sides before;
    std::transform(this->Outer.begin(), this->Outer.end(), std::back_inserter(before),
      [](const OuterSide& outer) { return outer.first; });
    std::sort(before.begin(), before.end());
    Sides added;
    std::set_difference(
      this->Boundary.begin(), this->Boundary.end(), before.begin(), before.end(), std::back_inserter(added));
    const LineList lines(added, this->Places);
    this->Result.Gone = CollectChunks<TriangleId>(this->Mesh.Size(), Grain, Monitor(),
      [&](std::vector<TriangleId>& gone, std::int64_t first, std::int64_t last)
      {
        for (auto triangle = TriangleId(first); triangle < TriangleId(last); ++triangle)
        {
          const auto& [a, b, c] = this->Mesh.Corners(triangle);
          const bool mayAllStay = mayStay[a] != 0 && mayStay[b] != 0 && mayStay[c] != 0;
          if (!mayAllStay || lines.AnyEnters({ this->Mesh.Place(a), this->Mesh.Place(b), this->Mesh.Place(c) }))
          {
            gone.push_back(triangle);
          }
        }
      });
  }

  bool Stays(TriangleId triangle) const
  {
    return !std::binary_search(this->Result.Gone.begin(), this->Result.Gone.end(), triangle);
  }

  /// Around the rest, that is beside triangles that stay, and on the new boundary elsewhere.
  void FindOpen()
  {
    Sides covered;
    const auto add = [&](const Side& ofStaying)
    {
      if (IsIn(this->Boundary, ofStaying))
      {
        covered.push_back(ofStaying);
      }
      else
      {
        this->Open.emplace_back(ofStaying.second, ofStaying.first);
      }
    };
    for (const auto& [side, triangle] : this->Outer)
    {
      if (this->Stays(triangle))
      {
        add(side);
      }
    }
    for (const TriangleId triangle : this->Result.Gone)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const TriangleId beyond = this->Mesh.Neighbour(triangle, edge);
        if (beyond != NoTriangle && this->Stays(beyond))
        {
          const Side side = this->SideOf(triangle, edge);
          add({ side.second, side.first });
        }
      }
    }
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
      this->Result.Added.push_back(points[std::size_t(corner)]);
    }
  }

  /// A check: triangles that cover a place twice, or miss one, have another area.
  bool IsCovered() const
  {
    const PlanePoint origin = this->Places.front();
    std::int64_t area = 0;
    for (const auto& [from, to] : this->Open)
    {
      area += SignedArea(origin, this->Places[from], this->Places[to]);
    }
    const RawVector<PointId>& corners = this->Result.Added;
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
  std::vector<OuterSide> Outer; // of the mesh before
  Sides Open;
  LoopChange Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<LoopChange> ChangeLoops(const PlaneMesh& mesh, const std::vector<PointId>& sources,
  const std::vector<unsigned char>& mayStay, PlanePoints places, const Loops& boundary)
{
  return LoopChanger(mesh, sources, places, boundary).Run(mayStay);
}
}
