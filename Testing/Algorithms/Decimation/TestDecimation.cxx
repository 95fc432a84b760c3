// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes within an error or of so many points: small cases, what each option does, errors.

#include "Common/Base/Parallel.h"
#include "DecimationChecker.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <cmath>
#include <limits>

using namespace SeismicHorizons;
using namespace DecimationChecker;

namespace
{
double Wave(const PlanePoint& column)
{
  return 8.0 * std::sin(0.2 * column.X) * std::cos(0.17 * column.Y);
}

Patches::Columns Square(int side)
{
  return Patches::FromPicture(std::vector<std::string>(std::size_t(side), std::string(std::size_t(side), '#')));
}

/// A plane needs no point beside its corners, whatever the bound.
void TestPlane()
{
  const Patches::Columns columns = Square(30);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(0.1 * column.X - 0.3 * column.Y + 1e6);
  }
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, heights));
  horizon = TestHorizons::Drop(horizon, SimplifyBoundary(horizon, horizon.Boundary, { 1e-6, false, 0.0 }));
  const Decimation result = Decimate(horizon, Within(0.0));
  CHECK_EQUAL(result.Points.Source.size(), 4u);
  CHECK_EQUAL(result.Triangles.size(), 6u);
  CHECK(result.LargestError < 1e-8);
  // Each of the two triangles is shared out among its corners.
  const BoundedHorizon reduced = TestHorizons::Reduce(horizon, result.Points);
  CHECK_EQUAL(std::accumulate(reduced.Count.begin(), reduced.Count.end(), std::int64_t(0)), 900);
  CHECK(*std::min_element(reduced.Count.begin(), reduced.Count.end()) > 120);
}

/// One spike: it and nothing else is needed when it is higher than the bound.
void TestSpike()
{
  const Patches::Columns columns = Square(21);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  horizon.Height[10 * 21 + 10] = 4.0;
  CHECK_EQUAL(Decimate(horizon, Within(4.0)).Points.Source.size(), 80u);
  const Decimation one = Decimate(horizon, Within(3.9));
  CHECK(one.LargestError <= 3.9);
  CHECK(one.Points.Target[10 * 21 + 10] != NoPoint);
  CHECK_EQUAL(one.Points.Source[std::size_t(one.Points.Target[10 * 21 + 10])], 10 * 21 + 10);
}

void TestNumberOfPoints()
{
  Patches::Random random(5);
  const Patches::Columns columns = Square(40);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  std::generate(horizon.Height.begin(), horizon.Height.end(), [&random]() { return random.Fraction(); });
  double before = std::numeric_limits<double>::infinity();
  for (const std::size_t most : { 156, 157, 200, 400, 1600 })
  {
    const Decimation result = Decimate(horizon, AtMost(most));
    CHECK_EQUAL(result.Points.Source.size(), most);
    CHECK(result.LargestError <= before || most < 400);
    before = result.LargestError;
  }
  CHECK_EQUAL(before, 0.0);
  CHECK_THROWS_WITH(Decimate(horizon, AtMost(155)),
    "maximum number of points 155, expected at least the 156 of the loops, which are kept");
}

/// As many vertices are nearer on average, loops stay, and no height moves farther than the bound.
void TestFitHeights()
{
  const Patches::Columns columns = Square(60);
  BoundedHorizon smooth = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  BoundedHorizon horizon = smooth;
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    smooth.Height[point] = Wave(columns[point]);
    horizon.Height[point] = std::round(smooth.Height[point]);
  }
  const Decimation fitted = Decimate(smooth, AtMost(400, true));
  CHECK_EQUAL(fitted.Points.Source.size(), 400u);
  CHECK(fitted.MeanError < 0.95 * Decimate(smooth, AtMost(400)).MeanError);
  const Decimation bound = Decimate(horizon, Within(0.75, true));
  CHECK(bound.Points.Source.size() < Decimate(horizon, Within(0.75)).Points.Source.size());
  const std::vector<PointId>& source = bound.Points.Source;
  double farthest = 0.0;
  for (std::size_t vertex = 0; vertex < source.size(); ++vertex)
  {
    const double move = std::abs(bound.Points.Height[vertex] - horizon.Height[std::size_t(source[vertex])]);
    CHECK_EQUAL(bound.Points.Averaged[vertex] != 0, move > 0.0);
    farthest = std::max(farthest, move);
  }
  CHECK(farthest > 0.1 && farthest <= 0.75);
  horizon.Boundary.ForEachPoint([&](PointId point)
    { CHECK_EQUAL(bound.Points.Averaged[std::size_t(bound.Points.Target[std::size_t(point)])], 0); });
}

