// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates a patch with several advancing fronts in parallel.

#ifndef SeismicHorizonsPatchFront_h
#define SeismicHorizonsPatchFront_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"
#include "SearchGrid.h"
#include "ThirdPointSearch.h"

#include <cassert>
#include <vector>

namespace SeismicHorizons
{
struct FrontEdge
{
  PointId From = NoPoint;
  PointId To = NoPoint;
  /// This is the diameter of the circumcircle of the adjacent triangle, or 0 if unknown.
  float Diameter = 0.0f;
};

/// Edges that wait for a triangle to their left (edge pool of the thesis, 5.3.7), in linked lists by first point, as
/// few edges share one. Memory is 4 bytes per point and 24 per edge.
class AdvancingFront
{
public:
  AdvancingFront(PointId first, PointId end)
    : FirstPoint(first)
    , First(end - first, None)
  {
  }

  void Add(const FrontEdge& edge)
  {
    std::int32_t& first = this->FirstLink(edge.From);
    const std::int32_t link = this->NewLink();
    this->Links[link] = { edge.To, first };
    first = link;
    this->Newest.push_back(edge);
  }

  bool Remove(PointId from, PointId to)
  {
    std::int32_t* link = &this->FirstLink(from);
    while (*link != None && this->Links[*link].To != to)
    {
      link = &this->Links[*link].Next;
    }
    if (*link == None)
    {
      return false;
    }
    this->Free.push_back(*link);
    *link = this->Links[*link].Next;
    return true;
  }

  /// If the edge waited for this triangle, it leaves the front; otherwise its reverse waits for one.
  void AddEdge(const FrontEdge& edge)
  {
    if (!this->Remove(edge.From, edge.To))
    {
      this->Add({ edge.To, edge.From, edge.Diameter });
    }
  }

  bool TakeNewest(FrontEdge& edge)
  {
    while (!this->Newest.empty())
    {
      edge = this->Newest.back();
      this->Newest.pop_back();
      // Removed edges are still in this list.
      if (this->Remove(edge.From, edge.To))
      {
        return true;
      }
    }
    return false;
  }

private:
  static constexpr std::int32_t None = -1;

  struct Link
  {
    PointId To;
    std::int32_t Next;
  };

  std::int32_t& FirstLink(PointId from)
  {
    assert(from >= this->FirstPoint && std::size_t(from - this->FirstPoint) < this->First.size());
    return this->First[from - this->FirstPoint];
  }

  std::int32_t NewLink()
  {
    if (this->Free.empty())
    {
      this->Links.emplace_back();
      return std::int32_t(this->Links.size() - 1);
    }
    const std::int32_t link = this->Free.back();
    this->Free.pop_back();
    return link;
  }

  const PointId FirstPoint;
  std::vector<std::int32_t> First; // by point
  std::vector<Link> Links;
  std::vector<std::int32_t> Free;
  std::vector<FrontEdge> Newest;
};

/// Points have the numbers of the search grid.
class PatchFront
{
public:
  /// Keeps references. There may be fewer strips, if a row of search cells has many points. With one strip the newest
  /// edge is always next.
  PatchFront(const SearchGrid& points, const ThirdPointSearch& search, std::int64_t strips);

  static std::int64_t FindStrips(const SearchGrid& points);

  /// The left of the edge must be outside or meshed; its reverse waits for a triangle. Added in both directions, it has
  /// no surface on either side.
  void AddEdge(PointId from, PointId to);

  /// Throws InputError if an edge finds no third point.
  void Grow(std::size_t most, const Monitor& monitor);

  /// By Euler's formula a planar mesh has less than two triangles per point.
  std::size_t MostTriangles() const { return 2 * std::size_t(this->Points.NumberOfPoints()); }

  std::size_t NumberOfTriangles() const;

  Edge LastEdge() const
  {
    assert(this->Parts.size() == 1 && !this->Parts.back().empty());
    const RawVector<PointId>& triangles = this->Parts.back();
    return { triangles[triangles.size() - 3], triangles[triangles.size() - 2] };
  }

  bool IsUsed(PointId point) const { return this->Used[point] != 0; }
  void Use(PointId point) { this->Used[point] = 1; }

  /// Corners are names of points.
  void MoveTriangles(RawVector<PointId>& corners);

private:
  struct Region
  {
    std::size_t FirstStrip = 0;
    std::size_t EndStrip = 0;
    std::vector<FrontEdge> Edges;
  };

  struct Growth
  {
    Region Below;
    Region Above;
    RawVector<PointId> Triangles;
  };

  void MakeStrips(std::int64_t strips);
  std::vector<Region> GrowRegions(const std::vector<Region>& regions, const Monitor& monitor);
  Growth GrowWall(const Region& region);
  void GrowStrip(const Region& region, std::size_t most, const Monitor& monitor, RawVector<PointId>& triangles);
  template <typename EdgeAdder>
  void GrowTriangles(AdvancingFront& front, const Region& region, std::size_t most, const Monitor& monitor,
    RawVector<PointId>& triangles, EdgeAdder&& addEdge);
  [[noreturn]] void ThrowNoThird(const FrontEdge& edge) const;

  PointId FirstPointOf(const Region& region) const { return this->StripStarts[region.FirstStrip]; }
  PointId EndPointOf(const Region& region) const { return this->StripStarts[region.EndStrip]; }

  const SearchGrid& Points;
  const ThirdPointSearch& Search;
  std::vector<PointId> StripStarts;
  std::vector<FrontEdge> Edges;
  std::vector<unsigned char> Used; // Several threads write these, so that they are bytes, not bits.
  std::vector<RawVector<PointId>> Parts; // triangles of walls and strips
};
}

#endif
