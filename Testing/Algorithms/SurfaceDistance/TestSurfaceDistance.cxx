// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/RandomSurfaces.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace RandomSurfaces;

namespace
{
bool IsNear(double found, double expected, double tolerance)
{
  return std::abs(found - expected) <= tolerance || (std::isnan(found) && std::isnan(expected));
}

double Flat(double, double)
{
  return 0.0;
}

/// Everything is one distance, and that is exact.
void TestParallelPlanes()
{
  const TriangleSurface low = MakeField(10, 1.0, Flat);
  const TriangleSurface high = MakeField(4, 2.5, [](double, double) { return 3.0; });
  const SurfaceDistance distance = MeasureSurfaceDistance(low, high);
  for (const DistanceFigures& figures : { distance.ReferenceToMesh, distance.MeshToReference, distance.TwoSided })
  {
    CHECK_EQUAL(figures.Largest, 3.0);
    CHECK(IsNear(figures.Mean, 3.0, 1e-12) && IsNear(figures.Rms, 3.0, 1e-12));
    for (const double percentile : figures.Percentile)
    {
      CHECK_EQUAL(percentile, 3.0);
    }
    CHECK(figures.Outline < 1e-12);
  }
  CHECK(std::abs(double(distance.ReferenceToMesh.Samples) - SurfaceDistanceOptions::LeastSamples) < 100.0);
  for (const double vertical : distance.Reference.Vertical)
  {
    CHECK_EQUAL(vertical, -3.0);
  }
  for (const double vertical : distance.Mesh.Vertical)
  {
    CHECK_EQUAL(vertical, 3.0);
  }
}

/// A tent of height 2 over a plane of 8 x 8: from the tent, distances to the plane are even from 0 to 2. From the plane
/// the nearest place of a tent's side of slope 1/2 is at 1/sqrt(5/4) of the height above it.
void TestTent()
{
  const TriangleSurface plane = MakeField(1, 8.0, Flat);
  TriangleSurface tent;
  tent.Points = { { 0, 0, 0 }, { 4, 0, 2 }, { 8, 0, 0 }, { 0, 8, 0 }, { 4, 8, 2 }, { 8, 8, 0 } };
  tent.Triangles = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 } };
  SurfaceDistanceOptions options;
  options.SamplesPerPoint = 20000.0;
  const SurfaceDistance distance = MeasureSurfaceDistance(plane, tent, options);
  CHECK_EQUAL(distance.MeshToReference.Largest, 2.0);
  CHECK(IsNear(distance.MeshToReference.Mean, 1.0, 1e-3));
  CHECK(IsNear(distance.MeshToReference.Rms, std::sqrt(4.0 / 3.0), 1e-3));
  CHECK(IsNear(distance.MeshToReference.Percentile[0], 1.0, 5e-3));
  CHECK(IsNear(distance.MeshToReference.Percentile[1], 1.8, 5e-3));
  CHECK(IsNear(distance.MeshToReference.Percentile[3], 1.98, 5e-3));
  const double slant = 1.0 / std::sqrt(1.25);
  CHECK(IsNear(distance.ReferenceToMesh.Mean, slant, 2e-3));
  // Below the ridge; edges and faces are sampled, and the plane's diagonal runs there.
  CHECK(distance.ReferenceToMesh.LargestFound <= 2.0 * slant + 1e-12);
  CHECK(distance.ReferenceToMesh.LargestFound > 2.0 * slant - 0.02);
  CHECK_EQUAL(distance.TwoSided.Largest, 2.0);
  const double slope = std::sqrt(1.25);
  CHECK(IsNear(distance.TwoSided.Mean, (slant + slope) / (1.0 + slope), 2e-3));
  CHECK_EQUAL(distance.Mesh.Vertical[1], 2.0);
}

