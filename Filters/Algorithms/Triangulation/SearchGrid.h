// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points and boundary edges for a search, in a grid of square search cells with about one point each, and in a pyramid
// of boxes for distant points.

#ifndef SeismicHorizonsSearchGrid_h
#define SeismicHorizonsSearchGrid_h

#include "Common/Base/CountingSort.h"
#include "Common/Horizon/CellGrid.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Reduces coordinates to the smallest integers: relative to the least, and divided by the largest common power of two.
/// Predicates do not depend on origin and unit.
struct PlaneFrame
{
  PlaneFrame() = default;
  explicit PlaneFrame(const std::vector<PlanePoint>& places);

  PlanePoint Inward(const PlanePoint& place) const
  {
    return { (place.X - this->Least.X) >> this->Shift, (place.Y - this->Least.Y) >> this->Shift };
  }
  PlanePoint Outward(const PlanePoint& place) const
  {
    return { (place.X << this->Shift) + this->Least.X, (place.Y << this->Shift) + this->Least.Y };
  }

  PlanePoint Least;
  PlanePoint Greatest;
  int Shift = 0; // exponent of the power of two
};

/// Points are renumbered by cell, row by row, so that points in a row of cells have successive numbers.
class SearchGrid
{
public:
  /// Coordinates must be from 0 to below 2^29. Throws InputError for equal places, points on boundary edges, and
  /// crossing boundary edges; messages use `names`.
  SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names);

  PointId NumberOf(PointId point) const { return this->Sorted.Numbers[point]; }
  PointId NameOf(PointId number) const { return this->Sorted.Names[number]; }

  PointId NumberOfPoints() const { return PointId(this->Sorted.Names.size()); }

  const PlanePoint& At(PointId number) const { return this->Sorted.Places[number]; }

  /// At() may read this many places after the last point.
  static constexpr PointId Padding = 4;

  const CellGrid& Cells() const { return this->Grid; }

  PointId FirstIn(std::int64_t cell) const { return this->Sorted.Cells.First(cell); }
  PointId EndOf(std::int64_t cell) const { return this->Sorted.Cells.End(cell); }

  const PointId* CellStarts() const { return this->Sorted.Cells.Firsts(); }

  /// Coordinates outside the grid give the nearest cell. Bit shifts are faster than CellX() and CellY() of the grid.
  std::int64_t CellX(std::int32_t x) const { return std::clamp((x - this->Origin.X) >> this->Shift, 0, this->Last.X); }
  std::int64_t CellY(std::int32_t y) const { return std::clamp((y - this->Origin.Y) >> this->Shift, 0, this->Last.Y); }

  /// This is the side of a square with the mean area per point.
  double Spacing() const { return this->PointSpacing; }

  const EdgeLists& Edges() const { return this->EdgesInCell; }

  /// Counts steps between cells, also diagonal, to the nearest cell with boundary edges, at most 255.
  std::int64_t EdgeDistance(std::int64_t x, std::int64_t y) const
  {
    return this->EdgeDistances[this->Grid.Index(x, y)];
  }

private:
  struct SortedPoints
  {
    SortedPoints(const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names);

    CountingSort<PointId> Cells;
    std::vector<PlanePoint> Places; // by new number, like Names
    std::vector<PointId> Names;
    std::vector<PointId> Numbers; // by previous number
  };

  bool AreFewAndApart(std::int64_t cell) const;
  void CheckPlaces(std::int64_t cell) const;
  void CheckEdges(std::int64_t cell) const;
  void CheckEdge(const Edge* edge, std::int64_t cell) const;
  std::string Describe(const Edge& edge) const;
  void MeasureEdgeDistances();

  const double PointSpacing;
  const CellGrid Grid;
  const int Shift; // binary logarithm of the cell size
  const PlanePoint Origin;
  const PlanePoint Last; // column and row of cells
  const SortedPoints Sorted;
  const EdgeLists EdgesInCell;
  std::vector<unsigned char> EdgeDistances;
};

inline double SquaredDistanceToBox(const SegmentEnd& place, const PlaneBox& box)
{
  const double x = std::max({ box.Least.X - place.X, 0.0, place.X - box.Greatest.X });
  const double y = std::max({ box.Least.Y - place.Y, 0.0, place.Y - box.Greatest.Y });
  return x * x + y * y;
}

/// Bounding boxes of points in squares of search cells, which double in size per level. A search skips boxes that
/// cannot hold a better point. Memory is 16 bytes per 12 cells and per 7 points.
class PointPyramid
{
public:
  explicit PointPyramid(const SearchGrid& points);

