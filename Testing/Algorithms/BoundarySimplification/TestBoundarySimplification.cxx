// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

using namespace TestHorizons;

namespace
{
/// A strip two rows high: the lower row has the given heights, the upper one is level.
BoundedHorizon Strip(const std::vector<double>& heights)
{
  const std::string row(heights.size(), '#');
  std::vector<double> all = heights;
  all.resize(2 * heights.size(), 0.0);
  return MakeHorizon(Patches::FromPicture({ row, row }), all);
}

BoundarySimplification Simplify(const BoundedHorizon& horizon, double threshold)
{
  return SimplifyBoundary(horizon, horizon.Boundary, threshold);
}

/// Which points of the lower row of a strip stay.
std::vector<PointId> KeptBelow(const std::vector<double>& heights, double threshold)
{
  const BoundarySimplification result = Simplify(Strip(heights), threshold);
  const std::vector<PointId> targets = FindTargets(result, 2 * heights.size());
  std::vector<PointId> kept;
  for (PointId point = 0; point < PointId(heights.size()); ++point)
  {
    if (targets[std::size_t(point)] == point)
    {
      kept.push_back(point);
    }
  }
  return kept;
}

using Ids = std::vector<PointId>;

void TestLevelRunKeepsItsEnds()
{
  CHECK(KeptBelow({ 0, 0, 0, 0, 0, 0, 0 }, 0.4) == Ids({ 0, 6 }));
  const BoundarySimplification result = Simplify(Strip({ 0, 0, 0, 0, 0, 0, 0 }), 0.4);
  CHECK_EQUAL(result.Boundary.TotalLength(), 4u);
  CHECK_EQUAL(result.Deviation, 0.0);
}

/// Nothing is nearer than 0.
void TestThresholdZeroKeepsAll()
{
  CHECK(KeptBelow({ 0, 0, 0, 0 }, 0.0) == Ids({ 0, 1, 2, 3 }));
}

/// The peak is at distance 1 from the line through its neighbours; those are at 0.45 from theirs, then at 0.63. In the
/// first pass 1 goes, and after 2, 3 and 4, which stay, 5.
void TestPeak()
{
  CHECK(KeptBelow({ 0, 0, 0, 1, 0, 0, 0 }, 0.3) == Ids({ 0, 2, 3, 4, 6 }));
  CHECK(KeptBelow({ 0, 1, 0 }, 1.0) == Ids({ 0, 1, 2 })); // less than the threshold, not equal
  CHECK(KeptBelow({ 0, 1, 0 }, 1.001) == Ids({ 0, 2 }));
}

/// The first pass drops 1, goes on at 2 and drops 3, and so on; 2 and 4 are left for the next.
void TestSeveralPasses()
{
  CHECK(KeptBelow({ 0, 0.1, 0, 0.1, 0, 0.1, 0 }, 0.2) == Ids({ 0, 6 }));
}

/// Point 1 is 0.36 above the line from 0 to 2 when it is dropped, and point 2 as much above that from 0 to 4. In the
/// end point 1 is 0.54 away from the level edge that is left: beyond the threshold, which is reported.
void TestDeviationIsMeasured()
{
  const std::vector<double> heights = { 0, 0.54, 0.36, 0.18, 0 };
  CHECK(KeptBelow(heights, 0.4) == Ids({ 0, 4 }));
  CHECK(std::abs(Simplify(Strip(heights), 0.4).Deviation - 0.54) < 1e-12);
}

/// The dropped points count for the nearer end of the edge that spans them.
void TestDroppedPointsAreCounted()
{
  const BoundarySimplification result = Simplify(Strip({ 0, 0, 0, 0, 0, 0 }), 0.4);
  const PointId expected[] = { 0, 0, 0, 5, 5, 5 };
  for (std::size_t point = 0; point < 6; ++point)
  {
    CHECK_EQUAL(FindTargets(result, 12)[point], expected[point]);
  }
}

/// Which points of a level horizon are dropped, as columns.
std::vector<PlanePoint> Dropped(const std::vector<std::string>& picture)
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  const BoundarySimplification result = Simplify(MakeLevelHorizon(columns), 0.4);
  std::vector<PlanePoint> dropped;
  for (const DroppedPoint& one : result.Dropped)
  {
    dropped.push_back(columns[std::size_t(one.Point)]);
  }
  return dropped;
}