/// Heights are fitted among noise, too, where few moves are far.
void TestFitNoise()
{
  Patches::Random random(29);
  const Patches::Columns columns = Square(60);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    horizon.Height[point] = Wave(columns[point]) + 2.0 * random.Fraction();
  }
  for (const std::size_t most : { 300, 400, 600 })
  {
    const Decimation fitted = Decimate(horizon, Best(AtMost(most, true)));
    const Decimation columnsAlone = Decimate(horizon, Best(AtMost(most)));
    CHECK(fitted.MeanError < 0.99 * columnsAlone.MeanError);
  }
  // Within an error, fitted heights take fewer vertices.
  for (const double error : { 0.8, 1.0 })
  {
    const std::size_t columnsAlone = Decimate(horizon, Best(Within(error))).Points.Source.size();
    CHECK(double(Decimate(horizon, Best(Within(error, true))).Points.Source.size()) < 0.8 * double(columnsAlone));
  }
}

/// Fewer vertices for an error, and a smaller error for so many vertices.
void TestBest()
{
  const Patches::Columns columns = Square(60);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    horizon.Height[point] = Wave(columns[point]);
  }
  horizon = TestHorizons::Drop(horizon, SimplifyBoundary(horizon, horizon.Boundary, { 0.25, true, 0.0 }));
  for (const bool fitHeights : { false, true })
  {
    const Decimation fast = Decimate(horizon, Within(0.25, fitHeights));
    const Decimation best = Decimate(horizon, Best(Within(0.25, fitHeights)));
    CHECK(double(best.Points.Source.size()) < 0.85 * double(fast.Points.Source.size()));
    const std::size_t most = horizon.Boundary.CountPoints(horizon.Plane.size()) + 100;
    const double mean = Decimate(horizon, AtMost(most, fitHeights)).MeanError;
    CHECK(Decimate(horizon, Best(AtMost(most, fitHeights))).MeanError < (fitHeights ? 0.85 : 0.95) * mean);
  }
}

/// The mean error is smaller with the one, the largest with the other.
void TestPriority()
{
  const Patches::Columns columns = Square(60);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  std::array<double, 2> sums = { 0.0, 0.0 };
  for (const int seed : { 21, 22, 23, 24 })
  {
    Patches::Random random(seed);
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      horizon.Height[point] = Wave(columns[point]) + (columns[point].X > 40 ? 3.0 * random.Fraction() : 0.0);
    }
    for (const DecimationEffort effort : { DecimationEffort::Fast, DecimationEffort::Best })
    {
      DecimationOptions options = AtMost(500, true);
      options.Effort = effort;
      const Decimation mean = Decimate(horizon, options);
      options.Priority = DecimationPriority::LargestError;
      const Decimation largest = Decimate(horizon, options);
      CHECK(mean.MeanError < 0.8 * largest.MeanError);
      sums[effort == DecimationEffort::Best] += largest.LargestError / mean.LargestError;
    }
  }
  CHECK(sums[0] < 4.0 * 0.9); // the last point of one seed may be unlucky
  CHECK(sums[1] < 4.0 * 0.7);
}

/// Of what was asked to be small, a fit leaves nothing larger than without it: the largest error, or the mean of all.
void TestFitToPriority()
{
  Patches::Random random(31);
  const Patches::Columns columns = Square(30);
  double shrinks = 0.0;
  for (int n = 0; n < 40; ++n)
  {
    const BoundedHorizon horizon =
      TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random)));
    const std::size_t most = horizon.Boundary.CountPoints(horizon.Plane.size()) + std::size_t(20 + random.Below(100));
    DecimationOptions fitted = AtMost(most, true);
    DecimationOptions plain = AtMost(most, false);
    const double before = Decimate(horizon, plain).MeanError;
    const double after = Decimate(horizon, fitted).MeanError;
    CHECK(after <= before);
    shrinks += after < 0.99 * before ? 1.0 : 0.0;
    fitted.Priority = DecimationPriority::LargestError;
    plain.Priority = DecimationPriority::LargestError;
    CHECK(Decimate(horizon, fitted).LargestError <= Decimate(horizon, plain).LargestError + 1e-9);
  }
  CHECK(shrinks > 20.0);
}

