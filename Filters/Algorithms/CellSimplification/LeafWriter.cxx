// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: number the boundary points; count the new points of each cell, and add the counts up; let every cell write its
// points to the places that it knows by then. So no thread waits for another, and the order is that of the cells.

#include "LeafWriter.h"

#include "Common/Parallel.h"
#include "NearestPoint.h"
#include "StandIns.h"

#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
class LeafWriter
{
public:
  LeafWriter(const CellLeaves& leaves, RepresentativeKind representative)
    : Leaves(leaves)
    , StandIns(leaves, representative)
  {
  }

  Reduction Run(const Monitor& monitor);

private:
  /// What a thread needs to work on a cell.
  struct Scratch
  {
    std::vector<PointId> Kept; // the boundary points of a leaf
    std::vector<StandIn> Found;
    std::vector<PlanePoint> Places;
  };

  void NumberBoundaryPoints();
  std::vector<std::uint32_t> CountNewPoints(const Monitor& monitor) const;
  void WriteCell(std::int64_t cell, PointId next, Scratch& scratch);
  void WriteBoundaryPoints(const PointId* first, const PointId* last, std::vector<PointId>& kept);
  void MergeIntoBoundary(const PointId* first, const PointId* last, std::vector<PointId>& kept);
  void WriteNewPoint(const StandIn& standIn, PointId number);

  const CellLeaves& Leaves;
  const StandInFinder StandIns;
  Reduction Result;
};

//----------------------------------------------------------------------------------------------------------------------
Reduction LeafWriter::Run(const Monitor& monitor)
{
  this->NumberBoundaryPoints();
  const std::vector<std::uint32_t> next = this->CountNewPoints(monitor.Step(0.0, 0.2));
  const std::size_t size = next.back();
  this->Result.Source.resize(size);
  this->Result.Averaged.assign(size, 0);
  this->Result.Plane.resize(size);
  this->Result.Height.resize(size);
  this->Result.Origin.resize(size);
  ParallelFor(this->Leaves.Grid().Size(), CellLeaves::Grain, monitor.Step(0.2, 1.0),
    [&](std::int64_t first, std::int64_t last)
    {
      Scratch scratch;
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        this->WriteCell(cell, PointId(next[std::size_t(cell)]), scratch);
      }
    });
  return std::move(this->Result);
}

//----------------------------------------------------------------------------------------------------------------------
void LeafWriter::NumberBoundaryPoints()
{
  const std::vector<unsigned char>& flags = this->Leaves.BoundaryFlags();
  this->Result.Target.assign(flags.size(), NoPoint);
  // Few points are on the boundary: memchr finds them many times faster than a loop over all flags.
  const unsigned char* const begin = flags.data();
  const unsigned char* const end = begin + flags.size();
  const auto find = [end](const unsigned char* from)
  { return static_cast<const unsigned char*>(std::memchr(from, 1, std::size_t(end - from))); };
  for (const unsigned char* found = find(begin); found; found = found + 1 < end ? find(found + 1) : nullptr)
  {
    this->Result.Target[std::size_t(found - begin)] = PointId(this->Result.Source.size());
    this->Result.Source.push_back(PointId(found - begin));
  }
  this->Result.Boundary = this->Leaves.Horizon().Boundary.Renumbered(this->Result.Target);
}

//----------------------------------------------------------------------------------------------------------------------
/// For each cell the number of its first new point, and at the end the number of all points.
std::vector<std::uint32_t> LeafWriter::CountNewPoints(const Monitor& monitor) const
{
  std::vector<std::uint32_t> next(std::size_t(this->Leaves.Grid().Size()) + 1, 0);
  ParallelFor(this->Leaves.Grid().Size(), CellLeaves::Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        next[std::size_t(cell) + 1] = this->Leaves.CountMerging(cell);
      }
    });
  next.front() = std::uint32_t(this->Result.Source.size());
  std::partial_sum(next.begin(), next.end(), next.begin());
  return next;
}

