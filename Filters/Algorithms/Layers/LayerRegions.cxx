// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerRegions.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/SpacePoints.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// ---- Outlines -------------------------------------------------------------------------------------------------------
// The outlines of a stack with the fewest points for which all horizons are within the error along them.

/// Loops are simplified for the first horizon. Edges too far from another one keep its farthest point, until none is.
class OutlineMaker
{
public:
  OutlineMaker(PlanePoints columns, const HeightStack& heights, const std::vector<std::vector<unsigned char>>& known,
    const std::vector<HorizonView>& horizons, const std::vector<ColumnIndex>& indices,
    BoundarySimplificationOptions options)
    : Columns(columns)
    , Heights(heights)
    , Known(known)
    , Horizons(horizons)
    , Indices(indices)
    , Options(std::move(options))
  {
    if (this->Options.OutlineTolerance > 0.0) // without a tolerance outlines pass over no other columns
    {
      this->Index.emplace(columns);
    }
  }

  LayerOutline Run(const ExteriorBoundary& boundary, const Monitor& monitor)
  {
    const std::vector<PointId> ends = boundary.OpenCracks.PointsOfOpenEnds();
    this->Options.Fixed.insert(this->Options.Fixed.end(), ends.begin(), ends.end());
    BoundarySimplification simplified;
    const SpacePoints points(this->Columns, this->Heights.front(), 1);
    std::vector<PointId> far;
    Monitor step = monitor;
    do
    {
      this->Options.Fixed.insert(this->Options.Fixed.end(), far.begin(), far.end());
      simplified = SimplifyBoundary(points, boundary.Boundary, this->Options, step);
      step = monitor.Step(1.0, 1.0);
      far = this->FindFar(boundary.Boundary, simplified.Boundary);
    } while (!far.empty());
    LayerOutline outline;
    outline.Boundary = std::move(simplified.Boundary);
    outline.Patch = boundary.Patch;
    for (const DroppedPoint& dropped : simplified.Dropped)
    {
      outline.Patch[std::size_t(dropped.Point)] = NoPatch;
    }
    return outline;
  }

private:
  std::vector<PointId> FindFar(const Loops& loops, const Loops& simplified) const
  {
    std::vector<PointId> far;
    ForEachChain(loops, simplified, this->Columns.size(),
      [&](const std::vector<PointId>& chain)
      {
        const auto at = [&chain](std::size_t n) { return chain[n]; };
        std::size_t farthest = this->FindFarthest(at, 0, chain.size() - 1);
        farthest = farthest == 0 ? this->FindBesidePassed(at, 0, chain.size() - 1) : farthest;
        if (farthest != 0)
        {
          far.push_back(at(farthest));
        }
      });
    return far;
  }

  /// The point between two kept ones at which a horizon is farthest from the edge, if too far, or `from`.
  template <typename PointAt>
  std::size_t FindFarthest(const PointAt& at, std::size_t from, std::size_t to) const
  {
    std::size_t farthest = from;
    double largest = this->Options.DistanceThreshold + this->Slack();
    for (std::size_t n = from + 1; n < to; ++n)
    {
      for (std::size_t horizon = 1; horizon < this->Heights.size(); ++horizon)
      {
        const bool counts = this->Known.empty() || this->Known[horizon][std::size_t(at(n))] != 0;
        const double distance = counts ? this->DistanceFrom(at(from), at(to), at(n), this->Heights[horizon]) : 0.0;
        farthest = distance > largest ? n : farthest;
        largest = std::max(largest, distance);
      }
    }
    return farthest;
  }

