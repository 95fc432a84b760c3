// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CommonColumns.h"

#include "Common/ColumnIndex.h"
#include "Common/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
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
  const auto isNotBefore = [](const PlanePoint& a, const PlanePoint& b) { return !IsBefore(a, b); };
  if (std::adjacent_find(columns.begin(), columns.end(), isNotBefore) == columns.end())
  {
    return points;
  }
  std::sort(points.begin(), points.end(), [&](PointId a, PointId b) { return IsBefore(columns[a], columns[b]); });
  const auto same =
    std::adjacent_find(points.begin(), points.end(), [&](PointId a, PointId b) { return columns[a] == columns[b]; });
  if (same != points.end())
  {
    throw SameColumnError(std::min(*same, same[1]), std::max(*same, same[1]), columns[*same]);
  }
  return points;
}

/// Calls call(n) for all points, on threads.
template <typename Call>
void ForEach(const std::vector<PointId>& points, Call&& call)
{
  constexpr std::int64_t Grain = 1 << 14;
  ParallelFor(std::int64_t(points.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto n = std::size_t(first); n < std::size_t(last); ++n)
      {
        call(n);
      }
    });
}

/// Those for which keep(point) is true, which is asked on threads.
template <typename Keep>
void KeepIf(std::vector<PointId>& points, Keep&& keep)
{
  std::vector<unsigned char> isKept(points.size());
  ForEach(points, [&](std::size_t n) { isKept[n] = keep(points[n]) ? 1 : 0; });
  auto next = isKept.begin();
  points.erase(std::remove_if(points.begin(), points.end(), [&next](PointId) { return *next++ == 0; }), points.end());
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
  if (horizons.empty())
  {
    return common;
  }
  const PlanePoints first = horizons.front().Columns;
  std::vector<std::optional<ColumnIndex>> indices(horizons.size()); // none where columns are as of the first
  ParallelFor(std::int64_t(horizons.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto n = std::size_t(begin); n < std::size_t(end); ++n)
      {
        const PlanePoints own = horizons[n].Columns;
        if (!std::equal(own.begin(), own.end(), first.begin(), first.end()))
        {
          indices[n].emplace(own);
        }
      }
    });
  const auto pointOf = [&](std::size_t n, PointId point)
  { return indices[n] ? indices[n]->PointAt(first[std::size_t(point)]) : point; };
  std::vector<PointId> points = SortByRows(first);
  KeepIf(points,
    [&](PointId point)
    {
      std::size_t n = 1;
      for (; n < horizons.size() && pointOf(n, point) != NoPoint; ++n)
      {
      }
      return n == horizons.size();
    });
  common.Columns.resize(points.size());
  ForEach(points, [&](std::size_t n) { common.Columns[n] = first[std::size_t(points[n])]; });
  for (std::size_t horizon = 0; horizon < horizons.size(); ++horizon)
  {
    common.Points.emplace_back(points.size());
    ForEach(points, [&](std::size_t n) { common.Points.back()[n] = pointOf(horizon, points[n]); });
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
