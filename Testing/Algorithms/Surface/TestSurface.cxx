// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From points to mesh: the same as the three methods one after the other, with parameters that are chosen or given, and
// no more triangles than there may be.

#include "Common/Base/Parallel.h"
#include "SurfaceInputs.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

using namespace SeismicHorizons;
using namespace SurfaceInputs;

namespace
{
using SurfaceInputs::Points;

double Fold(const PlanePoint& column)
{
  return std::round(20.0 + 6.0 * std::sin(0.3 * column.X) * std::cos(0.25 * column.Y));
}

Points RandomPoints(int n, Patches::Random& random)
{
  const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
  const bool isNoise = n % 3 == 0;
  return MakePoints(
    columns, [&](const PlanePoint& column) { return isNoise ? std::floor(9.0 * random.Fraction()) : Fold(column); });
}

/// How many points each vertex represents.
std::vector<std::int64_t> CountPoints(const Reduction& vertices)
{
  std::vector<std::int64_t> counts(vertices.Source.size(), 0);
  for (const PointId target : vertices.Target)
  {
    counts[std::size_t(target)] += target == NoPoint ? 0 : 1;
  }
  return counts;
}

/// As texts, with the columns that were given.
struct Result
{
  std::string Mesh;
  std::string Outlines;
};

std::string TellLoops(const Reduction& vertices)
{
  std::ostringstream text;
  vertices.Boundary.ForEachPoint([&](PointId point)
    { text << vertices.Plane[std::size_t(point)].X << ' ' << vertices.Plane[std::size_t(point)].Y << ' '; });
  return text.str();
}

/// The three methods, one after the other, with the parameters of a surface and the points that its outlines keep.
Result RunMethods(const Points& points, const SurfaceOptions& given, const Surface& surface)
{
  const SurfaceParameters& parameters = surface.Parameters;
  BoundaryOptions boundary;
  boundary.Radius = parameters.Radius;
  boundary.Growth = given.Growth;
  boundary.KeepHoles = given.KeepHoles;
  boundary.SmallestHoleSize = parameters.SmallestHoleSize;
  boundary.MinimumPatchSize = given.MinimumPatchSize;
  const BoundedHorizon horizon = TestHorizons::MakeHorizon(points.Columns, points.Height, boundary);
  BoundarySimplificationOptions straight;
  straight.Method = OutlineMethod::FewestPoints;
  straight.OutlineTolerance = parameters.OutlineTolerance;
  straight.DistanceThreshold = parameters.DistanceThreshold;
  straight.Fixed = surface.AddedToOutlines;
  const BoundarySimplification simplified =
    SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, straight);
  DecimationOptions decimation;
  decimation.MaximumError = parameters.MaximumNumberOfPoints > 0 ? 0.0 : parameters.MaximumError;
  decimation.MaximumNumberOfPoints = parameters.MaximumNumberOfPoints;
  decimation.Effort = given.Effort;
  decimation.Crossings = given.Crossings;
  Decimation mesh = Decimate(TestHorizons::Leave(horizon, simplified), decimation);
  RawVector<PointId>& target = mesh.Points.Target;
  std::for_each(simplified.Dropped.begin(), simplified.Dropped.end(),
    [&](const DroppedPoint& one) { target[std::size_t(one.Point)] = target[std::size_t(one.Target)]; });
  std::ostringstream text;
  for (const PointId vertex : mesh.Triangles)
  {
    const PlanePoint& place = mesh.Points.Plane[std::size_t(vertex)];
    text << place.X << ' ' << place.Y << ' ' << mesh.Points.Height[std::size_t(vertex)] << ' ';
  }
  for (const std::int64_t count : CountPoints(mesh.Points))
  {
    text << count << ' ';
  }
  text << mesh.LargestError << ' ' << mesh.MeanError << ' ' << simplified.OutlineDeviation;
  return { text.str(), TellLoops(mesh.Points) };
}

/// The same of a surface.
Result Tell(const Points& points, const Surface& surface)
{
  std::ostringstream text;
  const Reduction& vertices = surface.Mesh.Points;
  for (const PointId vertex : surface.Mesh.Triangles)
  {
    const PlanePoint& place = vertices.Plane[std::size_t(vertex)];
    text << place.X << ' ' << place.Y << ' ' << vertices.Height[std::size_t(vertex)] << ' ';
    const PointId source = surface.Kept[std::size_t(vertices.Source[std::size_t(vertex)])];
    CHECK(points.Columns[std::size_t(source)] == place);
  }
  for (const std::int64_t count : CountPoints(vertices))
  {
    text << count << ' ';
  }
  text << surface.Mesh.LargestError << ' ' << surface.Mesh.MeanError << ' ' << surface.OutlineDeviation;
  return { text.str(), TellLoops(vertices) };
}

