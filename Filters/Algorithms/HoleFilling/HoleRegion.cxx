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

#include "HoleRegion.h"

#include "Common/Horizon/Predicates.h"
#include "PlateEnergy.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
HoleRegion::HoleRegion(
  const ColumnIndex& index, const LinkCuts* cuts, const std::vector<std::int64_t>& hole, int ringWidth)
{
  assert(!hole.empty() && std::is_sorted(hole.begin(), hole.end()));
  std::int64_t leftmost = index.Width();
  std::int64_t rightmost = 0;
  for (const std::int64_t place : hole)
  {
    leftmost = std::min(leftmost, place % index.Width());
    rightmost = std::max(rightmost, place % index.Width());
  }
  const std::int64_t margin = ringWidth + SiteBox::Margin;
  const std::int64_t bottom = hole.front() / index.Width();
  const std::int64_t top = hole.back() / index.Width();
  this->First = (bottom - margin) * index.Width() + leftmost - margin;
  this->Turned = rightmost - leftmost > top - bottom;
  const auto inBox = [&](std::int64_t place)
  {
    const auto x = std::int32_t(place % index.Width() - (leftmost - margin));
    const auto y = std::int32_t(place / index.Width() - (bottom - margin));
    return this->Turned ? PlanePoint{ y, x } : PlanePoint{ x, y };
  };
  std::vector<BoxRun> runs;
  for (const std::int64_t place : hole)
  {
    const PlanePoint column = inBox(place);
    runs.push_back({ column.Y, column.X, column.X });
  }
  this->Near = std::make_shared<const BoxPlaces>(runs, int(margin));
  this->Kind.assign(std::size_t(this->Near->Size()), PlaceKind::Other);
  this->Point.assign(this->Kind.size(), NoPoint);
  this->HolePlaces.reserve(hole.size());
  for (const std::int64_t place : hole)
  {
    this->HolePlaces.push_back(this->Near->Find(inBox(place)));
    this->Kind[this->HolePlaces.back()] = PlaceKind::Hole;
  }
  if (cuts)
  {
    this->ReadCuts(index, *cuts);
  }
  this->AddRing(index, ringWidth);
}

