// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: sort the points into cubes, patch by patch; number the rings; cut the cubes ring by ring; write the points.
//
// Terms: a cube is the points of one patch in one cube. Its level is 0, that of a piece how many times it was halved.
// Sizes are counted in units of the smallest piece, so that their sums are exact.
//
//    ring  1  1  1  1  1  1        Cubes of one ring read the leaves of the ring before and write their own,
//          1  2  2  2  2  1        so that all of them can run at the same time.
//          1  2  3  3  2  1
//          1  1  1  2  1  1

#include "ElaborateSimplification.h"

#include "OctreeCutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
using Iterator = CellSimplifier::Iterator;

constexpr double HalfALevel = 1.4142135623730951; // a level is a factor of 2

void CheckAtLeast(const char* name, double value, double least, const char* unit)
{
  if (!(value >= least))
  {
    std::ostringstream text;
    text << name << ' ' << value << ", expected at least " << least << unit;
    throw InputError(text.str());
  }
}

void CheckOptions(const ElaborateOptions& options)
{
  CheckAtLeast("flatness threshold", options.FlatnessThreshold, 0.0, " (a plane), and 1/3 at the most");
  CheckAtLeast("boundary density threshold", options.BoundaryDensityThreshold, 0.0, " points per lattice unit");
  CheckAtLeast("boundary extent threshold", options.BoundaryExtentThreshold, 0.0, " lattice units");
  CheckAtLeast("boundary cell size threshold", options.BoundaryCellSizeThreshold, 0.0, " lattice units");
  CheckAtLeast("growth per ring", options.GrowthPerRing, 1.0, " (cells as large as their neighbours)");
}

/// How often a cell can be halved before its side falls below one column.
int Halvings(int size)
{
  return size < 2 ? 0 : 1 + Halvings(size / 2);
}

class ElaborateSimplifier
{
public:
  ElaborateSimplifier(const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor)
    : Horizon(horizon)
    , Options(options)
    , Bottom(*std::min_element(horizon.Height.begin(), horizon.Height.end()))
    , Deepest(Halvings(options.CellSize))
    , Cells(horizon, options, monitor)
  {
  }

  Reduction Run(const Monitor& monitor)
  {
    this->MakeCubes(monitor.Step(0.0, 0.2));
    this->NumberRings();
    std::size_t done = 0;
    for (const std::vector<std::size_t>& ring : this->Rings)
    {
      const Monitor step = monitor.Step(0.2 + 0.4 * this->Part(done), 0.2 + 0.4 * this->Part(done + ring.size()));
      ParallelFor(std::int64_t(ring.size()), 64, step,
        [&](std::int64_t first, std::int64_t last) { this->CutCubes(ring.data() + first, ring.data() + last); });
      done += ring.size();
    }
    Reduction result = this->Cells.Write(monitor.Step(0.6, 0.95));
    this->WriteRings(result);
    if (this->Options.ListCells)
    {
      this->Cells.ListCells(
        result, [this](Iterator first, Iterator, int level) { return this->BoxBottom(*first, level); });
    }
    return result;
  }

private:
  double Part(std::size_t cubes) const { return double(cubes) / double(this->Cubes.size()); }

  std::int32_t LayerOf(PointId point) const
  {
    const double layer = std::floor((this->Horizon.Height[std::size_t(point)] - this->Bottom) / this->Options.CellSize);
    return std::int32_t(std::min(layer, double(std::numeric_limits<std::int32_t>::max())));
  }