/// No angle becomes smaller than asked for where all were larger before.
void TestSmallestAngle()
{
  Patches::Random random(19);
  const Patches::Columns columns = Square(40);
  const BoundedHorizon horizon =
    TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random)));
  const auto smallest = [&](const DecimationOptions& options)
  {
    const Decimation result = Decimate(horizon, options);
    double least = 180.0;
    std::vector<double> angles(result.Triangles.size() / 3, 180.0); // the smallest one of each triangle
    for (std::size_t n = 0; n < result.Triangles.size(); ++n)
    {
      const std::size_t first = n / 3 * 3;
      const auto at = [&](std::size_t k) { return result.Points.Plane[std::size_t(result.Triangles[first + k % 3])]; };
      const PlanePoint a = at(n % 3);
      const PlanePoint b = at(n % 3 + 1);
      const PlanePoint c = at(n % 3 + 2);
      const double one = std::atan2(double(b.Y) - a.Y, double(b.X) - a.X);
      const double other = std::atan2(double(c.Y) - a.Y, double(c.X) - a.X);
      const double angle = std::remainder(other - one, 8.0 * std::atan(1.0)) * 45.0 / std::atan(1.0);
      angles[n / 3] = std::min(angles[n / 3], angle);
      least = std::min(least, angle);
    }
    const auto isBelow = [&options](double angle) { return angle < options.SmallestAngle; };
    CHECK_EQUAL(result.NumberOfSlivers, std::size_t(std::count_if(angles.begin(), angles.end(), isBelow)));
    return least;
  };
  const double before = smallest(Within(2.0));
  CHECK(smallest(Best(Within(2.0), 0.0)) < 0.5 * before);
  CHECK(smallest(Best(Within(2.0), 60.0)) >= before - 1e-9);
  CHECK(smallest(Best(Within(2.0), 0.8 * before)) >= 0.8 * before - 1e-9);
  // For a number, too, down to the last point.
  for (const double angle : { 2.0, 10.0 })
  {
    CHECK(smallest(Best(AtMost(250, true), angle)) >= angle);
    CHECK(smallest(Best(AtMost(400, true), angle)) >= angle);
  }
  // Of 14 points inside and 156 on the loop some angles have to be smaller: no more so than it takes.
  CHECK(smallest(Best(AtMost(170, true), 10.0)) >= 2.5);
}

void TestThreads()
{
  Patches::Random random(9);
  const Patches::Columns columns = Square(120);
  const BoundedHorizon horizon =
    TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random)));
  const int before = Detail::NumberOfThreads();
  for (const DecimationOptions& options : { DecimationOptions(), Best(AtMost(1500, true)) })
  {
    Detail::NumberOfThreads() = 1;
    const Decimation one = Decimate(horizon, options);
    Detail::NumberOfThreads() = 5;
    const Decimation five = Decimate(horizon, options);
    Detail::NumberOfThreads() = before;
    CHECK(one.Triangles == five.Triangles && one.Points.Source == five.Points.Source);
    CHECK(one.Points.Height == five.Points.Height);
    CHECK(one.Points.Target == five.Points.Target && one.Errors == five.Errors && one.MeanError == five.MeanError);
  }
}

