// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Thickness.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/ColumnIndex.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
/// Lines farther apart are not a grid whose columns represent all bins between; outlines bridge no more, either.
constexpr std::int64_t LargestStep = 32;

/// Returns the step between columns of a horizon, for example 2 if only every second line has points.
std::int64_t StepOf(PlanePoints columns, std::int32_t PlanePoint::*along, std::int32_t PlanePoint::*across)
{
  std::int64_t step = 0;
  for (const PlanePoint& column : columns)
  {
    step = std::gcd(step, std::int64_t(column.*along) - columns.front().*along);
    if (step == 1)
    {
      return 1;
    }
  }
  // A step needs a majority of neighbours: for a few scattered columns it means nothing.
  std::vector<PlanePoint> sorted(columns.begin(), columns.end());
  std::sort(sorted.begin(), sorted.end(),
    [&](const PlanePoint& a, const PlanePoint& b)
    { return a.*across != b.*across ? a.*across < b.*across : a.*along < b.*along; });
  std::int64_t neighbours = 0;
  std::int64_t others = 0;
  for (std::size_t n = 1; n < sorted.size(); ++n)
  {
    if (sorted[n].*across == sorted[n - 1].*across)
    {
      ++(std::int64_t(sorted[n].*along) - sorted[n - 1].*along == step ? neighbours : others);
    }
  }
  return neighbours > others && step <= LargestStep ? step : 1;
}

struct SteppedColumns
{
  std::array<std::int64_t, 2> Step; // columns of the lattice
  std::vector<PlanePoint> Columns; // counted in steps
  std::array<std::vector<PointId>, 2> Points;
  std::int64_t LeftOut = 0;
};

SteppedColumns FindColumns(const HorizonView& first, const HorizonView& other)
{
  const CommonColumns all = FindStackColumns({ first, other }, 1);
  SteppedColumns found;
  found.Step = { std::lcm(StepOf(first.Columns, &PlanePoint::X, &PlanePoint::Y),
                   StepOf(other.Columns, &PlanePoint::X, &PlanePoint::Y)),
    std::lcm(
      StepOf(first.Columns, &PlanePoint::Y, &PlanePoint::X), StepOf(other.Columns, &PlanePoint::Y, &PlanePoint::X)) };
  const auto areBoth = [&all](std::size_t n) { return all.Points[0][n] != NoPoint && all.Points[1][n] != NoPoint; };
  std::size_t n = 0;
  for (; n < all.Columns.size() && !areBoth(n); ++n)
  {
  }
  if (n == all.Columns.size())
  {
    throw InputError("no column with points of both horizons, expected some");
  }
  const PlanePoint origin = all.Columns[n];
  for (n = 0; n < all.Columns.size(); ++n)
  {
    const std::int64_t x = std::int64_t(all.Columns[n].X) - origin.X;
    const std::int64_t y = std::int64_t(all.Columns[n].Y) - origin.Y;
    if (areBoth(n))
    {
      found.Columns.push_back({ std::int32_t(x / found.Step[0]), std::int32_t(y / found.Step[1]) });
      found.Points[0].push_back(all.Points[0][n]);
      found.Points[1].push_back(all.Points[1][n]);
    }
    else if (x % found.Step[0] == 0 && y % found.Step[1] == 0)
    {
      ++found.LeftOut;
    }
  }
  return found;
}

double StepAlong(
  const ColumnIndex& index, const std::vector<double>& heights, PointId point, std::int64_t place, std::int64_t next)
{
  const auto step = [&](std::int64_t way)
  {
    const PointId beside = index[place + way];
    return beside == NoPoint ? NoValue : (heights[beside] - heights[point]) * (way > 0 ? 1.0 : -1.0);
  };
  const double forward = step(next);
  const double backward = step(-next);
  return std::isnan(backward) || std::abs(forward) < std::abs(backward) ? forward : backward;
}

void Count(Thickness& result)
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
      result.Volume += result.Area * std::max(0.0, thickness);
    }
  }
  result.Mean = sum / double(result.Columns);
}
}

//----------------------------------------------------------------------------------------------------------------------
LatticeScale ScaleOf(const Lattice& lattice)
{
  const Eigen::Vector3d origin = lattice.ToWorld(Eigen::Vector3d::Zero());
  LatticeScale scale;
  scale.Plane.col(0) = (lattice.ToWorld(Eigen::Vector3d::UnitX()) - origin).head<2>();
  scale.Plane.col(1) = (lattice.ToWorld(Eigen::Vector3d::UnitY()) - origin).head<2>();
  scale.Height = (lattice.ToWorld(Eigen::Vector3d::UnitZ()) - origin).z();
  return scale;
}

//----------------------------------------------------------------------------------------------------------------------
Thickness MeasureThickness(
  const HorizonView& first, const HorizonView& other, const LatticeScale& scale, const Monitor& monitor)
{
  assert(first.Columns.empty() || first.Heights);
  assert(other.Columns.empty() || other.Heights);
  monitor.Progress(0.0);
  const SteppedColumns columns = FindColumns(first, other);
  monitor.Progress(0.4);
  const std::size_t size = columns.Columns.size();
  std::vector<double> isochore(size);
  std::vector<double> means(size);
  std::int64_t above = 0; // minus columns where the other horizon is above
  for (std::size_t n = 0; n < size; ++n)
  {
    const double height = first.Heights[columns.Points[0][n]];
    const double below = other.Heights[columns.Points[1][n]];
    isochore[n] = scale.Height * (height - below);
    means[n] = 0.5 * height + 0.5 * below;
    above += isochore[n] > 0.0 ? 1 : isochore[n] < 0.0 ? -1 : 0;
  }
  monitor.Progress(0.5);
  Thickness result;
  result.LeftOut = columns.LeftOut;
  result.Isochore.assign(first.Columns.size(), NoValue);
  result.Isopach = result.Isochore;
  Eigen::Matrix2d plane = scale.Plane;
  plane.col(0) *= double(columns.Step[0]);
  plane.col(1) *= double(columns.Step[1]);
  result.Area = std::abs(plane.determinant());
  const Eigen::Matrix2d toWorld = plane.transpose().inverse();
  const ColumnIndex index(columns.Columns, 1, 1);
  ParallelFor(std::int64_t(size), Grain, monitor.Step(0.5, 0.9),
    [&](std::int64_t begin, std::int64_t end)
    {
      for (PointId n = PointId(begin); n < PointId(end); ++n)
      {
        const PointId point = columns.Points[0][std::size_t(n)];
        const std::int64_t place = index.Place(index.Columns()[std::size_t(n)]);
        const Eigen::Vector2d steps(
          StepAlong(index, means, n, place, 1), StepAlong(index, means, n, place, index.Width()));
        const double slope = (toWorld * steps).norm() * std::abs(scale.Height);
        result.Isochore[std::size_t(point)] = isochore[std::size_t(n)] * (above < 0 ? -1.0 : 1.0) + 0.0; // not -0
        result.Isopach[std::size_t(point)] = result.Isochore[std::size_t(point)] / std::sqrt(1.0 + slope * slope);
      }
    });
  Count(result);
  monitor.Progress(1.0);
  return result;
}
}
