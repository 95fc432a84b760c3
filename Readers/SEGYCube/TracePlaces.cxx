// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracePlaces.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Survey/LineLattice.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/StrayPicks.h"
#include "Common/Survey/SurveyMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr double IrregularTolerance = 0.55; // In columns: midpoints are within half a bin, and the fit is not exact.

// ---- Places as picks ------------------------------------------------------------------------------------------------
/// Places are sampled where some suffice.
std::int64_t SamplingStride(const TraceTable& table)
{
  constexpr std::int64_t sampledPlaces = 1000;
  return std::max<std::int64_t>(1, table.Traces / sampledPlaces);
}

/// Returns the traces with a place, or every n-th of them.
PickPlaces ListPlaces(const LineNumbers& lines, const FieldPair& fields, std::int64_t stride = 1)
{
  PickPlaces picks;
  for (std::int64_t trace = 0; trace < lines.Table.Traces; trace += stride)
  {
    if (HasPlace(lines, fields, trace))
    {
      const Eigen::Vector2d place = TracePlace(lines.Table, fields, trace);
      picks.Inline.push_back(lines.Inline(trace));
      picks.Crossline.push_back(lines.Crossline(trace));
      picks.X.push_back(place.x());
      picks.Y.push_back(place.y());
    }
  }
  return picks;
}

/// Returns the distance of each pick from its column, in columns.
std::vector<double> FindDistances(const PickPlaces& picks, const LineNumbering& numbering, const PlaneMap& map)
{
  const Eigen::Matrix2d toColumns = map.Steps.inverse();
  std::vector<double> distances(picks.X.size());
  for (std::size_t pick = 0; pick < distances.size(); ++pick)
  {
    const Eigen::Vector2d place(picks.X[pick], picks.Y[pick]);
    const Eigen::Vector2d index = LineIndex(numbering, picks.Crossline[pick], picks.Inline[pick]);
    distances[pick] = (toColumns * (place - map.Origin) - index).cwiseAbs().maxCoeff();
  }
  return distances;
}

double FarthestDistance(const PickPlaces& picks, const LineNumbering& numbering, const PlaneMap& map)
{
  const std::vector<double> distances = FindDistances(picks, numbering, map);
  return std::accumulate(distances.begin(), distances.end(), 0.0, [](double a, double b) { return std::max(a, b); });
}

std::vector<std::size_t> ListBeyond(const std::vector<double>& distances, double tolerance)
{
  std::vector<std::size_t> strays;
  for (std::size_t pick = 0; pick < distances.size(); ++pick)
  {
    if (!(distances[pick] <= tolerance))
    {
      strays.push_back(pick);
    }
  }
  return strays;
}

// ---- Fit of a lattice -----------------------------------------------------------------------------------------------
struct PlaceFit
{
  PlaneMap ToWorld;
  double LargestDistance = 0.0;
  std::vector<std::size_t> Strays = {};
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
      const std::size_t strays = ListBeyond(FindDistances(picks, numbering, *map), tolerance).size();
      best = strays < fewest ? map : best;
      fewest = std::min(fewest, strays);
    }
  }
  return best;
}

PickPlaces SamplePlaces(const PickPlaces& picks)
{
  constexpr std::size_t fittedPlaces = 1000;
  PickPlaces some;
  const std::size_t stride = std::max<std::size_t>(1, picks.X.size() / fittedPlaces);
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
  const std::optional<PlaneMap> consensus = FindConsensus(SamplePlaces(picks), numbering, 2.0 * tolerance);
  if (!consensus)
  {
    return ofAll;
  }
  PlaceFit fit = { *consensus };
  for (const double allowed : { 2.0 * tolerance, tolerance, tolerance })
  {
    const std::vector<std::size_t> strays = ListBeyond(FindDistances(picks, numbering, fit.ToWorld), allowed);
    if (double(strays.size()) > std::max(1.0, MostStrays * double(picks.X.size())) ||
      picks.X.size() < strays.size() + 4)
    {
      return ofAll;
    }
    fit.ToWorld = FitPlaces(WithoutPicks(picks, strays), numbering, monitor);
  }
  const std::vector<double> distances = FindDistances(picks, numbering, fit.ToWorld);
  fit.Strays = ListBeyond(distances, tolerance);
  for (const double distance : distances)
  {
    fit.LargestDistance = distance <= tolerance ? std::max(fit.LargestDistance, distance) : fit.LargestDistance;
  }
  return fit;
}

