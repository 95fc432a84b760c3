// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellSpans.h"
#include "TriangleHeight.h"
#include "TriangleRaster.h"

#include <algorithm>
#include <array>
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
  std::size_t LevelOf;
  std::int64_t X;
  std::int64_t Y;
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
    const PlanTriangle triangle(this->Surface, this->Surface.Triangles[number]);
    const double first = triangle.DoubledArea(0, place.head<2>());
    const double second = triangle.DoubledArea(1, place.head<2>());
    const double third = triangle.DoubledArea(2, place.head<2>());
    const double whole = first + second + third;
    const double least = whole < 0.0 ? -std::max({ first, second, third }) : std::min({ first, second, third });
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
TriangleRaster::Waiting TriangleRaster::MakeWaiting(
  const Eigen::Vector3d& place, const Metric& metric, std::size_t level, std::int64_t x, std::int64_t y) const
{
  const Level& cells = this->Pyramid[level];
  const Heights& heights = cells.Cells[std::size_t(y * cells.Size[0] + x)];
  const double side = std::ldexp(this->Grid.Side, int(level));
  const double reach = 2.0 * this->Grid.Slack;
  const Eigen::Array3d low(this->Grid.Low[0] + double(x) * side - reach, this->Grid.Low[1] + double(y) * side - reach,
    this->Middle + double(heights.Low));
  const Eigen::Array3d high(
    low[0] + side + 2.0 * reach, low[1] + side + 2.0 * reach, this->Middle + double(heights.High));
  const Eigen::Array3d gap = (low - place.array()).max(place.array() - high).max(0.0) * metric.Weights();
  return { gap.square().sum(), level, x, y };
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleRaster::SearchPyramid(
  const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const
{
  std::array<Waiting, MostWaiting> stack;
  std::size_t size = 1;
  stack[0] = { 0.0, this->Pyramid.size() - 1, 0, 0 };
  while (size > 0)
  {
    const Waiting box = stack[--size];
    if (box.SquaredDistance >= best)
    {
      continue;
    }
    if (box.LevelOf == 0)
    {
      this->SearchCells(place, metric, { box.X, box.X }, { box.Y, box.Y }, nearest, best);
      continue;
    }
    const std::size_t level = box.LevelOf - 1;
    const std::size_t oldSize = size;
    for (std::int64_t y = 2 * box.Y; y < std::min(2 * box.Y + 2, this->Pyramid[level].Size[1]); ++y)
    {
      for (std::int64_t x = 2 * box.X; x < std::min(2 * box.X + 2, this->Pyramid[level].Size[0]); ++x)
      {
        const Waiting child = this->MakeWaiting(place, metric, level, x, y);
        if (child.SquaredDistance < best)
        {
          stack[size++] = child;
        }
      }
    }
    std::sort(stack.begin() + std::ptrdiff_t(oldSize), stack.begin() + std::ptrdiff_t(size),
      [](const Waiting& a, const Waiting& b) { return a.SquaredDistance > b.SquaredDistance; });
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