/// A mesh that ends early: from the mesh all is well, from the reference the missing part is as far as it is long.
void TestMissingPatch()
{
  const TriangleSurface whole = MakeField(10, 1.0, Flat);
  TriangleSurface part = whole;
  part.Triangles.resize(100); // rows of y below 5
  const SurfaceDistance distance = MeasureSurfaceDistance(whole, part);
  CHECK(distance.MeshToReference.Largest < 1e-12);
  CHECK(distance.MeshToReference.Percentile[3] < 1e-12);
  CHECK_EQUAL(distance.ReferenceToMesh.Largest, 5.0);
  CHECK(IsNear(distance.ReferenceToMesh.Mean, 1.25, 0.01));
  CHECK(IsNear(distance.ReferenceToMesh.Percentile[1], 4.0, 0.05));
  CHECK_EQUAL(distance.ReferenceToMesh.Outline, 5.0);
  CHECK(IsNear(distance.MeshToReference.Outline, 5.0, 0.1)); // from the middle of the new rim
  CHECK_EQUAL(distance.Reference.Vertical[0], 0.0);
  CHECK(std::isnan(distance.Reference.Vertical.back()));
  CHECK_EQUAL(distance.Mesh.Distance.back(), 0.0); // a point without triangles is measured, too
}

/// Means of samples are those of a dense regular sampling, on meshes that have nothing in common.
void TestAgainstBruteForce()
{
  Patches::Random random(11);
  const TriangleSurface a = MakeField(12, 1.0, [&random](double, double) { return 3.0 * random.Fraction(); });
  const TriangleSurface b = MakeField(5, 2.4, [&random](double, double) { return 3.0 * random.Fraction(); });
  double sum = 0.0;
  double area = 0.0;
  double largest = 0.0;
  constexpr int Cuts = 12;
  for (const Corners& t : a.Triangles)
  {
    for (int n = 0; n < Cuts * Cuts; ++n)
    {
      double u = (n / Cuts + 1.0 / 3.0) / Cuts;
      double v = (n % Cuts + 1.0 / 3.0) / Cuts;
      const bool beyond = u + v > 1.0;
      u = beyond ? 1.0 - u : u;
      v = beyond ? 1.0 - v : v;
      const Eigen::Vector3d place =
        a.Point(t[0]) + u * (a.Point(t[1]) - a.Point(t[0])) + v * (a.Point(t[2]) - a.Point(t[0]));
      double squared = std::numeric_limits<double>::infinity();
      for (const Corners& other : b.Triangles)
      {
        squared =
          std::min(squared, SquaredDistanceToTriangle(place, b.Point(other[0]), b.Point(other[1]), b.Point(other[2])));
      }
      sum += a.Area(t) / (Cuts * Cuts) * std::sqrt(squared);
      area += a.Area(t) / (Cuts * Cuts);
      largest = std::max(largest, std::sqrt(squared));
    }
  }
  const SurfaceDistance distance = MeasureSurfaceDistance(a, b);
  CHECK(IsNear(distance.ReferenceToMesh.Mean, sum / area, 0.01 * sum / area));
  CHECK(distance.ReferenceToMesh.Largest >= largest - 0.05);
}

bool AreSame(const DistanceFigures& a, const DistanceFigures& b)
{
  return a.Largest == b.Largest && a.LargestFound == b.LargestFound && a.Mean == b.Mean && a.Rms == b.Rms &&
    a.Percentile == b.Percentile && a.Samples == b.Samples && IsNear(a.Outline, b.Outline, 0.0);
}

bool AreSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0;
}

/// The same bytes on any number of threads, other samples with another seed, and the two sides can be exchanged.
void TestSameResults()
{
  Patches::Random random(5);
  const TriangleSurface a = MakeField(90, 1.0, [&random](double, double) { return 3.0 * random.Fraction(); });
  const TriangleSurface b = MakeField(31, 3.0, [&random](double, double) { return 3.0 * random.Fraction(); });
  const int usual = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1;
  const SurfaceDistance one = MeasureSurfaceDistance(a, b);
  for (const int threads : { 2, 3, 7 })
  {
    Detail::NumberOfThreads() = threads;
    const SurfaceDistance many = MeasureSurfaceDistance(a, b);
    CHECK(AreSame(one.ReferenceToMesh, many.ReferenceToMesh) && AreSame(one.MeshToReference, many.MeshToReference));
    CHECK(AreSame(one.TwoSided, many.TwoSided));
    CHECK(AreSame(one.Reference.Distance, many.Reference.Distance) && AreSame(one.Mesh.Vertical, many.Mesh.Vertical));
  }
  Detail::NumberOfThreads() = usual;
  const SurfaceDistance swapped = MeasureSurfaceDistance(b, a);
  CHECK(AreSame(one.ReferenceToMesh, swapped.MeshToReference) && AreSame(one.TwoSided, swapped.TwoSided));
  CHECK(AreSame(one.Reference.Distance, swapped.Mesh.Distance));
  SurfaceDistanceOptions options;
  options.Seed = 2;
  const SurfaceDistance other = MeasureSurfaceDistance(a, b, options);
  CHECK(other.TwoSided.Mean != one.TwoSided.Mean);
  CHECK(IsNear(other.TwoSided.Mean, one.TwoSided.Mean, 0.01 * one.TwoSided.Mean));
  // The same surface moved and turned has the same distances.
  TriangleSurface movedA = a;
  TriangleSurface movedB = b;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (TriangleSurface* surface : { &movedA, &movedB })
  {
    for (Eigen::Vector3d& point : surface->Points)
    {
      point = turn * point + Eigen::Vector3d(1000, -2000, 300);
    }
  }
  const SurfaceDistance moved = MeasureSurfaceDistance(movedA, movedB);
  CHECK(IsNear(moved.TwoSided.Mean, one.TwoSided.Mean, 0.01 * one.TwoSided.Mean));
  for (std::size_t point = 0; point < a.Points.size(); ++point)
  {
    CHECK(IsNear(moved.Reference.Distance[point], one.Reference.Distance[point], 1e-9));
  }
}

