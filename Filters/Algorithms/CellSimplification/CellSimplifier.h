// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the simplifications of the inside have in common (thesis 4.3): points are sorted into square cells, cells are
// cut into leaves, and each leaf gives the points that stand for it.
//
// Terms: a group is the points of one patch in one cell (and one layer, where cells end upwards, too). A leaf is a
// piece of a group, or all of it. A leaf with boundary points keeps these; one without becomes one point.
//
// A barycentre has to be strictly inside the boundary and alone in its place. When it is not, the input point of the
// leaf that is nearest to it in plan stands for the leaf: input points inside are strictly inside, and no two of them
// share a place.

#ifndef SeismicHorizonsCellSimplifier_h
#define SeismicHorizonsCellSimplifier_h

#include "Common/BoundedHorizon.h"
#include "Common/CellGrid.h"
#include "Common/Monitor.h"
#include "Common/Parallel.h"
#include "Common/Types.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// What stands for a cell: the mean of its points, or the input point nearest to that.
enum class RepresentativeKind
{
  Barycentre = 0,
  NearestPoint = 1
};

/// The options that all simplifications of the inside have.
struct CellOptions
{
  CellOptions(int cellSize, RepresentativeKind representative = RepresentativeKind::Barycentre, bool listCells = false)
    : CellSize(cellSize)
    , Representative(representative)
    , ListCells(listCells)
  {
  }

  int CellSize; // columns, at least 1
  RepresentativeKind Representative;
  bool ListCells; // whether the result says which cells there were
};

class CellSimplifier
{
public:
  /// The points of cells in one piece of memory: those of a cell, of a group, of a leaf follow each other there, each
  /// in the order of the input. Sorting and cutting cells permutes them, which leaves may do for themselves.
  using Iterator = PointId*;

  /// Sorts the points into cells. Throws InputError when the cell size is below 1. Keeps a reference to the horizon.
  CellSimplifier(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor);

  const BoundedHorizon& Input() const { return this->Horizon; }
  const CellGrid& Grid() const { return this->PlaneCells; }
  /// The side of a cell in sub-voxels.
  std::int64_t CellSize() const { return this->Side; }
  bool IsOnBoundary(PointId point) const { return this->OnBoundary[std::size_t(point)] != 0; }

  /// How many points of the original horizon a point stands for; one that says none counts as one.
  std::int64_t Weight(PointId point) const
  {
    return std::max<std::int64_t>(1, this->Horizon.Count[std::size_t(point)]);
  }

  /// Cuts every cell into groups of equal key(point), an std::int64_t, in ascending order. Each group is one leaf then.
  template <typename Key>
  void MakeGroups(Key&& key, const Monitor& monitor);

  std::size_t NumberOfGroups() const { return this->GroupEnds.back(); }
  /// The groups of a cell are FirstGroup(cell) to FirstGroup(cell + 1).
  std::size_t FirstGroup(std::int64_t cell) const { return this->GroupEnds[std::size_t(cell)]; }
  /// Calls visit(first, last) for the groups of a cell, as long as no leaf was cut.
  template <typename Visitor>
  void ForEachLeaf(std::int64_t cell, Visitor&& visit);
  template <typename Visitor>
  void ForEachLeaf(Iterator first, Iterator last, Visitor&& visit);
  bool HasBoundary(Iterator leaf) const { return (this->MarkOf(leaf) & Boundary) != 0; }

  /// Makes a leaf begin at a point. `level` is how many times its cell was halved. `keepsInner` is for a leaf that has
  /// both boundary points and others: whether these become one, or go.
  void MarkLeaf(Iterator first, int level, bool hasBoundary, bool keepsInner)
  {
    this->MarkOf(first) = static_cast<unsigned char>(
      Start | (hasBoundary ? Boundary : 0U) | (keepsInner ? KeepsInner : 0U) | (unsigned(level) & LevelMask));
  }

  /// Makes the output points. Boundary points come first, in the order of the input, then what stands for the leaves,
  /// in their order.
  Reduction Write(const Monitor& monitor);

  /// Adds the leaves to what Write gave. bottom(first, last, level) is the height at which to show a leaf.
  template <typename Bottom>
  void ListCells(Reduction& result, Bottom&& bottom);

private:
  // What a mark is made of.
  static constexpr unsigned Start = 0x80;
  static constexpr unsigned Boundary = 0x40;
  static constexpr unsigned KeepsInner = 0x20;
  static constexpr unsigned LevelMask = 0x1f;

  /// What stands for the inner points of a leaf.
  struct StandIn
  {
    Iterator First = nullptr;
    Iterator Last = nullptr;
    PlanePoint Place;
    double Height = 0.0;
    PointId Nearest = NoPoint;
    bool Averaged = false;
  };

  /// What a thread needs to work on a cell.
  struct Scratch
  {
    std::vector<std::pair<std::int64_t, PointId>> Keyed;
    std::vector<PointId> Kept;
    std::vector<StandIn> StandIns;
    std::vector<PlanePoint> Places;
  };

