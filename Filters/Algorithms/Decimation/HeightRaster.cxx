// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightRaster.h"

#include "Boundary/ColumnRaster.h"

#include <Eigen/Core>

#include <limits>

namespace SeismicHorizons
{
namespace
{
/// A row of columns, and a straight line over it.
struct Row
{
  using Four = Eigen::Array4d;

  const double* Heights; // nan where there is no point
  std::int32_t Size;
  double Start; // the height of the line at the first column
  double Slope; // and by how much it rises from each to the next one

  double Distance(std::int32_t n) const { return std::abs(this->Start + n * this->Slope - this->Heights[n]); }

  /// The larger of two, and the first where the second is nan.
  static double Larger(double a, double b) { return a < b ? b : a; }

  /// Vertically, at any column with a point; 0 when there is none. Four columns at a time, some of the last ones twice.
  double LargestDistance() const
  {
    if (this->Size < 4)
    {
      double largest = 0.0;
      for (std::int32_t n = 0; n < this->Size; ++n)
      {
        largest = Larger(largest, this->Distance(n));
      }
      return largest;
    }
    // Eigen's maximum is that of std::max: nan on the right is never larger.
    Four most = Four::Zero().max(this->DistancesFrom(this->Size - 4));
    for (std::int32_t n = 0; n + 4 < this->Size; n += 4)
    {
      most = most.max(this->DistancesFrom(n));
    }
    return LargestOf(most);
  }

  /// Adds powers of the distances as well, each column once.
  template <int Power>
  double LargestDistance(double perUnit, double& sum) const
  {
    Four most = Four::Zero();
    Four sums = Four::Zero();
    std::int32_t n = 0;
    for (; n + 4 <= this->Size; n += 4)
    {
      const Four distances = Four::Zero().max(this->DistancesFrom(n));
      most = most.max(distances);
      sums += Raised<Power, Four>(distances * perUnit);
    }
    double largest = LargestOf(most);
    double rest = 0.0;
    for (; n < this->Size; ++n)
    {
      const double distance = Larger(0.0, this->Distance(n));
      largest = Larger(largest, distance);
      rest += Raised<Power, double>(distance * perUnit);
    }
    sum += (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest;
    return largest;
  }

  template <int Power, typename Number>
  static Number Raised(const Number& number)
  {
    const Number square = number * number;
    return Power == 2 ? square : Number(square * square);
  }

  static double LargestOf(const Four& four) { return Larger(Larger(four[0], four[1]), Larger(four[2], four[3])); }

  Four DistancesFrom(std::int32_t n) const
  {
    const Four columns = Four(0.0, 1.0, 2.0, 3.0) + double(n);
    return (this->Start + columns * this->Slope - Eigen::Map<const Four>(this->Heights + n)).abs();
  }

  /// The first column at that distance.
  std::int32_t Find(double distance) const
  {
    std::int32_t n = 0;
    while (n + 1 < this->Size && this->Distance(n) != distance)
    {
      ++n;
    }
    return n;
  }
};
}

//----------------------------------------------------------------------------------------------------------------------
HeightRaster::HeightRaster(
  const std::vector<PointId>& points, const std::vector<PlanePoint>& columns, const std::vector<double>& heights)
{
  for (const PointId point : points)
  {
    this->Box.Add(columns[std::size_t(point)]);
  }
  this->Width = std::int64_t(this->Box.Greatest.X) - this->Box.Least.X + 1;
  const std::int64_t rows = std::int64_t(this->Box.Greatest.Y) - this->Box.Least.Y + 1;
  this->Points.assign(std::size_t(this->Width * rows), NoPoint);
  this->Heights.assign(this->Points.size(), std::numeric_limits<double>::quiet_NaN());
  for (const PointId point : points)
  {
    const PlanePoint& column = columns[std::size_t(point)];
    const std::size_t place = std::size_t(this->Place(column.X, column.Y));
    if (this->Points[place] != NoPoint)
    {
      throw SameColumnError(this->Points[place], point, column);
    }
    this->Points[place] = point;
    this->Heights[place] = heights[std::size_t(point)];
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Along a row the weights of b and c change by the same amount from column to column, and are whole numbers: what is
// lost to rounding is some units in the last place of the heights.
template <typename RowMeasure>
HeightError HeightRaster::MeasureRows(const RaisedTriangle& triangle, RowMeasure&& measure) const
{
  const RaisedPoint& a = triangle[0];
  const RaisedPoint& b = triangle[1];
  const RaisedPoint& c = triangle[2];
  const double bRise = b.Height - a.Height;
  const double cRise = c.Height - a.Height;
  const double perArea = 1.0 / double(SignedArea(a.Column, b.Column, c.Column));
  const double slope =
    (bRise * (double(c.Column.Y) - a.Column.Y) - cRise * (double(b.Column.Y) - a.Column.Y)) * perArea;
  HeightError error;
  std::int64_t worst = -1;
  ForEachRow({ a.Column, b.Column, c.Column },
    [&](std::int32_t y, std::int32_t first, std::int32_t last)
    {
      const PlanePoint start{ first, y };
      const double rise =
        bRise * double(SignedArea(c.Column, a.Column, start)) + cRise * double(SignedArea(a.Column, b.Column, start));
      const std::int64_t place = this->Place(first, y);
      const Row row{ this->Heights.data() + place, last - first + 1, a.Height + rise * perArea, slope };
      const double largest = measure(row, error.Sum);
      if (largest > error.Largest)
      {
        error.Largest = largest;
        worst = place + row.Find(largest);
      }
    });
  error.Point = worst < 0 ? NoPoint : this->Points[std::size_t(worst)];
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightRaster::Measure(const RaisedTriangle& triangle, const ErrorPower& power) const
{
  const double perUnit = 1.0 / power.Unit;
  switch (power.Power)
  {
    case 2:
      return this->MeasureRows(
        triangle, [perUnit](const Row& row, double& sum) { return row.LargestDistance<2>(perUnit, sum); });
    case 4:
      return this->MeasureRows(
        triangle, [perUnit](const Row& row, double& sum) { return row.LargestDistance<4>(perUnit, sum); });
    default:
      return this->MeasureRows(triangle, [](const Row& row, double&) { return row.LargestDistance(); });
  }
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightRaster::MeasureSide(
  const RaisedPoint& from, const RaisedPoint& to, const std::vector<unsigned char>& marks) const
{
  HeightError error;
  this->ForEachCrossing(from, to,
    [&](const Crossing& crossing)
    {
      const double distance = std::abs(crossing.Error);
      if (distance > error.Largest)
      {
        const bool isFirstNear = crossing.PartOfColumn < 0.5;
        const PointId near = this->Points[std::size_t(isFirstNear ? crossing.Place : crossing.Beyond)];
        const PointId far = this->Points[std::size_t(isFirstNear ? crossing.Beyond : crossing.Place)];
        const PointId point = marks[std::size_t(near)] == 0 ? near : far;
        error = marks[std::size_t(point)] == 0 ? HeightError{ distance, point } : error;
      }
    });
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightRaster::MeasureCrossings(
  const RaisedPoint& from, const RaisedPoint& to, const ErrorPower& power) const
{
  HeightError error;
  this->ForEachCrossing(from, to,
    [&](const Crossing& crossing)
    {
      const double distance = std::abs(crossing.Error);
      error.Largest = std::max(error.Largest, distance);
      error.Sum += power.Raise(distance);
    });
  return error;
}
}
