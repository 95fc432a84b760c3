// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PairFit.h"

#include "Common/Horizon/Lattice.h"
#include "Common/Survey/PlaneFit.h"
#include "Common/Text/TextFields.h"
#include "FieldGuess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace SeismicHorizons
{
namespace
{
constexpr double LeastCoordinate = 1e4;
// Fraction of a step by which rounded places may deviate.
constexpr double LargestMisfit = 0.1;
// Fraction of the extent by which wrong, bent or noisy places deviate.
constexpr double RoughlyOff = 0.15;
constexpr double LeastSine = 0.3;
// Fraction of the extent of the sample; the larger of both limits applies.
constexpr double LargestPartOff = 0.02;

struct Pair
{
  Eigen::Vector2d Index, Place;
};

std::vector<Pair> ReadPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to)
{
  std::vector<Pair> pairs;
  for (const std::string_view line : sample)
  {
    const Fields fields = SplitFields(line, layout.Separator);
    std::array<double, 4> values = {};
    bool areNumbers = true;
    for (const std::size_t n : { 0, 1, 2, 3 })
    {
      const std::size_t column = n < 2 ? from + n : to + n - 2;
      areNumbers = areNumbers && column < fields.size() &&
        ReadNumber(fields[column], values[n]) == NumberKind::Finite && std::abs(values[n]) < LargestPlace;
    }
    if (areNumbers)
    {
      pairs.push_back({ { values[0], values[1] }, { values[2], values[3] } });
    }
  }
  return pairs.size() >= MostOf(sample.size()) ? pairs : std::vector<Pair>();
}

/// A few lines may be wrong, and are left out of the map.
struct TrimmedFit
{
  std::optional<PlaneMap> Map; // maps differences from the first pair
  std::vector<double> Off; // distances from the map, ascending
  Eigen::Vector2d Extent = Eigen::Vector2d::Zero();

  /// The most reliable pairs come first.
  explicit TrimmedFit(std::vector<Pair> pairs)
  {
    for (int round = 0; round < 2; ++round)
    {
      this->Extent.setZero();
      for (std::size_t n = 0; n < MostOf(pairs.size()); ++n)
      {
        this->Extent = this->Extent.cwiseMax((pairs[n].Place - pairs.front().Place).cwiseAbs());
      }
      this->Map = Sort(pairs, MostOf(pairs.size()), &Pair::Index, &Pair::Place, this->Off);
      if (!this->Map)
      {
        return;
      }
    }
  }

  static std::optional<PlaneMap> Sort(std::vector<Pair>& pairs, std::size_t counting, Eigen::Vector2d Pair::*from,
    Eigen::Vector2d Pair::*to, std::vector<double>& sorted)
  {
    const Pair first = pairs.empty() ? Pair() : pairs.front();
    PlaneFit fit;
    for (std::size_t n = 0; n < counting; ++n)
    {
      fit.Add(pairs[n].*from - first.*from, pairs[n].*to - first.*to);
    }
    const std::optional<PlaneMap> map = fit.Solve();
    if (map)
    {
      const auto off = [&](const Pair& pair)
      { return (pair.*to - first.*to - map->Origin - map->Steps * (pair.*from - first.*from)).norm(); };
      std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return off(a) < off(b); });
      sorted.clear();
      std::transform(pairs.begin(), pairs.end(), std::back_inserter(sorted), off);
    }
    return map;
  }
};

/// An outlier bends the map that leads from it, and deviates only from the opposite map. The better one is used.
TrimmedFit FitMost(const std::vector<Pair>& pairs)
{
  std::vector<Pair> forward = pairs;
  std::vector<Pair> backward = pairs;
  std::vector<double> off;
  TrimmedFit::Sort(forward, pairs.size(), &Pair::Index, &Pair::Place, off);
  TrimmedFit::Sort(backward, pairs.size(), &Pair::Place, &Pair::Index, off);
  const TrimmedFit a(std::move(forward));
  const TrimmedFit b(std::move(backward));
  const std::size_t last = MostOf(pairs.size()) - 1;
  return a.Map && (!b.Map || a.Off[last] <= b.Off[last]) ? a : b;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t MostOf(std::size_t lines)
{
  return lines - lines / 10;
}

//----------------------------------------------------------------------------------------------------------------------
PairFit FitPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to)
{
  const std::vector<Pair> pairs = ReadPairs(sample, layout, from, to);
  PairFit result;
  result.AreCoordinates = !pairs.empty() &&
    std::all_of(
      pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.Place.cwiseAbs().minCoeff() > LeastCoordinate; });
  const TrimmedFit fit = FitMost(pairs);
  const std::optional<PlaneMap>& map = fit.Map;
  constexpr std::size_t fewest = 4; // Three pairs always fit a map.
  result.AreTelling = map && pairs.size() >= fewest;
  // The steps of a plane z and a constant attribute are parallel.
  if (!result.AreTelling || AreParallel(map->Steps.col(0), map->Steps.col(1)))
  {
    return result;
  }
  const double step = map->Steps.colwise().norm().minCoeff();
  const double most = std::max(LargestMisfit * step, LargestPartOff * fit.Extent.minCoeff());
  result.AreLarger = std::abs(map->Steps.determinant()) >= 0.999;
  result.AreAffine = fit.Off[MostOf(pairs.size()) - 1] <= most;
  // Steps of a slope and of an attribute that follows it are nearly parallel.
  const double sine = std::abs(map->Steps.determinant()) / (map->Steps.col(0).norm() * map->Steps.col(1).norm());
  result.AreMostlyAffine = sine > LeastSine && fit.Off[pairs.size() * 3 / 4] <= RoughlyOff * fit.Extent.minCoeff();
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
bool FollowOneLine(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places)
{
  const std::vector<Pair> pairs = ReadPairs(sample, layout, lines, places);
  PlaneFit fit;
  for (const Pair& pair : pairs)
  {
    fit.Add(pair.Index - pairs.front().Index, pair.Place - pairs.front().Place);
  }
  constexpr std::size_t fewest = 10;
  const std::optional<PlaneMap> map = pairs.size() >= fewest && !fit.Solve() ? fit.SolveAlongLine() : std::nullopt;
  return map &&
    std::all_of(pairs.begin(), pairs.end(),
      [&](const Pair& pair)
      {
        const Eigen::Vector2d place = map->Origin + map->Steps * (pair.Index - pairs.front().Index);
        return (pair.Place - pairs.front().Place - place).norm() <= LargestMisfit * map->Steps.col(0).norm();
      });
}
}
