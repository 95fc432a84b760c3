// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: ShortcutGuard, which prevents loops from crossing; ShortcutCone, which excludes most starts of an
// edge; the best path along a chain, node by node.

#include "FewestPoints.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/Predicates.h"

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t NoPosition = 0; // not between the ends of the chain

std::int64_t FloorOfQuotient(std::int64_t numerator, std::int64_t denominator)
{
  assert(denominator > 0);
  const std::int64_t quotient = numerator / denominator;
  return quotient - std::int64_t(numerator % denominator < 0);
}

// A crossing is a number that sorts by row, then x: 31 bits of the row, 32 of x, 1 of the direction.
constexpr std::int64_t Offset = std::int64_t(1) << 30;
constexpr int PlaceBits = 32;

std::int64_t RowOf(std::uint64_t crossing)
{
  return std::int64_t(crossing >> (PlaceBits + 1)) - Offset;
}

/// A place is the sum of the integers on either side of x, 2 x for an integer. The order of crossings without an
/// integer between them has no effect.
std::int64_t PlaceOf(std::uint64_t crossing)
{
  return std::int64_t(crossing >> 1 & ((std::uint64_t(1) << PlaceBits) - 1)) - 2 * Offset;
}

bool IsUpward(std::uint64_t crossing)
{
  return (crossing & 1) != 0;
}

/// Returns 1 if the edge crosses the row of the column upwards to its right, -1 if downwards, and 0 otherwise. An edge
/// includes its lower end, but not its upper end.
int CrossingOf(const PlanePoint& from, const PlanePoint& to, const PlanePoint& column)
{
  const bool isUpward = from.Y <= column.Y && to.Y > column.Y;
  const bool isDownward = to.Y <= column.Y && from.Y > column.Y;
  if (!isUpward && !isDownward)
  {
    return 0;
  }
  const std::int64_t side = isUpward ? SignedArea(from, to, column) : SignedArea(to, from, column);
  return side <= 0 ? 0 : isUpward ? 1 : -1;
}

// Edges from a point that pass points within a tolerance lie in a wedge of directions in plan (Imai and Iri 1988; Chan
// and Chin 1996) and a range of slopes. The cone is conservative: edges inside may still exceed the tolerances.
//
//             .  |  .
//           _____o_____      An edge passes o within the tolerance if its direction lies between the tangents of the
//          .    /|\    .     circle around o. Its point nearest to o is at most as far from the start x as o, and closer
//          .   / | \   .     by the tolerance at most, which bounds the slope.
//             . \|/
//                x
class ShortcutCone
{
public:
  ShortcutCone(double outlineTolerance, double heightTolerance)
    : Radius(outlineTolerance + PlanSlack)
    , HeightTolerance(heightTolerance)
  {
  }

  bool IsEmpty() const { return this->HasNoDirection || this->LeastSlope > this->GreatestSlope; }

  /// Returns whether an edge can lead to the end of `way`, and excludes edges that pass this end outside the
  /// tolerances.
  bool Pass(const Eigen::Vector3d& way)
  {
    const double length = way.head<2>().norm();
    const double slack = HeightSlack * std::abs(way.z());
    const bool hasDirection = this->IsWhole || IsBetween(this->Right, this->Left, way.head<2>());
    const bool hasSlope =
      way.z() + slack >= this->LeastSlope * length && way.z() - slack <= this->GreatestSlope * length;
    if (length > this->Radius)
    {
      this->NarrowDirections(way.head<2>(), std::sqrt(length * length - this->Radius * this->Radius));
    }
    const double nearest = std::max(0.0, length - this->Radius);
    const double tolerance = this->HeightTolerance + slack;
    this->LeastSlope = std::max(this->LeastSlope, -GreatestOf(tolerance - way.z(), nearest, length));
    this->GreatestSlope = std::min(this->GreatestSlope, GreatestOf(tolerance + way.z(), nearest, length));
    return hasDirection && hasSlope;
  }

private:
  // These exceed rounding by far for coordinates below 2^29, and have no practical effect. The second is relative to
  // the height.
  static constexpr double PlanSlack = 1e-6;
  static constexpr double HeightSlack = 1e-9;

  static double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

  static bool IsBetween(const Eigen::Vector2d& right, const Eigen::Vector2d& left, const Eigen::Vector2d& direction)
  {
    return Cross(right, direction) >= 0.0 && Cross(direction, left) >= 0.0;
  }