/// Picks need only line numbers and places. Throws InputError, which begins with `what`, if the places are on no
/// lattice.
PlaceFit FitLattice(const PickPlaces& picks, const LineNumbering& numbering, const std::string& what, double tolerance,
  const Monitor& monitor)
{
  PlaceFit fit = { FitPlaces(picks, numbering, monitor) };
  if (AreParallel(fit.ToWorld.Steps.col(0), fit.ToWorld.Steps.col(1)))
  {
    throw InputError(what + "on one line, expected some that span a lattice");
  }
  fit.LargestDistance = FarthestDistance(picks, numbering, fit.ToWorld);
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

/// x and y may repeat the line numbers, in either order, multiplied by the scalar.
bool FollowsLines(const PlaneMap& map, const LineNumbers& lines)
{
  constexpr double rounding = 1e-6; // Fraction of a step.
  const double scale = Scaled(1.0, lines.Table[TraceByte::PlaceScalar][0]);
  const auto follows = [&](const Eigen::Vector2d& step, double lineStep)
  {
    const Eigen::Vector2d size = step.cwiseAbs() / std::abs(lineStep);
    const auto isStep = [&](double part)
    { return std::abs(part - 1.0) < rounding || std::abs(part / scale - 1.0) < rounding; };
    return std::min(size.x(), size.y()) < rounding && isStep(size.maxCoeff());
  };
  return follows(map.Steps.col(0), lines.Numbering.CrosslineStep) &&
    follows(map.Steps.col(1), lines.Numbering.InlineStep);
}

// ---- Choice of the fields -------------------------------------------------------------------------------------------
std::string FieldsText(const FieldPair& fields)
{
  return "x and y of traces (bytes " + std::to_string(fields.First) + " and " + std::to_string(fields.Second) + ") ";
}

PlacedTraces TryFields(const LineNumbers& lines, const FieldPair& fields, double tolerance, const Monitor& monitor)
{
  if (AreFloats(lines, fields))
  {
    throw InputError(FieldsText(fields) + "have the bits of floats, expected integers");
  }
  const PickPlaces picks = ListPlaces(lines, fields);
  if (picks.X.empty())
  {
    throw InputError(FieldsText(fields) + "that are all 0, expected coordinates");
  }
  const PlaceFit fit = FitLattice(picks, lines.Numbering, FieldsText(fields), tolerance, monitor);
  PlacedTraces placed = { fields, fit.ToWorld, fit.LargestDistance, std::int64_t(fit.Strays.size()), {} };
  if (tolerance == IrregularTolerance)
  {
    const std::vector<double> distances = FindDistances(picks, lines.Numbering, fit.ToWorld);
    const Eigen::Map<const Eigen::ArrayXd> all(distances.data(), Eigen::Index(distances.size()));
    const double squares = (all <= fit.LargestDistance).select(all.square(), 0.0).sum();
    std::ostringstream text;
    text.precision(2);
    text << FieldsText(fields) << "up to " << fit.LargestDistance << " of a step off any lattice, "
         << std::sqrt(squares / double((all <= fit.LargestDistance).count()))
         << " rms, as with irregular midpoints: the lattice is a least-squares fit";
    placed.Warnings.push_back(text.str());
  }
  std::size_t places = 0; // up to the first stray
  for (std::int64_t trace = 0; !fit.Strays.empty() && trace < lines.Table.Traces; ++trace)
  {
    if (HasPlace(lines, fields, trace) && places++ == fit.Strays.front())
    {
      placed.Warnings.push_back(std::to_string(placed.Strays) + " traces, the first of them " +
        std::to_string(trace + 1) + ", with x and y off the lattice of the others: placed by their line numbers");
    }
  }
  return placed;
}

/// Returns a warning if another pair of fields has another lattice.
std::string CompareFields(
  const LineNumbers& lines, const PlacedTraces& placed, const FieldPair& other, double tolerance)
{
  if (AreSame(lines.Table, other) || AreLineNumbers(lines, other) || AreFloats(lines, other))
  {
    return {};
  }
  const PickPlaces picks = ListPlaces(lines, other, SamplingStride(lines.Table));
  const double distance = picks.X.empty() ? 0.0 : FarthestDistance(picks, lines.Numbering, placed.ToWorld);
  if (distance <= 1.0)
  {
    return {};
  }
  try
  {
    const PlaceFit fit = FitLattice(picks, lines.Numbering, FieldsText(other), tolerance, Monitor());
    if (!fit.Strays.empty() || FollowsLines(fit.ToWorld, lines))
    {
      return {};
    }
  }
  catch (const InputError&)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(3);
  text << FieldsText(other) << "on another lattice, up to " << distance << " columns from the one at bytes "
       << placed.Fields.First << " and " << placed.Fields.Second
       << ", which is used; set XByte and YByte to use the other";
  return text.str();
}

PlacedTraces LinesForPlaces(const std::string& problems, const LineNumbering& numbering)
{
  PlacedTraces placed;
  if (!problems.empty())
  {
    placed.Warnings.push_back(problems + "; line numbers stand for x and y");
  }
  placed.Fields = { NoField, NoField };
  placed.ToWorld = LinesAsPlaces(numbering);
  return placed;
}

/// Uses fields that follow the line numbers, with a warning, for lack of better fields.
PlacedTraces UseDoubtful(PlacedTraces doubtful, bool areLineNumbers, const LineNumbering& numbering)
{
  if (areLineNumbers)
  {
    return LinesForPlaces(FieldsText(doubtful.Fields) + "that equal the line numbers, expected coordinates", numbering);
  }
  doubtful.Warnings.push_back(FieldsText(doubtful.Fields) +
    "with the steps of line numbers, expected coordinates; if they are lines as well, set XByte and YByte");
  return doubtful;
}
}

