// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A raster of square cells in plan, with the triangles that touch each, to find the nearest triangle of a surface that
// is about a height field.
//
// The triangle right above or below a place bounds the distance: only triangles whose cells are within the bound in
// plan can be nearer. Mostly that is the one cell, and a few triangles. Where the bound is poor (the surface is steep,
// far away, or ends) a pyramid over the cells is searched, as a tree of boxes: each box has the heights of four of the
// level below.
//
// A surface of any shape is searched correctly, but slowly where many triangles touch one cell; for such a surface the
// raster stays empty (IsWorthwhile).

#ifndef SeismicHorizonsTriangleRaster_h
#define SeismicHorizonsTriangleRaster_h

#include "Common/CountingSort.h"
#include "Common/Monitor.h"
#include "Metric.h"
#include "PlanTriangle.h"

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Cells from First to Last along an axis, both included; none where Last is below First.
struct CellRange
{
  std::int64_t First;
  std::int64_t Last;
  std::int64_t Size() const { return this->Last - this->First + 1; }
};

/// Where the cells are.
struct RasterGrid
{
  Eigen::Array2d Low = Eigen::Array2d::Zero(); // the corner of the first cell
  double Side = 1.0;
  double CellsPerUnit = 1.0; // one over the side
  // By how much triangles are taken to be smaller, so that the two of a lattice square lie in one cell, and boxes of
  // cells to be larger. Far more than rounding moves anything.
  double Slack = 0.0;
  std::int64_t Size[2] = { 0, 0 };

  std::int64_t Cells() const { return this->Size[0] * this->Size[1]; }

  /// The cells of an interval, of those there are.
  CellRange Range(int axis, double low, double high) const
  {
    // Numbers that are not negative are cut to whole ones, which takes less time than std::floor.
    const double first = (low - this->Low[axis]) * this->CellsPerUnit;
    const double last = (high - this->Low[axis]) * this->CellsPerUnit;
    return { std::int64_t(std::clamp(first, 0.0, double(this->Size[axis]))),
      last < 0.0 ? -1 : std::int64_t(std::min(last, double(this->Size[axis] - 1))) };
  }

  /// The cell of a place in plan; -1 outside.
  std::int64_t CellOf(const Eigen::Vector3d& place) const
  {
    const double x = (place.x() - this->Low[0]) * this->CellsPerUnit;
    const double y = (place.y() - this->Low[1]) * this->CellsPerUnit;
    const bool inside = x >= 0.0 && y >= 0.0 && x < double(this->Size[0]) && y < double(this->Size[1]);
    return inside ? std::int64_t(y) * this->Size[0] + std::int64_t(x) : -1;
  }
};

class TriangleRaster
{
public:
  /// `surface` is one that CheckSurface takes, and must outlive the raster. Linear, on several threads; about 15 bytes
  /// per triangle where all are about the same size. The same raster for any number of threads.
  explicit TriangleRaster(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  /// False where a tree is quicker: then the raster is empty.
  bool IsWorthwhile() const { return this->Grid.Cells() > 0; }

  std::int64_t Cells() const { return this->Grid.Cells(); }

  /// Calls visit(triangle) for the triangles of a range of cells, so that each triangle is visited with one cell.
  template <typename Visitor>
  void ForEachTriangle(std::int64_t firstCell, std::int64_t lastCell, Visitor&& visit) const
  {
    for (std::uint32_t n = this->Sort.First(firstCell); n < this->Sort.First(lastCell); ++n)
    {
      if ((this->Items[n] & OwnerBit) != 0)
      {
        visit(this->TriangleOf(n));
      }
    }
  }

  /// Calls visit(triangle) for all triangles that may overlap one in plan, some of them more than once, while it is
  /// true; whether it always was.
  template <typename Visitor>
  bool ForEachNear(const PlanTriangle& plan, Visitor&& visit) const
  {
    const CellRange box = this->Grid.Range(0, plan.Low(0) - this->Slack(), plan.High(0) + this->Slack());
    const CellRange rows = this->Grid.Range(1, plan.Low(1) - this->Slack(), plan.High(1) + this->Slack());
    for (std::int64_t row = rows.First; row <= rows.Last; ++row)
    {
      CellRange cells = box;
      if (box.Size() > 2)
      {
        const double low = this->Grid.Low[1] + double(row) * this->Grid.Side;
        const auto [first, last] = SpanWithin(plan, low - this->Slack(), low + this->Grid.Side + this->Slack());
        cells = this->Grid.Range(0, std::min(first, last) - this->Slack(), std::max(first, last) + this->Slack());
      }
      const std::uint32_t end = cells.Size() > 0 ? this->Sort.End(row * this->Grid.Size[0] + cells.Last) : 0;
      for (std::uint32_t n = end > 0 ? this->Sort.First(row * this->Grid.Size[0] + cells.First) : 0; n < end; ++n)
      {
        if (!visit(this->TriangleOf(n)))
        {
          return false;
        }
      }
    }
    return true;
  }

  const TriangleSurface& GetSurface() const { return this->Surface; }

  /// A triangle right above or below a place; -1 for none. One that reaches the place by rounding alone counts.
  std::int32_t FindAcross(const Eigen::Vector3d& place) const;

  /// Whether a triangle overlaps no other one in plan, but for a strip along its sides that is narrower than Slack.
  bool IsAlone(std::int32_t triangle) const { return this->Overlaps[triangle].load(std::memory_order_relaxed) == 0; }

  /// Triangles reach over the cells that they are listed in by twice the slack of the grid at most, along both axes.
  double Slack() const { return 4.0 * this->Grid.Slack; }

  /// Finds the nearest triangle. `best` and `nearest`, the squared distance to any triangle and its number, become
  /// those of the nearest one.
  void Search(const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const;

  /// As TriangleTree::FindHeight.
  double FindHeight(const Eigen::Vector3d& point, double tolerance) const;

private:
  static constexpr std::uint32_t OwnerBit = std::uint32_t(1) << 31U;

  /// From the lowest to the highest z, relative to Middle, of triangles in a cell; Low is above High where there are
  /// none.
  struct Heights
  {
    float Low;
    float High;
  };
  /// The cells of a level of the pyramid, four of the level below each.
  struct Level
  {
    std::int64_t Size[2];
    double Side;
    std::vector<Heights> Cells;
  };
  struct Waiting;

  std::int32_t TriangleOf(std::uint32_t item) const { return std::int32_t(this->Items[item] & ~OwnerBit); }
  bool MakeGrid();
  std::vector<std::uint32_t> FindOnlyCells() const;
  bool SortIntoCells();
  bool IsCrowded() const;
  bool FindOverlaps();
  void MakePyramid();
  Heights HeightsOf(std::int64_t cell) const;
  Waiting* PushChildren(
    const Eigen::Vector3d& place, const Metric& metric, const Waiting& box, double best, Waiting* end) const;
  void SearchCells(const Eigen::Vector3d& place, const Metric& metric, const CellRange& x, const CellRange& y,
    std::int32_t& nearest, double& best) const;
  void SearchPyramid(const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const;

  const TriangleSurface& Surface;
  RasterGrid Grid;
  CountingSort<std::uint32_t> Sort;
  std::vector<std::uint32_t> Items; // numbers of triangles, by cell; with the bit in the first cell of each
  std::vector<std::atomic<unsigned char>> Overlaps; // by triangle
  std::vector<Level> Pyramid;
  double Middle = 0.0;
  float Margin = 0.0F; // by how much heights are widened: more than rounding moves any
};
}

#endif
