// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounds of the largest distance: beside places everywhere on surfaces of all kinds, and where it is known.

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/SurfaceDistance/LargestDistance.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Tools/Check.h"
#include "Tools/RandomSurfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
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

/// The bounds without any samples: from the corners alone.
LargestDistance FindFromCorners(const TriangleSurface& from, const TriangleSurface& to, std::int64_t effort)
{
  const TriangleSearch search(to);
  const std::unique_ptr<PlanOverlay> overlay(search.GetRaster() ? new PlanOverlay(*search.GetRaster()) : nullptr);
  DistanceProbe probe(search, TwoMetrics);
  DistanceProbe ofCorners(search, TwoMetrics);
  std::vector<PointDistances> distances(2);
  std::vector<NearestTriangles> nearest;
  for (const Eigen::Vector3d& place : from.Points)
  {
    const MetricValues found = probe(place);
    distances[0].Distance.push_back(found[0]);
    distances[1].Distance.push_back(found[1]);
    nearest.push_back(probe.Triangles());
  }
  for (const Corners& t : from.Triangles)
  {
    for (const PointId corner : t)
    {
      if (from.Counts(corner))
      {
        ofCorners(from.Point(corner));
      }
    }
  }
  return FindLargestDistance(
    { from, search, overlay.get(), TwoMetrics, distances, nearest, ofCorners.Largest }, effort, Monitor());
}

/// Whether the bounds hold what was found by hand, and are as near as 1 % where that is asked for.
void CheckBounds(const char* name, double found, double most, double byHand, bool isNear)
{
  const double rounding = 1e-12 * (1.0 + byHand);
  if (!CHECK(found <= most && byHand <= most + rounding) || !CHECK(!isNear || most <= 1.01 * found + rounding))
  {
    std::cerr << name << ": " << found << " to " << most << ", by hand " << byHand << '\n';
  }
}

void CheckBounds(const char* name, const DistanceFigures& figures, double byHand)
{
  CheckBounds(name, figures.LargestFound, figures.Largest, byHand, true);
}

void CheckDirection(const char* name, const TriangleSurface& from, const TriangleSurface& to)
{
  for (const std::int64_t effort : { 0, 100, 1000000 })
  {
    const LargestDistance largest = FindFromCorners(from, to, effort);
    for (std::size_t metric = 0; metric < TwoMetrics.size(); ++metric)
    {
      const double byHand = LargestByHand(from, to, TwoMetrics[metric], 16);
      CheckBounds(name, largest.Found[metric], largest.Most[metric], byHand, effort > 1000);
      CHECK(effort <= 1000 || largest.Found[metric] >= 0.99 * byHand - 1e-9);
    }
  }
}

void CheckPair(const char* name, const TriangleSurface& a, const TriangleSurface& b)
{
  CheckDirection(name, a, b);
  CheckDirection(name, b, a);
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

/// Lifts all on one side of a line, and leaves a crack or a wall there, of which both cutoffs are at the same columns.
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

/// A plane of a million columns with a hole of two, around a point whose fan ends at a thousandth of its length.
TriangleSurface MakeHoled()
{
  constexpr int Count = 10;
  TriangleSurface holed = MakeField(Count, 100.0, Flat);
  const PointId corner = 6 * (Count + 1) + 3;
  const Eigen::Vector3d middle = holed.Points[corner];
  const PointId size = PointId(holed.Points.size());
  std::vector<PointId> inner(size, NoPoint); // by outer point
  const auto innerOf = [&](PointId outer)
  {
    if (inner[outer] == NoPoint)
    {
      inner[outer] = PointId(holed.Points.size());
      holed.Points.push_back(middle + 0.01 * (holed.Points[outer] - middle));
    }
    return inner[outer];
  };
  const std::vector<Corners> triangles = holed.Triangles;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    const Corners& t = triangles[n];
    const std::size_t at = std::size_t(std::find(t.begin(), t.end(), corner) - t.begin());
    if (at < 3)
    {
      const PointId next = t[(at + 1) % 3];
      const PointId last = t[(at + 2) % 3];
      const PointId inside[2] = { innerOf(next), innerOf(last) };
      holed.Triangles[n] = { next, last, inside[1] };
      holed.Triangles.push_back({ next, inside[1], inside[0] });
    }
  }
  return holed;
}

