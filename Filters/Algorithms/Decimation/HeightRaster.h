// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rasterizes the heights of a patch, and measures the vertical distance of triangles and edges from them.

#ifndef SeismicHorizonsHeightRaster_h
#define SeismicHorizonsHeightRaster_h

#include "Common/Base/FixedChunks.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/Types.h"
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
/// Interpolated heights are exact to some units in the last place of the corners' heights.
constexpr double UnitsOfRounding = 32.0 * std::numeric_limits<double>::epsilon();

struct HeightError
{
  double Largest = 0.0;
  PointId Point = NoPoint;
  double Sum = 0.0; // of squares, if requested
};

/// Division by the unit keeps squares from overflowing.
struct ErrorSquares
{
  bool AreSummed = false;
  double Unit = 1.0;
};

/// Place and Beyond are the two columns, which have points or dropped ones.
struct Crossing
{
  std::int64_t Place = 0;
  std::int64_t Beyond = 0;
  double FractionOfColumn = 0.0; // from the first to the second
  double FractionOfEdge = 0.0; // from its start to its end
  double Error = 0.0; // edge minus segment
};

/// Of an edge that crosses links, those with an end that was dropped apart.
struct CrossingErrors
{
  double Inside = 0.0;
  double BesideLoops = 0.0;

  double Largest() const { return std::max(this->Inside, this->BesideLoops); }
};

