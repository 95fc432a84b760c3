// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: sort the points into patch cubes, and number their rings (PatchCubes.h); cut the patch cubes into leaves, ring
// by ring; write the points that stand for the leaves. Patch cubes of one ring read the sizes of leaves in the rings
// before and write their own, so that all of them can be cut at the same time.

#include "ElaborateSimplification.h"

#include "CellFlatness.h"
#include "CellLeaves.h"
#include "Common/Parameters.h"
#include "LeafWriter.h"
#include "OctreeCutter.h"
#include "PatchCubes.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// How many patch cubes a thread takes at a time: to cut, which takes long, and to copy numbers.
constexpr std::int64_t GrainOfCutting = 64;
constexpr std::int64_t GrainOfCopying = 256;

// From a size to the middle, by ratio, between it and the next one: sizes of levels differ by a factor of 2.
constexpr double HalfALevel = 1.4142135623730951;

void CheckOptions(const ElaborateOptions& options)
{
  CheckAtLeast("flatness threshold", options.FlatnessThreshold, 0.0, " (a plane), and 1/3 at the most");
  CheckAtLeast("boundary density threshold", options.BoundaryDensityThreshold, 0.0, " points per lattice unit");
  CheckAtLeast("boundary extent threshold", options.BoundaryExtentThreshold, 0.0, " lattice units");
  CheckAtLeast("boundary cell size threshold", options.BoundaryCellSizeThreshold, 0.0, " lattice units");
  CheckAtLeast("smallest cell size", options.SmallestCellSize, 1.0, " column");
  CheckAtLeast("growth per ring", options.GrowthPerRing, 1.0, " (cells as large as their neighbours)");
}

/// How many times a cell can be halved before its side falls below the smallest.
int Halvings(double size, double smallest)
{
  return 0.5 * size < smallest ? 0 : 1 + Halvings(0.5 * size, smallest);
}

class ElaborateSimplifier
{
public:
  ElaborateSimplifier(const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor)
    : Options(options)
    , Deepest(Halvings(options.CellSize, options.SmallestCellSize))
    , Leaves(horizon, options.CellSize, monitor.Step(0.0, 0.6))
    , Cubes(this->Leaves, options.CellSize, monitor.Step(0.6, 1.0))
  {
  }

  Reduction Run(const Monitor& monitor)
  {
    this->CutRings(monitor.Step(0.0, 0.5));
    Reduction result = WriteLeaves(this->Leaves, this->Options.Representative, monitor.Step(0.5, 0.95));
    this->DescribeLeaves(result);
    if (this->Options.ListCells)
    {
      ListCells(this->Leaves, result,
        [this](const PointId* first, const PointId*, int level) { return this->BottomOf(*first, level); });
    }
    return result;
  }

private:
  void CutRings(const Monitor& monitor)
  {
    const double size = double(this->Cubes.Size());
    std::size_t done = 0;
    for (const PatchCubes::Ring& ring : this->Cubes.Rings())
    {
      const Monitor step = monitor.Step(double(done) / size, double(done + ring.size()) / size);
      ParallelFor(std::int64_t(ring.size()), GrainOfCutting, step,
        [&](std::int64_t first, std::int64_t last) { this->CutCubes(ring.data() + first, ring.data() + last); });
      this->Cubes.EndRing(ring);
      done += ring.size();
    }
  }

  void CutCubes(const std::size_t* first, const std::size_t* last)
  {
    OctreeCutter cutter(this->Leaves, this->Options, this->Deepest);
    for (; first != last; ++first)
    {
      PatchCube& cube = this->Cubes[*first];
      const CellSizes leaves = cutter.Cut(cube.First, cube.Last, this->Cubes.BoxOf(cube), this->LeastLevel(cube));
      const bool countsOnce = this->Options.NeighbourMean == NeighbourMeanKind::OverCubes;
      cube.Sizes = countsOnce ? CellSizes{ leaves.Mean(), 1 } : leaves;
    }
  }

  /// How many times the leaves of a patch cube are halved at least: to the level whose size is nearest, by ratio, to
  /// the mean of its neighbours before (thesis eq. 4.3). Rounding down would make cells shrink from ring to ring, as
  /// the mean of different sizes is below the largest of them.
  int LeastLevel(const PatchCube& cube) const
  {
    const CellSizes before = this->Cubes.SizesBefore(cube);
    const double largest = HalfALevel * this->Options.GrowthPerRing * before.Sum;
    for (int level = 0; level < this->Deepest; ++level)
    {
      // As many cells of this level, in units of the smallest size.
      const double sum = std::ldexp(double(before.Number), this->Deepest - level);
      if (!(sum > largest))
      {
        return level;
      }
    }
    return this->Deepest;
  }

  /// The bottom of the octant of that level that a point is in.
  double BottomOf(PointId point, int level) const
  {
    CubeBox box = this->Cubes.BoxOf(point);
    for (int n = 0; n < level; ++n)
    {
      box = box.Octant(box.OctantOf(this->Leaves.Plane(point), this->Leaves.Height(point)));
    }
    return box.Z;
  }

  /// Writes the rings of leaves, and how flat they are. Each output point belongs to one leaf, so that no two threads
  /// write to the same place.
  void DescribeLeaves(Reduction& result) const
  {
    result.Flatness.resize(result.Source.size());
    ParallelFor(std::int64_t(this->Cubes.Size()), GrainOfCopying,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          const PatchCube& cube = this->Cubes[std::size_t(n)];
          this->Leaves.ForEachLeaf(cube.First, cube.Last,
            [&](const PointId* first, const PointId* last) { this->DescribeLeaf(first, last, cube.Ring, result); });
        }
      });
  }

  void DescribeLeaf(const PointId* first, const PointId* last, std::int32_t ring, Reduction& result) const
  {
    const double flatness = FlatnessOf(this->Leaves, first, last);
    for (const PointId* point = first; point != last; ++point)
    {
      const std::size_t target = std::size_t(result.Target[std::size_t(*point)]);
      result.Origin[target].Ring = ring;
      result.Flatness[target] = flatness;
    }
  }

  const ElaborateOptions Options;
  const int Deepest; // the level of the smallest cells
  CellLeaves Leaves;
  PatchCubes Cubes;
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
  return ElaborateSimplifier(horizon, options, monitor.Step(0.0, 0.35)).Run(monitor.Step(0.35, 1.0));
}
}
