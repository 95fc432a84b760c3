// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoxScan.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace SeismicHorizons
{
namespace
{
// 4 * 48 u, rounded up, and how much more than the least cotangent that of a candidate may be: so much of one more than
// its size.
constexpr float Rounding = 256.0f / 16777216.0f;
constexpr float Slack = 1.0f / 64.0f;

// Greater than the cotangents of all points in question.
constexpr float Unknown = 1e30f;

// The box around a circle is wider by this, and by so much of the radius: some ten times what rounding takes off.
constexpr float BoxMargin = 1.0f;
constexpr float BoxMarginPerRadius = 1e-5f;

// Farther than the grid is wide. Sums of it and coordinates fit 32 bits.
constexpr float FarOutside = 1073741824.0f;
}

//----------------------------------------------------------------------------------------------------------------------
// From the start of the edge, four numbers stand for x and y, and for both with the other sign: of all four the least
// is looked for. It is that of the circle where that place of the circle is to the left of the edge, else that of an
// end of the edge.
VoxelBox VoxelsOfCircle(const ThirdPointQuery& query, float cotangent, float radius)
{
  const std::int32_t edgeX = query.B.X - query.A.X;
  const std::int32_t edgeY = query.B.Y - query.A.Y;
  const FloatBatch edge = ToFloats(IntegerBatch{ edgeX, edgeY, -edgeX, -edgeY });
  const FloatBatch turned = __builtin_shufflevector(edge, edge, 1, 2, 3, 0);
  const FloatBatch centre = 0.5f * (edge - cotangent * turned);
  const FloatBatch squares = edge * edge;
  // Of the edge and the way from its start to the place: positive when that is to the left.
  const FloatBatch area = turned * radius + 0.5f * cotangent * (squares[0] + squares[1]);
  const float margin = BoxMargin + BoxMarginPerRadius * radius;
  const FloatBatch zero = {};
  const FloatBatch ends = edge < zero ? edge : zero;
  const FloatBatch least = (area > FourTimes(-4.0f * margin * radius) ? centre - radius : ends) - margin;
  const IntegerBatch places = ToIntegers(least > FourTimes(-FarOutside) ? least : FourTimes(-FarOutside));
  const SearchGrid& points = query.Points;
  // Rounded towards 0, a place moves by less than 1.
  return { points.VoxelX(query.A.X + places[0] - 1), points.VoxelY(query.A.Y + places[1] - 1),
    points.VoxelX(query.A.X - places[2] + 1), points.VoxelY(query.A.Y - places[3] + 1) };
}

//----------------------------------------------------------------------------------------------------------------------
VoxelBox VoxelsOfBest(const ThirdPointQuery& query)
{
  const float cotangent = float(query.BestCotangent);
  return VoxelsOfCircle(
    query, cotangent, 0.5f * std::sqrt((1.0f + cotangent * cotangent) * float(query.SquaredLength())));
}

//----------------------------------------------------------------------------------------------------------------------
void BoxScan::Run(ThirdPointQuery& query, const VoxelBox& box, float bound)
{
  constexpr int ends = 2;
  BoxScan scan(query, box, bound);
  if (scan.Visit<false>(box) > ends)
  {
    scan.Visit<true>(box);
  }
}

//----------------------------------------------------------------------------------------------------------------------
BoxScan::BoxScan(ThirdPointQuery& query, const VoxelBox& box, float bound)
  : Query(query)
  , EdgeX(float(query.B.X - query.A.X))
  , EdgeY(float(query.B.Y - query.A.Y))
  , Bound(bound)
{
  const float size = float(query.Points.Voxels().CellSize()) *
    float(std::int32_t(std::max(box.LastX - box.FirstX, box.LastY - box.FirstY)) + 1);
  this->Near = Rounding / Slack * size * (size + std::abs(this->EdgeX) + std::abs(this->EdgeY));
  this->Lowest = FourTimes(query.OnlyVisible || query.Best != NoPoint ? bound : Unknown);
}

//----------------------------------------------------------------------------------------------------------------------
// Gives how many points are near the line through the edge. A batch may have points more than the row has: they do no
// harm.
template <bool WithNear>
int BoxScan::Visit(const VoxelBox& box)
{
  const std::int64_t width = this->Query.Points.Voxels().SizeX();
  const PointId* starts = this->Query.Points.VoxelStarts() + box.FirstY * width + box.FirstX;
  PointId batches[Capacity + MostPerRow];
  std::size_t count = 0;
  int near = 0;
  const auto evaluateFull = [&]()
  {
    if (count >= Capacity)
    {
      near += this->Evaluate<WithNear>(batches, Capacity);
      std::copy_n(batches + Capacity, MostPerRow, batches);
      count -= Capacity;
    }
  };
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row, starts += width)
  {
    PointId first = starts[0];
    const PointId end = starts[box.LastX - box.FirstX + 1];
    for (; end - first > PointId(MostPerRow) * BatchSize; first += BatchSize)
    {
      evaluateFull();
      batches[count++] = first;
    }
    evaluateFull();
    for (std::size_t n = 0; n < MostPerRow; ++n)
    {
      batches[count + n] = first + PointId(n) * BatchSize;
    }
    count += std::size_t(end - first + BatchSize - 1) / BatchSize;
  }
  evaluateFull();
  return near + this->Evaluate<WithNear>(batches, count);
}

