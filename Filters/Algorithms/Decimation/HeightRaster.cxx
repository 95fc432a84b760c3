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
    return Larger(Larger(most[0], most[1]), Larger(most[2], most[3]));
  }

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

/// Calls visit(x, y, part, height) where a segment crosses the rows between its ends at no column: between x and x + 1,
/// that part of the way.
template <typename Visitor>
void ForEachCrossing(const PlanePoint& from, const PlanePoint& to, double fromHeight, double toHeight, Visitor&& visit)
{
  if (from.Y > to.Y)
  {
    ForEachCrossing(to, from, toHeight, fromHeight, visit);
    return;
  }
  SideWalk walk(from, to);
  for (std::int32_t y = from.Y + 1; y < to.Y; ++y)
  {
    walk.GoUp();
    if (!walk.IsAtColumn())
    {
      const double height = fromHeight + (toHeight - fromHeight) * (double(y) - from.Y) / (double(to.Y) - from.Y);
      visit(walk.AtOrLeft(), y, walk.PartOfColumn(), height);
    }
  }
}
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
HeightError HeightRaster::Measure(const RaisedTriangle& triangle) const
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
      const double largest = row.LargestDistance();
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
HeightError HeightRaster::MeasureSide(
  const RaisedPoint& from, const RaisedPoint& to, const std::vector<unsigned char>& marks) const
{
  HeightError error;
  // `part` is how far the crossing is from the first of two places to the second.
  const auto compare = [&](std::int64_t place, std::int64_t other, double part, double height)
  {
    const double line = this->Heights[std::size_t(place)] +
      part * (this->Heights[std::size_t(other)] - this->Heights[std::size_t(place)]);
    const double distance = std::abs(height - line); // nan where a column is empty, and then not larger
    if (distance > error.Largest)
    {
      const PointId near = this->Points[std::size_t(part < 0.5 ? place : other)];
      const PointId far = this->Points[std::size_t(part < 0.5 ? other : place)];
      const PointId point = marks[std::size_t(near)] == 0 ? near : far;
      error = marks[std::size_t(point)] == 0 ? HeightError{ distance, point } : error;
    }
  };
  const auto turn = [](const PlanePoint& column) { return PlanePoint{ column.Y, column.X }; };
  ForEachCrossing(from.Column, to.Column, from.Height, to.Height,
    [&](std::int32_t x, std::int32_t y, double part, double height)
    { compare(this->Place(x, y), this->Place(x + 1, y), part, height); });
  ForEachCrossing(turn(from.Column), turn(to.Column), from.Height, to.Height,
    [&](std::int32_t y, std::int32_t x, double part, double height)
    { compare(this->Place(x, y), this->Place(x, y + 1), part, height); });
  return error;
}
}