/// Where outlines move, triangles far from them stay as they are, so that only the outlines are the same.
void CheckSame(const Points& points, const SurfaceOptions& options, const Surface& surface)
{
  const Result found = Tell(points, surface);
  const Result expected = RunMethods(points, options, surface);
  CHECK_EQUAL(found.Outlines, expected.Outlines);
  if (surface.AddedToOutlines.empty() || options.MaximumNumberOfTriangles > 0)
  {
    CHECK_EQUAL(found.Mesh, expected.Mesh);
  }
  else
  {
    const double error = surface.Parameters.MaximumError + 1e-9;
    CHECK(surface.Mesh.LargestError <= error);
    CHECK(surface.Mesh.LargestEdgeError <= (options.Crossings == CrossingTolerance::Twice ? 2.0 : 1.0) * error);
  }
}

void TestSameAsMethods()
{
  Patches::Random random(5);
  for (int n = 0; n < 300; ++n)
  {
    const Points points = RandomPoints(n, random);
    SurfaceOptions options = n % 2 == 0 ? Within(0.3 * random.Below(8)) : AtMost(std::size_t(60 + random.Below(500)));
    options.Growth = n % 5 == 0 ? GrowthStrategy::Distance : GrowthStrategy::Clockwise;
    options.KeepHoles = n % 4 != 3;
    options.Effort = n % 7 < 3 ? DecimationEffort::Fast : DecimationEffort::Best;
    options.Crossings = n % 11 < 4 ? CrossingTolerance::Twice : CrossingTolerance::Same;
    const Surface surface = MakeSurface(points, options);
    CheckSame(points, options, surface);
    const SurfaceParameters& chosen = surface.Parameters;
    const bool isFar = n % 2 == 1 && chosen.OutlineTolerance == chosen.MaximumError; // as few triangles need
    CHECK(isFar || chosen.OutlineTolerance == std::min(chosen.MaximumError, 0.75));
    CHECK_EQUAL(chosen.DistanceThreshold, chosen.MaximumError);
    CHECK_EQUAL(chosen.SmallestHoleSize, ChooseSmallestHoleSize(chosen.Radius, chosen.OutlineTolerance));
  }
}

void TestGivenParameters()
{
  const Points points = MakePoints(Rectangle(30, 20), Fold);
  SurfaceOptions options = Within(1.0);
  options.Radius = 3;
  options.SmallestHoleSize = 7;
  options.OutlineTolerance = 0.0;
  options.DistanceThreshold = 0.25;
  const Surface surface = MakeSurface(points, options);
  CHECK_EQUAL(surface.Parameters.Radius, 3);
  CHECK_EQUAL(surface.Parameters.SmallestHoleSize, 7);
  CHECK_EQUAL(surface.Parameters.OutlineTolerance, 0.0);
  CHECK_EQUAL(surface.Parameters.DistanceThreshold, 0.25);
  CHECK_EQUAL(surface.Parameters.MaximumError, 1.0);
  CheckSame(points, options, surface);
  // With both tolerances there is no error to search for.
  options.MaximumNumberOfTriangles = 400;
  const Surface byNumber = MakeSurface(points, options);
  CHECK(byNumber.Parameters.MaximumError == 0.0 && CountTriangles(byNumber) <= 400 && CountTriangles(byNumber) >= 399);
}

/// Single missing points are closed, a hole of 6 by 6 columns stays open; on every second line of twice the size.
void TestHoles()
{
  for (const int step : { 1, 2 })
  {
    Patches::Columns columns;
    for (const PlanePoint& column : Rectangle(40, 40))
    {
      const bool isHole = column.X > 20 && column.X < 27 && column.Y > 20 && column.Y < 27;
      const bool isDropout = column.X % 10 == 5 && column.Y % 10 == 5;
      if (!isHole && !isDropout)
      {
        columns.push_back({ column.X * step, column.Y * step });
      }
    }
    const Surface surface = MakeSurface(MakePoints(columns, Fold), Within(0.75));
    CHECK_EQUAL(surface.Parameters.Radius, step);
    CHECK_EQUAL(surface.Parameters.SmallestHoleSize, (2 * step + 1) * (2 * step + 1));
    CHECK_EQUAL(surface.Boundary.NumberOfPatches, 1u);
    CHECK_EQUAL(surface.Boundary.Boundary.Size(), 2u);
  }
}

