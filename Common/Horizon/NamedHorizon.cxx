// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NamedHorizon.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> NamesOf(const std::vector<NamedHorizon>& horizons)
{
  std::vector<std::string> names(horizons.size());
  std::transform(
    horizons.begin(), horizons.end(), names.begin(), [](const NamedHorizon& horizon) { return horizon.Name; });
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
std::string HorizonName(std::int64_t surfaceId)
{
  return "Horizon " + std::to_string(surfaceId);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> MakeDistinct(std::vector<std::string> names)
{
  std::unordered_set<std::string> taken(names.begin(), names.end());
  std::unordered_map<std::string, int> uses;
  for (std::string& name : names)
  {
    const std::string first = name;
    int& number = uses[first];
    ++number;
    while (number > 1 && !taken.insert(name = first + " (" + std::to_string(number) + ')').second)
    {
      ++number;
    }
  }
  return names;
}
}