//----------------------------------------------------------------------------------------------------------------------
// Of batches by their first points. Cotangents of points that are not far enough to the left are not numbers, and so
// never less than another one.
template <bool WithNear>
int BoxScan::Evaluate(const PointId* batches, std::size_t count)
{
  const PlanePoint& a = this->Query.A;
  const IntegerBatch start = { a.X, a.Y, a.X, a.Y };
  const FloatBatch edgeX = FourTimes(this->EdgeX);
  const FloatBatch edgeY = FourTimes(this->EdgeY);
  const FloatBatch nearArea = FourTimes(this->Near);
  // Twice as much as such a point can have whose cotangent is up to the bound.
  const FloatBatch nearProduct = nearArea * (2.0f * std::max(1.0f, this->Bound));
  const PlanePoint* const places = &this->Query.Points.At(0);
  FloatBatch cotangents[Capacity];
  FloatBatch lowest = this->Lowest;
  IntegerBatch nearCount = {};
  for (std::size_t n = 0; n < count; ++n)
  {
    IntegerBatch even;
    IntegerBatch odd;
    std::memcpy(&even, places + batches[n], sizeof(even));
    std::memcpy(&odd, places + batches[n] + 2, sizeof(odd));
    const FloatBatch first = ToFloats(even - start);
    const FloatBatch second = ToFloats(odd - start);
    const FloatBatch x = __builtin_shufflevector(first, second, 0, 2, 4, 6);
    const FloatBatch y = __builtin_shufflevector(first, second, 1, 3, 5, 7);
    const FloatBatch area = edgeX * y - edgeY * x;
    const FloatBatch product = x * (x - edgeX) + y * (y - edgeY);
    const IntegerBatch notLeft = area <= nearArea;
    const IntegerBatch near = notLeft & (area >= -nearArea) & (product <= nearProduct);
    nearCount -= near;
    const FloatBatch cotangent = FloatBatch(IntegerBatch(product / area) | notLeft);
    lowest = cotangent < lowest ? cotangent : lowest;
    cotangents[n] = WithNear ? (near ? FourTimes(-Unknown) : cotangent) : cotangent;
  }
  this->Lowest = lowest;
  const FloatBatch limit = FourTimes(this->LimitFor(lowest));
  BitBatch bit = { 1, 2, 4, 8 };
  BitBatch marks = {};
  for (std::size_t n = 0; n < count; ++n, bit <<= BatchSize)
  {
    marks |= BitBatch(cotangents[n] <= limit) & bit;
  }
  for (std::uint32_t left = marks[0] | marks[1] | marks[2] | marks[3]; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctz(left);
    const PointId point = batches[number / BatchSize] + number % BatchSize;
    if (point < this->Query.Points.NumberOfPoints())
    {
      this->Query.Consider(point);
    }
  }
  return nearCount[0] + nearCount[1] + nearCount[2] + nearCount[3];
}

//----------------------------------------------------------------------------------------------------------------------
// The greatest cotangent of a candidate, for the lowest so far.
float BoxScan::LimitFor(const FloatBatch& lowest) const
{
  const float least =
    this->Query.OnlyVisible ? this->Bound : std::min(std::min(lowest[0], lowest[1]), std::min(lowest[2], lowest[3]));
  return least + Slack * (1.0f + std::abs(least));
}
}
