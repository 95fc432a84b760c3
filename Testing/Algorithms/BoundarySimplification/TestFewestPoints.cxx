// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShortcutSearch.h"

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace TestHorizons;

namespace
{
BoundarySimplificationOptions Options(double tolerance, double threshold)
{
  BoundarySimplificationOptions options;
  options.Method = OutlineMethod::FewestPoints;
  options.OutlineTolerance = tolerance;
  options.DistanceThreshold = threshold;
  return options;
}

BoundarySimplification Simplify(const BoundedHorizon& horizon, double tolerance, double threshold)
{
  return SimplifyBoundary(OnColumns(horizon), horizon.Boundary, Options(tolerance, threshold));
}

/// The columns of the points that the loops of a level horizon keep.
std::set<PlanePoint> Kept(const std::vector<std::string>& picture, double tolerance)
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  const BoundedHorizon horizon = MakeLevelHorizon(columns);
  std::set<PlanePoint> kept;
  Simplify(horizon, tolerance, 0.0)
    .Boundary.ForEachPoint([&](PointId point) { kept.insert(columns[std::size_t(point)]); });
  return kept;
}

using Places = std::set<PlanePoint>;

/// Without tolerances straight level runs are shortened, and nothing else.
void TestRectangle()
{
  CHECK(Kept({ "#####", "#####", "#####" }, 0.0) == Places({ { 0, 0 }, { 4, 0 }, { 4, 2 }, { 0, 2 } }));
}

/// A bump of one column is 1 off the straight side, and the points next to it 0.63 off the lines from it to the
/// corners.
void TestBump()
{
  const std::vector<std::string> picture = { "...#...", "#######", "#######", "#######" };
  CHECK(Kept(picture, 0.0) == Places({ { 0, 0 }, { 6, 0 }, { 6, 2 }, { 4, 2 }, { 3, 3 }, { 2, 2 }, { 0, 2 } }));
  CHECK(Kept(picture, 0.9) == Places({ { 0, 0 }, { 6, 0 }, { 6, 2 }, { 3, 3 }, { 0, 2 } }));
  CHECK_EQUAL(Kept(picture, 1.0).size(), 4u);
}

/// The points of a staircase are up to 0.45 from its straight line; its end is a spur of one column.
void TestStaircase()
{
  std::vector<std::string> picture;
  for (int row = 0; row < 9; ++row)
  {
    picture.push_back(std::string(std::size_t(2 * row + 2), '#'));
  }
  CHECK_EQUAL(Kept(picture, 0.0).size(), 19u);
  CHECK(Kept(picture, 0.45) == Places({ { 0, 0 }, { 0, 8 }, { 16, 0 }, { 17, 0 } }));
}

/// A spur stays as it is, and so does a patch without an inside, whatever is allowed.
void TestNothingCollapses()
{
  CHECK(Kept({ "##....", "######" }, 0.0) ==
    Places({ { 0, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 5, 0 }, { 0, 1 }, { 1, 1 } }));
  CHECK_EQUAL(Kept({ "####" }, 100.0).size(), 4u);
  CHECK_EQUAL(Kept({ "#" }, 100.0).size(), 1u);
  CHECK_EQUAL(Kept({ "#.", ".#" }, 100.0).size(), 2u);
  CHECK_EQUAL(Kept({ "####", "####" }, 100.0).size(), 3u);
  CHECK_EQUAL(Kept({ "##", "##" }, 100.0).size(), 3u);
}

/// Heights decide along a straight side: one ridge of two slopes needs its top, whatever steps lead there.
void TestHeights()
{
  const Patches::Columns columns = Patches::FromPicture({ "#########", "#########" });
  std::vector<double> heights(columns.size(), 0.0);
  const double ridge[] = { 0.0, 1.2, 2.2, 3.0, 4.0, 3.0, 1.8, 1.0, 0.0 };
  std::copy(std::begin(ridge), std::end(ridge), heights.begin());
  const BoundedHorizon horizon = MakeHorizon(columns, heights);
  CHECK_EQUAL(Simplify(horizon, 0.0, 0.19).Boundary.TotalLength(), 7u);
  CHECK_EQUAL(Simplify(horizon, 0.0, 0.21).Boundary.TotalLength(), 5u);
  CHECK_EQUAL(Simplify(horizon, 0.0, 4.0).Boundary.TotalLength(), 4u);
  CHECK(std::abs(Simplify(horizon, 0.0, 4.0).Deviation - 4.0) < 1e-12);
}

