// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickDoubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<double, 20> UsualNulls = { 0.0, -999.0, 999.0, -9999.0, 9999.0, -32768.0, 32767.0, -1.0, -99.0,
  -32767.0, 99999.0, -99999.0, 999999.0, -999999.0, -999.25, 999.25, -9999.25, -999.99, -9999.99, 9999900.0 };
}

//----------------------------------------------------------------------------------------------------------------------
std::string FindNull(const std::vector<double>& z, const std::vector<std::int32_t>& picks)
{
  const auto ends = std::minmax_element(
    picks.begin(), picks.end(), [&](std::int32_t a, std::int32_t b) { return z[std::size_t(a)] < z[std::size_t(b)]; });
  if (ends.first == picks.end())
  {
    return {};
  }
  for (const double null : { z[std::size_t(*ends.first)], z[std::size_t(*ends.second)] })
  {
    const bool isUsual = std::find(UsualNulls.begin(), UsualNulls.end(), null) != UsualNulls.end();
    std::int64_t count = 0;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const std::int32_t pick : picks)
    {
      const double value = z[std::size_t(pick)];
      count += value == null ? 1 : 0;
      least = value == null ? least : std::min(least, value);
      greatest = value == null ? greatest : std::max(greatest, value);
    }
    const double range = greatest - least;
    const double gap = std::max(least - null, null - greatest);
    // A level platform of a horizon is far from the rest, but not as far as all of it is from 0.
    const double leastGap = isUsual ? 0.0 : 0.5 * std::max(std::abs(least), std::abs(greatest));
    if (count > (isUsual ? 0 : 1) && range >= 0.0 && gap > range && gap > leastGap)
    {
      std::ostringstream text;
      text.precision(12);
      text << count << " of " << picks.size() << " picks with z " << null << ", far from all others, " << least
           << " to " << greatest << ": add " << null << " to NullValues if it means that there is no z";
      return text.str();
    }
  }
  return {};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> FindDoubts(const SurveyHorizons& horizons)
{
  std::vector<std::string> doubts = horizons.Doubts;
  std::int64_t duplicates = 0;
  std::int64_t picks = 0;
  for (const LatticeHorizon& horizon : horizons.Horizons)
  {
    duplicates += horizon.DroppedDuplicates;
    picks += horizon.DroppedDuplicates + std::int64_t(horizon.RealZ.size());
  }
  if (100 * duplicates > picks)
  {
    doubts.push_back(std::to_string(duplicates) + " of " + std::to_string(picks) +
      " picks dropped, as their column has another one: for several horizons or surveys in one file, name the "
      "column that distinguishes them; DuplicatePolicy chooses");
  }
  return doubts;
}
}
