// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary loops of the fewest points within tolerances: a shortest path over all edges that may take the place of a
// part of a loop (Imai and Iri 1988).
//
// Points that loops visit more than once stay, and cut a loop into chains. An edge between two points of a chain may
// take the place of all between them when these are within the tolerances of it, and ShortcutGuard.h lets it. Going
// along a chain, for each point the best way to it is found from those to the points before it, of which ShortcutCone.h
// rules out nearly all. Among ways of equally many edges the best is that of the least sum of squared distances in
// space from dropped points to the lines of their edges.
//
// So that time is near linear, only the last 512 points before each are looked at; where more could have come into
// question, as on straight sides of a survey, the points that are left are gone along in the same way, and so on. Of
// runs that are straight in space, points farther than 32 from their ends are not looked at. So the number of points is
// the least where no edge could span more than 512 and no such run has more than 64, and near it otherwise.

#ifndef SeismicHorizonsFewestPoints_h
#define SeismicHorizonsFewestPoints_h

#include "Common/SpacePoints.h"
#include "ShortcutGuard.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace SeismicHorizons
{
class FewestPoints
{
public:
  /// `points` are all points of the horizon, on whole columns (InputError otherwise), of which loops visit each so many
  /// times, 2 standing for more than one. Tolerances in columns, and in lattice units upwards. `goOn` is called every
  /// so many points; it can throw to end the work.
  FewestPoints(const SpacePoints& points, const std::vector<unsigned char>& visits, double outlineTolerance,
    double heightTolerance, std::function<void()> goOn);

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

  bool IsFixed(PointId point) const { return this->Visits[std::size_t(point)] > 1; }
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
  const std::vector<unsigned char>& Visits;
  const double OutlineTolerance;
  const double HeightTolerance;
  const std::function<void()> GoOn;
  ShortcutGuard Guard;
  std::vector<PointId> Chain;
  std::vector<Eigen::Vector3d> Places; // of the chain
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
