// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Five passes make the raster; any but the last may prefer a tree:
//
// MakeGrid: cells of about the mean triangle's area, on a lattice whole squares
// SortIntoCells: triangles that touch a cell, the items
// IsCrowded: too many triangles per cell
// FindOverlaps: triangles that overlap in plan
// MakePyramid: heights by cell, then by squares of four
//
// Searches visit the cells within the best distance or, if there are many, the pyramid.
//
// Triangles are shrunk by the slack, a millionth of a cell, so that the two of a lattice square lie in one cell instead
// of nine. Searches widen boxes by twice the slack.

#include "TriangleRaster.h"

#include "Common/Base/FixedChunks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TrianglesPerBin = 16384;
constexpr std::int64_t CellGrain = 2048;

constexpr double SlackOfCells = 1e-6; // of their side
// Slack is at least this multiple of the rounding of the largest coordinate.
constexpr double LeastSlack = 64.0;

// Single precision, and the margin, round heights by up to 2^-24 of half their range.
constexpr double RoundingOfHeights = 0x1p-22;

// Beyond these limits, as for heaps and walls, a raster may take far more than a tree. Needles would still be faster,
// but counts do not show them.
constexpr std::int64_t MostCellsPerTriangle = 2;
constexpr std::int64_t MostItemsPerTriangle = 8;
constexpr double MostItemsPerCell = 32.0; // in the cell of a mean item
constexpr double MostOverlapping = 0.25; // of all triangles
constexpr std::int64_t FewItems = 1024; // always allowed
constexpr double FewOverlapping = 512.0;

constexpr std::int64_t FewCells = 16; // With more cells the pyramid is searched.

// A box adds three to the stack per level, and there are fewer than 64 levels.
constexpr std::size_t MostWaitingBlocks = 3 * 64 + 1;

// A place this far outside, relative to the area, counts as across.
constexpr double AcrossTolerance = 1e-9;

double Square(double value)
{
  return value * value;
}

// ---- Triangles in plan ----------------------------------------------------------------------------------------------

CellRange ShrunkRange(const RasterGrid& grid, int axis, double low, double high)
{
  const double middle = 0.5 * (low + high);
  return grid.Range(axis, std::min(low + grid.Slack, middle), std::max(high - grid.Slack, middle));
}

std::array<CellRange, 2> BoxOf(const RasterGrid& grid, const PlanTriangle& triangle)
{
  return { ShrunkRange(grid, 0, triangle.Low(0), triangle.High(0)),
    ShrunkRange(grid, 1, triangle.Low(1), triangle.High(1)) };
}

constexpr std::uint32_t ManyCells = 0xffffffffU;

std::uint32_t OnlyCell(const RasterGrid& grid, const PlanTriangle& triangle)
{
  const auto [x, y] = BoxOf(grid, triangle);
  return x.Size() == 1 && y.Size() == 1 ? std::uint32_t(y.First * grid.Size[0] + x.First) : ManyCells;
}

/// Places of the triangle are at most twice the slack beyond these cells.
template <typename Visitor>
void ForEachCell(const RasterGrid& grid, const PlanTriangle& triangle, Visitor&& visit)
{
  const auto [x, y] = BoxOf(grid, triangle);
  const bool isBox = x.Size() == 1 || y.Size() == 1;
  for (std::int64_t row = y.First; row <= y.Last; ++row)
  {
    CellRange cells = x;
    if (!isBox)
    {
      const double low = grid.Low[1] + double(row) * grid.Side - grid.Slack;
      const std::array<double, 2> span = SpanWithin(triangle, low, low + grid.Side + 2.0 * grid.Slack);
      cells = ShrunkRange(grid, 0, std::min(span[0], span[1]), std::max(span[0], span[1]));
    }
    for (std::int64_t cell = row * grid.Size[0] + cells.First; cell <= row * grid.Size[0] + cells.Last; ++cell)
    {
      visit(cell);
    }
  }
}

