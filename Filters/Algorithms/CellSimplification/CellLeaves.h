// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a horizon sorted into square cells, and cells cut into leaves (thesis 4.3).
//
// Terms:
//  - cell: a square of the grid in plan with points in it. The elaborate simplification stacks cubes on it and halves
//    them; the pieces are called cells as well, and how many times one was halved is its level.
//  - side: the points of one patch in one cell of level 0, and where the cell is cut, on one side of the cuts.
//  - group: the points of one side; the elaborate simplification parts them by height, too.
//  - leaf: the points of a group in a cell that is not cut any further. A group is one leaf until it is cut.
//  - inner points: the points of a leaf that are not on the boundary.
//
// All points stand in one array: cell by cell, in a cell group by group, in a group leaf by leaf, and in a leaf in the
// order of the input. So each of these is a range of the array, and what is known of a leaf is noted where it begins:
//
//     cells    |     0     |       1       | 2 |
//     groups   |  0  |  1  |       2       | 3 |
//     points   | 2 7 | 3 8 | 1 4 9   0 5   | 6 |
//     leaves     *     *     *       *       *
//
// Squares without points have no number and take no memory: parts of a horizon may be any distance apart.

#ifndef SeismicHorizonsCellLeaves_h
#define SeismicHorizonsCellLeaves_h

