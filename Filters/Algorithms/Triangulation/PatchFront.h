// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a patch by advancing fronts, several of them side by side.

#ifndef SeismicHorizonsPatchFront_h
#define SeismicHorizonsPatchFront_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "SearchGrid.h"
#include "ThirdPointSearch.h"

#include <cassert>
#include <vector>

namespace SeismicHorizons
{
/// A side that has something to its left, or an edge that waits for it.
struct FrontEdge
{
  PointId From = NoPoint;
  PointId To = NoPoint;
  /// Of the circle of the triangle on the side that is meshed; 0 where that is not known.
  float Diameter = 0.0f;
};

/// The edges that wait for a triangle to their left (the thesis's edge pool, 5.3.7); the newest can be taken.
/// Few of its edges begin in the same point, so each point has a linked list of those that begin in it. 4 bytes per
/// point, and 24 per edge.
class AdvancingFront
{
public:
  /// For edges that begin in the points from `first` to before `end`.
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

  /// Removes an edge; false when it is not in the front.
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

  /// Adds a side that has something to its left now: if it waited for that it leaves the front, else its reverse waits
  /// for a triangle.
  void AddSide(const FrontEdge& side)
  {
    if (!this->Remove(side.From, side.To))
    {
      this->Add({ side.To, side.From, side.Diameter });
    }
  }

  /// Removes the edge that was added last; false when the front is empty.
  bool TakeNewest(FrontEdge& edge)
  {
    while (!this->Newest.empty())
    {
      edge = this->Newest.back();
      this->Newest.pop_back();
      // Edges that were removed in the meantime are still in this list.
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
  std::vector<std::int32_t> First; // for each point the first link of its list
  std::vector<Link> Links;
  std::vector<std::int32_t> Free; // links that are in no list
  std::vector<FrontEdge> Newest; // in the order in which they were added
};

/// Points have the numbers of the search here, except where names are asked for.
class PatchFront
{
public:
  /// Both must outlive the front. It has about as many strips as asked for, fewer where one row of voxels has more
  /// points. With one strip the newest edge is always the next.
  PatchFront(const SearchGrid& points, const ThirdPointSearch& search, std::int64_t strips);

  /// How many strips make the walls a small part of the work.
  static std::int64_t FindStrips(const SearchGrid& points);

  /// Adds a side that has the outside or something meshed to its left: its reverse waits for a triangle. One that is
  /// added in both directions has surface on neither side.
  void AddSide(PointId from, PointId to);

  /// Makes up to that many triangles, all if that is more. Throws InputError when an edge finds no third point.
  void Grow(std::size_t most, const Monitor& monitor);

  /// By Euler's formula a plane mesh has less than two triangles per point.
  std::size_t MostTriangles() const { return 2 * std::size_t(this->Points.NumberOfPoints()); }

  std::size_t NumberOfTriangles() const;

  /// The edge whose triangle was made last, with a single strip.
  Edge LastEdge() const
  {
    assert(this->Parts.size() == 1 && !this->Parts.back().empty());
    const RawVector<PointId>& triangles = this->Parts.back();
    return { triangles[triangles.size() - 3], triangles[triangles.size() - 2] };
  }

  /// Whether a side or a triangle has the point.
  bool IsUsed(PointId point) const { return this->Used[point] != 0; }
  void Use(PointId point) { this->Used[point] = 1; }

  /// Appends the triangles by the names of their points, and forgets them.
  void MoveTriangles(RawVector<PointId>& corners);

private:
  /// Strips that follow each other, and the sides in them that have something to their left.
  struct Region
  {
    std::size_t FirstStrip = 0;
    std::size_t EndStrip = 0;
    std::vector<FrontEdge> Sides;
  };

  /// What a region without its middle wall falls into, and the triangles of the wall; or of all for a single strip.
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
  template <typename SideAdder>
  void GrowTriangles(AdvancingFront& front, const Region& region, std::size_t most, const Monitor& monitor,
    RawVector<PointId>& triangles, SideAdder&& addSide);
  [[noreturn]] void ThrowNoThird(const FrontEdge& edge) const;

  PointId FirstPointOf(const Region& region) const { return this->StripStarts[region.FirstStrip]; }
  PointId EndPointOf(const Region& region) const { return this->StripStarts[region.EndStrip]; }

  const SearchGrid& Points;
  const ThirdPointSearch& Search;
  std::vector<PointId> StripStarts; // the first point of each strip, and in the end the number of points
  std::vector<FrontEdge> Sides;
  std::vector<unsigned char> Used; // bytes, as several threads write them
  std::vector<RawVector<PointId>> Parts; // triangles, of the walls and strips in the order in which they are made
};
}

#endif
