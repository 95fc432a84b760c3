// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums and ranges of random stars are those of a plain loop over all columns, on any processor to the last bit.

#include "Filters/Algorithms/Decimation/StarKernels.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int Side = 40;
constexpr double Bound = 1.5;

struct Column
{
  std::int64_t Place;
  double Error;
  double Weight;
};

template <typename Real>
class RandomStar
{
public:
  explicit RandomStar(Patches::Random& random)
  {
    for (int place = 0; place < Side * Side + 8; ++place)
    {
      this->Heights.push_back(
        random.Chance(0.1) ? std::numeric_limits<Real>::quiet_NaN() : HeightNear(place % Side, random));
    }
    const StarCorner<Real> centre = { random.Below(16) + 12, random.Below(16) + 12, HeightNear(20, random) };
    const int corners = 3 + random.Below(6);
    for (int n = 0; n < corners; ++n)
    {
      const double angle = 8.0 * std::atan(1.0) * (n + 0.6 * random.Fraction()) / corners;
      const double length = 3.0 + 8.0 * random.Fraction();
      this->Ring.push_back({ std::int32_t(std::lround(centre.X + length * std::cos(angle))),
        std::int32_t(std::lround(centre.Y + length * std::sin(angle))),
        HeightNear(centre.X + length * std::cos(angle), random) });
    }
    this->Own = { centre, this->Ring.data(), corners, random.Chance(0.7) };
  }

  HeightGrid<Real> Grid() const { return { this->Heights.data(), Side }; }

  /// Returns false for a triangle that is not counter-clockwise.
  bool FindColumns(std::vector<Column>& found) const
  {
    for (int n = 0; n < this->Own.NumberOfTriangles(); ++n)
    {
      if (!this->FindColumns(this->Own.Centre, this->Own.Ring[n], this->Own.Next(n), found))
      {
        return false;
      }
    }
    return true;
  }

  Star<Real> Own;

private:
  using Corner = StarCorner<Real>;

  /// A slope with noise.
  static Real HeightNear(double x, Patches::Random& random) { return Real(0.1 * x + 2.4 * random.Fraction()); }

  static double Area(const Corner& a, const Corner& b, int x, int y)
  {
    return double(b.X - a.X) * (y - a.Y) - double(b.Y - a.Y) * (x - a.X);
  }

  bool FindColumns(const Corner& p, const Corner& a, const Corner& b, std::vector<Column>& found) const
  {
    const double area = Area(p, a, b.X, b.Y);
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double ofP = Area(a, b, x, y);
        const double ofA = Area(b, p, x, y);
        const double ofB = Area(p, a, x, y);
        const double own = double(this->Heights[std::size_t(y * Side + x)]);
        if (ofP >= 0.0 && ofA >= 0.0 && ofB >= 0.0 && !std::isnan(own))
        {
          found.push_back(
            { y * Side + x, (ofP * p.Height + ofA * a.Height + ofB * b.Height) / area - own, ofP / area });
        }
      }
    }
    return area > 0.0;
  }

  std::vector<Real> Heights;
  std::vector<Corner> Ring;
};

bool IsNear(double a, double b, double tolerance)
{
  return std::abs(a - b) <= tolerance * std::max({ 1.0, std::abs(a), std::abs(b) });
}

template <typename Real>
void TestStar(const RandomStar<Real>& star, const std::vector<Column>& columns)
{
  constexpr double tolerance = 256.0 * std::numeric_limits<Real>::epsilon();
  const StarKernels<Real>& kernels = KernelsForStars<Real>();
  const StarKernels<Real>& forAny = KernelsForStars<Real>(true);
  double lowest = -1e30;
  double highest = 1e30;
  for (const Column& column : columns)
  {
    if (column.Weight > 0.0)
    {
      lowest = std::max(lowest, (-Bound - column.Error) / column.Weight);
      highest = std::min(highest, (Bound - column.Error) / column.Weight);
    }
  }
  const FreeRange<Real> range = kernels.FindRange(star.Grid(), star.Own, Bound);
  CHECK_EQUAL(range.IsEmpty(), lowest > highest);
  CHECK(lowest > highest || (IsNear(range.Lowest, lowest, tolerance) && IsNear(range.Highest, highest, tolerance)));
  const FreeRange<Real> other = forAny.FindRange(star.Grid(), star.Own, Bound);
  CHECK(range.Lowest == other.Lowest && range.Highest == other.Highest && range.LowestAt == other.LowestAt &&
    range.HighestAt == other.HighestAt);
  for (const int power : { 2, 4 })
  {
    const StarSums sums = kernels.SumStar(star.Grid(), star.Own, power, Real(1.0 / Bound));
    CHECK(sums.Sums == forAny.SumStar(star.Grid(), star.Own, power, Real(1.0 / Bound)).Sums);
    for (const double move : { 0.0, -0.7, 2.0 })
    {
      double sum = 0.0;
      for (const Column& column : columns)
      {
        sum += std::pow(column.Error / Bound + move * column.Weight, power);
      }
      CHECK(IsNear(sums.At(move), sum, tolerance));
    }
    const double best = sums.FindBest(-3.0, 3.0);
    CHECK(best >= -3.0 && best <= 3.0);
    CHECK(sums.At(best) <= std::min({ sums.At(best - 0.1), sums.At(best + 0.1) }) + 1e-3 * sums.At(best) ||
      std::abs(best) == 3.0);
  }
}

/// Of all columns of a star, two exclude each other if it is impossible, and none does otherwise.
template <typename Real>
void TestCritical(const RandomStar<Real>& star)
{
  const StarKernels<Real>& kernels = KernelsForStars<Real>();
  const FreeRange<Real> range = kernels.FindRange(star.Grid(), star.Own, Bound);
  CriticalColumns<Real> columns;
  columns.X.fill(Real(-1000)); // in no triangle
  columns.Y.fill(Real(star.Own.Centre.Y));
  columns.Height.fill(star.Own.Centre.Height);
  int n = 0;
  for (const std::int64_t place : { range.LowestAt, range.HighestAt })
  {
    columns.X[n] = Real(place % Side);
    columns.Y[n] = Real(place / Side);
    columns.Height[n++] = star.Grid().Heights[place];
  }
  const bool areBound = std::abs(range.Lowest) < 1e20 && std::abs(range.Highest) < 1e20;
  CHECK(!areBound || kernels.IsPossible(columns, star.Own, true, Bound) == !range.IsEmpty());
}

template <typename Real>
void TestRandomStars()
{
  Patches::Random random(31);
  int stars = 0;
  int possible = 0;
  for (int n = 0; n < 3000; ++n)
  {
    const RandomStar<Real> star(random);
    std::vector<Column> columns;
    if (star.FindColumns(columns))
    {
      ++stars;
      TestStar(star, columns);
      TestCritical(star);
      possible += KernelsForStars<Real>().FindRange(star.Grid(), star.Own, Bound).IsEmpty() ? 0 : 1;
    }
  }
  CHECK(stars > 1000 && possible > 100 && stars - possible > 100);
}
}

int TestStarKernels(int, char*[])
{
  TestRandomStars<float>();
  TestRandomStars<double>();
  return Check::Result();
}
