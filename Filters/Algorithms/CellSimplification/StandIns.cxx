// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StandIns.h"

#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <limits>

namespace SeismicHorizons
{
namespace
{
/// The nearest integer; halves go up.
std::int32_t RoundedQuotient(std::int64_t sum, std::int64_t count)
{
  const std::int64_t numerator = 2 * sum + count;
  const std::int64_t quotient = numerator / (2 * count);
  return std::int32_t(numerator % (2 * count) < 0 ? quotient - 1 : quotient);
}

/// Whether the segment between two places that are not on the edge a-b crosses it. An end of the edge that lies on the
/// segment counts as lying to its left. So a loop that the segment only touches in a point is crossed there twice or
/// not at all, and one that it passes through in a point is crossed once.
bool Crosses(const PlanePoint& a, const PlanePoint& b, const PlanePoint& from, const PlanePoint& to)
{
  return (SignedArea(from, to, a) >= 0) != (SignedArea(from, to, b) >= 0) &&
    (SignedArea(a, b, from) > 0) != (SignedArea(a, b, to) > 0);
}
}

//----------------------------------------------------------------------------------------------------------------------
StandInFinder::StandInFinder(const CellLeaves& leaves, RepresentativeKind representative)
  : Leaves(leaves)
  , Edges(SortByCell(leaves.Grid(), leaves.Horizon().Plane, leaves.Horizon().Boundary))
  , Representative(representative)
{
}

//----------------------------------------------------------------------------------------------------------------------
StandIn StandInFinder::Find(std::int64_t cell, const PointId* first, const PointId* last) const
{
  StandIn standIn = this->FindBarycentre(first, last);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::int64_t count = 0;
  for (const PointId* point = first; point != last; ++point)
  {
    if (this->Leaves.IsOnBoundary(*point))
    {
      continue;
    }
    ++count;
    const std::int64_t distance = SquaredDistance(this->Leaves.Plane(*point), standIn.Plane);
    if (distance < least)
    {
      least = distance;
      standIn.Nearest = *point;
    }
  }
  standIn.Averaged = count > 1 && this->Representative == RepresentativeKind::Barycentre &&
    this->IsInside(cell, standIn.Plane, standIn.Nearest);
  if (!standIn.Averaged)
  {
    this->UseNearest(standIn);
  }
  return standIn;
}

//----------------------------------------------------------------------------------------------------------------------
StandIn StandInFinder::FindBarycentre(const PointId* first, const PointId* last) const
{
  std::int64_t count = 0;
  std::int64_t x = 0;
  std::int64_t y = 0;
  double z = 0.0;
  for (const PointId* point = first; point != last; ++point)
  {
    if (!this->Leaves.IsOnBoundary(*point))
    {
      const std::int64_t weight = this->Leaves.Weight(*point);
      count += weight;
      x += weight * this->Leaves.Plane(*point).X;
      y += weight * this->Leaves.Plane(*point).Y;
      z += double(weight) * this->Leaves.Height(*point);
    }
  }
  StandIn standIn;
  standIn.First = first;
  standIn.Last = last;
  standIn.Plane = { RoundedQuotient(x, count), RoundedQuotient(y, count) };
  standIn.Height = z / double(count);
  return standIn;
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether a place in the hull of points of one cell and patch is strictly inside the boundary, as the point `inner`
/// among them is: the segment between the two must cross the boundary of the patch an even number of times, and with
/// cuts not at all, as it may cross both lips of a crack.
bool StandInFinder::IsInside(std::int64_t cell, const PlanePoint& place, PointId inner) const
{
  const PlanePoint& from = this->Leaves.Plane(inner);
  bool inside = true;
  for (const Edge* edge = this->Edges.begin(cell); edge != this->Edges.end(cell); ++edge)
  {
    if (this->Leaves.Patch(edge->From) != this->Leaves.Patch(inner))
    {
      continue;
    }
    const PlanePoint& a = this->Leaves.Plane(edge->From);
    const PlanePoint& b = this->Leaves.Plane(edge->To);
    if (place == a || place == b || OnOpenSegment(a, b, place))
    {
      return false;
    }
    const bool crosses = Crosses(a, b, from, place);
    if (crosses && this->Leaves.HasCuts())
    {
      return false;
    }
    inside = inside != crosses;
  }
  return inside;
}

//----------------------------------------------------------------------------------------------------------------------
/// Leaves above each other can have their barycentres in one place. Then all of them use their nearest points. These
/// may in turn be in the place of another barycentre, so that the search goes on until nothing changes.
void StandInFinder::SeparatePlaces(std::vector<StandIn>& standIns, std::vector<PlanePoint>& places) const
{
  bool changed = standIns.size() > 1;
  while (changed)
  {
    changed = false;
    places.clear();
    for (const StandIn& standIn : standIns)
    {
      places.push_back(standIn.Plane);
    }
    std::sort(places.begin(), places.end());
    for (StandIn& standIn : standIns)
    {
      const auto same = std::equal_range(places.begin(), places.end(), standIn.Plane);
      if (standIn.Averaged && same.second - same.first > 1)
      {
        this->UseNearest(standIn);
        changed = true;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void StandInFinder::UseNearest(StandIn& standIn) const
{
  standIn.Averaged = false;
  standIn.Plane = this->Leaves.Plane(standIn.Nearest);
  standIn.Height = this->Leaves.Height(standIn.Nearest);
}
}
