// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker of outlines must find each kind of damage.

#include "Check.h"
#include "ExactPlane.h"
#include "OutlineChecker.h"
#include "Patches.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
void TestDamagedBoundaries()
{
  const Patches::Columns columns = Patches::FromPicture({ "####", "#..#", "####", "...#" });
  const ExteriorBoundary sound = FindExteriorBoundary(columns);
  CHECK_EQUAL(OutlineChecker::CheckOutlines(columns, sound), std::string());

  ExteriorBoundary damaged = sound;
  damaged.Patch[3] = 1;
  CHECK(OutlineChecker::CheckOutlines(columns, damaged) != "");

  const auto withLoop = [&](std::vector<PointId> points)
  {
    ExteriorBoundary result = sound;
    result.Boundary = Loops();
    std::for_each(points.begin(), points.end(), [&](PointId point) { result.Boundary.Append(point); });
    result.Boundary.Close();
    return OutlineChecker::CheckOutlines(columns, result);
  };
  std::vector<PointId> loop(sound.Boundary.begin(0), sound.Boundary.end(0));
  CHECK_EQUAL(withLoop(loop), std::string());
  std::reverse(loop.begin() + 1, loop.end());
  CHECK_EQUAL(withLoop(loop), "direction of a loop");
  std::reverse(loop.begin() + 1, loop.end());
  std::rotate(loop.begin(), loop.begin() + 2, loop.end());
  CHECK_EQUAL(withLoop(loop), "first point of a loop");
  std::rotate(loop.begin(), loop.end() - 2, loop.end());
  loop.erase(loop.begin() + 3);
  CHECK(withLoop(loop) != "");
}

void TestLocate()
{
  const Patches::Columns square = Patches::FromPicture({ "###", "###", "###" });
  const Loops loops = FindExteriorBoundary(square).Boundary;
  CHECK_EQUAL(ExactPlane::Locate(square, loops, { 1, 1 }), 1);
  CHECK_EQUAL(ExactPlane::Locate(square, loops, { 2, 1 }), 0);
  CHECK_EQUAL(ExactPlane::Locate(square, loops, { 3, 1 }), -1);
}
}

int TestOutlineChecker(int, char*[])
{
  TestDamagedBoundaries();
  TestLocate();
  return Check::Result();
}
