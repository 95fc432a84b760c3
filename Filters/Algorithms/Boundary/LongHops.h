// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The hops that lead further than to a neighbour, upwards, with what can be in the way of each: tables that do not
// depend on the points.

#ifndef SeismicHorizonsLongHops_h
#define SeismicHorizonsLongHops_h

#include "HopVectors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// From a column to a neighbour: with the opposite ones these are the eight.
constexpr std::array<PlanePoint, 4> NeighbourSteps = { { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 } } };

/// Two neighbouring columns on either side of a hop, seen from its start.
struct Gate
{
  PlanePoint Column;
  std::size_t Step; // to the other one, in NeighbourSteps
  std::int64_t Offset; // of the column, in places of the raster
  std::int64_t OtherOffset;
};

/// Columns are offsets from the start of the hop, in places of the raster.
struct LongHop
{
  HopId Hop = NoHop;
  std::vector<std::int64_t> Over; // columns it passes over
  std::vector<PlanePoint> ColumnsOver; // the same, seen from its start
  std::vector<Gate> Gates; // columns it passes between, those near its ends first
  std::vector<std::int64_t> Between; // columns nearer to both of its ends than they are to each other
  std::vector<std::int64_t> Squares; // unit squares it touches other than with its ends, by their least corners
};

class LongHops
{
public:
  explicit LongHops(const HopVectors& hops);

  /// Hops are numbered by their Euclidean length, equal ones in the order of a sweep.
  std::size_t Size() const { return this->Hops.size(); }
  const LongHop& operator[](std::size_t number) const { return this->Hops[number]; }

  /// The number of a vector that leads upwards, or level to the right, further than to a neighbour.
  std::size_t NumberOf(const PlanePoint& vector) const { return this->Numbers[this->Slot(vector)]; }

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
