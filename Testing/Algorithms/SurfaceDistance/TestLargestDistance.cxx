// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounds of the largest distance: beside places everywhere on surfaces of all kinds, and where it is known.

#include "Common/Parallel.h"
#include "SurfaceDistance/SurfaceDistance.h"
#include "Tools/Check.h"
#include "Tools/RandomSurfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

using namespace RandomSurfaces;

namespace
{
double Flat(double, double)
{
  return 0.0;
}

/// Columns of 25 by 12.5, turned, and a vertical step of 4; and one that squeezes the plan.
const std::vector<Metric> TwoMetrics = { Metric(),
  Metric((Eigen::Matrix2d() << 15.0, -10.0, 20.0, 7.5).finished(), 4.0) };

/// The largest distance of places of a grid on each triangle that counts, corners included, by trying all triangles.
double LargestByHand(const TriangleSurface& from, const TriangleSurface& to, const Metric& metric, int cuts)
{
  double largest = 0.0;
  for (const Corners& t : from.Triangles)
  {
    for (int n = 0; from.Counts(t) && n < (cuts + 1) * (cuts + 1); ++n)
    {
      const double u = double(n % (cuts + 1)) / cuts;
      const double v = double(n / (cuts + 1)) / cuts;
      if (u + v > 1.0)
      {
        continue;
      }
      const Eigen::Vector3d place =
        from.Point(t[0]) + u * (from.Point(t[1]) - from.Point(t[0])) + v * (from.Point(t[2]) - from.Point(t[0]));
      double squared = std::numeric_limits<double>::infinity();
      for (const Corners& other : to.Triangles)
      {
        squared = std::min(squared, metric.SquaredDistance(to, other, place));
      }
      largest = std::max(largest, std::sqrt(squared));
    }
  }
  return largest;
}

/// Whether the bounds hold what was found by hand, and are as near as 1 % where that is asked for.
void CheckBounds(const char* name, const DistanceFigures& figures, double byHand, bool isNear = true)
{
  const double rounding = 1e-12 * (1.0 + byHand);
  if (!CHECK(figures.LargestFound <= figures.Largest && byHand <= figures.Largest + rounding) ||
    !CHECK(!isNear || figures.Largest <= 1.01 * figures.LargestFound + rounding))
  {
    std::cerr << name << ": " << figures.LargestFound << " to " << figures.Largest << ", by hand " << byHand << '\n';
  }
}

void CheckPair(const char* name, const TriangleSurface& a, const TriangleSurface& b, bool isNear = true)
{
  SurfaceDistanceOptions few;
  few.SamplesPerPoint = 1e-6;
  const std::vector<SurfaceDistance> found = MeasureSurfaceDistances(a, b, TwoMetrics, few);
  for (std::size_t metric = 0; metric < TwoMetrics.size(); ++metric)
  {
    CheckBounds(name, found[metric].ReferenceToMesh, LargestByHand(a, b, TwoMetrics[metric], 16), isNear);
    CheckBounds(name, found[metric].MeshToReference, LargestByHand(b, a, TwoMetrics[metric], 16), isNear);
    const DistanceFigures& both = found[metric].TwoSided;
    CHECK(both.Largest == std::max(found[metric].ReferenceToMesh.Largest, found[metric].MeshToReference.Largest));
    CHECK(both.LargestFound ==
      std::max(found[metric].ReferenceToMesh.LargestFound, found[metric].MeshToReference.LargestFound));
  }
}

TriangleSurface MakeRough(int count, double step, double height, Patches::Random& random)
{
  return MakeField(count, step, [&](double, double) { return height * random.Fraction(); });
}

/// Leaves out triangles at random: holes, spurs, and patches that meet at a point.
TriangleSurface WithHoles(TriangleSurface surface, Patches::Random& random)
{
  const auto isOut = [&](const Corners&) { return random.Chance(0.2); };
  surface.Triangles.erase(
    std::remove_if(surface.Triangles.begin() + 1, surface.Triangles.end(), isOut), surface.Triangles.end());
  return surface;
}

/// Lifts all on one side of a line, and leaves a crack or a wall there, of which both lips are at the same columns.
TriangleSurface WithFault(const TriangleSurface& surface, double x, double throwOfFault, bool hasWall)
{
  TriangleSurface faulted = surface;
  const PointId size = PointId(surface.Points.size());
  for (const Eigen::Vector3d& point : surface.Points)
  {
    faulted.Points.push_back(point + Eigen::Vector3d(0.0, 0.0, throwOfFault));
  }
  for (Corners& t : faulted.Triangles)
  {
    const bool isBeyond = surface.Point(t[0]).x() + surface.Point(t[1]).x() + surface.Point(t[2]).x() > 3.0 * x;
    t = isBeyond ? Corners{ t[0] + size, t[1] + size, t[2] + size } : t;
  }
  for (PointId point = 0; hasWall && point < size; ++point)
  {
    const auto isNext = [&](PointId other)
    { return surface.Point(point).x() == x && surface.Point(other).x() == x && other > point; };
    const PointId next = point + PointId(std::lround(std::sqrt(double(size))));
    if (next < size && isNext(next))
    {
      faulted.Triangles.push_back({ point, next, next + size });
      faulted.Triangles.push_back({ point, next + size, point + size });
    }
  }
  return faulted;
}

void TestAgainstBruteForce()
{
  for (int seed = 1; seed <= 6; ++seed)
  {
    Patches::Random random(seed);
    const TriangleSurface fine = MakeRough(9, 1.0, 3.0, random);
    const TriangleSurface coarse = MakeRough(3, 3.1, 3.0, random);
    CheckPair("fields", fine, coarse);
    CheckPair("steep fields", MakeRough(7, 1.0, 20.0, random), MakeRough(4, 1.7, 20.0, random));
    CheckPair("holes", WithHoles(fine, random), coarse);
    CheckPair("holes in both", WithHoles(fine, random), WithHoles(coarse, random));
    CheckPair("crack", WithFault(fine, 4.0, 5.0, false), coarse);
    CheckPair("wall", WithFault(fine, 4.0, 5.0, true), WithFault(coarse, 6.2, 3.0, true));
    TriangleSurface overlapping = WithHoles(coarse, random);
    const TriangleSurface above = MakeRough(2, 4.0, 3.0, random);
    for (const Corners& t : above.Triangles)
    {
      const PointId size = PointId(overlapping.Points.size());
      overlapping.Triangles.push_back({ size, size + 1, size + 2 });
      overlapping.Points.insert(overlapping.Points.end(), { above.Point(t[0]), above.Point(t[1]), above.Point(t[2]) });
    }
    CheckPair("overlapping", fine, overlapping);
    TriangleSurface folded = fine; // back over itself along a line
    for (Eigen::Vector3d& point : folded.Points)
    {
      point.x() = std::min(point.x(), 9.0 - point.x());
    }
    CheckPair("folded", coarse, folded);
    CheckPair("soups", MakeSoup(40, 10.0, random), MakeSoup(30, 10.0, random));
    CheckPair("one triangle", fine, MakeSoup(1, 10.0, random));
    TriangleSurface far = coarse;
    for (Eigen::Vector3d& point : far.Points)
    {
      point += Eigen::Vector3d(30.0, -20.0, 1000.0 * seed);
    }
    CheckPair("far apart", fine, far);
  }
}

/// Long thin triangles in any direction, as at simplified outlines.
void TestNeedles()
{
  for (int seed = 1; seed <= 4; ++seed)
  {
    Patches::Random random(seed);
    TriangleSurface needles;
    for (PointId n = 0; n < 3 * 20; n += 3)
    {
      const Eigen::Vector3d from = RandomPlace(random, 10.0);
      const Eigen::Vector3d to = RandomPlace(random, 10.0);
      needles.Points.insert(needles.Points.end(), { from, to, 0.5 * (from + to) + RandomPlace(random, 1e-3) });
      needles.Triangles.push_back({ n, n + 1, n + 2 });
    }
    CheckPair("needles", needles, MakeRough(5, 2.0, 3.0, random));
  }
}

/// A hole that no sample is in: 2 by 2 columns of a million.
void TestSmallHole()
{
  TriangleSurface whole = MakeField(1, 1000.0, Flat);
  TriangleSurface holed = MakeField(100, 10.0, Flat);
  const PointId corner = 57 * 101 + 33;
  const Eigen::Vector3d middle = holed.Points[corner];
  // Four columns around a point: its fan is replaced by one that ends a column before it.
  for (Corners& t : holed.Triangles)
  {
    if (t[0] != corner && t[1] != corner && t[2] != corner)
    {
      continue;
    }
    const std::size_t at = t[0] == corner ? 0 : t[1] == corner ? 1 : 2;
    const PointId next = t[(at + 1) % 3];
    const PointId last = t[(at + 2) % 3];
    const PointId size = PointId(holed.Points.size());
    holed.Points.push_back(middle + (holed.Points[next] - middle) / 10.0);
    holed.Points.push_back(middle + (holed.Points[last] - middle) / 10.0);
    t = { next, last, size + 1 };
    holed.Triangles.push_back({ next, size + 1, size });
  }
  const DistanceFigures figures = MeasureSurfaceDistance(whole, holed).ReferenceToMesh;
  CHECK(figures.LargestFound > 0.6 && figures.Largest < 1.01);
  CHECK(figures.Largest <= 1.01 * figures.LargestFound);
}

/// The same plane in two triangulations that have nothing in common, with and without anything beyond its outline.
void TestSamePlane()
{
  const auto tilted = [](double x, double y) { return 0.25 * x - 0.5 * y; };
  const TriangleSurface fine = MakeField(60, 1.0, tilted);
  for (const auto& [count, step] : { std::make_pair(1, 60.0), std::make_pair(7, 60.0 / 7.0), std::make_pair(60, 1.0) })
  {
    const SurfaceDistance distance = MeasureSurfaceDistance(fine, MakeField(count, step, tilted));
    CHECK(distance.ReferenceToMesh.Largest < 1e-12 && distance.MeshToReference.Largest < 1e-12);
  }
  const SurfaceDistance beyond = MeasureSurfaceDistance(fine, MakeField(9, 8.0, tilted));
  CHECK(beyond.ReferenceToMesh.Largest < 1e-12);
  CHECK(beyond.MeshToReference.LargestFound > 12.0 && beyond.MeshToReference.Largest < 1.01 * std::sqrt(2.0) * 14.0);
}

/// What is known: below the ridge of a tent, and in the middle of a patch that is missing.
void TestKnownDistances()
{
  TriangleSurface tent;
  tent.Points = { { 0, 0, 0 }, { 4, 0, 2 }, { 8, 0, 0 }, { 0, 8, 0 }, { 4, 8, 2 }, { 8, 8, 0 } };
  tent.Triangles = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 } };
  const SurfaceDistance toTent = MeasureSurfaceDistance(MakeField(3, 8.0 / 3.0, Flat), tent);
  const double slant = 2.0 / std::sqrt(1.25);
  CheckBounds("tent", toTent.ReferenceToMesh, slant);
  CheckBounds("plane", toTent.MeshToReference, 2.0);
  CHECK(toTent.ReferenceToMesh.LargestFound <= slant + 1e-12 && toTent.MeshToReference.LargestFound <= 2.0);
  TriangleSurface ring = MakeField(12, 1.0, Flat);
  const auto isIn = [&](const Corners& t)
  {
    const Eigen::Vector3d middle = (ring.Point(t[0]) + ring.Point(t[1]) + ring.Point(t[2])) / 3.0;
    return std::max(std::abs(middle.x() - 6.0), std::abs(middle.y() - 6.0)) < 4.0;
  };
  ring.Triangles.erase(std::remove_if(ring.Triangles.begin(), ring.Triangles.end(), isIn), ring.Triangles.end());
  const SurfaceDistance toRing = MeasureSurfaceDistance(MakeField(1, 12.0, Flat), ring);
  CheckBounds("ring", toRing.ReferenceToMesh, 4.0);
  CHECK(toRing.ReferenceToMesh.LargestFound <= 4.0 + 1e-12 && toRing.MeshToReference.Largest < 1e-12);
}

