// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellSpans.h"
#include "SearchStack.h"
#include "TriangleHeight.h"
#include "TriangleRaster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
// Within so many cells all triangles are tried; where there are more, the pyramid is searched.
constexpr std::int64_t FewCells = 16;

// On each level a box is taken off the stack and four are put there; 64 levels are more than there can be.
constexpr std::size_t MostWaiting = 3 * 64 + 1;

// How far outside a triangle a place still counts as across: of its area. It is then searched for anything nearer all
// the same.
constexpr double Across = 1e-9;

double Square(double value)
{
  return value * value;
}

/// Whether the box of a triangle in plan reaches a place up to a tolerance.
bool MayReach(const PlanTriangle& triangle, const Eigen::Vector3d& place, double tolerance)
{
  const auto low = triangle.Corner[0].array().min(triangle.Corner[1].array()).min(triangle.Corner[2].array());
  const auto high = triangle.Corner[0].array().max(triangle.Corner[1].array()).max(triangle.Corner[2].array());
  const auto plan = place.head<2>().array();
  return (low - plan).max(plan - high).maxCoeff() <= tolerance;
}
}

/// A box that is still to be searched.
struct TriangleRaster::Waiting
{
  double SquaredDistance;
  std::uint32_t LevelOf;
  std::uint32_t X;
  std::uint32_t Y;
};

//----------------------------------------------------------------------------------------------------------------------
std::int32_t TriangleRaster::FindAcross(const Eigen::Vector3d& place) const
{
  const std::int64_t cell = this->Grid.CellOf(place);
  if (cell < 0)
  {
    return -1;
  }
  for (std::uint32_t n = this->Sort.First(cell); n < this->Sort.End(cell); ++n)
  {
    const std::uint32_t number = this->Items[n] & ~OwnerBit;
    const Corners& t = this->Surface.Triangles[number];
    const auto [first, second, third] =
      DoubledAreas(place, this->Surface.Point(t[0]), this->Surface.Point(t[1]), this->Surface.Point(t[2]));
    const double whole = first + second + third;
    const double least =
      whole < 0.0 ? -std::max(std::max(first, second), third) : std::min(std::min(first, second), third);
    if (least >= -Across * std::abs(whole))
    {
      return std::int32_t(number);
    }
  }
  return -1;
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::SearchCells(const Eigen::Vector3d& place, const Metric& metric, const CellRange& x,
  const CellRange& y, std::int32_t& nearest, double& best) const
{
  for (std::int64_t row = y.First; row <= y.Last; ++row)
  {
    const std::uint32_t end = this->Sort.End(row * this->Grid.Size[0] + x.Last);
    for (std::uint32_t n = this->Sort.First(row * this->Grid.Size[0] + x.First); n < end; ++n)
    {
      const std::int32_t triangle = std::int32_t(this->Items[n] & ~OwnerBit);
      const Corners& corners = this->Surface.Triangles[std::size_t(triangle)];
      if (triangle != nearest && metric.SquaredDistanceToBox(this->Surface, corners, place) < best)
      {
        const double distance = metric.SquaredDistance(this->Surface, corners, place);
        nearest = distance < best ? triangle : nearest;
        best = std::min(best, distance);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Puts those of the four boxes below a box on the stack that are nearer than the best triangle, the nearest one last.
TriangleRaster::Waiting* TriangleRaster::PushChildren(
  const Eigen::Vector3d& place, const Metric& metric, const Waiting& box, double best, Waiting* end) const
{
  const Level& cells = this->Pyramid[box.LevelOf - 1];
  const double reach = 2.0 * this->Grid.Slack;
  const std::int64_t first[2] = { 2 * box.X, 2 * box.Y };
  double gaps[2][2]; // by axis, squared
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int n = 0; n < 2; ++n)
    {
      const double low = this->Grid.Low[axis] + double(first[axis] + n) * cells.Side - reach;
      const double gap = std::max(low - place[axis], place[axis] - (low + cells.Side + 2.0 * reach));
      gaps[axis][n] = Square(std::max(gap, 0.0) * metric.Weights()[axis]);
    }
  }
  Waiting* next = end;
  for (int y = 0; y < 2 && first[1] + y < cells.Size[1]; ++y)
  {
    for (int x = 0; x < 2 && first[0] + x < cells.Size[0]; ++x)
    {
      const Heights& heights = cells.Cells[std::size_t((first[1] + y) * cells.Size[0] + first[0] + x)];
      const double height = place.z() - this->Middle;
      const double gap = std::max(double(heights.Low) - height, height - double(heights.High));
      const double squared = gaps[0][x] + gaps[1][y] + Square(std::max(gap, 0.0) * metric.Weights()[2]);
      if (squared < best)
      {
        *next++ = { squared, std::uint32_t(box.LevelOf - 1), std::uint32_t(first[0] + x), std::uint32_t(first[1] + y) };
      }
    }
  }
  SortByDistance(end, next);
  return next;
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::SearchPyramid(
  const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const
{
  Waiting stack[MostWaiting];
  Waiting* end = stack;
  *end++ = { 0.0, std::uint32_t(this->Pyramid.size() - 1), 0, 0 };
  while (end != stack)
  {
    const Waiting box = *--end;
    if (box.SquaredDistance >= best)
    {
      continue;
    }
    if (box.LevelOf == 0)
    {
      this->SearchCells(place, metric, { box.X, box.X }, { box.Y, box.Y }, nearest, best);
      continue;
    }
    end = this->PushChildren(place, metric, box, best, end);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::Search(
  const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const
{
  const Eigen::Array2d reach = std::sqrt(best) / metric.Weights().head<2>() + 2.0 * this->Grid.Slack;
  const CellRange x = this->Grid.Range(0, place.x() - reach[0], place.x() + reach[0]);
  const CellRange y = this->Grid.Range(1, place.y() - reach[1], place.y() + reach[1]);
  if (x.Size() <= 0 || y.Size() <= 0)
  {
    return;
  }
  if (x.Size() <= FewCells && y.Size() <= FewCells && x.Size() * y.Size() <= FewCells)
  {
    this->SearchCells(place, metric, x, y, nearest, best);
    return;
  }
  this->SearchPyramid(place, metric, nearest, best);
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleRaster::FindHeight(const Eigen::Vector3d& point, double tolerance) const
{
  const double reach = 2.0 * (tolerance + this->Grid.Slack);
  const CellRange x = this->Grid.Range(0, point.x() - reach, point.x() + reach);
  const CellRange y = this->Grid.Range(1, point.y() - reach, point.y() + reach);
  double best = std::numeric_limits<double>::quiet_NaN();
  for (std::int64_t row = y.First; row <= y.Last; ++row)
  {
    for (std::int64_t column = x.First; column <= x.Last; ++column)
    {
      const std::int64_t cell = row * this->Grid.Size[0] + column;
      for (std::uint32_t n = this->Sort.First(cell); n < this->Sort.End(cell); ++n)
      {
        const Corners& t = this->Surface.Triangles[this->Items[n] & ~OwnerBit];
        if (MayReach(PlanTriangle(this->Surface, t), point, 2.0 * tolerance))
        {
          best = NearerHeight(this->Surface, t, point, tolerance, best);
        }
      }
    }
  }
  return best;
}
}
