// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a group's vertices and columns, and trials of stars with a free height.

#ifndef SeismicHorizonsGroupHeights_h
#define SeismicHorizonsGroupHeights_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"
#include "GroupMesh.h"
#include "PlaneMesh.h"
#include "StarKernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace SeismicHorizons
{
/// A place for a vertex, and the ring around it.
struct StarTrial
{
  static constexpr double Never = 1e30;

  PlanePoint Place;
  const std::vector<VertexId>* Ring = nullptr;
  bool IsClosed = true;
  bool IsFree = true;
  /// Costs from here on are too large.
  double Most = Never;
  /// Vertices that remember columns in the way.
  VertexId Owner = NoVertex;
  VertexId Other = NoVertex;
};

template <typename Real>
class GroupHeights
{
public:
  GroupHeights(Group& group, const GroupOptions& options);

  /// Whether twice the areas of the group's triangles are exact, and rounding is small beside the error.
  static bool IsEnough(const Group& group, double error);

  /// Costs are sums of this power of errors in units of the error.
  void SetPower(int power) { this->Power = power; }

  /// How many horizons there are.
  std::size_t Size() const { return this->Grids.size(); }

  double Height(std::size_t horizon, VertexId vertex) const { return this->Whole.Horizons[horizon].Heights[vertex]; }

  void GetHeights(VertexId vertex, std::vector<double>& heights) const;

  void SetHeights(VertexId vertex, const std::vector<double>& heights);

  /// Returns false where one of several horizons has no height.
  bool GetColumn(const PlanePoint& place, std::vector<double>& heights) const;

  /// The first horizon has a height wherever a vertex may be.
  bool CanBeAt(const PlanePoint& place) const;

  /// With isBound, too large if an error is.
  double CostOf(const std::array<VertexId, 3>& corners, bool isBound, double most = StarTrial::Never) const;

  /// Of the column of a vertex alone.
  double OwnCost(VertexId vertex) const;

  bool IsEdgeWithin(VertexId from, VertexId to) const;

  /// The heights are those to start from and, if the trial is possible, those it gives. Returns the cost, or Never.
  double Try(const StarTrial& trial, std::vector<double>& heights);

  /// Where the cost would fall on the map if the centre of the last trial moved.
  std::array<double, 2> Descent() const;

  /// The last critical columns of a vertex that has gone matter to the other end of its edge.
  void Inherit(VertexId from, VertexId to);

private:
  /// In units of the error.
  struct FreeMove
  {
    double Lowest = 0.0;
    double Highest = 0.0;
    StarSums Sums;
  };

  double Add(const HeightRaster& raster);
  /// Of the horizon.
  PlanePoint Column(const PlanePoint& place) const
  {
    return { this->Whole.Box.Least.X + place.X, this->Whole.Box.Least.Y + place.Y };
  }
  StarCorner<Real> Corner(std::size_t horizon, VertexId vertex) const;
  Star<Real> Pack(const StarTrial& trial, std::size_t horizon, double height);
  bool IsPossible(const StarTrial& trial, std::size_t horizon, const Star<Real>& star);
  CriticalColumns<Real>& CriticalsOf(VertexId vertex, std::size_t horizon)
  {
    return this->Criticals[std::size_t(vertex) * this->Grids.size() + horizon];
  }
  void AddCritical(VertexId vertex, std::size_t horizon, std::int64_t place);
  /// The column of the centre counts once.
  StarSums SumStar(std::size_t horizon, const Star<Real>& star) const;
  double OwnError(std::size_t horizon, const StarCorner<Real>& corner) const;
  double TryFree(const StarTrial& trial, std::size_t horizon, const Star<Real>& star);
  double TryFixed(std::size_t horizon, const Star<Real>& star, double most) const;

  /// The first and the last end of an open ring have their edges already.
  bool NarrowBySpokes(const StarTrial& trial, const std::vector<double>& heights);

  /// Narrows the move of `from` so that the edge is within the error where it crosses grid lines. Returns false if no
  /// move is left.
  bool Narrow(std::size_t horizon, const StarCorner<Real>& from, const StarCorner<Real>& to, FreeMove& move) const;

  /// Calls visit(error, weight of `from`) where the edge crosses links, in units of the error, until it returns false.
  /// Returns whether it did not. IsTurned exchanges rows and columns.
  template <bool IsTurned, typename Visitor>
  bool ForEachCrossing(
    std::size_t horizon, const StarCorner<Real>& from, const StarCorner<Real>& to, const Visitor& visit) const;

  /// NaN if the link is cut or an end has no height.
  template <bool IsTurned>
  double HeightBetween(std::size_t horizon, const PlanePoint& column, double fraction) const;

  double OnLink(std::size_t horizon, const PlanePoint& column) const;

  double Move(const StarTrial& trial, std::vector<double>& heights);

  Group& Whole;
  const double Error;
  const StarKernels<Real>& Kernels;
  const std::int32_t Width;
  const std::int32_t Rows;
  std::vector<HeightGrid<Real>> Grids; // by horizon, relative to the middles
  std::deque<RawVector<double>> Copies; // what grids of doubles show
  std::vector<double> Middles;
  Real Bound = 0;
  double EdgeBound = 1.0; // in units of the error
  int Power = 4;
  std::vector<CriticalColumns<Real>> Criticals; // by vertex, then by horizon
  std::vector<StarCorner<Real>> Packed;
  std::vector<FreeMove> Moves; // by horizon, of the last trial
  std::vector<double> Before;
};
}

#endif
