// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The heights of one patch by column, and how far triangles and their sides are from them.

#ifndef SeismicHorizonsHeightRaster_h
#define SeismicHorizonsHeightRaster_h

#include "Common/LinkCuts.h"
#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"
#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
  /// How far from AtOrLeft() to AtOrRight() the side is, from 0 to 1.
  double PartOfColumn() const { return double(this->Part) / double(this->Height); }

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
  std::int64_t Height;
  std::int32_t Floor;
  std::int32_t Slope; // whole columns per row
  std::int64_t Rest; // and so many parts of one, of which a column has Height
  std::int64_t Part = 0; // by how many the side is to the right of Floor
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

class HeightRaster
{
public:
  /// For some points of a horizon, at least one: forEachPoint(add) calls add(point) for each of them, and is run twice.
  /// `columns` and `heights`, which are finite, are those of all its points. Takes 12 bytes per column of the bounding
  /// box. Throws InputError when two stand in the same column. Nothing is measured at links that are cut; `cuts`, null
  /// for none, must outlive it.
  template <typename ForEachPoint>
  HeightRaster(ForEachPoint&& forEachPoint, PlanePoints columns, const std::vector<double>& heights,
    const LinkCuts* cuts = nullptr)
    : Cuts(cuts)
  {
    forEachPoint([&](PointId point) { this->Box.Add(columns[point]); });
    this->MakeColumns();
    forEachPoint([&](PointId point) { this->Add(point, columns[point], heights[point]); });
  }

  /// Of a column with a point.
  double HeightAt(const PlanePoint& column) const { return this->Heights[this->Place(column.X, column.Y)]; }

  /// At the columns inside a triangle and on its sides.
  HeightError Measure(const RaisedTriangle& triangle, const ErrorPower& power = ErrorPower()) const;

  /// Where a side crosses the line between two neighbouring columns that both have points, its distance from the
  /// straight line between these. Gives the nearer of the two points that is not marked, and nothing for crossings
  /// between two marked ones.
  HeightError MeasureSide(
    const RaisedPoint& from, const RaisedPoint& to, const std::vector<unsigned char>& marks) const;

  /// The same without a point, of all crossings, with the sum.
  HeightError MeasureCrossings(const RaisedPoint& from, const RaisedPoint& to, const ErrorPower& power) const;

  /// Calls visit(point, error, weights) for the columns with a point inside a triangle and on its sides: the triangle's
  /// height less that of the point, and the weights of the three corners, whose sum is twice the triangle's area.
  template <typename Visitor>
  void ForEachColumn(const RaisedTriangle& triangle, Visitor&& visit) const;

  /// Calls visit(crossing) for those of a side.
  template <typename Visitor>
  void ForEachCrossing(const RaisedPoint& from, const RaisedPoint& to, Visitor&& visit) const;

private:
  void MakeColumns();
  void Add(PointId point, const PlanePoint& column, double height);
  template <int Power>
  HeightError Measure(const RaisedTriangle& triangle, double perUnit) const;
  template <int Power>
  HeightError MeasureRows(const RaisedTriangle& triangle, double perUnit) const;
  template <int Power>
  HeightError MeasureBox(const RaisedTriangle& triangle, const PlaneBox& box, double perUnit) const;

  std::int64_t Place(std::int64_t x, std::int64_t y) const
  {
    return (y - this->Box.Least.Y) * this->Width + (x - this->Box.Least.X);
  }

  PlaneBox Box;
  std::int64_t Width = 0;
  std::vector<PointId> Points; // by place
  std::vector<double> Heights; // by place; nan where there is no point
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
template <typename Visitor>
void HeightRaster::ForEachCrossing(const RaisedPoint& from, const RaisedPoint& to, Visitor&& visit) const
{
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
      const double first = this->Heights[crossing.Place];
      const double second = this->Heights[crossing.Beyond];
      crossing.PartOfColumn = walk.PartOfColumn();
      const double up = (double(line) - low.Y) / (double(high.Y) - low.Y);
      crossing.PartOfSide = isUp ? up : 1.0 - up;
      crossing.Error = from.Height + crossing.PartOfSide * (to.Height - from.Height) -
        (first + crossing.PartOfColumn * (second - first));
      const bool isCut = this->Cuts && (isTurned ? this->Cuts->IsCutNorth({ x, y }) : this->Cuts->IsCutEast({ x, y }));
      if (!isCut && !std::isnan(crossing.Error)) // a column without a point
      {
        visit(crossing);
      }
    }
  }
}
}

#endif
