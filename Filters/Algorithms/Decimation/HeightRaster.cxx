// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightRaster.h"

#include "Common/ColumnIndex.h"

#include <Eigen/Core>

#include <limits>

namespace SeismicHorizons
{
namespace
{
// Four neighbouring columns of a row.
using Four = Eigen::Array4d;

// Triangles up to so many columns wide are measured four columns at a time, each with its weights: most rows are so
// short that finding their ends would take longer.
constexpr std::int32_t MostColumnsOfBox = 8;

// What no distance is above.
constexpr double Huge = 1e300;

/// The larger of two, and the first where the second is nan.
double Larger(double a, double b)
{
  return a < b ? b : a;
}

/// The larger of each number and 0, which is 0 where the number is nan. Eigen's maximum is that of the processor unless
/// it is told to prefer numbers: with NEON it would be nan, and with SSE depend on the order.
Four AtLeastZero(const Four& four)
{
  return Four::Zero().binaryExpr(four, Eigen::internal::scalar_max_op<double, double, Eigen::PropagateNumbers>());
}

double LargestOf(const Four& four)
{
  return Larger(Larger(four[0], four[1]), Larger(four[2], four[3]));
}

double SumOf(const Four& four)
{
  return (four[0] + four[1]) + (four[2] + four[3]);
}

/// Which is 0, 2 or 4.
template <int Power, typename Number>
Number RaiseTo(const Number& number)
{
  const Number square = number * number;
  return Power == 2 ? square : Number(square * square);
}

/// A row of columns, and a straight line over it.
struct Row
{
  const double* Heights; // nan where there is no point
  std::int32_t Size;
  double Start; // the height of the line at the first column
  double Slope; // and by how much it rises from each to the next one

  double Distance(std::int32_t n) const { return std::abs(this->Start + n * this->Slope - this->Heights[n]); }

  Four DistancesFrom(std::int32_t n) const
  {
    const Four columns = Four(0.0, 1.0, 2.0, 3.0) + double(n);
    return AtLeastZero((this->Start + columns * this->Slope - Eigen::Map<const Four>(this->Heights + n)).abs());
  }

  /// The largest vertical distance at a column with a point, 0 when there is none; adds powers of all of them.
  template <int Power>
  double Measure(double perUnit, double& sum) const
  {
    if (Power == 0 && this->Size >= 4)
    {
      return this->LargestDistance();
    }
    Four most = Four::Zero();
    Four sums = Four::Zero();
    std::int32_t n = 0;
    for (; n + 4 <= this->Size; n += 4)
    {
      const Four distances = this->DistancesFrom(n);
      most = most.max(distances);
      sums += RaiseTo<Power, Four>(distances * perUnit);
    }
    double largest = LargestOf(most);
    double rest = 0.0;
    for (; n < this->Size; ++n)
    {
      const double distance = Larger(0.0, this->Distance(n));
      largest = Larger(largest, distance);
      rest += RaiseTo<Power, double>(distance * perUnit);
    }
    sum += SumOf(sums) + rest;
    return largest;
  }

