// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CommonColumns.h"

#include "Common/ColumnIndex.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
bool IsBefore(const PlanePoint& a, const PlanePoint& b)
{
  return std::tie(a.Y, a.X) < std::tie(b.Y, b.X);
}

/// The points of a horizon row by row.
std::vector<PointId> SortByRows(PlanePoints columns)
{
  std::vector<PointId> points(columns.size());
  std::iota(points.begin(), points.end(), 0);
  const auto isBefore = [&](PointId a, PointId b) { return IsBefore(columns[a], columns[b]); };
  if (!std::is_sorted(columns.begin(), columns.end(), IsBefore))
  {
    std::sort(points.begin(), points.end(), isBefore);
  }
  const auto same =
    std::adjacent_find(points.begin(), points.end(), [&](PointId a, PointId b) { return columns[a] == columns[b]; });
  if (same != points.end())
  {
    throw SameColumnError(std::min(*same, same[1]), std::max(*same, same[1]), columns[*same]);
  }
  return points;
}

/// Columns that so many neighbours of a stack have.
CommonColumns FindColumns(const std::vector<HorizonView>& horizons, std::size_t neighbours)
{
  std::vector<std::vector<PointId>> sorted;
  for (const HorizonView& horizon : horizons)
  {
    sorted.push_back(SortByRows(horizon.Columns));
  }
  CommonColumns result;
  result.Points.resize(horizons.size());
  std::vector<std::size_t> next(horizons.size(), 0);
  std::vector<PointId> points(horizons.size());
  while (true)
  {
    const PlanePoint* column = nullptr; // the first one that is left
    for (std::size_t n = 0; n < horizons.size(); ++n)
    {
      const bool isAny = next[n] < sorted[n].size();
      const PlanePoint* const own = isAny ? &horizons[n].Columns[sorted[n][next[n]]] : nullptr;
      column = own && (!column || IsBefore(*own, *column)) ? own : column;
    }
    if (!column)
    {
      return result;
    }
    std::size_t together = 0; // horizons above each other up to this one
    std::size_t most = 0;
    for (std::size_t n = 0; n < horizons.size(); ++n)
    {
      const bool isIn = next[n] < sorted[n].size() && horizons[n].Columns[sorted[n][next[n]]] == *column;
      points[n] = isIn ? sorted[n][next[n]++] : NoPoint;
      together = isIn ? together + 1 : 0;
      most = std::max(most, together);
    }
    for (std::size_t n = 0; n < horizons.size() && most >= neighbours; ++n)
    {
      result.Points[n].push_back(points[n]);
    }
    if (most >= neighbours)
    {
      result.Columns.push_back(*column);
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
CommonColumns FindCommonColumns(const std::vector<HorizonView>& horizons)
{
  CommonColumns common;
  for (const HorizonView& horizon : horizons)
  {
    const bool isLikeFirst = !common.Points.empty() && common.Points.front().size() == horizon.Columns.size() &&
      std::equal(horizon.Columns.begin(), horizon.Columns.end(), horizons.front().Columns.begin());
    if (isLikeFirst) // as horizons of one survey often are
    {
      common.Points.push_back(common.Points.front());
      continue;
    }
    std::vector<PointId> points = SortByRows(horizon.Columns);
    if (common.Points.empty())
    {
      common.Points.push_back(std::move(points));
      continue;
    }
    const PlanePoints first = horizons.front().Columns;
    std::vector<std::vector<PointId>> both(common.Points.size() + 1);
    auto next = points.begin();
    for (std::size_t n = 0; n < common.Points.front().size(); ++n)
    {
      const PlanePoint& column = first[common.Points.front()[n]];
      next = std::find_if(next, points.end(), [&](PointId point) { return !IsBefore(horizon.Columns[point], column); });
      if (next != points.end() && horizon.Columns[*next] == column)
      {
        for (std::size_t other = 0; other < common.Points.size(); ++other)
        {
          both[other].push_back(common.Points[other][n]);
        }
        both.back().push_back(*next);
      }
    }
    common.Points = std::move(both);
  }
  if (!horizons.empty())
  {
    common.Columns.resize(common.Points.front().size());
    std::transform(common.Points.front().begin(), common.Points.front().end(), common.Columns.begin(),
      [&](PointId point) { return horizons.front().Columns[point]; });
  }
  return common;
}

//----------------------------------------------------------------------------------------------------------------------
CommonColumns FindColumnsOfLayers(const std::vector<HorizonView>& horizons)
{
  return FindColumns(horizons, 2);
}

//----------------------------------------------------------------------------------------------------------------------
CommonColumns FindColumnsOfAny(const std::vector<HorizonView>& horizons)
{
  return FindColumns(horizons, 1);
}
}
