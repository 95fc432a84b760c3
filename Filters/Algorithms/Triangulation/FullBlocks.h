// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles that need no search, where the lattice is full. An edge between neighbouring columns is in every
// constrained Delaunay triangulation, as the circle around it holds no other column. So what such edges enclose is
// meshed on its own, as long as it is inside the boundary and no boundary edge cuts it:
//  - a full block, two by two points: two triangles. InCircle in Predicates.h says which diagonal cuts it.
//  - a ring, three by three points without the middle one, which is what a single missing point leaves: four triangles
//    at its corners, and two in the square between the middles of its sides, whose diagonal InCircle settles, too.
//
//     *---*        *---*---*
//     | / |        |  / \  |
//     *---*        | / : \ |
//                  *   :   *
//     a block      | \ : / |      a ring
//                  |  \ /  |
//                  *---*---*

#ifndef SeismicHorizonsFullBlocks_h
#define SeismicHorizonsFullBlocks_h

#include "Common/BoundedHorizon.h"
#include "Common/PlaneFrame.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
class FullBlocks
{
public:
  /// Has no blocks.
  FullBlocks() = default;

  /// Finds those of all patches of a horizon; `frame` is that of its points. When the points are so few in their
  /// bounding box that there can not be many full blocks, or when two of them are in one place, none is found.
  FullBlocks(const BoundedHorizon& horizon, const PlaneFrame& frame);

  std::size_t NumberOfTriangles() const { return this->RowStarts.empty() ? 0 : this->RowStarts.back(); }

  /// The points of the horizon that the search still has to know: those that blocks and rings do not cover, which is
  /// to surround them on all sides, and those of the boundary.
  std::vector<PointId> FindLoosePoints(const BoundedHorizon& horizon) const;

  /// The triangles of all full blocks and rings, counter-clockwise, row by row: three points each.
  void WriteTriangles(PointId* corners) const;

  /// Calls visit(from, to) for each side of a full block or ring that has no other one on its other side, with the
  /// block to the left. All of them begin and end in `loose` points, which are those of FindLoosePoints.
  template <typename Visitor>
  void ForEachSide(const BoundedHorizon& horizon, const std::vector<PointId>& loose, Visitor&& visit) const
  {
    for (std::size_t n = 0; this->NumberOfTriangles() > 0 && n < loose.size(); ++n)
    {
      const PlanePoint column = this->Frame.Inward(horizon.Plane[std::size_t(loose[n])]);
      this->VisitSides(column.X, column.Y, [&](PointId to) { visit(loose[n], to); });
    }
  }

private:
  bool PlacePoints(const std::vector<PlanePoint>& points);
  void MarkCutBlocks(const BoundedHorizon& horizon);
  void MarkTurns(const BoundedHorizon& horizon);
  std::size_t FindFull(std::int64_t y, const std::int32_t* patches);
  std::size_t FindRings(std::int64_t y, const std::int32_t* patches);
  bool IsRing(std::int64_t x, std::int64_t y, const std::int32_t* patches) const;
  std::vector<PointId> FindUncovered() const;
  std::vector<PointId> FindCoveredBoundary(const BoundedHorizon& horizon) const;

  /// Calls work(y) for each row of blocks, on several threads.
  template <typename Work>
  void ForEachRow(Work&& work) const;

  /// Whether all four blocks around a column are meshed.
  bool Covers(std::int64_t x, std::int64_t y) const
  {
    return this->IsMeshed(x, y) && this->IsMeshed(x - 1, y) && this->IsMeshed(x - 1, y - 1) && this->IsMeshed(x, y - 1);
  }

  std::size_t Place(std::int64_t x, std::int64_t y) const { return std::size_t(y * this->Width + x); }
  PointId At(std::int64_t x, std::int64_t y) const { return this->Points[this->Place(x, y)]; }

  bool IsMeshed(std::int64_t x, std::int64_t y) const
  {
    return x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height &&
      (this->Blocks[this->Place(x, y)] & Meshed) != 0;
  }

  /// Whether a ring has its least corner here.
  bool BeginsRing(std::int64_t x, std::int64_t y) const
  {
    return (this->Blocks[this->Place(x, y)] & Ring) != 0 && this->At(x + 1, y + 1) == NoPoint;
  }

  void WriteRow(std::int64_t y, PointId* corners) const;
  PointId* WriteBlock(std::int64_t x, std::int64_t y, PointId* corners) const;
  PointId* WriteRing(std::int64_t x, std::int64_t y, PointId* corners) const;

  /// Calls visit(to) for the sides that begin in a point, with their other ends.
  template <typename Visitor>
  void VisitSides(std::int64_t x, std::int64_t y, Visitor&& visit) const
  {
    const bool right = this->IsMeshed(x, y);
    const bool left = this->IsMeshed(x - 1, y);
    const bool leftBelow = this->IsMeshed(x - 1, y - 1);
    const bool rightBelow = this->IsMeshed(x, y - 1);
    if (right && !rightBelow)
    {
      visit(this->At(x + 1, y));
    }
    if (left && !right)
    {
      visit(this->At(x, y + 1));
    }
    if (leftBelow && !left)
    {
      visit(this->At(x - 1, y));
    }
    if (rightBelow && !leftBelow)
    {
      visit(this->At(x, y - 1));
    }
  }

  enum Block : unsigned char
  {
    Nothing = 0,
    Turn = 1, // the inside of the boundary begins or ends between this block and the one to its left
    Cut = 2, // a boundary edge runs through the block, or close by
    Open = 4, // the block is inside the boundary, and not cut
    Full = 8, // a full block
    Ring = 16, // a quarter of a ring
    Meshed = Full | Ring
  };

  PlaneFrame Frame;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  RawVector<PointId> Points; // by column
  std::vector<unsigned char> Blocks; // by the column of the least corner
  std::vector<std::size_t> RowStarts; // for each row how many triangles the rows before it have
  // Which diagonal cuts a square: that between its first and third corner (0) or between the others (1).
  std::size_t BlockDiagonal = 0;
  std::size_t RingDiagonal = 0;
};
}

#endif
