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
  : BlockDiagonal(InCircle({ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }) < 0 ? 0 : 1)
  , RingDiagonal(InCircle({ 1, 0 }, { 2, 1 }, { 1, 2 }, { 0, 1 }) < 0 ? 0 : 1)
{
  for (const PlanePoint& point : points)
  {
    this->Width = std::max(this->Width, std::int64_t(point.X) + 1);
    this->Height = std::max(this->Height, std::int64_t(point.Y) + 1);
  }
  if (this->Width * this->Height > MostColumnsPerPoint * std::int64_t(points.size()) || !this->PlacePoints(points))
  {
    this->Width = 0;
    this->Height = 0;
    return;
  }
  this->Blocks.assign(this->Points.size(), Nothing);
  this->MarkCutBlocks(points, boundary);
  this->MarkTurns(points, boundary);
  this->MarkOpen();
  this->FindFull();
  this->FindRings();
}

//----------------------------------------------------------------------------------------------------------------------
bool FullBlocks::PlacePoints(const std::vector<PlanePoint>& points)
{
  this->Points.assign(std::size_t(this->Width * this->Height), NoPoint);
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    PointId& place = this->Points[this->Place(points[point].X, points[point].Y)];
    if (place != NoPoint)
    {
      return false;
    }
    place = PointId(point);
  }
  return true;
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
void FullBlocks::MarkTurns(const std::vector<PlanePoint>& points, const Loops& boundary)
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
void FullBlocks::MarkOpen()
{
  for (std::int64_t y = 0; y + 1 < this->Height; ++y)
  {
    bool inside = false;
    for (std::int64_t x = 0; x + 1 < this->Width; ++x)
    {
      unsigned char& block = this->Blocks[this->Place(x, y)];
      inside = inside != ((block & Turn) != 0);
      block = inside && (block & Cut) == 0 ? Open : Nothing;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::FindFull()
{
  for (std::int64_t y = 0; y + 1 < this->Height; ++y)
  {
    const PointId* const below = this->Points.data() + this->Place(0, y);
    const PointId* const above = below + this->Width;
    unsigned char* const blocks = this->Blocks.data() + this->Place(0, y);
    for (std::int64_t x = 0; x + 1 < this->Width; ++x)
    {
      // NoPoint is the only negative number, so that one sign tells of all four.
      const bool full = (blocks[x] & Open) != 0 && (below[x] | below[x + 1] | above[x] | above[x + 1]) >= 0;
      blocks[x] |= full ? Full : Nothing;
      this->Triangles += full ? 2 : 0;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FullBlocks::FindRings()
{
  for (std::int64_t y = 1; y + 1 < this->Height; ++y)
  {
    for (std::int64_t x = 1; x + 1 < this->Width; ++x)
    {
      if (this->At(x, y) == NoPoint && this->IsRing(x, y))
      {
        for (const std::int64_t row : { y - 1, y })
        {
          this->Blocks[this->Place(x - 1, row)] |= Ring;
          this->Blocks[this->Place(x, row)] |= Ring;
        }
        this->Triangles += 6;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool FullBlocks::IsRing(std::int64_t x, std::int64_t y) const
{
  const PointId around = this->At(x - 1, y - 1) | this->At(x, y - 1) | this->At(x + 1, y - 1) | this->At(x - 1, y) |
    this->At(x + 1, y) | this->At(x - 1, y + 1) | this->At(x, y + 1) | this->At(x + 1, y + 1);
  const unsigned char open = this->Blocks[this->Place(x - 1, y - 1)] & this->Blocks[this->Place(x, y - 1)] &
    this->Blocks[this->Place(x - 1, y)] & this->Blocks[this->Place(x, y)];
  return around >= 0 && (open & Open) != 0;
}
}
