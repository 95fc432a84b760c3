// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultScore.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Links as places on a lattice of twice as many columns, where each has a place of its own.
using Places = std::set<std::pair<int, int>>;

std::pair<int, int> PlaceOf(const PlanePoint& column, bool isNorth)
{
  return { 2 * column.X + (isNorth ? 0 : 1), 2 * column.Y + (isNorth ? 1 : 0) };
}

/// Whether there is one within some columns along i and j.
bool IsNear(const Places& places, const std::pair<int, int>& place, int reach)
{
  for (int x = place.first - 2 * reach; x <= place.first + 2 * reach; ++x)
  {
    const auto first = places.lower_bound({ x, place.second - 2 * reach });
    if (first != places.end() && first->first == x && first->second <= place.second + 2 * reach)
    {
      return true;
    }
  }
  return false;
}
}

//----------------------------------------------------------------------------------------------------------------------
void FaultScore::Add(const FaultScore& other)
{
  for (std::size_t n = 0; n < this->Torn.size(); ++n)
  {
    this->Torn[n] += other.Torn[n];
    this->Found[n] += other.Found[n];
  }
  this->False += other.False;
  this->Columns += other.Columns;
}

//----------------------------------------------------------------------------------------------------------------------
double FaultScore::FoundPercent(std::size_t throwClass) const
{
  return this->Torn[throwClass] > 0 ? 100.0 * double(this->Found[throwClass]) / double(this->Torn[throwClass])
                                    : std::numeric_limits<double>::quiet_NaN();
}

//----------------------------------------------------------------------------------------------------------------------
FaultScore ScoreFaults(const FaultedHorizon& horizon, const FaultLines& found, int reach, int reachOfAll)
{
  reach = std::max(reach, reachOfAll);
  FaultScore score;
  score.Columns = std::int64_t(horizon.Columns.size());
  std::set<std::pair<int, int>> columns;
  for (const PlanePoint& column : horizon.Columns)
  {
    columns.insert({ column.X, column.Y });
  }
  Places foundPlaces;
  for (std::size_t n = 0; n < found.NumberOfLinks(); ++n)
  {
    foundPlaces.insert(PlaceOf(found[n].Place.Column, found[n].Place.Side == LinkSide::North));
  }
  Places tornPlaces;
  for (const TornLink& link : horizon.Torn)
  {
    const std::pair<int, int> place = PlaceOf(link.Column, link.IsNorth);
    tornPlaces.insert(place);
    std::size_t throwClass = FaultScore::ClassBegins.size();
    while (throwClass > 0 && std::abs(link.Throw) < FaultScore::ClassBegins[throwClass - 1])
    {
      --throwClass;
    }
    if (throwClass == 0)
    {
      continue;
    }
    const bool isInGap = columns.count({ link.Column.X, link.Column.Y }) == 0 ||
      columns.count({ link.Column.X + (link.IsNorth ? 0 : 1), link.Column.Y + (link.IsNorth ? 1 : 0) }) == 0;
    ++score.Torn[throwClass - 1];
    score.Found[throwClass - 1] += IsNear(foundPlaces, place, isInGap ? reach : reachOfAll) ? 1 : 0;
  }
  for (const std::pair<int, int>& place : foundPlaces)
  {
    score.False += IsNear(tornPlaces, place, 1 + reach) ? 0 : 1;
  }
  return score;
}
}