/// On a slope of one in two every point is a corner; only (2, 0) lies within a straight run, from (3, 0) to (1, 0).
void TestStaircaseStays()
{
  CHECK(Dropped({ "....##", "..####", "####.." }) == std::vector<PlanePoint>({ { 2, 0 } }));
}

/// The way out along a spur could drop points that the way back keeps, so spurs stay whole. (1, 0) is on the body.
void TestSpurStays()
{
  CHECK(Dropped({ "##....", "######" }) == std::vector<PlanePoint>({ { 1, 0 } }));
}

/// A loop that begins within a straight run, as those of other programs may, comes out as it does from its corner, and
/// begins there.
void TestLoopThatBeginsAnywhere()
{
  Patches::Random random(31);
  for (int n = 0; n < 60; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon horizon = MakeHorizon(columns, MakeHeights(columns, random));
    const double threshold = 2.0 * random.Fraction();
    const BoundarySimplification expected = Simplify(horizon, threshold);
    for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
    {
      Ids turned(horizon.Boundary.begin(loop), horizon.Boundary.end(loop));
      const std::size_t length = turned.size();
      std::rotate(turned.begin(), turned.begin() + random.Below(int(length)), turned.end());
      BoundedHorizon other = horizon;
      other.Boundary = Loops();
      std::for_each(turned.begin(), turned.end(), [&other](PointId point) { other.Boundary.Append(point); });
      other.Boundary.Close();
      const BoundarySimplification found = Simplify(other, threshold);
      Ids after(found.Boundary.begin(0), found.Boundary.end(0));
      const Ids wanted(expected.Boundary.begin(loop), expected.Boundary.end(loop));
      const auto first = std::find(after.begin(), after.end(), wanted.front());
      CHECK(first != after.end());
      std::rotate(after.begin(), first, after.end());
      if (std::count(after.begin(), after.end(), wanted.front()) == 1 && horizon.Boundary.Size() == 1)
      {
        CHECK((after == wanted));
        CHECK((FindTargets(found, columns.size()) == FindTargets(expected, columns.size())));
      }
    }
  }
}

void TestSmallestLoops()
{
  for (const std::vector<std::string>& picture :
    { std::vector<std::string>{ "#" }, std::vector<std::string>{ "##" }, std::vector<std::string>{ "#.", ".#" } })
  {
    const Patches::Columns columns = Patches::FromPicture(picture);
    const BoundedHorizon horizon = MakeLevelHorizon(columns);
    CHECK_EQUAL(Simplify(horizon, 10.0).Boundary.TotalLength(), columns.size());
  }
}

/// What must hold for every loop: a subset in the same order, starting with the same point, with the same outline in
/// plan, all dropped points on the edges that span them and within the reported deviation.
void CheckLoop(const std::vector<SpacePoint>& points, const Ids& before, const Ids& after, double deviation)
{
  CHECK_EQUAL(after.front(), before.front());
  std::size_t edge = 0;
  for (const PointId point : before)
  {
    if (edge < after.size() && point == after[edge])
    {
      ++edge;
      continue;
    }
    const SpacePoint& p = points[std::size_t(point)];
    const SpacePoint& a = points[std::size_t(after[edge - 1])];
    const SpacePoint& b = points[std::size_t(after[edge % after.size()])];
    CHECK_EQUAL((b.X - a.X) * (p.Y - a.Y), (b.Y - a.Y) * (p.X - a.X));
    const double part = std::hypot(p.X - a.X, p.Y - a.Y) / std::hypot(b.X - a.X, b.Y - a.Y);
    CHECK(part > 0.0 && part < 1.0);
    // Distances in space are not larger than those straight up.
    const double tilt = (b.Z - a.Z) / std::hypot(b.X - a.X, b.Y - a.Y);
    CHECK(std::abs(a.Z + part * (b.Z - a.Z) - p.Z) <= deviation * std::sqrt(1.0 + tilt * tilt) + 1e-9);
  }
  CHECK_EQUAL(edge, after.size());
}

