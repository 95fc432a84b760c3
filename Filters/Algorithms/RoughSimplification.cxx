// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: number the kept boundary points; sort all points by cell; note which boundary edges cross which cells;
// then visit the cells row by row and, within a cell, its groups: the points of one patch in one cell.

#include "RoughSimplification.h"

#include "CellGrid.h"
#include "Predicates.h"

#include <algorithm>
#include <sstream>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
std::int64_t SquaredDistance(const PlanePoint& a, const PlanePoint& b)
{
  const std::int64_t x = std::int64_t(a.X) - b.X;
  const std::int64_t y = std::int64_t(a.Y) - b.Y;
  return x * x + y * y;
}

/// The nearest integer; halves go up.
std::int32_t RoundedQuotient(std::int64_t sum, std::int64_t count)
{
  const std::int64_t numerator = 2 * sum + count;
  const std::int64_t quotient = numerator / (2 * count);
  return std::int32_t(numerator % (2 * count) < 0 ? quotient - 1 : quotient);
}

struct Barycentre
{
  PlanePoint Place;
  double Height = 0.0;
};

class CellSimplifier
{
public:
  CellSimplifier(const BoundedHorizon& horizon, int cellSize)
    : Horizon(horizon)
    , Grid(horizon.Plane, horizon.SubVoxelsPerColumn, std::int64_t(cellSize) * horizon.SubVoxelsPerColumn)
    , Points(SortByCell(this->Grid, horizon.Plane))
    , Hops(SortByCell(this->Grid, horizon.Plane, horizon.Boundary))
    , OnBoundary(horizon.Plane.size(), false)
  {
    this->Result.Target.assign(horizon.Plane.size(), NoPoint);
  }