#include "Common/BoundedHorizon.h"
#include "Common/CellGrid.h"
#include "Common/Monitor.h"
#include "Common/Parallel.h"
#include "Common/Types.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class CellLeaves
{
public:
  /// How many cells a thread takes at a time: little work next to all of it, much next to the start of a thread.
  static constexpr std::int64_t Grain = 1024;

  /// Cells, by their index in the grid, in ascending order, and where their points begin.
  using Starts = std::vector<std::pair<std::int64_t, std::uint32_t>>;

  /// Sorts the points, at least one, into cells of so many columns. Throws InputError when these are below 1. Keeps a
  /// reference to the horizon.
  CellLeaves(const BoundedHorizon& horizon, int columns, const Monitor& monitor);

  const BoundedHorizon& Horizon() const { return this->Input; }
  const CellGrid& Grid() const { return this->Cells; }
  /// The side of a cell in sub-voxels; that of the grid may be less where one cell covers the horizon.
  std::int64_t CellSize() const { return this->Side; }

  const SubVoxelPlaces& Places() const { return this->Given; }
  PlanePoint Plane(PointId point) const { return this->Given[point]; }
  double Height(PointId point) const { return this->Input.Height[point]; }
  /// In lattice units.
  SpacePoint Place(PointId point) const
  {
    const PlanePoint place = this->Plane(point);
    return { place.X * this->Scale, place.Y * this->Scale, this->Height(point) };
  }
  std::int32_t Patch(PointId point) const { return this->Input.Patch[point]; }
  /// The number of the side that a point is on in its cell: where the cell is not cut, that of its patch.
  std::int32_t SideOf(PointId point) const { return this->Sides.empty() ? this->Patch(point) : this->Sides[point]; }
  bool HasCuts() const { return !this->Sides.empty(); }
  bool IsOnBoundary(PointId point) const { return this->OnBoundary[point] != 0; }
  /// For each point 1 when it is on the boundary, else 0.
  const std::vector<unsigned char>& BoundaryFlags() const { return this->OnBoundary; }

  /// Cells are numbered row by row of the grid.
  std::int64_t NumberOfCells() const { return std::int64_t(this->Squares.size()); }
  /// The index of a cell in the grid.
  std::int64_t Square(std::int64_t cell) const { return this->Squares[cell]; }
  /// The first cell whose index in the grid is at least this; NumberOfCells() when there is none.
  std::int64_t FirstCellFrom(std::int64_t square) const
  {
    return this->FirstCells.empty()
      ? std::lower_bound(this->Squares.begin(), this->Squares.end(), square) - this->Squares.begin()
      : this->FirstCells[square];
  }

  /// How many points of the original horizon a point represents; at least 1, whatever the horizon says.
  std::int64_t Weight(PointId point) const
  {
    return this->Input.Count.empty() ? 1 : std::max<std::int64_t>(1, this->Input.Count[point]);
  }

  /// Sorts the points of every cell into groups of equal key(point), an std::int64_t, in ascending order. Each group is
  /// one leaf then.
  template <typename Key>
  void MakeGroups(Key&& key, const Monitor& monitor);

  std::size_t NumberOfGroups() const { return this->GroupEnds.back(); }
  /// The groups of a cell are FirstGroup(cell) to before FirstGroup(cell + 1).
  std::size_t FirstGroup(std::int64_t cell) const { return this->GroupEnds[cell]; }

  /// Calls visit(first, last) for the groups of a cell; before any of them is cut. Who cuts a group may give its points
  /// another order.
  template <typename Visitor>
  void ForEachGroup(std::int64_t cell, Visitor&& visit)
  {
    this->ForEachRange(this->Begin(cell), this->Begin(cell + 1), visit);
  }

  /// Lets a leaf begin at a point. `level` is how many times its cell was halved. `keepsInner` is for a leaf with
  /// boundary points: whether one point represents its inner points, or these go.
  void MarkLeaf(PointId* first, int level, bool hasBoundary, bool keepsInner)
  {
    this->MarkOf(first) = static_cast<unsigned char>(
      Start | (hasBoundary ? Boundary : 0U) | (keepsInner ? KeepsInner : 0U) | (unsigned(level) & LevelMask));
  }

  /// Calls visit(first, last) for the leaves of a cell.
  template <typename Visitor>
  void ForEachLeaf(std::int64_t cell, Visitor&& visit) const
  {
    this->ForEachRange<const PointId*>(this->Begin(cell), this->Begin(cell + 1), visit);
  }
  /// The same for the leaves of a group.
  template <typename Visitor>
  void ForEachLeaf(const PointId* first, const PointId* last, Visitor&& visit) const
  {
    this->ForEachRange(first, last, visit);
  }
  /// The same for all leaves.
  template <typename Visitor>
  void ForEachLeaf(Visitor&& visit) const
  {
    this->ForEachRange<const PointId*>(this->Points.get(), this->Points.get() + this->Given.size(), visit);
  }

  // What is known of a leaf, by its first point.
  int Level(const PointId* leaf) const { return int(this->MarkOf(leaf) & LevelMask); }
  bool HasBoundary(const PointId* leaf) const { return (this->MarkOf(leaf) & Boundary) != 0; }
  /// Whether one point represents the inner points: in a leaf without boundary points, and where MarkLeaf said so.
  bool MergesInner(const PointId* leaf) const { return MergesInner(this->MarkOf(leaf)); }
  /// For how many leaves of a cell this is so.
  std::uint32_t CountMerging(std::int64_t cell) const;

private:
  // What the mark of a leaf is made of. Elsewhere marks are 0.
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
  /// Marks where keys change, and counts the groups. False when keys do not ascend: then points have to be sorted
  /// first.
  template <typename Key>
  bool MarkGroups(PointId* first, PointId* last, Key& key, std::uint32_t& groups);
  /// Calls visit for the ranges that begin at marks.
  template <typename Iterator, typename Visitor>
  void ForEachRange(Iterator first, Iterator last, Visitor& visit) const;

  PointId* Begin(std::int64_t cell) const { return this->Points.get() + this->CellBegins[cell]; }
  unsigned char& MarkOf(PointId* point) { return this->Marks[point - this->Points.get()]; }
  unsigned char MarkOf(const PointId* point) const { return this->Marks[point - this->Points.get()]; }

  const BoundedHorizon& Input;
  const SubVoxelPlaces Given; // its places
  const double Scale; // columns in a sub-voxel
  const std::int64_t Side;
  const CellGrid Cells; // all squares
  std::vector<unsigned char> OnBoundary;
  std::vector<std::int32_t> Sides; // by point; empty without cuts
  std::unique_ptr<PointId[]> Points; // the array of all points
  std::vector<unsigned char> Marks; // for each entry of Points: what kind of leaf begins there, or 0
  std::vector<std::int64_t> Squares; // the index of each cell in the grid
  std::vector<std::uint32_t> CellBegins; // where the points of each cell begin, and at the end their number
  std::vector<std::uint32_t> FirstCells; // FirstCellFrom(square) for all squares, unless most of these are empty
  std::vector<std::uint32_t> GroupEnds; // like CellBegins, the number of the first group of each cell
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
  if (this->MarkGroups(first, last, key, groups)) // most cells have one group
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
}

#endif