/// What is left out has no part in the bounds, and an edge between two points that count has.
void TestLeftOut()
{
  TriangleSurface spike = MakeField(6, 1.0, [](double x, double y) { return x == 3.0 && y == 3.0 ? 9.0 : 0.0; });
  spike.LeftOut.assign(spike.Points.size(), 0);
  spike.LeftOut[3 * 7 + 3] = 1;
  const SurfaceDistance distance = MeasureSurfaceDistance(spike, MakeField(2, 3.0, Flat));
  CHECK(distance.ReferenceToMesh.Largest < 1e-12);
  // A triangle with one corner left out: only its low side counts, beyond the end of the other surface.
  TriangleSurface wing = MakeField(2, 1.0, Flat);
  wing.Points.insert(wing.Points.end(), { { 3.0, 0.0, 0.0 }, { 3.0, 1.0, 50.0 } });
  wing.Triangles.push_back({ 2, 9, 10 });
  wing.LeftOut.assign(wing.Points.size(), 0);
  wing.LeftOut[10] = 1;
  CheckBounds("wing", MeasureSurfaceDistance(wing, MakeField(2, 1.0, Flat)).ReferenceToMesh, 1.0);
}

/// The bounds scale with the surfaces, and are the same on any number of threads, also when the effort does not reach.
void TestSameBounds()
{
  Patches::Random random(8);
  const TriangleSurface a = MakeRough(70, 1.0, 30.0, random);
  const TriangleSurface b = MakeRough(33, 2.1, 30.0, random);
  const int usual = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1;
  const DistanceFigures one = MeasureSurfaceDistance(a, b).TwoSided;
  for (const int threads : { 2, 5 })
  {
    Detail::NumberOfThreads() = threads;
    const DistanceFigures many = MeasureSurfaceDistance(a, b).TwoSided;
    CHECK(one.Largest == many.Largest && one.LargestFound == many.LargestFound);
  }
  Detail::NumberOfThreads() = usual;
  SurfaceDistanceOptions more;
  more.SamplesPerPoint = 50.0;
  const DistanceFigures dense = MeasureSurfaceDistance(a, b, more).TwoSided;
  CHECK(dense.LargestFound <= one.Largest && one.LargestFound <= dense.Largest);
}
}

int TestLargestDistance(int, char*[])
{
  TestAgainstBruteForce();
  TestNeedles();
  TestSmallHole();
  TestSamePlane();
  TestKnownDistances();
  TestLeftOut();
  TestSameBounds();
  return Check::Result();
}