void TestErrors()
{
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(Square(5)));
  CHECK_THROWS_WITH(Decimate(horizon, Within(-1.0)), "maximum error -1, expected at least 0 lattice units");
  CHECK_THROWS_WITH(Decimate(horizon, Best(Within(1.0), -1.0)), "smallest angle -1, expected 0 to 60 degrees");
  DecimationOptions both = AtMost(25);
  both.MaximumError = 0.5;
  CHECK_THROWS_WITH(Decimate(horizon, both),
    "maximum error 0.5 and maximum number of points 25, expected one of them as the target, and 0 for the other one");
  CHECK_THROWS_WITH(
    Decimate(horizon, Within(std::nan(""))), "maximum error nan, expected a finite number, at least 0 lattice units");
  BoundedHorizon twice = horizon;
  twice.Plane[12] = twice.Plane[11];
  CHECK_THROWS_WITH(Decimate(twice), "points 11 and 12 both in column (1, 2), expected at most one point");
  BoundedHorizon outside = horizon;
  outside.Plane[12] = { 9, 0 };
  CHECK_THROWS_WITH(Decimate(outside), "point 12 lies outside the boundary of its patch, expected loops around all");
  CHECK_EQUAL(Decimate(BoundedHorizon()).Triangles.size(), 0u);
  // Patches that someone took out leave gaps in the numbers.
  BoundedHorizon later = horizon;
  later.Patch.assign(later.Patch.size(), 3);
  CHECK(Decimate(later).Triangles == Decimate(horizon).Triangles);
}

/// Points of a negative patch are as good as not there.
void TestPointsWithoutPatch()
{
  Patches::Random random(19);
  for (int n = 0; n < 60; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon horizon =
      TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random)));
    const BoundarySimplification simplified = SimplifyBoundary(horizon, horizon.Boundary, { 1.0, true, 0.0 });
    BoundedHorizon marked = horizon;
    marked.Boundary = simplified.Boundary;
    for (const DroppedPoint& dropped : simplified.Dropped)
    {
      marked.Patch[std::size_t(dropped.Point)] = -1;
      marked.Height[std::size_t(dropped.Point)] = 1e9;
    }
    DecimationOptions options = Within(0.5);
    if (n % 2 == 1)
    {
      options.MaximumError = 0.0;
      options.MaximumNumberOfPoints = columns.size();
    }
    const Decimation expected = Decimate(TestHorizons::Drop(horizon, simplified), options);
    const Decimation found = Decimate(marked, options);
    CHECK((found.Triangles == expected.Triangles));
    CHECK((found.Points.Height == expected.Points.Height && found.Points.Plane == expected.Points.Plane));
    CHECK((found.Errors == expected.Errors));
    CHECK_EQUAL(found.MeanError, expected.MeanError);
    const KeptPoints kept = KeepOthers(simplified.Dropped, columns.size());
    const std::vector<PointId> targets = kept.Select(found.Points.Target);
    const RawVector<PointId>& of = expected.Points.Target;
    CHECK(std::equal(targets.begin(), targets.end(), of.begin(), of.end()));
    for (const DroppedPoint& dropped : simplified.Dropped)
    {
      CHECK_EQUAL(found.Points.Target[std::size_t(dropped.Point)], NoPoint);
    }
  }
}

void TestStop()
{
  Patches::Random random(9);
  const Patches::Columns columns = Square(60);
  const BoundedHorizon horizon =
    TestHorizons::OnColumns(TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random)));
  CHECK_EQUAL(
    MonitorChecker::Check(8, [&](const Monitor& monitor) { Decimate(horizon, Within(0.1), monitor); }), std::string());
}

/// With the effort Fast, points are inserted until triangles have the angle, and more until the error is kept again.
void TestAnglesOfFast()
{
  const Patches::Columns columns = Square(60);
  BoundedHorizon horizon = TestHorizons::OnColumns(TestHorizons::MakeLevelHorizon(columns));
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    horizon.Height[point] = Wave(columns[point]);
  }
  std::size_t vertices = 0;
  for (const double angle : { 0.0, 10.0, 20.0, 25.0 })
  {
    DecimationOptions options = Within(0.5);
    options.SmallestAngle = angle;
    const Decimation result = Decimate(horizon, options);
    CHECK_EQUAL(Checker(horizon, result).Check(0.5, MeshChecker::Kind::Delaunay), std::string());
    CHECK_EQUAL(result.NumberOfSlivers, 0u);
    CHECK(result.Points.Source.size() > vertices);
    vertices = result.Points.Source.size();
  }
}
}

int TestDecimation(int, char*[])
{
  TestPlane();
  TestSpike();
  TestNumberOfPoints();
  TestFitHeights();
  TestFitNoise();
  TestBest();
  TestPriority();
  TestFitToPriority();
  TestSmallestAngle();
  TestThreads();
  TestErrors();
  TestPointsWithoutPatch();
  TestAnglesOfFast();
  TestStop();
  return Check::Result();
}
