// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShortcutGuard.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// Not between the ends of the chain.
constexpr std::size_t NoPosition = 0;

std::int64_t FloorOfPart(std::int64_t numerator, std::int64_t denominator)
{
  const std::int64_t part = numerator / denominator;
  return part - std::int64_t(numerator % denominator < 0);
}

// A crossing is one number, by which crossings sort row by row, and in a row by x: 31 bits of the row, 32 of x, 1 of
// the direction.
constexpr std::int64_t Offset = std::int64_t(1) << 30; // makes rows and places positive
constexpr int PlaceBits = 32;

std::int64_t RowOf(std::uint64_t crossing)
{
  return std::int64_t(crossing >> (PlaceBits + 1)) - Offset;
}

/// The sum of the whole numbers next to x on either side, which are both x when that is whole. So those between two
/// crossings are known, and in which order crossings come that have none between them does not matter.
std::int64_t PlaceOf(std::uint64_t crossing)
{
  return std::int64_t(crossing >> 1 & ((std::uint64_t(1) << PlaceBits) - 1)) - 2 * Offset;
}

bool IsUpward(std::uint64_t crossing)
{
  return (crossing & 1) != 0;
}
}

//----------------------------------------------------------------------------------------------------------------------
ShortcutGuard::ShortcutGuard(const SpacePoints& points, const std::vector<unsigned char>& isOnLoop)
  : Points(points)
  , Occupied(points, isOnLoop)
  , Position(this->Occupied.NumberOfLoopColumns(), NoPosition)
{
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t& ShortcutGuard::PositionOf(PointId point)
{
  const PlanePoint column = this->Points.Column(std::size_t(point));
  return this->Position[this->Occupied.LoopNumber(column.X, column.Y)];
}

//----------------------------------------------------------------------------------------------------------------------
void ShortcutGuard::SetChain(const std::vector<PointId>& chain)
{
  for (const PointId point : this->Chain)
  {
    this->PositionOf(point) = NoPosition;
  }
  this->Chain = chain;
  for (std::size_t position = 1; position + 1 < chain.size(); ++position)
  {
    this->PositionOf(chain[position]) = position;
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsClear(std::size_t from, std::size_t to)
{
  this->From = from;
  this->To = to;
  const PlanePoint first = this->ColumnAt(from);
  const PlanePoint last = this->ColumnAt(to);
  if (!this->IsClearAlong(first, last))
  {
    return false;
  }
  this->Crossings.clear();
  for (std::size_t position = from; position < to; ++position)
  {
    this->AddCrossings(this->ColumnAt(position), this->ColumnAt(position + 1));
  }
  this->AddCrossings(last, first);
  return this->IsClearBetween();
}

//----------------------------------------------------------------------------------------------------------------------
/// Where an edge crosses the rows of columns. Its lower end counts, its upper end does not, so that a line through an
/// end of two edges crosses one of them, or both, or neither, as a line just above does.
void ShortcutGuard::AddCrossings(const PlanePoint& from, const PlanePoint& to)
{
  const bool isUpward = from.Y < to.Y;
  const PlanePoint& low = isUpward ? from : to;
  const PlanePoint& high = isUpward ? to : from;
  const std::int64_t height = std::int64_t(high.Y) - low.Y;
  const std::int64_t width = std::int64_t(high.X) - low.X;
  for (std::int64_t row = 0; row < height; ++row)
  {
    const std::int64_t floor = FloorOfPart(row * width, height);
    const std::int64_t place = 2 * (low.X + floor) + std::int64_t(floor * height != row * width);
    this->Crossings.push_back(std::uint64_t(low.Y + row + Offset) << (PlaceBits + 1) |
      std::uint64_t(place + 2 * Offset) << 1 | std::uint64_t(isUpward));
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether all columns that the chain and the edge go around, in either direction, are clear.
bool ShortcutGuard::IsClearBetween()
{
  std::sort(this->Crossings.begin(), this->Crossings.end());
  int turns = 0;
  for (std::size_t n = 0; n + 1 < this->Crossings.size(); ++n)
  {
    const std::uint64_t crossing = this->Crossings[n];
    turns += IsUpward(crossing) ? 1 : -1;
    const std::int64_t last = turns == 0 ? 0 : FloorOfPart(PlaceOf(this->Crossings[n + 1]), 2);
    for (std::int64_t x = FloorOfPart(PlaceOf(crossing) + 1, 2); turns != 0 && x <= last; ++x)
    {
      if (!this->IsClearAt(x, RowOf(crossing)))
      {
        return false;
      }
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether the columns that an edge passes exactly are clear.
bool ShortcutGuard::IsClearAlong(const PlanePoint& from, const PlanePoint& to) const
{
  const std::int64_t x = std::int64_t(to.X) - from.X;
  const std::int64_t y = std::int64_t(to.Y) - from.Y;
  const std::int64_t steps = std::gcd(x, y);
  for (std::int64_t step = 1; step < steps; ++step)
  {
    if (!this->IsClearAt(from.X + x / steps * step, from.Y + y / steps * step))
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsClearAt(std::int64_t x, std::int64_t y) const
{
  if (!this->Occupied.IsOccupied(x, y))
  {
    return true;
  }
  const std::size_t number = this->Occupied.LoopNumber(x, y);
  const std::size_t position = number == OccupiedColumns::NoNumber ? NoPosition : this->Position[number];
  const PlanePoint column = { std::int32_t(x), std::int32_t(y) };
  return (position > this->From && position < this->To) || column == this->ColumnAt(this->From) ||
    column == this->ColumnAt(this->To);
}
}