/// Returns the least and greatest height. The plane of the triangle within a square may narrow the range.
std::array<double, 2> HeightsWithin(
  const TriangleSurface& surface, const Corners& t, const Eigen::Array2d& middle, double reach)
{
  const Eigen::Vector3d& a = surface.Point(t[0]);
  const Eigen::Vector3d& b = surface.Point(t[1]);
  const Eigen::Vector3d& c = surface.Point(t[2]);
  const double low = std::min({ a.z(), b.z(), c.z() });
  const double high = std::max({ a.z(), b.z(), c.z() });
  const auto offset = [&middle](const Eigen::Vector3d& v) { return (v.head<2>().array() - middle).abs().maxCoeff(); };
  if (std::max({ offset(a), offset(b), offset(c) }) <= reach)
  {
    return { low, high };
  }
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const Eigen::Array2d slope = -normal.head<2>().array() / normal.z();
  const double height = a.z() + (slope * (middle - a.head<2>().array())).sum();
  // Rounding of slopes grows with height over width of a needle in plan.
  const double change = slope.abs().sum() * reach + 1e-9 * (high - low);
  const double longer = std::max((b - a).head<2>().squaredNorm(), (c - a).head<2>().squaredNorm());
  const bool isPlane = std::abs(normal.z()) > 1e-5 * longer && std::isfinite(height);
  return { isPlane ? std::max(low, height - change) : low, isPlane ? std::min(high, height + change) : high };
}

// ---- Making the raster ----------------------------------------------------------------------------------------------

struct Extent
{
  Eigen::AlignedBox3d Box;
  double PlanArea = 0.0;

  void Add(const Extent& other)
  {
    this->Box.extend(other.Box);
    this->PlanArea += other.PlanArea;
  }
};

Extent MeasureExtent(const TriangleSurface& surface)
{
  return AddUpChunks<Extent>(std::int64_t(surface.Triangles.size()), TrianglesPerBin, Monitor(),
    [&](Extent& extent, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        extent.Add({ surface.Box(surface.Triangles[n]),
          0.5 * std::abs(PlanTriangle(surface, surface.Triangles[n]).DoubledArea()) });
      }
    });
}

/// On a lattice, cells with such sides hold whole squares.
double RoundSide(double side)
{
  return side > 0.75 ? std::round(side) : 1.0 / std::round(1.0 / side);
}
}

//----------------------------------------------------------------------------------------------------------------------
TriangleRaster::TriangleRaster(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
{
  assert(surface.Triangles.size() < OwnerBit);
  monitor.Progress(0.0);
  bool isWorthwhile = this->MakeGrid();
  monitor.Progress(0.2);
  isWorthwhile = isWorthwhile && this->SortIntoCells() && !this->IsCrowded();
  monitor.Progress(0.5);
  isWorthwhile = isWorthwhile && this->FindOverlaps();
  monitor.Progress(0.7);
  if (isWorthwhile)
  {
    this->MakePyramid();
    return;
  }
  this->Grid.Size[0] = this->Grid.Size[1] = 0;
  this->Sort = CountingSort<std::uint32_t>();
  this->Items = std::vector<std::uint32_t>();
  this->Overlaps = std::vector<std::atomic<unsigned char>>();
}

//----------------------------------------------------------------------------------------------------------------------
/// Returns false if cells are too small for the coordinates, or nothing has an area.
bool TriangleRaster::MakeGrid()
{
  const Extent extent = MeasureExtent(this->Surface);
  const std::int64_t triangles = std::int64_t(this->Surface.Triangles.size());
  const double most = double(MostCellsPerTriangle * triangles + FewItems);
  this->Middle = extent.Box.center().z();
  this->Margin = float(RoundingOfHeights * extent.Box.sizes().z());
  double side = RoundSide(std::sqrt(extent.PlanArea / double(triangles)));
  if (!(side > 0.0) || !std::isfinite(side))
  {
    return false;
  }
  Eigen::Array2d size;
  for (;; side *= 2.0)
  {
    this->Grid.Low = (extent.Box.min().head<2>().array() / side).floor() * side;
    size = ((extent.Box.max().head<2>().array() - this->Grid.Low) / side).floor() + 1.0;
    if (size.prod() <= most)
    {
      break;
    }
  }
  this->Grid.Side = side;
  this->Grid.CellsPerUnit = 1.0 / side;
  this->Grid.Slack = SlackOfCells * side;
  this->Grid.Size[0] = std::int64_t(size[0]);
  this->Grid.Size[1] = std::int64_t(size[1]);
  const double largest =
    std::max(extent.Box.min().head<2>().cwiseAbs().maxCoeff(), extent.Box.max().head<2>().cwiseAbs().maxCoeff());
  return this->Grid.Slack > LeastSlack * std::numeric_limits<double>::epsilon() * largest;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::uint32_t> TriangleRaster::FindOnlyCells() const
{
  const std::vector<Corners>& triangles = this->Surface.Triangles;
  std::vector<std::uint32_t> only(triangles.size());
  ParallelFor(std::int64_t(triangles.size()), TrianglesPerBin,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        only[n] = OnlyCell(this->Grid, PlanTriangle(this->Surface, triangles[n]));
      }
    });
  return only;
}

