// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points and boundary edges that a search looks through: in a grid of square voxels with about one point each, and
// in boxes of points, for what is far away.

#ifndef SeismicHorizonsSearchGrid_h
#define SeismicHorizonsSearchGrid_h

#include "Common/CellGrid.h"
#include "Common/CountingSort.h"
#include "Common/PlaneGeometry.h"
#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Points get new numbers here, voxel by voxel and row by row, so that those in a row of voxels are in one range.
class SearchGrid
{
public:
  /// There must be at least one point, and coordinates are at least 0 and below 2^29. Throws InputError when two points
  /// are in one place, a point lies on a boundary edge, or two boundary edges cross; `names` are the numbers by which
  /// messages call the points.
  SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names);

  /// The new number of a point, and the name of the point that has a new number.
  PointId NumberOf(PointId point) const { return this->Sorted.Numbers[point]; }
  PointId NameOf(PointId number) const { return this->Sorted.Names[number]; }

  PointId NumberOfPoints() const { return PointId(this->Sorted.Names.size()); }

  const PlanePoint& At(PointId number) const { return this->Sorted.Places[number]; }

  /// At() may be asked for so many numbers after the last: a search can look at this many points at once.
  static constexpr PointId Padding = 4;

  const CellGrid& Voxels() const { return this->Grid; }

  /// The points in a voxel have the numbers from the first to before the end.
  PointId FirstIn(std::int64_t voxel) const { return this->Sorted.Voxels.First(voxel); }
  PointId EndOf(std::int64_t voxel) const { return this->Sorted.Voxels.End(voxel); }

  /// The first points of all voxels, row by row: those of a row of voxels end at the first point of the next voxel.
  const PointId* VoxelStarts() const { return this->Sorted.Voxels.Firsts(); }

  /// The column and the row of voxels at a coordinate; for one outside the grid, of the nearest voxel in it. Quicker
  /// than CellX and CellY of the grid, as coordinates are whole and the side of a voxel is a power of two.
  std::int64_t VoxelX(std::int32_t x) const { return std::clamp((x - this->Origin.X) >> this->Shift, 0, this->Last.X); }
  std::int64_t VoxelY(std::int32_t y) const { return std::clamp((y - this->Origin.Y) >> this->Shift, 0, this->Last.Y); }

  /// How far apart points are on average: the side of a square with the area that there is for one point.
  double Spacing() const { return this->PointSpacing; }

  /// The boundary edges in each voxel.
  const EdgeLists& Edges() const { return this->EdgesInVoxel; }

  /// How many steps from voxel to voxel, also across corners, it is to the nearest one with boundary edges, up to 255.
  std::int64_t EdgeDistance(std::int64_t x, std::int64_t y) const
  {
    return this->EdgeDistances[this->Grid.Index(x, y)];
  }

private:
  /// The points in the order of their new numbers.
  struct SortedPoints
  {
    SortedPoints(const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names);

    CountingSort<PointId> Voxels;
    std::vector<PlanePoint> Places; // by new number
    std::vector<PointId> Names; // by new number
    std::vector<PointId> Numbers; // the new numbers, by those that points had before
  };

  bool AreFewAndApart(std::int64_t voxel) const;
  void CheckPlaces(std::int64_t voxel) const;
  void CheckEdges(std::int64_t voxel) const;
  void CheckEdge(const Edge* edge, std::int64_t voxel) const;
  std::string Describe(const Edge& edge) const;
  void MeasureEdgeDistances();

  const double PointSpacing;
  const CellGrid Grid;
  const int Shift; // the exponent of the side of a voxel
  const PlanePoint Origin; // of the grid
  const PlanePoint Last; // the last column and the last row of voxels
  const SortedPoints Sorted;
  const EdgeLists EdgesInVoxel;
  std::vector<unsigned char> EdgeDistances; // by voxel
};

/// From a place to the nearest place of a box.
inline double SquaredDistanceToBox(const SegmentEnd& place, const PlaneBox& box)
{
  const double x = std::max({ box.Least.X - place.X, 0.0, place.X - box.Greatest.X });
  const double y = std::max({ box.Least.Y - place.Y, 0.0, place.Y - box.Greatest.Y });
  return x * x + y * y;
}

/// Bounding boxes of the points in squares of voxels, which double in size from level to level, for what is far away: a
/// search leaves out those that cannot hold a better point. Takes time linear in the points and voxels, and memory of
/// 16 bytes for each 12 voxels and for each 7 points.
class PointPyramid
{
public:
  /// Keeps a reference.
  explicit PointPyramid(const SearchGrid& points);

  /// Calls visit(point) for the points in boxes for which mayHold(box) is true, those with a small distance(box) first.
  /// Both are called when the search reaches a box, so that mayHold can depend on the points that were visited so far.
  template <typename MayHold, typename Distance, typename Visitor>
  void Visit(MayHold&& mayHold, Distance&& distance, Visitor&& visit) const
  {
    this->VisitSquare({ this->Levels.size() - 1, 0, 0 }, mayHold, distance, visit);
  }

private:
  static constexpr std::int64_t BaseSize = 4; // voxels along the side of a square of the lowest level
  static constexpr PointId RunSize = 8; // points in a run of the lowest level
  static constexpr int RunShift = 3; // a run has 2^3 of the level below

  struct Level
  {
    std::int64_t SizeX;
    std::int64_t SizeY;
    std::vector<PlaneBox> Boxes; // row by row
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
      this->VisitVoxels(square, mayHold, visit);
      return;
    }
    const Level& below = this->Levels[square.Level - 1];
    std::array<std::pair<double, Square>, 4> parts; // from near to far
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

  /// The points of a square of the lowest level. Those of a row of it are some runs.
  template <typename MayHold, typename Visitor>
  void VisitVoxels(const Square& square, MayHold& mayHold, Visitor& visit) const
  {
    const CellGrid& voxels = this->Points.Voxels();
    const std::int64_t left = BaseSize * square.X;
    const std::int64_t right = std::min(left + BaseSize, voxels.SizeX()) - 1;
    for (std::int64_t y = BaseSize * square.Y; y < std::min(BaseSize * (square.Y + 1), voxels.SizeY()); ++y)
    {
      const PointId first = this->Points.FirstIn(voxels.Index(left, y));
      const PointId end = this->Points.EndOf(voxels.Index(right, y));
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

  /// The level whose runs are about as long as that.
  std::size_t LevelOfRuns(PointId length) const
  {
    std::size_t level = 0;
    while (level + 1 < this->Runs.size() && (RunSize << (RunShift * (level + 1))) <= length)
    {
      ++level;
    }
    return level;
  }

  /// The points of a run that are from the first to before the end.
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
  // Boxes of points that follow each other. Along an outline a voxel can have many, where inside there are none.
  std::vector<std::vector<PlaneBox>> Runs;
  std::vector<Level> Levels; // the lowest first; the last one has a single square
};
}

#endif