//----------------------------------------------------------------------------------------------------------------------
bool AreLineNumbers(const LineNumbers& lines, const FieldPair& fields)
{
  const auto areAll = [&](auto&& placeOf)
  {
    for (std::int64_t trace = 0; trace < lines.Table.Traces; ++trace)
    {
      const Eigen::Vector2d numbers(lines.Inline(trace), lines.Crossline(trace));
      if (HasPlace(lines, fields, trace) && placeOf(trace) != numbers && placeOf(trace) != numbers.reverse())
      {
        return false;
      }
    }
    return true;
  };
  const auto stored = [&](std::int64_t trace)
  { return Eigen::Vector2d(lines.Table[fields.First][trace], lines.Table[fields.Second][trace]); };
  return areAll(stored) || areAll([&](std::int64_t trace) { return TracePlace(lines.Table, fields, trace); });
}

//----------------------------------------------------------------------------------------------------------------------
bool AreFloats(const LineNumbers& lines, const FieldPair& fields)
{
  constexpr std::int32_t least = 0x3f800000; // 1 as an IEEE float.
  constexpr std::int32_t largest = 0x4cbebc20; // 1e8 as an IEEE float; IBM floats from 1 to 1e8 are in the same range.
  const auto isFloat = [&](std::int32_t bits) { return bits >= least && bits <= largest; };
  std::int64_t places = 0;
  for (std::int64_t trace = 0; trace < lines.Table.Traces; trace += SamplingStride(lines.Table))
  {
    if (HasPlace(lines, fields, trace))
    {
      ++places;
      if (!isFloat(lines.Table[fields.First][trace]) || !isFloat(lines.Table[fields.Second][trace]))
      {
        return false;
      }
    }
  }
  return places > 0;
}

//----------------------------------------------------------------------------------------------------------------------
PlacedTraces PlaceTraces(const LineNumbers& lines, const SEGYOptions& options, bool isLine, const Monitor& monitor)
{
  const bool isGiven = options.PlaceFields.First > 0;
  std::optional<PlacedTraces> found, doubtful;
  const auto tryAll = [&](double tolerance)
  {
    std::string problems;
    for (const FieldPair& fields : ListPlaceFields(lines.Table, options.PlaceFields))
    {
      if (found)
      {
        const std::string other = CompareFields(lines, *found, fields, tolerance);
        found->Warnings.insert(found->Warnings.end(), other.empty() ? 0 : 1, other);
        continue;
      }
      try
      {
        const PlacedTraces placed = TryFields(lines, fields, tolerance, monitor);
        std::optional<PlacedTraces>& which = !isGiven && FollowsLines(placed.ToWorld, lines) ? doubtful : found;
        which = which ? which : placed;
      }
      catch (const InputError& error)
      {
        problems += (problems.empty() ? "" : "; ") + std::string(error.what());
      }
    }
    return problems;
  };
  const std::string problems = tryAll(options.Tolerance);
  if (!found && !doubtful && !isLine)
  {
    tryAll(IrregularTolerance);
    if (isGiven && !found)
    {
      throw InputError(problems);
    }
  }
  if (found || doubtful)
  {
    return found ? *found : UseDoubtful(*doubtful, AreLineNumbers(lines, doubtful->Fields), lines.Numbering);
  }
  return LinesForPlaces(problems, lines.Numbering);
}
}
