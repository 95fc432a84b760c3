// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sheets between sticks, and where they pass through a horizon.

#include "FaultPictures.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

/// A stick of a fault that dips to the east: half a column for each vertical index.
FaultStick Stick(double y, double top, double bottom, const std::string& fault = "F")
{
  return { { { 10.25 + 0.5 * top, y, top }, { 10.25 + 0.5 * bottom, y, bottom } }, fault };
}

ColumnHeights Level(bool hasGap = false)
{
  return MakeHeights(30, 20, [hasGap](int i, int) { return hasGap && i >= 12 && i < 17 ? Missing : 8.0; });
}

std::vector<FaultPolyline> Trace(
  const ColumnHeights& heights, const std::vector<FaultStick>& sticks, bool extend = false)
{
  return FindTraces(heights, MakeFaultSheets(sticks, extend));
}

/// From one y to another one at i = 14.25, and half a column on; half a column from place to place at most.
void CheckTrace(const FaultPolyline& trace, double from, double to)
{
  CHECK(std::abs(std::min(trace.front().Y, trace.back().Y) - (from - 0.5)) < 1e-9);
  CHECK(std::abs(std::max(trace.front().Y, trace.back().Y) - (to + 0.5)) < 1e-9);
  for (std::size_t n = 0; n < trace.size(); ++n)
  {
    CHECK(std::abs(trace[n].X - 14.25) < 1e-9);
    CHECK(n == 0 || std::abs(trace[n].Y - trace[n - 1].Y) <= 1.0 + 1e-9);
  }
}

void PassesThroughAHorizon()
{
  // Up or down, whether there is a gap or not.
  for (const bool hasGap : { false, true })
  {
    const auto traces = Trace(Level(hasGap), { Stick(2.5, 0.0, 20.0), Stick(6.5, 18.0, 1.0), Stick(9.5, 0.0, 30.0) });
    if (CHECK_EQUAL(traces.size(), 1U))
    {
      CheckTrace(traces.front(), 2.5, 9.5);
    }
  }
}

void SortsSticks()
{
  // As picked: first each second one, then those between.
  std::vector<FaultStick> sticks;
  for (const double y : { 3.0, 7.0, 11.0, 15.0, 5.0, 9.0, 13.0, 1.0, 17.0 })
  {
    sticks.push_back(Stick(y, 0.0, 20.0));
  }
  const auto traces = Trace(Level(), sticks);
  if (CHECK_EQUAL(traces.size(), 1U))
  {
    CheckTrace(traces.front(), 1.0, 17.0);
    CHECK_EQUAL(traces.front().size(), 33U);
  }
  // Around a fault that is bent to three quarters of a circle, in any order.
  std::vector<FaultStick> ring;
  for (int n = 0; n < 28; ++n)
  {
    const double angle = 0.17 * ((n * 11) % 28);
    const double x = 15.0 + 7.0 * std::cos(angle);
    const double y = 10.0 + 7.0 * std::sin(angle);
    ring.push_back({ { { x, y, 0.0 }, { x, y, 20.0 } }, "R" });
  }
  const auto bent = Trace(Level(), ring);
  if (CHECK_EQUAL(bent.size(), 1U))
  {
    double length = 0.0;
    for (std::size_t n = 1; n < bent.front().size(); ++n)
    {
      length += std::hypot(bent[0][n].X - bent[0][n - 1].X, bent[0][n].Y - bent[0][n - 1].Y);
    }
    CHECK(std::abs(length - 7.0 * 0.17 * 27 - 1.0) < 0.1);
  }
}

void EndsTraces()
{
  // Two faults; another one with a single stick, which is no surface.
  const std::vector<FaultStick> sticks = { Stick(1.0, 0.0, 20.0), Stick(2.0, 0.0, 20.0), Stick(3.0, 0.0, 20.0, "G"),
    Stick(4.0, 0.0, 20.0, "G"), Stick(8.0, 0.0, 20.0, "H") };
  CHECK_EQUAL(Trace(Level(), sticks).size(), 2U);
  // Without names a fault ends where the next stick is far away.
  CHECK_EQUAL(Trace(Level(),
                { Stick(1.0, 0.0, 20.0, ""), Stick(2.0, 0.0, 20.0, ""), Stick(3.0, 0.0, 20.0, ""),
                  Stick(14.0, 0.0, 20.0, ""), Stick(15.0, 0.0, 20.0, "") })
                .size(),
    2U);
  // Beside the horizon, and of one place.
  CHECK_EQUAL(Trace(Level(), { Stick(-9.0, 0.0, 20.0), Stick(-99.0, 0.0, 20.0) }).size(), 0U);
  CHECK_EQUAL(Trace(Level(), { { { { 3.0, 3.0, 3.0 } }, "" }, { {}, "" } }).size(), 0U);
}

void ContinuesShortSticks()
{
  // The middle one ends above the horizon: as long ones on both sides do not, the cut goes on.
  const auto traces = Trace(Level(), { Stick(2.0, 0.0, 20.0), Stick(6.0, 0.0, 5.0), Stick(10.0, 0.0, 20.0) });
  if (CHECK_EQUAL(traces.size(), 1U))
  {
    CheckTrace(traces.front(), 2.0, 10.0);
  }
  // The last one has none beyond it.
  const auto ended = Trace(Level(), { Stick(2.0, 0.0, 20.0), Stick(6.0, 0.0, 20.0), Stick(10.0, 0.0, 5.0) });
  if (CHECK_EQUAL(ended.size(), 1U))
  {
    CheckTrace(ended.front(), 2.0, 6.0);
  }
}