/// Far apart, with triangles of no area, vertical, closed: whatever comes, distances are right.
void TestHardSurfaces()
{
  TriangleSurface plane = MakeField(2, 1.0, Flat);
  TriangleSurface far = plane;
  for (Eigen::Vector3d& point : far.Points)
  {
    point.z() += 1e9;
  }
  CHECK_EQUAL(MeasureSurfaceDistance(plane, far).TwoSided.Percentile[2], 1e9);
  plane.Triangles.push_back({ 0, 0, 0 });
  plane.Triangles.push_back({ 0, 1, 2 });
  CHECK(MeasureSurfaceDistance(plane, MakeField(1, 2.0, Flat)).TwoSided.Largest < 1e-12);
  TriangleSurface wall;
  wall.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 4 } };
  wall.Triangles = { { 0, 1, 2 } };
  const SurfaceDistance toWall = MeasureSurfaceDistance(MakeField(2, 1.0, Flat), wall);
  CHECK_EQUAL(toWall.MeshToReference.Largest, 4.0);
  CHECK(std::isnan(toWall.Reference.Vertical[4]));
  TriangleSurface closed;
  closed.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  closed.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  CHECK(std::isnan(MeasureSurfaceDistance(closed, wall).TwoSided.Outline));
  Patches::Random random(9);
  const TriangleSurface soup = MakeSoup(300, 10.0, random);
  const SurfaceDistance itself = MeasureSurfaceDistance(soup, soup);
  CHECK(itself.TwoSided.Largest < 1e-7);
}

void TestEdges()
{
  const TriangleSurface field = MakeField(3, 1.0, Flat);
  int inner = 0;
  int outer = 0;
  SurfaceEdges(field).ForEach(0, 16, [&](PointId, PointId, std::uint32_t uses) { ++(uses == 1 ? outer : inner); });
  CHECK_EQUAL(outer, 12);
  CHECK_EQUAL(inner, 21);
  CHECK_EQUAL(FindOutline(field, SurfaceEdges(field)).Points.size(), std::size_t(12));
}

/// The value below which a part of all values lies.
double PercentileByHand(std::vector<double> values, double part)
{
  std::sort(values.begin(), values.end());
  return values[std::size_t(part * double(values.size()))];
}

/// Percentiles of many values are right to a thousandth; those of no distance are 0, and those without a bound
/// infinite.
void TestPercentiles()
{
  TriangleSurface fans;
  std::vector<double> ratios;
  for (PointId n = 0; n < 3 * 2000; n += 3)
  {
    const double side = 1.0 + 0.01 * n;
    const double slant = std::sqrt(1.0 + side * side);
    fans.Points.insert(fans.Points.end(), { { 0, 0, 0 }, { side, 0, 0 }, { 0, 1, 0 } });
    fans.Triangles.push_back({ n, n + 1, n + 2 });
    ratios.insert(ratios.end(), { side, slant, slant / side });
  }
  const Grading grading = MeasureGrading(fans);
  const double median = PercentileByHand(ratios, 0.5);
  const double high = PercentileByHand(ratios, 0.95);
  CHECK(IsNear(grading.Median, median, 2e-3 * median) && IsNear(grading.Percentile95, high, 2e-3 * high));
  for (PointId n = 0; n < 400; ++n)
  {
    fans.Triangles.push_back({ n, n, n + 1 });
  }
  CHECK(std::isinf(MeasureGrading(fans).Percentile95));
  const SurfaceDistance none = MeasureSurfaceDistance(MakeField(8, 1.0, Flat), MakeField(4, 2.0, Flat));
  CHECK_EQUAL(none.TwoSided.Percentile[0], 0.0);
  CHECK_EQUAL(none.TwoSided.Percentile[3], 0.0);
}