void TestRandomPatches()
{
  Patches::Random random(7);
  for (int n = 0; n < 1000; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon horizon = MakeHorizon(columns, MakeHeights(columns, random));
    const BoundarySimplification result = Simplify(horizon, 2.0 * random.Fraction());
    CHECK_EQUAL(result.Boundary.Size(), horizon.Boundary.Size());
    for (std::size_t loop = 0; loop < result.Boundary.Size(); ++loop)
    {
      CheckLoop(ToSpacePoints(horizon), Ids(horizon.Boundary.begin(loop), horizon.Boundary.end(loop)),
        Ids(result.Boundary.begin(loop), result.Boundary.end(loop)), result.Deviation);
    }
    const BoundedHorizon dropped = Drop(horizon, result);
    CHECK_EQUAL(
      std::accumulate(dropped.Count.begin(), dropped.Count.end(), std::int64_t(0)), std::int64_t(columns.size()));
  }
}

BoundarySimplificationOptions RandomOptions(Patches::Random& random)
{
  BoundarySimplificationOptions options;
  options.DistanceThreshold = 2.0 * random.Fraction();
  options.BoundDeviation = random.Chance(0.5);
  options.OutlineTolerance = 3.0 * random.Fraction();
  return options;
}

/// The peak of a long roof may not be levelled bit by bit.
void TestBoundDeviation()
{
  const std::vector<double> heights = { 0, 0.54, 0.36, 0.18, 0 };
  BoundarySimplificationOptions options;
  options.BoundDeviation = true;
  const BoundedHorizon strip = Strip(heights);
  const BoundarySimplification result = SimplifyBoundary(strip, strip.Boundary, options);
  CHECK(result.Deviation > 0.0 && result.Deviation <= 0.4);
  Patches::Random random(8);
  for (int n = 0; n < 300; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon horizon = MakeHorizon(columns, MakeHeights(columns, random));
    options.DistanceThreshold = 2.0 * random.Fraction();
    options.OutlineTolerance = n / int(Patches::Shape::Count) % 2; // corners, too, are dropped one by one
    const BoundarySimplification bound = SimplifyBoundary(horizon, horizon.Boundary, options);
    CHECK(bound.Deviation <= std::hypot(options.DistanceThreshold, options.OutlineTolerance));
    CHECK(bound.OutlineDeviation <= options.OutlineTolerance);
  }
}

/// A right triangle on the lattice: with a tolerance its staircase goes, and points at most so far outside with it.
void TestStaircase()
{
  std::vector<std::string> picture;
  for (int row = 0; row < 9; ++row)
  {
    picture.push_back(std::string(std::size_t(2 * row + 2), '#'));
  }
  const Patches::Columns columns = Patches::FromPicture(picture);
  const BoundedHorizon horizon = MakeHorizon(columns, std::vector<double>(columns.size(), 5.0));
  BoundarySimplificationOptions options;
  const std::size_t before = SimplifyBoundary(horizon, horizon.Boundary, options).Boundary.TotalLength();
  options.OutlineTolerance = 0.5;
  const BoundarySimplification result = SimplifyBoundary(horizon, horizon.Boundary, options);
  CHECK_EQUAL(before, 20u);
  CHECK_EQUAL(result.Boundary.TotalLength(), 5u);
  CHECK(result.OutlineDeviation > 0.4 && result.OutlineDeviation <= 0.5);
  CHECK_EQUAL(
    MeshChecker::CheckMesh(Drop(horizon, result), Triangulate(Drop(horizon, result)).Triangles), std::string());
}

/// How far a place is from the nearest of a loop's edges, in plan.
double DistanceToLoop(const std::vector<SpacePoint>& points, const Loops& boundary, std::size_t loop, PointId point)
{
  const SpacePoint& p = points[std::size_t(point)];
  double nearest =
    std::hypot(points[std::size_t(*boundary.begin(loop))].X - p.X, points[std::size_t(*boundary.begin(loop))].Y - p.Y);
  boundary.ForEachEdgeOf(loop,
    [&](PointId from, PointId to)
    {
      const SpacePoint& a = points[std::size_t(from)];
      const double x = points[std::size_t(to)].X - a.X;
      const double y = points[std::size_t(to)].Y - a.Y;
      const double part = std::clamp(((p.X - a.X) * x + (p.Y - a.Y) * y) / (x * x + y * y), 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(a.X + part * x - p.X, a.Y + part * y - p.Y));
    });
  return nearest;
}