  /// Returns the greatest slope that rises by at most `height` within these distances.
  static double GreatestOf(double height, double nearest, double farthest)
  {
    const double distance = height >= 0.0 ? nearest : farthest;
    return distance > 0.0 ? height / distance : std::copysign(std::numeric_limits<double>::infinity(), height);
  }

  void NarrowDirections(const Eigen::Vector2d& way, double tangent)
  {
    const Eigen::Vector2d aside = this->Radius * Eigen::Vector2d(-way.y(), way.x());
    const Eigen::Vector2d right = tangent * way - aside;
    const Eigen::Vector2d left = tangent * way + aside;
    const double rightToRight = Cross(this->Right, right);
    const double rightToLeft = Cross(this->Right, left);
    const double leftToRight = Cross(right, this->Left);
    const double leftToLeft = Cross(left, this->Left);
    const bool hasRight = this->IsWhole || (rightToRight >= 0.0 && leftToRight >= 0.0);
    const bool hasLeft = this->IsWhole || (rightToLeft >= 0.0 && leftToLeft >= 0.0);
    const bool keepsRight = rightToRight <= 0.0 && rightToLeft >= 0.0;
    const bool keepsLeft = leftToRight >= 0.0 && leftToLeft <= 0.0;
    this->HasNoDirection = !(hasRight || keepsRight) || !(hasLeft || keepsLeft);
    this->Right = hasRight ? right : this->Right;
    this->Left = hasLeft ? left : this->Left;
    this->IsWhole = false;
  }

  double Radius;
  double HeightTolerance;
  bool IsWhole = true;
  bool HasNoDirection = false;
  Eigen::Vector2d Right{ 0.0, 0.0 };
  Eigen::Vector2d Left{ 0.0, 0.0 };
  double LeastSlope = -std::numeric_limits<double>::infinity();
  double GreatestSlope = std::numeric_limits<double>::infinity();
};

// Outlines of real horizons rarely have edges that span more points, and time grows with this number where they are
// straight.
constexpr std::size_t LookBack = 512;

constexpr std::size_t MostBars = 8; // blocking columns
constexpr std::size_t ReachOfBar = 2 * LookBack;

constexpr std::size_t RunEnd = 32;

constexpr std::size_t NodesPerBatch = 1024;
constexpr std::int64_t NodesPerTask = 128;
constexpr std::int64_t PointsPerCopy = 512;

constexpr std::size_t NoWay = std::numeric_limits<std::size_t>::max() / 2;

KeptOfChains::key_type KeyOfChain(const std::vector<PointId>& chain)
{
  return { chain.front(), chain[chain.size() > 1 ? 1 : 0], chain.size() };
}
}

//----------------------------------------------------------------------------------------------------------------------
ShortcutGuard::ShortcutGuard(const ColumnIndex& index, const std::vector<unsigned char>& isOnLoop)
  : Index(index)
  , Columns(index.Columns())
{
  PlaceSet onLoops(index.Width(), index.Height());
  const auto places = CollectChunks<std::int64_t>(std::int64_t(isOnLoop.size()), ChunkSize, Monitor(),
    [&](std::vector<std::int64_t>& found, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        if (isOnLoop[point] != 0)
        {
          found.push_back(index.Place(this->Columns[point]));
        }
      }
    });
  std::for_each(places.begin(), places.end(), [&onLoops](std::int64_t place) { onLoops.Add(place); });
  for (std::int64_t place = 0; place < this->Index.NumberOfPlaces(); place += PlaceSet::WordBits)
  {
    this->OnLoops->Append(std::uint64_t(onLoops.From(place)));
  }
  this->Position.assign(this->OnLoops->Size(), NoPosition);
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t& ShortcutGuard::PositionOf(PointId point)
{
  return this->Position[(*this->OnLoops)[this->Index.Place(this->Columns[point])]];
}

