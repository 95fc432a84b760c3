// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary loops of the fewest points within tolerances: a shortest path over all edges that may take the place of a
// part of a loop (Imai and Iri 1988).
//
// Points that loops visit more than once stay, and cut a loop into chains. An edge between two points of a chain may
// take the place of all between them when these are within the tolerances of it, and ShortcutGuard lets it. Going
// along a chain, for each point the best way to it is found from those to the points before it, of which ShortcutCone
// rules out nearly all. Among ways of equally many edges the best is that of the least sum of squared distances in
// space from dropped points to the lines of their edges.
//
// So that time is near linear, only the last 512 points before each are looked at; where more could have come into
// question, as on straight sides of a survey, the points that are left are gone along in the same way, and so on. Of
// runs that are straight in space, points farther than 32 from their ends are not looked at. So the number of points is
// the least where no edge could span more than 512 and no such run has more than 64, and near it otherwise.

#ifndef SeismicHorizonsFewestPoints_h
#define SeismicHorizonsFewestPoints_h

#include "Common/ColumnIndex.h"
#include "Common/SpacePoints.h"
#include "Common/Types.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Distances of a place from an edge seen from above, and in height where it is nearest so.
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
    return (way - NearestPart(this->Along, way) * this->Along).norm();
  }

  MapDistances OnMap(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d way = place - this->From;
    const Eigen::Vector3d off = way - NearestPart<Eigen::Vector2d>(this->Along.head<2>(), way.head<2>()) * this->Along;
    return { this->IsOnMap(way) ? 0.0 : off.head<2>().norm(), std::abs(off.z()) };
  }

private:
  /// Where on the segment from the origin to `along` the place nearest to `way` is: 0 at the origin, 1 at its other
  /// end.
  template <typename Vector>
  static double NearestPart(const Vector& along, const Vector& way)
  {
    const double length = along.squaredNorm();
    return length > 0.0 ? std::min(1.0, std::max(0.0, along.dot(way) / length)) : 0.0;
  }

  /// Whether the end of a way from our first end is on us, seen from above. Boundary points stand on whole columns, so
  /// that products are exact, and nothing is lost to rounding on a straight run.
  bool IsOnMap(const Eigen::Vector3d& way) const
  {
    const double part = this->Along.head<2>().dot(way.head<2>());
    return this->Along.x() * way.y() == this->Along.y() * way.x() && part >= 0.0 &&
      part <= this->Along.head<2>().squaredNorm();
  }

  Eigen::Vector3d From;
  Eigen::Vector3d Along;
};

// Which chains of boundary points can be replaced by straight edges, so that no loops come to cross and every point
// stays on its side of them.
//
//        o--o                    When an edge takes the place of a chain, what lies between the two changes sides. No
//       /    \    o--o           point may lie there, or on the edge, other than those of the chain. Then no edge of
//   ---o------o--/----o---       another chain crosses the new one: it cannot cross the chain, and would have an end
//              \o                between the two. For the same reason two new edges never cross, in whatever order they
//                              are made, as their ends are among the points that may not lie there.
/// All answers are exact.
class ShortcutGuard
{
public:
  /// `index` is that of all points of the horizon, on the boundary or inside, of which `isOnLoop` has for each 0 when
  /// no loop visits it. Keeps a reference to it.
  ShortcutGuard(const ColumnIndex& index, const std::vector<unsigned char>& isOnLoop);

  /// Takes a chain, whose points between its ends no loop visits a second time.
  void SetChain(const std::vector<PointId>& chain);

  /// How many steps lead along the chain from a position to a point: 0 where no loop visits it, as many as a number can
  /// be where only others do.
  std::size_t StepsTo(std::size_t position, PointId point) const;

  /// Whether the points of the chain between two positions can be dropped.
  bool IsClear(std::size_t from, std::size_t to);

