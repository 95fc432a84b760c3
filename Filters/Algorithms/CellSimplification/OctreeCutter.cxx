// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OctreeCutter.h"

#include "CellFlatness.h"
#include "Common/CountingSort.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace SeismicHorizons
{
namespace
{
constexpr int NumberOfOctants = 8;

double Distance(const SpacePoint& a, const SpacePoint& b)
{
  const double x = a.X - b.X;
  const double y = a.Y - b.Y;
  const double z = a.Z - b.Z;
  return std::sqrt(x * x + y * y + z * z);
}
}

//----------------------------------------------------------------------------------------------------------------------
OctreeCutter::OctreeCutter(CellLeaves& leaves, const ElaborateOptions& options, int deepest)
  : Leaves(leaves)
  , Options(options)
  , Deepest(deepest)
{
}

//----------------------------------------------------------------------------------------------------------------------
CellSizes OctreeCutter::Cut(PointId* first, PointId* last, const CubeBox& cube, int leastLevel)
{
  this->Sizes = CellSizes();
  this->LeastLevel = leastLevel;
  this->CutAny(first, last, cube, 0);
  return this->Sizes;
}

//----------------------------------------------------------------------------------------------------------------------
void OctreeCutter::CutAny(PointId* first, PointId* last, const CubeBox& box, int level)
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

//----------------------------------------------------------------------------------------------------------------------
/// Points without boundary points among them: cuts them until they are flat, and then on to the least level.
void OctreeCutter::CutInner(PointId* first, PointId* last, const CubeBox& box, int level)
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

//----------------------------------------------------------------------------------------------------------------------
void OctreeCutter::CutFlat(PointId* first, PointId* last, const CubeBox& box, int level)
{
  if (level >= this->LeastLevel)
  {
    this->MakeLeaf(first, level, false, false);
  }
  else if (last - first == 1) // the one octant it is in at the least level
  {
    this->MakeLeaf(first, this->LeastLevel, false, false);
  }
  else
  {
    this->Halve(first, last, box,
      [&](PointId* begin, PointId* end, const CubeBox& octant) { this->CutFlat(begin, end, octant, level + 1); });
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether a cell with boundary points is a leaf (thesis eq. 4.2): these lie densely, and far apart.
bool OctreeCutter::StaysWhole(const PointId* first, const PointId* last, std::ptrdiff_t boundaryPoints, double size)
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

//----------------------------------------------------------------------------------------------------------------------
/// Whether any two of BoundaryPoints, in a cell of that size, are farther apart than that (thesis eq. 4.1).
bool OctreeCutter::AnyApart(double extent, double size) const
{
  if (extent > 2.0 * size) // more than the diagonal
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
    if (a == 0 && 2.0 * reach <= extent) // all are so near to the first one that no two can be far apart
    {
      return false;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
/// Sorts points into the octants of a box, each in the order they came in, and calls visit(first, last, octant) for
/// those that have some.
template <typename Visitor>
void OctreeCutter::Halve(PointId* first, PointId* last, const CubeBox& box, Visitor&& visit)
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

//----------------------------------------------------------------------------------------------------------------------
void OctreeCutter::MakeLeaf(PointId* first, int level, bool hasBoundary, bool keepsInner)
{
  this->Leaves.MarkLeaf(first, level, hasBoundary, keepsInner);
  this->Sizes.Sum += double(std::int64_t(1) << (this->Deepest - level));
  ++this->Sizes.Number;
}
}