  /// The point half-way if the edge is too far from points that the stack does not have, or `from`.
  template <typename PointAt>
  std::size_t FindBesidePassed(const PointAt& at, std::size_t from, std::size_t to) const
  {
    const PlanePoint& a = this->Columns[std::size_t(at(from))];
    const PlanePoint& b = this->Columns[std::size_t(at(to))];
    bool isFar = false;
    const auto look = [&](const PlanePoint& place, double part)
    {
      const bool isOther = this->Index->PointAt(place) == NoPoint;
      for (std::size_t horizon = 0; isOther && horizon < this->Indices.size(); ++horizon)
      {
        const double start = this->Heights[horizon][std::size_t(at(from))];
        const double end = this->Heights[horizon][std::size_t(at(to))];
        const double distance = std::abs(start + (end - start) * part - this->HeightAt(horizon, place));
        isFar = isFar || distance > this->Options.DistanceThreshold + this->Slack();
      }
    };
    if (to > from + 1 && this->Index)
    {
      ForEachColumnBetween(a, b, look);
    }
    return isFar ? from + (to - from) / 2 : from;
  }

  double HeightAt(std::size_t horizon, const PlanePoint& column) const
  {
    const PointId point = this->Indices[horizon].PointAt(column);
    return point == NoPoint ? std::nan("") : this->Horizons[horizon].Heights[point];
  }

  double DistanceFrom(PointId from, PointId to, PointId point, const std::vector<double>& heights) const
  {
    const PlanePoint& a = this->Columns[std::size_t(from)];
    const PlanePoint& b = this->Columns[std::size_t(to)];
    const auto length = double(SquaredDistance(a, b));
    const auto along = double(ScalarProduct(a, b, this->Columns[std::size_t(point)]));
    const double part = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    const double start = heights[std::size_t(from)];
    return std::abs(start + part * (heights[std::size_t(to)] - start) - heights[std::size_t(point)]);
  }

  double Slack() const { return 1e-9 * std::max(1.0, this->Options.DistanceThreshold); }

  PlanePoints Columns;
  const HeightStack& Heights;
  const std::vector<std::vector<unsigned char>>& Known;
  const std::vector<HorizonView>& Horizons;
  std::optional<ColumnIndex> Index; // of the columns of the stack
  const std::vector<ColumnIndex>& Indices; // of the columns of the horizons
  BoundarySimplificationOptions Options;
};

// ---- Parts of blocks ------------------------------------------------------------------------------------------------
int DiagonalOf(int corners)
{
  return (corners & 9) == 9 ? 9 : 6;
}

int CountCorners(int corners)
{
  return (corners & 1) + (corners >> 1 & 1) + (corners >> 2 & 1) + (corners >> 3 & 1);
}

bool HasBoth(int corners, int two)
{
  return (corners & two) == two;
}

std::int64_t FloorOfThird(std::int64_t sum)
{
  return sum >= 0 ? sum / 3 : -((2 - sum) / 3);
}
}