/// A right-angled triangle has the ratios 1, sqrt(2), sqrt(2); one of sides 1 and 10 has 10, and about 10 and 1.
void TestGrading()
{
  const Grading even = MeasureGrading(MakeField(8, 1.0, Flat));
  CHECK(IsNear(even.Median, std::sqrt(2.0), 2e-3) && IsNear(even.Percentile95, std::sqrt(2.0), 2e-3));
  TriangleSurface thin;
  thin.Points = { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 1, 0 } };
  thin.Triangles = { { 0, 1, 2 } };
  CHECK(IsNear(MeasureGrading(thin).Median, 10.0, 0.03));
}

void TestErrors()
{
  const TriangleSurface good = MakeField(2, 1.0, Flat);
  TriangleSurface bad;
  CHECK_THROWS_WITH(MeasureSurfaceDistance(good, bad), "mesh: 0 points and no triangles, expected a triangle mesh");
  bad = good;
  bad.Points[4].y() = std::nan("");
  CHECK_THROWS_WITH(MeasureSurfaceDistance(bad, good), "reference: point 4 at (1, nan, 0), expected finite");
  bad.Points[4].y() = 1e17;
  CHECK_THROWS_WITH(MeasureSurfaceDistance(good, bad), "mesh: point 4 at (1, 1e+17, 0), expected finite coordinates");
  bad = good;
  bad.Triangles[2][1] = 9;
  CHECK_THROWS_WITH(
    MeasureSurfaceDistance(good, bad), "mesh: triangle 2 has the corner 9, expected points from 0 to 8");
  bad.Triangles = { { 0, 1, 2 }, { 3, 3, 3 } };
  CHECK_THROWS_WITH(MeasureSurfaceDistance(good, bad), "mesh: 2 triangles without any area, expected a surface");
}

void TestStop()
{
  const TriangleSurface field = MakeField(60, 1.0, Flat);
  CHECK_EQUAL(
    MonitorChecker::Check(
      20, [&](const Monitor& monitor) { MeasureSurfaceDistance(field, field, SurfaceDistanceOptions(), monitor); }),
    std::string());
}

/// One needle, a million times as long as it is wide: samples by its area would be one for each thousandth of its
/// width.
void TestNeedle()
{
  for (const double length : { 1e6, 1e9, 1e14 })
  {
    TriangleSurface needle;
    needle.Points = { { 0.0, 0.0, 0.0 }, { length, 0.0, 0.0 }, { 0.0, 1e-3, 0.0 } };
    needle.Triangles = { { 0, 1, 2 } };
    // Places along it are known to some units in the last place of its length.
    const double largest = MeasureSurfaceDistance(needle, needle, SurfaceDistanceOptions()).TwoSided.Largest;
    CHECK(largest <= 4.0 * std::numeric_limits<double>::epsilon() * length);
  }
}

/// A rough field, pulled ever higher: all its triangles become needles that point up, in all directions of the plan.
void TestSteepSurface()
{
  for (const double scale : { 1e3, 1e5, 1e6, 1e7 })
  {
    Patches::Random random(3);
    const TriangleSurface steep = MakeField(5, 1.0, [&](double, double) { return scale * random.Fraction(); });
    const double largest = MeasureSurfaceDistance(steep, steep, SurfaceDistanceOptions()).TwoSided.Largest;
    // A place on a face is right to some units in the last place of its height.
    if (!CHECK(largest <= 1e-9 + 10.0 * std::numeric_limits<double>::epsilon() * scale))
    {
      std::cerr << "height scale " << scale << ": " << largest << '\n';
    }
  }
}
}

int TestSurfaceDistance(int, char*[])
{
  TestParallelPlanes();
  TestTent();
  TestMissingPatch();
  TestAgainstBruteForce();
  TestSameResults();
  TestHardSurfaces();
  TestEdges();
  TestPercentiles();
  TestGrading();
  TestErrors();
  TestStop();
  TestNeedle();
  TestSteepSurface();
  return Check::Result();
}
