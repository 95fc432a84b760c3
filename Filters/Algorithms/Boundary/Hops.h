// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hops are the steps of a boundary, from a column to another one at most k columns away along each axis (k-square
// neighbourhood of the thesis, Def. 3.1), numbered in the order of a clockwise sweep from the south; of several in one
// direction the shorter comes first.
//
//          3  4  5
//          2  *  6         the 8 hops of k = 1
//          1  0  7

#ifndef SeismicHorizonsHops_h
#define SeismicHorizonsHops_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
using HopId = std::int32_t;

constexpr HopId NoHop = -1;

class HopVectors
{
public:
  /// An offset is a difference of places in an index with rows of `rasterWidth` places.
  HopVectors(int radius, std::int64_t rasterWidth);

  int Radius() const { return this->MostColumns; }
  HopId Size() const { return HopId(this->Vectors.size()); }

  const PlanePoint& Vector(HopId hop) const { return this->Vectors[hop]; }
  std::int64_t Offset(HopId hop) const { return this->Offsets[hop]; }
  std::int64_t OffsetOf(const PlanePoint& vector) const { return vector.Y * this->RasterWidth + vector.X; }
  HopId Opposite(HopId hop) const { return this->Opposites[hop]; }
  /// The columns whose centres a hop passes divide it into this number of parts.
  std::int32_t NumberOfParts(HopId hop) const { return this->NumbersOfParts[hop]; }
  HopId Find(const PlanePoint& vector) const { return this->Hops[this->Slot(vector)]; }
  /// Returns 1 for the next hop of a clockwise sweep, up to Size() for `from` itself.
  HopId Turn(HopId from, HopId to) const { return to > from ? to - from : to - from + this->Size(); }
  /// Returns the eight hops to neighbours, in the order of a sweep.
  const std::vector<HopId>& ToNeighbours() const { return this->Short; }

private:
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
  std::vector<HopId> Short;
};

bool IsSweptBefore(const PlanePoint& a, const PlanePoint& b);

std::int32_t ChebyshevLength(const PlanePoint& vector);

/// Compares columns along the longer axis, then Euclidean length: the order of a strictly convex norm (the larger
/// coordinate plus an infinitesimal fraction of the Euclidean length).
bool IsNearer(const PlanePoint& a, const PlanePoint& b);

// Long hops lead further than to a neighbour, and upwards or straight to the right.

constexpr std::array<PlanePoint, 4> NeighbourSteps = { { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 } } };

/// A hop passes between these two neighbouring columns; vectors and offsets are from the start of the hop.
struct Gate
{
  PlanePoint Column;
  std::size_t Step; // to the other column, in NeighbourSteps
  std::int64_t Offset;
  std::int64_t OtherOffset;
};

struct LongHop
{
  HopId Hop = NoHop;
  std::vector<std::int64_t> Over; // offsets of columns passed over
  std::vector<PlanePoint> ColumnsOver;
  std::vector<Gate> Gates; // near the ends first
  std::vector<std::int64_t> Between; // These columns are nearer to both ends than the ends are to each other.
  std::vector<std::int64_t> Squares; // The hop touches these unit squares other than with its ends.
};

class LongHops
{
public:
  explicit LongHops(const HopVectors& hops);

  /// Hops are numbered by Euclidean length, then in the order of a sweep.
  std::size_t Size() const { return this->Hops.size(); }
  const LongHop& operator[](std::size_t number) const { return this->Hops[number]; }

  /// IsLongAndRising(vector) must hold.
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

// A walk sweeps clockwise at each point from the hop it came by, which comes last, and leaves by the first hop of the
// plane graph. Its face is on the left: the outer face is walked clockwise, a hole counter-clockwise.

/// The hop is NoHop at an isolated point.
struct FaceStep
{
  PointId Point;
  HopId Hop;
};

/// The walk ends before it repeats `first`; `next` sweeps clockwise.
template <typename Next>
void WalkFace(const ColumnIndex& index, const HopVectors& hops, std::int64_t start, HopId first, Next&& next,
  std::vector<FaceStep>& steps)
{
  steps.clear();
  std::int64_t place = start;
  HopId hop = first;
  do
  {
    steps.push_back({ index[place], hop });
    if (hop != NoHop)
    {
      place += hops.Offset(hop);
      hop = next(place, hops.Opposite(hop));
    }
  } while (place != start || hop != first);
}

struct FaceSize
{
  std::int64_t TwiceArea = 0; // negative for a face walked clockwise
  std::int64_t OnLoop = 0; // Each passage of the walk through the centre of a column counts.
};

inline FaceSize MeasureFace(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  FaceSize size;
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (const FaceStep& step : steps)
  {
    if (step.Hop == NoHop)
    {
      return size;
    }
    const PlanePoint& vector = hops.Vector(step.Hop);
    size.TwiceArea += x * vector.Y - y * vector.X;
    size.OnLoop += hops.NumberOfParts(step.Hop);
    x += vector.X;
    y += vector.Y;
  }
  return size;
}

/// Pick's theorem gives the columns strictly inside, 0 for a face walked clockwise or without area. A column visited
/// twice counts as two columns of the loop.
inline std::int64_t ColumnsInside(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  const FaceSize size = MeasureFace(hops, steps);
  return size.TwiceArea > 0 ? (size.TwiceArea - size.OnLoop) / 2 + 1 : 0;
}

/// The loop begins at its point of least x, then y, and there with the hop that comes first in a sweep from the south.
inline void AppendLoop(const HopVectors& hops, std::vector<FaceStep>& steps, Loops& loops)
{
  // Columns are relative to the first step.
  PlanePoint column;
  PlanePoint least;
  std::size_t first = 0;
  for (std::size_t n = 0; n < steps.size(); ++n)
  {
    const HopId hop = steps[n].Hop;
    if (column < least || (column == least && hop < steps[first].Hop))
    {
      least = column;
      first = n;
    }
    const PlanePoint vector = hop == NoHop ? PlanePoint{} : hops.Vector(hop);
    column = { column.X + vector.X, column.Y + vector.Y };
  }
  std::rotate(steps.begin(), steps.begin() + std::ptrdiff_t(first), steps.end());
  for (const FaceStep& step : steps)
  {
    loops.Append(step.Point);
  }
  loops.Close();
}
}

#endif