/// The point between two hops in one direction, of which one is twice as long, goes without any tolerance, whatever
/// rounding does to their direction and slope.
void TestAlignedHops()
{
  for (int hop = 0; hop < 144; ++hop)
  {
    const int x = 1 + hop % 12;
    const int y = hop / 12;
    BoundedHorizon points;
    points.Plane = { { 0, 0 }, { x, y }, { 3 * x, 3 * y }, { 0, 50 } };
    points.Height = { 0, 1, 3, 0 };
    Loops loop;
    for (const PointId point : { 0, 3, 2, 1 })
    {
      loop.Append(point);
    }
    loop.Close();
    CHECK_EQUAL(SimplifyBoundary(points, loop, Options(0.0, 0.0)).Boundary.TotalLength(), 3u);
  }
}

/// Long sides on an even slope, of which points far from the ends are not looked at: rounding must not tear them apart.
void TestSlope()
{
  const std::string row(5000, '#');
  const Patches::Columns columns = Patches::FromPicture({ row, row, row });
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(3.0 * column.X + 5.0 * column.Y);
  }
  const BoundedHorizon horizon = MakeHorizon(columns, heights);
  const BoundarySimplification result = Simplify(horizon, 0.0, 0.0);
  CHECK(result.Deviation < 1e-9);
  CHECK_EQUAL(ShortcutSearch(horizon, 0.0, 0.0).CheckLoop(0, result.Boundary, 0), std::string());
  CHECK_EQUAL(Simplify(horizon, 0.0, 1e-6).Boundary.TotalLength(), 4u);
}

/// A straight side of far more points than are looked at from one: the corners are left, when it is level or all
/// heights may be; else edges that may be.
void TestLongSides()
{
  const std::string row(1300, '#');
  const Patches::Columns columns = Patches::FromPicture({ row, row, row });
  CHECK_EQUAL(Simplify(MakeLevelHorizon(columns), 0.0, 0.0).Boundary.TotalLength(), 4u);
  Patches::Random random(43);
  const BoundedHorizon horizon = MakeHorizon(columns, MakeHeights(columns, random));
  CHECK_EQUAL(Simplify(horizon, 0.0, 12.0).Boundary.TotalLength(), 4u);
  for (const double threshold : { 2.0, 6.0 })
  {
    const BoundarySimplification result = Simplify(horizon, 0.5, threshold);
    CHECK_EQUAL(ShortcutSearch(horizon, 0.5, threshold).CheckLoop(0, result.Boundary, 0), std::string());
  }
}

/// An island in a lagoon: the edges of the lagoon may not run over it, nor its own over the shore.
void TestPointsInTheWay()
{
  BoundaryOptions holes;
  holes.KeepHoles = true;
  const BoundedHorizon horizon =
    MakeLevelHorizon(Patches::FromPicture({ "#####", "#...#", "#.#.#", "#...#", "#####" }), holes);
  const BoundedHorizon result = Drop(horizon, Simplify(horizon, 10.0, 0.0));
  CHECK_EQUAL(result.Boundary.Size(), 3u);
  CHECK_EQUAL(BoundaryChecker::CheckCrossings(result), std::string());
  CHECK_EQUAL(MeshChecker::CheckMesh(result, Triangulate(result).Triangles), std::string());
}

/// Edges that were simplified before and cross wide bands without points: the corner of a hole stays on its side of
/// them.
void TestLongEdgesOverEmptyBands()
{
  const std::vector<PlanePoint> columns = { { 0, 0 }, { 15000, 1498 }, { 30000, 3000 }, { 30000, 30000 }, { 0, 30000 },
    { 10000, 999 }, { 10000, 1010 }, { 10010, 1010 } };
  const std::vector<double> heights(columns.size(), 0.0);
  Loops loops;
  for (PointId point = 0; point < 8; ++point)
  {
    loops.Append(point);
    if (point == 4 || point == 7)
    {
      loops.Close();
    }
  }
  std::vector<PointId> kept;
  SimplifyBoundary(SpacePoints(columns, heights, 1), loops, Options(2.0, 0.0))
    .Boundary.ForEachPoint([&kept](PointId point) { kept.push_back(point); });
  CHECK(kept == std::vector<PointId>({ 0, 1, 2, 3, 4, 5, 6, 7 }));
}

