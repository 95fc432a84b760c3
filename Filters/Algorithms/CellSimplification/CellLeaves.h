// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of a horizon, sorted into square cells that are cut into leaves (thesis 4.3). Terms:
//  - cell: a square of the grid in plan that has points. The elaborate simplification stacks cubes on it and halves
//    them; the pieces are cells as well, with the number of halvings as their level.
//  - side: points of one patch in one cell of level 0, and on one side of the cuts in the cell.
//  - group: points of one side; the elaborate simplification divides them by height, too.
//  - leaf: points of a group in a cell that is not cut further. An uncut group is one leaf.
//  - inner points: points of a leaf that are not on the boundary.
//
// An array holds all points by cell, group and leaf, and within a leaf in the order of the input. Each of these is a
// range of the array, and a leaf is described by a mark at its first point:
//
//     cells    |     0     |       1       | 2 |
//     groups   |  0  |  1  |       2       | 3 |
//     points   | 2 7 | 3 8 | 1 4 9   0 5   | 6 |
//     leaves     *     *     *       *       *
//
// Squares without points take no memory, so that patches may be any distance apart.

#ifndef SeismicHorizonsCellLeaves_h
#define SeismicHorizonsCellLeaves_h

#include "CellSimplification.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/CellGrid.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class CellLeaves
{
public:
  static constexpr std::int64_t Grain = 1024; // cells per task

  /// Squares with their first points are ascending.
  using Starts = std::vector<std::pair<std::int64_t, std::uint32_t>>;

  /// `columns` is the cell size, at least 1 (InputError). The object keeps a reference to the horizon, which must have
  /// points.
  CellLeaves(const BoundedHorizon& horizon, int columns, const Monitor& monitor);

  const BoundedHorizon& Horizon() const { return this->Input; }
  const CellGrid& Grid() const { return this->Cells; }
  /// This is in sub-voxels; a single cell of the grid may be smaller.
  std::int64_t CellSize() const { return this->Side; }

  const SubVoxelPlaces& Places() const { return this->Given; }
  PlanePoint Plane(PointId point) const { return this->Given[point]; }
  double Height(PointId point) const { return this->Input.Height[point]; }
  SpacePoint Place(PointId point) const
  {
    const PlanePoint place = this->Plane(point);
    return { place.X * this->Scale, place.Y * this->Scale, this->Height(point) };
  }
  std::int32_t Patch(PointId point) const { return this->Input.Patch[point]; }
  /// Without cuts in the cell, this is the number of the patch.
  std::int32_t SideOf(PointId point) const { return this->Sides.empty() ? this->Patch(point) : this->Sides[point]; }
  bool HasCuts() const { return !this->Sides.empty(); }
  bool IsOnBoundary(PointId point) const { return this->OnBoundary[point] != 0; }
  const std::vector<unsigned char>& BoundaryFlags() const { return this->OnBoundary; }

  std::int64_t NumberOfCells() const { return std::int64_t(this->Squares.size()); }
  std::int64_t Square(std::int64_t cell) const { return this->Squares[cell]; }
  std::int64_t FirstCellFrom(std::int64_t square) const
  {
    return this->FirstCells.empty()
      ? std::lower_bound(this->Squares.begin(), this->Squares.end(), square) - this->Squares.begin()
      : this->FirstCells[square];
  }

  /// This is the number of original points that the point represents, at least 1 also for invalid input.
  std::int64_t Weight(PointId point) const
  {
    return this->Input.Count.empty() ? 1 : std::max<std::int64_t>(1, this->Input.Count[point]);
  }

  /// Groups have equal keys (std::int64_t), in ascending order. Each group is one leaf at first.
  template <typename Key>
  void MakeGroups(Key&& key, const Monitor& monitor);

  std::size_t NumberOfGroups() const { return this->GroupEnds.back(); }
  std::size_t FirstGroup(std::int64_t cell) const { return this->GroupEnds[cell]; }

  /// Groups must not have been cut. The visitor may reorder the points of a group.
  template <typename Visitor>
  void ForEachGroup(std::int64_t cell, Visitor&& visit)
  {
    this->ForEachRange(this->Begin(cell), this->Begin(cell + 1), visit);
  }

  /// `keepsInner` matters in leaves with boundary points: one point represents the inner points, or they are dropped.
  void MarkLeaf(PointId* first, int level, bool hasBoundary, bool keepsInner)
  {
    this->MarkOf(first) = static_cast<unsigned char>(
      Start | (hasBoundary ? Boundary : 0U) | (keepsInner ? KeepsInner : 0U) | (unsigned(level) & LevelMask));
  }

  template <typename Visitor>
  void ForEachLeaf(std::int64_t cell, Visitor&& visit) const
  {
    this->ForEachRange<const PointId*>(this->Begin(cell), this->Begin(cell + 1), visit);
  }
  template <typename Visitor>
  void ForEachLeaf(const PointId* first, const PointId* last, Visitor&& visit) const
  {
    this->ForEachRange(first, last, visit);
  }
  template <typename Visitor>
  void ForEachLeaf(Visitor&& visit) const
  {
    this->ForEachRange<const PointId*>(this->Points.get(), this->Points.get() + this->Given.size(), visit);
  }

  int Level(const PointId* leaf) const { return int(this->MarkOf(leaf) & LevelMask); }
  bool HasBoundary(const PointId* leaf) const { return (this->MarkOf(leaf) & Boundary) != 0; }
  bool MergesInner(const PointId* leaf) const { return MergesInner(this->MarkOf(leaf)); }
  std::uint32_t CountMerging(std::int64_t cell) const;

private:
  static constexpr unsigned Start = 0x80;
  static constexpr unsigned Boundary = 0x40;
  static constexpr unsigned KeepsInner = 0x20;
  static constexpr unsigned LevelMask = 0x1f;

  using KeyedPoints = std::vector<std::pair<std::int64_t, PointId>>;

  static bool MergesInner(unsigned mark) { return (mark & Start) && (!(mark & Boundary) || (mark & KeepsInner)); }

  void MakeCells(const std::vector<Starts>& bands);
  void IndexSquares();
  void FindSides();
  PlanePoint ColumnOf(PointId point) const;
  template <typename Key>
  std::uint32_t GroupCell(std::int64_t cell, Key& key, KeyedPoints& keyed);
  /// Returns false if keys are not ascending, so that the points must be sorted first.
  template <typename Key>
  bool MarkGroups(PointId* first, PointId* last, Key& key, std::uint32_t& groups);
  template <typename Iterator, typename Visitor>
  void ForEachRange(Iterator first, Iterator last, Visitor& visit) const;

  PointId* Begin(std::int64_t cell) const { return this->Points.get() + this->CellBegins[cell]; }
  unsigned char& MarkOf(PointId* point) { return this->Marks[point - this->Points.get()]; }
  unsigned char MarkOf(const PointId* point) const { return this->Marks[point - this->Points.get()]; }

  const BoundedHorizon& Input;
  const SubVoxelPlaces Given;
  const double Scale; // columns per sub-voxel
  const std::int64_t Side;
  const CellGrid Cells;
  std::vector<unsigned char> OnBoundary;
  std::vector<std::int32_t> Sides; // by point; empty without cuts
  std::unique_ptr<PointId[]> Points;
  std::vector<unsigned char> Marks; // not 0 where a leaf begins
  std::vector<std::int64_t> Squares; // index in the grid
  std::vector<std::uint32_t> CellBegins; // first entry of Points by cell, and the end
  std::vector<std::uint32_t> FirstCells; // This caches FirstCellFrom(square), unless most squares are empty.
  std::vector<std::uint32_t> GroupEnds; // first group by cell, and the end
};

