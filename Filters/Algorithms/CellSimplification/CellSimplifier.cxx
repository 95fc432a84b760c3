// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: number the kept boundary points; sort all points by cell; note which boundary edges cross which cells. Then,
// once the caller has cut cells into leaves: count what each cell gives, add the counts up, and let every cell write
// its points to the places it knows then. So no thread waits for another, and the order is that of the cells.

#include "CellSimplifier.h"

#include "CellSorter.h"
#include "Common/Errors.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>
#include <sstream>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 1024; // cells; small next to a cell of work, large next to a thread

/// The nearest integer; halves go up.
std::int32_t RoundedQuotient(std::int64_t sum, std::int64_t count)
{
  const std::int64_t numerator = 2 * sum + count;
  const std::int64_t quotient = numerator / (2 * count);
  return std::int32_t(numerator % (2 * count) < 0 ? quotient - 1 : quotient);
}

std::int64_t CheckedCellSize(const BoundedHorizon& horizon, int columns)
{
  if (columns < 1)
  {
    std::ostringstream text;
    text << "cell size " << columns << ", expected at least 1 column";
    throw InputError(text.str());
  }
  return std::int64_t(columns) * horizon.SubVoxelsPerColumn;
}

/// Whether the way between two places that are not on the edge a-b crosses it. An end that the way runs through counts
/// as lying to its left, so that the crossings of a whole loop come out even or odd as they must.
bool Crosses(const PlanePoint& a, const PlanePoint& b, const PlanePoint& from, const PlanePoint& to)
{
  return (SignedArea(from, to, a) >= 0) != (SignedArea(from, to, b) >= 0) &&
    (SignedArea(a, b, from) > 0) != (SignedArea(a, b, to) > 0);
}
}

