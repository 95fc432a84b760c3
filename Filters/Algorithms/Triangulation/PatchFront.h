// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a patch by advancing fronts, several of them side by side.
//
// The voxels are cut into strips of rows. Triangles that reach across the line between two strips make a wall; the
// walls part the rest, so that fronts can grow in each strip without regard to the others. The wall on the middle line
// is made first, then in either half the one on its middle line, and so on (Cignoni, Montani, Scopigno, "DeWall: A fast
// divide and conquer Delaunay triangulation algorithm in E^d", 1998):
//
//     +-----------------+
//     |  front          |
//     |-/\/\/\/\/\/\/\/-|  wall, made second
//     |  front          |
//     |=/\/\/\/\/\/\/\/=|  wall, made first
//     |  front          |
//     |-/\/\/\/\/\/\/\/-|  wall, made second
//     |  front          |
//     +-----------------+
//
// A wall is made by a front, too: of the edges that cross the line. It begins at those of the boundary, where the line
// enters the patch, and ends where it leaves it. Sides of its triangles that do not cross the line go to one of the
// halves. As each third point follows from the edge alone, the triangles are those of a single front.
//
// Strips depend on the points alone. So the mesh has its triangles in the same order for any number of threads.

#ifndef SeismicHorizonsPatchFront_h
#define SeismicHorizonsPatchFront_h

#include "AdvancingFront.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "SearchGrid.h"
#include "ThirdPointSearch.h"

#include <vector>

namespace SeismicHorizons
{
/// Points have the numbers of the search here, except where names are told.
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
    const RawVector<PointId>& triangles = this->Parts.back();
    return { triangles[triangles.size() - 3], triangles[triangles.size() - 2] };
  }

  /// Whether a side or a triangle has the point.
  bool IsUsed(PointId point) const { return this->Used[std::size_t(point)] != 0; }
  void Use(PointId point) { this->Used[std::size_t(point)] = 1; }

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
  std::vector<PointId> StripStarts; // the first point of each strip, and at last the number of points
  std::vector<FrontEdge> Sides;
  std::vector<unsigned char> Used; // bytes, as several threads write them
  std::vector<RawVector<PointId>> Parts; // triangles, of the walls and strips in the order in which they are made
};
}

#endif
