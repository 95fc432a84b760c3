// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Hops.h"

#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// A sweep from the south meets the west in its first half.
bool IsInFirstHalf(const PlanePoint& vector)
{
  return vector.X < 0 || (vector.X == 0 && vector.Y < 0);
}

PlanePoint Sum(const PlanePoint& a, const PlanePoint& b)
{
  return { a.X + b.X, a.Y + b.Y };
}

PlanePoint Difference(const PlanePoint& a, const PlanePoint& b)
{
  return { a.X - b.X, a.Y - b.Y };
}

/// A hop of length n along its longer axis meets the next squares after a fraction of at least 1 / n. Without half of
/// this at both ends it touches the same squares, except those at its ends.
bool Touches(const PlanePoint& end, const PlanePoint& corner)
{
  const std::int32_t parts = 2 * ChebyshevLength(end);
  const PlanePoint from = end;
  const PlanePoint to{ end.X * (parts - 1), end.Y * (parts - 1) };
  const PlanePoint low{ corner.X * parts, corner.Y * parts };
  const PlanePoint high{ low.X + parts, low.Y + parts };
  const auto x = std::minmax(from.X, to.X);
  const auto y = std::minmax(from.Y, to.Y);
  if (x.second < low.X || x.first > high.X || y.second < low.Y || y.first > high.Y)
  {
    return false;
  }
  const std::array<int, 4> sides = { Sign(SignedArea(from, to, low)), Sign(SignedArea(from, to, { high.X, low.Y })),
    Sign(SignedArea(from, to, high)), Sign(SignedArea(from, to, { low.X, high.Y })) };
  return *std::min_element(sides.begin(), sides.end()) <= 0 && *std::max_element(sides.begin(), sides.end()) >= 0;
}

void FindColumns(const HopVectors& hops, LongHop& hop)
{
  const PlanePoint& end = hops.Vector(hop.Hop);
  for (HopId other = 0; other < hops.Size(); ++other)
  {
    const PlanePoint& column = hops.Vector(other);
    if (OnOpenSegment({ 0, 0 }, end, column))
    {
      hop.Over.push_back(hops.Offset(other));
      hop.ColumnsOver.push_back(column);
    }
    if (IsNearer(column, end) && IsNearer(Difference(end, column), end))
    {
      hop.Between.push_back(hops.Offset(other));
    }
  }
}

void FindSquares(const HopVectors& hops, LongHop& hop)
{
  const PlanePoint& end = hops.Vector(hop.Hop);
  std::vector<std::pair<std::int32_t, Gate>> gates;
  for (std::int32_t y = -1; y <= end.Y; ++y)
  {
    for (std::int32_t x = std::min(0, end.X) - 1; x <= std::max(0, end.X) + 1; ++x)
    {
      const PlanePoint column{ x, y };
      if (Touches(end, column))
      {
        hop.Squares.push_back(hops.OffsetOf(column));
      }
      const std::int32_t distance = std::min(ChebyshevLength(column), ChebyshevLength(Difference(end, column)));
      for (std::size_t step = 0; step < NeighbourSteps.size(); ++step)
      {
        const PlanePoint other = Sum(column, NeighbourSteps[step]);
        if (ProperlyCross({ 0, 0 }, end, column, other))
        {
          gates.push_back({ distance, { column, step, hops.OffsetOf(column), hops.OffsetOf(other) } });
        }
      }
    }
  }
  std::stable_sort(gates.begin(), gates.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(
    gates.begin(), gates.end(), std::back_inserter(hop.Gates), [](const auto& gate) { return gate.second; });
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsSweptBefore(const PlanePoint& a, const PlanePoint& b)
{
  if (IsInFirstHalf(a) != IsInFirstHalf(b))
  {
    return IsInFirstHalf(a);
  }
  const std::int64_t turn = std::int64_t(a.X) * b.Y - std::int64_t(a.Y) * b.X;
  return turn != 0 ? turn < 0 : SquaredLength(a) < SquaredLength(b);
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t ChebyshevLength(const PlanePoint& vector)
{
  return std::max(std::abs(vector.X), std::abs(vector.Y));
}

//----------------------------------------------------------------------------------------------------------------------
bool IsNearer(const PlanePoint& a, const PlanePoint& b)
{
  return ChebyshevLength(a) != ChebyshevLength(b) ? ChebyshevLength(a) < ChebyshevLength(b)
                                                  : SquaredLength(a) < SquaredLength(b);
}

//----------------------------------------------------------------------------------------------------------------------
HopVectors::HopVectors(int radius, std::int64_t rasterWidth)
  : MostColumns(radius)
  , RasterWidth(rasterWidth)
{
  assert(radius >= 1);
  for (std::int32_t y = -radius; y <= radius; ++y)
  {
    for (std::int32_t x = -radius; x <= radius; ++x)
    {
      if (x != 0 || y != 0)
      {
        this->Vectors.push_back({ x, y });
      }
    }
  }
  std::sort(this->Vectors.begin(), this->Vectors.end(), IsSweptBefore);
  this->Hops.assign(this->Vectors.size() + 1, NoHop); // The vector of length 0 has a slot, too.
  for (HopId hop = 0; hop < this->Size(); ++hop)
  {
    this->Hops[this->Slot(this->Vector(hop))] = hop;
  }
  for (const PlanePoint& vector : this->Vectors)
  {
    if (ChebyshevLength(vector) == 1)
    {
      this->Short.push_back(this->Find(vector));
    }
    this->Offsets.push_back(this->OffsetOf(vector));
    this->Opposites.push_back(this->Find({ -vector.X, -vector.Y }));
    this->NumbersOfParts.push_back(std::gcd(vector.X, vector.Y));
  }
}

//----------------------------------------------------------------------------------------------------------------------
LongHops::LongHops(const HopVectors& hops)
  : Radius(hops.Radius())
{
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    if (IsLongAndRising(hops.Vector(hop)))
    {
      LongHop longHop;
      longHop.Hop = hop;
      FindColumns(hops, longHop);
      FindSquares(hops, longHop);
      this->Hops.push_back(std::move(longHop));
    }
  }
  std::stable_sort(this->Hops.begin(), this->Hops.end(),
    [&hops](const LongHop& a, const LongHop& b)
    { return SquaredLength(hops.Vector(a.Hop)) < SquaredLength(hops.Vector(b.Hop)); });
  this->Numbers.assign(std::size_t((this->Radius + 1) * (2 * this->Radius + 1)), this->Size());
  for (std::size_t number = 0; number < this->Size(); ++number)
  {
    this->Numbers[this->Slot(hops.Vector(this->Hops[number].Hop))] = number;
  }
}
}
