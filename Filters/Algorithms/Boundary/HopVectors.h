// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The vectors of hops, the steps that a boundary may take, from a column to any other one at most k columns away along
// each axis (the thesis's k-square neighbourhood, Def. 3.1). Hops are numbered in the order in which a clockwise sweep
// from the south meets their ends; of several in one direction the shorter comes first.
//
//          3  4  5
//          2  *  6         the 8 hops of k = 1
//          1  0  7

#ifndef SeismicHorizonsHopVectors_h
#define SeismicHorizonsHopVectors_h

#include "Common/PlaneGeometry.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The number of a hop in HopVectors.
using HopId = std::int32_t;

constexpr HopId NoHop = -1;

class HopVectors
{
public:
  /// All hops of at most `radius` columns along each axis, for a raster with rows of `rasterWidth` places.
  HopVectors(int radius, std::int64_t rasterWidth);

  int Radius() const { return this->MostColumns; }
  HopId Size() const { return HopId(this->Vectors.size()); }

  /// From the start of a hop to its end, in columns.
  const PlanePoint& Vector(HopId hop) const { return this->Vectors[std::size_t(hop)]; }
  /// The same as a difference of places in the raster.
  std::int64_t Offset(HopId hop) const { return this->Offsets[std::size_t(hop)]; }
  std::int64_t OffsetOf(const PlanePoint& vector) const { return vector.Y * this->RasterWidth + vector.X; }
  /// The hop back.
  HopId Opposite(HopId hop) const { return this->Opposites[std::size_t(hop)]; }
  /// Into how many parts a hop is divided by the columns whose middles it passes through.
  std::int32_t NumberOfParts(HopId hop) const { return this->NumbersOfParts[std::size_t(hop)]; }
  /// The hop with a vector.
  HopId Find(const PlanePoint& vector) const { return this->Hops[this->Slot(vector)]; }

private:
  /// The position of a vector in the square of all of them, row by row.
  std::size_t Slot(const PlanePoint& vector) const
  {
    return std::size_t((vector.Y + this->MostColumns) * (2 * this->MostColumns + 1) + vector.X + this->MostColumns);
  }

  const int MostColumns;
  const std::int64_t RasterWidth;
  std::vector<PlanePoint> Vectors;
  std::vector<std::int64_t> Offsets;
  std::vector<HopId> Opposites;
  std::vector<std::int32_t> NumbersOfParts;
  std::vector<HopId> Hops; // by slot
};

/// Whether a clockwise sweep from the south meets the end of vector `a` before that of `b`.
bool IsSweptBefore(const PlanePoint& a, const PlanePoint& b);

/// Columns along the longer axis.
std::int32_t ChebyshevLength(const PlanePoint& vector);

/// Whether the end of a vector is nearer than that of another: fewer columns along the longer axis, or as many and
/// shorter in a straight line. This is the order of a norm whose circles have no straight stretches (the larger
/// coordinate, plus an infinitely small part of the Euclidean length).
bool IsNearer(const PlanePoint& a, const PlanePoint& b);
}

#endif
