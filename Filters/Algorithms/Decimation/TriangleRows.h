// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Visits the columns of a triangle row by row, including its edges.

#ifndef SeismicHorizonsTriangleRows_h
#define SeismicHorizonsTriangleRows_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace SeismicHorizons
{
/// Follows an edge upwards, in integers.
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

struct RaisedPoint
{
  PlanePoint Column;
  double Height = 0.0;
};

using RaisedTriangle = std::array<RaisedPoint, 3>; // counter-clockwise in plan
}

#endif
