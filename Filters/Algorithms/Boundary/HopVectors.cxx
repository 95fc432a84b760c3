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
/// Whether a sweep from the south meets the end of a vector in its first half, which is the west.
bool IsInFirstHalf(const PlanePoint& vector)
{
  return vector.X < 0 || (vector.X == 0 && vector.Y < 0);
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
  this->Hops.assign(this->Vectors.size() + 1, NoHop); // the vector of length 0 has a slot, too
  for (HopId hop = 0; hop < this->Size(); ++hop)
  {
    this->Hops[this->Slot(this->Vector(hop))] = hop;
  }
  for (const PlanePoint& vector : this->Vectors)
  {
    this->Offsets.push_back(this->OffsetOf(vector));
    this->Opposites.push_back(this->Find({ -vector.X, -vector.Y }));
    this->NumbersOfParts.push_back(std::gcd(vector.X, vector.Y));
  }
}
}