/// With a second sheet right below, joined to the first one where that ends: each side has two triangles.
TriangleSurface Doubled(const TriangleSurface& surface)
{
  TriangleSurface doubled = surface;
  std::vector<PointId> lower(surface.Points.size(), NoPoint);
  SurfaceEdges(surface).ForEach(0, std::int64_t(surface.Points.size()),
    [&](PointId low, PointId high, std::uint32_t triangles)
    {
      lower[low] = triangles == 1 ? low : lower[low];
      lower[high] = triangles == 1 ? high : lower[high];
    });
  for (std::size_t point = 0; point < lower.size(); ++point)
  {
    if (lower[point] == NoPoint)
    {
      lower[point] = PointId(doubled.Points.size());
      doubled.Points.push_back(surface.Points[point] - Eigen::Vector3d(0.0, 0.0, 1e-3));
    }
  }
  for (const Corners& t : surface.Triangles)
  {
    doubled.Triangles.push_back({ lower[t[0]], lower[t[2]], lower[t[1]] });
  }
  return doubled;
}

/// A hole that no sample is in; in the second surface all sides have two triangles, those around the hole on one side.
void TestSmallHole()
{
  const TriangleSurface whole = MakeField(1, 1000.0, Flat);
  for (const TriangleSurface& holed : { MakeHoled(), Doubled(MakeHoled()) })
  {
    CHECK(TriangleSearch(holed).GetRaster() != nullptr);
    const DistanceFigures figures = MeasureSurfaceDistance(whole, holed).ReferenceToMesh;
    CHECK(figures.LargestFound > 0.6 && figures.Largest < 1.01);
    CheckBounds("small hole", figures, 0.7);
  }
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

/// A plane of 12 by 12 columns, without the 8 by 8 in its middle.
TriangleSurface MakeRing()
{
  TriangleSurface ring = MakeField(12, 1.0, Flat);
  const auto isIn = [&](const Corners& t)
  {
    const Eigen::Vector3d middle = (ring.Point(t[0]) + ring.Point(t[1]) + ring.Point(t[2])) / 3.0;
    return std::max(std::abs(middle.x() - 6.0), std::abs(middle.y() - 6.0)) < 4.0;
  };
  ring.Triangles.erase(std::remove_if(ring.Triangles.begin(), ring.Triangles.end(), isIn), ring.Triangles.end());
  return ring;
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
  const SurfaceDistance toRing = MeasureSurfaceDistance(MakeField(1, 12.0, Flat), MakeRing());
  CheckBounds("ring", toRing.ReferenceToMesh, 4.0);
  CHECK(toRing.ReferenceToMesh.LargestFound <= 4.0 + 1e-12 && toRing.MeshToReference.Largest < 1e-12);
}

/// What is left out has no part in the bounds; an edge between two points that count has.
void TestLeftOut()
{
  TriangleSurface spike = MakeField(6, 1.0, [](double x, double y) { return x == 3.0 && y == 3.0 ? 9.0 : 0.0; });
  spike.LeftOut.assign(spike.Points.size(), 0);
  spike.LeftOut[3 * 7 + 3] = 1;
  for (const int count : { 2, 5 })
  {
    CHECK(MeasureSurfaceDistance(spike, MakeField(count, 6.0 / count, Flat)).ReferenceToMesh.Largest < 1e-12);
  }
  // A triangle with one corner left out: its low side counts, across a hole.
  TriangleSurface ring = MakeRing();
  TriangleSurface bridge = ring;
  bridge.Points.emplace_back(6.0, 7.0, 50.0);
  bridge.Triangles.push_back({ 6 * 13 + 2, 6 * 13 + 10, PointId(ring.Points.size()) });
  bridge.LeftOut.assign(bridge.Points.size(), 0);
  bridge.LeftOut.back() = 1;
  const LargestDistance largest = FindFromCorners(bridge, ring, 1000);
  CheckBounds("bridge", largest.Found[0], largest.Most[0], 4.0, true);
  CHECK(FindFromCorners(ring, ring, 1000).Most[0] < 1e-12);
}

/// The bounds are the same on any number of threads, and hold what is found elsewhere.
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