//----------------------------------------------------------------------------------------------------------------------
template <typename Key>
void CellLeaves::MakeGroups(Key&& key, const Monitor& monitor)
{
  this->GroupEnds.assign(this->Squares.size() + 1, 0);
  ParallelFor(this->NumberOfCells(), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      KeyedPoints keyed;
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        this->GroupEnds[cell + 1] = this->GroupCell(cell, key, keyed);
      }
    });
  std::partial_sum(this->GroupEnds.begin(), this->GroupEnds.end(), this->GroupEnds.begin());
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Key>
std::uint32_t CellLeaves::GroupCell(std::int64_t cell, Key& key, KeyedPoints& keyed)
{
  PointId* const first = this->Begin(cell);
  PointId* const last = this->Begin(cell + 1);
  std::uint32_t groups = 0;
  if (this->MarkGroups(first, last, key, groups))
  {
    return groups;
  }
  keyed.clear();
  for (PointId* point = first; point != last; ++point)
  {
    keyed.emplace_back(key(*point), *point);
    this->MarkOf(point) = 0;
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(keyed.begin(), keyed.end(), first, [](const auto& keyedPoint) { return keyedPoint.second; });
  this->MarkGroups(first, last, key, groups);
  return groups;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Key>
bool CellLeaves::MarkGroups(PointId* first, PointId* last, Key& key, std::uint32_t& groups)
{
  groups = 0;
  PointId* start = first;
  std::int64_t current = 0;
  for (PointId* point = first; point != last; ++point)
  {
    const std::int64_t next = key(*point);
    if (point != first && next < current)
    {
      return false;
    }
    if (point == first || next > current)
    {
      start = point;
      current = next;
      this->MarkLeaf(start, 0, false, false);
      ++groups;
    }
    if (this->IsOnBoundary(*point))
    {
      this->MarkLeaf(start, 0, true, false);
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Iterator, typename Visitor>
void CellLeaves::ForEachRange(Iterator first, Iterator last, Visitor& visit) const
{
  while (first != last)
  {
    Iterator next = first + 1;
    while (next != last && this->MarkOf(next) == 0)
    {
      ++next;
    }
    visit(first, next);
    first = next;
  }
}

/// Boundary points come first, in the order of the input, then a point for each leaf that MergesInner. Inner points of
/// other leaves are counted with the nearest boundary point of their leaf. Rings remain 0.
Reduction WriteLeaves(const CellLeaves& leaves, RepresentativeKind representative, const Monitor& monitor);

using CellBottom = std::function<double(const PointId* first, const PointId* last, int level)>;

void ListCells(const CellLeaves& leaves, Reduction& result, const CellBottom& bottom);
}

#endif
