// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StarKernels.h"

#include "Common/Base/Portable.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

// Vectors are passed between functions that are one after inlining.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace SeismicHorizons
{
namespace StarLanes // whose short names other files have, too
{
namespace
{
constexpr int Columns = 8;

template <typename Real>
using Numbers = typename Eight<Real>::Numbers;

/// As wide as numbers: -1 where a comparison is true, else 0.
template <typename Real>
using MarkOf = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
template <typename Real>
using Marks = typename Eight<MarkOf<Real>>::Numbers;

template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER Numbers<Real> All(Real value)
{
  return Numbers<Real>{} + value;
}

template <typename Vector>
SEISMICHORIZONS_PART_OF_CALLER Vector Count()
{
  return Vector{ 0, 1, 2, 3, 4, 5, 6, 7 };
}

/// Zero where the mark is not set, even for NaN.
template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER Numbers<Real> Only(const Marks<Real>& marks, const Numbers<Real>& numbers)
{
  return marks ? numbers : Numbers<Real>{};
}

template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER Real Sum(const Numbers<Real>& a)
{
  return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
}

template <typename Vector>
SEISMICHORIZONS_PART_OF_CALLER int Greatest(const Vector& a)
{
  int n = 0;
  for (int k = 1; k < Columns; ++k)
  {
    n = a[k] > a[n] ? k : n;
  }
  return n;
}

template <typename Vector>
SEISMICHORIZONS_PART_OF_CALLER int Least(const Vector& a)
{
  int n = 0;
  for (int k = 1; k < Columns; ++k)
  {
    n = a[k] < a[n] ? k : n;
  }
  return n;
}

template <typename Vector>
SEISMICHORIZONS_PART_OF_CALLER bool IsAny(const Vector& marks)
{
  std::array<std::uint64_t, sizeof(Vector) / 8> bits;
  std::memcpy(bits.data(), &marks, sizeof(bits));
  std::uint64_t all = 0;
  for (const std::uint64_t one : bits)
  {
    all |= one;
  }
  return all != 0;
}

template <typename Corner>
SEISMICHORIZONS_PART_OF_CALLER double Area(const Corner& a, const Corner& b, std::int32_t x, std::int32_t y)
{
  return double(
    (std::int64_t(b.X) - a.X) * (std::int64_t(y) - a.Y) - (std::int64_t(b.Y) - a.Y) * (std::int64_t(x) - a.X));
}

// ---- Columns of a triangle -----------------------------------------------------------------------------------------
/// Weights are twice the areas opposite to the corners, integers that floats hold.
template <typename Real>
struct RowWeights
{
  Real OfA;
  Real OfB;
  Real OfP;

  /// Columns from the first one of a row between which no weight is negative, or one too many.
  SEISMICHORIZONS_PART_OF_CALLER void Cut(Real weight, Real step, Real& first, Real& last) const
  {
    if (step > 0)
    {
      first = std::max(first, -weight / step);
    }
    else if (step < 0)
    {
      last = std::min(last, -weight / step);
    }
    else if (weight < 0)
    {
      last = -1;
    }
  }
};

/// Calls visit(errors, weights of p from 0 to 1, marks of columns inside that have points, place of the first).
template <typename Real, typename Visitor>
SEISMICHORIZONS_PART_OF_CALLER void ForEachEight(const HeightGrid<Real>& grid, const StarCorner<Real>& p,
  const StarCorner<Real>& a, const StarCorner<Real>& b, const Visitor& visit)
{
  using Unaligned = typename Eight<Real>::Unaligned;
  const std::int32_t left = std::min({ p.X, a.X, b.X });
  const std::int32_t right = std::max({ p.X, a.X, b.X });
  const std::int32_t low = std::min({ p.Y, a.Y, b.Y });
  const std::int32_t high = std::max({ p.Y, a.Y, b.Y });
  const Real area = Real(Area(p, a, b.X, b.Y));
  const Real perArea = Real(1) / area;
  const RowWeights<Real> alongX = { Real(b.Y - p.Y), Real(p.Y - a.Y), Real(a.Y - b.Y) };
  const RowWeights<Real> alongY = { Real(p.X - b.X), Real(a.X - p.X), Real(b.X - a.X) };
  RowWeights<Real> start = { Real(Area(b, p, left, low)), Real(Area(p, a, left, low)), Real(Area(a, b, left, low)) };
  const Real riseOfA = (a.Height - p.Height) * perArea;
  const Real riseOfB = (b.Height - p.Height) * perArea;
  const Numbers<Real> count = Count<Numbers<Real>>();
  std::int64_t place = grid.Place(left, low);
  const std::int32_t width = right - left;
  const auto look = [&](std::int32_t first) __attribute__((always_inline))
  {
    const Numbers<Real> columns = count + Real(first);
    const Numbers<Real> weightOfA = start.OfA + columns * alongX.OfA;
    const Numbers<Real> weightOfB = start.OfB + columns * alongX.OfB;
    const Numbers<Real> weightOfP = start.OfP + columns * alongX.OfP;
    const Numbers<Real> heights = *reinterpret_cast<const Unaligned*>(grid.Heights + place + first);
    const Marks<Real> isIn =
      (weightOfA >= Real(0)) & (weightOfB >= Real(0)) & (weightOfP >= Real(0)) & (heights == heights);
    visit(p.Height + riseOfA * weightOfA + riseOfB * weightOfB - heights, weightOfP * perArea, isIn, place + first);
  };
  for (std::int32_t y = low; y <= high; ++y)
  {
    if (width < Columns)
    {
      look(0);
    }
    else
    {
      Real first = 0;
      Real last = Real(width);
      start.Cut(start.OfA, alongX.OfA, first, last);
      start.Cut(start.OfB, alongX.OfB, first, last);
      start.Cut(start.OfP, alongX.OfP, first, last);
      constexpr Real rounding = Real(0.01);
      const auto end = first <= last + 1 ? std::int32_t(last + (1 + rounding)) : 0;
      for (auto n = std::int32_t(first <= last + 1 ? std::max(Real(0), first - rounding) : 0); n < end; n += Columns)
      {
        look(n);
      }
    }
    start.OfA += alongY.OfA;
    start.OfB += alongY.OfB;
    start.OfP += alongY.OfP;
    place += grid.Width;
  }
}

// ---- Kernels -------------------------------------------------------------------------------------------------------
template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER Real SumTriangleHere(const HeightGrid<Real>& grid,
  const typename StarKernels<Real>::Triangle& triangle, int power, Real perUnit, Real bound)
{
  Numbers<Real> sums = {};
  Numbers<Real> largest = {};
  ForEachEight(
    grid, triangle[0], triangle[1], triangle[2],
    [&](const Numbers<Real>& errors, const Numbers<Real>&, const Marks<Real>& isIn, std::int64_t)
      __attribute__((always_inline)) {
        const Numbers<Real> scaled = Only<Real>(isIn, errors) * perUnit;
        const Numbers<Real> squares = scaled * scaled;
        sums += power == 2 ? squares : squares * squares;
        largest = largest > squares ? largest : squares;
      });
  const Real most = bound * perUnit;
  return largest[Greatest(largest)] > most * most ? std::numeric_limits<Real>::infinity() : Sum<Real>(sums);
}

// Columns of the ring have no weight of the centre.
template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER FreeRange<Real> FindRangeHere(
  const HeightGrid<Real>& grid, const Star<Real>& star, Real bound)
{
  constexpr Real leastWeight = Real(1e-6);
  constexpr Real noZero = Real(1e-30);
  constexpr Real farthest = Real(1e30);
  Numbers<Real> lowest = All(-farthest);
  Numbers<Real> highest = All(farthest);
  Marks<Real> lowestAt = {};
  Marks<Real> highestAt = {};
  const Marks<Real> count = Count<Marks<Real>>();
  const int size = star.NumberOfTriangles();
  for (int n = 0; n < size; ++n)
  {
    ForEachEight(
      grid, star.Centre, star.Ring[n], star.Next(n),
      [&](const Numbers<Real>& errors, const Numbers<Real>& weights, const Marks<Real>& isIn, std::int64_t place)
        __attribute__((always_inline)) {
          const Marks<Real> isBound = isIn & (weights > leastWeight);
          const Numbers<Real> perWeight = Real(1) / (weights + noZero);
          const Numbers<Real> low = (-bound - errors) * perWeight;
          const Numbers<Real> high = (bound - errors) * perWeight;
          const Marks<Real> isLow = isBound & (low > lowest);
          const Marks<Real> isHigh = isBound & (high < highest);
          const Marks<Real> places = count + MarkOf<Real>(place);
          lowest = isLow ? low : lowest;
          highest = isHigh ? high : highest;
          lowestAt = isLow ? places : lowestAt;
          highestAt = isHigh ? places : highestAt;
        });
    const bool isLast = n + 1 == size;
    if (IsAny(lowest > highest) || isLast || n % 2 == 1)
    {
      const int atLowest = Greatest(lowest);
      const int atHighest = Least(highest);
      if (isLast || lowest[atLowest] > highest[atHighest])
      {
        return { lowest[atLowest], highest[atHighest], lowestAt[atLowest], highestAt[atHighest] };
      }
    }
  }
  return { -farthest, farthest, 0, 0 };
}

template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER std::array<Real, 2> SlopeOf(
  const StarCorner<Real>& p, const StarCorner<Real>& a, const StarCorner<Real>& b)
{
  const Real perArea = Real(1) / Real(Area(p, a, b.X, b.Y));
  const Real riseOfA = (a.Height - p.Height) * perArea;
  const Real riseOfB = (b.Height - p.Height) * perArea;
  return { riseOfA * Real(b.Y - p.Y) + riseOfB * Real(p.Y - a.Y),
    riseOfA * Real(p.X - b.X) + riseOfB * Real(a.X - p.X) };
}

template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER StarSums SumStarHere(
  const HeightGrid<Real>& grid, const Star<Real>& star, int power, Real perUnit)
{
  std::array<Numbers<Real>, 5> sums = {};
  std::array<Numbers<Real>, 2> descent = {};
  for (int n = 0; n < star.NumberOfTriangles(); ++n)
  {
    const std::array<Real, 2> slope = SlopeOf(star.Centre, star.Ring[n], star.Next(n));
    ForEachEight(
      grid, star.Centre, star.Ring[n], star.Next(n),
      [&](const Numbers<Real>& errors, const Numbers<Real>& allWeights, const Marks<Real>& isIn, std::int64_t)
        __attribute__((always_inline)) {
          const Numbers<Real> scaled = Only<Real>(isIn, errors) * perUnit;
          const Numbers<Real> weights = Only<Real>(isIn, allWeights);
          const Numbers<Real> squares = scaled * scaled;
          const Numbers<Real> products = scaled * weights;
          const Numbers<Real> ofWeights = weights * weights;
          if (power == 2)
          {
            sums[0] += squares;
            sums[1] += products;
            sums[2] += ofWeights;
            descent[0] += products * slope[0];
            descent[1] += products * slope[1];
          }
          else
          {
            const Numbers<Real> cubes = squares * products;
            sums[0] += squares * squares;
            sums[1] += cubes;
            descent[0] += cubes * slope[0];
            descent[1] += cubes * slope[1];
            sums[2] += products * products;
            sums[3] += products * ofWeights;
            sums[4] += ofWeights * ofWeights;
          }
        });
  }
  StarSums result;
  result.Power = power;
  for (std::size_t n = 0; n < sums.size(); ++n)
  {
    result.Sums[n] = double(Sum<Real>(sums[n]));
  }
  result.Descent = { double(Sum<Real>(descent[0])), double(Sum<Real>(descent[1])) };
  return result;
}

template <typename Real>
SEISMICHORIZONS_PART_OF_CALLER bool IsPossibleHere(
  const CriticalColumns<Real>& columns, const Star<Real>& star, bool isFree, Real bound)
{
  static_assert(CriticalColumns<Real>::Size == Columns, "they are read at once");
  using Unaligned = typename Eight<Real>::Unaligned;
  constexpr Real leastWeight = Real(1e-6);
  constexpr Real noZero = Real(1e-30);
  constexpr Real farthest = Real(1e30);
  const StarCorner<Real>& p = star.Centre;
  const Numbers<Real> x = *reinterpret_cast<const Unaligned*>(columns.X.data()) - Real(p.X);
  const Numbers<Real> y = *reinterpret_cast<const Unaligned*>(columns.Y.data()) - Real(p.Y);
  const Numbers<Real> heights = *reinterpret_cast<const Unaligned*>(columns.Height.data());
  Numbers<Real> lowest = All(-farthest);
  Numbers<Real> highest = All(farthest);
  Marks<Real> isFar = {};
  for (int n = 0; n < star.NumberOfTriangles(); ++n)
  {
    const StarCorner<Real>& a = star.Ring[n];
    const StarCorner<Real>& b = star.Next(n);
    const Real ax = Real(a.X - p.X);
    const Real ay = Real(a.Y - p.Y);
    const Real bx = Real(b.X - p.X);
    const Real by = Real(b.Y - p.Y);
    const Real area = ax * by - ay * bx;
    const Real perArea = Real(1) / area;
    const Numbers<Real> weightOfA = x * by - y * bx;
    const Numbers<Real> weightOfB = ax * y - ay * x;
    const Numbers<Real> weightOfP = area - weightOfA - weightOfB;
    const Marks<Real> isIn = (weightOfA >= Real(0)) & (weightOfB >= Real(0)) & (weightOfP >= Real(0));
    const Numbers<Real> errors =
      p.Height + (a.Height - p.Height) * perArea * weightOfA + (b.Height - p.Height) * perArea * weightOfB - heights;
    if (!isFree)
    {
      isFar |= isIn & ((errors > bound) | (errors < -bound));
      continue;
    }
    const Marks<Real> isBound = isIn & (weightOfP > leastWeight * area);
    const Numbers<Real> perWeight = area / (weightOfP + noZero);
    const Numbers<Real> low = (-bound - errors) * perWeight;
    const Numbers<Real> high = (bound - errors) * perWeight;
    lowest = isBound & (low > lowest) ? low : lowest;
    highest = isBound & (high < highest) ? high : highest;
  }
  return isFree ? lowest[Greatest(lowest)] <= highest[Least(highest)] : !IsAny(isFar);
}

// ---- For any processor, and for those with AVX2 --------------------------------------------------------------------
#define SEISMICHORIZONS_KERNELS(NAME, TARGET)                                                                          \
  template <typename Real>                                                                                             \
  struct NAME                                                                                                          \
  {                                                                                                                    \
    TARGET static Real SumTriangle(const HeightGrid<Real>& grid, const typename StarKernels<Real>::Triangle& triangle, \
      int power, Real perUnit, Real bound)                                                                             \
    {                                                                                                                  \
      return SumTriangleHere(grid, triangle, power, perUnit, bound);                                                   \
    }                                                                                                                  \
    TARGET static FreeRange<Real> FindRange(const HeightGrid<Real>& grid, const Star<Real>& star, Real bound)          \
    {                                                                                                                  \
      return FindRangeHere(grid, star, bound);                                                                         \
    }                                                                                                                  \
    TARGET static StarSums SumStar(const HeightGrid<Real>& grid, const Star<Real>& star, int power, Real perUnit)      \
    {                                                                                                                  \
      return SumStarHere(grid, star, power, perUnit);                                                                  \
    }                                                                                                                  \
    TARGET static bool IsPossible(                                                                                     \
      const CriticalColumns<Real>& columns, const Star<Real>& star, bool isFree, Real bound)                           \
    {                                                                                                                  \
      return IsPossibleHere(columns, star, isFree, bound);                                                             \
    }                                                                                                                  \
    static StarKernels<Real> Get() { return { &SumTriangle, &FindRange, &SumStar, &IsPossible }; }                     \
  };
SEISMICHORIZONS_KERNELS(ForAny, )
SEISMICHORIZONS_KERNELS(ForAvx2, SEISMICHORIZONS_WITH_AVX2)
#undef SEISMICHORIZONS_KERNELS
}
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
const StarKernels<Real>& KernelsForStars(bool isForAny)
{
  static const StarKernels<Real> forAny = StarLanes::ForAny<Real>::Get();
  static const StarKernels<Real> forAvx2 = StarLanes::ForAvx2<Real>::Get();
  return isForAny || !HasAvx2() ? forAny : forAvx2;
}

template const StarKernels<float>& KernelsForStars<float>(bool isForAny);
template const StarKernels<double>& KernelsForStars<double>(bool isForAny);

//----------------------------------------------------------------------------------------------------------------------
void StarSums::Add(double error, double weight, double times)
{
  for (int n = this->Power; n >= 0; --n)
  {
    double product = times;
    for (int factor = 0; factor < this->Power; ++factor)
    {
      product *= factor < n ? weight : error;
    }
    this->Sums[std::size_t(n)] += product;
  }
}

//----------------------------------------------------------------------------------------------------------------------
double StarSums::At(double move) const
{
  const auto& [a, b, c, d, e] = this->Sums;
  return this->Power == 2 ? a + move * (2.0 * b + move * c)
                          : a + move * (4.0 * b + move * (6.0 * c + move * (4.0 * d + move * e)));
}

//----------------------------------------------------------------------------------------------------------------------
double StarSums::FindBest(double lowest, double highest) const
{
  const auto& [a, b, c, d, e] = this->Sums;
  if (this->Power == 2)
  {
    return c > 0.0 ? std::clamp(-b / c, lowest, highest) : std::clamp(0.0, lowest, highest);
  }
  constexpr int mostSteps = 8;
  constexpr double enough = 1e-3;
  double move = std::clamp(0.0, lowest, highest);
  for (int step = 0; step < mostSteps; ++step)
  {
    const double slope = b + move * (3.0 * c + move * (3.0 * d + move * e));
    const double bend = 3.0 * (c + move * (2.0 * d + move * e));
    if (!(bend > 1e-12))
    {
      break;
    }
    const double before = move;
    move = std::clamp(move - slope / bend, lowest, highest);
    if (std::abs(move - before) < enough)
    {
      break;
    }
  }
  return move;
}
}
