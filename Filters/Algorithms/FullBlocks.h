// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a lattice is full there is nothing to search. An edge between neighbouring columns is in every constrained
// Delaunay triangulation, as the circle around it holds no other column. So what such edges enclose is meshed on its
// own, as long as it is inside the boundary and no boundary edge cuts it:
//  - a full block, two by two points: two triangles. Which diagonal cuts it is settled by Predicates.h.
//  - a ring, three by three points without the middle one, which is what a single dropout leaves: four triangles at its
//    corners, and two in the square between the middles of its sides.
//
//     *---*---*
//     |  / \  |
//     | / : \ |        ring: the diagonal of the inner square is settled by Predicates.h, too
//     *   :   *
//     | \ : / |
//     |  \ /  |
//     *---*---*

#ifndef SeismicHorizonsFullBlocks_h
#define SeismicHorizonsFullBlocks_h

#include "Types.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
class FullBlocks
{
public:
  /// None at all.
  FullBlocks() = default;

  /// `points` have coordinates from 0, `boundary` runs over them with the surface to the right of its hops. When the
  /// points are so few in their bounding box that there can not be many full blocks, or when two of them are in one
  /// place, none is found.
  FullBlocks(const std::vector<PlanePoint>& points, const Loops& boundary);

  std::size_t NumberOfTriangles() const { return this->Triangles; }

  /// Whether no triangle but those of full blocks and rings can have the point as a corner: all that is around it is
  /// meshed.
  bool Covers(const PlanePoint& point) const
  {
    return this->IsMeshed(point.X, point.Y) && this->IsMeshed(point.X - 1, point.Y) &&
      this->IsMeshed(point.X - 1, point.Y - 1) && this->IsMeshed(point.X, point.Y - 1);
  }

  /// Whether some of what is around the point is meshed.
  bool Touches(const PlanePoint& point) const
  {
    return this->IsMeshed(point.X, point.Y) || this->IsMeshed(point.X - 1, point.Y) ||
      this->IsMeshed(point.X - 1, point.Y - 1) || this->IsMeshed(point.X, point.Y - 1);
  }

  /// Calls triangle(a, b, c) for the triangles of all full blocks and rings, counter-clockwise, row by row, and
  /// side(from, to) for each of their sides that has none of them beyond it, with its block to the left.
  template <typename Triangle, typename Side>
  void Visit(Triangle&& triangle, Side&& side) const
  {
    for (std::int64_t y = 0; y + 1 < this->Height; ++y)
    {
      for (std::int64_t x = 0; x + 1 < this->Width; ++x)
      {
        const unsigned char block = this->Blocks[this->Place(x, y)];
        if ((block & Meshed) == 0)
        {
          continue;
        }
        if (block & Full)
        {
          this->VisitBlock(x, y, triangle);
        }
        else if (this->At(x + 1, y + 1) == NoPoint)
        {
          this->VisitRing(x, y, triangle);
        }
        this->VisitSides(x, y, side);
      }
    }
  }

private:
  bool PlacePoints(const std::vector<PlanePoint>& points);
  void MarkCutBlocks(const std::vector<PlanePoint>& points, const Loops& boundary);
  void MarkTurns(const std::vector<PlanePoint>& points, const Loops& boundary);
  void MarkOpen();
  void FindFull();
  void FindRings();
  bool IsRing(std::int64_t x, std::int64_t y) const;

  std::size_t Place(std::int64_t x, std::int64_t y) const { return std::size_t(y * this->Width + x); }
  PointId At(std::int64_t x, std::int64_t y) const { return this->Points[this->Place(x, y)]; }

  bool IsMeshed(std::int64_t x, std::int64_t y) const
  {
    return x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height &&
      (this->Blocks[this->Place(x, y)] & Meshed) != 0;
  }

  template <typename Triangle>
  void VisitBlock(std::int64_t x, std::int64_t y, Triangle&& triangle) const
  {
    const std::array<PointId, 4> corner = { this->At(x, y), this->At(x + 1, y), this->At(x + 1, y + 1),
      this->At(x, y + 1) };
    const std::size_t first = this->BlockDiagonal;
    triangle(corner[first], corner[first + 1], corner[first + 2]);
    triangle(corner[first], corner[first + 2], corner[(first + 3) % 4]);
  }

  /// The ring whose least corner is (x, y).
  template <typename Triangle>
  void VisitRing(std::int64_t x, std::int64_t y, Triangle&& triangle) const
  {
    const std::array<PointId, 4> corner = { this->At(x, y), this->At(x + 2, y), this->At(x + 2, y + 2),
      this->At(x, y + 2) };
    // The middles of the sides that follow the corners.
    const std::array<PointId, 4> middle = { this->At(x + 1, y), this->At(x + 2, y + 1), this->At(x + 1, y + 2),
      this->At(x, y + 1) };
    for (std::size_t n = 0; n < 4; ++n)
    {
      triangle(corner[n], middle[n], middle[(n + 3) % 4]);
    }
    const std::size_t first = this->RingDiagonal;
    triangle(middle[first], middle[first + 1], middle[first + 2]);
    triangle(middle[first], middle[first + 2], middle[(first + 3) % 4]);
  }

  /// Where a block of a ring has its missing corner, its neighbours are meshed as well, so that no side ends there.
  template <typename Side>
  void VisitSides(std::int64_t x, std::int64_t y, Side&& side) const
  {
    if (!this->IsMeshed(x, y - 1))
    {
      side(this->At(x, y), this->At(x + 1, y));
    }
    if (!this->IsMeshed(x + 1, y))
    {
      side(this->At(x + 1, y), this->At(x + 1, y + 1));
    }
    if (!this->IsMeshed(x, y + 1))
    {
      side(this->At(x + 1, y + 1), this->At(x, y + 1));
    }
    if (!this->IsMeshed(x - 1, y))
    {
      side(this->At(x, y + 1), this->At(x, y));
    }
  }

  enum Block : unsigned char
  {
    Nothing = 0,
    Turn = 1, // between this block and the one to its left the inside begins or ends
    Cut = 2, // a boundary edge runs through it, or close by
    Open = 4, // inside, and not cut
    Full = 8,
    Ring = 16, // a quarter of a ring
    Meshed = Full | Ring
  };

  std::size_t Triangles = 0;
  std::int64_t Width = 0;
  std::int64_t Height = 0;
  std::vector<PointId> Points; // by column
  std::vector<unsigned char> Blocks; // by the column of the lower left corner
  // Which diagonal cuts a square: that between its first and third corner (0) or between the others (1).
  std::size_t BlockDiagonal = 0;
  std::size_t RingDiagonal = 0;
};
}

#endif
