// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cuts the cubes of the elaborate simplification into leaves (thesis 4.3.2).

#ifndef SeismicHorizonsOctreeCutter_h
#define SeismicHorizonsOctreeCutter_h

#include "CellSimplifier.h"
#include "Common/CountingSort.h"
#include "Common/Types.h"
#include "ElaborateSimplification.h"
#include "Flatness.h"

#include <algorithm>
#include <cstdint>

namespace SeismicHorizons
{
/// The sizes of leaves.
struct LeafSizes
{
  std::int64_t Sum = 0; // in units of the smallest
  std::int64_t Number = 0;
};

/// The points of one patch in one cube.
struct PatchCube
{
  CellSimplifier::Iterator First = nullptr;
  CellSimplifier::Iterator Last = nullptr;
  std::int64_t Cell = 0; // in plan
  std::int32_t Patch = 0;
  std::int32_t Layer = 0;
  std::int32_t Ring = 0; // 0 as long as it is not known
  LeafSizes Leaves;
};

/// The least corner of a cell and its side. Octants begin at the middle.
struct CubeBox
{
  std::int64_t X = 0; // sub-voxels
  std::int64_t Y = 0;
  double Z = 0.0; // lattice units
  std::int64_t PlaneSize = 0; // the side in sub-voxels
  double Size = 0.0; // the side in lattice units

  int Octant(const PlanePoint& place, double height) const
  {
    const std::int64_t half = this->PlaneSize / 2;
    return int(place.X - this->X >= half) + 2 * int(place.Y - this->Y >= half) +
      4 * int(height - this->Z >= 0.5 * this->Size);
  }

  CubeBox Child(int octant) const
  {
    CubeBox child(*this);
    child.PlaneSize = this->PlaneSize / 2;
    child.Size = 0.5 * this->Size;
    child.X += (octant & 1) ? child.PlaneSize : 0;
    child.Y += (octant & 2) ? child.PlaneSize : 0;
    child.Z += (octant & 4) ? child.Size : 0.0;
    return child;
  }
};

/// Cuts one cube after the other into leaves.
class OctreeCutter
{
public:
  using Iterator = CellSimplifier::Iterator;

  OctreeCutter(CellSimplifier& cells, const ElaborateOptions& options, int deepest)
    : Cells(cells)
    , Horizon(cells.Input())
    , Options(options)
    , Deepest(deepest)
  {
  }

  /// `level` is the least that leaves without boundary points get.
  LeafSizes Cut(const PatchCube& cube, const CubeBox& box, int level)
  {
    this->Leaves = LeafSizes();
    this->LeastLevel = level;
    this->CutAny(cube.First, cube.Last, box, 0);
    return this->Leaves;
  }

private:
  void CutAny(Iterator first, Iterator last, const CubeBox& box, int level)
  {
    const std::ptrdiff_t boundary =
      std::count_if(first, last, [this](PointId point) { return this->Cells.IsOnBoundary(point); });
    if (boundary == 0)
    {
      this->CutInner(first, last, box, level);
    }
    else if (level == this->Deepest || this->StaysWhole(first, last, boundary, box.Size))
    {
      const bool keepsInner = boundary < last - first && box.Size > this->Options.BoundaryCellSizeThreshold;
      this->MakeLeaf(first, level, true, keepsInner);
    }
    else
    {
      this->Halve(first, last, box,
        [&](Iterator begin, Iterator end, const CubeBox& part) { this->CutAny(begin, end, part, level + 1); });
    }
  }

  /// Thesis eq. 4.2.
  bool StaysWhole(Iterator first, Iterator last, std::ptrdiff_t boundary, double size)
  {
    if (!(double(boundary) / size > this->Options.BoundaryDensityThreshold))
    {
      return false;
    }
    this->Ends.clear();
    std::copy_if(
      first, last, std::back_inserter(this->Ends), [this](PointId point) { return this->Cells.IsOnBoundary(point); });
    return this->IsWider(this->Options.BoundaryExtentThreshold, size);
  }