//----------------------------------------------------------------------------------------------------------------------
CellSimplifier::CellSimplifier(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor)
  : Horizon(horizon)
  , Options(options)
  , Side(CheckedCellSize(horizon, options.CellSize))
  , PlaneCells(horizon.Plane, horizon.SubVoxelsPerColumn, this->Side)
  , Edges(SortByCell(this->PlaneCells, horizon.Plane, horizon.Boundary))
  , OnBoundary(horizon.Plane.size(), 0)
  , Marks(horizon.Plane.size(), 0)
{
  monitor.Progress(0.0);
  this->NumberBoundary();
  this->SortPoints(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void CellSimplifier::NumberBoundary()
{
  const Loops& boundary = this->Horizon.Boundary;
  boundary.ForEachPoint([this](PointId point) { this->OnBoundary[std::size_t(point)] = 1; });
  this->Result.Target.assign(this->Horizon.Plane.size(), NoPoint);
  // Boundary points are few and far between: memchr finds them many times faster than a loop.
  const unsigned char* const begin = this->OnBoundary.data();
  const unsigned char* const end = begin + this->OnBoundary.size();
  const auto find = [end](const unsigned char* from)
  { return static_cast<const unsigned char*>(std::memchr(from, 1, std::size_t(end - from))); };
  for (const unsigned char* found = find(begin); found; found = found + 1 < end ? find(found + 1) : nullptr)
  {
    this->Result.Target[std::size_t(found - begin)] = PointId(this->Result.Source.size());
    this->Result.Source.push_back(PointId(found - begin));
  }
  this->Result.Boundary = boundary.Renumbered(this->Result.Target);
}

//----------------------------------------------------------------------------------------------------------------------
void CellSimplifier::SortPoints(const Monitor& monitor)
{
  if (this->PlaneCells.Size() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::bad_alloc();
  }
  const std::size_t size = this->Horizon.Plane.size();
  this->Points.reset(new PointId[size]); // not a vector, which would write to all of it on one thread first
  this->CellEnds.assign(std::size_t(this->PlaneCells.Size()) + 1, 0);
  const CellSorter sorter(this->PlaneCells, this->Horizon.Plane, monitor.Step(0.0, 0.5));
  sorter.Sort(this->CellEnds, this->Points.get(), monitor.Step(0.5, 1.0));
  this->CellEnds.back() = std::uint32_t(size);
}

//----------------------------------------------------------------------------------------------------------------------
Reduction CellSimplifier::Write(const Monitor& monitor)
{
  const std::vector<std::uint32_t> next = this->CountStandIns(monitor.Step(0.0, 0.2));
  const std::size_t size = next.back();
  this->Result.Source.resize(size);
  this->Result.Averaged.assign(size, 0);
  this->Result.Plane.resize(size);
  this->Result.Height.resize(size);
  this->Result.Origin.resize(size);
  ParallelFor(this->PlaneCells.Size(), Grain, monitor.Step(0.2, 1.0),
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
std::vector<std::uint32_t> CellSimplifier::CountStandIns(const Monitor& monitor) const
{
  std::vector<std::uint32_t> next(std::size_t(this->PlaneCells.Size()) + 1, 0);
  ParallelFor(this->PlaneCells.Size(), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        const auto begin = this->Marks.begin() + this->CellEnds[std::size_t(cell)];
        const auto end = this->Marks.begin() + this->CellEnds[std::size_t(cell) + 1];
        next[std::size_t(cell) + 1] = std::uint32_t(std::count_if(
          begin, end, [](unsigned mark) { return (mark & Start) && (!(mark & Boundary) || (mark & KeepsInner)); }));
      }
    });
  next.front() = std::uint32_t(this->Result.Source.size());
  for (std::size_t cell = 1; cell < next.size(); ++cell)
  {
    next[cell] += next[cell - 1];
  }
  return next;
}

//----------------------------------------------------------------------------------------------------------------------
void CellSimplifier::WriteCell(std::int64_t cell, PointId next, Scratch& scratch)
{
  scratch.StandIns.clear();
  this->ForEachLeaf(cell,
    [&](Iterator first, Iterator last)
    {
      const unsigned mark = this->MarkOf(first);
      if (mark & Boundary)
      {
        this->KeepBoundary(first, last, scratch);
      }
      if (!(mark & Boundary) || (mark & KeepsInner))
      {
        scratch.StandIns.push_back(this->FindStandIn(cell, first, last));
      }
    });
  if (scratch.StandIns.size() > 1)
  {
    this->PartPlaces(scratch);
  }
  for (const StandIn& standIn : scratch.StandIns)
  {
    this->WritePoint(standIn, next);
    ++next;
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Each inner point of a leaf with boundary points counts for the nearest of these, unless they become one point.
void CellSimplifier::KeepBoundary(Iterator first, Iterator last, Scratch& scratch)
{
  std::vector<PointId>& kept = scratch.Kept;
  kept.clear();
  const unsigned mark = this->MarkOf(first);
  for (Iterator point = first; point != last; ++point)
  {
    if (this->IsOnBoundary(*point))
    {
      const std::size_t number = std::size_t(this->Result.Target[std::size_t(*point)]);
      this->Result.Plane[number] = this->Plane(*point);
      this->Result.Height[number] = this->Horizon.Height[std::size_t(*point)];
      this->Result.Origin[number].Level = static_cast<unsigned char>(mark & LevelMask);
      kept.push_back(*point);
    }
  }
  if ((mark & KeepsInner) || std::ptrdiff_t(kept.size()) == last - first)
  {
    return;
  }
  // Sorted by x, so that in a large cell only those near in x need a look.
  std::sort(kept.begin(), kept.end(), [this](PointId a, PointId b) { return this->Plane(a) < this->Plane(b); });
  for (Iterator point = first; point != last; ++point)
  {
    if (!this->IsOnBoundary(*point))
    {
      const PointId nearest = this->NearestKept(this->Plane(*point), kept);
      this->Result.Target[std::size_t(*point)] = this->Result.Target[std::size_t(nearest)];
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
PointId CellSimplifier::NearestKept(const PlanePoint& place, const std::vector<PointId>& kept) const
{
  const auto middle = std::lower_bound(
    kept.begin(), kept.end(), place, [this](PointId point, const PlanePoint& p) { return this->Plane(point) < p; });
  PointId best = NoPoint;
  std::int64_t bestDistance = 0;
  // False when all further ones in the same direction are too far away in x alone.
  const auto consider = [&](PointId point)
  {
    const std::int64_t x = std::int64_t(this->Plane(point).X) - place.X;
    if (best != NoPoint && x * x > bestDistance)
    {
      return false;
    }
    const std::int64_t distance = SquaredDistance(this->Plane(point), place);
    if (best == NoPoint || std::make_tuple(distance, point) < std::make_tuple(bestDistance, best))
    {
      best = point;
      bestDistance = distance;
    }
    return true;
  };
  for (auto point = middle; point != kept.end() && consider(*point); ++point)
  {
  }
  for (auto point = middle; point != kept.begin() && consider(*(point - 1)); --point)
  {
  }
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
CellSimplifier::StandIn CellSimplifier::FindStandIn(std::int64_t cell, Iterator first, Iterator last) const
{
  StandIn standIn = this->FindBarycentre(first, last);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::int64_t count = 0;
  for (Iterator point = first; point != last; ++point)
  {
    if (this->IsOnBoundary(*point))
    {
      continue;
    }
    ++count;
    const std::int64_t distance = SquaredDistance(this->Plane(*point), standIn.Place);
    if (distance < least)
    {
      least = distance;
      standIn.Nearest = *point;
    }
  }
  standIn.Averaged = count > 1 && this->Options.Representative == RepresentativeKind::Barycentre &&
    this->IsInside(cell, standIn.Place, standIn.Nearest);
  if (!standIn.Averaged)
  {
    this->UseNearest(standIn);
  }
  return standIn;
}

//----------------------------------------------------------------------------------------------------------------------
CellSimplifier::StandIn CellSimplifier::FindBarycentre(Iterator first, Iterator last) const
{
  std::int64_t count = 0;
  std::int64_t x = 0;
  std::int64_t y = 0;
  double z = 0.0;
  for (Iterator point = first; point != last; ++point)
  {
    if (!this->IsOnBoundary(*point))
    {
      const std::int64_t weight = this->Weight(*point);
      count += weight;
      x += weight * this->Plane(*point).X;
      y += weight * this->Plane(*point).Y;
      z += double(weight) * this->Horizon.Height[std::size_t(*point)];
    }
  }
  count = std::max<std::int64_t>(1, count); // there are such points, or the leaf would not become one
  StandIn standIn;
  standIn.First = first;
  standIn.Last = last;
  standIn.Place = { RoundedQuotient(x, count), RoundedQuotient(y, count) };
  standIn.Height = z / double(count);
  return standIn;
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether a place in the hull of points of one cell and patch is strictly inside the boundary, as the point `inner`
/// among them is: the way from there must cross the boundary of the patch an even number of times.
bool CellSimplifier::IsInside(std::int64_t cell, const PlanePoint& place, PointId inner) const
{
  const PlanePoint& from = this->Plane(inner);
  bool inside = true;
  for (const Edge* edge = this->Edges.begin(cell); edge != this->Edges.end(cell); ++edge)
  {
    if (this->Horizon.Patch[std::size_t(edge->From)] != this->Horizon.Patch[std::size_t(inner)])
    {
      continue;
    }
    const PlanePoint& a = this->Plane(edge->From);
    const PlanePoint& b = this->Plane(edge->To);
    if (place == a || place == b || OnOpenSegment(a, b, place))
    {
      return false;
    }
    inside = inside != Crosses(a, b, from, place);
  }
  return inside;
}

//----------------------------------------------------------------------------------------------------------------------
/// Leaves above each other can have their barycentres in one place. Then all of them use their nearest points, which
/// may in turn be in the place of a barycentre: so until every point is alone.
void CellSimplifier::PartPlaces(Scratch& scratch) const
{
  std::vector<PlanePoint>& places = scratch.Places;
  bool changed = true;
  while (changed)
  {
    changed = false;
    places.clear();
    for (const StandIn& standIn : scratch.StandIns)
    {
      places.push_back(standIn.Place);
    }
    std::sort(places.begin(), places.end());
    for (StandIn& standIn : scratch.StandIns)
    {
      const auto same = std::equal_range(places.begin(), places.end(), standIn.Place);
      if (standIn.Averaged && same.second - same.first > 1)
      {
        this->UseNearest(standIn);
        changed = true;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CellSimplifier::UseNearest(StandIn& standIn) const
{
  standIn.Averaged = false;
  standIn.Place = this->Plane(standIn.Nearest);
  standIn.Height = this->Horizon.Height[std::size_t(standIn.Nearest)];
}

//----------------------------------------------------------------------------------------------------------------------
void CellSimplifier::WritePoint(const StandIn& standIn, PointId number)
{
  const std::size_t target = std::size_t(number);
  this->Result.Source[target] = standIn.Nearest;
  this->Result.Averaged[target] = standIn.Averaged ? 1 : 0;
  this->Result.Plane[target] = standIn.Place;
  this->Result.Height[target] = standIn.Height;
  this->Result.Origin[target].Level = static_cast<unsigned char>(this->MarkOf(standIn.First) & LevelMask);
  this->Result.Origin[target].Kind = standIn.Averaged ? PointKind::Barycentre : PointKind::InputPoint;
  for (Iterator point = standIn.First; point != standIn.Last; ++point)
  {
    if (!this->IsOnBoundary(*point))
    {
      this->Result.Target[std::size_t(*point)] = number;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
SimplificationCell CellSimplifier::DescribeLeaf(
  const Reduction& result, const PointId* first, const PointId* last) const
{
  const unsigned mark = this->MarkOf(first);
  const PlanePoint& place = this->Plane(*first);
  const PlanePoint corner = this->PlaneCells.Corner(this->PlaneCells.CellOf(place));
  std::int64_t x = corner.X;
  std::int64_t y = corner.Y;
  std::int64_t size = this->Side;
  for (unsigned level = 0; level < (mark & LevelMask); ++level)
  {
    size /= 2;
    x += place.X - x >= size ? size : 0;
    y += place.Y - y >= size ? size : 0;
  }
  const double scale = 1.0 / this->Horizon.SubVoxelsPerColumn;
  SimplificationCell leaf;
  leaf.Low = { double(x) * scale, double(y) * scale, 0.0 };
  leaf.Size = double(size) * scale;
  leaf.Origin = result.Origin[std::size_t(result.Target[std::size_t(*first)])];
  leaf.Origin.Kind = (mark & Boundary) ? PointKind::Boundary : leaf.Origin.Kind;
  leaf.Patch = this->Horizon.Patch[std::size_t(*first)];
  leaf.Points = std::int32_t(last - first);
  return leaf;
}
}
