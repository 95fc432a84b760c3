// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Thickness.h"

#include "Common/ColumnIndex.h"
#include "Common/Errors.h"
#include "Common/Parallel.h"
#include "Common/PlaneGeometry.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

// How many points a thread looks at at a time.
constexpr std::int64_t Grain = 1 << 14;

/// The heights of a horizon at the points of another one, nan where it has none.
std::vector<double> HeightsAt(const ColumnIndex& index, const ColumnSurface& other)
{
  const PlaneBox box(index.Columns());
  std::vector<double> heights(index.Columns().size(), NotKnown);
  for (std::size_t n = 0; n < other.Columns.size(); ++n)
  {
    const PlanePoint& column = other.Columns[n];
    const bool isInside =
      column.X >= box.Least.X && column.X <= box.Greatest.X && column.Y >= box.Least.Y && column.Y <= box.Greatest.Y;
    const PointId point = isInside ? index[index.Place(column)] : NoPoint;
    if (point != NoPoint && !std::isnan(heights[point]))
    {
      throw InputError("two points of the other horizon in the column (" + std::to_string(column.X) + ", " +
        std::to_string(column.Y) + "), expected one");
    }
    if (point != NoPoint)
    {
      heights[point] = other.Height[n];
    }
  }
  return heights;
}

/// The steps of heights to the next columns, of which the flatter one counts; nan where there is none.
double StepAlong(
  const ColumnIndex& index, const std::vector<double>& heights, PointId point, std::int64_t place, std::int64_t next)
{
  const auto step = [&](std::int64_t way)
  {
    const PointId beside = index[place + way];
    return beside == NoPoint ? NotKnown : (heights[beside] - heights[point]) * (way > 0 ? 1.0 : -1.0);
  };
  const double forward = step(next);
  const double backward = step(-next);
  return std::isnan(backward) || std::abs(forward) < std::abs(backward) ? forward : backward;
}

/// Counts what is known, which is at least one column.
void Count(Thickness& result, double area)
{
  result.Least = std::numeric_limits<double>::infinity();
  result.Largest = -result.Least;
  double sum = 0.0;
  for (const double thickness : result.Isochore)
  {
    if (!std::isnan(thickness))
    {
      ++result.Columns;
      result.Crossings += thickness < 0.0 ? 1 : 0;
      result.Least = std::min(result.Least, thickness);
      result.Largest = std::max(result.Largest, thickness);
      sum += thickness;
      result.Volume += area * std::max(0.0, thickness);
    }
  }
  result.Mean = sum / double(result.Columns);
}
}

//----------------------------------------------------------------------------------------------------------------------
Thickness MeasureThickness(
  const ColumnSurface& first, const ColumnSurface& other, const LatticeScale& scale, const Monitor& monitor)
{
  const ColumnIndex index(first.Columns);
  const std::vector<double> below = HeightsAt(index, other);
  monitor.Progress(0.3);
  Thickness result;
  result.Isochore.resize(below.size());
  std::vector<double> means(below.size());
  std::int64_t above = 0; // less those where the other one is
  for (std::size_t n = 0; n < below.size(); ++n)
  {
    result.Isochore[n] = scale.Height * (first.Height[n] - below[n]);
    means[n] = 0.5 * first.Height[n] + 0.5 * below[n];
    above += result.Isochore[n] > 0.0 ? 1 : result.Isochore[n] < 0.0 ? -1 : 0;
  }
  if (std::all_of(below.begin(), below.end(), [](double height) { return std::isnan(height); }))
  {
    throw InputError("no column with points of both horizons, expected some");
  }
  result.Isopach.assign(below.size(), NotKnown);
  const Eigen::Matrix2d toWorld = scale.Plane.transpose().inverse();
  ParallelFor(std::int64_t(below.size()), Grain, monitor.Step(0.3, 1.0),
    [&](std::int64_t begin, std::int64_t end)
    {
      for (PointId point = PointId(begin); point < PointId(end); ++point)
      {
        result.Isochore[point] *= above < 0 ? -1.0 : 1.0;
        const std::int64_t place = index.Place(index.Columns()[point]);
        const Eigen::Vector2d steps(
          StepAlong(index, means, point, place, 1), StepAlong(index, means, point, place, index.Width()));
        const double slope = (toWorld * steps).norm() * std::abs(scale.Height);
        result.Isopach[point] = result.Isochore[point] / std::sqrt(1.0 + slope * slope);
      }
    });
  Count(result, std::abs(scale.Plane.determinant()));
  return result;
}
}
