// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CommonColumns.h"

#include "Common/Horizon/ColumnIndex.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
std::vector<PointId> SortByRows(PlanePoints columns)
{
  std::vector<PointId> points(columns.size());
  std::iota(points.begin(), points.end(), 0);
  const auto isNotBefore = [](const PlanePoint& a, const PlanePoint& b) { return !PrecedesByRow(a, b); };
  if (std::adjacent_find(columns.begin(), columns.end(), isNotBefore) == columns.end())
  {
    return points;
  }
  std::sort(points.begin(), points.end(), [&](PointId a, PointId b) { return PrecedesByRow(columns[a], columns[b]); });
  const auto same =
    std::adjacent_find(points.begin(), points.end(), [&](PointId a, PointId b) { return columns[a] == columns[b]; });
  if (same != points.end())
  {
    throw SameColumnError(std::min(*same, same[1]), std::max(*same, same[1]), columns[*same]);
  }
  return points;
}
}

//----------------------------------------------------------------------------------------------------------------------
CommonColumns FindStackColumns(const std::vector<HorizonView>& horizons, std::size_t together)
{
  std::vector<std::vector<PointId>> sorted;
  for (const HorizonView& horizon : horizons)
  {
    sorted.push_back(SortByRows(horizon.Columns));
  }
  CommonColumns result;
  const auto isSame = [&horizons](const HorizonView& horizon)
  {
    const PlanePoints& first = horizons.front().Columns;
    return std::equal(first.begin(), first.end(), horizon.Columns.begin(), horizon.Columns.end());
  };
  if (!horizons.empty() && together <= horizons.size() && std::all_of(horizons.begin(), horizons.end(), isSame))
  {
    for (const PointId point : sorted.front())
    {
      result.Columns.push_back(horizons.front().Columns[point]);
    }
    result.Points = std::move(sorted);
    return result;
  }
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
      column = own && (!column || PrecedesByRow(*own, *column)) ? own : column;
    }
    if (!column)
    {
      return result;
    }
    std::size_t successive = 0; // horizons up to this one
    std::size_t most = 0;
    for (std::size_t n = 0; n < horizons.size(); ++n)
    {
      const bool isIn = next[n] < sorted[n].size() && horizons[n].Columns[sorted[n][next[n]]] == *column;
      points[n] = isIn ? sorted[n][next[n]++] : NoPoint;
      successive = isIn ? successive + 1 : 0;
      most = std::max(most, successive);
    }
    if (most >= together)
    {
      result.Columns.push_back(*column);
      for (std::size_t n = 0; n < horizons.size(); ++n)
      {
        result.Points[n].push_back(points[n]);
      }
    }
  }
}
}
