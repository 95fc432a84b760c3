// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultSticks.h"

#include "Common/Errors.h"
#include "SegmentClip.h"

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
      const SegmentClip near(this->Heights.Grid(), this->FromLeast(a), this->FromLeast(b));
      if (near.IsEmpty())
      {
        continue;
      }
      const MapPlace& from = near.From();
      const MapPlace& to = near.To();
      const double halfRise = 0.5 * b.Z - 0.5 * a.Z;
      // Half a column from sample to sample.
      const int samples = int(std::ceil(2.0 * std::hypot(to.X - from.X, to.Y - from.Y)) + 1.0);
      for (int sample = 0; sample <= samples; ++sample)
      {
        const double share = double(sample) / samples;
        const double part = near.First() + share * (near.Last() - near.First());
        const Sample next = this->Take({ from.X + share * (to.X - from.X), from.Y + share * (to.Y - from.Y) },
          a.Z + part * halfRise + part * halfRise);
        if (std::isnan(next.Above))
        {
          continue;
        }
        if (!std::isnan(last.Above) && (last.Above < 0.0) != (next.Above < 0.0))
        {
          return this->Passage(last, next);
        }
        last = next;
      }
    }
    return std::nullopt;
  }

private:
  struct Sample
  {
    MapPlace Place; // from the least column
    double Above = std::numeric_limits<double>::quiet_NaN(); // how far above the horizon
  };

  MapPlace FromLeast(const SpacePoint& place) const { return { place.X - this->Least.X, place.Y - this->Least.Y }; }

  /// Where a stick is level with the horizon between two samples, in columns of the lattice.
  MapPlace Passage(const Sample& before, const Sample& after) const
  {
    const double known = 0.5 * before.Above / (0.5 * before.Above - 0.5 * after.Above);
    const double share = std::isfinite(known) ? known : 0.5; // between infinite heights
    return { this->Least.X + before.Place.X + share * (after.Place.X - before.Place.X),
      this->Least.Y + before.Place.Y + share * (after.Place.Y - before.Place.Y) };
  }

  /// By the height of the nearest column.
  Sample Take(const MapPlace& place, double height) const
  {
    Sample sample;
    sample.Place = place;
    const double x = std::round(place.X);
    const double y = std::round(place.Y);
    const LinkGrid& grid = this->Heights.Grid();
    if (x >= 0.0 && y >= 0.0 && x < double(grid.Width()) && y < double(grid.Height()))
    {
      sample.Above = height - this->Heights[std::int64_t(y) * grid.Width() + std::int64_t(x)];
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
