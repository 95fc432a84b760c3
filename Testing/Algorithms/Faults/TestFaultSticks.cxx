// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where sticks pass through a horizon, and which passages make a trace.

#include "FaultPictures.h"
#include "Tools/Check.h"

#include <limits>

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

void JoinsPassages()
{
  // All pass at i = 14.25, up or down, whether there is a gap or not.
  for (const bool hasGap : { false, true })
  {
    const std::vector<FaultPolyline> traces =
      FindTraces(Level(hasGap), { Stick(2.5, 0.0, 20.0), Stick(6.5, 18.0, 1.0), Stick(9.5, 0.0, 30.0) });
    CHECK_EQUAL(traces.size(), 1U);
    CHECK_EQUAL(traces.front().size(), 3U);
    for (const MapPlace& place : traces.front())
    {
      CHECK(std::abs(place.X - 14.25) < 1e-9);
    }
    CHECK_EQUAL(traces.front()[1].Y, 6.5);
  }
}

void EndsTraces()
{
  // Another fault, and a stick that ends above the horizon.
  const std::vector<FaultPolyline> traces = FindTraces(Level(),
    { Stick(1.0, 0.0, 20.0), Stick(2.0, 0.0, 20.0), Stick(3.0, 0.0, 20.0, "G"), Stick(4.0, 0.0, 20.0, "G"),
      Stick(5.0, 0.0, 7.0, "G"), Stick(6.0, 0.0, 20.0, "G"), Stick(7.0, 0.0, 20.0, "G"), Stick(8.0, 0.0, 20.0, "H") });
  CHECK_EQUAL(traces.size(), 3U);
  for (const FaultPolyline& trace : traces)
  {
    CHECK_EQUAL(trace.size(), 2U);
  }
  // Beside the horizon, and of one place.
  CHECK_EQUAL(FindTraces(Level(), { Stick(-9.0, 0.0, 20.0), Stick(99.0, 0.0, 20.0) }).size(), 0U);
  CHECK_EQUAL(FindTraces(Level(), { { { { 3.0, 3.0, 3.0 } }, "" }, { {}, "" } }).size(), 0U);
}

/// What is outside takes no time, and heights may be as large as numbers are.
void ComesFromFarAway()
{
  FaultStick zigzag{ {}, "F" };
  for (int n = 0; n < 100000; ++n)
  {
    zigzag.Places.push_back({ n % 2 == 0 ? -1e9 : 1e9, 30.0 + n, 8.0 });
  }
  CHECK_EQUAL(FindTraces(Level(), { zigzag, zigzag }).size(), 0U);
  const auto straight = [](double y, double far) {
    return FaultStick{ { { 14.25, y, -far }, { 14.25, y, far } }, "F" };
  };
  for (const double far : { 1e9, 1e300, 1.7e308 })
  {
    const std::vector<FaultPolyline> traces = FindTraces(Level(), { straight(2.0, far), straight(3.0, far) });
    CHECK_EQUAL(traces.size(), 1U);
    CHECK_EQUAL(traces.front()[1].X, 14.25);
  }
}

void RefusesWhatIsNotFinite()
{
  CHECK_THROWS_WITH(FindTraces(Level(), { { { { 1.0, Missing, 2.0 } }, "F" } }),
    "fault stick 0 with a point at (1, nan, 2) in columns and vertical indices, expected finite numbers");
}
}

int TestFaultSticks(int, char*[])
{
  JoinsPassages();
  EndsTraces();
  ComesFromFarAway();
  RefusesWhatIsNotFinite();
  return Check::Result();
}