//----------------------------------------------------------------------------------------------------------------------
void HoleRegion::ReadCuts(const ColumnIndex& index, const LinkCuts& cuts)
{
  this->Cuts.resize(this->Kind.size());
  for (std::size_t place = 0; place < this->Cuts.size(); ++place)
  {
    const PlanePoint column = index.GivenColumn(this->InIndex(std::int64_t(place), index));
    const bool east = cuts.IsCutEast(column);
    const bool north = cuts.IsCutNorth(column);
    this->Cuts[place] = static_cast<unsigned char>(
      ((this->Turned ? north : east) ? EastBit : 0) | ((this->Turned ? east : north) ? NorthBit : 0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool HoleRegion::CanStep(std::int64_t place, int dx, int dy) const
{
  if (!this->HasCuts() || (dx == 0 && dy == 0))
  {
    return true;
  }
  if (dx == 0 || dy == 0)
  {
    return this->IsLinked(place, this->Near->Beside(place, dx, dy));
  }
  return this->IsWholeBlock(this->Near->Beside(place, dx < 0 ? -1 : 0, dy < 0 ? -1 : 0));
}

//----------------------------------------------------------------------------------------------------------------------
void HoleRegion::AddRing(const ColumnIndex& index, int ringWidth)
{
  std::vector<bool> reached(this->Kind.size(), false);
  std::vector<std::int64_t> front = this->HolePlaces;
  for (const std::int64_t place : front)
  {
    reached[place] = true;
  }
  std::vector<std::int64_t> next;
  for (int step = 0; step < ringWidth; ++step)
  {
    for (const std::int64_t place : front)
    {
      for (int n = 0; n < 9; ++n)
      {
        const std::int64_t neighbour = this->Near->Beside(place, n % 3 - 1, n / 3 - 1);
        if (!reached[neighbour] && this->CanStep(place, n % 3 - 1, n / 3 - 1))
        {
          reached[neighbour] = true;
          next.push_back(neighbour);
          const PointId point = index[this->InIndex(neighbour, index)];
          this->Point[neighbour] = point;
          this->Kind[neighbour] = point == NoPoint ? PlaceKind::Other : PlaceKind::Ring;
        }
      }
    }
    front.swap(next);
    next.clear();
  }
}

//----------------------------------------------------------------------------------------------------------------------
SiteBox HoleRegion::MakeSites(bool withRing) const
{
  SiteBox box(this->Near);
  for (std::size_t place = 0; place < this->Kind.size(); ++place)
  {
    if (this->Kind[place] == PlaceKind::Hole || (withRing && this->Kind[place] == PlaceKind::Ring))
    {
      box.Add(std::int64_t(place));
    }
  }
  return box;
}

namespace
{
// Weaker smoothing has no visible effect, but costs digits.
constexpr double LeastRimSmoothing = 1e-6;

// ---- The nearest known points ---------------------------------------------------------------------------------------

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

// ---- Plates ---------------------------------------------------------------------------------------------------------

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
std::string KeyOfRegion(const HoleRegion& region)
{
  const std::vector<BoxRun>& runs = region.Near->Runs;
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
    if (SignedArea(ends[0], ends[1], column) != 0)
    {
      return true;
    }
  }
  return false;
}

// ---- Membranes ------------------------------------------------------------------------------------------------------

/// Each column is the mean of its neighbours along rows and columns that are in the hole or known, and not cut off.
/// Values are NaN where they are unknown.
SiteSystem<1> MakeMembrane(const HoleRegion& region, const std::vector<double>& known)
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
        if (isHole || !std::isnan(known[neighbour]))
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
  Membrane(const HoleRegion& region, const std::vector<double>& known)
    : Region(region)
    , System(MakeMembrane(region, known))
    , Solver(MakeSiteSolver(this->System))
  {
    assert(this->Solver->IsDefinite());
  }

  /// The same values must be known.
  void AddTo(std::vector<double>& filled, const std::vector<double>& known, const Monitor& monitor) const
  {
    std::vector<double> values(this->System.Sites.Size(), 0.0);
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      this->Region.ForEachLinked(this->System.Sites.Place[site],
        [&](std::int64_t neighbour) { values[site] += std::isnan(known[neighbour]) ? 0.0 : known[neighbour]; });
    }
    this->Solver->Solve(values, monitor);
    for (std::size_t n = 0; n < filled.size(); ++n)
    {
      filled[n] += values[this->System.Sites.Number[this->Region.HolePlaces[n]]];
    }
  }

private:
  const HoleRegion& Region;
  const SiteSystem<1> System;
  const std::unique_ptr<const SiteSolver> Solver;
};

// ---- Filling --------------------------------------------------------------------------------------------------------

class RegionFiller
{
public:
  RegionFiller(const HoleRegion& region, const HoleFillingOptions& options, HolePlates& plates)
    : Region(region)
    , Options(options)
    , Plates(plates)
  {
    for (const std::int64_t place : region.HolePlaces)
    {
      region.ForEachLinked(place,
        [&](std::int64_t neighbour)
        {
          if (region.Kind[neighbour] == PlaceKind::Ring)
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
    std::vector<double> known(this->Region.Kind.size(), NoValue);
    double sum = 0.0;
    std::int64_t count = 0;
    for (std::size_t place = 0; place < known.size(); ++place)
    {
      if (this->Region.Kind[place] == PlaceKind::Ring)
      {
        known[place] = heights[this->Region.Point[place]];
        assert(std::isfinite(known[place]));
        sum += known[place];
        ++count;
      }
    }
    const double base = sum / double(count);
    for (double& height : known)
    {
      height -= base;
    }
    std::vector<double> filled(this->Region.HolePlaces.size(), base);
    const bool isPlate = this->Options.Method == FillMethod::Plate && HoldsPlate(this->Region) &&
      this->AddPlate(known, filled, monitor.Step(0.0, 0.8));
    if (!isPlate || this->RingWeight() > 0.0)
    {
      this->RingMembrane(known).AddTo(filled, isPlate ? this->WithoutNoise(known) : known, monitor.Step(0.8, 1.0));
    }
    return filled;
  }

  std::vector<double> FillAttribute(const PointValue& attribute, const Monitor& monitor)
  {
    // The rim alone holds the membrane.
    std::vector<double> known(this->Region.Kind.size(), NoValue);
    std::size_t finite = 0;
    for (const std::int64_t place : this->Rim)
    {
      const double value = attribute(this->Region.Point[place]);
      known[place] = std::isfinite(value) ? value : NoValue;
      finite += std::isfinite(value) ? 1 : 0;
    }
    std::vector<double> filled(this->Region.HolePlaces.size(), finite == 0 ? NoValue : 0.0);
    if (finite == this->Rim.size() && this->IsLevel(known))
    {
      filled.assign(filled.size(), known[this->Rim.front()]);
    }
    else if (finite == this->Rim.size())
    {
      this->RingMembrane(known).AddTo(filled, known, monitor);
    }
    else if (finite > 0)
    {
      Membrane(this->Region, known).AddTo(filled, known, monitor);
    }
    return filled;
  }

private:
  double RingWeight() const
  {
    return this->Options.RimSmoothing < LeastRimSmoothing ? 0.0 : 1.0 / this->Options.RimSmoothing;
  }

  bool IsLevel(const std::vector<double>& known) const
  {
    constexpr double rounding = 1e-9;
    const double first = known[this->Rim.front()];
    const double most = rounding * std::max(1.0, std::abs(first));
    return std::all_of(
      this->Rim.begin(), this->Rim.end(), [&](std::int64_t place) { return std::abs(known[place] - first) <= most; });
  }

  bool AddPlate(std::vector<double>& known, std::vector<double>& filled, const Monitor& monitor) const
  {
    const double weight = this->RingWeight();
    const std::shared_ptr<const HolePlate> plate = this->Plates.Get(this->Region, weight);
    if (!plate->Solver->IsDefinite())
    {
      return false;
    }
    const SiteBox& sites = plate->System.Sites;
    std::vector<double> values = PlateRightSide(this->Region, sites, weight, known);
    plate->Solver->Solve(values, monitor);
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
    std::vector<double> means(values.size(), NoValue);
    for (std::size_t place = 0; place < values.size(); ++place)
    {
      if (this->Region.Kind[place] != PlaceKind::Ring)
      {
        continue;
      }
      double sum = 0.0;
      int count = 0;
      for (int n = 0; n < 9; ++n)
      {
        const std::int64_t neighbour = this->Region.Near->Beside(std::int64_t(place), n % 3 - 1, n / 3 - 1);
        if (this->Region.Kind[neighbour] == PlaceKind::Ring &&
          this->Region.CanStep(std::int64_t(place), n % 3 - 1, n / 3 - 1))
        {
          sum += values[neighbour];
          ++count;
        }
      }
      means[place] = sum / count;
    }
    return means;
  }

  /// Values are known at the whole ring, or at least at its rim.
  const Membrane& RingMembrane(const std::vector<double>& known)
  {
    if (!this->HeldByRing)
    {
      this->HeldByRing.emplace(this->Region, known);
    }
    return *this->HeldByRing;
  }

  const HoleRegion& Region;
  const HoleFillingOptions& Options;
  HolePlates& Plates;
  std::vector<std::int64_t> Rim; // places beside the hole, once for each link to it
  std::optional<Membrane> HeldByRing;
};
}

//----------------------------------------------------------------------------------------------------------------------
HolePlate::HolePlate(const HoleRegion& region, double ringWeight)
  : System(MakePlate(region, ringWeight))
  , Solver(MakeSiteSolver(this->System))
{
}

//----------------------------------------------------------------------------------------------------------------------
std::shared_ptr<const HolePlate> HolePlates::Get(const HoleRegion& region, double ringWeight)
{
  if (region.HasCuts() || region.Near->Size() > LargestKept)
  {
    return std::make_shared<const HolePlate>(region, ringWeight);
  }
  const std::string key = KeyOfRegion(region);
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
void FillHole(const HoleRegion& region, const std::vector<double>& heights, const std::vector<PointValue>& attributes,
  const HoleFillingOptions& options, HolePlates& plates, std::size_t entry, FilledColumns& result,
  const Monitor& monitor)
{
  assert(entry + region.HolePlaces.size() <= result.Height.size() && attributes.size() == result.Attribute.size());
  const std::vector<PointId> nearest = FindNearestRim(region);
  if (nearest.empty())
  {
    return;
  }
  const auto write = [entry](const auto& values, auto& target)
  { std::copy(values.begin(), values.end(), target.begin() + std::ptrdiff_t(entry)); };
  write(nearest, result.Nearest);
  RegionFiller filler(region, options, plates);
  const double parts = double(attributes.size()) + 5.0; // A plate takes about as long as four membranes.
  write(filler.FillHeights(heights, monitor.Step(0.0, 5.0 / parts)), result.Height);
  for (std::size_t n = 0; n < attributes.size(); ++n)
  {
    const Monitor part = monitor.Step((5.0 + double(n)) / parts, (6.0 + double(n)) / parts);
    write(filler.FillAttribute(attributes[n], part), result.Attribute[n]);
  }
}
}
