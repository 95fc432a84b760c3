// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestRim.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
/// A search by breadth, from all columns beside known points at once.
class RimSearch
{
public:
  explicit RimSearch(const GapRegion& region)
    : Region(region)
    , Nearest(region.Kind.size(), NoPoint)
    , Distance(region.Kind.size(), 0)
  {
  }

  std::vector<PointId> Run()
  {
    std::vector<std::int64_t> front = this->StartBesideRing();
    std::vector<std::int64_t> next;
    for (std::int32_t distance = 2; !front.empty(); ++distance)
    {
      for (const std::int64_t place : front)
      {
        this->Spread(place, distance, next);
      }
      front.swap(next);
      next.clear();
    }
    std::vector<PointId> result;
    result.reserve(this->Region.GapPlaces.size());
    for (const std::int64_t place : this->Region.GapPlaces)
    {
      result.push_back(this->Nearest[std::size_t(place)]);
    }
    return std::find(result.begin(), result.end(), NoPoint) == result.end() ? result : std::vector<PointId>();
  }

private:
  std::vector<std::int64_t> StartBesideRing()
  {
    std::vector<std::int64_t> front;
    for (const std::int64_t place : this->Region.GapPlaces)
    {
      for (const std::int64_t neighbour : this->Region.Neighbours(place))
      {
        if (this->Region.Kind[std::size_t(neighbour)] == PlaceKind::Ring && this->Region.IsLinked(place, neighbour))
        {
          this->Offer(place, this->Region.Point[std::size_t(neighbour)], 1, front);
        }
      }
    }
    return front;
  }

  void Spread(std::int64_t place, std::int32_t distance, std::vector<std::int64_t>& reached)
  {
    for (const std::int64_t neighbour : this->Region.Neighbours(place))
    {
      if (this->Region.Kind[std::size_t(neighbour)] == PlaceKind::Gap && this->Region.IsLinked(place, neighbour))
      {
        this->Offer(neighbour, this->Nearest[std::size_t(place)], distance, reached);
      }
    }
  }

  /// Takes a point that far away for the nearest of a place, unless there is a better one.
  void Offer(std::int64_t place, PointId point, std::int32_t distance, std::vector<std::int64_t>& reached)
  {
    PointId& nearest = this->Nearest[std::size_t(place)];
    if (nearest == NoPoint)
    {
      nearest = point;
      this->Distance[std::size_t(place)] = distance;
      reached.push_back(place);
    }
    else if (this->Distance[std::size_t(place)] == distance)
    {
      nearest = std::min(nearest, point);
    }
  }

  const GapRegion& Region;
  std::vector<PointId> Nearest; // to each place
  std::vector<std::int32_t> Distance;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> FindNearestRim(const GapRegion& region)
{
  return RimSearch(region).Run();
}
}