  void MakeCubes(const Monitor& monitor)
  {
    this->Cells.MakeGroups(
      [this](PointId point)
      {
        const std::int64_t patch = this->Horizon.Patch[std::size_t(point)];
        return patch * (std::int64_t(1) << 32) + this->LayerOf(point);
      },
      monitor);
    this->Cubes.resize(this->Cells.NumberOfGroups());
    ParallelFor(this->Cells.Grid().Size(), 1024,
      [this](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t cell = begin; cell < end; ++cell)
        {
          std::size_t cube = this->Cells.FirstGroup(cell);
          this->Cells.ForEachLeaf(cell,
            [&](Iterator first, Iterator last)
            {
              this->Cubes[cube] = { first, last, cell, this->Horizon.Patch[std::size_t(*first)], this->LayerOf(*first),
                this->Cells.HasBoundary(first) ? 1 : 0, LeafSizes() };
              ++cube;
            });
        }
      });
  }

  /// Calls visit(neighbour) for the cubes of the same patch that touch a cube; with `anyHeight`, for those that do in
  /// plan.
  template <typename Visitor>
  void ForEachNeighbour(const PatchCube& cube, bool anyHeight, Visitor&& visit) const
  {
    const CellGrid& grid = this->Cells.Grid();
    const std::int64_t x = cube.Cell % grid.SizeX();
    const std::int64_t y = cube.Cell / grid.SizeX();
    for (std::int64_t row = std::max<std::int64_t>(0, y - 1); row <= std::min(grid.SizeY() - 1, y + 1); ++row)
    {
      const std::int64_t left = grid.Index(std::max<std::int64_t>(0, x - 1), row);
      const std::int64_t right = grid.Index(std::min(grid.SizeX() - 1, x + 1), row);
      for (std::size_t n = this->Cells.FirstGroup(left); n < this->Cells.FirstGroup(right + 1); ++n)
      {
        const PatchCube& other = this->Cubes[n];
        const std::int64_t up = std::int64_t(other.Layer) - cube.Layer;
        if (&other != &cube && other.Patch == cube.Patch && (anyHeight || (up >= -1 && up <= 1)))
        {
          visit(n);
        }
      }
    }
  }

  void NumberRings()
  {
    this->Rings.emplace_back();
    for (std::size_t cube = 0; cube < this->Cubes.size(); ++cube)
    {
      if (this->Cubes[cube].Ring == 1)
      {
        this->Rings.back().push_back(cube);
      }
    }
    std::size_t reached = this->Rings.back().size();
    while (reached < this->Cubes.size())
    {
      std::vector<std::size_t> next = this->NextRing();
      reached += next.size();
      this->Rings.push_back(std::move(next));
    }
  }

  std::vector<std::size_t> NextRing()
  {
    const std::int32_t number = std::int32_t(this->Rings.size()) + 1;
    std::vector<std::size_t> next;
    const auto take = [&](std::size_t cube)
    {
      if (this->Cubes[cube].Ring == 0)
      {
        this->Cubes[cube].Ring = number;
        next.push_back(cube);
      }
    };
    for (const std::size_t cube : this->Rings.back())
    {
      this->ForEachNeighbour(this->Cubes[cube], false, take);
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

  /// Looks only at rings that were not looked at before: around those nothing is left.
  template <typename Take>
  void TakeBeyondCliffs(Take&& take)
  {
    for (; this->FirstRingWithCliffs < this->Rings.size(); ++this->FirstRingWithCliffs)
    {
      for (const std::size_t cube : this->Rings[this->FirstRingWithCliffs])
      {
        this->ForEachNeighbour(this->Cubes[cube], true, take);
      }
    }
  }

  void CutCubes(const std::size_t* first, const std::size_t* last)
  {
    OctreeCutter cutter(this->Cells, this->Options, this->Deepest);
    for (; first != last; ++first)
    {
      PatchCube& cube = this->Cubes[*first];
      cube.Leaves = cutter.Cut(cube, this->BoxOf(cube.Cell, cube.Layer), this->LeastLevel(cube));
    }
  }

  /// How often the leaves of a cube are halved at least: to the level whose size is nearest to the mean of those
  /// before (thesis eq. 4.3), by ratio. To always round down would make cells shrink from ring to ring, as any mix of
  /// sizes has its mean below the largest.
  int LeastLevel(const PatchCube& cube) const
  {
    LeafSizes before = this->SizesBefore(cube, false);
    if (before.Number == 0)
    {
      before = this->SizesBefore(cube, true);
    }
    const double largest = HalfALevel * this->Options.GrowthPerRing * double(before.Sum);
    int level = 0;
    while (level<this->Deepest&& double(before.Number) * double(std::int64_t(1) << (this->Deepest - level))> largest)
    {
      ++level;
    }
    return level;
  }

  /// The leaves of the neighbours one ring further out; with `anyHeight`, of those in plan in any ring further out.
  LeafSizes SizesBefore(const PatchCube& cube, bool anyHeight) const
  {
    LeafSizes sizes;
    this->ForEachNeighbour(cube, anyHeight,
      [&](std::size_t n)
      {
        const std::int32_t outwards = cube.Ring - this->Cubes[n].Ring;
        if (anyHeight ? outwards > 0 : outwards == 1)
        {
          sizes.Sum += this->Cubes[n].Leaves.Sum;
          sizes.Number += this->Cubes[n].Leaves.Number;
        }
      });
    return sizes;
  }

  CubeBox BoxOf(std::int64_t cell, std::int32_t layer) const
  {
    const PlanePoint corner = this->Cells.Grid().Corner(cell);
    const double size = this->Options.CellSize;
    return { corner.X, corner.Y, this->Bottom + size * layer, this->Cells.CellSize(), size };
  }

  double BoxBottom(PointId point, int level) const
  {
    CubeBox box = this->BoxOf(this->Cells.Grid().CellOf(this->Horizon.Plane[std::size_t(point)]), this->LayerOf(point));
    for (int n = 0; n < level; ++n)
    {
      box = box.Child(box.Octant(this->Horizon.Plane[std::size_t(point)], this->Horizon.Height[std::size_t(point)]));
    }
    return box.Z;
  }

  void WriteRings(Reduction& result) const
  {
    ParallelFor(std::int64_t(this->Cubes.size()), 256,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          const PatchCube& cube = this->Cubes[std::size_t(n)];
          std::for_each(cube.First, cube.Last,
            [&](PointId point) { result.Origin[std::size_t(result.Target[std::size_t(point)])].Ring = cube.Ring; });
        }
      });
  }

  const BoundedHorizon& Horizon;
  const ElaborateOptions Options;
  const double Bottom; // of the lowest cells
  const int Deepest; // the level of the smallest pieces
  CellSimplifier Cells;
  std::vector<PatchCube> Cubes;
  std::vector<std::vector<std::size_t>> Rings;
  std::size_t FirstRingWithCliffs = 0;
};
}

//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyElaborate(const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  return ElaborateSimplifier(horizon, options, monitor.Step(0.0, 0.2)).Run(monitor.Step(0.2, 1.0));
}
}