void FollowsTheHorizonBetweenSticks()
{
  // Sticks 18 columns apart, and a ridge of the horizon between: the trace runs aside with it, no chord.
  const auto heights = MakeHeights(30, 20, [](int, int j) { return 8.0 + 6.0 * std::sin(j * 3.14159265 / 18.0); });
  const auto traces = Trace(heights, { Stick(0.0, 0.0, 30.0), Stick(18.0, 0.0, 30.0) });
  if (CHECK_EQUAL(traces.size(), 1U))
  {
    const auto farthest = std::max_element(
      traces.front().begin(), traces.front().end(), [](const MapPlace& a, const MapPlace& b) { return a.X < b.X; });
    CHECK(std::abs(farthest->X - (10.25 + 0.5 * 14.0)) < 0.1);
    CHECK(std::abs(farthest->Y - 9.0) < 0.6);
  }
}

/// The fault passes the horizon on the upper side, at the step and on the lower side: it cuts at the step.
void CutsAtTheStep()
{
  const auto heights = MakeHeights(30, 20, [](int i, int) { return i < 16 ? 8.0 : 16.0; });
  const auto traces = Trace(heights, { Stick(0.0, 0.0, 30.0), Stick(9.0, 0.0, 30.0) });
  if (CHECK_EQUAL(traces.size(), 1U))
  {
    for (const MapPlace& place : traces.front())
    {
      CHECK(place.X > 15.0 && place.X < 16.0);
    }
  }
}

bool HasPlace(const FaultSheet& sheet, const SpacePoint& place)
{
  return std::any_of(sheet.Places.begin(), sheet.Places.end(),
    [&place](const std::optional<SpacePoint>& other)
    {
      return other && std::abs(other->X - place.X) < 1e-9 && std::abs(other->Y - place.Y) < 1e-9 &&
        std::abs(other->Z - place.Z) < 1e-9;
    });
}

void MakesTriangles()
{
  const auto sheets = MakeFaultSheets({ Stick(2.0, 0.0, 20.0), Stick(4.0, 0.0, 10.0), Stick(8.0, 0.0, 20.0) }, false);
  if (!CHECK_EQUAL(sheets.size(), 1U))
  {
    return;
  }
  CHECK_EQUAL(sheets[0].Fault, "F");
  CHECK_EQUAL(sheets[0].Sticks, 3U);
  CHECK_EQUAL(sheets[0].Levels, 3U); // 0, 10 and 20
  CHECK_EQUAL(sheets[0].ListTriangles().size(), 8U);
  // The short one goes on along the plane of the others.
  CHECK(HasPlace(sheets[0], { 20.25, 4.0, 20.0 }));
  // By as much as there is between the last two, on either side.
  const auto extended = MakeFaultSheets({ Stick(2.0, 0.0, 20.0), Stick(4.0, 0.0, 20.0), Stick(8.0, 0.0, 20.0) }, true);
  CHECK_EQUAL(extended[0].Sticks, 5U);
  const double first = extended[0].Places[extended[0].At(0, 0)]->Y;
  const double last = extended[0].Places[extended[0].At(4, 0)]->Y;
  CHECK(std::abs(std::min(first, last) - 0.0) < 1e-9 && std::abs(std::max(first, last) - 12.0) < 1e-9);
  CHECK_EQUAL(extended[0].ListTriangles().size(), 8U);
}

/// What is outside takes no time, and heights may be as large as numbers are.
void ComesFromFarAway()
{
  FaultStick zigzag{ {}, "F" };
  for (int n = 0; n < 100000; ++n)
  {
    zigzag.Places.push_back({ n % 2 == 0 ? -1e9 : 1e9, 30.0 + n, 8.0 });
  }
  CHECK_EQUAL(Trace(Level(), { zigzag, zigzag }, true).size(), 0U);
  const auto straight = [](double y, double far) {
    return FaultStick{ { { 14.25, y, -far }, { 14.25, y, far } }, "F" };
  };
  for (const double far : { 1e9, 1e300, 1.7e308 })
  {
    for (const bool extend : { false, true })
    {
      const auto traces = Trace(Level(), { straight(2.0, far), straight(3.0, far) }, extend);
      CHECK_EQUAL(traces.size(), 1U);
      CHECK_EQUAL(traces.front()[1].X, 14.25);
    }
  }
}

void RefusesWhatIsNotFinite()
{
  CHECK_THROWS_WITH(MakeFaultSheets({ { { { 1.0, Missing, 2.0 } }, "F" } }, false),
    "fault stick 0 with a point at (1, nan, 2) in world coordinates, expected finite numbers");
}
}

int TestFaultSurfaces(int, char*[])
{
  PassesThroughAHorizon();
  SortsSticks();
  EndsTraces();
  ContinuesShortSticks();
  FollowsTheHorizonBetweenSticks();
  CutsAtTheStep();
  MakesTriangles();
  ComesFromFarAway();
  RefusesWhatIsNotFinite();
  return Check::Result();
}