//----------------------------------------------------------------------------------------------------------------------
void LeafWriter::WriteCell(std::int64_t cell, PointId next, Scratch& scratch)
{
  scratch.Found.clear();
  this->Leaves.ForEachLeaf(cell,
    [&](const PointId* first, const PointId* last)
    {
      if (this->Leaves.HasBoundary(first))
      {
        this->WriteBoundaryPoints(first, last, scratch.Kept);
      }
      if (this->Leaves.MergesInner(first))
      {
        scratch.Found.push_back(this->StandIns.Find(cell, first, last));
      }
      else if (std::ptrdiff_t(scratch.Kept.size()) < last - first)
      {
        this->MergeIntoBoundary(first, last, scratch.Kept);
      }
    });
  this->StandIns.SeparatePlaces(scratch.Found, scratch.Places);
  for (const StandIn& standIn : scratch.Found)
  {
    this->WriteNewPoint(standIn, next);
    ++next;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void LeafWriter::WriteBoundaryPoints(const PointId* first, const PointId* last, std::vector<PointId>& kept)
{
  kept.clear();
  for (const PointId* point = first; point != last; ++point)
  {
    if (this->Leaves.IsOnBoundary(*point))
    {
      const std::size_t number = std::size_t(this->Result.Target[std::size_t(*point)]);
      this->Result.Plane[number] = this->Leaves.Plane(*point);
      this->Result.Height[number] = this->Leaves.Height(*point);
      this->Result.Origin[number].Level = static_cast<unsigned char>(this->Leaves.Level(first));
      kept.push_back(*point);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void LeafWriter::MergeIntoBoundary(const PointId* first, const PointId* last, std::vector<PointId>& kept)
{
  const NearestPoint nearestKept(this->Leaves.Horizon().Plane, kept);
  for (const PointId* point = first; point != last; ++point)
  {
    if (!this->Leaves.IsOnBoundary(*point))
    {
      const PointId nearest = nearestKept.Find(this->Leaves.Plane(*point));
      this->Result.Target[std::size_t(*point)] = this->Result.Target[std::size_t(nearest)];
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void LeafWriter::WriteNewPoint(const StandIn& standIn, PointId number)
{
  const std::size_t target = std::size_t(number);
  this->Result.Source[target] = standIn.Nearest;
  this->Result.Averaged[target] = standIn.Averaged ? 1 : 0;
  this->Result.Plane[target] = standIn.Plane;
  this->Result.Height[target] = standIn.Height;
  this->Result.Origin[target].Level = static_cast<unsigned char>(this->Leaves.Level(standIn.First));
  this->Result.Origin[target].Kind = standIn.Averaged ? PointKind::Barycentre : PointKind::InputPoint;
  for (const PointId* point = standIn.First; point != standIn.Last; ++point)
  {
    if (!this->Leaves.IsOnBoundary(*point))
    {
      this->Result.Target[std::size_t(*point)] = number;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// The cell of a leaf, at height 0: the cell of the grid, halved as often as the leaf says, towards its first point.
SimplificationCell DescribeCell(
  const CellLeaves& leaves, const Reduction& result, const PointId* first, const PointId* last)
{
  const PlanePoint& place = leaves.Plane(*first);
  const PlanePoint corner = leaves.Grid().Corner(leaves.Grid().CellOf(place));
  std::int64_t x = corner.X;
  std::int64_t y = corner.Y;
  std::int64_t size = leaves.CellSize();
  for (int level = 0; level < leaves.Level(first); ++level)
  {
    size /= 2;
    x += place.X - x >= size ? size : 0;
    y += place.Y - y >= size ? size : 0;
  }
  const double scale = 1.0 / leaves.Horizon().SubVoxelsPerColumn;
  SimplificationCell cell;
  cell.Low = { double(x) * scale, double(y) * scale, 0.0 };
  cell.Size = double(size) * scale;
  cell.Origin = result.Origin[std::size_t(result.Target[std::size_t(*first)])];
  cell.Origin.Kind = leaves.HasBoundary(first) ? PointKind::Boundary : cell.Origin.Kind;
  cell.Flatness = result.Flatness.empty() ? 0.0 : result.Flatness[std::size_t(result.Target[std::size_t(*first)])];
  cell.Patch = leaves.Patch(*first);
  cell.Points = std::int32_t(last - first);
  return cell;
}
}

//----------------------------------------------------------------------------------------------------------------------
Reduction WriteLeaves(const CellLeaves& leaves, RepresentativeKind representative, const Monitor& monitor)
{
  return LeafWriter(leaves, representative).Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void ListCells(const CellLeaves& leaves, Reduction& result, const CellBottom& bottom)
{
  leaves.ForEachLeaf(
    [&](const PointId* first, const PointId* last)
    {
      SimplificationCell cell = DescribeCell(leaves, result, first, last);
      cell.Low.Z = bottom(first, last, leaves.Level(first));
      result.Cells.push_back(cell);
    });
}
}
