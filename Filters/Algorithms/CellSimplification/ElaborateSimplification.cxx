// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reduces points where a horizon is flat and far from its boundary (thesis 4.3.2, Alg. 4.2 and 4.3, eq. 4.1 to 4.5).
//
// Points of each patch are sorted into cubes, which are cut into octants; both are called cells. The barycentre, or the
// input point nearest to it, represents the points of each leaf. Cubes with boundary points, the first ring, are cut by
// the density of these points. Each further ring, the cubes that touch the previous one, is cut by curvature, and at
// least to the mean size of its neighbours in the previous ring, so that sizes change gradually.
//
// Interpretation of eq. 4.3, size(C) = 1/m sum of size(C_j) over m neighbouring cells of the previous ring: C_j is a
// cube, which counts once; its size is the mean of its leaves. The text averages levels, the equation sizes; the
// equation is used. (The mean of levels is a geometric mean of sizes, which shrinks cells faster.)
//
// Differences from the thesis:
//  - No cell is halved below the smallest cell size, at least one column. (4.3.2.4.1 limits inner cells alone, but a
//    cell with one boundary point never meets the criterion, so that the pseudo-code does not end.)
//  - Points in one place, on a line or on a plane have no curvature, whatever the threshold.
//  - Octants without boundary points in the first ring have no previous ring, and are cut by curvature alone.
//  - Cubes beyond a cliff higher than a cube touch no ring. Once no other cubes remain, those next to a ring in plan
//    follow, then isolated cubes, which are cut by curvature alone.
//  - Points on different sides of cuts are in different cubes (CellLeaves.cxx).
//  - Leaves can lie above each other, but no two new points share a place in plan (LeafWriter.cxx).
//
// Time is linear in the points times the number of halvings, but boundary points are compared in pairs if the extent
// threshold is about the cell size.
//
// Points are sorted into patch cubes with ring numbers, the cubes are cut into leaves ring by ring, and the
// representatives of leaves are written. Cubes of a ring read sizes of leaves in earlier rings only, so that they can
// be cut in parallel.
//
// Space is divided into cubes over the cells of the grid, as high as wide. A patch cube holds the points of one side in
// one cube (a group of CellLeaves.h); a tower holds the patch cubes of one side over one cell. The ring of a patch cube
// is its number of steps from the boundary:
//
//    ring  1  1  1  1  1  1
//          1  2  2  2  2  1
//          1  2  3  3  2  1
//          1  1  1  2  1  1

#include "CellSimplification.h"

#include "CellLeaves.h"
#include "Common/Base/CountingSort.h"
#include "Common/Base/Parameters.h"
#include "Flatness.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t GrainOfCutting = 64;
constexpr std::int64_t GrainOfCopying = 256;

// Sizes of levels differ by a factor of 2; this leads to the geometric mean with the next size.
constexpr double HalfALevel = 1.4142135623730951;

struct CellSizes
{
  double Sum = 0.0; // In units of the smallest possible size, sums of sizes of leaves are exact.
  std::int64_t Number = 0;

  double Mean() const { return this->Sum / double(this->Number); }

  void Add(const CellSizes& other)
  {
    this->Sum += other.Sum;
    this->Number += other.Number;
  }
};

/// A cube is given by its least corner; X, Y and PlaneSize are in sub-voxels, Z and Size in lattice units.
struct CubeBox
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
  double Z = 0.0;
  std::int64_t PlaneSize = 0;
  double Size = 0.0;

  int OctantOf(const PlanePoint& place, double height) const
  {
    const std::int64_t half = this->PlaneSize / 2;
    return int(place.X - this->X >= half) + 2 * int(place.Y - this->Y >= half) +
      4 * int(height - this->Z >= 0.5 * this->Size);
  }

  CubeBox Octant(int octant) const
  {
    CubeBox result(*this);
    result.PlaneSize = this->PlaneSize / 2;
    result.Size = 0.5 * this->Size;
    result.X += (octant & 1) ? result.PlaneSize : 0;
    result.Y += (octant & 2) ? result.PlaneSize : 0;
    result.Z += (octant & 4) ? result.Size : 0.0;
    return result;
  }
};

