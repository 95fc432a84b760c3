// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultSticks.h"

#include "Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// Looks along sticks for the place where they pass from above a horizon to below it.
class StickProbe
{
public:
  explicit StickProbe(const ColumnHeights& heights)
    : Heights(heights)
    , Least(heights.Grid().ToLink(0).Column)
  {
  }

  std::optional<MapPlace> FindPassage(const std::vector<SpacePoint>& places) const
  {
    Sample last;
    for (std::size_t n = 1; n < places.size(); ++n)
    {
      const SpacePoint& a = places[n - 1];
      const SpacePoint& b = places[n];
      // Within the box half a column from sample to sample; most sticks are far shorter than this many.
      constexpr double MostSamples = 1e5;
      const double length = std::hypot(b.X - a.X, b.Y - a.Y);
      const int samples = int(std::min(MostSamples, std::ceil(2.0 * length) + 1.0));
      for (int sample = 0; sample <= samples; ++sample)
      {
        const double part = double(sample) / samples;
        const Sample next =
          this->Take({ a.X + part * (b.X - a.X), a.Y + part * (b.Y - a.Y), a.Z + part * (b.Z - a.Z) });
        if (std::isnan(next.Above))
        {
          continue;
        }
        if (!std::isnan(last.Above) && (last.Above < 0.0) != (next.Above < 0.0))
        {
          const double share = last.Above / (last.Above - next.Above);
          return MapPlace{ last.Place.X + share * (next.Place.X - last.Place.X),
            last.Place.Y + share * (next.Place.Y - last.Place.Y) };
        }
        last = next;
      }
    }
    return std::nullopt;
  }

private:
  struct Sample
  {
    MapPlace Place;
    double Above = std::numeric_limits<double>::quiet_NaN(); // how far above the horizon
  };

  /// By the height of the nearest column.
  Sample Take(const SpacePoint& place) const
  {
    Sample sample;
    sample.Place = { place.X, place.Y };
    const double x = std::round(place.X - this->Least.X);
    const double y = std::round(place.Y - this->Least.Y);
    const LinkGrid& grid = this->Heights.Grid();
    if (x >= 0.0 && y >= 0.0 && x < double(grid.Width()) && y < double(grid.Height()))
    {
      sample.Above = place.Z - this->Heights[std::int64_t(y) * grid.Width() + std::int64_t(x)];
    }
    return sample;
  }

  const ColumnHeights& Heights;
  const PlanePoint Least;
};

void CheckPlaces(const std::vector<FaultStick>& sticks)
{
  for (std::size_t stick = 0; stick < sticks.size(); ++stick)
  {
    for (const SpacePoint& place : sticks[stick].Places)
    {
      if (!std::isfinite(place.X) || !std::isfinite(place.Y) || !std::isfinite(place.Z))
      {
        std::ostringstream text;
        text << "fault stick " << stick << " with a point at (" << place.X << ", " << place.Y << ", " << place.Z
             << ") in columns and vertical indices, expected finite numbers";
        throw InputError(text.str());
      }
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultPolyline> FindTraces(const ColumnHeights& heights, const std::vector<FaultStick>& sticks)
{
  CheckPlaces(sticks);
  const StickProbe probe(heights);
  std::vector<FaultPolyline> traces;
  FaultPolyline trace;
  const auto endTrace = [&traces, &trace]()
  {
    if (trace.size() > 1)
    {
      traces.push_back(trace);
    }
    trace.clear();
  };
  for (std::size_t stick = 0; stick < sticks.size(); ++stick)
  {
    if (stick > 0 && sticks[stick].Fault != sticks[stick - 1].Fault)
    {
      endTrace();
    }
    if (const std::optional<MapPlace> place = probe.FindPassage(sticks[stick].Places))
    {
      trace.push_back(*place);
    }
    else
    {
      endTrace();
    }
  }
  endTrace();
  return traces;
}
}
