// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: sort the points into patch cubes; number the rings; cut the patch cubes into leaves, ring by ring; write the
// points that stand for the leaves.
//
// Terms: space is cut into cubes with the side of a cell, one layer above the other. A patch cube is the points of one
// patch in one cube, which is what CellLeaves.h calls a group. Its ring is the number of steps from the boundary:
//
//    ring  1  1  1  1  1  1        Patch cubes of one ring read the sizes of the leaves in the ring before, and write
//          1  2  2  2  2  1        their own, so that all of them can be cut at the same time.
//          1  2  3  3  2  1
//          1  1  1  2  1  1

#include "ElaborateSimplification.h"

#include "CellLeaves.h"
#include "Common/Errors.h"
#include "LeafWriter.h"
#include "OctreeCutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// How many patch cubes a thread takes at a time: to cut, which takes long, and to copy numbers.
constexpr std::int64_t GrainOfCutting = 64;
constexpr std::int64_t GrainOfCopying = 256;

// From a size to the middle, by ratio, between it and the next one: sizes of levels differ by a factor of 2.
constexpr double HalfALevel = 1.4142135623730951;

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

/// How many times a cell can be halved before its side falls below one column.
int Halvings(int size)
{
  return size < 2 ? 0 : 1 + Halvings(size / 2);
}

/// The points of one patch in one cube.
struct PatchCube
{
  PointId* First = nullptr;
  PointId* Last = nullptr;
  std::int64_t Cell = 0; // of the grid, below the cube
  std::int32_t Layer = 0;
  std::int32_t Patch = 0;
  std::int32_t Ring = 0; // 0 until it is known
  std::uint32_t Tower = 0; // its number
  LeafSizes Sizes; // of its leaves, once it is cut
};

/// The patch cubes of one patch above one cell of the grid, from the bottom up.
struct PatchTower
{
  std::size_t First = 0;
  std::size_t End = 0;
  std::int32_t Patch = 0;
  bool IsTaken = false; // all of them have a ring
  LeafSizes Sizes; // of those in the rings that are cut
};

class ElaborateSimplifier
{
public:
  ElaborateSimplifier(const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor)
    : Options(options)
    , Bottom(*std::min_element(horizon.Height.begin(), horizon.Height.end()))
    , Deepest(Halvings(options.CellSize))
    , Leaves(horizon, options.CellSize, monitor)
  {
  }

  Reduction Run(const Monitor& monitor)
  {
    this->MakeCubes(monitor.Step(0.0, 0.2));
    this->MakeTowers();
    this->NumberRings();
    std::size_t done = 0;
    for (const std::vector<std::size_t>& ring : this->Rings)
    {
      const Monitor step = monitor.Step(0.2 + 0.4 * this->Part(done), 0.2 + 0.4 * this->Part(done + ring.size()));
      ParallelFor(std::int64_t(ring.size()), GrainOfCutting, step,
        [&](std::int64_t first, std::int64_t last) { this->CutCubes(ring.data() + first, ring.data() + last); });
      for (const std::size_t cube : ring)
      {
        this->TowerOf(this->Cubes[cube]).Sizes.Add(this->Cubes[cube].Sizes);
      }
      done += ring.size();
    }
    Reduction result = WriteLeaves(this->Leaves, this->Options.Representative, monitor.Step(0.6, 0.95));
    this->WriteRings(result);
    if (this->Options.ListCells)
    {
      ListCells(this->Leaves, result,
        [this](const PointId* first, const PointId*, int level) { return this->BoxBottom(*first, level); });
    }
    return result;
  }

private:
  double Part(std::size_t cubes) const { return double(cubes) / double(this->Cubes.size()); }

  std::int32_t LayerOf(PointId point) const
  {
    const double layer = std::floor((this->Leaves.Height(point) - this->Bottom) / this->Options.CellSize);
    return std::int32_t(std::min(layer, double(std::numeric_limits<std::int32_t>::max())));
  }

