// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounding boxes of the points in squares of voxels, which double in size from level to level. For edges whose third
// point is far away: those of an outline without points inside, or between many points and one far from them. A search
// voxel by voxel would look at most of the points for each such edge. With the boxes it leaves out those that can not
// hold a better point than the best so far.

#ifndef SeismicHorizonsPointPyramid_h
#define SeismicHorizonsPointPyramid_h

#include "Common/PlaneGeometry.h"
#include "Common/Types.h"
#include "SearchGrid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// To make it takes time linear in the points and voxels, and memory of 16 bytes for each 12 voxels and for each 7
/// points.
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
    return level.Boxes[std::size_t(square.Y * level.SizeX + square.X)];
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

  /// The points of a square of the lowest level.
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
    if (run * size >= end || (run + 1) * size <= first || !mayHold(this->Runs[level][std::size_t(run)]))
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

  static constexpr PointId RunSize = 8; // points in a run of the lowest level
  static constexpr int RunShift = 3; // a run has 2^3 of the level below

  const SearchGrid& Points;
  // Boxes of points that follow each other. Along an outline a voxel can have many, where inside there are none.
  std::vector<std::vector<PlaneBox>> Runs;
  std::vector<Level> Levels; // the lowest first; the last one has a single square
};
}

#endif
