// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaceFit.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Survey/LineLattice.h"
#include "Common/Survey/StrayPicks.h"
#include "Common/Survey/SurveyMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <optional>
#include <random>
#include <sstream>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t FittedPlaces = 1000;

class Distances
{
public:
  Distances(const PickPlaces& picks, const LineNumbering& numbering, const PlaneMap& map)
    : Picks(picks)
    , Numbering(numbering)
    , Origin(map.Origin)
    , ToColumns(map.Steps.inverse())
  {
  }

  double operator[](std::size_t pick) const
  {
    const Eigen::Vector2d place(this->Picks.X[pick], this->Picks.Y[pick]);
    const Eigen::Vector2d index = LineIndex(this->Numbering, this->Picks.Crossline[pick], this->Picks.Inline[pick]);
    return (this->ToColumns * (place - this->Origin) - index).cwiseAbs().maxCoeff();
  }

  double Largest() const
  {
    double largest = 0.0;
    for (std::size_t pick = 0; pick < this->Picks.X.size(); ++pick)
    {
      largest = std::max(largest, (*this)[pick]);
    }
    return largest;
  }

  std::vector<std::size_t> Beyond(double tolerance) const
  {
    std::vector<std::size_t> strays;
    for (std::size_t pick = 0; pick < this->Picks.X.size(); ++pick)
    {
      if (!((*this)[pick] <= tolerance))
      {
        strays.push_back(pick);
      }
    }
    return strays;
  }

private:
  const PickPlaces& Picks;
  const LineNumbering& Numbering;
  const Eigen::Vector2d Origin;
  const Eigen::Matrix2d ToColumns;
};

/// The best of many maps through three picks has most inliers.
std::optional<PlaneMap> FindConsensus(const PickPlaces& picks, const LineNumbering& numbering, double tolerance)
{
  constexpr int tries = 64; // With 10 % of strays each try fails with a probability of a quarter.
  const std::size_t count = picks.X.size();
  std::mt19937 random(1); // A fixed seed makes results reproducible.
  std::optional<PlaneMap> best;
  std::size_t fewest = count;
  for (int n = 0; n < tries; ++n)
  {
    PlaneFit fit;
    const std::size_t first = random() % count;
    const Eigen::Vector2d middle(picks.X[first], picks.Y[first]);
    for (const std::size_t pick : { first, std::size_t(random() % count), std::size_t(random() % count) })
    {
      fit.Add(LineIndex(numbering, picks.Crossline[pick], picks.Inline[pick]),
        Eigen::Vector2d(picks.X[pick], picks.Y[pick]) - middle);
    }
    std::optional<PlaneMap> map = fit.Solve();
    map = map ? map : fit.SolveAlongLine();
    if (map && !AreParallel(map->Steps.col(0), map->Steps.col(1)))
    {
      map->Origin += middle;
      const std::size_t strays = Distances(picks, numbering, *map).Beyond(tolerance).size();
      best = strays < fewest ? map : best;
      fewest = std::min(fewest, strays);
    }
  }
  return best;
}

PickPlaces Sample(const PickPlaces& picks)
{
  PickPlaces some;
  const std::size_t stride = std::max<std::size_t>(1, picks.X.size() / FittedPlaces);
  for (std::size_t pick = 0; pick < picks.X.size(); pick += stride)
  {
    some.Inline.push_back(picks.Inline[pick]);
    some.Crossline.push_back(picks.Crossline[pick]);
    some.X.push_back(picks.X[pick]);
    some.Y.push_back(picks.Y[pick]);
  }
  return some;
}

/// If strays are too many, returns a distance beyond the tolerance. `ofAll` is the fit of all places.
PlaceFit FitWithoutStrays(const PickPlaces& picks, const LineNumbering& numbering, double tolerance,
  const PlaceFit& ofAll, const Monitor& monitor)
{
  // Maps through three places exaggerate their rounding.
  const std::optional<PlaneMap> consensus = FindConsensus(Sample(picks), numbering, 2.0 * tolerance);
  if (!consensus)
  {
    return ofAll;
  }
  PlaceFit fit;
  fit.ToWorld = *consensus;
  double allowed = 2.0 * tolerance;
  std::vector<std::size_t> strays;
  for (int pass = 0; pass < 3; ++pass, allowed = tolerance)
  {
    strays = Distances(picks, numbering, fit.ToWorld).Beyond(allowed);
    if (double(strays.size()) > std::max(1.0, MostStrays * double(picks.X.size())) ||
      picks.X.size() < strays.size() + 4)
    {
      return ofAll;
    }
    fit.ToWorld = FitPlaces(WithoutPicks(picks, strays), numbering, monitor);
  }
  strays = Distances(picks, numbering, fit.ToWorld).Beyond(tolerance);
  fit.Strays = std::int64_t(strays.size());
  fit.FirstStray = strays.empty() ? 0 : strays.front();
  fit.LargestDistance = Distances(WithoutPicks(picks, strays), numbering, fit.ToWorld).Largest();
  return fit;
}

}

//----------------------------------------------------------------------------------------------------------------------
PlaceFit FitLattice(const PickPlaces& picks, const LineNumbering& numbering, const std::string& what, double tolerance,
  const Monitor& monitor)
{
  PlaceFit fit;
  fit.ToWorld = FitPlaces(picks, numbering, monitor);
  if (AreParallel(fit.ToWorld.Steps.col(0), fit.ToWorld.Steps.col(1)))
  {
    throw InputError(what + "on one line, expected some that span a lattice");
  }
  fit.LargestDistance = Distances(picks, numbering, fit.ToWorld).Largest();
  if (!(fit.LargestDistance <= tolerance))
  {
    fit = FitWithoutStrays(picks, numbering, tolerance, fit, monitor);
  }
  if (!(fit.LargestDistance <= tolerance))
  {
    std::ostringstream text;
    text.precision(3);
    text << what << "up to " << fit.LargestDistance << " columns away from their columns, expected at most "
         << tolerance;
    throw InputError(text.str());
  }
  return fit;
}

//----------------------------------------------------------------------------------------------------------------------
double LargestDistance(const PickPlaces& picks, const LineNumbering& numbering, const PlaneMap& map)
{
  return Distances(picks, numbering, map).Largest();
}

//----------------------------------------------------------------------------------------------------------------------
bool FollowsLines(const PlaneMap& map, const LineNumbering& numbering, double scale)
{
  constexpr double rounding = 1e-6; // Fraction of a step.
  const auto follows = [&](const Eigen::Vector2d& step, double lineStep)
  {
    const Eigen::Vector2d size = step.cwiseAbs() / std::abs(lineStep);
    const auto isStep = [&](double part)
    { return std::abs(part - 1.0) < rounding || std::abs(part / scale - 1.0) < rounding; };
    return std::min(size.x(), size.y()) < rounding && isStep(size.maxCoeff());
  };
  return follows(map.Steps.col(0), numbering.CrosslineStep) && follows(map.Steps.col(1), numbering.InlineStep);
}
}