  void MakeCubes(const Monitor& monitor)
  {
    this->Leaves.MakeGroups(
      [this](PointId point)
      {
        const std::int64_t patch = this->Leaves.Patch(point);
        return patch * (std::int64_t(1) << 32) + this->LayerOf(point);
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
                this->Leaves.HasBoundary(first) ? 1 : 0, 0, LeafSizes() };
              ++cube;
            });
        }
      });
  }

  PatchTower& TowerOf(const PatchCube& cube) { return this->Towers[cube.Tower]; }

  void MakeTowers()
  {
    this->TowersOfCells.assign(std::size_t(this->Leaves.Grid().Size()) + 1, 0);
    for (std::size_t n = 0; n < this->Cubes.size(); ++n)
    {
      PatchCube& cube = this->Cubes[n];
      if (n == 0 || cube.Cell != this->Cubes[n - 1].Cell || cube.Patch != this->Cubes[n - 1].Patch)
      {
        this->Towers.push_back({ n, n, cube.Patch, false, LeafSizes() });
        ++this->TowersOfCells[std::size_t(cube.Cell) + 1];
      }
      this->Towers.back().End = n + 1;
      cube.Tower = std::uint32_t(this->Towers.size() - 1);
    }
    std::partial_sum(this->TowersOfCells.begin(), this->TowersOfCells.end(), this->TowersOfCells.begin());
  }

  /// Calls visit(number) for the towers of the same patch that touch that of a cube, itself included.
  template <typename Visitor>
  void ForEachTower(const PatchCube& cube, Visitor&& visit) const
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

  /// Calls visit(number) for the patch cubes of the same patch that touch one, itself included.
  template <typename Visitor>
  void ForEachNeighbour(const PatchCube& cube, Visitor&& visit) const
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

  /// What touches the last ring; where nothing is left, what touches any ring in plan; and in the end all others.
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

  /// Calls take(number) for what touches any ring in plan. Rings that an earlier call has looked at have no neighbours
  /// left to take.
  template <typename Take>
  void TakeBeyondCliffs(Take&& take)
  {
    for (; this->FirstRingWithCliffs < this->Rings.size(); ++this->FirstRingWithCliffs)
    {
      for (const std::size_t cube : this->Rings[this->FirstRingWithCliffs])
      {
        this->ForEachTower(this->Cubes[cube], [&](std::size_t tower) { this->TakeTower(this->Towers[tower], take); });
      }
    }
  }

  template <typename Take>
  void TakeTower(PatchTower& tower, Take& take)
  {
    for (std::size_t cube = tower.First; !tower.IsTaken && cube < tower.End; ++cube)
    {
      take(cube);
    }
    tower.IsTaken = true;
  }

  void CutCubes(const std::size_t* first, const std::size_t* last)
  {
    OctreeCutter cutter(this->Leaves, this->Options, this->Deepest);
    for (; first != last; ++first)
    {
      PatchCube& cube = this->Cubes[*first];
      cube.Sizes = cutter.Cut(cube.First, cube.Last, this->BoxOf(cube.Cell, cube.Layer), this->LeastLevel(cube));
    }
  }

  /// How many times the leaves of a patch cube are halved at least: to the level whose size is nearest, by ratio, to
  /// the mean of those before (thesis eq. 4.3). Rounding down would make cells shrink from ring to ring, as the mean of
  /// different sizes is below the largest of them.
  int LeastLevel(const PatchCube& cube) const
  {
    LeafSizes before = this->SizesOfRingBefore(cube);
    if (before.Number == 0)
    {
      this->ForEachTower(cube, [&](std::size_t tower) { before.Add(this->Towers[tower].Sizes); });
    }
    const double largest = HalfALevel * this->Options.GrowthPerRing * double(before.Sum);
    for (int level = 0; level < this->Deepest; ++level)
    {
      // As many leaves of this level, in units of the smallest size.
      const double sum = std::ldexp(double(before.Number), this->Deepest - level);
      if (!(sum > largest))
      {
        return level;
      }
    }
    return this->Deepest;
  }

  /// The leaves of the neighbours one ring further out.
  LeafSizes SizesOfRingBefore(const PatchCube& cube) const
  {
    LeafSizes sizes;
    this->ForEachNeighbour(cube,
      [&](std::size_t n)
      {
        if (this->Cubes[n].Ring == cube.Ring - 1)
        {
          sizes.Add(this->Cubes[n].Sizes);
        }
      });
    return sizes;
  }

  CubeBox BoxOf(std::int64_t cell, std::int32_t layer) const
  {
    const PlanePoint corner = this->Leaves.Grid().Corner(cell);
    const double size = this->Options.CellSize;
    return { corner.X, corner.Y, this->Bottom + size * layer, this->Leaves.CellSize(), size };
  }

  /// The bottom of the octant of that level that a point is in.
  double BoxBottom(PointId point, int level) const
  {
    const PlanePoint& place = this->Leaves.Plane(point);
    CubeBox box = this->BoxOf(this->Leaves.Grid().CellOf(place), this->LayerOf(point));
    for (int n = 0; n < level; ++n)
    {
      box = box.Octant(box.OctantOf(place, this->Leaves.Height(point)));
    }
    return box.Z;
  }

  void WriteRings(Reduction& result) const
  {
    ParallelFor(std::int64_t(this->Cubes.size()), GrainOfCopying,
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

  const ElaborateOptions Options;
  const double Bottom; // of the lowest layer
  const int Deepest; // the level of the smallest cells
  CellLeaves Leaves;
  std::vector<PatchCube> Cubes; // in the order of the groups
  std::vector<PatchTower> Towers; // in the same order
  std::vector<std::size_t> TowersOfCells; // for each cell its first tower, and at the end their number
  std::vector<std::vector<std::size_t>> Rings; // the numbers of their patch cubes, ring 1 first
  std::size_t FirstRingWithCliffs = 0; // where TakeBeyondCliffs goes on
};
}

//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyElaborate(const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  if (horizon.Plane.empty())
  {
    return Reduction();
  }
  return ElaborateSimplifier(horizon, options, monitor.Step(0.0, 0.2)).Run(monitor.Step(0.2, 1.0));
}
}
