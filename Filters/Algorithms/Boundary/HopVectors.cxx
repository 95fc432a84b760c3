// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HopVectors.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
/// South and all that leads to the west comes in the first half of a sweep.
bool IsInFirstHalf(const PlanePoint& vector)
{
  return vector.X < 0 || (vector.X == 0 && vector.Y < 0);
}
}

//----------------------------------------------------------------------------------------------------------------------
bool SweepsBefore(const PlanePoint& a, const PlanePoint& b)
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
HopVectors::HopVectors(int radius, std::int64_t rowLength)
  : K(radius)
  , RowLength(rowLength)
{
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
  std::sort(this->Vectors.begin(), this->Vectors.end(), SweepsBefore);
  this->Numbers.assign(this->Vectors.size() + 1, NoHop);
  for (HopId hop = 0; hop < this->Size(); ++hop)
  {
    this->Offsets.push_back(this->OffsetOf(this->Vector(hop)));
    this->Numbers[this->Slot(this->Vector(hop))] = hop;
  }
  for (const PlanePoint& vector : this->Vectors)
  {
    this->Opposites.push_back(this->Find({ -vector.X, -vector.Y }));
    this->NumbersOfParts.push_back(std::gcd(vector.X, vector.Y));
  }
}
}
