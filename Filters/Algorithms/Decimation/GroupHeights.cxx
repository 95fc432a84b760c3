// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GroupHeights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
GroupHeights<Real>::GroupHeights(Group& group, const GroupOptions& options)
  : Whole(group)
  , Error(options.Error)
  , Kernels(KernelsForStars<Real>())
  , Width(group.Box.Greatest.X - group.Box.Least.X + 1)
  , Rows(group.Box.Greatest.Y - group.Box.Least.Y + 1)
{
  double rounding = 0.0;
  for (const Group::Horizon& horizon : group.Horizons)
  {
    rounding = std::max(rounding, this->Add(*horizon.Raster));
  }
  this->Bound = Real(options.Error - rounding);
  this->EdgeBound = (options.CrossingError - rounding) / options.Error;
  this->Criticals.resize(group.Vertices.size() * group.Horizons.size());
  for (std::size_t n = 0; n < this->Criticals.size(); ++n)
  {
    const PlanePoint& place = group.Mesh.Place(VertexId(n / group.Horizons.size()));
    CriticalColumns<Real>& own = this->Criticals[n];
    own.X.fill(Real(place.X));
    own.Y.fill(Real(place.Y));
    own.Height.fill(this->Grids[n % group.Horizons.size()].At(place.X, place.Y));
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::IsEnough(const Group& group, double error)
{
  constexpr double mostColumns = 1 << 23;
  const double columns =
    (double(group.Box.Greatest.X) - group.Box.Least.X + 1.0) * (double(group.Box.Greatest.Y) - group.Box.Least.Y + 1.0);
  return !std::is_same_v<Real, float> ||
    (columns < mostColumns &&
      std::all_of(group.Horizons.begin(), group.Horizons.end(),
        [error](const Group::Horizon& horizon) { return horizon.Raster->IsFloatEnough(error); }));
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
void GroupHeights<Real>::GetHeights(VertexId vertex, std::vector<double>& heights) const
{
  heights.resize(this->Grids.size());
  for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
  {
    heights[horizon] = this->Height(horizon, vertex);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
void GroupHeights<Real>::SetHeights(VertexId vertex, const std::vector<double>& heights)
{
  for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
  {
    this->Whole.Horizons[horizon].Heights[vertex] = heights[horizon];
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::GetColumn(const PlanePoint& place, std::vector<double>& heights) const
{
  heights.resize(this->Grids.size());
  bool isKnown = true;
  for (std::size_t horizon = 0; horizon < heights.size() && isKnown; ++horizon)
  {
    heights[horizon] = this->Whole.Horizons[horizon].Raster->HeightAt(this->Column(place));
    isKnown = !std::isnan(heights[horizon]);
  }
  return isKnown;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::CanBeAt(const PlanePoint& place) const
{
  return place.X >= 0 && place.Y >= 0 && place.X < this->Width && place.Y < this->Rows &&
    !std::isnan(this->Grids[0].At(place.X, place.Y));
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::CostOf(const std::array<VertexId, 3>& corners, bool isBound, double most) const
{
  const Real bound = isBound ? this->Bound : Real(StarTrial::Never);
  double cost = 0.0;
  for (std::size_t horizon = 0; horizon < this->Grids.size() && cost < most; ++horizon)
  {
    cost += double(this->Kernels.SumTriangle(this->Grids[horizon],
      { this->Corner(horizon, corners[0]), this->Corner(horizon, corners[1]), this->Corner(horizon, corners[2]) },
      this->Power, Real(1.0 / this->Error), bound));
  }
  return cost;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::OwnCost(VertexId vertex) const
{
  double cost = 0.0;
  for (std::size_t horizon = 0; horizon < this->Grids.size(); ++horizon)
  {
    const double error = this->OwnError(horizon, this->Corner(horizon, vertex));
    cost += this->Power == 2 ? error * error : error * error * error * error;
  }
  return cost;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::IsEdgeWithin(VertexId from, VertexId to) const
{
  for (std::size_t horizon = 0; horizon < this->Grids.size(); ++horizon)
  {
    FreeMove stay;
    if (!this->Narrow(horizon, this->Corner(horizon, from), this->Corner(horizon, to), stay))
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::Try(const StarTrial& trial, std::vector<double>& heights)
{
  this->Moves.assign(this->Grids.size(), FreeMove());
  double cost = 0.0;
  for (std::size_t horizon = 0; horizon < this->Grids.size(); ++horizon)
  {
    const Star<Real> star = this->Pack(trial, horizon, heights[horizon]);
    if (!this->IsPossible(trial, horizon, star))
    {
      return StarTrial::Never;
    }
    cost += trial.IsFree ? this->TryFree(trial, horizon, star) : this->TryFixed(horizon, star, trial.Most - cost);
    if (!(cost < trial.Most))
    {
      return StarTrial::Never;
    }
  }
  if (!this->NarrowBySpokes(trial, heights))
  {
    return StarTrial::Never;
  }
  cost = trial.IsFree ? this->Move(trial, heights) : cost;
  return cost < trial.Most ? cost : StarTrial::Never;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
std::array<double, 2> GroupHeights<Real>::Descent() const
{
  std::array<double, 2> sum = { 0.0, 0.0 };
  for (const FreeMove& move : this->Moves)
  {
    sum = { sum[0] + move.Sums.Descent[0], sum[1] + move.Sums.Descent[1] };
  }
  return sum;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
void GroupHeights<Real>::Inherit(VertexId from, VertexId to)
{
  constexpr int inherited = 4;
  for (std::size_t horizon = 0; horizon < this->Grids.size(); ++horizon)
  {
    const CriticalColumns<Real> own = this->CriticalsOf(from, horizon);
    for (int n = 1; n <= inherited; ++n)
    {
      const int last = (own.Next + CriticalColumns<Real>::Size - n) % CriticalColumns<Real>::Size;
      this->AddCritical(to, horizon, this->Grids[horizon].Place(std::int32_t(own.X[last]), std::int32_t(own.Y[last])));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Returns how far off heights may be.
template <typename Real>
double GroupHeights<Real>::Add(const HeightRaster& raster)
{
  const double middle = raster.MiddleHeight();
  this->Middles.push_back(middle);
  if constexpr (std::is_same_v<Real, float>)
  {
    this->Grids.push_back({ raster.FloatsFrom(this->Whole.Box.Least), raster.Columns() });
    return raster.FloatRounding(this->Error);
  }
  else
  {
    RawVector<double>& copy = this->Copies.emplace_back();
    raster.ReadHeights(this->Whole.Box, middle, copy);
    copy.resize(copy.size() + HeightRaster::Beyond);
    std::fill(copy.end() - HeightRaster::Beyond, copy.end(), std::numeric_limits<double>::quiet_NaN());
    this->Grids.push_back({ copy.data(), this->Width });
    const double largest = std::max(std::abs(raster.LowestHeight()), std::abs(raster.HighestHeight()));
    return 16.0 * std::numeric_limits<double>::epsilon() * (largest + this->Error);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
StarCorner<Real> GroupHeights<Real>::Corner(std::size_t horizon, VertexId vertex) const
{
  const PlanePoint& place = this->Whole.Mesh.Place(vertex);
  return { place.X, place.Y, Real(this->Height(horizon, vertex) - this->Middles[horizon]) };
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
Star<Real> GroupHeights<Real>::Pack(const StarTrial& trial, std::size_t horizon, double height)
{
  this->Packed.clear();
  for (const VertexId end : *trial.Ring)
  {
    this->Packed.push_back(this->Corner(horizon, end));
  }
  return { { trial.Place.X, trial.Place.Y, Real(height - this->Middles[horizon]) }, this->Packed.data(),
    int(this->Packed.size()), trial.IsClosed };
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::IsPossible(const StarTrial& trial, std::size_t horizon, const Star<Real>& star)
{
  for (const VertexId vertex : { trial.Owner, trial.Other })
  {
    if (vertex != NoVertex &&
      !this->Kernels.IsPossible(this->CriticalsOf(vertex, horizon), star, trial.IsFree, this->Bound))
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
void GroupHeights<Real>::AddCritical(VertexId vertex, std::size_t horizon, std::int64_t place)
{
  if (vertex == NoVertex)
  {
    return;
  }
  const HeightGrid<Real>& grid = this->Grids[horizon];
  const Real x = Real(place % grid.Width);
  const Real y = Real(place / grid.Width);
  CriticalColumns<Real>& own = this->CriticalsOf(vertex, horizon);
  for (int n = 0; n < CriticalColumns<Real>::Size; ++n)
  {
    if (own.X[n] == x && own.Y[n] == y)
    {
      return;
    }
  }
  own.X[own.Next] = x;
  own.Y[own.Next] = y;
  own.Height[own.Next] = grid.Heights[place];
  own.Next = own.Next + 1 == CriticalColumns<Real>::Size ? 0 : own.Next + 1;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
StarSums GroupHeights<Real>::SumStar(std::size_t horizon, const Star<Real>& star) const
{
  StarSums sums = this->Kernels.SumStar(this->Grids[horizon], star, this->Power, Real(1.0 / this->Error));
  sums.Add(this->OwnError(horizon, star.Centre), 1.0, 1.0 - star.NumberOfTriangles());
  return sums;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::OwnError(std::size_t horizon, const StarCorner<Real>& corner) const
{
  const double error = double(corner.Height - this->Grids[horizon].At(corner.X, corner.Y)) / this->Error;
  return std::isnan(error) ? 0.0 : error;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::TryFree(const StarTrial& trial, std::size_t horizon, const Star<Real>& star)
{
  const FreeRange<Real> range = this->Kernels.FindRange(this->Grids[horizon], star, this->Bound);
  if (range.IsEmpty())
  {
    for (const VertexId vertex : { trial.Owner, trial.Other })
    {
      this->AddCritical(vertex, horizon, range.LowestAt);
      this->AddCritical(vertex, horizon, range.HighestAt);
    }
    return StarTrial::Never;
  }
  FreeMove& move = this->Moves[horizon];
  move.Lowest = double(range.Lowest) / this->Error;
  move.Highest = double(range.Highest) / this->Error;
  move.Sums = this->SumStar(horizon, star);
  return move.Sums.At(move.Sums.FindBest(move.Lowest, move.Highest));
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::TryFixed(std::size_t horizon, const Star<Real>& star, double most) const
{
  double cost = 0.0;
  for (int n = 0; n < star.NumberOfTriangles() && cost < most; ++n)
  {
    cost += double(this->Kernels.SumTriangle(this->Grids[horizon], { star.Centre, star.Ring[n], star.Next(n) },
      this->Power, Real(1.0 / this->Error), this->Bound));
  }
  return cost;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::NarrowBySpokes(const StarTrial& trial, const std::vector<double>& heights)
{
  const std::vector<VertexId>& ring = *trial.Ring;
  const std::size_t first = trial.IsClosed ? 0 : 1;
  const std::size_t last = trial.IsClosed ? ring.size() : ring.size() - 1;
  for (std::size_t horizon = 0; horizon < this->Grids.size(); ++horizon)
  {
    const StarCorner<Real> centre = { trial.Place.X, trial.Place.Y, Real(heights[horizon] - this->Middles[horizon]) };
    for (std::size_t n = first; n < last; ++n)
    {
      if (!this->Narrow(horizon, centre, this->Corner(horizon, ring[n]), this->Moves[horizon]))
      {
        return false;
      }
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
bool GroupHeights<Real>::Narrow(
  std::size_t horizon, const StarCorner<Real>& from, const StarCorner<Real>& to, FreeMove& move) const
{
  const auto narrow = [&](double error, double weight)
  {
    move.Lowest = std::max(move.Lowest, (-this->EdgeBound - error) / weight);
    move.Highest = std::min(move.Highest, (this->EdgeBound - error) / weight);
    return move.Lowest <= move.Highest;
  };
  return this->EdgeBound == std::numeric_limits<double>::infinity() ||
    (this->template ForEachCrossing<false>(horizon, from, to, narrow) &&
      this->template ForEachCrossing<true>(horizon, from, to, narrow));
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
template <bool IsTurned, typename Visitor>
bool GroupHeights<Real>::ForEachCrossing(
  std::size_t horizon, const StarCorner<Real>& from, const StarCorner<Real>& to, const Visitor& visit) const
{
  const std::int32_t start = IsTurned ? from.X : from.Y;
  const std::int32_t end = IsTurned ? to.X : to.Y;
  const std::int32_t lines = std::abs(end - start);
  const std::int64_t across = IsTurned ? std::int64_t(to.Y) - from.Y : std::int64_t(to.X) - from.X;
  for (std::int32_t n = 1; n < lines; ++n)
  {
    const std::int64_t parts = across * n;
    const std::int64_t whole = parts / lines - (parts % lines < 0 ? 1 : 0);
    const std::int64_t rest = parts - whole * lines;
    if (rest == 0)
    {
      continue;
    }
    const std::int32_t line = end > start ? start + n : start - n;
    const double fraction = double(n) / lines;
    const double height = double(from.Height) + fraction * (double(to.Height) - double(from.Height));
    const auto beside = std::int32_t((IsTurned ? from.Y : from.X) + whole);
    const PlanePoint column = IsTurned ? PlanePoint{ line, beside } : PlanePoint{ beside, line };
    const double error =
      (height - this->template HeightBetween<IsTurned>(horizon, column, double(rest) / lines)) / this->Error;
    if (!std::isnan(error) && !visit(error, 1.0 - fraction))
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
template <bool IsTurned>
double GroupHeights<Real>::HeightBetween(std::size_t horizon, const PlanePoint& column, double fraction) const
{
  const PlanePoint beyond = IsTurned ? PlanePoint{ column.X, column.Y + 1 } : PlanePoint{ column.X + 1, column.Y };
  const double first = this->OnLink(horizon, column);
  const double height = first + fraction * (this->OnLink(horizon, beyond) - first);
  const LinkCuts* const cuts = this->Whole.Cuts;
  const bool isCut =
    cuts && (IsTurned ? cuts->IsCutNorth(this->Column(column)) : cuts->IsCutEast(this->Column(column)));
  return isCut ? std::numeric_limits<double>::quiet_NaN() : height;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::OnLink(std::size_t horizon, const PlanePoint& column) const
{
  const double height = this->Grids[horizon].At(column.X, column.Y);
  return std::isnan(height)
    ? this->Whole.Horizons[horizon].Raster->DroppedHeight(this->Column(column)) - this->Middles[horizon]
    : height;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
double GroupHeights<Real>::Move(const StarTrial& trial, std::vector<double>& heights)
{
  this->Before = heights;
  double cost = 0.0;
  for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
  {
    const FreeMove& move = this->Moves[horizon];
    const double best = move.Sums.FindBest(move.Lowest, move.Highest);
    heights[horizon] += best * this->Error;
    cost += move.Sums.At(best);
  }
  if (!this->Whole.Rule)
  {
    return cost;
  }
  this->Whole.Rule(this->Column(trial.Place), heights);
  cost = 0.0;
  for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
  {
    const FreeMove& move = this->Moves[horizon];
    const double moved = (heights[horizon] - this->Before[horizon]) / this->Error;
    cost += moved < move.Lowest || moved > move.Highest ? StarTrial::Never : move.Sums.At(moved);
  }
  return cost;
}

template class GroupHeights<float>;
template class GroupHeights<double>;
}
