// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SearchGrid.h"

#include "Common/Errors.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
// How far it is to the nearest boundary edge, at most.
constexpr unsigned char FarFromEdges = 255;

// Bounds the memory of the grid, where points are gathered in a small part of their box.
constexpr double MostVoxelsPerPoint = 4.0;

/// The side of a square for each point, in what the boundary encloses.
double SpacingOf(const std::vector<PlanePoint>& points, const Loops& boundary)
{
  PlanePoint size;
  for (const PlanePoint& point : points)
  {
    size = { std::max(size.X, point.X), std::max(size.Y, point.Y) };
  }
  const double box = (double(size.X) + 1.0) * (double(size.Y) + 1.0);
  std::int64_t doubledArea = 0;
  boundary.ForEachEdge(
    [&](PointId from, PointId to) {
      doubledArea += SignedArea({ 0, 0 }, points[std::size_t(to)], points[std::size_t(from)]);
    });
  const double inside = std::max(0.5 * double(doubledArea), box / MostVoxelsPerPoint);
  return std::sqrt(std::min(box, inside) / double(points.size()));
}

/// The nearest power of two, which makes all that is computed of voxels exact.
std::int64_t VoxelSizeFor(double spacing)
{
  return std::int64_t(1) << std::max(0L, std::lround(std::log2(spacing)));
}
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names)
  : PointSpacing(SpacingOf(points, boundary))
  , Grid(points, 1, VoxelSizeFor(this->PointSpacing))
  , Sorted(this->Grid, points, names)
  , EdgesInCell(SortByCell(this->Grid, this->Sorted.Places, boundary.Renumbered(this->Sorted.Numbers)))
{
  this->CheckPlaces();
  this->CheckEdges();
  this->MeasureEdgeDistances();
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SortedPoints::SortedPoints(
  const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names)
  : Places(points.size() + Padding)
  , Names(points.size())
  , Starts(std::size_t(grid.Size()) + 1, 0)
  , Numbers(points.size())
{
  for (const PlanePoint& point : points)
  {
    ++this->Starts[std::size_t(grid.CellOf(point)) + 1];
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  std::vector<PointId> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const PointId number = next[std::size_t(grid.CellOf(points[point]))]++;
    this->Numbers[point] = number;
    this->Places[std::size_t(number)] = points[point];
    this->Names[std::size_t(number)] = names[point];
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Two passes, as a voxel on the shortest way to the nearest edge comes before it in one of both orders.
void SearchGrid::MeasureEdgeDistances()
{
  const std::int64_t sizeX = this->Grid.SizeX();
  const std::int64_t sizeY = this->Grid.SizeY();
  this->EdgeDistances.assign(std::size_t(this->Grid.Size()), FarFromEdges);
  if (this->EdgesInCell.AreEmpty(0, this->Grid.Size() - 1))
  {
    return;
  }
  const auto distance = [this](std::int64_t x, std::int64_t y) -> unsigned char&
  { return this->EdgeDistances[std::size_t(this->Grid.Index(x, y))]; };
  const auto approach = [&](std::int64_t x, std::int64_t y, std::int64_t rowBefore, std::int64_t columnBefore)
  {
    int nearest = FarFromEdges;
    if (rowBefore >= 0 && rowBefore < sizeY)
    {
      for (std::int64_t column = std::max<std::int64_t>(0, x - 1); column <= std::min(x + 1, sizeX - 1); ++column)
      {
        nearest = std::min<int>(nearest, distance(column, rowBefore));
      }
    }
    if (columnBefore >= 0 && columnBefore < sizeX)
    {
      nearest = std::min<int>(nearest, distance(columnBefore, y));
    }
    distance(x, y) = static_cast<unsigned char>(std::min<int>(distance(x, y), nearest + 1));
  };
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    if (!this->EdgesInCell.AreEmpty(cell, cell))
    {
      this->EdgeDistances[std::size_t(cell)] = 0;
    }
  }
  for (std::int64_t y = 0; y < sizeY; ++y)
  {
    for (std::int64_t x = 0; x < sizeX; ++x)
    {
      approach(x, y, y - 1, x - 1);
    }
  }
  for (std::int64_t y = sizeY; y-- > 0;)
  {
    for (std::int64_t x = sizeX; x-- > 0;)
    {
      approach(x, y, y + 1, x + 1);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SearchGrid::CheckPlaces() const
{
  std::vector<PointId> numbers;
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    numbers.resize(std::size_t(this->EndOf(cell) - this->FirstIn(cell)));
    if (numbers.size() < 2)
    {
      continue;
    }
    std::iota(numbers.begin(), numbers.end(), this->FirstIn(cell));
    std::sort(numbers.begin(), numbers.end(), [this](PointId a, PointId b) { return this->At(a) < this->At(b); });
    const auto twin = std::adjacent_find(
      numbers.begin(), numbers.end(), [this](PointId a, PointId b) { return this->At(a) == this->At(b); });
    if (twin != numbers.end())
    {
      const auto names = std::minmax({ this->NameOf(*twin), this->NameOf(*(twin + 1)) });
      throw InputError("points " + std::to_string(names.first) + " and " + std::to_string(names.second) +
        " in one place in plan, expected at most one point of a horizon above each place");
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SearchGrid::CheckEdges() const
{
  const auto name = [this](const BoundaryEdge& edge) {
    return "boundary edge " + std::to_string(this->NameOf(edge.From)) + " - " + std::to_string(this->NameOf(edge.To));
  };
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    for (const BoundaryEdge* edge = this->EdgesInCell.begin(cell); edge != this->EdgesInCell.end(cell); ++edge)
    {
      const PlanePoint& from = this->At(edge->From);
      const PlanePoint& to = this->At(edge->To);
      const BoundaryEdge* const crossing = std::find_if(this->EdgesInCell.begin(cell), edge,
        [&](const BoundaryEdge& other) { return ProperlyCross(from, to, this->At(other.From), this->At(other.To)); });
      if (crossing != edge)
      {
        throw InputError(name(*edge) + " crosses " + name(*crossing) + ", expected edges that meet only at their ends");
      }
      for (PointId point = this->FirstIn(cell); point < this->EndOf(cell); ++point)
      {
        if (OnOpenSegment(from, to, this->At(point)))
        {
          throw InputError("point " + std::to_string(this->NameOf(point)) + " lies on " + name(*edge) +
            ", expected no point between the ends of a boundary edge");
        }
      }
    }
  }
}
}
