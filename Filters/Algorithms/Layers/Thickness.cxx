// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Thickness.h"

#include "Common/ColumnIndex.h"
#include "Common/Errors.h"
#include "Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t ColumnGrain = 1 << 12;

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

/// The slope of a surface along an axis, from its heights before, at and after a column: nan where there is none.
double SlopeOf(double before, double at, double after)
{
  if (std::isnan(before))
  {
    return after - at;
  }
  return std::isnan(after) ? at - before : 0.5 * (after - before);
}

/// The mean of both surfaces, and what its slope makes of a vertical thickness.
class MeanSurface
{
public:
  MeanSurface(PlanePoints columns, std::vector<double> heights, const LatticeSteps& steps)
    : Index(columns)
    , Heights(std::move(heights))
    , Steps(steps)
    , Area(steps.X[0] * steps.Y[1] - steps.X[1] * steps.Y[0])
  {
    if (!std::isfinite(this->Area) || this->Area == 0.0 || steps.Height == 0.0)
    {
      throw InputError("steps of the lattice that are parallel or 0, expected two directions and a height");
    }
  }

  double CosineOfDip(const PlanePoint& column) const
  {
    const std::int64_t place = this->Index.Place(column);
    const double at = this->HeightAt(place);
    const double alongX = SlopeOf(this->HeightAt(place - 1), at, this->HeightAt(place + 1));
    const double alongY =
      SlopeOf(this->HeightAt(place - this->Index.Width()), at, this->HeightAt(place + this->Index.Width()));
    // The gradient in the world has these scalar products with the two steps.
    const double x = (alongX * this->Steps.Y[1] - alongY * this->Steps.X[1]) / this->Area;
    const double y = (alongY * this->Steps.X[0] - alongX * this->Steps.Y[0]) / this->Area;
    return 1.0 / std::sqrt(1.0 + x * x + y * y);
  }

private:
  double HeightAt(std::int64_t place) const
  {
    const PointId point = this->Index[place];
    return point == NoPoint ? std::numeric_limits<double>::quiet_NaN() : this->Heights[std::size_t(point)];
  }

  const ColumnIndex Index; // with an empty rim
  const std::vector<double> Heights;
  const LatticeSteps Steps;
  const double Area; // of a block of columns
};
}

//----------------------------------------------------------------------------------------------------------------------
CommonColumns FindCommonColumns(const std::vector<HorizonView>& horizons)
{
  CommonColumns common;
  for (const HorizonView& horizon : horizons)
  {
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
    std::transform(common.Points.front().begin(), common.Points.front().end(), std::back_inserter(common.Columns),
      [&](PointId point) { return horizons.front().Columns[point]; });
  }
  return common;
}

//----------------------------------------------------------------------------------------------------------------------
Thickness MeasureThickness(const HorizonView& upper, const HorizonView& lower, const LatticeSteps& steps)
{
  CommonColumns common = FindCommonColumns({ upper, lower });
  if (common.Columns.empty())
  {
    throw InputError("two horizons without a column in common, expected horizons that lie above each other");
  }
  Thickness result;
  const std::size_t size = common.Columns.size();
  std::vector<double> mean(size);
  result.Vertical.resize(size);
  result.Crosses.resize(size);
  for (std::size_t n = 0; n < size; ++n)
  {
    const double above = upper.Heights[common.Points[0][n]];
    const double below = lower.Heights[common.Points[1][n]];
    mean[n] = (0.5 * above + 0.5 * below) * steps.Height;
    result.Vertical[n] = (above - below) * steps.Height;
    result.Crosses[n] = result.Vertical[n] < 0.0 ? 1 : 0;
    result.NumberOfCrossings += result.Crosses[n];
  }
  result.Normal.resize(size);
  const MeanSurface surface(common.Columns, std::move(mean), steps);
  ParallelFor(std::int64_t(size), ColumnGrain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        result.Normal[n] = result.Vertical[n] * surface.CosineOfDip(common.Columns[n]);
      }
    });
  result.Columns = std::move(common.Columns);
  result.Points = { std::move(common.Points[0]), std::move(common.Points[1]) };
  return result;
}
}
