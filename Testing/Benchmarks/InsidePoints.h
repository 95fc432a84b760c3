// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points of a horizon are far from its boundary.

#ifndef SeismicHorizonsInsidePoints_h
#define SeismicHorizonsInsidePoints_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <cstddef>
#include <vector>

/// Those with a point in every column that is nearer than `depth` along both axes.
inline std::vector<bool> FindInside(const std::vector<SeismicHorizons::PlanePoint>& columns, int depth)
{
  const SeismicHorizons::PlaneBox box(columns);
  const int width = box.Greatest.X - box.Least.X + 2;
  const int rows = box.Greatest.Y - box.Least.Y + 2;
  std::vector<int> counts(std::size_t(width) * std::size_t(rows), 0); // of the points to the left and below
  const auto at = [&](int x, int y) -> int& { return counts[std::size_t(y) * std::size_t(width) + std::size_t(x)]; };
  for (const SeismicHorizons::PlanePoint& column : columns)
  {
    at(column.X - box.Least.X + 1, column.Y - box.Least.Y + 1) = 1;
  }
  for (int y = 1; y < rows; ++y)
  {
    for (int x = 1; x < width; ++x)
    {
      at(x, y) += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
    }
  }
  const int side = 2 * depth - 1;
  std::vector<bool> isInside;
  for (const SeismicHorizons::PlanePoint& column : columns)
  {
    const int left = column.X - box.Least.X + 1 - depth;
    const int low = column.Y - box.Least.Y + 1 - depth;
    const bool isWithin = left >= 0 && low >= 0 && left + side < width && low + side < rows;
    isInside.push_back(isWithin &&
      at(left + side, low + side) - at(left, low + side) - at(left + side, low) + at(left, low) == side * side);
  }
  return isInside;
}

#endif
