// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The hops that lead further than to a neighbour, and upwards or straight to the right, with the columns that matter
// for each: tables that do not depend on the points.

#ifndef SeismicHorizonsLongHops_h
#define SeismicHorizonsLongHops_h

#include "HopVectors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// From a column to four of its neighbours; the opposite steps lead to the other four.
constexpr std::array<PlanePoint, 4> NeighbourSteps = { { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 } } };

/// Two neighbouring columns that a hop passes between. Columns are vectors from the start of the hop, and offsets are
/// differences of places in the raster from there.
struct Gate
{
  PlanePoint Column;
  std::size_t Step; // from this column to the other one, in NeighbourSteps
  std::int64_t Offset; // of this column
  std::int64_t OtherOffset; // of the other one
};

/// Columns by their offsets, as in Gate.
struct LongHop
{
  HopId Hop = NoHop;
  std::vector<std::int64_t> Over; // columns that the hop passes over
  std::vector<PlanePoint> ColumnsOver; // the same as vectors
  std::vector<Gate> Gates; // pairs of columns that it passes between, those near its ends first
  std::vector<std::int64_t> Between; // columns nearer to both of its ends than these are to each other
  std::vector<std::int64_t> Squares; // unit squares it touches other than with its ends, by their least corners
};

class LongHops
{
public:
  explicit LongHops(const HopVectors& hops);

  /// Hops are numbered by their Euclidean length, equal ones in the order of a sweep.
  std::size_t Size() const { return this->Hops.size(); }
  const LongHop& operator[](std::size_t number) const { return this->Hops[number]; }

  /// The number of the hop with a vector for which IsLongAndRising is true.
  std::size_t NumberOf(const PlanePoint& vector) const { return this->Numbers[this->Slot(vector)]; }

  /// Whether a vector leads further than to a neighbour, and upwards or straight to the right.
  static bool IsLongAndRising(const PlanePoint& vector)
  {
    return ChebyshevLength(vector) > 1 && (vector.Y > 0 || (vector.Y == 0 && vector.X > 0));
  }

private:
  std::size_t Slot(const PlanePoint& vector) const
  {
    return std::size_t(vector.Y * (2 * this->Radius + 1) + vector.X + this->Radius);
  }

  const std::int32_t Radius;
  std::vector<LongHop> Hops;
  std::vector<std::size_t> Numbers; // by slot
};
}

#endif
