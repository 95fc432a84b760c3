// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsBoxScan_h
#define SeismicHorizonsBoxScan_h

#include "SearchGrid.h"
#include "ThirdPointQuery.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace SeismicHorizons
{
class BoxScan
{
public:
  BoxScan(const SearchGrid& points, ThirdPointQuery& query, const VoxelBox& box, float bound)
    : Points(points)
    , Query(query)
    , Start{ query.A.X, query.A.Y, query.A.X, query.A.Y }
    , EdgeX(float(query.B.X - query.A.X))
    , EdgeY(float(query.B.Y - query.A.Y))
    , Fixed(query.OnlyVisible)
    , Bound(bound)
  {
    const float size = float(points.Voxels().CellSize()) *
      float(std::int32_t(std::max(box.LastX - box.FirstX, box.LastY - box.FirstY)) + 1);
    this->Near = Rounding / Slack * size * (size + (std::abs(this->EdgeX) + std::abs(this->EdgeY)));
    this->Lowest = Splat(query.OnlyVisible || query.Best != NoPoint ? bound : Far);
    if (this->Visit<false>(box) > 2)
    {
      this->Visit<true>(box);
    }
  }

private:
  using Floats = float __attribute__((vector_size(16)));
  using Integers = std::int32_t __attribute__((vector_size(16)));

  template <bool WithNear>
  int Visit(const VoxelBox& box)
  {
    const CellGrid& voxels = this->Points.Voxels();
    PointId quads[Capacity + 3];
    std::size_t count = 0;
    int near = 0;
    for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
    {
      const PointId first = this->Points.FirstIn(voxels.Index(box.FirstX, row));
      const PointId last = this->Points.EndOf(voxels.Index(box.LastX, row));
      quads[count] = first;
      quads[count + 1] = first + 4;
      quads[count + 2] = first + 8;
      count += std::size_t(std::min((last - first + 3) >> 2, 3));
      for (PointId next = first + 12; next < last; next += 4)
      {
        if (count >= Capacity)
        {
          near += this->Evaluate<WithNear>(quads, count);
          count = 0;
        }
        quads[count++] = next;
      }
      if (count >= Capacity)
      {
        near += this->Evaluate<WithNear>(quads, count);
        count = 0;
      }
    }
    return near + this->Evaluate<WithNear>(quads, count);
  }

  template <bool WithNear>
  int Evaluate(const PointId* quads, std::size_t count)
  {
    const Integers start = this->Start;
    const Floats edgeX = Splat(this->EdgeX);
    const Floats edgeY = Splat(this->EdgeY);
    const Floats near = Splat(this->Near);
    const Floats right = -near;
    const Floats nearProduct = near * std::max(1.0f, this->Bound);
    Floats lowest = this->Lowest;
    Integers nearCount = {};
    Floats keys[Capacity + 3];
    const PlanePoint* const all = &this->Points.At(0);
    for (std::size_t n = 0; n < count; ++n)
    {
      const PlanePoint* places = all + quads[n];
      Integers even;
      Integers odd;
      std::memcpy(&even, places, sizeof(even));
      std::memcpy(&odd, places + 2, sizeof(odd));
      const Floats p = __builtin_convertvector(even - start, Floats);
      const Floats q = __builtin_convertvector(odd - start, Floats);
      const Floats x = __builtin_shufflevector(p, q, 0, 2, 4, 6);
      const Floats y = __builtin_shufflevector(p, q, 1, 3, 5, 7);
      const Floats area = edgeX * y - edgeY * x;
      const Floats product = x * (x - edgeX) + y * (y - edgeY);
      const Integers irregular = area <= near;
      const Integers special = irregular & (area >= right) & (product <= nearProduct);
      nearCount -= special;
      const Floats cotangent = Floats(Integers(product / area) | irregular); // NaN
      lowest = cotangent < lowest ? cotangent : lowest;
      keys[n] = WithNear ? (special ? Splat(-Far) : cotangent) : cotangent;
    }
    this->Lowest = lowest;
    const float low =
      this->Fixed ? this->Bound : std::min(std::min(lowest[0], lowest[1]), std::min(lowest[2], lowest[3]));
    const Floats limit = Splat(low + Slack * (1.0f + std::abs(low)));
    PointId found[4 * (Capacity + 3)];
    std::size_t size = 0;
    for (std::size_t n = 0; n < count; ++n)
    {
      const Integers inside = keys[n] <= limit;
      for (PointId lane = 0; lane < 4; ++lane)
      {
        found[size] = quads[n] + lane;
        size -= std::size_t(std::ptrdiff_t(inside[lane]));
      }
    }
    for (std::size_t n = 0; n < size; ++n)
    {
      if (found[n] < this->Points.NumberOfPoints())
      {
        this->Query.Consider(found[n]);
      }
    }
    return nearCount[0] + nearCount[1] + nearCount[2] + nearCount[3];
  }

  static Floats Splat(float value) { return Floats{ value, value, value, value }; }

  static constexpr std::size_t Capacity = 29;
  static constexpr float Rounding = 64.0f / 16777216.0f;
  static constexpr float Slack = 1.0f / 128.0f;
  static constexpr float Far = 1e30f;

  const SearchGrid& Points;
  ThirdPointQuery& Query;
  const Integers Start;
  const float EdgeX;
  const float EdgeY;
  const bool Fixed;
  const float Bound;
  float Near;
  Floats Lowest;
};
}

#endif
