// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small bounded horizons for the tests of the stages inside the boundary.

#ifndef SeismicHorizonsTestHorizons_h
#define SeismicHorizonsTestHorizons_h

#include "Boundary/ExteriorBoundary.h"
#include "BoundarySimplification/BoundarySimplification.h"
#include "Common/BoundedHorizon.h"
#include "Patches.h"

#include <cmath>

namespace TestHorizons
{
using namespace SeismicHorizons;

constexpr std::int32_t SubVoxelsPerColumn = 1 << 10;

/// Random heights around a gentle fold.
inline std::vector<double> MakeHeights(const Patches::Columns& columns, Patches::Random& random)
{
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(std::round(20.0 + 5.0 * std::sin(0.3 * column.X + 0.2 * column.Y) + random.Fraction()));
  }
  return heights;
}

inline BoundedHorizon MakeHorizon(const Patches::Columns& columns, const std::vector<double>& heights,
  const BoundaryOptions& options = BoundaryOptions())
{
  ExteriorBoundary boundary = FindExteriorBoundary(columns, options);
  BoundedHorizon horizon;
  for (const PlanePoint& column : columns)
  {
    horizon.Plane.push_back({ column.X * SubVoxelsPerColumn, column.Y * SubVoxelsPerColumn });
  }
  horizon.Height = heights;
  horizon.Patch = std::move(boundary.Patch);
  horizon.Count.assign(columns.size(), 1);
  horizon.Boundary = std::move(boundary.Boundary);
  horizon.SubVoxelsPerColumn = SubVoxelsPerColumn;
  return horizon;
}

/// A horizon whose heights are all 0.
inline BoundedHorizon MakeLevelHorizon(
  const Patches::Columns& columns, const BoundaryOptions& options = BoundaryOptions())
{
  return MakeHorizon(columns, std::vector<double>(columns.size(), 0.0), options);
}

/// The horizon without the points that were dropped from its boundary.
inline BoundedHorizon Drop(const BoundedHorizon& horizon, const BoundarySimplification& simplified)
{
  BoundedHorizon result;
  result.SubVoxelsPerColumn = horizon.SubVoxelsPerColumn;
  std::vector<PointId> number(horizon.Plane.size(), NoPoint);
  for (std::size_t point = 0; point < number.size(); ++point)
  {
    if (simplified.Target[point] == PointId(point))
    {
      number[point] = PointId(result.Plane.size());
      result.Plane.push_back(horizon.Plane[point]);
      result.Height.push_back(horizon.Height[point]);
      result.Patch.push_back(horizon.Patch[point]);
      result.Count.push_back(0);
    }
  }
  for (std::size_t point = 0; point < number.size(); ++point)
  {
    result.Count[std::size_t(number[std::size_t(simplified.Target[point])])] += horizon.Count[point];
  }
  result.Boundary = simplified.Boundary.Renumbered(number);
  return result;
}

/// The horizon that a reduction makes of another one.
inline BoundedHorizon Reduce(const BoundedHorizon& horizon, const Reduction& reduction)
{
  BoundedHorizon result;
  result.SubVoxelsPerColumn = horizon.SubVoxelsPerColumn;
  result.Plane = reduction.Plane;
  result.Height = reduction.Height;
  result.Boundary = reduction.Boundary;
  result.Count.assign(reduction.Source.size(), 0);
  for (const PointId source : reduction.Source)
  {
    result.Patch.push_back(horizon.Patch[std::size_t(source)]);
  }
  for (std::size_t point = 0; point < reduction.Target.size(); ++point)
  {
    result.Count[std::size_t(reduction.Target[point])] += horizon.Count[point];
  }
  return result;
}
}

#endif