  /// Whether any two of Ends are farther apart than that (thesis eq. 4.1).
  bool IsWider(double extent, double size) const
  {
    if (extent > 2.0 * size) // more than the diagonal
    {
      return false;
    }
    double reach = 0.0;
    for (std::size_t a = 0; a < this->Ends.size(); ++a)
    {
      for (std::size_t b = a + 1; b < this->Ends.size(); ++b)
      {
        const double distance = (this->Place(this->Ends[a]) - this->Place(this->Ends[b])).norm();
        if (distance > extent)
        {
          return true;
        }
        reach = std::max(reach, distance);
      }
      if (a == 0 && 2.0 * reach <= extent) // all are that near to the first one
      {
        return false;
      }
    }
    return false;
  }

  void CutInner(Iterator first, Iterator last, const CubeBox& box, int level)
  {
    if (level == this->Deepest || this->IsFlat(first, last))
    {
      this->CutFlat(first, last, box, level);
    }
    else
    {
      this->Halve(first, last, box,
        [&](Iterator begin, Iterator end, const CubeBox& part) { this->CutInner(begin, end, part, level + 1); });
    }
  }

  void CutFlat(Iterator first, Iterator last, const CubeBox& box, int level)
  {
    if (level >= this->LeastLevel)
    {
      this->MakeLeaf(first, level, false, false);
    }
    else if (last - first == 1)
    {
      this->MakeLeaf(first, this->LeastLevel, false, false);
    }
    else
    {
      this->Halve(first, last, box,
        [&](Iterator begin, Iterator end, const CubeBox& part) { this->CutFlat(begin, end, part, level + 1); });
    }
  }

  bool IsFlat(Iterator first, Iterator last) const
  {
    if (last - first <= 3) // always on a plane
    {
      return true;
    }
    Covariance covariance(this->Place(*first));
    std::for_each(
      first, last, [&](PointId point) { covariance.Add(this->Place(point), double(this->Cells.Weight(point))); });
    return IsFlatWithin(covariance.Matrix(), this->Options.FlatnessThreshold);
  }

  /// Sorts points into the octants of a box, each in the order they came in, and calls visit(first, last, part) for
  /// those that have some.
  template <typename Visitor>
  void Halve(Iterator first, Iterator last, const CubeBox& box, Visitor&& visit)
  {
    SmallCountingSort<std::ptrdiff_t, 8> sort;
    this->Octants.clear();
    for (Iterator point = first; point != last; ++point)
    {
      const int octant =
        box.Octant(this->Horizon.Plane[std::size_t(*point)], this->Horizon.Height[std::size_t(*point)]);
      this->Octants.push_back(static_cast<unsigned char>(octant));
      sort.Count(octant);
    }
    sort.EndCounting();
    this->Order.assign(first, last);
    for (std::size_t n = 0; n < this->Order.size(); ++n)
    {
      first[sort.NextPosition(this->Octants[n])] = this->Order[n];
    }
    for (int octant = 0; octant < 8; ++octant)
    {
      if (sort.First(octant) != sort.End(octant))
      {
        visit(first + sort.First(octant), first + sort.End(octant), box.Child(octant));
      }
    }
  }

  void MakeLeaf(Iterator first, int level, bool hasBoundary, bool keepsInner)
  {
    this->Cells.MarkLeaf(first, level, hasBoundary, keepsInner);
    this->Leaves.Sum += std::int64_t(1) << (this->Deepest - level);
    ++this->Leaves.Number;
  }

  Eigen::Vector3d Place(PointId point) const
  {
    const PlanePoint& place = this->Horizon.Plane[std::size_t(point)];
    const double scale = 1.0 / this->Horizon.SubVoxelsPerColumn;
    return { place.X * scale, place.Y * scale, this->Horizon.Height[std::size_t(point)] };
  }

  CellSimplifier& Cells;
  const BoundedHorizon& Horizon;
  const ElaborateOptions& Options;
  const int Deepest;
  int LeastLevel = 0;
  LeafSizes Leaves;
  std::vector<PointId> Ends; // the boundary points of the cell at hand
  std::vector<PointId> Order;
  std::vector<unsigned char> Octants;
};
}

#endif
