// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyOutline.h"

#include "BlockHeights.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Surface/Surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
namespace
{
constexpr int LeastHop = 8; // columns; narrower bays and spurs go
constexpr double LeastBend = 2.0; // columns
constexpr std::size_t MostCorners = 32;

std::vector<PlanePoint> ListColumns(const SealingInput& input)
{
  const BlockWindow window = WindowOf(input);
  std::vector<unsigned char> isThere(window.Size(), 0);
  for (const SealingHorizon& horizon : input.Horizons)
  {
    for (const PlanePoint& column : horizon.Columns)
    {
      if (window.Contains(column))
      {
        isThere[window.NodeOf(column)] = 1;
      }
    }
  }
  std::vector<PlanePoint> columns;
  window.ForEach([&](const PlanePoint& column, std::size_t node)
    { columns.insert(columns.end(), isThere[node] != 0 ? 1 : 0, column); });
  return columns;
}

double TwiceArea(const std::vector<PlanePoint>& corners)
{
  double area = 0.0;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const PlanePoint &a = corners[n], &b = corners[(n + 1) % corners.size()];
    area += double(a.X) * b.Y - double(b.X) * a.Y;
  }
  return std::abs(area);
}

/// Where a line comes back to a corner, the larger part stays.
std::vector<PlanePoint> KeepLargestPart(std::vector<PlanePoint> corners)
{
  const auto same = [](const PlanePoint& a, const PlanePoint& b) { return a.X == b.X && a.Y == b.Y; };
  for (std::size_t first = 0; first < corners.size(); ++first)
  {
    for (std::size_t last = first + 1; last < corners.size(); ++last)
    {
      if (same(corners[first], corners[last]))
      {
        const auto begin = corners.begin() + std::ptrdiff_t(first), end = corners.begin() + std::ptrdiff_t(last);
        const std::vector<PlanePoint> inner(begin, end);
        std::vector<PlanePoint> outer(corners.begin(), begin);
        outer.insert(outer.end(), end, corners.end());
        return KeepLargestPart(TwiceArea(inner) > TwiceArea(outer) ? inner : outer);
      }
    }
  }
  return corners;
}

/// Corners on the line through their neighbours are none.
std::vector<PlanePoint> DropStraight(const std::vector<PlanePoint>& corners)
{
  std::vector<PlanePoint> kept;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const PlanePoint& before = kept.empty() ? corners.back() : kept.back();
    const bool isCorner = SignedArea(before, corners[n], corners[(n + 1) % corners.size()]) != 0;
    kept.insert(kept.end(), isCorner ? 1 : 0, corners[n]);
  }
  return kept;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> FindSurveyOutline(const SealingInput& input, const Monitor& monitor)
{
  const std::vector<PlanePoint> columns = ListColumns(input);
  BoundaryOptions options;
  options.Radius = std::max(LeastHop, ChooseRadius(columns));
  const ExteriorBoundary boundary = FindExteriorBoundary(columns, options, monitor.Step(0.0, 0.7));
  std::vector<std::size_t> sizes(boundary.NumberOfPatches, 0);
  for (const std::int32_t patch : boundary.Patch)
  {
    sizes[std::size_t(std::max(patch, 0))] += patch >= 0 ? 1 : 0;
  }
  std::vector<PlanePoint> corners;
  if (!sizes.empty())
  {
    Loops largest;
    largest.AppendLoop(boundary.Boundary, std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin()));
    const std::vector<double> level(columns.size(), 0.0);
    BoundarySimplificationOptions simplify;
    simplify.Method = OutlineMethod::FewestPoints;
    simplify.OutlineTolerance = LeastBend;
    Loops simplified = largest;
    do
    {
      simplified = SimplifyBoundary(SpacePoints(columns, level, 1), largest, simplify, monitor.Step(0.7, 1.0)).Boundary;
      simplify.OutlineTolerance *= 2.0;
    } while (simplified.TotalLength() > MostCorners && simplify.OutlineTolerance < double(columns.size()));
    std::for_each(
      simplified.begin(0), simplified.end(0), [&](PointId point) { corners.push_back(columns[std::size_t(point)]); });
    corners = DropStraight(KeepLargestPart(std::move(corners)));
  }
  if (corners.size() < 3 || !(TwiceArea(corners) > 0.0))
  {
    throw InputError("picks that enclose no area, expected an outline for the walls");
  }
  return corners;
}
}