  /// Calls visit(point) for points in boxes that pass mayHold(box), roughly by distance(box).
  template <typename MayHold, typename Distance, typename Visitor>
  void Visit(MayHold&& mayHold, Distance&& distance, Visitor&& visit) const
  {
    this->VisitSquare({ this->Levels.size() - 1, 0, 0 }, mayHold, distance, visit);
  }

private:
  static constexpr std::int64_t BaseSize = 4;
  static constexpr PointId RunSize = 8;
  static constexpr int RunShift = 3;

  struct Level
  {
    std::int64_t SizeX;
    std::int64_t SizeY;
    std::vector<PlaneBox> Boxes;
  };

  struct Square
  {
    std::size_t Level;
    std::int64_t X;
    std::int64_t Y;
  };

  const PlaneBox& BoxOf(const Square& square) const
  {
    const Level& level = this->Levels[square.Level];
    return level.Boxes[square.Y * level.SizeX + square.X];
  }

  void MakeRuns();
  void MakeLowest();
  void MakeNext();

  template <typename MayHold, typename Distance, typename Visitor>
  void VisitSquare(const Square& square, MayHold& mayHold, Distance& distance, Visitor& visit) const
  {
    const PlaneBox& box = this->BoxOf(square);
    if (box.IsEmpty() || !mayHold(box))
    {
      return;
    }
    if (square.Level == 0)
    {
      this->VisitCells(square, mayHold, visit);
      return;
    }
    const Level& below = this->Levels[square.Level - 1];
    std::array<std::pair<double, Square>, 4> parts;
    std::size_t count = 0;
    for (std::int64_t y = 2 * square.Y; y < std::min(2 * square.Y + 2, below.SizeY); ++y)
    {
      for (std::int64_t x = 2 * square.X; x < std::min(2 * square.X + 2, below.SizeX); ++x)
      {
        const Square part{ square.Level - 1, x, y };
        const double partDistance = distance(this->BoxOf(part));
        std::size_t n = count++;
        for (; n > 0 && parts[n - 1].first > partDistance; --n)
        {
          parts[n] = parts[n - 1];
        }
        parts[n] = { partDistance, part };
      }
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      this->VisitSquare(parts[n].second, mayHold, distance, visit);
    }
  }

  template <typename MayHold, typename Visitor>
  void VisitCells(const Square& square, MayHold& mayHold, Visitor& visit) const
  {
    const CellGrid& cells = this->Points.Cells();
    const std::int64_t left = BaseSize * square.X;
    const std::int64_t right = std::min(left + BaseSize, cells.SizeX()) - 1;
    for (std::int64_t y = BaseSize * square.Y; y < std::min(BaseSize * (square.Y + 1), cells.SizeY()); ++y)
    {
      const PointId first = this->Points.FirstIn(cells.Index(left, y));
      const PointId end = this->Points.EndOf(cells.Index(right, y));
      if (first < end)
      {
        const std::size_t level = this->LevelOfRuns(end - first);
        const PointId size = RunSize << (RunShift * level);
        for (PointId run = first / size; run * size < end; ++run)
        {
          this->VisitRun(level, run, first, end, mayHold, visit);
        }
      }
    }
  }

  std::size_t LevelOfRuns(PointId length) const
  {
    std::size_t level = 0;
    while (level + 1 < this->Runs.size() && (RunSize << (RunShift * (level + 1))) <= length)
    {
      ++level;
    }
    return level;
  }

  template <typename MayHold, typename Visitor>
  void VisitRun(std::size_t level, PointId run, PointId first, PointId end, MayHold& mayHold, Visitor& visit) const
  {
    const PointId size = RunSize << (RunShift * level);
    if (run * size >= end || (run + 1) * size <= first || !mayHold(this->Runs[level][run]))
    {
      return;
    }
    for (PointId part = run << RunShift;
         level > 0 && part < PointId(std::min(this->Runs[level - 1].size(), std::size_t(run + 1) << RunShift)); ++part)
    {
      this->VisitRun(level - 1, part, first, end, mayHold, visit);
    }
    for (PointId point = std::max(first, run * size); level == 0 && point < std::min(end, (run + 1) * size); ++point)
    {
      visit(point);
    }
  }

  const SearchGrid& Points;
  std::vector<std::vector<PlaneBox>> Runs;
  std::vector<Level> Levels; // lowest first
};
}

#endif