  Reduction Run(const Monitor& monitor)
  {
    this->KeepBoundary();
    const std::int64_t cells = this->Grid.Size();
    for (std::int64_t cell = 0; cell < cells; ++cell)
    {
      if (cell % 65536 == 0)
      {
        monitor.Progress(double(cell) / double(cells));
      }
      this->SimplifyCell(cell);
    }
    return std::move(this->Result);
  }

private:
  void KeepBoundary()
  {
    const Loops& boundary = this->Horizon.Boundary;
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      std::for_each(boundary.begin(loop), boundary.end(loop),
        [this](PointId point) { this->OnBoundary[std::size_t(point)] = true; });
    }
    for (std::size_t point = 0; point < this->OnBoundary.size(); ++point)
    {
      if (this->OnBoundary[point])
      {
        this->Result.Target[point] = this->AddInputPoint(PointId(point));
      }
    }
    this->Result.Boundary = boundary.Renumbered(this->Result.Target);
  }

  void SimplifyCell(std::int64_t cell)
  {
    const auto patchOf = [this](PointId point) { return this->Horizon.Patch[std::size_t(point)]; };
    const auto samePatch = [&](PointId a, PointId b) { return patchOf(a) == patchOf(b); };
    this->Cell.assign(this->Points.begin(cell), this->Points.end(cell));
    const auto differs = [&](PointId a, PointId b) { return !samePatch(a, b); };
    if (std::adjacent_find(this->Cell.begin(), this->Cell.end(), differs) != this->Cell.end())
    {
      std::sort(this->Cell.begin(), this->Cell.end(),
        [&](PointId a, PointId b) { return std::make_tuple(patchOf(a), a) < std::make_tuple(patchOf(b), b); });
    }
    for (auto first = this->Cell.cbegin(); first != this->Cell.cend();)
    {
      const auto last = std::find_if(first, this->Cell.cend(), [&](PointId point) { return differs(*first, point); });
      this->SimplifyGroup(cell, first, last);
      first = last;
    }
  }

  using Iterator = std::vector<PointId>::const_iterator;

  void SimplifyGroup(std::int64_t cell, Iterator first, Iterator last)
  {
    this->Kept.clear();
    std::copy_if(first, last, std::back_inserter(this->Kept),
      [this](PointId point) { return this->OnBoundary[std::size_t(point)]; });
    if (this->Kept.empty())
    {
      this->MergeGroup(cell, first, last);
    }
    else if (std::distance(first, last) > std::ptrdiff_t(this->Kept.size()))
    {
      this->DropInnerPoints(first, last);
    }
  }

  /// Each inner point of a group with boundary points counts for the nearest of these. They are sorted by x, so that
  /// in a large cell only those near in x need a look.
  void DropInnerPoints(Iterator first, Iterator last)
  {
    std::sort(
      this->Kept.begin(), this->Kept.end(), [this](PointId a, PointId b) { return this->Plane(a) < this->Plane(b); });
    for (auto point = first; point != last; ++point)
    {
      if (!this->OnBoundary[std::size_t(*point)])
      {
        const PointId kept = this->NearestKept(this->Plane(*point));
        this->Result.Target[std::size_t(*point)] = this->Result.Target[std::size_t(kept)];
      }
    }
  }

  PointId NearestKept(const PlanePoint& place) const
  {
    const auto middle = std::lower_bound(this->Kept.begin(), this->Kept.end(), place,
      [this](PointId kept, const PlanePoint& p) { return this->Plane(kept) < p; });
    PointId best = NoPoint;
    std::int64_t bestDistance = 0;
    // False when all further ones in the same direction are too far away in x alone.
    const auto consider = [&](PointId kept)
    {
      const std::int64_t x = std::int64_t(this->Plane(kept).X) - place.X;
      if (best != NoPoint && x * x > bestDistance)
      {
        return false;
      }
      const std::int64_t distance = SquaredDistance(this->Plane(kept), place);
      if (best == NoPoint || std::make_tuple(distance, kept) < std::make_tuple(bestDistance, best))
      {
        best = kept;
        bestDistance = distance;
      }
      return true;
    };
    for (auto kept = middle; kept != this->Kept.end() && consider(*kept); ++kept)
    {
    }
    for (auto kept = middle; kept != this->Kept.begin() && consider(*(kept - 1)); --kept)
    {
    }
    return best;
  }

  void MergeGroup(std::int64_t cell, Iterator first, Iterator last)
  {
    const Barycentre barycentre = this->FindBarycentre(first, last);
    const PointId nearest = *std::min_element(first, last,
      [&](PointId a, PointId b) {
        return SquaredDistance(this->Plane(a), barycentre.Place) < SquaredDistance(this->Plane(b), barycentre.Place);
      });
    const bool average = std::distance(first, last) > 1 && this->IsInside(cell, barycentre.Place, nearest);
    const PointId target = average ? this->AddPoint(nearest, barycentre, true) : this->AddInputPoint(nearest);
    std::for_each(first, last, [&](PointId point) { this->Result.Target[std::size_t(point)] = target; });
  }

  Barycentre FindBarycentre(Iterator first, Iterator last) const
  {
    std::int64_t count = 0;
    std::int64_t x = 0;
    std::int64_t y = 0;
    double z = 0.0;
    for (auto point = first; point != last; ++point)
    {
      const std::int64_t weight = this->Horizon.Count[std::size_t(*point)];
      count += weight;
      x += weight * this->Plane(*point).X;
      y += weight * this->Plane(*point).Y;
      z += double(weight) * this->Horizon.Height[std::size_t(*point)];
    }
    return { { RoundedQuotient(x, count), RoundedQuotient(y, count) }, z / double(count) };
  }

  /// Whether a place in the hull of a group without boundary points is strictly inside the boundary, as the group's
  /// point `inner` is: the way from there must cross the boundary of the patch an even number of times. No end of
  /// these edges is in the cell, so the way can not run through one.
  bool IsInside(std::int64_t cell, const PlanePoint& place, PointId inner) const
  {
    const PlanePoint& from = this->Plane(inner);
    bool inside = true;
    for (const Hop* hop = this->Hops.begin(cell); hop != this->Hops.end(cell); ++hop)
    {
      if (this->Horizon.Patch[std::size_t(hop->From)] != this->Horizon.Patch[std::size_t(inner)])
      {
        continue;
      }
      const PlanePoint& a = this->Plane(hop->From);
      const PlanePoint& b = this->Plane(hop->To);
      if (OnOpenSegment(a, b, place))
      {
        return false;
      }
      inside = inside != ProperlyCross(a, b, from, place);
    }
    return inside;
  }

  PointId AddInputPoint(PointId point)
  {
    return this->AddPoint(point, { this->Plane(point), this->Horizon.Height[std::size_t(point)] }, false);
  }

  PointId AddPoint(PointId source, const Barycentre& place, bool averaged)
  {
    this->Result.Source.push_back(source);
    this->Result.Averaged.push_back(averaged);
    this->Result.Plane.push_back(place.Place);
    this->Result.Height.push_back(place.Height);
    return PointId(this->Result.Source.size() - 1);
  }

  const PlanePoint& Plane(PointId point) const { return this->Horizon.Plane[std::size_t(point)]; }

  const BoundedHorizon& Horizon;
  const CellGrid Grid;
  const PointLists Points;
  const HopLists Hops;
  std::vector<bool> OnBoundary;
  Reduction Result;
  std::vector<PointId> Cell; // the points of the cell at hand, patch by patch
  std::vector<PointId> Kept; // the boundary points of the group at hand
};
}

//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyRough(const BoundedHorizon& horizon, int cellSize, const Monitor& monitor)
{
  if (cellSize < 1)
  {
    std::ostringstream text;
    text << "cell size " << cellSize << ", expected at least 1 column";
    throw InputError(text.str());
  }
  return CellSimplifier(horizon, cellSize).Run(monitor);
}
}