//----------------------------------------------------------------------------------------------------------------------
LayerOutline SimplifyOutline(PlanePoints columns, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const std::vector<HorizonView>& horizons,
  const std::vector<ColumnIndex>& indices, const ExteriorBoundary& boundary, BoundarySimplificationOptions options,
  const Monitor& monitor)
{
  assert(HaveAll(heights, columns.size()) && indices.size() == horizons.size());
  assert(known.empty() || known.size() == heights.size());
  assert(options.Method == OutlineMethod::FewestPoints);
  return OutlineMaker(columns, heights, known, horizons, indices, std::move(options)).Run(boundary, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
LayerRegions::LayerRegions(
  PlanePoints columns, const std::vector<std::vector<unsigned char>>& isIn, const LinkCuts* cuts)
  : Index(columns)
  , Columns(columns)
  , IsIn(isIn)
  , Cuts(cuts)
{
  const PlaneBox box(columns);
  this->FirstX = std::int64_t(box.Least.X) - 1;
  this->FirstY = std::int64_t(box.Least.Y) - 1;
}

//----------------------------------------------------------------------------------------------------------------------
PointId LayerRegions::PointAt(std::int64_t x, std::int64_t y) const
{
  return this->Index.PointAt({ std::int32_t(x), std::int32_t(y) });
}

//----------------------------------------------------------------------------------------------------------------------
// The bits of the corners of a block that have a layer.
int LayerRegions::PresentCorners(std::size_t layer, std::int64_t x, std::int64_t y) const
{
  int corners = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const PointId point = this->PointAt(x + (corner & 1), y + (corner >> 1));
    corners |= point != NoPoint && this->IsIn[layer][std::size_t(point)] != 0 ? 1 << corner : 0;
  }
  return corners;
}

//----------------------------------------------------------------------------------------------------------------------
// The part of a block with these corners that cuts leave: all of it, the half where one corner is cut off, or none.
int LayerRegions::OpenPartOf(std::int64_t x, std::int64_t y, int corners) const
{
  if (!this->Cuts)
  {
    return corners;
  }
  const PlanePoint least = { std::int32_t(x), std::int32_t(y) };
  const bool bottom = this->Cuts->IsCutEast(least);
  const bool left = this->Cuts->IsCutNorth(least);
  const bool top = this->Cuts->IsCutEast({ least.X, least.Y + 1 });
  const bool right = this->Cuts->IsCutNorth({ least.X + 1, least.Y });
  if (!bottom && !left && !top && !right)
  {
    return corners;
  }
  if (bottom == top || left == right)
  {
    return 0;
  }
  const int others = All - (1 << ((right ? 1 : 0) + (top ? 2 : 0)));
  return HasBoth(corners, others) ? others : 0;
}

//----------------------------------------------------------------------------------------------------------------------
int LayerRegions::PartOf(std::size_t layer, std::int64_t x, std::int64_t y) const
{
  const int corners = this->PresentCorners(layer, x, y);
  const int open = this->OpenPartOf(x, y, All);
  if (open != All)
  {
    return HasBoth(corners, open) ? open : 0;
  }
  if (CountCorners(corners) != 3)
  {
    return corners == All ? All : 0;
  }
  for (std::size_t before = 0; before < layer; ++before)
  {
    const int others = this->PresentCorners(before, x, y);
    if (CountCorners(others) == 3)
    {
      return DiagonalOf(others) == DiagonalOf(corners) ? corners : 0;
    }
  }
  return corners;
}

//----------------------------------------------------------------------------------------------------------------------
int LayerRegions::PartOfAll(std::int64_t x, std::int64_t y) const
{
  int corners = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    corners |= this->PointAt(x + (corner & 1), y + (corner >> 1)) != NoPoint ? 1 << corner : 0;
  }
  return this->OpenPartOf(x, y, CountCorners(corners) >= 3 ? corners : 0);
}

