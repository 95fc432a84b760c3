// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a horizon in cubes, patch by patch, for the elaborate simplification.
//
// Terms: space is cut into cubes with the side of a cell, one layer above the other, over the cells of the grid. A
// patch cube is the points of one side, mostly a patch, in one cube, which is what CellLeaves.h calls a group. A tower
// is the patch cubes of one side over one cell. The ring of a patch cube is the number of steps to it from the
// boundary:
//
//    ring  1  1  1  1  1  1
//          1  2  2  2  2  1
//          1  2  3  3  2  1
//          1  1  1  2  1  1

#ifndef SeismicHorizonsPatchCubes_h
#define SeismicHorizonsPatchCubes_h

#include "CellLeaves.h"
#include "Common/Monitor.h"
#include "Common/Types.h"
#include "CubeBox.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The points of one side in one cube.
struct PatchCube
{
  PointId* First = nullptr;
  PointId* Last = nullptr;
  std::int64_t Cell = 0; // of the grid, below the cube
  std::int32_t Layer = 0;
  std::int32_t Patch = 0;
  std::int32_t Ring = 0; // from 1; 0 while rings are numbered
  std::uint32_t Tower = 0; // its number
  CellSizes Sizes; // what counts in the mean of its neighbours' sizes, once it is cut
};

class PatchCubes
{
public:
  /// The numbers of the patch cubes of one ring.
  using Ring = std::vector<std::size_t>;

  /// Makes groups of the points, and numbers the rings. `size` is the side of a cube in lattice units. Keeps a
  /// reference to the leaves.
  PatchCubes(CellLeaves& leaves, int size, const Monitor& monitor);

  std::size_t Size() const { return this->Cubes.size(); }
  PatchCube& operator[](std::size_t n) { return this->Cubes[n]; }
  const PatchCube& operator[](std::size_t n) const { return this->Cubes[n]; }

  /// All rings, that at the boundary first.
  const std::vector<Ring>& Rings() const { return this->AllRings; }

  /// Says that the patch cubes of a ring are cut: their sizes then count for SizesBefore.
  void EndRing(const Ring& ring);

  /// The sizes of the neighbours of a patch cube that are of the ring before; where there are none, of the neighbours
  /// in plan that are of any ring before.
  CellSizes SizesBefore(const PatchCube& cube) const;

  CubeBox BoxOf(const PatchCube& cube) const { return this->BoxOf(cube.Cell, cube.Layer); }
  /// The cube that a point is in.
  CubeBox BoxOf(PointId point) const;

private:
  /// The patch cubes of one side over one cell, from the bottom up.
  struct PatchTower
  {
    std::size_t First = 0;
    std::size_t End = 0;
    std::int32_t Patch = 0;
    bool IsTaken = false; // all of them have a ring
    CellSizes Sizes; // of those in the rings that have ended
  };

  std::int32_t LayerOf(PointId point) const;
  CubeBox BoxOf(std::int64_t cell, std::int32_t layer) const;
  void MakeCubes(const Monitor& monitor);
  void MakeTowers();
  void NumberRings();
  Ring FindNextRing();
  template <typename Take>
  void TakeBeyondCliffs(Take&& take);
  template <typename Take>
  void TakeTower(PatchTower& tower, Take& take);
  template <typename Visitor>
  void ForEachTower(const PatchCube& cube, Visitor&& visit) const;
  template <typename Visitor>
  void ForEachNeighbour(const PatchCube& cube, Visitor&& visit) const;

  CellLeaves& Leaves;
  const int CubeSize; // lattice units
  const double Bottom; // of the lowest layer
  std::vector<PatchCube> Cubes; // in the order of the groups
  std::vector<PatchTower> Towers; // in the same order
  std::vector<std::size_t> TowersOfCells; // for each cell its first tower, and at the end their number
  std::vector<Ring> AllRings;
  std::size_t FirstRingWithCliffs = 0; // where TakeBeyondCliffs goes on
};
}

#endif
