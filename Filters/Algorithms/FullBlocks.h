// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a lattice is full there is nothing to search: two by two neighbouring points inside the boundary, which no
// boundary edge cuts, are two triangles of the constrained Delaunay triangulation. The circle through the four holds
// no other lattice point, and which diagonal cuts them is settled by Predicates.h.

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
  /// `points` have coordinates from 0, `boundary` runs over them with the surface to the right of its hops. When the
  /// points are so few in their bounding box that there can not be many full blocks, none is found.
  FullBlocks(const std::vector<PlanePoint>& points, const Loops& boundary);

  /// Calls triangle(a, b, c) for the triangles of all full blocks, counter-clockwise, row by row, and side(from, to)
  /// for each side that has no full block beyond it, with its block to the left.
  template <typename Triangle, typename Side>
  void Visit(Triangle&& triangle, Side&& side) const
  {
    for (std::int64_t y = 0; y + 1 < this->Height; ++y)
    {
      for (std::int64_t x = 0; x + 1 < this->Width; ++x)
      {
        if (this->IsFull(x, y))
        {
          this->VisitBlock(x, y, triangle, side);
        }
      }
    }
  }

private:
  void MarkCutBlocks(const std::vector<PlanePoint>& points, const Loops& boundary);
  void MarkInside(const std::vector<PlanePoint>& points, const Loops& boundary);
  void FindFull();

  std::size_t Place(std::int64_t x, std::int64_t y) const { return std::size_t(y * this->Width + x); }

  bool IsFull(std::int64_t x, std::int64_t y) const
  {
    return x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height && this->Blocks[this->Place(x, y)] == Full;
  }

  template <typename Triangle, typename Side>
  void VisitBlock(std::int64_t x, std::int64_t y, Triangle&& triangle, Side&& side) const
  {
    // Counter-clockwise from the lower left, so that the first and the third are the ends of the rising diagonal.
    const std::array<PointId, 4> corner = { this->Points[this->Place(x, y)], this->Points[this->Place(x + 1, y)],
      this->Points[this->Place(x + 1, y + 1)], this->Points[this->Place(x, y + 1)] };
    const std::size_t first = this->Rising ? 0 : 1;
    triangle(corner[first], corner[first + 1], corner[first + 2]);
    triangle(corner[first], corner[first + 2], corner[(first + 3) % 4]);
    const std::array<bool, 4> beyond = { this->IsFull(x, y - 1), this->IsFull(x + 1, y), this->IsFull(x, y + 1),
      this->IsFull(x - 1, y) };
    for (std::size_t n = 0; n < 4; ++n)
    {
      if (!beyond[n])
      {
        side(corner[n], corner[(n + 1) % 4]);
      }
    }
  }

  enum Block : unsigned char
  {
    Nothing = 0,
    Turn = 1, // between this block and the one to its left the inside begins or ends
    Cut = 2, // a boundary edge runs through it, or close by
    Full = 4
  };

  std::int64_t Width = 0;
  std::int64_t Height = 0;
  std::vector<PointId> Points; // by column
  std::vector<unsigned char> Blocks; // by the column of the lower left corner
  const bool Rising; // which diagonal cuts a block
};
}

#endif