  void SortPoints(const Monitor& monitor);
  void NumberBoundary();
  template <typename Key>
  std::uint32_t GroupCell(std::int64_t cell, Key& key, Scratch& scratch);
  /// False when keys do not ascend, so that points have to be sorted first, as they seldom have.
  template <typename Key>
  bool MarkGroups(Iterator first, Iterator last, Key& key, std::uint32_t& groups);

  std::vector<std::uint32_t> CountStandIns(const Monitor& monitor) const;
  void WriteCell(std::int64_t cell, PointId next, Scratch& scratch);
  void KeepBoundary(Iterator first, Iterator last, Scratch& scratch);
  PointId NearestKept(const PlanePoint& place, const std::vector<PointId>& kept) const;
  StandIn FindStandIn(std::int64_t cell, Iterator first, Iterator last) const;
  StandIn FindBarycentre(Iterator first, Iterator last) const;
  bool IsInside(std::int64_t cell, const PlanePoint& place, PointId inner) const;
  void PartPlaces(Scratch& scratch) const;
  SimplificationCell DescribeLeaf(const Reduction& result, const PointId* first, const PointId* last) const;
  void UseNearest(StandIn& standIn) const;
  void WritePoint(const StandIn& standIn, PointId number);

  Iterator CellBegin(std::int64_t cell) { return this->Points.get() + this->CellEnds[std::size_t(cell)]; }
  unsigned char& MarkOf(Iterator point) { return this->Marks[std::size_t(point - this->Points.get())]; }
  unsigned char MarkOf(const PointId* point) const { return this->Marks[std::size_t(point - this->Points.get())]; }
  const PlanePoint& Plane(PointId point) const { return this->Horizon.Plane[std::size_t(point)]; }

  const BoundedHorizon& Horizon;
  const CellOptions Options;
  const std::int64_t Side;
  const CellGrid PlaneCells;
  const EdgeLists Edges;
  std::vector<unsigned char> OnBoundary;
  std::unique_ptr<PointId[]> Points; // cell by cell
  std::vector<unsigned char> Marks; // for each entry of Points: what kind of leaf begins there, or 0
  std::vector<std::uint32_t> CellEnds; // where the points of each cell begin, and at the end their number
  std::vector<std::uint32_t> GroupEnds; // likewise for groups
  Reduction Result;
};

//----------------------------------------------------------------------------------------------------------------------
template <typename Key>
void CellSimplifier::MakeGroups(Key&& key, const Monitor& monitor)
{
  const std::int64_t cells = this->PlaneCells.Size();
  this->GroupEnds.assign(std::size_t(cells) + 1, 0);
  ParallelFor(cells, 1024, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      Scratch scratch;
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        this->GroupEnds[std::size_t(cell) + 1] = this->GroupCell(cell, key, scratch);
      }
    });
  for (std::size_t cell = 1; cell < this->GroupEnds.size(); ++cell)
  {
    this->GroupEnds[cell] += this->GroupEnds[cell - 1];
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Key>
std::uint32_t CellSimplifier::GroupCell(std::int64_t cell, Key& key, Scratch& scratch)
{
  Iterator first = this->CellBegin(cell);
  Iterator last = this->CellBegin(cell + 1);
  std::uint32_t groups = 0;
  if (this->MarkGroups(first, last, key, groups))
  {
    return groups;
  }
  scratch.Keyed.clear();
  for (Iterator point = first; point != last; ++point)
  {
    scratch.Keyed.emplace_back(key(*point), *point);
    this->MarkOf(point) = 0;
  }
  std::stable_sort(
    scratch.Keyed.begin(), scratch.Keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(scratch.Keyed.begin(), scratch.Keyed.end(), first, [](const auto& keyed) { return keyed.second; });
  this->MarkGroups(first, last, key, groups);
  return groups;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Key>
bool CellSimplifier::MarkGroups(Iterator first, Iterator last, Key& key, std::uint32_t& groups)
{
  groups = 0;
  Iterator start = first;
  std::int64_t current = 0;
  for (Iterator point = first; point != last; ++point)
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
template <typename Bottom>
void CellSimplifier::ListCells(Reduction& result, Bottom&& bottom)
{
  this->ForEachLeaf(this->Points.get(), this->Points.get() + this->Horizon.Plane.size(),
    [&](Iterator first, Iterator last)
    {
      SimplificationCell leaf = this->DescribeLeaf(result, first, last);
      leaf.Low.Z = bottom(first, last, int(leaf.Origin.Level));
      result.Cells.push_back(leaf);
    });
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Visitor>
void CellSimplifier::ForEachLeaf(std::int64_t cell, Visitor&& visit)
{
  this->ForEachLeaf(this->CellBegin(cell), this->CellBegin(cell + 1), std::forward<Visitor>(visit));
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Visitor>
void CellSimplifier::ForEachLeaf(Iterator first, Iterator last, Visitor&& visit)
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
