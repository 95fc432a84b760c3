// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmptyBands.h"

#include "ColumnRaster.h"
#include "Common/PlaneGeometry.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// A raster may have so many columns per point, or so many in all, before empty bands are narrowed: it takes 64 bytes
// per point, or 4 megabytes.
constexpr std::int64_t EnoughColumnsPerPoint = 16;
constexpr std::int64_t EnoughColumns = 1 << 20;

/// Throws InputError when two points stand in the same column.
void CheckColumns(const std::vector<PlanePoint>& columns)
{
  std::vector<PointId> order(columns.size());
  std::iota(order.begin(), order.end(), 0);
  const auto column = [&columns](PointId point) -> const PlanePoint& { return columns[std::size_t(point)]; };
  std::stable_sort(order.begin(), order.end(), [&](PointId a, PointId b) { return column(a) < column(b); });
  const auto twin =
    std::adjacent_find(order.begin(), order.end(), [&](PointId a, PointId b) { return column(a) == column(b); });
  if (twin != order.end())
  {
    throw SameColumnError(*twin, *(twin + 1), column(*twin));
  }
}

/// Narrows the bands across one axis to `widest` columns from point to point.
void Narrow(std::vector<PlanePoint>& columns, std::int32_t PlanePoint::*axis, std::int32_t widest)
{
  std::vector<std::int32_t> before;
  before.reserve(columns.size());
  std::transform(columns.begin(), columns.end(), std::back_inserter(before),
    [axis](const PlanePoint& column) { return column.*axis; });
  std::sort(before.begin(), before.end());
  before.erase(std::unique(before.begin(), before.end()), before.end());
  std::vector<std::int32_t> after(before.size(), 0);
  for (std::size_t n = 1; n < before.size(); ++n)
  {
    after[n] = after[n - 1] + std::int32_t(std::min<std::int64_t>(std::int64_t(before[n]) - before[n - 1], widest));
  }
  for (PlanePoint& column : columns)
  {
    const auto found = std::lower_bound(before.begin(), before.end(), column.*axis);
    column.*axis = after[std::size_t(found - before.begin())];
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
bool AreScattered(const std::vector<PlanePoint>& columns)
{
  if (columns.empty())
  {
    return false;
  }
  const PlaneBox box(columns);
  const double width = double(box.Greatest.X) - box.Least.X + 1.0;
  const double height = double(box.Greatest.Y) - box.Least.Y + 1.0;
  return width * height > double(std::max(EnoughColumns, EnoughColumnsPerPoint * std::int64_t(columns.size())));
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> NarrowEmptyBands(std::vector<PlanePoint> columns, int radius)
{
  CheckColumns(columns); // first, so that the message names the columns as they were
  Narrow(columns, &PlanePoint::X, radius + 1);
  Narrow(columns, &PlanePoint::Y, radius + 1);
  return columns;
}
}
