// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary loops with the fewest points within tolerances: a shortest path over all edges that can replace a section of
// a loop (Imai and Iri 1988).
//
// Points that loops visit more than once stay and divide a loop into chains. An edge between two points of a chain is
// admissible if the points in between are within the tolerances, and ShortcutGuard allows it. Each point in turn takes
// the best path through the points before it, most of them excluded by ShortcutCone. Among paths with equally many
// edges the least sum of squared distances in space wins.
//
// For nearly linear time, only 512 points before each point are tried, and within runs that are straight in space only
// points up to 32 from an end. If this excluded edges, as on straight borders of a survey, the remaining points are
// processed again. The result is optimal if no edge could span more than 512 points, and no straight run exceeds 64
// points.

#ifndef SeismicHorizonsFewestPoints_h
#define SeismicHorizonsFewestPoints_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/SpacePoints.h"
#include "Common/Horizon/Types.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace SeismicHorizons
{
struct MapDistances
{
  double InPlan;
  double InHeight;
};

class SpanningEdge
{
public:
  SpanningEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    : From(from)
    , Along(to - from)
  {
  }

  double InSpace(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d way = place - this->From;
    return (way - NearestFraction(this->Along, way) * this->Along).norm();
  }

  MapDistances OnMap(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d way = place - this->From;
    const Eigen::Vector3d off =
      way - NearestFraction<Eigen::Vector2d>(this->Along.head<2>(), way.head<2>()) * this->Along;
    return { this->IsOnMap(way) ? 0.0 : off.head<2>().norm(), std::abs(off.z()) };
  }

private:
  template <typename Vector>
  static double NearestFraction(const Vector& along, const Vector& way)
  {
    const double length = along.squaredNorm();
    return length > 0.0 ? std::min(1.0, std::max(0.0, along.dot(way) / length)) : 0.0;
  }

  /// Products of whole coordinates are exact, so that a straight run has no rounding errors.
  bool IsOnMap(const Eigen::Vector3d& way) const
  {
    const double product = this->Along.head<2>().dot(way.head<2>());
    return this->Along.x() * way.y() == this->Along.y() * way.x() && product >= 0.0 &&
      product <= this->Along.head<2>().squaredNorm();
  }

  Eigen::Vector3d From;
  Eigen::Vector3d Along;
};

// Decides whether a straight edge can replace a chain of boundary points without crossing loops. All answers are exact.
//
//       o--o                    If an edge replaces a chain, the area between them changes sides. No point may lie there
//      /    \    o--o           or on the edge, except from the chain. Then edges of other chains do not cross the new
//  ---o------o--/----o---       one: it cannot cross the chain, and would have an end in the area. By the same argument
//             \o                two new edges never cross, in any order.
class ShortcutGuard
{
public:
  /// The index must contain all points of the horizon, and is kept by reference. `isOnLoop` is 0 for points that no
  /// loop visits.
  ShortcutGuard(const ColumnIndex& index, const std::vector<unsigned char>& isOnLoop);

  /// Loops must visit the inner points of the chain only once.
  void SetChain(const std::vector<PointId>& chain);

  bool IsClear(std::size_t from, std::size_t to);

  /// Tests the last blocking columns, which is fast for successive edges to the same or the next points.
  bool IsKnownToBeBarred(std::size_t from, std::size_t to);

private:
  /// A blocking column has winding counts of the chain from position First to each later one: crossings of the row to
  /// its right, upwards minus downwards.
  struct Bar
  {
    PlanePoint Column;
    std::size_t First;
    std::vector<std::int32_t> Crossings;
  };

  void AddBar(const PlanePoint& column);
  PlanePoint ColumnAt(std::size_t position) const { return this->Columns[this->Chain[position]]; }
  std::size_t& PositionOf(PointId point);
  void AddCrossings(const PlanePoint& from, const PlanePoint& to);
  bool IsClearBetween();
  bool IsClearAlong(const PlanePoint& from, const PlanePoint& to) const;
  bool IsClearAt(std::int64_t x, std::int64_t y) const;

  const ColumnIndex& Index;
  const PlanePoints Columns;
  std::shared_ptr<PlaceNumbers> OnLoops = std::make_shared<PlaceNumbers>(); // shared by copies
  std::vector<PointId> Chain;
  std::vector<std::size_t> Position; // in the chain, by number in OnLoops
  std::size_t From = 0;
  std::size_t To = 0;
  std::vector<std::uint64_t> Crossings;
  std::vector<Bar> Bars;
  std::size_t NextBar = 0;
};

/// Positions that chains keep, by their first two points and their length, which tell the chains of one boundary apart.
/// Tolerances must remain the same.
using KeptOfChains = std::map<std::tuple<PointId, PointId, std::size_t>, std::vector<std::size_t>>;

class FewestPoints
{
public:
  /// `visits` saturates at 2. Tolerances are in columns and, vertically, in lattice units. `goOn` is called regularly
  /// and may throw to abort.
  FewestPoints(const SpacePoints& points, const ColumnIndex& index, const std::vector<unsigned char>& visits,
    double outlineTolerance, double heightTolerance, KeptOfChains& known, std::function<void()> goOn);

  /// Returns the positions that a loop keeps, ascending. A loop without fixed points is processed twice, from its first
  /// point and from a point kept about half-way round.
  std::vector<std::size_t> Simplify(const std::vector<PointId>& loop);

  /// Returns the positions that the chain keeps, ascending. Its ends stay; they may be the same point.
  std::vector<std::size_t> SimplifyChain(const std::vector<PointId>& chain);

private:
  struct Step
  {
    std::size_t Edges;
    double Cost;
    std::size_t From;
  };

  /// Sums over the points of the chain before a position give costs in constant time: vectors from the first point,
  /// their outer products and squared lengths.
  struct Moments
  {
    Eigen::Vector3d Ways;
    Eigen::Matrix3d Products;
    double Lengths;
  };

  bool IsFixed(PointId point) const { return this->Visits[point] > 1; }
  std::vector<std::size_t> SimplifyFrom(const std::vector<PointId>& loop, std::size_t first);
  void Learn(const std::vector<std::vector<PointId>>& chains);
  void SetChain(const std::vector<PointId>& chain);
  void ListNodes();
  bool IsBend(std::size_t position) const;
  bool FindPath();
  bool IsStraight() const;
  void FindSources(std::size_t node);
  bool ListSources(std::size_t node, std::vector<std::size_t>& sources) const;
  Step BestStep(std::size_t node, const std::vector<Step>& ways);
  std::size_t LeastEdges(const std::vector<Step>& ways, std::size_t atLeast) const;
  bool IsAdmissible(std::size_t from, std::size_t to);
  double Cost(std::size_t from, std::size_t to) const;
  void FollowPath(const Step& last);

  const SpacePoints& Points;
  const std::vector<unsigned char>& Visits;
  const double OutlineTolerance;
  const double HeightTolerance;
  KeptOfChains& Known;
  std::function<void()> GoOn;
  ShortcutGuard Guard;
  std::vector<PointId> Chain;
  std::vector<Eigen::Vector3d> Places;
  std::vector<Moments> Before;
  std::vector<std::size_t> Nodes; // positions in the chain
  std::vector<Step> Fewest; // best last step, by node
  std::vector<Step> TwoOrMore; // with at least two edges
  std::vector<std::size_t> Sources;
  std::vector<std::vector<std::size_t>> NextSources; // of this node and those after it
  std::vector<Step> Steps;
  bool IsLimited = false;
};
}

#endif
