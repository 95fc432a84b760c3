// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Visits the columns of a triangle row by row, including its edges.

#ifndef SeismicHorizonsTriangleRows_h
#define SeismicHorizonsTriangleRows_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/Types.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

namespace SeismicHorizons
{
/// Follows an edge upwards, in integers.
class EdgeWalk
{
public:
  EdgeWalk(const PlanePoint& low, const PlanePoint& high)
    : Height(std::max(1, high.Y - low.Y))
    , Floor(low.X)
    , Slope((high.X - low.X) / this->Height)
    , Rest((high.X - low.X) % this->Height)
  {
    assert(low.Y <= high.Y);
    if (this->Rest < 0)
    {
      --this->Slope;
      this->Rest += this->Height;
    }
  }

  std::int32_t AtOrLeft() const { return this->Floor; }
  std::int32_t AtOrRight() const { return this->Floor + (this->Part > 0 ? 1 : 0); }
  bool IsAtColumn() const { return this->Part == 0; }
  /// The fraction of a column from AtOrLeft() to the edge is Parts() divided by the rows that the edge spans.
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
  std::int32_t Rest; // in columns / Height per row
  std::int32_t Part = 0; // in columns / Height
};

/// Calls visit(y, first, last) upwards for rows with columns.
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
  EdgeWalk through(low, high);
  const auto walk = [&](EdgeWalk edge, std::int32_t first, std::int32_t last)
  {
    for (std::int32_t y = first; y <= last; ++y)
    {
      const std::int32_t left = std::min(through.AtOrRight(), edge.AtOrRight());
      const std::int32_t right = std::max(through.AtOrLeft(), edge.AtOrLeft());
      if (left <= right)
      {
        visit(y, left, right);
      }
      through.GoUp();
      edge.GoUp();
    }
  };
  walk(EdgeWalk(low, middle), low.Y, middle.Y - 1);
  walk(EdgeWalk(middle, high), middle.Y, high.Y);
}

struct RaisedPoint
{
  PlanePoint Column;
  double Height = 0.0;
};

using RaisedTriangle = std::array<RaisedPoint, 3>; // counter-clockwise in plan

// Visits the columns of a triangle, four of a row at a time.
//
// Weights of corners are twice the areas opposite to them: integers that change by constants from column to column.

template <typename Real>
using FourColumns = Eigen::Array<Real, 4, 1>;

/// Returns 0 for NaN. Eigen's default maximum would be NaN with NEON, and depend on the order with SSE.
template <typename Four>
auto AtLeastZero(const Four& four)
{
  using Real = typename Four::Scalar;
  return Four::Zero().binaryExpr(four, Eigen::internal::scalar_max_op<Real, Real, Eigen::PropagateNumbers>());
}

/// Inner columns always count.
struct EdgeColumns
{
  bool AreAll() const { return this->WithCorners && this->Opposite[0] && this->Opposite[1] && this->Opposite[2]; }

  bool WithCorners = true;
  std::array<bool, 3> Opposite = { true, true, true };
};

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
  double StepOfB() const { return double(this->C.Y) - this->A.Y; }
  double StepOfC() const { return double(this->A.Y) - this->B.Y; }
  double RowStepOfB() const { return double(this->A.X) - this->C.X; }
  double RowStepOfC() const { return double(this->B.X) - this->A.X; }

  PlanePoint A;
  PlanePoint B;
  PlanePoint C;
  double Area;
};

/// The height is Start + PerB * b + PerC * c for weights b and c, relative to the middle height.
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
template <typename Real, typename PlaceOf, typename Visitor>
void ForEachFourOfBox(const RaisedTriangle& triangle, const PlaneBox& box, double middle, const EdgeColumns& edges,
  const PlaceOf& placeOf, Visitor&& visit)
{
  using Four = FourColumns<Real>;
  const CornerWeights weights(triangle);
  const Four columns(0, 1, 2, 3);
  const WeightPlane plane(triangle, weights.Area, middle);
  const Real start = Real(plane.Start);
  const Real perB = Real(plane.PerB);
  const Real perC = Real(plane.PerC);
  const Real area = Real(weights.Area);
  // Weights are integers, so a column counts or is short of these by at least 1.
  const Real aboveA = edges.Opposite[0] ? 0 : 1;
  const Real aboveB = edges.Opposite[1] ? 0 : 1;
  const Real aboveC = edges.Opposite[2] ? 0 : 1;
  const Real stepOfB = Real(weights.StepOfB());
  const Real stepOfC = Real(weights.StepOfC());
  const Real rowStepOfB = Real(weights.RowStepOfB());
  const Real rowStepOfC = Real(weights.RowStepOfC());
  Four firstB = Real(weights.OfB(box.Least)) + columns * stepOfB;
  Four firstC = Real(weights.OfC(box.Least)) + columns * stepOfC;
  const std::int32_t width = box.Greatest.X - box.Least.X + 1;
  for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
  {
    const std::int64_t first = placeOf(box.Least.X, y);
    for (std::int32_t n = 0; n < width; n += 4)
    {
      const Four b = firstB + Real(n) * stepOfB;
      const Four c = firstC + Real(n) * stepOfC;
      const Four a = area - b - c;
      const Four least = (a - aboveA).min(b - aboveB).min(c - aboveC);
      Four isIn = (least + least + Real(1)).max(Real(0)).min(Real(1));
      if (!edges.WithCorners)
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
template <typename Real, typename PlaceOf, typename Visitor>
void ForEachFourOfRows(
  const RaisedTriangle& triangle, double middle, const EdgeColumns& edges, const PlaceOf& placeOf, Visitor&& visit)
{
  using Four = FourColumns<Real>;
  const CornerWeights weights(triangle);
  const WeightPlane plane(triangle, weights.Area, middle);
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
    const std::int64_t place = placeOf(begin, y);
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
  // Only the ends of a row, or all of it, can lie on edges.
  const bool areAll = edges.AreAll();
  const auto counts = [&](const PlanePoint& column)
  {
    if (areAll)
    {
      return true;
    }
    const double b = weights.OfB(column);
    const double c = weights.OfC(column);
    const double a = weights.Area - b - c;
    return (a > 0.0 || edges.Opposite[0]) && (b > 0.0 || edges.Opposite[1]) && (c > 0.0 || edges.Opposite[2]) &&
      (edges.WithCorners || std::max({ a, b, c }) < weights.Area);
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

/// Calls visit(place, heights, b, c, isIn) until it returns false: placeOf(x, y) of the first column; heights less
/// `middle`; weights of the second and third corner; and 1 for columns that count, else 0.
template <typename Real, typename PlaceOf, typename Visitor>
void ForEachFourOf(
  const RaisedTriangle& triangle, double middle, const EdgeColumns& edges, const PlaceOf& placeOf, Visitor&& visit)
{
  // Narrow triangles are faster without the ends of rows; fewer rows keep weights exact in floats.
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
    ForEachFourOfBox<Real>(triangle, box, middle, edges, placeOf, visit);
  }
  else
  {
    ForEachFourOfRows<Real>(triangle, middle, edges, placeOf, visit);
  }
}
}

#endif