/// At most so many; just as many, but for one, where there are points enough.
void TestNumberOfTriangles()
{
  const auto wavy = [](const PlanePoint& column)
  { return 20.0 + 6.0 * std::sin(0.3 * column.X) * std::cos(0.25 * column.Y); };
  const Points points = MakePoints(Rectangle(60, 50), wavy);
  for (const std::size_t most : { 20, 101, 1000, 3000 })
  {
    const Surface surface = MakeSurface(points, AtMost(most));
    CHECK(CountTriangles(surface) <= most && CountTriangles(surface) + 1 >= most);
  }
  CHECK(MakeSurface(points, AtMost(1000000)).Mesh.LargestError < 1e-3);
}

/// With the priority of largest errors, as many triangles as an error takes leave about that error, at columns and
/// edges, also where the outline is ragged, and in units of which the error is many. Where outlines need most triangles,
/// errors depend on a few vertices.
void TestNumberOfAnError()
{
  Patches::Random random(7);
  Patches::Columns ragged;
  for (const PlanePoint& column : Rectangle(180, 150))
  {
    const double x = column.X - 90.0;
    const double y = column.Y - 75.0;
    const double rim = 60.0 + 8.0 * std::sin(5.0 * std::atan2(y, x)) + 5.0 * random.Fraction();
    const bool isHole = std::hypot(x - 20.0, y + 15.0) < 9.0 + 2.0 * random.Fraction();
    if (std::hypot(x, y) < rim && !isHole)
    {
      ragged.push_back(column);
    }
  }
  for (const auto& [columns, scale] :
    { std::make_pair(Rectangle(150, 120), 1.0), std::make_pair(ragged, 1.0), std::make_pair(ragged, 15.0) })
  {
    for (const double noise : { 0.0, 0.2, 1.0 })
    {
      const auto rough = [&, factor = scale](const PlanePoint& column)
      { return factor * (9.0 * std::sin(0.06 * column.X) * std::cos(0.05 * column.Y) + noise * random.Fraction()); };
      const Points points = MakePoints(columns, rough);
      for (const double error : { 0.1 * scale, 0.4 * scale })
      {
        SurfaceOptions options = AtMost(CountTriangles(MakeSurface(points, Within(error))));
        options.Priority = DecimationPriority::LargestError;
        const Surface surface = MakeSurface(points, options);
        CHECK(CountTriangles(surface) <= options.MaximumNumberOfTriangles);
        CHECK(std::max(surface.Mesh.LargestError, surface.Mesh.LargestEdgeError) <=
          (options.MaximumNumberOfTriangles > 600 ? 1.06 : 1.3) * error);
      }
    }
  }
}

/// So many triangles as the coarsest outlines take are enough, and one less is refused, which names that number. So do
/// all below it, while any number above it is kept.
void TestNumberOnRandomPatches()
{
  constexpr double anything = 1e4; // farther than any two points of the patches are apart
  Patches::Random random(23);
  int refused = 0;
  for (int n = 0; n < 300; ++n)
  {
    const Points points = RandomPoints(n, random);
    SurfaceOptions outlines = Within(anything);
    outlines.OutlineTolerance = anything;
    const std::size_t least = CountTriangles(MakeSurface(points, outlines));
    const std::size_t any = std::size_t(1 + random.Below(n % 2 == 0 ? 8 : 400));
    for (const std::size_t most : { std::max<std::size_t>(least, 1), least + any })
    {
      CHECK(CountTriangles(MakeSurface(points, AtMost(most))) <= most);
    }
    for (const std::size_t most : { least - 1, least - std::min(any, least) })
    {
      if (least > 0 && most > 0) // 0 is no number
      {
        CHECK_THROWS_WITH(MakeSurface(points, AtMost(most)),
          "maximum number of triangles " + std::to_string(most) + ", expected at least the " + std::to_string(least) +
            " that the outlines require");
        ++refused;
      }
    }
  }
  CHECK(refused > 200); // a patch in a line has no triangles
}

