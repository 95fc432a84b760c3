// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Check.h"
#include "ExteriorBoundary.h"
#include "MeshChecker.h"
#include "Patches.h"

#include <algorithm>
#include <set>
#include <sstream>

using namespace SeismicHorizons;

namespace
{
/// The loops as text, a column each, like "0,0 0,1 | 5,5".
std::string Text(const std::vector<PlanePoint>& columns, const Loops& loops)
{
  std::ostringstream text;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    text << (loop == 0 ? "" : "|");
    std::for_each(loops.begin(loop), loops.end(loop),
      [&](PointId point) { text << ' ' << columns[std::size_t(point)].X << ',' << columns[std::size_t(point)].Y; });
  }
  return text.str();
}

std::string LoopsOf(const std::vector<std::string>& picture)
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  return Text(columns, FindExteriorBoundary(columns).Boundary);
}

void TestSmallPatches()
{
  CHECK_EQUAL(LoopsOf({ "#" }), " 0,0");
  CHECK_EQUAL(LoopsOf({ "##" }), " 0,0 1,0");
  CHECK_EQUAL(LoopsOf({ "##", "##" }), " 0,0 0,1 1,1 1,0");
  // The middle of three by three is inside, whether it is there or not.
  CHECK_EQUAL(LoopsOf({ "###", "###", "###" }), " 0,0 0,1 0,2 1,2 2,2 2,1 2,0 1,0");
  CHECK_EQUAL(LoopsOf({ "###", "#.#", "###" }), " 0,0 0,1 0,2 1,2 2,2 2,1 2,0 1,0");
  // A plus: hops are diagonal, and the middle is inside.
  CHECK_EQUAL(LoopsOf({ ".#.", "###", ".#." }), " 0,1 1,2 2,1 1,0");
}

void TestSpur()
{
  CHECK_EQUAL(LoopsOf({ "##..", "####" }), " 0,0 0,1 1,1 2,0 3,0 2,0 1,0");
}

/// The first point is where two lobes touch: a walk that stops at its first return would lose one of them.
void TestPinchAtFirstPoint()
{
  CHECK_EQUAL(LoopsOf({ ".#", "#.", ".#" }), " 0,1 1,2 0,1 1,0");
  CHECK_EQUAL(LoopsOf({ ".##", ".##", "#..", ".##", ".##" }), " 0,2 1,3 1,4 2,4 2,3 1,3 0,2 1,1 2,1 2,0 1,0 1,1");
}

void TestSeveralPatches()
{
  // Numbered by rows from below; the loop of each starts at its least x.
  CHECK_EQUAL(LoopsOf({ "#...", "....", "..##" }), " 2,0 3,0| 0,2");
}

/// An island in a hole belongs to the patch around it, however deep they are nested.
void TestIslands()
{
  const Patches::Columns columns = Patches::FromPicture({
    "#######",
    "#.....#",
    "#.###.#",
    "#.#.#.#",
    "#.###.#",
    "#.....#",
    "#######",
  });
  const ExteriorBoundary boundary = FindExteriorBoundary(columns);
  CHECK_EQUAL(boundary.Boundary.Size(), 1u);
  CHECK_EQUAL(boundary.Boundary.TotalLength(), 24u);
  CHECK_EQUAL(std::count(boundary.Patch.begin(), boundary.Patch.end(), 0), std::ptrdiff_t(columns.size()));
}

/// An open ring encloses nothing: what lies in it is a patch of its own.
void TestOpenRing()
{
  const Patches::Columns columns = Patches::FromPicture({ "#####", "#....", "#.#.#", "#...#", "#####" });
  CHECK_EQUAL(FindExteriorBoundary(columns).Boundary.Size(), 2u);
}

void TestRandomPatches()
{
  Patches::Random random(2);
  for (int shape = 0; shape < int(Patches::Shape::Count); ++shape)
  {
    for (int n = 0; n < 300; ++n)
    {
      const Patches::Columns columns = Patches::Make(Patches::Shape(shape), random);
      CHECK_EQUAL(MeshChecker::CheckExteriorBoundary(columns, FindExteriorBoundary(columns)), std::string());
    }
  }
}

void TestOrderOfPointsIsNoMatter()
{
  Patches::Random random(3);
  for (int n = 0; n < 100; ++n)
  {
    Patches::Columns columns = Patches::Make(Patches::Shape::Sparse, random);
    const std::string before = Text(columns, FindExteriorBoundary(columns).Boundary);
    std::reverse(columns.begin(), columns.end());
    CHECK_EQUAL(Text(columns, FindExteriorBoundary(columns).Boundary), before);
  }
}

void TestErrorsAndEmpty()
{
  CHECK_EQUAL(FindExteriorBoundary({}).Boundary.Size(), 0u);
  CHECK_THROWS_WITH(FindExteriorBoundary({ { 4, 7 }, { 3, 7 }, { 4, 7 } }),
    "points 0 and 2 both in column (4, 7), expected at most one point of a horizon in a column");
}

void TestAbort()
{
  const Monitor stop([](double) { return false; });
  CHECK_THROWS_WITH(FindExteriorBoundary(Patches::FromPicture({ "###" }), stop), "stopped on request");
}
}

int TestExteriorBoundary(int, char*[])
{
  TestSmallPatches();
  TestSpur();
  TestPinchAtFirstPoint();
  TestSeveralPatches();
  TestIslands();
  TestOpenRing();
  TestRandomPatches();
  TestOrderOfPointsIsNoMatter();
  TestErrorsAndEmpty();
  TestAbort();
  return Check::Result();
}
