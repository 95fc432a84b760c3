// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultPlate.h"

#include "Common/Base/Errors.h"
#include "Common/Base/LeastSquares.h"
#include "Common/Horizon/ConvexHull.h"
#include "Filters/Algorithms/HoleFilling/PlateEnergy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace SeismicHorizons
{
namespace
{
constexpr double NoReach = std::numeric_limits<double>::infinity();
constexpr double SpringsPerBend = 100.0; // Springs hold the plate at its picks, closer than interpreters pick.
constexpr double Held = 1e-9; // A plate that a single line holds would turn about it.
constexpr std::size_t MostNodes = 9000; // less than what needs a multigrid

/// The convex line around the ends of segments, seen across strike.
std::vector<std::array<FaultPlace, 2>> HullOf(const std::vector<std::array<FaultPlace, 2>>& segments)
{
  std::vector<Eigen::Vector2d> places;
  for (const auto& [from, to] : segments)
  {
    places.emplace_back(from.S, from.Z);
    places.emplace_back(to.S, to.Z);
  }
  const std::vector<Eigen::Vector2d> corners = FindHull(std::move(places));
  std::vector<std::array<FaultPlace, 2>> hull;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const Eigen::Vector2d &from = corners[n], &to = corners[(n + 1) % corners.size()];
    hull.push_back({ { { from.x(), 0.0, from.y() }, { to.x(), 0.0, to.y() } } });
  }
  return hull;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::pair<std::size_t, double> FaultPlate::Axis::Find(double value) const
{
  const double n = (value - this->First) / this->Step;
  const auto interval = std::size_t(std::clamp(n, 0.0, double(this->Size - 2)));
  return { interval, n - double(interval) };
}

//----------------------------------------------------------------------------------------------------------------------
FaultPlate::FaultPlate(const FaultPicks& picks, const Monitor& monitor)
  : OwnName(picks.Name)
  , IsDipKnown(picks.HasDip)
{
  this->Orient(picks);
  const Segments segments = this->MakeGrid(picks);
  if (picks.TipLoop.empty())
  {
    this->FindExtent(picks.IsSurface ? segments : HullOf(segments), 0.5 * picks.Spacing);
  }
  else
  {
    Segments loop;
    for (const auto& [from, to] : picks.TipLoop)
    {
      loop.push_back({ this->ToPlace(from), this->ToPlace(to) });
    }
    this->FindExtent(loop, 0.0);
  }
  this->Fit(segments, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
// The normal of the mean plane gives strike and dip. Heights are scaled to the size of the map, since their unit may be
// seconds: a plane stays a plane.
void FaultPlate::Orient(const FaultPicks& picks)
{
  const auto count = double(2 * picks.Segments.size());
  for (const auto& [from, to] : picks.Segments)
  {
    this->Origin += (from + to) / count;
    this->OnMap.extend(from.head<2>());
    this->OnMap.extend(to.head<2>());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& [from, to] : picks.Segments)
  {
    for (const Eigen::Vector3d& place : { from, to })
    {
      spread += (place - this->Origin) * (place - this->Origin).transpose() / count;
    }
  }
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(0.5 * picks.Spacing);
  this->OnMap = Eigen::AlignedBox2d(this->OnMap.min() - reach, this->OnMap.max() + reach);
  const double onMap = std::max(spread(0, 0), spread(1, 1));
  const double scale = std::sqrt(onMap / spread(2, 2));
  constexpr double rounding = 1e-9;
  const auto isNone = [](double square, double place) { return std::sqrt(square) <= rounding * std::abs(place); };
  if (isNone(onMap, this->Origin.head<2>().cwiseAbs().maxCoeff()) || isNone(spread(2, 2), this->Origin.z()) ||
    !(onMap > 0.0) || !std::isfinite(scale))
  {
    throw InputError("fault " + this->OwnName +
      " with picks at one height or on one vertical line, expected sticks "
      "down the fault, lines on several horizons, or a surface");
  }
  spread.row(2) *= scale;
  spread.col(2) *= scale;
  const PrincipalAxes<3> axes = FindPrincipalAxes(spread);
  const Eigen::Vector3d normal = axes.Axes.col(0);
  constexpr double leastSpread = 1e-12, leastDip = 0.02;
  if (!(axes.Values(1) > leastSpread * axes.Values(2)))
  {
    throw InputError("fault " + this->OwnName + " with picks on one line, expected two sticks, or a surface");
  }
  if (!(normal.head<2>().norm() > leastDip))
  {
    throw InputError("fault " + this->OwnName + " that is horizontal, expected one that dips");
  }
  this->Across = normal.head<2>().normalized();
  const double slope = -normal(2) * scale / normal.head<2>().norm(); // of the offset, by height
  if (slope > 0.0 || (slope == 0.0 && this->Across.x() + this->Across.y() < 0.0))
  {
    this->Across = -this->Across;
  }
  this->Along = { -this->Across.y(), this->Across.x() };
}

//----------------------------------------------------------------------------------------------------------------------
// Nodes are a fourth of the mean distance of picks apart along both axes, but there are 8 to 150 of them. The mean plane
// is subtracted, so that the plate of a plane is exact.
FaultPlate::Segments FaultPlate::MakeGrid(const FaultPicks& picks)
{
  Segments segments;
  std::array<double, 2> least = { NoReach, NoReach }, greatest = { -NoReach, -NoReach };
  double rise = 0.0;
  Eigen::MatrixX3d places(2 * std::ptrdiff_t(picks.Segments.size()), 3);
  Eigen::VectorXd offsets(places.rows());
  for (const auto& [from, to] : picks.Segments)
  {
    segments.push_back({ this->ToPlace(from), this->ToPlace(to) });
    rise += std::abs(to.z() - from.z()) / double(picks.Segments.size());
    for (std::size_t end : { 0, 1 })
    {
      const FaultPlace& place = segments.back()[end];
      least = { std::min(least[0], place.S), std::min(least[1], place.Z) };
      greatest = { std::max(greatest[0], place.S), std::max(greatest[1], place.Z) };
      const std::ptrdiff_t row = 2 * std::ptrdiff_t(segments.size() - 1) + std::ptrdiff_t(end);
      places.row(row) << 1.0, place.S, place.Z;
      offsets(row) = place.N;
    }
  }
  const Eigen::Vector3d plane = SolveLeastSquares(places, offsets).Unknowns;
  this->Plane = plane.tail<2>();
  this->Origin.head<2>() += plane(0) * this->Across;
  for (std::array<FaultPlace, 2>& segment : segments)
  {
    segment[0].N -= plane(0);
    segment[1].N -= plane(0);
  }
  const double width = greatest[0] - least[0], height = greatest[1] - least[1];
  const double across = picks.Spacing > 0.0 ? picks.Spacing : width / std::sqrt(double(segments.size()));
  const auto nodes = [](double length, double step)
  { return std::size_t(std::clamp(4.0 * length / std::max(step, 1e-3 * length), 8.0, 150.0)); };
  this->Grid[0].Size = nodes(width, across);
  this->Grid[1].Size = std::min(nodes(height, rise), MostNodes / this->Grid[0].Size);
  for (const std::size_t axis : { 0, 1 })
  {
    const double margin = axis == 0 ? 0.5 * picks.Spacing : 0.0;
    this->Grid[axis].First = least[axis] - margin;
    this->Grid[axis].Step = (greatest[axis] - least[axis] + 2.0 * margin) / double(this->Grid[axis].Size - 1);
  }
  return segments;
}

//----------------------------------------------------------------------------------------------------------------------
// Between two levels, the fault reaches as far as the outermost picks there.
void FaultPlate::FindExtent(const Segments& segments, double margin)
{
  const Axis& axis = this->Grid[1];
  this->Extent.assign(axis.Size - 1, { NoReach, -NoReach });
  for (const auto& [from, to] : segments)
  {
    const double low = std::min(from.Z, to.Z), high = std::max(from.Z, to.Z);
    if (high < axis.First || low > axis.At(axis.Size - 1))
    {
      continue;
    }
    const auto placeAt = [&from = from, &to = to](double z) {
      return from.Z == to.Z ? from.S : from.S + (to.S - from.S) * std::clamp((z - from.Z) / (to.Z - from.Z), 0.0, 1.0);
    };
    for (std::size_t level = axis.Interval(low); level <= axis.Interval(high); ++level)
    {
      for (const double s : { placeAt(axis.At(level)), placeAt(axis.At(level + 1)), low == high ? to.S : placeAt(low) })
      {
        this->Extent[level] = { std::min(this->Extent[level][0], s - margin),
          std::max(this->Extent[level][1], s + margin) };
      }
    }
  }
  this->Ends = { NoReach, -NoReach };
  for (const std::array<double, 2>& range : this->Extent)
  {
    this->Ends = { std::min(this->Ends[0], range[0]), std::max(this->Ends[1], range[1]) };
  }
  if (!(this->Ends[0] <= this->Ends[1]))
  {
    throw InputError("fault " + this->OwnName +
      " with a closed line beyond the heights of its sticks, expected a tip "
      "loop around them");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FaultPlate::Fit(const Segments& segments, const Monitor& monitor)
{
  const auto width = std::int32_t(this->Grid[0].Size), height = std::int32_t(this->Grid[1].Size);
  std::vector<BoxRun> runs;
  for (std::int32_t row = 0; row < height; ++row)
  {
    runs.push_back({ row, 0, width - 1 });
  }
  SiteSystem<2> system(SiteBox::Fill(runs));
  const auto isIn = [&system](std::int64_t place) { return system.Sites.Number[std::size_t(place)] != NoSite; };
  const auto always = [](auto...) { return true; };
  ForEachPlateStencil(*system.Sites.Near, isIn, always, always,
    [&system](std::int64_t place, const auto& terms, double weight) { AddSquare(system, place, terms, weight); });
  this->Values.assign(system.Sites.Size(), 0.0);
  for (std::size_t site = 0; site < this->Values.size(); ++site)
  {
    system.Matrix[site][StencilMatrix<2>::Centre] += Held;
  }
  for (const auto& [from, to] : segments)
  {
    const double steps = std::ceil(
      2.0 * std::max(std::abs(to.S - from.S) / this->Grid[0].Step, std::abs(to.Z - from.Z) / this->Grid[1].Step));
    for (double n = 0.0; n <= steps; ++n)
    {
      const double part = steps > 0.0 ? n / steps : 0.0;
      const double s = from.S + part * (to.S - from.S), z = from.Z + part * (to.Z - from.Z);
      const double offset = from.N + part * (to.N - from.N) - this->Plane.dot(Eigen::Vector2d(s, z));
      const auto [x, a] = this->Grid[0].Find(s);
      const auto [y, b] = this->Grid[1].Find(z);
      const std::array<PlateTerm, 4> corners = { { { 0, 0, (1.0 - a) * (1.0 - b) }, { 1, 0, a * (1.0 - b) },
        { 0, 1, (1.0 - a) * b }, { 1, 1, a * b } } };
      AddSquare(system, system.Sites.Near->Find({ std::int32_t(x), std::int32_t(y) }), corners, SpringsPerBend);
      for (const PlateTerm& corner : corners)
      {
        this->Values[(y + std::size_t(corner.Y)) * this->Grid[0].Size + x + std::size_t(corner.X)] +=
          SpringsPerBend * corner.Coefficient * offset;
      }
    }
  }
  MakeSiteSolver<2>(system)->Solve(this->Values, monitor);
  for (const std::array<FaultPlace, 2>& segment : segments)
  {
    for (const FaultPlace& place : segment)
    {
      this->Miss = std::max(this->Miss, std::abs(this->Distance(place)));
      this->Turn = std::max(this->Turn, std::abs(this->Gradient(place.S, place.Z).x()));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
FaultPlate FaultPlate::Moved(const Eigen::Isometry2d& move) const
{
  FaultPlate moved = *this;
  moved.Origin.head<2>() = move * this->Origin.head<2>();
  moved.Along = move.linear() * this->Along;
  moved.Across = move.linear() * this->Across;
  moved.OnMap = Eigen::AlignedBox2d();
  for (int corner = 0; corner < 4; ++corner)
  {
    moved.OnMap.extend(move * this->OnMap.corner(Eigen::AlignedBox2d::CornerType(corner)));
  }
  return moved;
}

//----------------------------------------------------------------------------------------------------------------------
FaultPlate FaultPlate::Reversed() const
{
  FaultPlate reversed = *this;
  reversed.Along = -this->Along;
  reversed.Across = -this->Across;
  reversed.Plane.y() = -this->Plane.y();
  reversed.Grid[0].First = -this->Grid[0].At(this->Grid[0].Size - 1);
  for (auto row = reversed.Values.begin(); row != reversed.Values.end(); row += std::ptrdiff_t(this->Grid[0].Size))
  {
    std::reverse(row, row + std::ptrdiff_t(this->Grid[0].Size));
  }
  std::transform(reversed.Values.begin(), reversed.Values.end(), reversed.Values.begin(), std::negate<double>());
  for (std::array<double, 2>& range : reversed.Extent)
  {
    range = { -range[1], -range[0] };
  }
  reversed.Ends = { -this->Ends[1], -this->Ends[0] };
  return reversed;
}

//----------------------------------------------------------------------------------------------------------------------
FaultPlace FaultPlate::ToPlace(const Eigen::Vector3d& world) const
{
  const Eigen::Vector2d onMap = (world - this->Origin).head<2>();
  return { onMap.dot(this->Along), onMap.dot(this->Across), world.z() - this->Origin.z() };
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Vector3d FaultPlate::ToWorld(const FaultPlace& place) const
{
  Eigen::Vector3d world = this->Origin;
  world.head<2>() += place.S * this->Along + place.N * this->Across;
  world.z() += place.Z;
  return world;
}

//----------------------------------------------------------------------------------------------------------------------
// Beyond the nodes the outermost squares continue.
double FaultPlate::Offset(double s, double z) const
{
  const auto [x, a] = this->Grid[0].Find(s);
  const auto [y, b] = this->Grid[1].Find(z);
  const double* const low = &this->Values[y * this->Grid[0].Size + x];
  const double* const high = low + this->Grid[0].Size;
  return this->Plane.x() * s + this->Plane.y() * z + (1.0 - b) * ((1.0 - a) * low[0] + a * low[1]) +
    b * ((1.0 - a) * high[0] + a * high[1]);
}

//----------------------------------------------------------------------------------------------------------------------
bool FaultPlate::Contains(double s, double z, double margin) const
{
  const Axis& axis = this->Grid[1];
  if (!(z >= axis.First && z <= axis.At(axis.Size - 1)))
  {
    return false;
  }
  const std::array<double, 2>& range = this->Extent[axis.Interval(z)];
  return s >= range[0] - margin && s <= range[1] + margin;
}

//----------------------------------------------------------------------------------------------------------------------
std::array<double, 2> FaultPlate::EndsAt(std::size_t level) const
{
  const std::array<double, 2>& below = this->Extent[level > 0 ? level - 1 : 0];
  const std::array<double, 2>& above = this->Extent[std::min(level, this->Extent.size() - 1)];
  return !(below[0] <= below[1]) ? above
    : !(above[0] <= above[1])    ? below
                                 : std::array<double, 2>{ 0.5 * (below[0] + above[0]), 0.5 * (below[1] + above[1]) };
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Vector2d FaultPlate::Gradient(double s, double z) const
{
  const double ds = 0.5 * this->Grid[0].Step, dz = 0.5 * this->Grid[1].Step;
  return { (this->Offset(s + ds, z) - this->Offset(s - ds, z)) / (2.0 * ds),
    (this->Offset(s, z + dz) - this->Offset(s, z - dz)) / (2.0 * dz) };
}

//----------------------------------------------------------------------------------------------------------------------
double FaultPlate::AreaOf(double width, double height, double s, double z) const
{
  return width * height * std::sqrt(1.0 + this->Gradient(s, z).squaredNorm());
}
}