/// A random horizon with any radius, with holes or without.
BoundedHorizon RandomHorizon(int shape, Patches::Random& random)
{
  const Patches::Columns columns = Patches::Make(Patches::Shape(shape % int(Patches::Shape::Count)), random);
  BoundaryOptions kind;
  kind.Radius = 1 + random.Below(3);
  kind.Growth = GrowthStrategy(random.Below(2));
  kind.KeepHoles = random.Chance(0.5);
  return MakeHorizon(columns, MakeHeights(columns, random), kind);
}

/// Everything that is promised but the number: tolerances, no crossing, no point on another side.
void TestRandomPatches()
{
  Patches::Random random(41);
  for (int n = 0; n < 2500; ++n)
  {
    const BoundedHorizon horizon = RandomHorizon(n, random);
    const double tolerance = n % 4 == 0 ? 0.0 : 3.0 * random.Fraction();
    const double threshold = 2.0 * random.Fraction();
    const BoundarySimplification result = Simplify(horizon, tolerance, threshold);
    CHECK(result.OutlineDeviation <= tolerance);
    CHECK(result.Deviation <= std::hypot(tolerance, threshold) + 1e-9);
    const ShortcutSearch search(horizon, tolerance, threshold);
    for (std::size_t loop = 0; loop < result.Boundary.Size(); ++loop)
    {
      CHECK_EQUAL(search.CheckLoop(loop, result.Boundary, loop), std::string());
    }
    const BoundedHorizon dropped = Drop(horizon, result);
    CHECK_EQUAL(BoundaryChecker::CheckCrossings(dropped), std::string());
    CHECK_EQUAL(MeshChecker::CheckMesh(dropped, Triangulate(dropped).Triangles), std::string());
  }
}

/// With 0 and 0 every loop is what it was, on the map and in height, and only points that are on new edges go.
void TestNothingIsLost()
{
  Patches::Random random(44);
  for (int n = 0; n < 300; ++n)
  {
    const BoundedHorizon horizon = RandomHorizon(n, random);
    const BoundarySimplification result = Simplify(horizon, 0.0, 0.0);
    CHECK_EQUAL(result.Deviation, 0.0);
    CHECK_EQUAL(result.OutlineDeviation, 0.0);
    CHECK_EQUAL(MeshChecker::CheckMesh(Drop(horizon, result), Triangulate(Drop(horizon, result)).Triangles), "");
  }
}

/// No loop can have fewer points with one of those that it keeps. Hardly any could have fewer with another.
void TestNumberIsLeast()
{
  Patches::Random random(42);
  int loops = 0;
  int beyondLeast = 0;
  for (int n = 0; n < 400; ++n)
  {
    const BoundedHorizon horizon = RandomHorizon(n, random);
    const double tolerance = n % 4 == 0 ? 0.0 : 2.0 * random.Fraction();
    const double threshold = 1.5 * random.Fraction();
    const BoundarySimplification result = Simplify(horizon, tolerance, threshold);
    const ShortcutSearch search(horizon, tolerance, threshold);
    for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
    {
      const std::vector<std::size_t> least = search.LeastPoints(loop);
      std::size_t leastOfKept = result.Boundary.Length(loop) + 1;
      for (std::size_t position = 0; position < least.size(); ++position)
      {
        const PointId point = horizon.Boundary.begin(loop)[position];
        const bool isKept =
          std::find(result.Boundary.begin(loop), result.Boundary.end(loop), point) != result.Boundary.end(loop);
        CHECK(!isKept || least[position] <= result.Boundary.Length(loop));
        leastOfKept = isKept && least[position] == result.Boundary.Length(loop) ? least[position] : leastOfKept;
      }
      CHECK_EQUAL(leastOfKept, result.Boundary.Length(loop));
      const std::size_t beyond = result.Boundary.Length(loop) - *std::min_element(least.begin(), least.end());
      CHECK(beyond <= 1);
      beyondLeast += int(beyond);
      ++loops;
    }
  }
  CHECK(beyondLeast * 100 < loops);
}

