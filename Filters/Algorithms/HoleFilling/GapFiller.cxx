// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapFiller.h"

#include "GapSystems.h"
#include "NearestRim.h"
#include "SiteSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace SeismicHorizons
{
namespace
{
// Springs of a millionth of the least smoothing that shows would only cost digits.
constexpr double LeastRimSmoothing = 1e-6;

/// Whether three of the columns of the ring are not on one line, as it takes to hold a plate.
bool HoldsPlate(const GapRegion& region)
{
  std::vector<PlanePoint> ends; // the first two columns
  for (std::size_t place = 0; place < region.Kind.size(); ++place)
  {
    if (region.Kind[place] != PlaceKind::Ring)
    {
      continue;
    }
    const PlanePoint column = { std::int32_t(std::int64_t(place) % region.Width),
      std::int32_t(std::int64_t(place) / region.Width) };
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

/// A membrane that is held at some places of the ring, and solves for any values there.
class Membrane
{
public:
  Membrane(const GapRegion& region, std::vector<bool> isKnown)
    : Region(region)
    , IsKnown(std::move(isKnown))
    , System(MakeMembrane(region, this->IsKnown))
    , Solver(this->System)
  {
  }

  /// The values of the sites, in the order of their places.
  std::vector<double> Fill(const std::vector<double>& atPlaces, const Monitor& monitor) const
  {
    std::vector<double> values = MembraneRightSide(this->Region, this->System, this->IsKnown, atPlaces);
    this->Solver.Solve(values, monitor);
    return values;
  }

  double At(const std::vector<double>& values, std::int64_t place) const
  {
    return values[std::size_t(this->System.Sites.Number[std::size_t(place)])];
  }

private:
  const GapRegion& Region;
  const std::vector<bool> IsKnown;
  const MembraneSystem System;
  const SiteSolver<1> Solver;
};

class GapFiller
{
public:
  GapFiller(const GapRegion& region, const HoleFillingOptions& options)
    : Region(region)
    , Options(options)
    , IsRing(region.Kind.size())
  {
    for (std::size_t place = 0; place < this->IsRing.size(); ++place)
    {
      this->IsRing[place] = region.Kind[place] == PlaceKind::Ring;
    }
    for (const std::int64_t place : region.GapPlaces)
    {
      for (const std::int64_t neighbour : region.Neighbours(place))
      {
        if (this->IsRing[std::size_t(neighbour)] && region.IsLinked(place, neighbour))
        {
          this->Rim.push_back(std::size_t(neighbour));
        }
      }
    }
  }

  std::vector<double> FillHeights(const std::vector<double>& heights, const Monitor& monitor)
  {
    // Heights are far from 0, and their differences small.
    std::vector<double> known = this->AtRing([&](PointId point) { return heights[std::size_t(point)]; });
    const double base = this->Mean(known);
    for (double& height : known)
    {
      height -= base;
    }
    std::vector<double> filled(this->Region.GapPlaces.size(), base);
    const bool isPlate = this->Options.Method == FillMethod::Plate && HoldsPlate(this->Region) &&
      this->AddPlate(known, filled, monitor.Step(0.0, 0.8));
    if (!isPlate || this->RingWeight() > 0.0)
    {
      this->AddMembrane(
        this->RingMembrane(), isPlate ? this->WithoutNoise(known) : known, filled, monitor.Step(0.8, 1.0));
    }
    return filled;
  }

  std::vector<double> FillAttribute(const PointValue& attribute, const Monitor& monitor)
  {
    // A membrane is held by the rim alone.
    std::vector<double> known(this->Region.Kind.size(), 0.0);
    std::size_t finite = 0;
    for (const std::size_t place : this->Rim)
    {
      known[place] = attribute(this->Region.Point[place]);
      finite += std::isfinite(known[place]) ? 1 : 0;
    }
    std::vector<double> filled(this->Region.GapPlaces.size(), 0.0);
    if (finite == this->Rim.size() && this->IsLevel(known))
    {
      filled.assign(filled.size(), known[this->Rim.front()]);
    }
    else if (finite == this->Rim.size())
    {
      this->AddMembrane(this->RingMembrane(), known, filled, monitor);
    }
    else if (finite > 0)
    {
      this->AddMembrane(Membrane(this->Region, this->FiniteOnes(known)), known, filled, monitor);
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

  /// Whether all values of the rim are the same, but for rounding: so are those of heights, less what the surface has.
  bool IsLevel(const std::vector<double>& known) const
  {
    constexpr double rounding = 1e-9;
    const double first = known[this->Rim.front()];
    const double most = rounding * std::max(1.0, std::abs(first));
    return std::all_of(
      this->Rim.begin(), this->Rim.end(), [&](std::size_t place) { return std::abs(known[place] - first) <= most; });
  }

  /// The places of the ring whose values are finite.
  std::vector<bool> FiniteOnes(const std::vector<double>& known) const
  {
    std::vector<bool> result = this->IsRing;
    for (std::size_t place = 0; place < known.size(); ++place)
    {
      result[place] = result[place] && std::isfinite(known[place]);
    }
    return result;
  }

  /// Adds the plate to the filled heights, and takes it from those of the ring. False when nothing holds it.
  bool AddPlate(std::vector<double>& known, std::vector<double>& filled, const Monitor& monitor) const
  {
    const double weight = this->RingWeight();
    const PlateSystem plate = MakePlate(this->Region, weight);
    const SiteSolver<2> solver(plate);
    if (!solver.IsDefinite())
    {
      return false;
    }
    std::vector<double> values = PlateRightSide(this->Region, plate, weight, known);
    solver.Solve(values, monitor);
    for (std::size_t n = 0; n < filled.size(); ++n)
    {
      filled[n] += values[std::size_t(plate.Sites.Number[std::size_t(this->Region.GapPlaces[n])])];
    }
    for (std::size_t site = 0; site < values.size(); ++site)
    {
      known[std::size_t(plate.Sites.Place[site])] -= values[site];
    }
    return true;
  }

  /// What is left at the ring, smoothed itself where there is much noise: of strong springs it is the surface between
  /// the known columns, which has to be carried on; of weak ones mostly noise.
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

  /// The mean of each place of the ring and those of its eight neighbours that are of the ring.
  std::vector<double> MeansAround(const std::vector<double>& values) const
  {
    std::vector<double> means(values.size(), 0.0);
    for (std::size_t place = 0; place < values.size(); ++place)
    {
      double sum = 0.0;
      int count = 0;
      for (int n = 0; this->IsRing[place] && n < 9; ++n)
      {
        const std::size_t neighbour =
          place + std::size_t((n / 3 - 1) * this->Region.Width + (n % 3 - 1)); // around 0 where negative
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

  void AddMembrane(const Membrane& membrane, const std::vector<double>& known, std::vector<double>& filled,
    const Monitor& monitor) const
  {
    const std::vector<double> values = membrane.Fill(known, monitor);
    for (std::size_t n = 0; n < filled.size(); ++n)
    {
      filled[n] += membrane.At(values, this->Region.GapPlaces[n]);
    }
  }

  const Membrane& RingMembrane()
  {
    if (!this->HeldByRing)
    {
      this->HeldByRing.emplace(this->Region, this->IsRing);
    }
    return *this->HeldByRing;
  }

  const GapRegion& Region;
  const HoleFillingOptions& Options;
  std::vector<bool> IsRing;
  std::vector<std::size_t> Rim; // places of the ring beside the gap, once for each link to it
  std::optional<Membrane> HeldByRing;
};
}

//----------------------------------------------------------------------------------------------------------------------
GapFill FillGap(const GapRegion& region, const std::vector<double>& heights, const std::vector<PointValue>& attributes,
  const HoleFillingOptions& options, const Monitor& monitor)
{
  GapFill result;
  result.Nearest = FindNearestRim(region);
  if (result.Nearest.empty())
  {
    return result;
  }
  GapFiller filler(region, options);
  const double parts = double(attributes.size()) + 5.0; // a plate takes about as long as four membranes
  result.Height = filler.FillHeights(heights, monitor.Step(0.0, 5.0 / parts));
  for (std::size_t n = 0; n < attributes.size(); ++n)
  {
    result.Attribute.push_back(
      filler.FillAttribute(attributes[n], monitor.Step((5.0 + double(n)) / parts, (6.0 + double(n)) / parts)));
  }
  return result;
}
}
