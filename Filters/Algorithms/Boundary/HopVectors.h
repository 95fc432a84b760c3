// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The hops a boundary may take: from a column to any other one at most k columns away along each axis (the thesis's
// k-square neighbourhood, Def. 3.1). They are numbered clockwise by their direction, from the south; of those in one
// direction the nearer comes first.
//
//          3  4  5
//          2  *  6         the 8 hops of k = 1
//          1  0  7

#ifndef SeismicHorizonsHopVectors_h
#define SeismicHorizonsHopVectors_h

#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The number of a hop in its table.
using HopId = std::int32_t;

constexpr HopId NoHop = -1;

class HopVectors
{
public:
  /// `rowLength` is the distance of two rows in the raster the hops are made on.
  HopVectors(int radius, std::int64_t rowLength);

  int Radius() const { return this->K; }
  HopId Size() const { return HopId(this->Vectors.size()); }

  /// The way a hop goes, in columns.
  const PlanePoint& Vector(HopId hop) const { return this->Vectors[std::size_t(hop)]; }
  /// The same in places of the raster.
  std::int64_t Offset(HopId hop) const { return this->Offsets[std::size_t(hop)]; }
  std::int64_t OffsetOf(const PlanePoint& vector) const { return vector.Y * this->RowLength + vector.X; }
  HopId Opposite(HopId hop) const { return this->Opposites[std::size_t(hop)]; }
  /// Into how many parts the columns it passes right over cut a hop.
  std::int32_t Parts(HopId hop) const { return this->NumbersOfParts[std::size_t(hop)]; }
  /// The hop along a vector that is not longer than the radius.
  HopId Find(const PlanePoint& vector) const { return this->Numbers[this->Slot(vector)]; }

private:
  std::size_t Slot(const PlanePoint& vector) const
  {
    return std::size_t((vector.Y + this->K) * (2 * this->K + 1) + vector.X + this->K);
  }

  const int K;
  const std::int64_t RowLength;
  std::vector<PlanePoint> Vectors;
  std::vector<std::int64_t> Offsets;
  std::vector<HopId> Opposites;
  std::vector<std::int32_t> NumbersOfParts;
  std::vector<HopId> Numbers; // by slot
};

/// Of two hops from a place in one direction or another: true when a clockwise sweep from the south meets `a` first.
bool SweepsBefore(const PlanePoint& a, const PlanePoint& b);

inline std::int64_t SquaredLength(const PlanePoint& vector)
{
  return std::int64_t(vector.X) * vector.X + std::int64_t(vector.Y) * vector.Y;
}

/// Columns along the longer axis.
std::int32_t ChebyshevLength(const PlanePoint& vector);

/// True when a hop is nearer than another: fewer columns along the longer axis, or as many and shorter in a straight
/// line. This is the order of a norm whose circles have no straight stretches (the larger coordinate, plus an
/// infinitely small part of the Euclidean length).
bool IsNearer(const PlanePoint& a, const PlanePoint& b);
}

#endif
