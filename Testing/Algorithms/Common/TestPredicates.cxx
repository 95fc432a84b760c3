// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/Predicates.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
void TestSignedArea()
{
  CHECK_EQUAL(SignedArea({ 0, 0 }, { 2, 0 }, { 0, 3 }), 6);
  CHECK_EQUAL(SignedArea({ 0, 0 }, { 0, 3 }, { 2, 0 }), -6);
  CHECK_EQUAL(SignedArea({ 1, 1 }, { 3, 3 }, { 7, 7 }), 0);
  // The largest coordinates there are, and a point off the line by one.
  const std::int32_t far = (1 << 29) - 1;
  CHECK_EQUAL(SignedArea({ 0, 0 }, { far, far }, { far - 1, far - 1 }), 0);
  CHECK(SignedArea({ 0, 0 }, { far, far }, { far - 1, far }) > 0);
}

void TestSegments()
{
  CHECK(ProperlyCross({ 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 }));
  CHECK(!ProperlyCross({ 0, 0 }, { 2, 2 }, { 2, 2 }, { 4, 0 })); // meet at an end
  CHECK(!ProperlyCross({ 0, 0 }, { 2, 2 }, { 1, 1 }, { 4, 0 })); // end on the other
  CHECK(!ProperlyCross({ 0, 0 }, { 4, 4 }, { 1, 1 }, { 3, 3 })); // one on the other
  CHECK(!ProperlyCross({ 0, 0 }, { 1, 0 }, { 3, -1 }, { 3, 1 }));
  CHECK(OnOpenSegment({ 0, 0 }, { 4, 2 }, { 2, 1 }));
  CHECK(!OnOpenSegment({ 0, 0 }, { 4, 2 }, { 4, 2 }));
  CHECK(!OnOpenSegment({ 0, 0 }, { 4, 2 }, { 6, 3 }));
  CHECK(!OnOpenSegment({ 0, 0 }, { 4, 2 }, { 2, 2 }));
}

void TestCircle()
{
  CHECK_EQUAL(InCircle({ 0, 0 }, { 4, 0 }, { 0, 4 }, { 1, 1 }), 1);
  CHECK_EQUAL(InCircle({ 0, 0 }, { 4, 0 }, { 0, 4 }, { 5, 5 }), -1);
  // Off a circle of the largest size by one: doubles alone cannot tell.
  const std::int32_t far = (1 << 29) - 1;
  CHECK_EQUAL(InCircle({ 0, 0 }, { far, 0 }, { far, far }, { 1, far }), 1);
  CHECK_EQUAL(InCircle({ 1, 0 }, { far, 0 }, { far, far }, { 0, far }), -1);
}

/// All full blocks of a lattice are cut along the same diagonal.
void TestLatticeBlock()
{
  for (int x = 0; x < 3; ++x)
  {
    const PlanePoint a{ x, 7 };
    const PlanePoint b{ x + 1, 7 };
    const PlanePoint c{ x + 1, 8 };
    const PlanePoint d{ x, 8 };
    CHECK_EQUAL(InCircle(a, b, c, d), InCircle({ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }));
  }
}

/// On one circle: no ties; the same answer for every way to ask; one diagonal is right when the other is wrong.
void TestTies(Patches::Random& random)
{
  // The lattice points at distance 65 from the origin, counter-clockwise.
  const PlanePoint circle[] = { { 65, 0 }, { 63, 16 }, { 60, 25 }, { 56, 33 }, { 52, 39 }, { 39, 52 }, { 33, 56 },
    { 25, 60 }, { 16, 63 }, { 0, 65 }, { -16, 63 }, { -25, 60 }, { -33, 56 }, { -39, 52 }, { -52, 39 }, { -56, 33 },
    { -60, 25 }, { -63, 16 }, { -65, 0 }, { -63, -16 }, { -60, -25 }, { -39, -52 }, { 0, -65 }, { 16, -63 },
    { 52, -39 }, { 63, -16 } };
  const int size = int(sizeof(circle) / sizeof(circle[0]));
  for (int n = 0; n < 2000; ++n)
  {
    int order[4] = { random.Below(size), random.Below(size), random.Below(size), random.Below(size) };
    std::sort(order, order + 4);
    if (std::adjacent_find(order, order + 4) != order + 4)
    {
      continue;
    }
    const PlanePoint& a = circle[order[0]];
    const PlanePoint& b = circle[order[1]];
    const PlanePoint& c = circle[order[2]];
    const PlanePoint& d = circle[order[3]];
    const int answer = InCircle(a, b, c, d);
    CHECK(answer != 0);
    CHECK_EQUAL(InCircle(b, c, a, d), answer);
    CHECK_EQUAL(InCircle(c, d, a, b), answer);
    CHECK_EQUAL(InCircle(b, c, d, a), -answer);
    const PlanePoint shift{ 1000 + random.Below(1000), random.Below(1000) };
    const auto moved = [&shift](const PlanePoint& p) { return PlanePoint{ p.X + shift.X, p.Y + shift.Y }; };
    CHECK_EQUAL(InCircle(moved(a), moved(b), moved(c), moved(d)), answer);
  }
}

/// On circles of the largest size a sum of doubles is hardly ever the 0 it should be. Ties are broken as on small ones.
void TestLargeTies(Patches::Random& random)
{
  const PlanePoint circle[] = { { 65, 0 }, { 63, 16 }, { 60, 25 }, { 52, 39 }, { 25, 60 }, { 0, 65 }, { -33, 56 },
    { -65, 0 }, { -39, -52 }, { 16, -63 } };
  for (int n = 0; n < 2000; ++n)
  {
    const int first = random.Below(7);
    const PlanePoint* const p = circle + first;
    const std::int32_t factor = 8000001 + random.Below(200000); // below 2^29 in the end
    const auto large = [&](int point) { return PlanePoint{ factor * p[point].X, factor * p[point].Y }; };
    CHECK_EQUAL(InCircle(large(0), large(1), large(2), large(3)), InCircle(p[0], p[1], p[2], p[3]));
  }
}

/// The order of circles through an edge has no cycles: the search keeps the best so far and never looks back.
void TestOrderOfCircles(Patches::Random& random)
{
  const PlanePoint a{ 3, 3 };
  const PlanePoint b{ 6, 3 };
  for (int n = 0; n < 5000; ++n)
  {
    PlanePoint p[3];
    for (PlanePoint& point : p)
    {
      point = { random.Below(10), 4 + random.Below(6) };
    }
    if (p[0] == p[1] || p[1] == p[2] || p[0] == p[2])
    {
      continue;
    }
    const bool first = InCircle(a, b, p[0], p[1]) > 0;
    const bool second = InCircle(a, b, p[1], p[2]) > 0;
    const bool third = InCircle(a, b, p[0], p[2]) > 0;
    CHECK(!(first && second) || third);
    CHECK(first != (InCircle(a, b, p[1], p[0]) > 0));
  }
}
}

int TestPredicates(int, char*[])
{
  Patches::Random random(1);
  TestSignedArea();
  TestSegments();
  TestCircle();
  TestLatticeBlock();
  TestTies(random);
  TestLargeTies(random);
  TestOrderOfCircles(random);
  return Check::Result();
}
