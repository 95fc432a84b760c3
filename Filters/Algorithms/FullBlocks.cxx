// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FullBlocks.h"

#include "CellGrid.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// With fewer points than one in so many columns, looking at all columns costs more than it can save.
constexpr std::int64_t MostColumnsPerPoint = 8;

/// Hops along a row or a column to the next one run between blocks.
bool RunsBetweenBlocks(const PlanePoint& a, const PlanePoint& b)
{
  return std::abs(a.X - b.X) + std::abs(a.Y - b.Y) == 1;
}
}

//----------------------------------------------------------------------------------------------------------------------
FullBlocks::FullBlocks(const std::vector<PlanePoint>& points, const Loops& boundary)
  : Rising(InCircle({ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }) < 0)
{
  for (const PlanePoint& point : points)
  {
    this->Width = std::max(this->Width, std::int64_t(point.X) + 1);
    this->Height = std::max(this->Height, std::int64_t(point.Y) + 1);
  }
  if (this->Width * this->Height > MostColumnsPerPoint * std::int64_t(points.size()))
  {
    this->Width = 0;
    this->Height = 0;
    return;
  }
  this->Points.assign(std::size_t(this->Width * this->Height), NoPoint);
  this->Blocks.assign(this->Points.size(), Nothing);
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    this->Points[this->Place(points[point].X, points[point].Y)] = PointId(point);
  }
  this->MarkCutBlocks(points, boundary);
  this->MarkInside(points, boundary);
  this->FindFull();
}

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::MarkCutBlocks(const std::vector<PlanePoint>& points, const Loops& boundary)
{
  const CellGrid blocks(points, 1, 1);
  boundary.ForEachHop(
    [&](PointId from, PointId to)
    {
      const PlanePoint& a = points[std::size_t(from)];
      const PlanePoint& b = points[std::size_t(to)];
      if (!RunsBetweenBlocks(a, b))
      {
        blocks.ForEachCellAlong(a, b, [this](std::int64_t block) { this->Blocks[std::size_t(block)] |= Cut; });
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// Along the middle of a row of blocks, each hop that crosses it is where the inside begins or ends for all blocks whose
// middle is further to the right. A hop through the middle of a block has cut it.
void FullBlocks::MarkInside(const std::vector<PlanePoint>& points, const Loops& boundary)
{
  boundary.ForEachHop(
    [&](PointId from, PointId to)
    {
      const PlanePoint& a = points[std::size_t(from)];
      const PlanePoint& b = points[std::size_t(to)];
      for (std::int32_t y = std::min(a.Y, b.Y); y < std::max(a.Y, b.Y); ++y)
      {
        const double x = a.X + (double(b.X) - a.X) * (y + 0.5 - a.Y) / (double(b.Y) - a.Y);
        this->Blocks[this->Place(std::int64_t(std::floor(x + 0.5)), y)] ^= Turn;
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::FindFull()
{
  for (std::int64_t y = 0; y + 1 < this->Height; ++y)
  {
    bool inside = false;
    for (std::int64_t x = 0; x + 1 < this->Width; ++x)
    {
      const std::size_t place = this->Place(x, y);
      unsigned char& block = this->Blocks[place];
      inside = inside != ((block & Turn) != 0);
      const std::size_t above = place + std::size_t(this->Width);
      const bool occupied = this->Points[place] != NoPoint && this->Points[place + 1] != NoPoint &&
        this->Points[above] != NoPoint && this->Points[above + 1] != NoPoint;
      block = inside && occupied && (block & Cut) == 0 ? Full : Nothing;
    }
  }
}
}