//----------------------------------------------------------------------------------------------------------------------
bool TriangleRaster::SortIntoCells()
{
  const std::vector<std::uint32_t> only = this->FindOnlyCells();
  const std::size_t most = std::size_t(MostItemsPerTriangle) * only.size() + std::size_t(FewItems);
  const auto forEach = [&](std::size_t n, auto&& visit)
  {
    only[n] != ManyCells ? visit(std::int64_t(only[n]))
                         : ForEachCell(this->Grid, PlanTriangle(this->Surface, this->Surface.Triangles[n]), visit);
  };
  this->Sort = CountingSort<std::uint32_t>(this->Grid.Cells());
  std::size_t items = 0;
  for (std::size_t n = 0; n < only.size() && items <= most; ++n)
  {
    forEach(n,
      [&](std::int64_t cell)
      {
        this->Sort.Count(cell);
        ++items;
      });
  }
  if (items > most)
  {
    return false;
  }
  this->Sort.EndCounting();
  this->Items.resize(items);
  for (std::size_t n = 0; n < only.size(); ++n)
  {
    std::uint32_t owner = OwnerBit;
    forEach(n,
      [&](std::int64_t cell)
      {
        this->Items[this->Sort.NextPosition(cell)] = std::uint32_t(n) | owner;
        owner = 0;
      });
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
bool TriangleRaster::IsCrowded() const
{
  double squares = 0.0;
  for (std::int64_t cell = 0; cell < this->Grid.Cells(); ++cell)
  {
    const double items = this->Sort.End(cell) - this->Sort.First(cell);
    squares += items * items;
  }
  return squares > MostItemsPerCell * double(this->Items.size() + std::size_t(FewItems));
}

//----------------------------------------------------------------------------------------------------------------------
bool TriangleRaster::FindOverlaps()
{
  this->Overlaps = std::vector<std::atomic<unsigned char>>(this->Surface.Triangles.size());
  const auto find = [&](std::int64_t first, std::int64_t last)
  {
    std::vector<PlanTriangle> triangles;
    for (std::int64_t cell = first; cell < last; ++cell)
    {
      triangles.clear();
      const std::uint32_t begin = this->Sort.First(cell);
      for (std::uint32_t n = begin; n < this->Sort.End(cell); ++n)
      {
        triangles.emplace_back(this->Surface, this->Surface.Triangles[this->TriangleOf(n)]);
        for (std::uint32_t other = begin; other < n; ++other)
        {
          if (Overlap(triangles[n - begin], triangles[other - begin]))
          {
            this->Overlaps[this->TriangleOf(n)].store(1, std::memory_order_relaxed);
            this->Overlaps[this->TriangleOf(other)].store(1, std::memory_order_relaxed);
          }
        }
      }
    }
  };
  ParallelFor(this->Grid.Cells(), CellGrain, find);
  const std::ptrdiff_t overlapping = std::count(this->Overlaps.begin(), this->Overlaps.end(), 1);
  return double(overlapping) <= MostOverlapping * double(this->Overlaps.size()) + FewOverlapping;
}

//----------------------------------------------------------------------------------------------------------------------
TriangleRaster::Heights TriangleRaster::HeightsOf(std::int64_t cell) const
{
  const double reach = 0.5 * this->Grid.Side + 2.0 * this->Grid.Slack;
  const Eigen::Array2d middle =
    this->Grid.Low + this->Grid.Side * (Eigen::Array2d(cell % this->Grid.Size[0], cell / this->Grid.Size[0]) + 0.5);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::uint32_t n = this->Sort.First(cell); n < this->Sort.End(cell); ++n)
  {
    const auto [least, greatest] =
      HeightsWithin(this->Surface, this->Surface.Triangles[this->TriangleOf(n)], middle, reach);
    low = std::min(low, least);
    high = std::max(high, greatest);
  }
  return { float(low - this->Middle) - this->Margin, float(high - this->Middle) + this->Margin };
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::MakePyramid()
{
  this->Pyramid.push_back({ { this->Grid.Size[0], this->Grid.Size[1] }, this->Grid.Side, {} });
  this->Pyramid[0].Cells.resize(this->Grid.Cells());
  ParallelFor(this->Grid.Cells(), CellGrain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        this->Pyramid[0].Cells[cell] = this->HeightsOf(cell);
      }
    });
  while (this->Pyramid.back().Cells.size() > 1)
  {
    const Level& below = this->Pyramid.back();
    Level level{ { (below.Size[0] + 1) / 2, (below.Size[1] + 1) / 2 }, 2.0 * below.Side, {} };
    constexpr float Infinity = std::numeric_limits<float>::infinity();
    level.Cells.assign(level.Size[0] * level.Size[1], { Infinity, -Infinity });
    for (std::int64_t y = 0; y < below.Size[1]; ++y)
    {
      for (std::int64_t x = 0; x < below.Size[0]; ++x)
      {
        const Heights& part = below.Cells[y * below.Size[0] + x];
        Heights& whole = level.Cells[y / 2 * level.Size[0] + x / 2];
        whole = { std::min(whole.Low, part.Low), std::max(whole.High, part.High) };
      }
    }
    this->Pyramid.push_back(std::move(level));
  }
}

