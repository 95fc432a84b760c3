// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// For each column of the hole the nearest known point is found. Heights are filled by a plate and a membrane, or by a
// membrane alone, attributes by a membrane.
//
// The plate minimizes u_xx^2 + 2 u_xy^2 + u_yy^2 over all stencils within the hole and its ring that no cut crosses, so
// that the outer rim of the ring is a free edge. With a positive ring weight the ring has unknowns, each held by a
// spring of this strength; otherwise its heights are fixed. A ring that cannot hold a plate, as it is a line or cuts
// leave too few stencils, leaves all to the membrane.

#include "HoleFiller.h"

#include "PlateEnergy.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace SeismicHorizons
{
namespace
{
// Weaker smoothing has no visible effect, but costs digits.
constexpr double LeastRimSmoothing = 1e-6;

//----------------------------------------------------------------------------------------------------------------------

/// A breadth-first search follows uncut links to four neighbours; among equally near points the lowest number wins. The
/// result is empty if a column of the hole reaches none.
std::vector<PointId> FindNearestRim(const HoleRegion& region)
{
  std::vector<PointId> nearest(region.Kind.size(), NoPoint);
  std::vector<std::int32_t> distance(region.Kind.size(), 0);
  std::vector<std::int64_t> front;
  std::vector<std::int64_t> next;
  const auto offer = [&](std::int64_t place, PointId point, std::int32_t steps)
  {
    if (nearest[place] == NoPoint)
    {
      nearest[place] = point;
      distance[place] = steps;
      next.push_back(place);
    }
    else if (distance[place] == steps)
    {
      nearest[place] = std::min(nearest[place], point);
    }
  };
  for (const std::int64_t place : region.HolePlaces)
  {
    region.ForEachLinked(place,
      [&](std::int64_t neighbour)
      {
        if (region.Kind[neighbour] == PlaceKind::Ring)
        {
          offer(place, region.Point[neighbour], 1);
        }
      });
  }
  for (std::int32_t steps = 2; !next.empty(); ++steps)
  {
    front.swap(next);
    next.clear();
    for (const std::int64_t place : front)
    {
      region.ForEachLinked(place,
        [&](std::int64_t neighbour)
        {
          if (region.Kind[neighbour] == PlaceKind::Hole)
          {
            offer(neighbour, nearest[place], steps);
          }
        });
    }
  }
  std::vector<PointId> result(region.HolePlaces.size());
  std::transform(region.HolePlaces.begin(), region.HolePlaces.end(), result.begin(),
    [&](std::int64_t place) { return nearest[place]; });
  return std::find(result.begin(), result.end(), NoPoint) == result.end() ? result : std::vector<PointId>();
}

//----------------------------------------------------------------------------------------------------------------------

template <typename Visitor>
void ForEachStencil(const HoleRegion& region, Visitor&& visit)
{
  ForEachPlateStencil(
    *region.Near, [&](std::int64_t place) { return region.Kind[place] != PlaceKind::Other; },
    [&](std::int64_t place, std::int64_t neighbour) { return region.IsLinked(place, neighbour); },
    [&](std::int64_t place) { return region.IsWholeBlock(place); }, visit);
}

SiteSystem<2> MakePlate(const HoleRegion& region, double ringWeight)
{
  SiteSystem<2> plate(region.MakeSites(ringWeight > 0.0));
  ForEachStencil(
    region, [&](std::int64_t place, const auto& terms, double weight) { AddSquare(plate, place, terms, weight); });
  for (std::size_t site = 0; site < plate.Sites.Size(); ++site)
  {
    if (region.Kind[plate.Sites.Place[site]] == PlaceKind::Ring)
    {
      plate.Matrix[site][StencilMatrix<2>::Centre] += ringWeight;
    }
  }
  return plate;
}

/// Plates with equal places and kinds of places are equal.
std::string KeyOf(const HoleRegion& region)
{
  const std::vector<BoxRun>& runs = region.Near->GetRuns();
  std::string key(reinterpret_cast<const char*>(runs.data()), runs.size() * sizeof(BoxRun));
  key.append(reinterpret_cast<const char*>(region.Kind.data()), region.Kind.size() * sizeof(PlaceKind));
  return key;
}

std::vector<double> PlateRightSide(
  const HoleRegion& region, const SiteBox& sites, double ringWeight, const std::vector<double>& height)
{
  std::vector<double> side(sites.Size(), 0.0);
  if (ringWeight > 0.0)
  {
    for (std::size_t site = 0; site < side.size(); ++site)
    {
      const std::int64_t place = sites.Place[site];
      side[site] = region.Kind[place] == PlaceKind::Ring ? ringWeight * height[place] : 0.0;
    }
    return side;
  }
  ForEachStencil(region,
    [&](std::int64_t place, const auto& terms, double weight)
    {
      double known = 0.0;
      for (const PlateTerm& term : terms)
      {
        const std::int64_t at = region.Near->Beside(place, term.X, term.Y);
        known += region.Kind[at] == PlaceKind::Ring ? term.Coefficient * height[at] : 0.0;
      }
      for (const PlateTerm& term : terms)
      {
        const std::int32_t site = sites.Number[region.Near->Beside(place, term.X, term.Y)];
        if (site != NoSite)
        {
          side[site] -= weight * term.Coefficient * known;
        }
      }
    });
  return side;
}

/// A plate needs three columns that are not on one line.
bool HoldsPlate(const HoleRegion& region)
{
  std::vector<PlanePoint> ends;
  for (std::size_t place = 0; place < region.Kind.size(); ++place)
  {
    if (region.Kind[place] != PlaceKind::Ring)
    {
      continue;
    }
    const PlanePoint column = region.Near->Column(std::int64_t(place));
    if (ends.size() < 2)
    {
      ends.push_back(column);
      continue;
    }
    const std::int64_t area = std::int64_t(ends[1].X - ends[0].X) * (column.Y - ends[0].Y) -
      std::int64_t(ends[1].Y - ends[0].Y) * (column.X - ends[0].X);
    if (area != 0)
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------

/// Each column is the mean of its neighbours along rows and columns that are in the hole or known, and not cut off.
SiteSystem<1> MakeMembrane(const HoleRegion& region, const std::vector<bool>& isKnown)
{
  using Stencil = StencilMatrix<1>;
  SiteSystem<1> membrane(region.MakeSites(false));
  for (std::size_t site = 0; site < membrane.Sites.Size(); ++site)
  {
    const std::int64_t place = membrane.Sites.Place[site];
    region.ForEachLinked(place,
      [&](std::int64_t neighbour)
      {
        const bool isHole = region.Kind[neighbour] == PlaceKind::Hole;
        if (isHole || isKnown[neighbour])
        {
          const std::int64_t step = neighbour - place;
          const std::size_t beside = step * step == 1 ? Stencil::Index(step, 0) : Stencil::Index(0, step > 0 ? 1 : -1);
          membrane.Matrix[site][Stencil::Centre] += 1.0;
          membrane.Matrix[site][beside] = isHole ? -1.0 : 0.0;
        }
      });
  }
  return membrane;
}

class Membrane
{
public:
  Membrane(const HoleRegion& region, std::vector<bool> isKnown)
    : Region(region)
    , IsKnown(std::move(isKnown))
    , System(MakeMembrane(region, this->IsKnown))
    , Solver(this->System)
  {
    assert(this->Solver.IsDefinite());
  }

  void AddTo(std::vector<double>& filled, const std::vector<double>& known, const Monitor& monitor) const
  {
    std::vector<double> values(this->System.Sites.Size(), 0.0);
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      this->Region.ForEachLinked(this->System.Sites.Place[site],
        [&](std::int64_t neighbour) { values[site] += this->IsKnown[neighbour] ? known[neighbour] : 0.0; });
    }
    this->Solver.Solve(values, monitor);
    for (std::size_t n = 0; n < filled.size(); ++n)
    {
      filled[n] += values[this->System.Sites.Number[this->Region.HolePlaces[n]]];
    }
  }

private:
  const HoleRegion& Region;
  const std::vector<bool> IsKnown;
  const SiteSystem<1> System;
  const SiteSolver<1> Solver;
};

//----------------------------------------------------------------------------------------------------------------------

class RegionFiller
{
public:
  RegionFiller(const HoleRegion& region, const HoleFillingOptions& options, HolePlates& plates)
    : Region(region)
    , Options(options)
    , Plates(plates)
    , IsRing(region.Kind.size())
  {
    for (std::size_t place = 0; place < this->IsRing.size(); ++place)
    {
      this->IsRing[place] = region.Kind[place] == PlaceKind::Ring;
    }
    for (const std::int64_t place : region.HolePlaces)
    {
      region.ForEachLinked(place,
        [&](std::int64_t neighbour)
        {
          if (this->IsRing[neighbour])
          {
            this->Rim.push_back(neighbour);
          }
        });
    }
    assert(!this->Rim.empty());
  }

  std::vector<double> FillHeights(const std::vector<double>& heights, const Monitor& monitor)
  {
    // Heights are far from 0, while their differences are small.
    std::vector<double> known = this->AtRing([&](PointId point) { return heights[point]; });
    const double base = this->Mean(known);
    for (double& height : known)
    {
      height -= base;
    }
    std::vector<double> filled(this->Region.HolePlaces.size(), base);
    const bool isPlate = this->Options.Method == FillMethod::Plate && HoldsPlate(this->Region) &&
      this->AddPlate(known, filled, monitor.Step(0.0, 0.8));
    if (!isPlate || this->RingWeight() > 0.0)
    {
      this->RingMembrane().AddTo(filled, isPlate ? this->WithoutNoise(known) : known, monitor.Step(0.8, 1.0));
    }
    return filled;
  }

  std::vector<double> FillAttribute(const PointValue& attribute, const Monitor& monitor)
  {
    // The rim alone holds the membrane.
    std::vector<double> known(this->Region.Kind.size(), 0.0);
    std::size_t finite = 0;
    for (const std::int64_t place : this->Rim)
    {
      known[place] = attribute(this->Region.Point[place]);
      finite += std::isfinite(known[place]) ? 1 : 0;
    }
    std::vector<double> filled(this->Region.HolePlaces.size(), 0.0);
    if (finite == this->Rim.size() && this->IsLevel(known))
    {
      filled.assign(filled.size(), known[this->Rim.front()]);
    }
    else if (finite == this->Rim.size())
    {
      this->RingMembrane().AddTo(filled, known, monitor);
    }
    else if (finite > 0)
    {
      Membrane(this->Region, this->FiniteOnes(known)).AddTo(filled, known, monitor);
    }
    else
    {
      filled.assign(filled.size(), std::numeric_limits<double>::quiet_NaN());
    }
    return filled;
  }

private:
  double RingWeight() const
  {
    return this->Options.RimSmoothing < LeastRimSmoothing ? 0.0 : 1.0 / this->Options.RimSmoothing;
  }

  std::vector<double> AtRing(const PointValue& value) const
  {
    std::vector<double> result(this->Region.Kind.size(), 0.0);
    for (std::size_t place = 0; place < result.size(); ++place)
    {
      result[place] = this->IsRing[place] ? value(this->Region.Point[place]) : 0.0;
    }
    return result;
  }

  double Mean(const std::vector<double>& known) const
  {
    double sum = 0.0;
    std::int64_t count = 0;
    for (std::size_t place = 0; place < known.size(); ++place)
    {
      sum += this->IsRing[place] ? known[place] : 0.0;
      count += this->IsRing[place] ? 1 : 0;
    }
    return sum / double(count);
  }

  bool IsLevel(const std::vector<double>& known) const
  {
    constexpr double rounding = 1e-9;
    const double first = known[this->Rim.front()];
    const double most = rounding * std::max(1.0, std::abs(first));
    return std::all_of(
      this->Rim.begin(), this->Rim.end(), [&](std::int64_t place) { return std::abs(known[place] - first) <= most; });
  }

  std::vector<bool> FiniteOnes(const std::vector<double>& known) const
  {
    std::vector<bool> result = this->IsRing;
    for (std::size_t place = 0; place < known.size(); ++place)
    {
      result[place] = result[place] && std::isfinite(known[place]);
    }
    return result;
  }

  bool AddPlate(std::vector<double>& known, std::vector<double>& filled, const Monitor& monitor) const
  {
    const double weight = this->RingWeight();
    const std::shared_ptr<const HolePlate> plate = this->Plates.Get(this->Region, weight);
    if (!plate->Solver.IsDefinite())
    {
      return false;
    }
    const SiteBox& sites = plate->System.Sites;
    std::vector<double> values = PlateRightSide(this->Region, sites, weight, known);
    plate->Solver.Solve(values, monitor);
    for (std::size_t n = 0; n < filled.size(); ++n)
    {
      filled[n] += values[sites.Number[this->Region.HolePlaces[n]]];
    }
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      known[sites.Place[site]] -= values[site];
    }
    return true;
  }

  /// Under strong springs the residual is surface between the known columns, to be continued; under weak springs it is
  /// mostly noise, to be smoothed.
  std::vector<double> WithoutNoise(const std::vector<double>& rest) const
  {
    const double part = this->Options.RimSmoothing <= 1.0 ? 0.0 : 1.0 - 1.0 / this->Options.RimSmoothing;
    if (part == 0.0)
    {
      return rest;
    }
    std::vector<double> smooth = this->MeansAround(this->MeansAround(rest));
    for (std::size_t place = 0; place < rest.size(); ++place)
    {
      smooth[place] = part * smooth[place] + (1.0 - part) * rest[place];
    }
    return smooth;
  }

  std::vector<double> MeansAround(const std::vector<double>& values) const
  {
    std::vector<double> means(values.size(), 0.0);
    for (std::size_t place = 0; place < values.size(); ++place)
    {
      double sum = 0.0;
      int count = 0;
      for (int n = 0; this->IsRing[place] && n < 9; ++n)
      {
        const std::int64_t neighbour = this->Region.Near->Beside(std::int64_t(place), n % 3 - 1, n / 3 - 1);
        if (this->IsRing[neighbour] && this->Region.CanStep(std::int64_t(place), n % 3 - 1, n / 3 - 1))
        {
          sum += values[neighbour];
          ++count;
        }
      }
      means[place] = count > 0 ? sum / count : 0.0;
    }
    return means;
  }

  const Membrane& RingMembrane()
  {
    if (!this->HeldByRing)
    {
      this->HeldByRing.emplace(this->Region, this->IsRing);
    }
    return *this->HeldByRing;
  }

  const HoleRegion& Region;
  const HoleFillingOptions& Options;
  HolePlates& Plates;
  std::vector<bool> IsRing;
  std::vector<std::int64_t> Rim; // places beside the hole, once for each link to it
  std::optional<Membrane> HeldByRing;
};
}

//----------------------------------------------------------------------------------------------------------------------
HolePlate::HolePlate(const HoleRegion& region, double ringWeight)
  : System(MakePlate(region, ringWeight))
  , Solver(this->System)
{
}

//----------------------------------------------------------------------------------------------------------------------
std::shared_ptr<const HolePlate> HolePlates::Get(const HoleRegion& region, double ringWeight)
{
  if (region.HasCuts() || region.Near->Size() > LargestKept)
  {
    return std::make_shared<const HolePlate>(region, ringWeight);
  }
  const std::string key = KeyOf(region);
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Kept.find(key);
    if (found != this->Kept.end())
    {
      return found->second;
    }
  }
  auto plate = std::make_shared<const HolePlate>(region, ringWeight);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Kept.size() < MostKept)
  {
    this->Kept.emplace(key, plate);
  }
  return plate;
}

//----------------------------------------------------------------------------------------------------------------------
HoleFill FillHole(const HoleRegion& region, const std::vector<double>& heights,
  const std::vector<PointValue>& attributes, const HoleFillingOptions& options, HolePlates& plates,
  const Monitor& monitor)
{
  HoleFill result;
  result.Nearest = FindNearestRim(region);
  if (result.Nearest.empty())
  {
    return result;
  }
  RegionFiller filler(region, options, plates);
  const double parts = double(attributes.size()) + 5.0; // A plate takes about as long as four membranes.
  result.Height = filler.FillHeights(heights, monitor.Step(0.0, 5.0 / parts));
  for (std::size_t n = 0; n < attributes.size(); ++n)
  {
    result.Attribute.push_back(
      filler.FillAttribute(attributes[n], monitor.Step((5.0 + double(n)) / parts, (6.0 + double(n)) / parts)));
  }
  return result;
}
}
