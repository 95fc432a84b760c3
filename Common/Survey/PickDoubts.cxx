// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickDoubts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<double, 14> UsualNulls = { 0.0, -999.0, 999.0, -9999.0, 9999.0, -32768.0, 32767.0, -1.0, -99.0,
  -32767.0, 99999.0, -99999.0, 999999.0, -999999.0 };

/// A number for no value that is farther from all other z than these are from each other: the least or the greatest z,
/// where it is a usual one, or one of several picks.
std::string FindNull(const LatticeHorizon& horizon)
{
  const auto ends = std::minmax_element(horizon.RealZ.begin(), horizon.RealZ.end());
  if (ends.first == horizon.RealZ.end())
  {
    return {};
  }
  for (const double null : { *ends.first, *ends.second })
  {
    const bool isUsual = std::find(UsualNulls.begin(), UsualNulls.end(), null) != UsualNulls.end();
    std::int64_t count = 0;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const double z : horizon.RealZ)
    {
      count += z == null ? 1 : 0;
      least = z == null ? least : std::min(least, z);
      greatest = z == null ? greatest : std::max(greatest, z);
    }
    const double range = greatest - least;
    if (count > (isUsual ? 0 : 1) && range >= 0.0 && (null < least - range || null > greatest + range))
    {
      std::ostringstream text;
      text.precision(12);
      text << count << " of " << horizon.RealZ.size() << " picks with z " << null << ", far from all others, " << least
           << " to " << greatest << ": add " << null << " to NullValues if it means that there is no z";
      return text.str();
    }
  }
  return {};
}
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
    const std::string null = FindNull(horizon);
    if (!null.empty())
    {
      doubts.push_back(null);
    }
  }
  if (100 * duplicates > picks)
  {
    doubts.push_back(std::to_string(duplicates) + " of " + std::to_string(picks) +
      " picks dropped, as there is another one in their column: of several horizons or surveys in one, name the column "
      "that tells them apart; DuplicatePolicy chooses");
  }
  return doubts;
}
}