// ---- Searches -------------------------------------------------------------------------------------------------------

struct TriangleRaster::Waiting
{
  double SquaredDistance;
  std::uint32_t LevelOf;
  std::uint32_t X;
  std::uint32_t Y;
};

//----------------------------------------------------------------------------------------------------------------------
std::int32_t TriangleRaster::FindAcross(const Eigen::Vector3d& place) const
{
  const std::int64_t cell = this->Grid.CellOf(place);
  if (cell < 0)
  {
    return -1;
  }
  for (std::uint32_t n = this->Sort.First(cell); n < this->Sort.End(cell); ++n)
  {
    const std::int32_t number = this->TriangleOf(n);
    const Corners& t = this->Surface.Triangles[number];
    const auto [first, second, third] =
      DoubledAreas(place, this->Surface.Point(t[0]), this->Surface.Point(t[1]), this->Surface.Point(t[2]));
    const double whole = first + second + third;
    const double least =
      whole < 0.0 ? -std::max(std::max(first, second), third) : std::min(std::min(first, second), third);
    if (least >= -AcrossTolerance * std::abs(whole))
    {
      return number;
    }
  }
  return -1;
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::SearchCells(const Eigen::Vector3d& place, const Metric& metric, const CellRange& x,
  const CellRange& y, std::int32_t& nearest, double& best) const
{
  for (std::int64_t row = y.First; row <= y.Last; ++row)
  {
    const std::uint32_t end = this->Sort.End(row * this->Grid.Size[0] + x.Last);
    for (std::uint32_t n = this->Sort.First(row * this->Grid.Size[0] + x.First); n < end; ++n)
    {
      const std::int32_t triangle = this->TriangleOf(n);
      KeepNearer(this->Surface, this->Surface.Triangles[triangle], triangle, place, metric, nearest, best);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Pushes nearer boxes only, the nearest last.
TriangleRaster::Waiting* TriangleRaster::PushChildren(
  const Eigen::Vector3d& place, const Metric& metric, const Waiting& box, double best, Waiting* end) const
{
  const Level& cells = this->Pyramid[box.LevelOf - 1];
  const double reach = 2.0 * this->Grid.Slack;
  const std::int64_t first[2] = { 2 * box.X, 2 * box.Y };
  double gaps[2][2]; // squared, by axis
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int n = 0; n < 2; ++n)
    {
      const double low = this->Grid.Low[axis] + double(first[axis] + n) * cells.Side - reach;
      const double gap = std::max(low - place[axis], place[axis] - (low + cells.Side + 2.0 * reach));
      gaps[axis][n] = Square(std::max(gap, 0.0) * metric.Weights()[axis]);
    }
  }
  Waiting* next = end;
  for (int y = 0; y < 2 && first[1] + y < cells.Size[1]; ++y)
  {
    for (int x = 0; x < 2 && first[0] + x < cells.Size[0]; ++x)
    {
      const Heights& heights = cells.Cells[(first[1] + y) * cells.Size[0] + first[0] + x];
      const double height = place.z() - this->Middle;
      const double gap = std::max(double(heights.Low) - height, height - double(heights.High));
      const double squared = gaps[0][x] + gaps[1][y] + Square(std::max(gap, 0.0) * metric.Weights()[2]);
      if (squared < best)
      {
        *next++ = { squared, std::uint32_t(box.LevelOf - 1), std::uint32_t(first[0] + x), std::uint32_t(first[1] + y) };
      }
    }
  }
  SortByDistance(end, next);
  return next;
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::SearchPyramid(
  const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const
{
  Waiting stack[MostWaitingBlocks];
  Waiting* end = stack;
  *end++ = { 0.0, std::uint32_t(this->Pyramid.size() - 1), 0, 0 };
  while (end != stack)
  {
    const Waiting box = *--end;
    if (box.SquaredDistance >= best)
    {
      continue;
    }
    if (box.LevelOf == 0)
    {
      this->SearchCells(place, metric, { box.X, box.X }, { box.Y, box.Y }, nearest, best);
      continue;
    }
    assert(end + 4 <= stack + MostWaitingBlocks);
    end = this->PushChildren(place, metric, box, best, end);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::Search(
  const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const
{
  assert(this->IsWorthwhile() && nearest >= 0 && best >= 0.0);
  const Eigen::Array2d reach = std::sqrt(best) / metric.Weights().head<2>() + 2.0 * this->Grid.Slack;
  const CellRange x = this->Grid.Range(0, place.x() - reach[0], place.x() + reach[0]);
  const CellRange y = this->Grid.Range(1, place.y() - reach[1], place.y() + reach[1]);
  if (x.Size() <= 0 || y.Size() <= 0)
  {
    return;
  }
  if (x.Size() <= FewCells && y.Size() <= FewCells && x.Size() * y.Size() <= FewCells)
  {
    this->SearchCells(place, metric, x, y, nearest, best);
    return;
  }
  this->SearchPyramid(place, metric, nearest, best);
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleRaster::FindHeight(const Eigen::Vector3d& point, double tolerance) const
{
  const double reach = 2.0 * (tolerance + this->Grid.Slack);
  const CellRange x = this->Grid.Range(0, point.x() - reach, point.x() + reach);
  const CellRange y = this->Grid.Range(1, point.y() - reach, point.y() + reach);
  double best = std::numeric_limits<double>::quiet_NaN();
  for (std::int64_t row = y.First; row <= y.Last; ++row)
  {
    for (std::int64_t column = x.First; column <= x.Last; ++column)
    {
      const std::int64_t cell = row * this->Grid.Size[0] + column;
      for (std::uint32_t n = this->Sort.First(cell); n < this->Sort.End(cell); ++n)
      {
        const Corners& t = this->Surface.Triangles[this->TriangleOf(n)];
        if (PlanTriangle(this->Surface, t).MayReach(point, 2.0 * tolerance))
        {
          best = NearerHeight(this->Surface, t, point, tolerance, best);
        }
      }
    }
  }
  return best;
}
}