//----------------------------------------------------------------------------------------------------------------------
// Cubes and rings

struct PatchCube
{
  PointId* First = nullptr;
  PointId* Last = nullptr;
  std::int64_t Cell = 0;
  std::int32_t Layer = 0;
  std::int32_t Patch = 0;
  std::int32_t Ring = 0; // from 1; 0 while not numbered
  std::uint32_t Tower = 0;
  CellSizes Sizes;
};

class PatchCubes
{
public:
  using Ring = std::vector<std::size_t>;

  PatchCubes(CellLeaves& leaves, int size, const Monitor& monitor)
    : Leaves(leaves)
    , CubeSize(size)
    , Bottom(*std::min_element(leaves.Horizon().Height.begin(), leaves.Horizon().Height.end()))
  {
    this->MakeCubes(monitor);
    this->MakeTowers();
    this->NumberRings();
  }

  std::size_t Size() const { return this->Cubes.size(); }
  PatchCube& operator[](std::size_t n) { return this->Cubes[n]; }
  const PatchCube& operator[](std::size_t n) const { return this->Cubes[n]; }

  const std::vector<Ring>& Rings() const { return this->AllRings; }

  void EndRing(const Ring& ring)
  {
    for (const std::size_t cube : ring)
    {
      this->Towers[this->Cubes[cube].Tower].Sizes.Add(this->Cubes[cube].Sizes);
    }
  }

  /// Returns sizes of neighbours in the previous ring, or if there are none, of neighbours in plan in any earlier ring.
  CellSizes SizesBefore(const PatchCube& cube) const
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

  CubeBox BoxOf(const PatchCube& cube) const { return this->BoxOf(this->Leaves.Square(cube.Cell), cube.Layer); }

  CubeBox BoxOf(PointId point) const
  {
    return this->BoxOf(this->Leaves.Grid().CellOf(this->Leaves.Plane(point)), this->LayerOf(point));
  }

private:
  struct PatchTower
  {
    std::size_t First = 0;
    std::size_t End = 0;
    std::int32_t Patch = 0;
    bool IsTaken = false;
    CellSizes Sizes;
  };

  std::int32_t LayerOf(PointId point) const
  {
    const double layer = std::floor((this->Leaves.Height(point) - this->Bottom) / this->CubeSize);
    return std::int32_t(std::min(layer, double(std::numeric_limits<std::int32_t>::max())));
  }

  CubeBox BoxOf(std::int64_t square, std::int32_t layer) const
  {
    const PlanePoint corner = this->Leaves.Grid().Corner(square);
    const double size = this->CubeSize;
    return { corner.X, corner.Y, this->Bottom + size * layer, this->Leaves.CellSize(), size };
  }

