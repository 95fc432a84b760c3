// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs of one sign on a trace, and their picks: small traces by hand.

#include "Filters/Algorithms/Reflections/ReflectionFinder.h"
#include "Tools/Check.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

using namespace SeismicHorizons;

namespace
{
constexpr float Missing = std::numeric_limits<float>::quiet_NaN();

/// The picks as text: "place thickness amplitude strength; ...".
std::string Picks(const std::vector<float>& trace, const ReflectionRules& rules = ReflectionRules())
{
  std::vector<Reflection> found;
  FindReflections(trace.data(), int(trace.size()), rules, found);
  std::ostringstream text;
  text.precision(4);
  for (const Reflection& pick : found)
  {
    text << InSamples(pick.Place) << ' ' << pick.Thickness << ' ' << pick.Amplitude << ' ' << pick.Strength << "; ";
  }
  return text.str();
}

ReflectionRules Middle(float threshold = 0.0F)
{
  return { ReflectionPolarity::Both, ReflectionPosition::Middle, threshold };
}

void TestPeaks()
{
  CHECK_EQUAL(Picks({}), "");
  CHECK_EQUAL(Picks({ 0, 0, 0 }), "");
  CHECK_EQUAL(Picks({ 3 }), "0 1 3 3; ");
  CHECK_EQUAL(Picks({ -3 }), "0 1 -3 3; ");
  CHECK_EQUAL(Picks({ 0, 1, 2, 1, 0 }), "2 3 1.333 2; ");
  CHECK_EQUAL(Picks({ 1, 2, 1, -1, -4, -1 }), "1 3 1.333 2; 4 3 -2 4; ");
  // The first and the last sample.
  CHECK_EQUAL(Picks({ 4, 2, 0, 0, -2, -4 }), "0 2 3 4; 5 2 -3 4; ");
  // Each local maximum of a run, with the mean of the whole run.
  CHECK_EQUAL(Picks({ 0, 3, 1, 3, 0, 0 }), "1.1 3 2.333 3; 2.9 3 2.333 3; ");
  CHECK_EQUAL(Picks({ 1, 2, 3, 4, 0, 0 }), "2.7 4 2.5 4; ");
}

/// The parabola through -1, 0 and 1 whose values are 1, 3 and 2 has its vertex at 1/6; through zeros of other signs
/// too.
void TestParabola()
{
  CHECK_EQUAL(Picks({ 0, 1, 3, 2, 0 }), "2.167 3 2 3; ");
  CHECK_EQUAL(Picks({ 0, -2, -3, -1, 0 }), "1.833 3 -2 3; ");
  CHECK_EQUAL(Picks({ -1, 3, 1, 0 }), "0 1 -1 1; 1.167 2 2 3; ");
  // Not beyond the half, whatever is beside.
  const std::string far = Picks({ 0, 1, 1.0000001F, -1e30F, 0 });
  CHECK_EQUAL(far.substr(0, 3), "1.5");
  std::vector<Reflection> found;
  const std::vector<float> steep = { 0.0F, 1.0F, 1.0000001F, -1e30F };
  FindReflections(steep.data(), 4, ReflectionRules(), found);
  CHECK_EQUAL(NearestSample(found[0].Place), 2);
}

/// Several equal samples: their middle.
void TestPlateaus()
{
  CHECK_EQUAL(Picks({ 0, 2, 2, 0 }), "1.5 2 2 2; ");
  CHECK_EQUAL(Picks({ 1, 2, 2, 2, 1 }), "2 5 1.6 2; ");
  CHECK_EQUAL(Picks({ 2, 2, 1, 2, 2 }), "0.5 5 1.8 2; 3.5 5 1.8 2; ");
  // A step on the way up or down is no peak.
  CHECK_EQUAL(Picks({ 0, 1, 1, 2, 1, 1, 0 }), "3 5 1.2 2; ");
}

void TestMissing()
{
  CHECK_EQUAL(Picks({ Missing, Missing }), "");
  CHECK_EQUAL(Picks({ 1, Missing, 1 }), "0 1 1 1; 2 1 1 1; ");
  // No parabola through a sample that is not there.
  CHECK_EQUAL(Picks({ 0, 1, 3, Missing }), "2 2 2 3; ");
}

void TestMiddle()
{
  CHECK_EQUAL(Picks({ 0, 1, 5, 1, 0 }, Middle()), "2 3 2.333 5; ");
  CHECK_EQUAL(Picks({ 5, 1, 1, 1 }, Middle()), "1.5 4 2 5; ");
  CHECK_EQUAL(Picks({ 1, 2, -2, -1 }, Middle()), "0.5 2 1.5 2; 2.5 2 -1.5 2; ");
  CHECK_EQUAL(Picks({ 3, 1, 3 }, Middle()), "1 3 2.333 3; ");
  // Samples below the threshold belong to no run, as in figure 2.5 of the thesis.
  CHECK_EQUAL(Picks({ 1, 2, 3, 2, 1 }, Middle(2)), "2 3 2.333 3; ");
  CHECK_EQUAL(Picks({ 3, 1, -3 }, Middle(3)), "0 1 3 3; 2 1 -3 3; ");
  CHECK_EQUAL(Picks({ 1, 1 }, Middle(2)), "");
}

void TestCrossings()
{
  const auto picks = [](const std::vector<float>& trace, ReflectionPolarity polarity = ReflectionPolarity::Both) {
    return Picks(trace, { polarity, ReflectionPosition::ZeroCrossing, 0 });
  };
  CHECK_EQUAL(picks({ 1, 2, -2, -1 }), "1.5 2 -2 2; ");
  CHECK_EQUAL(picks({ -1, -3, 1, 0 }), "1.75 2 2 2; ");
  CHECK_EQUAL(picks({ 1, -1, 1 }), "0.5 1 -1 1; 1.5 1 1 1; ");
  CHECK_EQUAL(picks({ 1, -1, 1 }, ReflectionPolarity::Positive), "1.5 1 1 1; ");
  CHECK_EQUAL(picks({ 1, -1, 1 }, ReflectionPolarity::Negative), "0.5 1 -1 1; ");
  // One sample of 0 is the crossing; more of them are none, and neither is what is missing, or the end of a trace.
  CHECK_EQUAL(picks({ 1, 0, -1 }), "1 1 -1 1; ");
  CHECK_EQUAL(picks({ 1, 0, 0, -1 }), "");
  CHECK_EQUAL(picks({ 1, 0, 1 }), "");
  CHECK_EQUAL(picks({ 1, Missing, -1 }), "");
  CHECK_EQUAL(picks({ 0, 1, 2 }), "");
  // Next to nothing on one side, and as much as there is.
  CHECK_EQUAL(
    picks({ std::numeric_limits<float>::denorm_min(), -std::numeric_limits<float>::max() }).substr(0, 2), "0 ");
}

void TestPolarity()
{
  const std::vector<float> trace = { 1, -2, 3 };
  CHECK_EQUAL(Picks(trace, { ReflectionPolarity::Positive, ReflectionPosition::Middle, 0 }), "0 1 1 1; 2 1 3 3; ");
  CHECK_EQUAL(Picks(trace, { ReflectionPolarity::Negative, ReflectionPosition::Middle, 0 }), "1 1 -2 2; ");
}

/// The smallest and the largest numbers there are.
void TestExtremes()
{
  constexpr float least = std::numeric_limits<float>::denorm_min();
  constexpr float most = std::numeric_limits<float>::max();
  std::vector<Reflection> found;
  const std::vector<float> trace = { least, -least, most, most, -most, -0.0F };
  FindReflections(trace.data(), int(trace.size()), ReflectionRules(), found);
  CHECK_EQUAL(found.size(), 4u);
  CHECK_EQUAL(found[2].Amplitude, most);
  CHECK_EQUAL(found[3].Amplitude, -most);
}
}

int TestReflectionRuns(int, char*[])
{
  TestPeaks();
  TestParabola();
  TestPlateaus();
  TestMissing();
  TestMiddle();
  TestCrossings();
  TestPolarity();
  TestExtremes();
  return Check::Result();
}
