// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchCubes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PatchCubes::PatchCubes(CellLeaves& leaves, int size, const Monitor& monitor)
  : Leaves(leaves)
  , CubeSize(size)
  , Bottom(*std::min_element(leaves.Horizon().Height.begin(), leaves.Horizon().Height.end()))
{
  this->MakeCubes(monitor);
  this->MakeTowers();
  this->NumberRings();
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t PatchCubes::LayerOf(PointId point) const
{
  const double layer = std::floor((this->Leaves.Height(point) - this->Bottom) / this->CubeSize);
  return std::int32_t(std::min(layer, double(std::numeric_limits<std::int32_t>::max())));
}

//----------------------------------------------------------------------------------------------------------------------
void PatchCubes::MakeCubes(const Monitor& monitor)
{
  this->Leaves.MakeGroups(
    [this](PointId point)
    {
      const std::int64_t side = this->Leaves.SideOf(point);
      return side * (std::int64_t(1) << 32) + this->LayerOf(point);
    },
    monitor);
  this->Cubes.resize(this->Leaves.NumberOfGroups());
  ParallelFor(this->Leaves.Grid().Size(), CellLeaves::Grain,
    [this](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t cell = begin; cell < end; ++cell)
      {
        std::size_t cube = this->Leaves.FirstGroup(cell);
        this->Leaves.ForEachGroup(cell,
          [&](PointId* first, PointId* last)
          {
            this->Cubes[cube] = { first, last, cell, this->LayerOf(*first), this->Leaves.Patch(*first),
              this->Leaves.HasBoundary(first) ? 1 : 0, 0, CellSizes() };
            ++cube;
          });
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchCubes::MakeTowers()
{
  this->TowersOfCells.assign(std::size_t(this->Leaves.Grid().Size()) + 1, 0);
  for (std::size_t n = 0; n < this->Cubes.size(); ++n)
  {
    PatchCube& cube = this->Cubes[n];
    if (n == 0 || cube.Cell != this->Cubes[n - 1].Cell ||
      this->Leaves.SideOf(*cube.First) != this->Leaves.SideOf(*this->Cubes[n - 1].First))
    {
      this->Towers.push_back({ n, n, cube.Patch, false, CellSizes() });
      ++this->TowersOfCells[std::size_t(cube.Cell) + 1];
    }
    this->Towers.back().End = n + 1;
    cube.Tower = std::uint32_t(this->Towers.size() - 1);
  }
  std::partial_sum(this->TowersOfCells.begin(), this->TowersOfCells.end(), this->TowersOfCells.begin());
}

//----------------------------------------------------------------------------------------------------------------------
/// Calls visit(number) for the towers of the same patch that touch that of a cube, itself included.
template <typename Visitor>
void PatchCubes::ForEachTower(const PatchCube& cube, Visitor&& visit) const
{
  const CellGrid& grid = this->Leaves.Grid();
  const std::int64_t x = cube.Cell % grid.SizeX();
  const std::int64_t y = cube.Cell / grid.SizeX();
  for (std::int64_t row = std::max<std::int64_t>(0, y - 1); row <= std::min(grid.SizeY() - 1, y + 1); ++row)
  {
    const std::int64_t left = grid.Index(std::max<std::int64_t>(0, x - 1), row);
    const std::int64_t right = grid.Index(std::min(grid.SizeX() - 1, x + 1), row);
    for (std::size_t n = this->TowersOfCells[std::size_t(left)]; n < this->TowersOfCells[std::size_t(right) + 1]; ++n)
    {
      if (this->Towers[n].Patch == cube.Patch)
      {
        visit(n);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Calls visit(number) for the patch cubes of the same patch that touch one, itself included.
template <typename Visitor>
void PatchCubes::ForEachNeighbour(const PatchCube& cube, Visitor&& visit) const
{
  const std::int64_t lowest = std::int64_t(cube.Layer) - 1;
  this->ForEachTower(cube,
    [&](std::size_t tower)
    {
      const auto end = this->Cubes.begin() + std::ptrdiff_t(this->Towers[tower].End);
      auto other = std::lower_bound(this->Cubes.begin() + std::ptrdiff_t(this->Towers[tower].First), end, lowest,
        [](const PatchCube& a, std::int64_t layer) { return a.Layer < layer; });
      for (; other != end && other->Layer <= lowest + 2; ++other)
      {
        visit(std::size_t(other - this->Cubes.begin()));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchCubes::NumberRings()
{
  this->AllRings.emplace_back();
  for (std::size_t cube = 0; cube < this->Cubes.size(); ++cube)
  {
    if (this->Cubes[cube].Ring == 1)
    {
      this->AllRings.back().push_back(cube);
    }
  }
  std::size_t reached = this->AllRings.back().size();
  while (reached < this->Cubes.size())
  {
    Ring next = this->FindNextRing();
    reached += next.size();
    this->AllRings.push_back(std::move(next));
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// What touches the last ring; where nothing is left, what touches any ring in plan; and in the end all others.
PatchCubes::Ring PatchCubes::FindNextRing()
{
  const std::int32_t number = std::int32_t(this->AllRings.size()) + 1;
  Ring next;
  const auto take = [&](std::size_t cube)
  {
    if (this->Cubes[cube].Ring == 0)
    {
      this->Cubes[cube].Ring = number;
      next.push_back(cube);
    }
  };
  for (const std::size_t cube : this->AllRings.back())
  {
    this->ForEachNeighbour(this->Cubes[cube], take);
  }
  if (next.empty())
  {
    this->TakeBeyondCliffs(take);
  }
  if (next.empty())
  {
    for (std::size_t cube = 0; cube < this->Cubes.size(); ++cube)
    {
      take(cube);
    }
  }
  return next;
}

//----------------------------------------------------------------------------------------------------------------------
/// Calls take(number) for what touches any ring in plan. Rings that an earlier call has looked at have no neighbours
/// left to take.
template <typename Take>
void PatchCubes::TakeBeyondCliffs(Take&& take)
{
  for (; this->FirstRingWithCliffs < this->AllRings.size(); ++this->FirstRingWithCliffs)
  {
    for (const std::size_t cube : this->AllRings[this->FirstRingWithCliffs])
    {
      this->ForEachTower(this->Cubes[cube], [&](std::size_t tower) { this->TakeTower(this->Towers[tower], take); });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Take>
void PatchCubes::TakeTower(PatchTower& tower, Take& take)
{
  for (std::size_t cube = tower.First; !tower.IsTaken && cube < tower.End; ++cube)
  {
    take(cube);
  }
  tower.IsTaken = true;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchCubes::EndRing(const Ring& ring)
{
  for (const std::size_t cube : ring)
  {
    this->Towers[this->Cubes[cube].Tower].Sizes.Add(this->Cubes[cube].Sizes);
  }
}

//----------------------------------------------------------------------------------------------------------------------
CellSizes PatchCubes::SizesBefore(const PatchCube& cube) const
{
  CellSizes sizes;
  this->ForEachNeighbour(cube,
    [&](std::size_t n)
    {
      if (this->Cubes[n].Ring == cube.Ring - 1)
      {
        sizes.Add(this->Cubes[n].Sizes);
      }
    });
  if (sizes.Number == 0)
  {
    this->ForEachTower(cube, [&](std::size_t tower) { sizes.Add(this->Towers[tower].Sizes); });
  }
  return sizes;
}

//----------------------------------------------------------------------------------------------------------------------
CubeBox PatchCubes::BoxOf(PointId point) const
{
  return this->BoxOf(this->Leaves.Grid().CellOf(this->Leaves.Plane(point)), this->LayerOf(point));
}

//----------------------------------------------------------------------------------------------------------------------
CubeBox PatchCubes::BoxOf(std::int64_t cell, std::int32_t layer) const
{
  const PlanePoint corner = this->Leaves.Grid().Corner(cell);
  const double size = this->CubeSize;
  return { corner.X, corner.Y, this->Bottom + size * layer, this->Leaves.CellSize(), size };
}
}
