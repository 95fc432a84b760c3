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
//
// With them the tables of what long hops pass over and between, and the walk around a face of a graph of hops.

#ifndef SeismicHorizonsHops_h
#define SeismicHorizonsHops_h

#include "Common/ColumnIndex.h"
#include "Common/PlaneGeometry.h"
#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The number of a hop in HopVectors.
using HopId = std::int32_t;

constexpr HopId NoHop = -1;

class HopVectors
{
public:
  /// All hops of at most `radius` columns along each axis, for a index with rows of `rasterWidth` places.
  HopVectors(int radius, std::int64_t rasterWidth);

  int Radius() const { return this->MostColumns; }
  HopId Size() const { return HopId(this->Vectors.size()); }

  /// From the start of a hop to its end, in columns.
  const PlanePoint& Vector(HopId hop) const { return this->Vectors[hop]; }
  /// The same as a difference of places in the index.
  std::int64_t Offset(HopId hop) const { return this->Offsets[hop]; }
  std::int64_t OffsetOf(const PlanePoint& vector) const { return vector.Y * this->RasterWidth + vector.X; }
  /// The hop back.
  HopId Opposite(HopId hop) const { return this->Opposites[hop]; }
  /// Into how many parts a hop is divided by the columns whose middles it passes through.
  std::int32_t NumberOfParts(HopId hop) const { return this->NumbersOfParts[hop]; }
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

// The hops that lead further than to a neighbour, and upwards or straight to the right, with the columns that matter
// for each: tables that do not depend on the points.

/// From a column to four of its neighbours; the opposite steps lead to the other four.
constexpr std::array<PlanePoint, 4> NeighbourSteps = { { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 } } };

/// Two neighbouring columns that a hop passes between. Columns are vectors from the start of the hop, and offsets are
/// differences of places in the index from there.
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

// The walk around one face of a plane graph that connects points of a horizon by hops. At every point the walk sweeps
// clockwise over the hops of the graph, beginning after the one back to where it came from, and leaves by the first
// that the sweep meets; the hop back comes last. So the face lies to the left of all hops of the walk: the outer face
// is walked clockwise around the patch, and the face of a hole counter-clockwise, with the surface to the right in
// either case.

/// A point of a walk, and the hop by which the walk leaves it: NoHop for a point alone. In the gap of a seam there is
/// no point (SeamGaps.h).
struct FaceStep
{
  PointId Point;
  HopId Hop;
};

/// Walks from the place `start` by the hop `first` until it is about to repeat that hop. `next(place, from)` gives the
/// first hop of the graph from a place that a clockwise sweep after `from` meets, or NoHop.
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
  std::int64_t TwiceArea = 0; // less than 0 for a face that is walked clockwise
  std::int64_t OnLoop = 0; // columns that the walk passes through the middles of, each as often as it does
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

/// How many columns lie strictly inside a face that is walked counter-clockwise, by Pick's theorem; 0 for one that is
/// walked clockwise, or has no area. A column that the walk visits twice counts twice, as if the loop had two there.
inline std::int64_t ColumnsInside(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  const FaceSize size = MeasureFace(hops, steps);
  return size.TwiceArea > 0 ? (size.TwiceArea - size.OnLoop) / 2 + 1 : 0;
}

/// Leaves out the steps in gaps of seams. The columns inside are counted before.
inline void DropStepsInGaps(std::vector<FaceStep>& steps)
{
  steps.erase(std::remove_if(steps.begin(), steps.end(), [](const FaceStep& step) { return step.Point == NoPoint; }),
    steps.end());
}

/// Adds a walk as a loop that begins at its point of least x, then least y. When the walk visits that point several
/// times, the loop begins with the hop from there that a clockwise sweep from the south meets first. No step is in a
/// gap.
inline void AppendLoop(PlanePoints columns, std::vector<FaceStep>& steps, Loops& loops)
{
  const auto first = std::min_element(steps.begin(), steps.end(),
    [&columns](const FaceStep& a, const FaceStep& b)
    {
      const PlanePoint& columnA = columns[a.Point];
      const PlanePoint& columnB = columns[b.Point];
      return columnA == columnB ? a.Hop < b.Hop : columnA < columnB;
    });
  std::rotate(steps.begin(), first, steps.end());
  for (const FaceStep& step : steps)
  {
    loops.Append(step.Point);
  }
  loops.Close();
}
}

#endif
