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
#include "FourColumns.h"
#include "TriangleRows.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// The largest vertical distance from the points of a patch, and the point where it is, or NoPoint where that was not
/// looked for.
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

/// Heights are kept as floats, less the middle one. They decide wherever their rounding leaves no doubt, and the
/// heights themselves elsewhere: so that all bounds are exact.
class HeightRaster
{
public:
  /// For some points of a horizon, at least one: forEachPoint(add) calls add(point) for each of them, and is run twice.
  /// `columns` and `heights`, which are finite, are those of all its points. Takes 8 bytes per column of the bounding
  /// box. Throws InputError when two stand in the same column. Nothing is measured at links that are cut. The heights,
  /// and `cuts`, null for none, must outlive it.
  template <typename ForEachPoint>
  HeightRaster(ForEachPoint&& forEachPoint, PlanePoints columns, const double* heights, const LinkCuts* cuts = nullptr)
    : Heights(heights)
    , Cuts(cuts)
  {
    forEachPoint([&](PointId point) { this->Box.Add(columns[point]); });
    RawVector<PointId> points = this->MakePlaces();
    forEachPoint([&](PointId point) { this->Add(point, columns[point], points); });
    this->Points = std::make_shared<const RawVector<PointId>>(std::move(points));
    this->SetFloats(nullptr);
  }

  /// Another horizon over the points of `other`, with 4 bytes per column. Columns of points that are not marked as
  /// known, where that is given, have no height.
  HeightRaster(const HeightRaster& other, const double* heights, const std::vector<unsigned char>* isKnown)
    : Box(other.Box)
    , Width(other.Width)
    , Points(other.Points)
    , Heights(heights)
    , Cuts(other.Cuts)
  {
    this->SetFloats(isKnown);
  }

  /// Of a column with a point.
  double HeightAt(const PlanePoint& column) const { return this->At<double>(this->Place(column.X, column.Y)); }

  /// The point of a column, which may lie anywhere, or NoPoint.
  PointId PointAt(const PlanePoint& column) const
  {
    return this->Box.Contains(column) ? (*this->Points)[this->Place(column.X, column.Y)] : NoPoint;
  }

  double LowestHeight() const { return this->Lowest; }
  double HighestHeight() const { return this->Highest; }

  /// At the columns inside a triangle and on its sides.
  HeightError Measure(const RaisedTriangle& triangle, const ErrorPower& power = ErrorPower()) const;

  /// The largest of these errors with its point where it is above a bound, as floats have it; else none.
  HeightError MeasureAbove(const RaisedTriangle& triangle, double bound) const;

  /// The first point, row by row, with the largest error, as it was measured with or without a bound (0).
  PointId FindPoint(const RaisedTriangle& triangle, double error, double bound) const;

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

  RawVector<PointId> MakePlaces();
  void Add(PointId point, const PlanePoint& column, RawVector<PointId>& points) const;
  void SetFloats(const std::vector<unsigned char>* isKnown);

  /// How far an error is wrong at most that floats have, of corners no farther from their columns than a bound.
  double FloatRounding(double bound) const;

  /// nan where there is no point, or an unknown one.
  template <typename Real>
  Real At(std::int64_t place) const
  {
    const float less = this->Floats[place];
    if constexpr (std::is_same_v<Real, float>)
    {
      return less;
    }
    else
    {
      return std::isnan(less) ? std::numeric_limits<double>::quiet_NaN() : this->Heights[(*this->Points)[place]];
    }
  }
  template <typename Real>
  FourColumns<Real> FourAt(std::int64_t place) const
  {
    if constexpr (std::is_same_v<Real, float>)
    {
      return Eigen::Map<const FourColumns<float>>(this->Floats.data() + place);
    }
    else
    {
      return { this->At<Real>(place), this->At<Real>(place + 1), this->At<Real>(place + 2), this->At<Real>(place + 3) };
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
  PointId FindPointAs(const RaisedTriangle& triangle, double error) const;
  /// Calls visit(place, heights, b, c, isIn) for four columns at a time, from the place of the first one on, until that
  /// gives false: heights of the triangle, less the middle one, and weights as for ForEachFour.
  template <typename Real, typename Visitor>
  void ForEachHeight(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const
  {
    ForEachFourOf<Real>(
      triangle, this->MiddleAs<Real>(), sides, [this](std::int64_t x, std::int64_t y) { return this->Place(x, y); },
      visit);
  }

  std::int64_t Place(std::int64_t x, std::int64_t y) const
  {
    return (y - this->Box.Least.Y) * this->Width + (x - this->Box.Least.X);
  }

  PlaneBox Box;
  std::int64_t Width = 0;
  std::shared_ptr<const RawVector<PointId>> Points; // by place
  const double* Heights; // by point
  RawVector<float> Floats; // these less the middle one, by place; nan where there is no point, or an unknown one
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
        const double own = this->At<double>(place);
        if (!std::isnan(own))
        {
          const double height = (weights[0] * a.Height + weights[1] * b.Height + weights[2] * c.Height) * perArea;
          visit((*this->Points)[place], height - own, weights);
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
      const double first = this->At<Real>(crossing.Place);
      const double second = this->At<Real>(crossing.Beyond);
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

//----------------------------------------------------------------------------------------------------------------------
template <typename Real, typename Visitor>
void HeightRaster::ForEachFour(const RaisedTriangle& triangle, const SideColumns& sides, Visitor&& visit) const
{
  using Four = FourColumns<Real>;
  this->ForEachHeight<Real>(triangle, sides,
    [&](std::int64_t place, const Four& heights, const Four& b, const Four& c, const Four& isIn)
    {
      const Four errors = heights - this->FourAt<Real>(place);
      const Four above = AtLeastZero(errors);
      const Four below = AtLeastZero(Four(-errors));
      const Four hasPoint = AtLeastZero(Four(errors - errors + Real(1)));
      visit(Four(above - below), b, c, Four(isIn * hasPoint));
      return true;
    });
}
}

#endif