  /// Whether one of the columns that were in the way of edges asked about last is in the way of this one, too. Takes
  /// hardly any time where many edges to one point, or to the next ones, are asked about.
  bool IsKnownToBeBarred(std::size_t from, std::size_t to);

private:
  /// A column that was in the way, and how often the chain goes around it, from a first position on to each later one:
  /// by crossings of the row to the right of the column, upwards less downwards.
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
  PlaceNumbers OnLoops; // the places with points of loops
  std::vector<PointId> Chain;
  std::vector<std::size_t> Position; // in the chain, by the numbers of these places, for points between its ends
  std::size_t From = 0; // the positions that IsClear was asked about
  std::size_t To = 0;
  std::vector<std::uint64_t> Crossings; // see AddCrossings
  std::vector<Bar> Bars; // the last ones
  std::size_t NextBar = 0; // which of them goes for a new one
};

class FewestPoints
{
public:
  /// `points` are all points of the horizon, which stand on the columns of `index`; loops visit each of them so many
  /// times, 2 standing for more than one. Tolerances in columns, and in lattice units upwards; beside a gap of at most
  /// 8 columns, but at least as many as the longest hop of the loops, half of its columns are the largest tolerance, so
  /// that outlines stay on their sides of its middle. `goOn` is called every so many points; it can
  /// throw to end the work.
  FewestPoints(const SpacePoints& points, const ColumnIndex& index, const std::vector<unsigned char>& visits,
    double outlineTolerance, double heightTolerance, int longestHop, std::function<void()> goOn);

  /// The positions of the points that a loop keeps, ascending. Of a loop without points that have to stay, one does all
  /// the same: one that stays when the first of the loop does, half-way round from there.
  std::vector<std::size_t> Simplify(const std::vector<PointId>& loop);

  /// The positions of the points that an open chain keeps, or one from a point back to itself, ascending. Its ends
  /// stay.
  std::vector<std::size_t> SimplifyChain(std::vector<PointId> chain);

private:
  /// The last edge of a way from the begin of the chain, and what the way has cost.
  struct Step
  {
    std::size_t Edges;
    double Cost;
    std::size_t From; // the number of a node
  };

  /// Sums over the points of the chain before a position: of their ways from the first, of the products of these, and
  /// of their squared lengths.
  struct Moments
  {
    Eigen::Vector3d Ways;
    Eigen::Matrix3d Products;
    double Lengths;
  };

  bool IsFixed(PointId point) const { return this->Visits[point] > 1; }
  double ToleranceAt(std::size_t position) const;
  std::vector<std::size_t> SimplifyFrom(const std::vector<PointId>& loop, std::size_t first);
  void SetChain(std::vector<PointId> chain);
  void ListNodes();
  bool IsBend(std::size_t position) const;
  bool FindPath();
  bool IsStraight() const;
  void FindSources(std::size_t node);
  Step BestStep(std::size_t node, const std::vector<Step>& ways);
  std::size_t LeastEdges(const std::vector<Step>& ways, std::size_t atLeast) const;
  bool IsAdmissible(std::size_t from, std::size_t to);
  double Cost(std::size_t from, std::size_t to) const;
  void FollowPath(const Step& last);

  const SpacePoints& Points;
  const ColumnIndex& Index;
  const std::vector<unsigned char>& Visits;
  const double OutlineTolerance;
  const double HeightTolerance;
  const int LongestHop;
  const std::function<void()> GoOn;
  ShortcutGuard Guard;
  std::vector<PointId> Chain;
  std::vector<Eigen::Vector3d> Places; // of the chain
  std::vector<double> Tolerances; // on the map
  std::vector<Moments> Before;
  std::vector<std::size_t> Nodes; // the positions in the chain that a way may go by
  std::vector<Step> Fewest; // to each node
  std::vector<Step> TwoOrMore; // the same, by two edges at least
  std::vector<std::size_t> Sources; // the nodes from which an edge may lead to the one we are at
  std::vector<Step> Steps; // from these
  bool IsLimited = false; // whether nodes were left out of the sources as too many
};
}

#endif
