// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SearchGrid.h"

#include "Errors.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// The size of voxels that hold one point each on average: the nearest power of two, which makes all that is computed
/// of them exact.
std::int64_t VoxelSizeFor(const std::vector<PlanePoint>& points)
{
  PlanePoint size;
  for (const PlanePoint& point : points)
  {
    size = { std::max(size.X, point.X), std::max(size.Y, point.Y) };
  }
  const double area = (double(size.X) + 1.0) * (double(size.Y) + 1.0);
  return std::int64_t(1) << std::max(0L, std::lround(0.5 * std::log2(area / double(points.size()))));
}
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names)
  : Grid(points, 1, VoxelSizeFor(points))
  , Sorted(this->Grid, points, names)
  , HopsInCell(SortByCell(this->Grid, this->Sorted.Places, boundary.Renumbered(this->Sorted.Numbers)))
{
  this->CheckPlaces();
  this->CheckEdges();
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SortedPoints::SortedPoints(
  const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names)
  : Places(points.size())
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
  const auto name = [this](const Hop& hop)
  { return "boundary edge " + std::to_string(this->NameOf(hop.From)) + " - " + std::to_string(this->NameOf(hop.To)); };
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    for (const Hop* hop = this->HopsInCell.begin(cell); hop != this->HopsInCell.end(cell); ++hop)
    {
      const PlanePoint& from = this->At(hop->From);
      const PlanePoint& to = this->At(hop->To);
      const Hop* const crossing = std::find_if(this->HopsInCell.begin(cell), hop,
        [&](const Hop& other) { return ProperlyCross(from, to, this->At(other.From), this->At(other.To)); });
      if (crossing != hop)
      {
        throw InputError(name(*hop) + " crosses " + name(*crossing) + ", expected edges that meet only at their ends");
      }
      for (PointId point = this->FirstIn(cell); point < this->EndOf(cell); ++point)
      {
        if (OnOpenSegment(from, to, this->At(point)))
        {
          throw InputError("point " + std::to_string(this->NameOf(point)) + " lies on " + name(*hop) +
            ", expected no point between the ends of a boundary edge");
        }
      }
    }
  }
}
}