  /// Of four columns at least; of the last ones some twice.
  double LargestDistance() const
  {
    Four most = this->DistancesFrom(this->Size - 4);
    for (std::int32_t n = 0; n + 4 < this->Size; n += 4)
    {
      most = most.max(this->DistancesFrom(n));
    }
    return LargestOf(most);
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

/// The plane of a triangle, and how its weights change from column to column. Weights are twice the areas of the
/// triangles with the opposite sides, whole numbers: exact.
struct Plane
{
  explicit Plane(const RaisedTriangle& triangle)
    : A(triangle[0])
    , B(triangle[1])
    , C(triangle[2])
    , BRise(this->B.Height - this->A.Height)
    , CRise(this->C.Height - this->A.Height)
    , Area(double(SignedArea(this->A.Column, this->B.Column, this->C.Column)))
    , PerArea(1.0 / this->Area)
  {
  }

  double WeightOfB(const PlanePoint& place) const { return double(SignedArea(this->C.Column, this->A.Column, place)); }
  double WeightOfC(const PlanePoint& place) const { return double(SignedArea(this->A.Column, this->B.Column, place)); }
  double HeightAt(const PlanePoint& place) const
  {
    return this->A.Height +
      (this->BRise * this->WeightOfB(place) + this->CRise * this->WeightOfC(place)) * this->PerArea;
  }
  /// From column to column of a row, and from row to row.
  double StepOfB() const { return double(this->C.Column.Y) - this->A.Column.Y; }
  double StepOfC() const { return double(this->A.Column.Y) - this->B.Column.Y; }
  double RowStepOfB() const { return double(this->A.Column.X) - this->C.Column.X; }
  double RowStepOfC() const { return double(this->B.Column.X) - this->A.Column.X; }
  double Slope() const { return (this->BRise * this->StepOfB() + this->CRise * this->StepOfC()) * this->PerArea; }

  const RaisedPoint& A;
  const RaisedPoint& B;
  const RaisedPoint& C;
  double BRise;
  double CRise;
  double Area;
  double PerArea;
};
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::MakeColumns()
{
  this->Width = std::int64_t(this->Box.Greatest.X) - this->Box.Least.X + 1;
  const std::int64_t rows = std::int64_t(this->Box.Greatest.Y) - this->Box.Least.Y + 1;
  this->Points.assign(std::size_t(this->Width * rows), NoPoint);
  this->Heights.assign(this->Points.size() + 3, std::numeric_limits<double>::quiet_NaN()); // read four at a time
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::Add(PointId point, const PlanePoint& column, double height)
{
  const std::size_t place = std::size_t(this->Place(column.X, column.Y));
  if (this->Points[place] != NoPoint)
  {
    throw SameColumnError(this->Points[place], point, column);
  }
  this->Points[place] = point;
  this->Heights[place] = height;
}

//----------------------------------------------------------------------------------------------------------------------
// Along a row the weights of b and c change by the same amount from column to column, and are whole numbers: what is
// lost to rounding is some units in the last place of the heights.
template <int Power>
HeightError HeightRaster::MeasureRows(const RaisedTriangle& triangle, double perUnit) const
{
  const Plane plane(triangle);
  const double slope = plane.Slope();
  HeightError error;
  std::int64_t worst = -1;
  ForEachRow({ plane.A.Column, plane.B.Column, plane.C.Column },
    [&](std::int32_t y, std::int32_t first, std::int32_t last)
    {
      const std::int64_t place = this->Place(first, y);
      const Row row{ this->Heights.data() + place, last - first + 1, plane.HeightAt({ first, y }), slope };
      const double largest = row.Measure<Power>(perUnit, error.Sum);
      if (largest > error.Largest)
      {
        error.Largest = largest;
        worst = place + row.Find(largest);
      }
    });
  error.Point = worst < 0 ? NoPoint : this->Points[worst];
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
// All columns of the bounding box, four at a time; those outside have a negative weight.
template <int Power>
HeightError HeightRaster::MeasureBox(const RaisedTriangle& triangle, const PlaneBox& box, double perUnit) const
{
  const Plane plane(triangle);
  const Four columns(0.0, 1.0, 2.0, 3.0);
  Four sums = Four::Zero();
  HeightError error;
  std::int64_t worst = -1;
  for (std::int32_t x = box.Least.X; x <= box.Greatest.X; x += 4)
  {
    Four b = plane.WeightOfB({ x, box.Least.Y }) + columns * plane.StepOfB();
    Four c = plane.WeightOfC({ x, box.Least.Y }) + columns * plane.StepOfC();
    for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
    {
      const std::int64_t place = this->Place(x, y);
      const Four heights = plane.A.Height + (plane.BRise * b + plane.CRise * c) * plane.PerArea;
      const Four least = b.min(c).min(plane.Area - b - c); // of the three weights
      Four distances = AtLeastZero((heights - Eigen::Map<const Four>(this->Heights.data() + place)).abs());
      distances = Four::Zero().max(distances.min((least + 0.5) * Huge));
      sums += RaiseTo<Power, Four>(distances * perUnit);
      const double largest = LargestOf(distances);
      if (largest > error.Largest)
      {
        error.Largest = largest;
        worst = place;
        for (int n = 0; distances[n] != largest; ++n)
        {
          ++worst;
        }
      }
      b += plane.RowStepOfB();
      c += plane.RowStepOfC();
    }
  }
  error.Sum = Power == 0 ? 0.0 : SumOf(sums);
  error.Point = worst < 0 ? NoPoint : this->Points[worst];
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
template <int Power>
HeightError HeightRaster::Measure(const RaisedTriangle& triangle, double perUnit) const
{
  PlaneBox box;
  for (const RaisedPoint& corner : triangle)
  {
    box.Add(corner.Column);
  }
  return box.Greatest.X - box.Least.X < MostColumnsOfBox ? this->MeasureBox<Power>(triangle, box, perUnit)
                                                         : this->MeasureRows<Power>(triangle, perUnit);
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightRaster::Measure(const RaisedTriangle& triangle, const ErrorPower& power) const
{
  const double perUnit = 1.0 / power.Unit;
  switch (power.Power)
  {
    case 2:
      return this->Measure<2>(triangle, perUnit);
    case 4:
      return this->Measure<4>(triangle, perUnit);
    default:
      return this->Measure<0>(triangle, perUnit);
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
        const PointId near = this->Points[isFirstNear ? crossing.Place : crossing.Beyond];
        const PointId far = this->Points[isFirstNear ? crossing.Beyond : crossing.Place];
        const PointId point = marks[near] == 0 ? near : far;
        error = marks[point] == 0 ? HeightError{ distance, point } : error;
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
