// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/SpacePoints.h"
#include "Tools/Check.h"

#include <cstddef>
#include <vector>

namespace
{
using namespace SeismicHorizons;

using Ids = std::vector<PointId>;

KeptPoints Keep(const Ids& points, std::size_t total)
{
  KeptPoints kept(total);
  for (const PointId point : points)
  {
    kept.Append(point);
  }
  return kept;
}

/// The points of some of the kept ones, as runs tell them.
Ids Tell(const KeptPoints& kept, std::size_t first, std::size_t last, int& runs)
{
  Ids points;
  runs = 0;
  kept.ForEachRun(first, last,
    [&](std::size_t n, PointId point, std::size_t length)
    {
      CHECK_EQUAL(n, first + points.size());
      ++runs;
      for (std::size_t next = 0; next < length; ++next)
      {
        points.push_back(point + PointId(next));
      }
    });
  return points;
}

/// In any order, from any one to any other one.
void TestRuns()
{
  for (const Ids& points : { Ids{}, Ids{ 0, 1, 2, 3 }, Ids{ 1, 2, 3, 7, 9, 10 }, Ids{ 9, 3, 4, 4, 5, 0 } })
  {
    const KeptPoints kept = Keep(points, 11);
    CHECK_EQUAL(kept.size(), points.size());
    CHECK(!kept.AreAll());
    for (std::size_t first = 0; first <= points.size(); ++first)
    {
      for (std::size_t last = first; last <= points.size(); ++last)
      {
        int runs = 0;
        CHECK(Tell(kept, first, last, runs) ==
          Ids(points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(last)));
      }
    }
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      CHECK_EQUAL(kept[n], points[n]);
    }
  }
  int runs = 0;
  Tell(Keep({ 1, 2, 3, 7, 9, 10 }, 11), 0, 6, runs);
  CHECK_EQUAL(runs, 3);
}

void TestAll()
{
  CHECK(KeptPoints::All(5).AreAll());
  CHECK(Keep({ 0, 1, 2 }, 3).AreAll());
  CHECK(!Keep({ 0, 2, 1 }, 3).AreAll());
  CHECK(!Keep({ 0, 1 }, 3).AreAll());
  CHECK(KeptPoints().AreAll() && KeptPoints().empty());
  CHECK(KeptPoints::All(0).AreAll());
}

void TestSelect()
{
  const KeptPoints kept = Keep({ 1, 2, 4 }, 6);
  CHECK(kept.Select(std::vector<double>{ 0.0, 0.1, 0.2, 0.3, 0.4, 0.5 }) == std::vector<double>({ 0.1, 0.2, 0.4 }));
  CHECK(kept.Numbers() == Ids({ NoPoint, 0, 1, NoPoint, 2, NoPoint }));
}

void TestDropped()
{
  const DroppedPoints dropped = { { 0, 1 }, { 3, 4 }, { 4, 5 }, { 8, 7 } };
  const KeptPoints kept = KeepOthers(dropped, 9);
  CHECK_EQUAL(kept.size(), 5u);
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    CHECK_EQUAL(NumberWithout(dropped, kept[n]), PointId(n));
  }
  Loops loops;
  for (const PointId point : { 7, 5, 1 })
  {
    loops.Append(point);
  }
  loops.Close();
  const Loops renumbered = RenumberWithout(dropped, loops);
  CHECK(Ids(renumbered.begin(0), renumbered.end(0)) == Ids({ 4, 2, 0 }));
  CHECK(KeepOthers({}, 9).AreAll());
}

void TestSpacePoints()
{
  BoundedHorizon horizon;
  horizon.SubVoxelsPerColumn = 4;
  horizon.Plane = { { 8, -4 }, { 7, 0 }, { 0, -1 } };
  horizon.Height = { 1.5, 2.5, 3.5 };
  const SpacePoints points(horizon);
  CHECK(points[0].X == 2.0 && points[0].Y == -1.0 && points[0].Z == 1.5);
  CHECK(points[1].X == 1.75 && points[2].Y == -0.25);
  const SpacePoints byFunction(
    horizon.Plane, [](std::size_t point) { return 0.5 * double(point); }, 4);
  CHECK(byFunction[2].Z == 1.0 && byFunction[2].Y == points[2].Y);
}
}

int TestKeptPoints(int, char*[])
{
  TestRuns();
  TestAll();
  TestSelect();
  TestDropped();
  TestSpacePoints();
  return Check::Result();
}
