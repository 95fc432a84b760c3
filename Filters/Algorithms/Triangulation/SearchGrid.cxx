// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SearchGrid.h"

#include "Common/Errors.h"
#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
// The largest distance to boundary edges that is told from larger ones: distances are kept in bytes.
constexpr unsigned char FarFromEdges = 255;

// Bounds the memory of the grid where points are crowded in a small part of their box.
constexpr double MostVoxelsPerPoint = 4.0;

/// The side of a square with the area that there is for each point inside the boundary.
double SpacingOf(const std::vector<PlanePoint>& points, const Loops& boundary)
{
  const PlanePoint size = PlaneBox(points).Greatest; // no coordinate is below 0
  const double box = (double(size.X) + 1.0) * (double(size.Y) + 1.0);
  std::int64_t doubledArea = 0;
  boundary.ForEachEdge(
    [&](PointId from, PointId to) {
      doubledArea += SignedArea({ 0, 0 }, points[std::size_t(to)], points[std::size_t(from)]);
    });
  const double inside = std::max(0.5 * double(doubledArea), box / MostVoxelsPerPoint);
  return std::sqrt(std::min(box, inside) / double(points.size()));
}

/// The power of two that is nearest to the spacing of points: then places in units of voxels are exact.
std::int64_t VoxelSizeFor(double spacing)
{
  return std::int64_t(1) << std::max(0L, std::lround(std::log2(spacing)));
}

/// Distances on a grid, in steps to neighbours, also across corners.
class DistanceField
{
public:
  /// `distances` are those that are known so far, row by row: upper bounds, and 0 where the distance is 0.
  DistanceField(std::int64_t sizeX, std::int64_t sizeY, std::vector<unsigned char>& distances)
    : SizeX(sizeX)
    , SizeY(sizeY)
    , Distances(distances)
  {
  }

  /// Row by row upwards, and in each row to the right.
  void PassUp()
  {
    for (std::int64_t y = 0; y < this->SizeY; ++y)
    {
      for (std::int64_t x = 0; x < this->SizeX; ++x)
      {
        this->Lower(x, y, y - 1, x - 1);
      }
    }
  }

  /// Row by row downwards, and in each row to the left.
  void PassDown()
  {
    for (std::int64_t y = this->SizeY; y-- > 0;)
    {
      for (std::int64_t x = this->SizeX; x-- > 0;)
      {
        this->Lower(x, y, y + 1, x + 1);
      }
    }
  }

private:
  /// Lowers a distance to one more than those of its neighbours in the row before, and of that in the column before.
  void Lower(std::int64_t x, std::int64_t y, std::int64_t rowBefore, std::int64_t columnBefore)
  {
    int nearest = FarFromEdges;
    if (rowBefore >= 0 && rowBefore < this->SizeY)
    {
      for (std::int64_t column = std::max<std::int64_t>(0, x - 1); column <= std::min(x + 1, this->SizeX - 1); ++column)
      {
        nearest = std::min<int>(nearest, this->At(column, rowBefore));
      }
    }
    if (columnBefore >= 0 && columnBefore < this->SizeX)
    {
      nearest = std::min<int>(nearest, this->At(columnBefore, y));
    }
    unsigned char& distance = this->At(x, y);
    distance = static_cast<unsigned char>(std::min<int>(distance, nearest + 1));
  }

  unsigned char& At(std::int64_t x, std::int64_t y) { return this->Distances[std::size_t(y * this->SizeX + x)]; }

  const std::int64_t SizeX;
  const std::int64_t SizeY;
  std::vector<unsigned char>& Distances;
};
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names)
  : PointSpacing(SpacingOf(points, boundary))
  , Grid(points, 1, VoxelSizeFor(this->PointSpacing))
  , Sorted(this->Grid, points, names)
  , EdgesInVoxel(SortByCell(this->Grid, this->Sorted.Places, boundary.Renumbered(this->Sorted.Numbers)))
{
  this->CheckPlaces();
  this->CheckEdges();
  this->MeasureEdgeDistances();
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SortedPoints::SortedPoints(
  const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names)
  : Voxels(grid.Size())
  , Places(points.size() + Padding)
  , Names(points.size())
  , Numbers(points.size())
{
  for (const PlanePoint& point : points)
  {
    this->Voxels.Count(grid.CellOf(point));
  }
  this->Voxels.EndCounting();
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const PointId number = this->Voxels.NextPosition(grid.CellOf(points[point]));
    this->Numbers[point] = number;
    this->Places[std::size_t(number)] = points[point];
    this->Names[std::size_t(number)] = names[point];
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Two passes are enough, as the next voxel on a shortest way to an edge is met earlier in one of their two orders
// (Rosenfeld and Pfaltz, "Sequential operations in digital picture processing", 1966).
void SearchGrid::MeasureEdgeDistances()
{
  this->EdgeDistances.assign(std::size_t(this->Grid.Size()), FarFromEdges);
  if (this->EdgesInVoxel.Size() == 0)
  {
    return;
  }
  for (std::int64_t voxel = 0; voxel < this->Grid.Size(); ++voxel)
  {
    if (!this->EdgesInVoxel.IsEmpty(voxel))
    {
      this->EdgeDistances[std::size_t(voxel)] = 0;
    }
  }
  DistanceField field(this->Grid.SizeX(), this->Grid.SizeY(), this->EdgeDistances);
  field.PassUp();
  field.PassDown();
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
  for (std::int64_t voxel = 0; voxel < this->Grid.Size(); ++voxel)
  {
    for (const Edge* edge = this->EdgesInVoxel.begin(voxel); edge != this->EdgesInVoxel.end(voxel); ++edge)
    {
      this->CheckEdge(edge, voxel);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// With the edges before it in a voxel, and the points there.
void SearchGrid::CheckEdge(const Edge* edge, std::int64_t voxel) const
{
  const PlanePoint& from = this->At(edge->From);
  const PlanePoint& to = this->At(edge->To);
  const Edge* const crossing = std::find_if(this->EdgesInVoxel.begin(voxel), edge,
    [&](const Edge& other) { return ProperlyCross(from, to, this->At(other.From), this->At(other.To)); });
  if (crossing != edge)
  {
    throw InputError(this->Describe(*edge) + " crosses " + this->Describe(*crossing) +
      ", expected edges that meet only at their ends");
  }
  for (PointId point = this->FirstIn(voxel); point < this->EndOf(voxel); ++point)
  {
    if (OnOpenSegment(from, to, this->At(point)))
    {
      throw InputError("point " + std::to_string(this->NameOf(point)) + " lies on " + this->Describe(*edge) +
        ", expected no point between the ends of a boundary edge");
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string SearchGrid::Describe(const Edge& edge) const
{
  return "boundary edge " + std::to_string(this->NameOf(edge.From)) + " - " + std::to_string(this->NameOf(edge.To));
}
}
