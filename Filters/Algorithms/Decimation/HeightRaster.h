// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The heights of one patch by column, and how far triangles and their sides are from them.

#ifndef SeismicHorizonsHeightRaster_h
#define SeismicHorizonsHeightRaster_h

#include "Common/LinkCuts.h"
#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace SeismicHorizons
{
// The columns of a triangle, row by row: those on its sides and corners count.

/// Where a side is in each row, upwards: the whole columns at or beside it, without rounding.
class SideWalk
{
public:
  SideWalk(const PlanePoint& low, const PlanePoint& high)
    : Height(std::max(1, high.Y - low.Y))
    , Floor(low.X)
    , Slope((high.X - low.X) / this->Height)
    , Rest((high.X - low.X) % this->Height)
  {
    if (this->Rest < 0)
    {
      --this->Slope;
      this->Rest += this->Height;
    }
  }

  std::int32_t AtOrLeft() const { return this->Floor; }
  std::int32_t AtOrRight() const { return this->Floor + (this->Part > 0 ? 1 : 0); }
  bool IsAtColumn() const { return this->Part == 0; }
  /// How far from AtOrLeft() to the next column the side is, in parts of which a column has as many as the side rows.
  std::int32_t Parts() const { return this->Part; }

  void GoUp()
  {
    this->Floor += this->Slope;
    this->Part += this->Rest;
    if (this->Part >= this->Height)
    {
      this->Part -= this->Height;
      ++this->Floor;
    }
  }

private:
  std::int32_t Height;
  std::int32_t Floor;
  std::int32_t Slope; // whole columns per row
  std::int32_t Rest; // and so many parts of one, of which a column has Height
  std::int32_t Part = 0; // by how many the side is to the right of Floor
};

/// Calls visit(y, first, last) for the rows of a triangle that have columns, from below.
template <typename Visitor>
void ForEachRow(std::array<PlanePoint, 3> corners, Visitor&& visit)
{
  std::sort(corners.begin(), corners.end(),
    [](const PlanePoint& a, const PlanePoint& b) { return a.Y != b.Y ? a.Y < b.Y : a.X < b.X; });
  const auto& [low, middle, high] = corners;
  if (low.Y == high.Y)
  {
    visit(low.Y, low.X, high.X);
    return;
  }
  SideWalk through(low, high);
  const auto walk = [&](SideWalk side, std::int32_t first, std::int32_t last)
  {
    for (std::int32_t y = first; y <= last; ++y)
    {
      const std::int32_t left = std::min(through.AtOrRight(), side.AtOrRight());
      const std::int32_t right = std::max(through.AtOrLeft(), side.AtOrLeft());
      if (left <= right)
      {
        visit(y, left, right);
      }
      through.GoUp();
      side.GoUp();
    }
  };
  walk(SideWalk(low, middle), low.Y, middle.Y - 1);
  walk(SideWalk(middle, high), middle.Y, high.Y);
}

/// A corner of a triangle, or an end of its sides: the column, and the height there.
struct RaisedPoint
{
  PlanePoint Column;
  double Height = 0.0;
};

using RaisedTriangle = std::array<RaisedPoint, 3>; // counter-clockwise in plan

/// The largest vertical distance from the points of a patch, and the point where it is; of several the first, row by
/// row. NoPoint where there is nothing to measure, or no distance.
struct HeightError
{
  double Largest = 0.0;
  PointId Point = NoPoint;
  double Sum = 0.0; // of the powers of all distances, where asked for
};

/// Which powers of distances are summed: each is divided by the unit first, so that high powers stay within what
/// numbers can hold.
struct ErrorPower
{
  int Power = 0; // 2 or 4; 0 for no sum
  double Unit = 1.0;

  double Raise(double distance) const
  {
    const double square = (distance / this->Unit) * (distance / this->Unit);
    return this->Power == 2 ? square : square * square;
  }
};

/// Where a side crosses the line between two neighbouring columns that both have points.
struct Crossing
{
  std::int64_t Place = 0; // of the first column
  std::int64_t Beyond = 0; // and of the second one
  double PartOfColumn = 0.0; // how far from the first to the second
  double PartOfSide = 0.0; // and from the side's beginning to its end
  double Error = 0.0; // the side's height less that of the line
};

/// Four neighbouring columns of a row.
template <typename Real>
using FourColumns = Eigen::Array<Real, 4, 1>;

/// The larger of each number and 0, which is 0 where the number is nan. Eigen's maximum is that of the processor unless
/// it is told to prefer numbers: with NEON it would be nan, and with SSE depend on the order.
template <typename Four>
auto AtLeastZero(const Four& four)
{
  using Real = typename Four::Scalar;
  return Four::Zero().binaryExpr(four, Eigen::internal::scalar_max_op<Real, Real, Eigen::PropagateNumbers>());
}

/// Which columns in a triangle and on its sides count for it: those inside always do.
struct SideColumns
{
  bool AreAll() const { return this->WithCorners && this->Opposite[0] && this->Opposite[1] && this->Opposite[2]; }

  bool WithCorners = true;
  std::array<bool, 3> Opposite = { true, true, true }; // to each corner
};

/// Heights are also kept as floats, less the middle one. They decide wherever their rounding leaves no doubt, and the
/// heights themselves elsewhere: so that all bounds are exact.
class HeightRaster
{
public:
  /// For some points of a horizon, at least one: forEachPoint(add) calls add(point) for each of them, and is run twice.
  /// `columns` and `heights`, which are finite, are those of all its points. Takes 16 bytes per column of the bounding
  /// box. Throws InputError when two stand in the same column. Nothing is measured at links that are cut; `cuts`, null
  /// for none, must outlive it.
  template <typename ForEachPoint>
  HeightRaster(ForEachPoint&& forEachPoint, PlanePoints columns, const std::vector<double>& heights,
    const LinkCuts* cuts = nullptr)
    : Cuts(cuts)
  {
    forEachPoint([&](PointId point) { this->AddRange(columns[point], heights[point]); });
    this->MakeColumns();
    forEachPoint([&](PointId point) { this->Add(point, columns[point], heights[point]); });
  }

  /// Of a column with a point.
  double HeightAt(const PlanePoint& column) const { return this->Heights[this->Place(column.X, column.Y)]; }

  double LowestHeight() const { return this->Lowest; }
  double HighestHeight() const { return this->Highest; }

  /// At the columns inside a triangle and on its sides.
  HeightError Measure(const RaisedTriangle& triangle, const ErrorPower& power = ErrorPower()) const;

  /// The largest of these errors and its point where it is above a bound, both as floats have them; else no more than
  /// that it is not.
  HeightError MeasureAbove(const RaisedTriangle& triangle, double bound) const;

  /// Whether no error of a triangle is above a bound.
  bool IsWithin(const RaisedTriangle& triangle, double bound) const
  {
    return this->SumWithin(triangle, { 0, bound }, bound) < Infinity;
  }

  /// The sum of powers of the errors as floats have it, each divided by the unit; infinite when an error is above a
  /// bound, or as soon as the sum is seen not to stay below `most`.
  double SumWithin(const RaisedTriangle& triangle, const ErrorPower& power, double bound, double most = Infinity) const;

  /// Where a side crosses the line between two neighbouring columns that both have points, its distance from the
  /// straight line between these. Gives the nearer of the two points that is not marked, and nothing for crossings
  /// between two marked ones.
  HeightError MeasureSide(
    const RaisedPoint& from, const RaisedPoint& to, const std::vector<unsigned char>& marks) const;

  /// The same without a point, of all crossings, with the sum.
  HeightError MeasureCrossings(const RaisedPoint& from, const RaisedPoint& to, const ErrorPower& power) const;

  /// Whether none of these errors is above a bound.
  bool IsSideWithin(const RaisedPoint& from, const RaisedPoint& to, double bound) const;

  /// Calls visit(point, error, weights) for the columns with a point inside a triangle and on its sides: the triangle's
  /// height less that of the point, and the weights of the three corners, whose sum is twice the triangle's area.
  template <typename Visitor>
  void ForEachColumn(const RaisedTriangle& triangle, Visitor&& visit) const;

  /// Whether floats tell errors apart of corners that are no farther from their columns than a bound.
  bool IsFloatEnough(double bound) const;

  /// Calls visit(errors, b, c, isIn) for the columns that count, four at a time, floats or doubles: errors, 0 where
  /// there is no point; the weights of the second and third corner; and 1 for columns with a point that count, else 0.
  template <typename Real, typename Visitor>
  void ForEachFour(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const;

  /// Calls visit(crossing) for those of a side, with heights as floats or doubles have them, until that gives false.
  template <typename Real, typename Visitor>
  void ForEachCrossing(const RaisedPoint& from, const RaisedPoint& to, Visitor&& visit) const;

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  void AddRange(const PlanePoint& column, double height);
  void MakeColumns();
  void Add(PointId point, const PlanePoint& column, double height);

  /// How far an error is wrong at most that floats have, of corners no farther from their columns than a bound.
  double FloatRounding(double bound) const;

  template <typename Real>
  const Real* HeightsAs() const
  {
    if constexpr (std::is_same_v<Real, float>)
    {
      return this->FloatHeights.data();
    }
    else
    {
      return this->Heights.data();
    }
  }
  /// What these are less.
  template <typename Real>
  double MiddleAs() const
  {
    return std::is_same_v<Real, float> ? 0.5 * this->Lowest + 0.5 * this->Highest : 0.0;
  }
  template <int Power, typename Real>
  HeightError MeasureAs(const RaisedTriangle& triangle, double perUnit, double bound, double most) const;
  template <typename Real>
  HeightError MeasureAs(const RaisedTriangle& triangle, const ErrorPower& power, double bound, double most) const;
  template <typename Real>
  PointId FindPoint(const RaisedTriangle& triangle, double error) const;
  /// Calls visit(place, heights, b, c, isIn) for four columns at a time, from the place of the first one on, until that
  /// gives false: heights of the triangle, less the middle one, and weights as for ForEachFour.
  template <typename Real, typename Visitor>
  void ForEachHeight(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const;
  template <typename Real, typename Visitor>
  void ForEachHeightOfBox(
    const RaisedTriangle& triangle, const PlaneBox& box, const SideColumns& sides, Visitor&& visit) const;
  template <typename Real, typename Visitor>
  void ForEachHeightOfRows(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const;

  std::int64_t Place(std::int64_t x, std::int64_t y) const
  {
    return (y - this->Box.Least.Y) * this->Width + (x - this->Box.Least.X);
  }

  PlaneBox Box;
  std::int64_t Width = 0;
  RawVector<PointId> Points; // by place
  RawVector<double> Heights; // by place; nan where there is no point
  RawVector<float> FloatHeights; // the same less the middle one
  double Lowest = Infinity;
  double Highest = -Infinity;
  const LinkCuts* Cuts;
};

//----------------------------------------------------------------------------------------------------------------------
template <typename Visitor>
void HeightRaster::ForEachColumn(const RaisedTriangle& triangle, Visitor&& visit) const
{
  const RaisedPoint& a = triangle[0];
  const RaisedPoint& b = triangle[1];
  const RaisedPoint& c = triangle[2];
  const double perArea = 1.0 / double(SignedArea(a.Column, b.Column, c.Column));
  // By how much weights change from column to column. They are whole numbers: sums are exact.
  const std::array<double, 3> steps = { double(b.Column.Y) - c.Column.Y, double(c.Column.Y) - a.Column.Y,
    double(a.Column.Y) - b.Column.Y };
  ForEachRow({ a.Column, b.Column, c.Column },
    [&](std::int32_t y, std::int32_t first, std::int32_t last)
    {
      const PlanePoint start{ first, y };
      std::array<double, 3> weights = { double(SignedArea(b.Column, c.Column, start)),
        double(SignedArea(c.Column, a.Column, start)), double(SignedArea(a.Column, b.Column, start)) };
      const std::int64_t end = this->Place(last, y);
      for (std::int64_t place = this->Place(first, y); place <= end; ++place)
      {
        const PointId point = this->Points[place];
        if (point != NoPoint)
        {
          const double height = (weights[0] * a.Height + weights[1] * b.Height + weights[2] * c.Height) * perArea;
          visit(point, height - this->Heights[place], weights);
        }
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
          weights[corner] += steps[corner];
        }
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real, typename Visitor>
void HeightRaster::ForEachCrossing(const RaisedPoint& from, const RaisedPoint& to, Visitor&& visit) const
{
  const Real* const heights = this->HeightsAs<Real>();
  const double start = from.Height - this->MiddleAs<Real>();
  const double rise = to.Height - from.Height;
  // First the rows between the ends, then, with rows and columns exchanged, the columns.
  for (const bool isTurned : { false, true })
  {
    const auto turn = [isTurned](const PlanePoint& column) {
      return isTurned ? PlanePoint{ column.Y, column.X } : column;
    };
    const bool isUp = turn(from.Column).Y < turn(to.Column).Y;
    const PlanePoint low = turn(isUp ? from.Column : to.Column);
    const PlanePoint high = turn(isUp ? to.Column : from.Column);
    if (high.Y - low.Y < 2) // most sides of small triangles
    {
      continue;
    }
    const double perLine = 1.0 / (double(high.Y) - low.Y);
    SideWalk walk(low, high);
    for (std::int32_t line = low.Y + 1; line < high.Y; ++line)
    {
      walk.GoUp();
      if (walk.IsAtColumn())
      {
        continue;
      }
      Crossing crossing;
      const std::int32_t x = isTurned ? line : walk.AtOrLeft();
      const std::int32_t y = isTurned ? walk.AtOrLeft() : line;
      crossing.Place = this->Place(x, y);
      crossing.Beyond = crossing.Place + (isTurned ? this->Width : 1);
      const double first = heights[crossing.Place];
      const double second = heights[crossing.Beyond];
      crossing.PartOfColumn = double(walk.Parts()) * perLine;
      const double up = (double(line) - low.Y) * perLine;
      crossing.PartOfSide = isUp ? up : 1.0 - up;
      crossing.Error = start + crossing.PartOfSide * rise - (first + crossing.PartOfColumn * (second - first));
      const bool isCut = this->Cuts && (isTurned ? this->Cuts->IsCutNorth({ x, y }) : this->Cuts->IsCutEast({ x, y }));
      const bool hasPoints = !std::isnan(crossing.Error);
      if (!isCut && hasPoints && !visit(crossing))
      {
        return;
      }
    }
  }
}

// ---- Four columns at a time ----------------------------------------------------------------------------------------
// Weights of the corners are twice the areas of the triangles with the opposite sides: whole numbers, which change by
// the same amount from column to column.
struct CornerWeights
{
  explicit CornerWeights(const RaisedTriangle& triangle)
    : A(triangle[0].Column)
    , B(triangle[1].Column)
    , C(triangle[2].Column)
    , Area(double(SignedArea(this->A, this->B, this->C)))
  {
  }

  double OfB(const PlanePoint& place) const { return double(SignedArea(this->C, this->A, place)); }
  double OfC(const PlanePoint& place) const { return double(SignedArea(this->A, this->B, place)); }
  /// From column to column of a row, and from row to row.
  double StepOfB() const { return double(this->C.Y) - this->A.Y; }
  double StepOfC() const { return double(this->A.Y) - this->B.Y; }
  double RowStepOfB() const { return double(this->A.X) - this->C.X; }
  double RowStepOfC() const { return double(this->B.X) - this->A.X; }

  PlanePoint A;
  PlanePoint B;
  PlanePoint C;
  double Area;
};

/// The plane of a triangle over these, heights less a middle one.
struct WeightPlane
{
  WeightPlane(const RaisedTriangle& triangle, double area, double middle)
    : Start(triangle[0].Height - middle)
    , PerB((triangle[1].Height - triangle[0].Height) / area)
    , PerC((triangle[2].Height - triangle[0].Height) / area)
  {
  }

  double Start;
  double PerB;
  double PerC;
};

//----------------------------------------------------------------------------------------------------------------------
// All columns of the bounding box; those outside have a negative weight.
template <typename Real, typename Visitor>
void HeightRaster::ForEachHeightOfBox(
  const RaisedTriangle& triangle, const PlaneBox& box, const SideColumns& sides, Visitor&& visit) const
{
  using Four = FourColumns<Real>;
  const CornerWeights weights(triangle);
  const Four columns(0, 1, 2, 3);
  const WeightPlane plane(triangle, weights.Area, this->MiddleAs<Real>());
  const Real start = Real(plane.Start);
  const Real perB = Real(plane.PerB);
  const Real perC = Real(plane.PerC);
  const Real area = Real(weights.Area);
  // What the weights are above of columns that count, and what below: they are whole numbers.
  const Real aboveA = sides.Opposite[0] ? 0 : 1;
  const Real aboveB = sides.Opposite[1] ? 0 : 1;
  const Real aboveC = sides.Opposite[2] ? 0 : 1;
  const Real stepOfB = Real(weights.StepOfB());
  const Real stepOfC = Real(weights.StepOfC());
  const Real rowStepOfB = Real(weights.RowStepOfB());
  const Real rowStepOfC = Real(weights.RowStepOfC());
  Four firstB = Real(weights.OfB(box.Least)) + columns * stepOfB;
  Four firstC = Real(weights.OfC(box.Least)) + columns * stepOfC;
  std::int64_t first = this->Place(box.Least.X, box.Least.Y);
  const std::int32_t width = box.Greatest.X - box.Least.X + 1;
  for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y, first += this->Width)
  {
    for (std::int32_t n = 0; n < width; n += 4)
    {
      const Four b = firstB + Real(n) * stepOfB;
      const Four c = firstC + Real(n) * stepOfC;
      const Four a = area - b - c;
      const Four least = (a - aboveA).min(b - aboveB).min(c - aboveC);
      Four isIn = (least + least + Real(1)).max(Real(0)).min(Real(1));
      if (!sides.WithCorners)
      {
        isIn *= (area - a.max(b).max(c)).max(Real(0)).min(Real(1));
      }
      if (!visit(first + n, Four(start + (perB * b + perC * c)), b, c, isIn))
      {
        return;
      }
    }
    firstB += rowStepOfB;
    firstC += rowStepOfC;
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real, typename Visitor>
void HeightRaster::ForEachHeightOfRows(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const
{
  using Four = FourColumns<Real>;
  const CornerWeights weights(triangle);
  const WeightPlane plane(triangle, weights.Area, this->MiddleAs<Real>());
  const Four columns(0, 1, 2, 3);
  const Real stepOfB = Real(weights.StepOfB());
  const Real stepOfC = Real(weights.StepOfC());
  const Real slope = Real(plane.PerB * weights.StepOfB() + plane.PerC * weights.StepOfC());
  bool goesOn = true;
  const auto visitRow = [&](std::int32_t y, std::int32_t begin, std::int32_t end)
  {
    const double firstB = weights.OfB({ begin, y });
    const double firstC = weights.OfC({ begin, y });
    const Real start = Real(plane.Start + (plane.PerB * firstB + plane.PerC * firstC));
    const std::int64_t place = this->Place(begin, y);
    const std::int32_t size = end - begin + 1;
    const auto visitFour = [&](std::int32_t n, const Four& isIn)
    {
      const Four steps = columns + Real(n);
      goesOn = visit(place + n, Four(start + steps * slope), Four(Real(firstB) + steps * stepOfB),
        Four(Real(firstC) + steps * stepOfC), isIn);
    };
    std::int32_t n = 0;
    for (; goesOn && n + 4 <= size; n += 4)
    {
      visitFour(n, Four::Ones());
    }
    if (goesOn && n < size)
    {
      visitFour(n, (Real(size - n) - columns).max(Real(0)).min(Real(1)));
    }
  };
  // Only the ends of a row can be on sides, or all of it.
  const bool areAll = sides.AreAll();
  const auto counts = [&](const PlanePoint& column)
  {
    if (areAll)
    {
      return true;
    }
    const double b = weights.OfB(column);
    const double c = weights.OfC(column);
    const double a = weights.Area - b - c;
    return (a > 0.0 || sides.Opposite[0]) && (b > 0.0 || sides.Opposite[1]) && (c > 0.0 || sides.Opposite[2]) &&
      (sides.WithCorners || std::max({ a, b, c }) < weights.Area);
  };
  ForEachRow({ weights.A, weights.B, weights.C },
    [&](std::int32_t y, std::int32_t begin, std::int32_t end)
    {
      for (; goesOn && begin <= end && !counts({ begin, y }); ++begin)
      {
      }
      for (; goesOn && begin <= end && !counts({ end, y }); --end)
      {
      }
      visitRow(y, begin, end);
    });
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real, typename Visitor>
void HeightRaster::ForEachHeight(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const
{
  // Most rows of such triangles are so short that finding their ends would take longer; and of as many rows, floats
  // have the whole numbers of all weights.
  constexpr std::int64_t MostColumnsOfBox = 8;
  constexpr std::int64_t MostRowsOfBox = 1 << 19;
  PlaneBox box;
  for (const RaisedPoint& corner : triangle)
  {
    box.Add(corner.Column);
  }
  if (std::int64_t(box.Greatest.X) - box.Least.X < MostColumnsOfBox &&
    std::int64_t(box.Greatest.Y) - box.Least.Y < MostRowsOfBox)
  {
    this->ForEachHeightOfBox<Real>(triangle, box, sides, visit);
  }
  else
  {
    this->ForEachHeightOfRows<Real>(triangle, sides, visit);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real, typename Visitor>
void HeightRaster::ForEachFour(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const
{
  using Four = FourColumns<Real>;
  this->ForEachHeight<Real>(triangle, sides,
    [&](std::int64_t place, const Four& heights, const Four& b, const Four& c, const Four& isIn)
    {
      const Four errors = heights - Eigen::Map<const Four>(this->HeightsAs<Real>() + place);
      const Four above = AtLeastZero(errors);
      const Four below = AtLeastZero(Four(-errors));
      const Four hasPoint = AtLeastZero(Four(errors - errors + Real(1)));
      visit(Four(above - below), b, c, Four(isIn * hasPoint));
      return true;
    });
}
}

#endif
