// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleRaster.h"

#include "CellSpans.h"
#include "Common/FixedChunks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TrianglesPerChunk = 16384;
constexpr std::int64_t CellGrain = 2048; // cells that a thread takes at a time

constexpr double SlackOfCells = 1e-6; // of their side
// Slack is at least so many times the rounding of the largest coordinate.
constexpr double LeastSlack = 64.0;

// Rounding to single precision moves a height by up to 2^-24 of half of their range, and so does the margin itself.
constexpr double RoundingOfHeights = 0x1p-22;

// Limits beyond which a tree takes less time and memory.
constexpr std::int64_t MostCellsPerTriangle = 2;
constexpr std::int64_t MostItemsPerTriangle = 8;
constexpr double MostItemsPerCell = 32.0; // in the cells of a mean item
constexpr double MostOverlapping = 0.25; // of all triangles
constexpr std::int64_t FewItems = 1024; // whatever there are
constexpr double FewOverlapping = 512.0;

/// What the size of cells follows from.
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
  return AddUpChunks<Extent>(std::int64_t(surface.Triangles.size()), TrianglesPerChunk, Monitor(),
    [&](Extent& extent, std::int64_t first, std::int64_t last)
    {
      for (std::size_t n = std::size_t(first); n < std::size_t(last); ++n)
      {
        const PlanTriangle triangle(surface, surface.Triangles[n]);
        for (const PointId corner : surface.Triangles[n])
        {
          extent.Box.extend(surface.Point(corner));
        }
        extent.PlanArea += 0.5 * std::abs(triangle.DoubledArea());
      }
    });
}

/// A whole number, or one over a whole number: on a lattice, cells of such a side hold whole squares.
double RoundSide(double side)
{
  return side > 0.75 ? std::round(side) : 1.0 / std::round(1.0 / side);
}
}

//----------------------------------------------------------------------------------------------------------------------
TriangleRaster::TriangleRaster(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
{
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
/// Cells of about four mean triangles, but no more of them than that; false where coordinates are too large for cells
/// so small.
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
/// By triangle: the one cell that it touches, or ManyCells.
std::vector<std::uint32_t> TriangleRaster::FindOnlyCells() const
{
  const std::vector<Corners>& triangles = this->Surface.Triangles;
  std::vector<std::uint32_t> only(triangles.size());
  ParallelFor(std::int64_t(triangles.size()), TrianglesPerChunk,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::size_t n = std::size_t(first); n < std::size_t(last); ++n)
      {
        only[n] = OnlyCell(this->Grid, PlanTriangle(this->Surface, triangles[n]));
      }
    });
  return only;
}

//----------------------------------------------------------------------------------------------------------------------
/// False where there are too many items.
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
/// False where many triangles overlap.
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
        triangles.emplace_back(this->Surface, this->Surface.Triangles[this->Items[n] & ~OwnerBit]);
        for (std::uint32_t other = begin; other < n; ++other)
        {
          if (Overlap(triangles[n - begin], triangles[other - begin]))
          {
            this->Overlaps[this->Items[n] & ~OwnerBit].store(1, std::memory_order_relaxed);
            this->Overlaps[this->Items[other] & ~OwnerBit].store(1, std::memory_order_relaxed);
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
/// What the triangles of a cell have within it.
TriangleRaster::Heights TriangleRaster::HeightsOf(std::int64_t cell) const
{
  const double reach = 0.5 * this->Grid.Side + 2.0 * this->Grid.Slack;
  const Eigen::Array2d middle =
    this->Grid.Low + this->Grid.Side * (Eigen::Array2d(cell % this->Grid.Size[0], cell / this->Grid.Size[0]) + 0.5);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::uint32_t n = this->Sort.First(cell); n < this->Sort.End(cell); ++n)
  {
    const HeightRange heights =
      HeightsWithin(this->Surface, this->Surface.Triangles[this->Items[n] & ~OwnerBit], middle, reach);
    low = std::min(low, heights.Low);
    high = std::max(high, heights.High);
  }
  return { float(low - this->Middle) - this->Margin, float(high - this->Middle) + this->Margin };
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::MakePyramid()
{
  this->Pyramid.push_back({ { this->Grid.Size[0], this->Grid.Size[1] }, this->Grid.Side, {} });
  this->Pyramid[0].Cells.resize(std::size_t(this->Grid.Cells()));
  ParallelFor(this->Grid.Cells(), CellGrain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        this->Pyramid[0].Cells[std::size_t(cell)] = this->HeightsOf(cell);
      }
    });
  while (this->Pyramid.back().Cells.size() > 1)
  {
    const Level& below = this->Pyramid.back();
    Level level{ { (below.Size[0] + 1) / 2, (below.Size[1] + 1) / 2 }, 2.0 * below.Side, {} };
    constexpr float Infinity = std::numeric_limits<float>::infinity();
    level.Cells.assign(std::size_t(level.Size[0] * level.Size[1]), { Infinity, -Infinity });
    for (std::int64_t y = 0; y < below.Size[1]; ++y)
    {
      for (std::int64_t x = 0; x < below.Size[0]; ++x)
      {
        const Heights& part = below.Cells[std::size_t(y * below.Size[0] + x)];
        Heights& whole = level.Cells[std::size_t(y / 2 * level.Size[0] + x / 2)];
        whole = { std::min(whole.Low, part.Low), std::max(whole.High, part.High) };
      }
    }
    this->Pyramid.push_back(std::move(level));
  }
}
}