  void MakeCubes(const Monitor& monitor)
  {
    this->Leaves.MakeGroups(
      [this](PointId point)
      {
        const std::int64_t side = this->Leaves.SideOf(point);
        return side * (std::int64_t(1) << 32) + this->LayerOf(point);
      },
      monitor);
    this->Cubes.resize(this->Leaves.NumberOfGroups());
    ParallelFor(this->Leaves.NumberOfCells(), CellLeaves::Grain,
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

  void MakeTowers()
  {
    this->FirstTowers.assign(this->Leaves.NumberOfCells() + 1, 0);
    for (std::size_t n = 0; n < this->Cubes.size(); ++n)
    {
      PatchCube& cube = this->Cubes[n];
      if (n == 0 || cube.Cell != this->Cubes[n - 1].Cell ||
        this->Leaves.SideOf(*cube.First) != this->Leaves.SideOf(*this->Cubes[n - 1].First))
      {
        this->Towers.push_back({ n, n, cube.Patch, false, CellSizes() });
        ++this->FirstTowers[cube.Cell + 1];
      }
      this->Towers.back().End = n + 1;
      cube.Tower = std::uint32_t(this->Towers.size() - 1);
    }
    std::partial_sum(this->FirstTowers.begin(), this->FirstTowers.end(), this->FirstTowers.begin());
  }

  void NumberRings()
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

  /// The next ring touches the last one; if nothing does, it touches any ring in plan; finally it is all remaining cubes.
  Ring FindNextRing()
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

  /// Rings that an earlier call has visited have no neighbours left to take.
  template <typename Take>
  void TakeBeyondCliffs(Take&& take)
  {
    for (; this->FirstRingWithCliffs < this->AllRings.size(); ++this->FirstRingWithCliffs)
    {
      for (const std::size_t cube : this->AllRings[this->FirstRingWithCliffs])
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

  template <typename Visitor>
  void ForEachTower(const PatchCube& cube, Visitor&& visit) const
  {
    const CellGrid& grid = this->Leaves.Grid();
    const std::int64_t x = this->Leaves.Square(cube.Cell) % grid.SizeX();
    const std::int64_t y = this->Leaves.Square(cube.Cell) / grid.SizeX();
    for (std::int64_t row = std::max<std::int64_t>(0, y - 1); row <= std::min(grid.SizeY() - 1, y + 1); ++row)
    {
      const std::int64_t left = grid.Index(std::max<std::int64_t>(0, x - 1), row);
      const std::int64_t right = grid.Index(std::min(grid.SizeX() - 1, x + 1), row);
      const std::size_t end = this->FirstTowers[this->Leaves.FirstCellFrom(right + 1)];
      for (std::size_t n = this->FirstTowers[this->Leaves.FirstCellFrom(left)]; n < end; ++n)
      {
        if (this->Towers[n].Patch == cube.Patch)
        {
          visit(n);
        }
      }
    }
  }

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

  CellLeaves& Leaves;
  const int CubeSize; // lattice units
  const double Bottom;
  std::vector<PatchCube> Cubes;
  std::vector<PatchTower> Towers;
  std::vector<std::size_t> FirstTowers;
  std::vector<Ring> AllRings;
  std::size_t FirstRingWithCliffs = 0; // TakeBeyondCliffs continues here.
};

//----------------------------------------------------------------------------------------------------------------------
// Cutting

constexpr std::ptrdiff_t MostPointsOfPlane = 3; // Up to three points always lie on a plane.

Eigen::Matrix3d CovarianceOf(const CellLeaves& leaves, const PointId* first, const PointId* last)
{
  Covariance covariance(leaves.Place(*first));
  std::for_each(first, last, [&](PointId point) { covariance.Add(leaves.Place(point), double(leaves.Weight(point))); });
  return covariance.Matrix();
}

/// The flatness (thesis eq. 4.5) is 0 for a plane and at most 1/3, with an error below 1e-6. Points are weighted by the
/// number that they represent.
double FlatnessOf(const CellLeaves& leaves, const PointId* first, const PointId* last)
{
  return last - first <= MostPointsOfPlane ? 0.0 : QuickFlatness(CovarianceOf(leaves, first, last));
}

bool AreFlat(const CellLeaves& leaves, const PointId* first, const PointId* last, double threshold)
{
  return last - first <= MostPointsOfPlane || IsFlatWithin(CovarianceOf(leaves, first, last), threshold);
}

constexpr int NumberOfOctants = 8;

double Distance(const SpacePoint& a, const SpacePoint& b)
{
  const double x = a.X - b.X;
  const double y = a.Y - b.Y;
  const double z = a.Z - b.Z;
  return std::sqrt(x * x + y * y + z * z);
}

class OctreeCutter
{
public:
  OctreeCutter(CellLeaves& leaves, const ElaborateOptions& options, int deepest)
    : Leaves(leaves)
    , Options(options)
    , Deepest(deepest)
  {
  }

  /// `leastLevel` applies to leaves without boundary points.
  CellSizes Cut(PointId* first, PointId* last, const CubeBox& cube, int leastLevel)
  {
    this->Sizes = CellSizes();
    this->LeastLevel = leastLevel;
    this->CutAny(first, last, cube, 0);
    return this->Sizes;
  }

private:
  void CutAny(PointId* first, PointId* last, const CubeBox& box, int level)
  {
    const std::ptrdiff_t boundaryPoints =
      std::count_if(first, last, [this](PointId point) { return this->Leaves.IsOnBoundary(point); });
    if (boundaryPoints == 0)
    {
      this->CutInner(first, last, box, level);
    }
    else if (level == this->Deepest || this->StaysWhole(first, last, boundaryPoints, box.Size))
    {
      const bool keepsInner = boundaryPoints < last - first && box.Size > this->Options.BoundaryCellSizeThreshold;
      this->MakeLeaf(first, level, true, keepsInner);
    }
    else
    {
      this->Halve(first, last, box,
        [&](PointId* begin, PointId* end, const CubeBox& octant) { this->CutAny(begin, end, octant, level + 1); });
    }
  }

  void CutInner(PointId* first, PointId* last, const CubeBox& box, int level)
  {
    if (level == this->Deepest || AreFlat(this->Leaves, first, last, this->Options.FlatnessThreshold))
    {
      this->CutFlat(first, last, box, level);
    }
    else
    {
      this->Halve(first, last, box,
        [&](PointId* begin, PointId* end, const CubeBox& octant) { this->CutInner(begin, end, octant, level + 1); });
    }
  }

  void CutFlat(PointId* first, PointId* last, const CubeBox& box, int level)
  {
    if (level >= this->LeastLevel)
    {
      this->MakeLeaf(first, level, false, false);
    }
    else if (last - first == 1) // A single point needs no cutting, since its cell at the least level is known.
    {
      this->MakeLeaf(first, this->LeastLevel, false, false);
    }
    else
    {
      this->Halve(first, last, box,
        [&](PointId* begin, PointId* end, const CubeBox& octant) { this->CutFlat(begin, end, octant, level + 1); });
    }
  }

  /// A cell with dense and extended boundary points stays a leaf (thesis eq. 4.2).
  bool StaysWhole(const PointId* first, const PointId* last, std::ptrdiff_t boundaryPoints, double size)
  {
    if (!(double(boundaryPoints) / size > this->Options.BoundaryDensityThreshold))
    {
      return false;
    }
    this->BoundaryPoints.clear();
    std::copy_if(first, last, std::back_inserter(this->BoundaryPoints),
      [this](PointId point) { return this->Leaves.IsOnBoundary(point); });
    return this->AnyApart(this->Options.BoundaryExtentThreshold, size);
  }

  bool AnyApart(double extent, double size) const
  {
    if (extent > 2.0 * size)
    {
      return false;
    }
    double reach = 0.0;
    for (std::size_t a = 0; a < this->BoundaryPoints.size(); ++a)
    {
      for (std::size_t b = a + 1; b < this->BoundaryPoints.size(); ++b)
      {
        const double distance =
          Distance(this->Leaves.Place(this->BoundaryPoints[a]), this->Leaves.Place(this->BoundaryPoints[b]));
        if (distance > extent)
        {
          return true;
        }
        reach = std::max(reach, distance);
      }
      if (a == 0 && 2.0 * reach <= extent) // All points are so close to the first one that no two can be far apart.
      {
        return false;
      }
    }
    return false;
  }

  template <typename Visitor>
  void Halve(PointId* first, PointId* last, const CubeBox& box, Visitor&& visit)
  {
    SmallCountingSort<std::ptrdiff_t, NumberOfOctants> sort;
    this->Octants.clear();
    for (const PointId* point = first; point != last; ++point)
    {
      const int octant = box.OctantOf(this->Leaves.Plane(*point), this->Leaves.Height(*point));
      this->Octants.push_back(static_cast<unsigned char>(octant));
      sort.Count(octant);
    }
    sort.EndCounting();
    this->Order.assign(first, last);
    for (std::size_t n = 0; n < this->Order.size(); ++n)
    {
      first[sort.NextPosition(this->Octants[n])] = this->Order[n];
    }
    for (int octant = 0; octant < NumberOfOctants; ++octant)
    {
      if (sort.First(octant) != sort.End(octant))
      {
        visit(first + sort.First(octant), first + sort.End(octant), box.Octant(octant));
      }
    }
  }

  void MakeLeaf(PointId* first, int level, bool hasBoundary, bool keepsInner)
  {
    this->Leaves.MarkLeaf(first, level, hasBoundary, keepsInner);
    this->Sizes.Sum += double(std::int64_t(1) << (this->Deepest - level));
    ++this->Sizes.Number;
  }

  CellLeaves& Leaves;
  const ElaborateOptions& Options;
  const int Deepest;
  int LeastLevel = 0;
  CellSizes Sizes;
  std::vector<PointId> BoundaryPoints;
  std::vector<PointId> Order;
  std::vector<unsigned char> Octants;
};

//----------------------------------------------------------------------------------------------------------------------
// Simplification

void CheckElaborateOptions(const ElaborateOptions& options)
{
  CheckAtLeast("flatness threshold", options.FlatnessThreshold, 0.0, " (a plane), and 1/3 at the most");
  CheckAtLeast("boundary density threshold", options.BoundaryDensityThreshold, 0.0, " points per lattice unit");
  CheckAtLeast("boundary extent threshold", options.BoundaryExtentThreshold, 0.0, " lattice units");
  CheckAtLeast("boundary cell size threshold", options.BoundaryCellSizeThreshold, 0.0, " lattice units");
  CheckAtLeast("smallest cell size", options.SmallestCellSize, 1.0, " column");
  CheckAtLeast("growth per ring", options.GrowthPerRing, 1.0, " (cells as large as their neighbours)");
}

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

  /// Returns the level with the size nearest, by ratio, to the mean in the previous ring (thesis eq. 4.3). Rounding
  /// down would shrink cells from ring to ring, as the mean of different sizes is below the largest.
  int LeastLevel(const PatchCube& cube) const
  {
    const CellSizes before = this->Cubes.SizesBefore(cube);
    const double largest = HalfALevel * this->Options.GrowthPerRing * before.Sum;
    for (int level = 0; level < this->Deepest; ++level)
    {
      const double sum = std::ldexp(double(before.Number), this->Deepest - level);
      if (!(sum > largest))
      {
        return level;
      }
    }
    return this->Deepest;
  }

  double BottomOf(PointId point, int level) const
  {
    CubeBox box = this->Cubes.BoxOf(point);
    for (int n = 0; n < level; ++n)
    {
      box = box.Octant(box.OctantOf(this->Leaves.Plane(point), this->Leaves.Height(point)));
    }
    return box.Z;
  }

  void DescribeLeaves(Reduction& result) const
  {
    result.Flatness.resize(result.Source.size());
    ParallelFor(std::int64_t(this->Cubes.Size()), GrainOfCopying,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          const PatchCube& cube = this->Cubes[n];
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
      const std::size_t target = std::size_t(result.Target[*point]);
      result.Origin[target].Ring = ring;
      result.Flatness[target] = flatness;
    }
  }

  const ElaborateOptions Options;
  const int Deepest;
  CellLeaves Leaves;
  PatchCubes Cubes;
};
}

//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyElaborate(const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor)
{
  CheckElaborateOptions(options);
  if (horizon.Height.empty())
  {
    return Reduction();
  }
  return ElaborateSimplifier(horizon, options, monitor.Step(0.0, 0.35)).Run(monitor.Step(0.35, 1.0));
}
}
