// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DecimationErrors.h"

#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "InsidePoints.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <cmath>

using namespace SeismicHorizons;

namespace DecimationErrors
{
namespace
{
constexpr int Depth = 6;

BoundedHorizon Straighten(const BoundedHorizon& horizon, double tolerance)
{
  BoundarySimplificationOptions options;
  options.Method = OutlineMethod::FewestPoints;
  options.DistanceThreshold = tolerance;
  options.OutlineTolerance = tolerance;
  return TestHorizons::Drop(horizon, SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, options));
}

using Place = std::array<double, 3>;

/// Twice the area in plan.
double AreaOf(const Place& a, const Place& b, const Place& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

class Measurement
{
public:
  explicit Measurement(const Surface& surface)
    : Box(surface.Columns)
    , Width(std::size_t(Box.Greatest.X - Box.Least.X + 1))
    , Points(Width * std::size_t(Box.Greatest.Y - Box.Least.Y + 1), NoPoint)
    , Height(surface.Horizon.Height)
    , Error(surface.Columns.size(), NAN)
  {
    for (std::size_t point = 0; point < surface.Columns.size(); ++point)
    {
      this->PointAt(surface.Columns[point].X, surface.Columns[point].Y) = PointId(point);
    }
  }

  void Add(const Place& a, const Place& b, const Place& c)
  {
    const double area = AreaOf(a, b, c);
    if (area == 0.0)
    {
      return;
    }
    // Vertices between columns are rounded, so that edges have a little width.
    constexpr double rounding = -1e-12;
    const auto [left, right] = this->Range({ a[0], b[0], c[0] }, this->Box.Least.X, this->Box.Greatest.X);
    const auto [low, high] = this->Range({ a[1], b[1], c[1] }, this->Box.Least.Y, this->Box.Greatest.Y);
    for (std::int32_t y = low; y <= high; ++y)
    {
      for (std::int32_t x = left; x <= right; ++x)
      {
        const PointId point = this->PointAt(x, y);
        const Place place = { double(x), double(y), 0.0 };
        const double first = AreaOf(place, b, c) / area;
        const double second = AreaOf(a, place, c) / area;
        const double third = AreaOf(a, b, place) / area;
        if (point != NoPoint && std::min({ first, second, third }) >= rounding)
        {
          const double height = first * a[2] + second * b[2] + third * c[2];
          double& largest = this->Error[std::size_t(point)];
          largest = std::fmax(largest, std::abs(height - this->Height[std::size_t(point)])); // nan until the first
        }
      }
    }
  }

  const std::vector<double>& ErrorByPoint() const { return this->Error; }

private:
  PointId& PointAt(std::int32_t x, std::int32_t y)
  {
    return this->Points[std::size_t(y - this->Box.Least.Y) * this->Width + std::size_t(x - this->Box.Least.X)];
  }

  std::pair<std::int32_t, std::int32_t> Range(const Place& corners, std::int32_t least, std::int32_t greatest) const
  {
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    constexpr double width = 1e-9;
    return { std::int32_t(std::max(std::ceil(*low - width), double(least))),
      std::int32_t(std::min(std::floor(*high + width), double(greatest))) };
  }

  PlaneBox Box;
  std::size_t Width;
  std::vector<PointId> Points; // by row
  const std::vector<double>& Height;
  std::vector<double> Error;
};
}

//----------------------------------------------------------------------------------------------------------------------
Surface::Surface(const Patches::Columns& columns, const std::vector<double>& heights, double tolerance)
  : Horizon(TestHorizons::OnColumns(Straighten(TestHorizons::MakeHorizon(columns, heights), tolerance)))
  , Columns(this->Horizon.Plane)
  , IsInside(FindInside(this->Columns, Depth))
{
}

//----------------------------------------------------------------------------------------------------------------------
Errors Measure(const Surface& surface, const Mesh& mesh)
{
  Measurement measurement(surface);
  std::size_t up = 0;
  std::size_t down = 0;
  for (const auto& corners : mesh.Triangles)
  {
    const Place& a = mesh.Vertices[corners[0]];
    const Place& b = mesh.Vertices[corners[1]];
    const Place& c = mesh.Vertices[corners[2]];
    const double area = AreaOf(a, b, c);
    up += area > 0.0 ? 1 : 0;
    down += area < 0.0 ? 1 : 0;
    measurement.Add(a, b, c);
  }
  Errors errors;
  errors.Folded = std::min(up, down);
  double sum = 0.0;
  double squares = 0.0;
  std::size_t covered = 0;
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    const double error = measurement.ErrorByPoint()[point];
    if (std::isnan(error))
    {
      continue;
    }
    ++covered;
    sum += error;
    squares += error * error;
    errors.Largest = std::max(errors.Largest, error);
    errors.LargestInside = surface.IsInside[point] ? std::max(errors.LargestInside, error) : errors.LargestInside;
  }
  errors.Mean = sum / double(covered);
  errors.RootMeanSquare = std::sqrt(squares / double(covered));
  return errors;
}
}
