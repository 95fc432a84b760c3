// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// No given pick is ever dropped, whatever the others of its guide say.

#include "PickFixtures.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace PickFixtures;

namespace
{
/// Picks on another event than the others of their guide are named and kept, but nothing around them follows; those near
/// nothing are not used.
void TestBadPicks()
{
  Traces traces = Empty({ 40, 30, 60 });
  for (int n = 0; n < 1200; ++n)
  {
    Put(traces.Trace(n % 40, n / 40), 10, 1.0F);
    Put(traces.Trace(n % 40, n / 40), 25, 2.0F);
    Put(traces.Trace(n % 40, n / 40), 40, -2.0F);
  }
  const Extraction found = Follow(traces,
    { { "upper", { { 3, 3, 10 }, { 30, 3, 10 }, { 20, 20, 25 }, { 3, 25, 10 }, { 35, 25, 10 }, { 9, 9, 17 } } } });
  CHECK_EQUAL(found.Guides[0].Strays.size(), 1u);
  CHECK_EQUAL(found.Guides[0].Strays.at(0), 2u);
  CHECK_EQUAL(found.Guides[0].NearNone.size(), 1u);
  CHECK_EQUAL(found.Guides[0].NearNone.at(0), 5u);
  CHECK_EQUAL(found.Surfaces[0].Column.size(), 1200u);
  CHECK_EQUAL(std::count(found.Surfaces[0].K.begin(), found.Surfaces[0].K.end(), 10), 1199);
  CHECK_EQUAL(found.Surfaces[0].K[20 * 40 + 20], 25);
  const Extraction mixed = Follow(traces, { { "mixed", { { 3, 3, 25 }, { 30, 3, 25 }, { 20, 20, 40 }, { 3, 3, 26 } } } });
  CHECK(!mixed.Guides[0].IsNegative);
  CHECK_EQUAL(mixed.Guides[0].OnOtherSign.size(), 1u);
  CHECK_EQUAL(mixed.Guides[0].OnOtherSign.at(0), 2u);
  CHECK_EQUAL(mixed.Guides[0].Doubled.size(), 1u);
  CHECK_EQUAL(mixed.Guides[0].Doubled.at(0), 3u);
  CHECK(mixed.Guides[0].NearNone.empty());
}

/// Two events run through the survey, and change places at a fault, as the layers around them show.
Traces TwoBlocks()
{
  Traces traces = Empty({ 60, 40, 80 });
  for (int n = 0; n < 2400; ++n)
  {
    const int i = n % 60;
    const int side = i < 40 ? 1 : -1;
    float* const trace = traces.Trace(i, n / 60);
    Put(trace, 30, 2.0F);
    Put(trace, 45, 2.0F);
    Put(trace, 30 + 5 * side, -0.7F);
    Put(trace, 45 - 5 * side, -0.7F);
  }
  return traces;
}

int SampleAt(const LatticeHorizon& surface, int i, int j)
{
  for (std::size_t n = 0; n < surface.Column.size(); ++n)
  {
    if (int(surface.Column[n].X) == i && int(surface.Column[n].Y) == j)
    {
      return surface.K[n];
    }
  }
  return -1;
}

/// Automatic surfaces pass the fault. The one pick behind it has its block, unless many contradict it.
void TestLonePick()
{
  const Traces traces = TwoBlocks();
  Guide guide = { "top", { { 3, 3, 30 }, { 30, 3, 30 }, { 50, 20, 45 } } };
  const Extraction found = Follow(traces, { guide });
  CHECK(found.Guides[0].Strays.empty());
  CHECK_EQUAL(SampleAt(found.Surfaces[0], 5, 20), 30);
  CHECK_EQUAL(SampleAt(found.Surfaces[0], 45, 5), 45);
  CHECK_EQUAL(SampleAt(found.Surfaces[0], 58, 38), 45);

  guide.Picks.insert(guide.Picks.end(), { { 20, 20, 30 }, { 3, 35, 30 } });
  const Extraction contradicted = Follow(traces, { guide });
  CHECK_EQUAL(contradicted.Guides[0].Strays.size(), 1u);
  CHECK_EQUAL(SampleAt(contradicted.Surfaces[0], 50, 20), 45);
}

/// Four events, each with a pick: each contradicts the others, and all are kept.
void TestAllContradicted()
{
  Traces traces = Empty({ 40, 30, 80 });
  Guide guide = { "top", {} };
  for (const int event : { 0, 1, 2, 3 })
  {
    for (int n = 0; n < 1200; ++n)
    {
      Put(traces.Trace(n % 40, n / 40), 10 + 18 * event, 1.0F);
    }
    guide.Picks.push_back({ 5 + 10 * event, 15, 10.0 + 18.0 * event });
  }
  const Extraction found = Follow(traces, { guide });
  CHECK_EQUAL(found.Guides[0].Strays.size(), 4u);
  CHECK_EQUAL(found.Surfaces[0].Column.size(), 1200u);
  for (const GuidePick& pick : guide.Picks)
  {
    CHECK_EQUAL(SampleAt(found.Surfaces[0], pick.I, pick.J), int(pick.Place));
  }
}
}

int TestContradictedPicks(int, char*[])
{
  TestBadPicks();
  TestLonePick();
  TestAllContradicted();
  return Check::Result();
}