/// Heights are floats relative to the middle height. Where float rounding could change a decision, doubles are read, so
/// that all bounds are exact.
class HeightRaster
{
public:
  /// pointAt(n), for n below `size`, gives at least one point; it may give NoPoint. Heights must be finite and, like
  /// cuts, outlive the raster. Throws InputError if two points share a column. Crossings of cut links are not measured.
  /// Dropped points, of loops, are no points of the raster, but their heights count on links.
  template <typename PointAt>
  HeightRaster(std::int64_t size, PointAt&& pointAt, PlanePoints columns, const double* heights,
    const LinkCuts* cuts = nullptr, const std::vector<PointId>& dropped = {})
    : Heights(heights)
    , Cuts(cuts)
  {
    const auto forEachPoint = [&](std::int64_t first, std::int64_t last, auto&& call)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const PointId point = pointAt(n);
        if (point != NoPoint)
        {
          call(point);
        }
      }
    };
    const auto rows = AddUpChunks<ColumnRows>(size, ChunkSize, Monitor(),
      [&](ColumnRows& part, std::int64_t first, std::int64_t last)
      { forEachPoint(first, last, [&](PointId point) { part.Add(ColumnRows::Of(columns[point])); }); });
    this->Box = rows.Box;
    std::for_each(dropped.begin(), dropped.end(), [&](PointId point) { this->Box.Add(columns[point]); });
    this->Points = std::make_shared<RawVector<PointId>>(this->MakePlaces());
    // Points row by row do not share columns, so that threads write different places.
    const std::int64_t grain = rows.AreAscending ? Grain : size;
    ParallelFor(size, grain,
      [&](std::int64_t first, std::int64_t last)
      { forEachPoint(first, last, [&](PointId point) { this->Add(point, columns[point]); }); });
    this->SetFloats(nullptr);
    this->Dropped = this->PlacesOf(dropped, columns);
  }

  /// Shares points with `other`. Columns not marked in isKnown, if given, have no height.
  HeightRaster(const HeightRaster& other, const double* heights, const std::vector<unsigned char>* isKnown)
    : Box(other.Box)
    , Width(other.Width)
    , Points(other.Points)
    , Heights(heights)
    , Cuts(other.Cuts)
  {
    this->SetFloats(isKnown);
  }

  /// Drops these points alone, which must have been dropped or in the raster. It must not be shared.
  void SetDropped(const std::vector<PointId>& points, PlanePoints columns);
  /// NaN without a dropped point.
  double DroppedHeight(const PlanePoint& column) const;
  /// Appends dropped points on links that an edge crosses farther away than the bound.
  void FindDropped(const RaisedPoint& from, const RaisedPoint& to, double bound, std::vector<PointId>& found) const;

  /// The column may lie outside the raster.
  PointId PointAt(const PlanePoint& column) const
  {
    return this->Box.Contains(column) ? (*this->Points)[this->Place(column.X, column.Y)] : NoPoint;
  }

  /// Sets the heights of the columns in a box, row by row, less a height; NaN without a known point. All must be in the
  /// raster.
  void ReadHeights(const PlaneBox& box, double less, RawVector<double>& heights) const;
  /// Floats from a column on, relative to the middle height; rows are Columns() apart, and Beyond more can be read.
  const float* FloatsFrom(const PlanePoint& column) const
  {
    return this->Floats.data() + this->Place(column.X, column.Y);
  }
  std::int64_t Columns() const { return this->Width; }
  double MiddleHeight() const { return this->MiddleAs<float>(); }
  static constexpr std::int64_t Beyond = 7;

  /// NaN without a known point.
  double HeightAt(const PlanePoint& column) const { return this->At<double>(this->Place(column.X, column.Y)); }

  const PlaneBox& Area() const { return this->Box; }
  double LowestHeight() const { return this->Lowest; }
  double HighestHeight() const { return this->Highest; }

  /// Edges of the triangle are included.
  HeightError Measure(const RaisedTriangle& triangle, const ErrorSquares& squares = ErrorSquares()) const;

  /// Returns no error up to the bound.
  HeightError MeasureAbove(const RaisedTriangle& triangle, double bound) const;

  /// Returns the first point, row by row, with an error that was measured with this bound.
  PointId FindPoint(const RaisedTriangle& triangle, double error, double bound) const;

  bool IsWithin(const RaisedTriangle& triangle, double bound) const;

  /// Measures crossings that have an unmarked column and no marked dropped one, and finds the nearer of these columns.
  HeightError MeasureEdge(
    const RaisedPoint& from, const RaisedPoint& to, const std::vector<unsigned char>& marks) const;

  CrossingErrors MeasureCrossings(const RaisedPoint& from, const RaisedPoint& to) const;

  bool IsEdgeWithin(const RaisedPoint& from, const RaisedPoint& to, double bound) const;

  /// Calls visit(point, error, weights): triangle minus point, and corner weights that sum to twice the area.
  template <typename Visitor>
  void ForEachColumn(const RaisedTriangle& triangle, Visitor&& visit) const;

  /// Of heights measured in floats, with corners within the bound of their columns.
  double FloatRounding(double bound) const;
  /// Floats suffice if they round little beside the bound.
  bool IsFloatEnough(double bound) const;

  /// Calls visit(errors, b, c, isIn): errors, 0 without a point; weights of the second and third corner; and 1 for
  /// columns with a point that count, else 0.
  template <typename Real, typename Visitor>
  void ForEachFour(const RaisedTriangle& triangle, const EdgeColumns& edges, Visitor&& visit) const;

  /// Stops when visit(crossing) returns false.
  template <typename Real, typename Visitor>
  void ForEachCrossing(const RaisedPoint& from, const RaisedPoint& to, Visitor&& visit) const;

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  RawVector<PointId> MakePlaces();
  void Add(PointId point, const PlanePoint& column);
  std::vector<std::pair<std::int64_t, PointId>> PlacesOf(const std::vector<PointId>& points, PlanePoints columns) const;
  void SetFloats(const std::vector<unsigned char>* isKnown);

  /// Returns NaN without a known point.
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
  template <typename Real>
  double OnLink(std::int64_t place) const
  {
    const double height = this->At<Real>(place);
    return std::isnan(height) && !this->Dropped.empty() ? this->DroppedHeightAt(place) - this->MiddleAs<Real>()
                                                        : height;
  }
  PointId DroppedAt(std::int64_t place) const
  {
    const auto found = std::lower_bound(this->Dropped.begin(), this->Dropped.end(), std::make_pair(place, PointId(0)));
    return found != this->Dropped.end() && found->first == place ? found->second : NoPoint;
  }
  double DroppedHeightAt(std::int64_t place) const
  {
    const PointId point = this->DroppedAt(place);
    return point == NoPoint ? std::numeric_limits<double>::quiet_NaN() : this->Heights[point];
  }
  /// Floats are relative to this height.
  template <typename Real>
  double MiddleAs() const
  {
    return std::is_same_v<Real, float> ? this->Middle : 0.0;
  }
  template <typename Real>
  HeightError MeasureAs(const RaisedTriangle& triangle, const ErrorSquares& squares, double bound) const;
  template <typename Real>
  PointId FindPointAs(const RaisedTriangle& triangle, double error) const;
  /// Calls visit(place, heights, b, c, isIn) until it returns false, with heights of the triangle relative to
  /// MiddleAs().
  template <typename Real, typename Visitor>
  void ForEachHeight(const RaisedTriangle& triangle, const EdgeColumns& edges, Visitor&& visit) const
  {
    ForEachFourOf<Real>(
      triangle, this->MiddleAs<Real>(), edges, [this](std::int64_t x, std::int64_t y) { return this->Place(x, y); },
      visit);
  }

  std::int64_t Place(std::int64_t x, std::int64_t y) const
  {
    return (y - this->Box.Least.Y) * this->Width + (x - this->Box.Least.X);
  }

  PlaneBox Box;
  std::int64_t Width = 0;
  std::shared_ptr<RawVector<PointId>> Points; // by Place()
  const double* Heights; // by point
  RawVector<float> Floats; // by Place(), relative to the middle; NaN without a known point
  std::vector<std::pair<std::int64_t, PointId>> Dropped; // by Place(), ascending
  double Lowest = Infinity;
  double Highest = -Infinity;
  double Middle = 0.0;
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
  // Weights are integers, so their sums are exact.
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
  // The second pass exchanges rows and columns.
  for (const bool isTurned : { false, true })
  {
    const auto turn = [isTurned](const PlanePoint& column) {
      return isTurned ? PlanePoint{ column.Y, column.X } : column;
    };
    const bool isUp = turn(from.Column).Y < turn(to.Column).Y;
    const PlanePoint low = turn(isUp ? from.Column : to.Column);
    const PlanePoint high = turn(isUp ? to.Column : from.Column);
    if (high.Y - low.Y < 2) // most edges of small triangles
    {
      continue;
    }
    const double perLine = 1.0 / (double(high.Y) - low.Y);
    EdgeWalk walk(low, high);
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
      const double first = this->OnLink<Real>(crossing.Place);
      const double second = this->OnLink<Real>(crossing.Beyond);
      crossing.FractionOfColumn = double(walk.Parts()) * perLine;
      const double up = (double(line) - low.Y) * perLine;
      crossing.FractionOfEdge = isUp ? up : 1.0 - up;
      crossing.Error = start + crossing.FractionOfEdge * rise - (first + crossing.FractionOfColumn * (second - first));
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
void HeightRaster::ForEachFour(const RaisedTriangle& triangle, const EdgeColumns& edges, Visitor&& visit) const
{
  using Four = FourColumns<Real>;
  this->ForEachHeight<Real>(triangle, edges,
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