//----------------------------------------------------------------------------------------------------------------------
void ShortcutGuard::SetChain(const std::vector<PointId>& chain)
{
  for (const PointId point : this->Chain)
  {
    this->PositionOf(point) = NoPosition;
  }
  this->Chain = chain;
  this->Bars.clear();
  for (std::size_t position = 1; position + 1 < chain.size(); ++position)
  {
    this->PositionOf(chain[position]) = position;
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsClear(std::size_t from, std::size_t to)
{
  this->From = from;
  this->To = to;
  const PlanePoint first = this->ColumnAt(from);
  const PlanePoint last = this->ColumnAt(to);
  if (!this->IsClearAlong(first, last))
  {
    return false;
  }
  this->Crossings.clear();
  for (std::size_t position = from; position < to; ++position)
  {
    this->AddCrossings(this->ColumnAt(position), this->ColumnAt(position + 1));
  }
  this->AddCrossings(last, first);
  return this->IsClearBetween();
}

//----------------------------------------------------------------------------------------------------------------------
void ShortcutGuard::AddCrossings(const PlanePoint& from, const PlanePoint& to)
{
  const bool isUpward = from.Y < to.Y;
  const PlanePoint& low = isUpward ? from : to;
  const PlanePoint& high = isUpward ? to : from;
  const std::int64_t height = std::int64_t(high.Y) - low.Y;
  const std::int64_t width = std::int64_t(high.X) - low.X;
  for (std::int64_t row = 0; row < height; ++row)
  {
    const std::int64_t floor = FloorOfQuotient(row * width, height);
    const std::int64_t place = 2 * (low.X + floor) + std::int64_t(floor * height != row * width);
    this->Crossings.push_back(std::uint64_t(low.Y + row + Offset) << (PlaceBits + 1) |
      std::uint64_t(place + 2 * Offset) << 1 | std::uint64_t(isUpward));
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsClearBetween()
{
  std::sort(this->Crossings.begin(), this->Crossings.end());
  int turns = 0;
  for (std::size_t n = 0; n + 1 < this->Crossings.size(); ++n)
  {
    const std::uint64_t crossing = this->Crossings[n];
    turns += IsUpward(crossing) ? 1 : -1;
    const std::int64_t last = turns == 0 ? 0 : FloorOfQuotient(PlaceOf(this->Crossings[n + 1]), 2);
    for (std::int64_t x = FloorOfQuotient(PlaceOf(crossing) + 1, 2); turns != 0 && x <= last; ++x)
    {
      if (!this->IsClearAt(x, RowOf(crossing)))
      {
        this->AddBar({ std::int32_t(x), std::int32_t(RowOf(crossing)) });
        return false;
      }
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
void ShortcutGuard::AddBar(const PlanePoint& column)
{
  const Bar bar{ column, this->To > ReachOfBar ? this->To - ReachOfBar : 0, { 0 } };
  if (this->Bars.size() < MostBars)
  {
    this->Bars.push_back(bar);
    return;
  }
  this->Bars[this->NextBar] = bar;
  this->NextBar = (this->NextBar + 1) % MostBars;
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsKnownToBeBarred(std::size_t from, std::size_t to)
{
  this->From = from;
  this->To = to;
  return std::any_of(this->Bars.begin(), this->Bars.end(),
    [&](Bar& bar)
    {
      if (from < bar.First || this->IsClearAt(bar.Column.X, bar.Column.Y))
      {
        return false;
      }
      while (bar.Crossings.size() <= to - bar.First)
      {
        const std::size_t position = bar.First + bar.Crossings.size();
        bar.Crossings.push_back(
          bar.Crossings.back() + CrossingOf(this->ColumnAt(position - 1), this->ColumnAt(position), bar.Column));
      }
      return bar.Crossings[to - bar.First] - bar.Crossings[from - bar.First] +
        CrossingOf(this->ColumnAt(to), this->ColumnAt(from), bar.Column) !=
        0;
    });
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsClearAlong(const PlanePoint& from, const PlanePoint& to) const
{
  const std::int64_t x = std::int64_t(to.X) - from.X;
  const std::int64_t y = std::int64_t(to.Y) - from.Y;
  const std::int64_t steps = std::gcd(x, y);
  for (std::int64_t step = 1; step < steps; ++step)
  {
    if (!this->IsClearAt(from.X + x / steps * step, from.Y + y / steps * step))
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutGuard::IsClearAt(std::int64_t x, std::int64_t y) const
{
  const PlanePoint column = { std::int32_t(x), std::int32_t(y) };
  const std::int64_t place = this->Index.Place(column);
  if (!this->Index.Has(place))
  {
    return true;
  }
  const std::int64_t number = (*this->OnLoops)[place];
  const std::size_t position = number == PlaceNumbers::None ? NoPosition : this->Position[number];
  return (position > this->From && position < this->To) || column == this->ColumnAt(this->From) ||
    column == this->ColumnAt(this->To);
}

//----------------------------------------------------------------------------------------------------------------------
FewestPoints::FewestPoints(const SpacePoints& points, const ColumnIndex& index,
  const std::vector<unsigned char>& visits, double outlineTolerance, double heightTolerance, KeptOfChains& known,
  std::function<void()> goOn)
  : Points(points)
  , Visits(visits)
  , OutlineTolerance(outlineTolerance)
  , HeightTolerance(heightTolerance)
  , Known(known)
  , GoOn(std::move(goOn))
  , Guard(index, visits)
{
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> FewestPoints::Simplify(const std::vector<PointId>& loop)
{
  const auto fixed = std::find_if(loop.begin(), loop.end(), [this](PointId point) { return this->IsFixed(point); });
  if (fixed != loop.end())
  {
    return this->SimplifyFrom(loop, std::size_t(fixed - loop.begin()));
  }
  const std::vector<std::size_t> kept = this->SimplifyFrom(loop, 0);
  std::vector<std::size_t> again = this->SimplifyFrom(loop, kept[kept.size() / 2]);
  return again.size() <= kept.size() ? again : kept;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> FewestPoints::SimplifyFrom(const std::vector<PointId>& loop, std::size_t first)
{
  std::vector<std::vector<PointId>> chains(1);
  for (std::size_t n = 0; n <= loop.size(); ++n)
  {
    const PointId point = loop[(first + n) % loop.size()];
    chains.back().push_back(point);
    if (chains.back().size() > 1 && n < loop.size() && this->IsFixed(point))
    {
      chains.push_back({ point });
    }
  }
  this->Learn(chains);
  std::vector<std::size_t> kept;
  for (const std::vector<PointId>& chain : chains)
  {
    const std::vector<std::size_t>& positions = this->Known.at(KeyOfChain(chain));
    std::transform(positions.begin(), positions.end() - 1, std::back_inserter(kept),
      [&](std::size_t position) { return (first + position) % loop.size(); });
    first += chain.size() - 1;
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

//----------------------------------------------------------------------------------------------------------------------
/// Chains are independent. A copy takes the time of some points.
void FewestPoints::Learn(const std::vector<std::vector<PointId>>& chains)
{
  std::vector<const std::vector<PointId>*> unknown;
  std::size_t points = 0;
  for (const std::vector<PointId>& chain : chains)
  {
    if (this->Known.count(KeyOfChain(chain)) == 0)
    {
      unknown.push_back(&chain);
      points += chain.size();
    }
  }
  std::vector<std::vector<std::size_t>> kept(unknown.size());
  const auto simplify = [&](FewestPoints& own, std::int64_t first, std::int64_t last)
  {
    std::transform(unknown.begin() + first, unknown.begin() + last, kept.begin() + first,
      [&own](const std::vector<PointId>* chain) { return own.SimplifyChain(*chain); });
  };
  const auto size = std::int64_t(unknown.size());
  const std::int64_t copies = std::min(size, std::int64_t(points) / PointsPerCopy);
  if (copies < 2)
  {
    simplify(*this, 0, size);
  }
  else
  {
    ParallelFor(size, size / copies,
      [&](std::int64_t first, std::int64_t last)
      {
        FewestPoints own(*this);
        own.GoOn = []() {}; // on the calling thread alone
        simplify(own, first, last);
      });
  }
  for (std::size_t n = 0; n < unknown.size(); ++n)
  {
    this->Known.emplace(KeyOfChain(*unknown[n]), std::move(kept[n]));
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Two points of a loop must not share two edges, or it might have no inside. A closed chain therefore keeps two inner
/// points, and an open chain one, unless it is straight.
std::vector<std::size_t> FewestPoints::SimplifyChain(const std::vector<PointId>& chain)
{
  this->SetChain(chain);
  const std::size_t leastEdges = this->Chain.front() == this->Chain.back() ? 3 : 1;
  bool isDone = this->Chain.size() <= leastEdges + 1;
  while (!isDone)
  {
    const std::size_t before = this->Nodes.size();
    isDone = this->FindPath() || this->Nodes.size() == before;
  }
  return this->Nodes;
}

//----------------------------------------------------------------------------------------------------------------------
void FewestPoints::SetChain(const std::vector<PointId>& chain)
{
  this->Chain = chain;
  this->Guard.SetChain(this->Chain);
  this->Places.clear();
  this->Before.assign(1, { Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0.0 });
  for (const PointId point : this->Chain)
  {
    const SpacePoint place = this->Points[point];
    this->Places.emplace_back(place.X, place.Y, place.Z);
    const Eigen::Vector3d way = this->Places.back() - this->Places.front();
    const Moments& before = this->Before.back();
    this->Before.push_back(
      { before.Ways + way, before.Products + way * way.transpose(), before.Lengths + way.squaredNorm() });
  }
  this->ListNodes();
}

//----------------------------------------------------------------------------------------------------------------------
void FewestPoints::ListNodes()
{
  this->Nodes.assign(1, 0);
  std::size_t bend = 0;
  for (std::size_t position = 1; position < this->Chain.size(); ++position)
  {
    if (this->IsBend(position))
    {
      for (std::size_t node = bend + 1; node <= position; ++node)
      {
        if (node <= bend + RunEnd || node + RunEnd >= position)
        {
          this->Nodes.push_back(node);
        }
      }
      bend = position;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool FewestPoints::IsBend(std::size_t position) const
{
  if (position + 1 == this->Places.size())
  {
    return true;
  }
  const Eigen::Vector3d in = this->Places[position] - this->Places[position - 1];
  const Eigen::Vector3d out = this->Places[position + 1] - this->Places[position];
  return in != out;
}

//----------------------------------------------------------------------------------------------------------------------
/// Returns false if a better path may exist, because LookBack excluded some edges.
bool FewestPoints::FindPath()
{
  const std::size_t last = this->Nodes.size() - 1;
  this->IsLimited = false;
  this->Fewest.assign(1, { 0, 0.0, 0 });
  this->TwoOrMore.assign(1, { NoWay, 0.0, 0 });
  for (std::size_t node = 1; node < last; ++node)
  {
    if (node % NodesPerBatch == 0)
    {
      this->GoOn();
    }
    this->FindSources(node);
    const bool isNearFirst = this->Sources.back() == 0;
    this->TwoOrMore.push_back(this->BestStep(node, this->Fewest));
    const bool isNext = isNearFirst && this->IsAdmissible(0, node);
    this->Fewest.push_back(
      isNext ? Step{ 1, this->Cost(this->Nodes[0], this->Nodes[node]), 0 } : this->TwoOrMore.back());
  }
  this->FindSources(last);
  const bool isClosed = this->Chain.front() == this->Chain.back();
  const bool isOne = !isClosed && this->IsStraight() && this->Sources.back() == 0 && this->IsAdmissible(0, last);
  this->FollowPath(isOne ? Step{ 1, 0.0, 0 } : this->BestStep(last, isClosed ? this->TwoOrMore : this->Fewest));
  return !this->IsLimited;
}

//----------------------------------------------------------------------------------------------------------------------
/// No other edge can exist between the ends of a chain that is straight in plan.
bool FewestPoints::IsStraight() const
{
  const SpanningEdge edge(this->Places.front(), this->Places.back());
  return std::all_of(this->Places.begin(), this->Places.end(),
    [&edge](const Eigen::Vector3d& place) { return edge.OnMap(place).InPlan == 0.0; });
}

//----------------------------------------------------------------------------------------------------------------------
/// Sources do not depend on paths, so that those of the next nodes are found in parallel.
void FewestPoints::FindSources(std::size_t node)
{
  const std::size_t inBatch = (node - 1) % NodesPerBatch;
  if (inBatch == 0)
  {
    std::atomic<bool> isLimited(this->IsLimited);
    this->NextSources.resize(std::min(NodesPerBatch, this->Nodes.size() - node));
    ParallelFor(std::int64_t(this->NextSources.size()), NodesPerTask,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          if (this->ListSources(node + std::size_t(n), this->NextSources[n]))
          {
            isLimited = true;
          }
        }
      });
    this->IsLimited = isLimited;
  }
  this->Sources.swap(this->NextSources[inBatch]);
}

//----------------------------------------------------------------------------------------------------------------------
/// Returns whether LookBack has excluded some.
bool FewestPoints::ListSources(std::size_t node, std::vector<std::size_t>& sources) const
{
  const Eigen::Vector3d& place = this->Places[this->Nodes[node]];
  ShortcutCone cone(this->OutlineTolerance, this->HeightTolerance);
  sources.clear();
  std::size_t source = node;
  while (source > 0 && node - source < LookBack && !cone.IsEmpty())
  {
    --source;
    const Eigen::Vector3d way = this->Places[this->Nodes[source]] - place;
    if (cone.Pass(way))
    {
      sources.push_back(source);
    }
  }
  return source > 0 && !cone.IsEmpty();
}

//----------------------------------------------------------------------------------------------------------------------
/// Candidates are sorted lazily, since costs, and even more admissibility, are expensive.
FewestPoints::Step FewestPoints::BestStep(std::size_t node, const std::vector<Step>& ways)
{
  const auto isWorse = [](const Step& a, const Step& b) { return std::tie(a.Cost, a.From) > std::tie(b.Cost, b.From); };
  for (std::size_t edges = this->LeastEdges(ways, 0); edges < NoWay; edges = this->LeastEdges(ways, edges + 1))
  {
    this->Steps.clear();
    for (const std::size_t source : this->Sources)
    {
      if (source > 0 && ways[source].Edges == edges)
      {
        const double cost = this->Cost(this->Nodes[source], this->Nodes[node]);
        this->Steps.push_back({ edges + 1, ways[source].Cost + cost, source });
      }
    }
    std::make_heap(this->Steps.begin(), this->Steps.end(), isWorse);
    for (; !this->Steps.empty(); this->Steps.pop_back())
    {
      std::pop_heap(this->Steps.begin(), this->Steps.end(), isWorse);
      if (this->IsAdmissible(this->Steps.back().From, node))
      {
        return this->Steps.back();
      }
    }
  }
  return { NoWay, 0.0, 0 };
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t FewestPoints::LeastEdges(const std::vector<Step>& ways, std::size_t atLeast) const
{
  std::size_t least = NoWay;
  for (const std::size_t source : this->Sources)
  {
    const std::size_t edges = ways[source].Edges;
    least = source > 0 && edges >= atLeast ? std::min(least, edges) : least;
  }
  return least;
}

//----------------------------------------------------------------------------------------------------------------------
/// An edge between successive nodes needs no test: they are neighbours, ends of a straight run, or results of the last
/// round.
bool FewestPoints::IsAdmissible(std::size_t from, std::size_t to)
{
  if (to == from + 1)
  {
    return true;
  }
  const std::size_t first = this->Nodes[from];
  const std::size_t last = this->Nodes[to];
  if (this->Guard.IsKnownToBeBarred(first, last))
  {
    return false;
  }
  const SpanningEdge edge(this->Places[first], this->Places[last]);
  const bool isNear =
    std::all_of(this->Places.begin() + std::ptrdiff_t(first) + 1, this->Places.begin() + std::ptrdiff_t(last),
      [&](const Eigen::Vector3d& place)
      {
        const MapDistances distances = edge.OnMap(place);
        return distances.InPlan <= this->OutlineTolerance && distances.InHeight <= this->HeightTolerance;
      });
  return isNear && this->Guard.IsClear(first, last);
}

//----------------------------------------------------------------------------------------------------------------------
double FewestPoints::Cost(std::size_t from, std::size_t to) const
{
  const Eigen::Vector3d start = this->Places[from] - this->Places.front();
  const Eigen::Vector3d along = this->Places[to] - this->Places[from];
  const Moments& begin = this->Before[from + 1];
  const Moments& end = this->Before[to];
  const double count = double(to - from - 1);
  const Eigen::Vector3d ways = end.Ways - begin.Ways;
  const double squares = end.Lengths - begin.Lengths - 2.0 * ways.dot(start) + count * start.squaredNorm();
  const double way = along.dot(start);
  const double squaresAlong =
    along.dot((end.Products - begin.Products) * along) - 2.0 * way * along.dot(ways) + count * way * way;
  return std::max(0.0, squares - squaresAlong / along.squaredNorm());
}

//----------------------------------------------------------------------------------------------------------------------
void FewestPoints::FollowPath(const Step& last)
{
  std::vector<std::size_t> path = { this->Nodes.back() };
  const bool isClosed = this->Chain.front() == this->Chain.back();
  for (std::size_t node = last.From; node > 0;
       node = (isClosed && path.size() == 2 ? this->TwoOrMore : this->Fewest)[node].From)
  {
    path.push_back(this->Nodes[node]);
  }
  path.push_back(this->Nodes.front());
  this->Nodes.assign(path.rbegin(), path.rend());
}
}