/// With a tolerance in plan: dropped points stay within it of their loop; nothing crosses, no point changes sides.
void TestOutlineTolerance()
{
  Patches::Random random(9);
  for (int n = 0; n < 1500; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    BoundaryOptions kind;
    kind.Radius = 1 + random.Below(3);
    kind.Growth = GrowthStrategy(random.Below(2));
    kind.KeepHoles = random.Chance(0.5);
    const BoundedHorizon horizon = MakeHorizon(columns, MakeHeights(columns, random), kind);
    const BoundarySimplificationOptions options = RandomOptions(random);
    const std::vector<SpacePoint> points = ToSpacePoints(horizon);
    const BoundarySimplification result = SimplifyBoundary(horizon, horizon.Boundary, options);
    CHECK(result.OutlineDeviation <= options.OutlineTolerance);
    for (std::size_t loop = 0; loop < result.Boundary.Size(); ++loop)
    {
      CHECK_EQUAL(*result.Boundary.begin(loop), *horizon.Boundary.begin(loop));
      std::for_each(horizon.Boundary.begin(loop), horizon.Boundary.end(loop),
        [&](PointId point)
        { CHECK(DistanceToLoop(points, result.Boundary, loop, point) <= options.OutlineTolerance + 1e-9); });
    }
    // A mesh with the areas of its loops and all points as corners shows the rest.
    const BoundedHorizon dropped = Drop(horizon, result);
    CHECK_EQUAL(BoundaryChecker::CheckCrossings(dropped), std::string());
    CHECK_EQUAL(MeshChecker::CheckMesh(dropped, Triangulate(dropped).Triangles), std::string());
  }
}

/// A pillar that leans over a bay, and an island in a lagoon: cutting the corner would run over a point.
void TestPointsInTheWay()
{
  BoundarySimplificationOptions options;
  options.OutlineTolerance = 10.0;
  const Patches::Columns columns = Patches::FromPicture({ "#####", "#...#", "#.#.#", "#...#", "#####" });
  BoundaryOptions holes;
  holes.KeepHoles = true;
  const BoundedHorizon horizon = MakeLevelHorizon(columns, holes);
  const BoundedHorizon result = Drop(horizon, SimplifyBoundary(horizon, horizon.Boundary, options));
  CHECK_EQUAL(result.Boundary.Size(), 3u);
  CHECK_EQUAL(BoundaryChecker::CheckCrossings(result), std::string());
  CHECK_EQUAL(MeshChecker::CheckMesh(result, Triangulate(result).Triangles), std::string());
}

void TestErrors()
{
  const BoundedHorizon horizon = Strip({ 0, 0, 0 });
  CHECK_THROWS_WITH(Simplify(horizon, -0.5), "distance threshold -0.5, expected at least 0 lattice units");
  CHECK_THROWS_WITH(Simplify(horizon, std::numeric_limits<double>::quiet_NaN()), "distance threshold nan");
  BoundarySimplificationOptions options;
  options.OutlineTolerance = -1.0;
  CHECK_THROWS_WITH(
    SimplifyBoundary(horizon, horizon.Boundary, options), "outline tolerance -1, expected at least 0 columns");
}

/// Each of many loops can be the last.
void TestMonitor()
{
  std::string picture;
  for (int patch = 0; patch < 200; ++patch)
  {
    picture += "#.";
  }
  const BoundedHorizon horizon = MakeHorizon(Patches::FromPicture({ picture }), std::vector<double>(200, 0.0));
  CHECK_EQUAL(MonitorChecker::Check(
                4, [&](const Monitor& monitor) { SimplifyBoundary(horizon, horizon.Boundary, 0.4, monitor); }),
    std::string());
}
}

int TestBoundarySimplification(int, char*[])
{
  TestLevelRunKeepsItsEnds();
  TestThresholdZeroKeepsAll();
  TestPeak();
  TestSeveralPasses();
  TestDeviationIsMeasured();
  TestDroppedPointsAreCounted();
  TestStaircaseStays();
  TestSpurStays();
  TestLoopThatBeginsAnywhere();
  TestSmallestLoops();
  TestRandomPatches();
  TestBoundDeviation();
  TestStaircase();
  TestOutlineTolerance();
  TestPointsInTheWay();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