std::vector<std::vector<PointId>> ToVectors(const Loops& loops)
{
  std::vector<std::vector<PointId>> vectors;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    vectors.emplace_back(loops.begin(loop), loops.end(loop));
  }
  return vectors;
}

/// What earlier calls found changes nothing, whichever points are fixed meanwhile.
void TestKnownChains()
{
  Patches::Random random(45);
  for (int n = 0; n < 300; ++n)
  {
    const BoundedHorizon horizon = RandomHorizon(n, random);
    BoundarySimplificationOptions options = Options(2.0 * random.Fraction(), 1.5 * random.Fraction());
    KeptOfChains known;
    for (int call = 0; call < 4; ++call)
    {
      options.Known = nullptr;
      const BoundarySimplification anew = SimplifyBoundary(OnColumns(horizon), horizon.Boundary, options);
      options.Known = &known;
      const BoundarySimplification again = SimplifyBoundary(OnColumns(horizon), horizon.Boundary, options);
      CHECK(ToVectors(again.Boundary) == ToVectors(anew.Boundary));
      options.Fixed.push_back(*(horizon.Boundary.begin(0) + random.Below(int(horizon.Boundary.Length(0)))));
    }
  }
}

/// With tolerances as large as the horizon any edge would be near enough, and only points in the way bar it: there are
/// fewer edges than with a small one.
void TestHugeTolerance()
{
  Patches::Columns columns;
  for (int x = -150; x <= 150; ++x)
  {
    for (int y = -150; y <= 150; ++y)
    {
      const double angle = std::atan2(y, x);
      if (std::hypot(x, y) < 130.0 + 12.0 * std::sin(7.0 * angle) + 6.0 * std::sin(31.0 * angle))
      {
        columns.push_back({ x + 150, y + 150 });
      }
    }
  }
  const BoundedHorizon horizon = MakeLevelHorizon(columns);
  const std::size_t coarse = Simplify(horizon, 1000.0, 1000.0).Boundary.TotalLength();
  CHECK(coarse >= 3 && coarse < Simplify(horizon, 3.0, 3.0).Boundary.TotalLength());
}

void TestErrors()
{
  const BoundedHorizon horizon = MakeLevelHorizon(Patches::FromPicture({ "####", "####", "####", "####" }));
  CHECK_THROWS_WITH(Simplify(horizon, -1.0, 0.5), "outline tolerance -1, expected at least 0 columns");
  CHECK_THROWS_WITH(Simplify(horizon, 1.0, -0.5), "distance threshold -0.5, expected at least 0 lattice units");
  BoundedHorizon twice = OnColumns(horizon);
  twice.Plane[5] = twice.Plane[6];
  CHECK_THROWS_WITH(SimplifyBoundary(twice, horizon.Boundary, Options(1.0, 1.0)),
    "points 5 and 6 both in column (2, 1), expected at most one point of a horizon in a column");
}

/// Also along one loop, which takes long.
void TestMonitor()
{
  const std::string row(3000, '#');
  const Patches::Columns columns = Patches::FromPicture({ row, row, row });
  Patches::Random random(45);
  const BoundedHorizon horizon = MakeHorizon(columns, MakeHeights(columns, random));
  const auto work = [&](const Monitor& monitor)
  { SimplifyBoundary(OnColumns(horizon), horizon.Boundary, Options(1.0, 1.0), monitor); };
  CHECK_EQUAL(MonitorChecker::Check(10, work), std::string());
}
}

int TestFewestPoints(int, char*[])
{
  TestRectangle();
  TestBump();
  TestStaircase();
  TestNothingCollapses();
  TestHeights();
  TestAlignedHops();
  TestSlope();
  TestLongSides();
  TestPointsInTheWay();
  TestLongEdgesOverEmptyBands();
  TestRandomPatches();
  TestNothingIsLost();
  TestNumberIsLeast();
  TestKnownChains();
  TestHugeTolerance();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