void TestPlaneAndFewPoints()
{
  const auto slope = [](const PlanePoint& column) { return 0.5 * column.X; };
  for (const SurfaceOptions& options : { Within(0.75), AtMost(20000), AtMost(2) })
  {
    CHECK_EQUAL(CountTriangles(MakeSurface(MakePoints(Rectangle(30, 20), slope), options)), 2u);
    CHECK_EQUAL(CountTriangles(MakeSurface(MakePoints({ { 4, 4 } }, slope), options)), 0u);
    CHECK_EQUAL(CountTriangles(MakeSurface(MakePoints(Rectangle(9, 1), slope), options)), 0u);
  }
  CHECK_EQUAL(CountTriangles(MakeSurface(MakePoints(Rectangle(2, 2), slope), AtMost(20000))), 2u);
  SurfaceOptions none = AtMost(1);
  none.OutlineTolerance = 0.0;
  CHECK_THROWS_WITH(MakeSurface(MakePoints(Rectangle(2, 2), slope), none),
    "maximum number of triangles 1, expected at least the 2 that the outlines require");
  none.DistanceThreshold = 0.0;
  CHECK_THROWS_WITH(MakeSurface(MakePoints(Rectangle(2, 2), slope), none), "expected at least the 2 that");
}

/// Small patches are dropped first, and when nothing else is there, nothing is left.
void TestSmallPatches()
{
  Patches::Columns columns = Rectangle(20, 20);
  columns.insert(columns.begin() + 77, { 40, 3 });
  const Points points = MakePoints(columns, Fold);
  for (SurfaceOptions options : { Within(0.75), AtMost(300) })
  {
    options.MinimumPatchSize = 2;
    const Surface surface = MakeSurface(points, options);
    CHECK_EQUAL(surface.Kept.size(), 400u);
    CHECK_EQUAL(surface.Kept[77], 78);
    CHECK_EQUAL(surface.Mesh.Points.Target.size(), 400u);
    options.MinimumPatchSize = 401;
    const Surface nothing = MakeSurface(points, options);
    CHECK(nothing.Kept.empty() && nothing.Mesh.Triangles.empty() && nothing.Boundary.NumberOfPatches == 0);
  }
}

void TestThreads()
{
  const auto check = [](const Points& points, const SurfaceOptions& options)
  {
    Detail::NumberOfThreads() = 1;
    const std::string onOne = Tell(points, MakeSurface(points, options)).Mesh;
    for (const int threads : { 2, 3 })
    {
      Detail::NumberOfThreads() = threads;
      CHECK_EQUAL(Tell(points, MakeSurface(points, options)).Mesh, onOne);
    }
    Detail::NumberOfThreads() = 0;
  };
  check(MakePoints(Rectangle(60, 50), Fold), AtMost(700));
  check(MakePoints(Rectangle(400, 300), Fold), Within(0.75)); // several chunks in each loop
}

void TestErrors()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points points = MakePoints(Rectangle(9, 9), Fold);
  CHECK_THROWS_WITH(MakeSurface(points, Within(-1.0)), "maximum error -1, expected at least 0 lattice units");
  CHECK_THROWS_WITH(MakeSurface(points, Within(nan)), "maximum error nan, expected a finite number");
  const auto refuse = [&](const std::string& message, void (*change)(SurfaceOptions&))
  {
    SurfaceOptions options;
    change(options);
    CHECK_THROWS_WITH(MakeSurface(points, options), message);
  };
  refuse("radius 0, expected 1 to 32 columns", [](SurfaceOptions& options) { options.Radius = 0; });
  refuse("smallest hole size 0, expected", [](SurfaceOptions& options) { options.SmallestHoleSize = 0; });
  refuse("outline tolerance -2, expected", [](SurfaceOptions& options) { options.OutlineTolerance = -2.0; });
  refuse("distance threshold -3, expected", [](SurfaceOptions& options) { options.DistanceThreshold = -3.0; });
  refuse("smallest angle 61, expected", [](SurfaceOptions& options) { options.SmallestAngle = 61.0; });
  CHECK_THROWS_WITH(MakeSurface(MakePoints({ { 1, 1 }, { 1, 1 } }, Fold)), "points 0 and 1");
}

void TestMonitor()
{
  const Points points = MakePoints(Rectangle(60, 50), Fold);
  for (const SurfaceOptions& options : { Within(0.75), AtMost(700) })
  {
    CHECK_EQUAL(
      MonitorChecker::Check(10, [&](const Monitor& monitor) { MakeSurface(points, options, monitor); }), std::string());
  }
}
}

int TestSurface(int, char*[])
{
  TestSameAsMethods();
  TestGivenParameters();
  TestHoles();
  TestNumberOfTriangles();
  TestNumberOfAnError();
  TestNumberOnRandomPatches();
  TestPlaneAndFewPoints();
  TestSmallPatches();
  TestThreads();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