//----------------------------------------------------------------------------------------------------------------------
bool LayerRegions::HasArea(std::size_t layer, PointId point) const
{
  assert(layer < this->IsIn.size());
  const PlanePoint& column = this->Columns[std::size_t(point)];
  for (int corner = 0; corner < 4; ++corner)
  {
    const int part = this->PartOf(layer, std::int64_t(column.X) - (corner & 1), std::int64_t(column.Y) - (corner >> 1));
    if ((part >> corner & 1) != 0)
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// The part with the centre of the triangle has all of it. If the centre is on a side of the part, no border is there.
bool LayerRegions::Holds(std::size_t layer, const std::array<PlanePoint, 3>& corners) const
{
  assert(layer < this->IsIn.size());
  const std::int64_t sumX = std::int64_t(corners[0].X) + corners[1].X + corners[2].X;
  const std::int64_t sumY = std::int64_t(corners[0].Y) + corners[1].Y + corners[2].Y;
  const std::int64_t x = FloorOfThird(sumX);
  const std::int64_t y = FloorOfThird(sumY);
  const std::int64_t restX = sumX - 3 * x;
  const std::int64_t restY = sumY - 3 * y;
  switch (this->PartOf(layer, x, y))
  {
    case All:
      return true;
    case All - 1:
      return restX + restY >= 3;
    case All - 2:
      return restY >= restX;
    case All - 4:
      return restX >= restY;
    case All - 8:
      return restX + restY <= 3;
    default:
      return false;
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Calls visit(from, to) for the borders of layers, not of all columns together, in the block to the north-east of a
// column and on its first sides.
template <typename Visitor>
void LayerRegions::ForEachBorderLink(const PlanePoint& column, Visitor&& visit) const
{
  const std::int64_t x = column.X;
  const std::int64_t y = column.Y;
  const auto at = [&](int corner) { return this->PointAt(x + (corner & 1), y + (corner >> 1)); };
  const auto isBorder = [](int one, int ofOne, int other, int ofOther)
  { return HasBoth(one, ofOne) != HasBoth(other, ofOther); };
  const int all = this->PartOfAll(x, y);
  const bool isEastInside = HasBoth(all, 3) && HasBoth(this->PartOfAll(x, y - 1), 12);
  const bool isNorthInside = HasBoth(all, 5) && HasBoth(this->PartOfAll(x - 1, y), 10);
  bool isEast = false;
  bool isNorth = false;
  int diagonal = 0;
  for (std::size_t layer = 0; layer < this->IsIn.size(); ++layer)
  {
    const int part = this->PartOf(layer, x, y);
    isEast = isEast || (isEastInside && isBorder(part, 3, this->PartOf(layer, x, y - 1), 12));
    isNorth = isNorth || (isNorthInside && isBorder(part, 5, this->PartOf(layer, x - 1, y), 10));
    diagonal = all == All && CountCorners(part) == 3 ? DiagonalOf(part) : diagonal;
  }
  if (isEast)
  {
    visit(at(0), at(1));
  }
  if (isNorth)
  {
    visit(at(0), at(2));
  }
  if (diagonal != 0)
  {
    visit(diagonal == 9 ? at(0) : at(1), diagonal == 9 ? at(3) : at(2));
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Edge> LayerRegions::FindBorders(const std::vector<unsigned char>& isOnLoop) const
{
  std::vector<std::pair<PointId, PointId>> links; // both ways
  const auto add = [&links](PointId from, PointId to)
  {
    links.emplace_back(from, to);
    links.emplace_back(to, from);
  };
  for (std::int64_t y = this->FirstY; y < this->FirstY + this->Index.Height(); ++y)
  {
    for (std::int64_t x = this->FirstX; x < this->FirstX + this->Index.Width(); ++x)
    {
      this->ForEachBorderLink({ std::int32_t(x), std::int32_t(y) }, add);
    }
  }
  std::sort(links.begin(), links.end());
  const auto linksOf = [&links](PointId point)
  { return std::lower_bound(links.begin(), links.end(), std::pair<PointId, PointId>(point, 0)); };
  // The next point where a line continues in the same direction and no other line is, else NoPoint.
  const auto next = [&](PointId before, PointId point)
  {
    const auto first = linksOf(point);
    const bool areTwo =
      links.end() - first >= 2 && first[1].first == point && (links.end() - first == 2 || first[2].first != point);
    if (!areTwo || isOnLoop[std::size_t(point)] != 0)
    {
      return NoPoint;
    }
    const PointId other = first[0].second == before ? first[1].second : first[0].second;
    const PlanePoint &a = this->Columns[before], &b = this->Columns[point], &c = this->Columns[other];
    return c.X - b.X == b.X - a.X && c.Y - b.Y == b.Y - a.Y ? other : NoPoint;
  };
  std::vector<Edge> borders;
  for (const auto& [from, second] : links)
  {
    if (next(second, from) != NoPoint)
    {
      continue; // amid a line
    }
    PointId before = from;
    PointId to = second;
    for (PointId on = next(before, to); on != NoPoint; on = next(before, to))
    {
      before = to;
      to = on;
    }
    if (from < to)
    {
      borders.push_back({ from, to });
    }
  }
  return borders;
}
}
