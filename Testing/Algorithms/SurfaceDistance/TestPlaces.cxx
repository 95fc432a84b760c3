// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Filters/Algorithms/SurfaceDistance/DistanceProbe.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Tools/Check.h"
#include "Tools/RandomSurfaces.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace RandomSurfaces;

namespace
{
bool IsNear(double found, double expected)
{
  return std::abs(found - expected) <= 1e-12 * (1.0 + std::abs(expected));
}

Metric World()
{
  return Metric((Eigen::Matrix2d() << 1.5, -1.0, 2.0, 0.75).finished(), 4.0);
}

TriangleSurface RandomField(int count, double step, double roughness, Patches::Random& random)
{
  return MakeField(count, step, [&](double, double) { return roughness * random.Fraction(); });
}

double Largest(const std::vector<double>& distances)
{
  return *std::max_element(distances.begin(), distances.end());
}

/// The largest distances of places on edges and on faces by measuring each of them, with the options' defaults.
struct LargestByHand
{
  MetricValues OnEdges;
  MetricValues OnFaces;

  LargestByHand(const TriangleSurface& from, const TriangleSurface& to, const std::vector<Metric>& metrics)
  {
    const TriangleSearch search(to);
    double area = 0.0;
    for (const Corners& t : from.Triangles)
    {
      area += from.Area(t);
    }
    // The surfaces have so few points that the least number of samples is taken.
    const double density = SurfaceDistanceOptions::LeastSamples / area;
    DistanceProbe onEdges(search, metrics);
    SurfaceEdges(from).ForEach(0, std::int64_t(from.Points.size()),
      [&](PointId low, PointId high, std::uint32_t)
      {
        const Eigen::Vector3d& a = from.Point(low);
        const Eigen::Vector3d& b = from.Point(high);
        const std::uint64_t edge = (std::uint64_t(low) << 32U) | std::uint64_t(high);
        SampleEdge(a, b, std::int64_t((b - a).norm() * std::sqrt(density)), Scramble(1 ^ Scramble(edge)), onEdges);
      });
    DistanceProbe onFaces(search, metrics);
    for (std::size_t n = 0; n < from.Triangles.size(); ++n)
    {
      const Corners& t = from.Triangles[n];
      SampleTriangle(from.Point(t[0]), from.Point(t[1]), from.Point(t[2]),
        std::max<std::int64_t>(1, std::int64_t(from.Area(t) * density + 0.5)), Scramble(1 ^ Scramble(n)), onFaces);
    }
    this->OnEdges = onEdges.Largest;
    this->OnFaces = onFaces.Largest;
  }
};

/// Places on edges that are left out change nothing: edges are nearer than they might be, and a ridge below which only
/// the middles of edges are far away.
void TestEdges()
{
  Patches::Random random(3);
  const std::vector<Metric> metrics = { Metric(), World() };
  int farthestOnEdges = 0;
  for (int run = 0; run < 20; ++run)
  {
    const TriangleSurface a = run == 0 ? MakeField(1, 40.0, [](double, double) { return 0.0; })
                                       : RandomField(3 + run, 40.0 / (3 + run), 0.2 * run, random);
    const TriangleSurface b = run == 0
      ? MakeField(40, 1.0, [](double x, double) { return 10.0 - 0.5 * std::abs(20.0 - x); })
      : RandomField(9, 4.5, 3.0, random);
    const std::vector<SurfaceDistance> found = MeasureSurfaceDistances(a, b, metrics);
    const LargestByHand expected(a, b, metrics);
    for (std::size_t metric = 0; metric < metrics.size(); ++metric)
    {
      const double ofPoints = Largest(found[metric].Reference.Distance);
      const double ofOthers = std::max(ofPoints, expected.OnFaces[metric]);
      const double largest = found[metric].ReferenceToMesh.LargestFound;
      const double byHand = std::max(ofOthers, expected.OnEdges[metric]);
      CHECK(largest >= byHand || IsNear(largest, byHand));
      CHECK(run != 0 || largest > 1.2 * ofPoints);
      farthestOnEdges += expected.OnEdges[metric] > ofOthers ? 1 : 0;
    }
  }
  CHECK(farthestOnEdges > 4);
}

TriangleSurface Mapped(const TriangleSurface& surface, const Metric& metric)
{
  TriangleSurface mapped = surface;
  for (Eigen::Vector3d& point : mapped.Points)
  {
    point = metric(point);
  }
  return mapped;
}

/// In two metrics at once: the first is as alone, the second as that of the mapped surfaces, up to where samples are.
void TestTwoMetrics()
{
  Patches::Random random(4);
  for (const double shift : { 0.0, 17.0 })
  {
    const TriangleSurface a = RandomField(40, 1.0, 2.0, random);
    TriangleSurface b = RandomField(13, 3.0, 2.0, random);
    for (Eigen::Vector3d& point : b.Points)
    {
      point.x() += shift; // only a part is across from the other one
    }
    const std::vector<SurfaceDistance> both = MeasureSurfaceDistances(a, b, { Metric(), World() });
    const SurfaceDistance first = MeasureSurfaceDistance(a, b);
    const SurfaceDistance second = MeasureSurfaceDistance(Mapped(a, World()), Mapped(b, World()));
    CHECK_EQUAL(both.size(), std::size_t(2));
    CHECK_EQUAL(both[0].TwoSided.Mean, first.TwoSided.Mean);
    CHECK(std::abs(both[0].TwoSided.Largest - first.TwoSided.Largest) < 0.01 * first.TwoSided.Largest);
    CHECK(both[0].Reference.Distance == first.Reference.Distance && both[1].Mesh.Vertical.empty());
    CHECK(both[0].TwoSided.Percentile == first.TwoSided.Percentile);
    CHECK(std::abs(both[1].TwoSided.Mean - second.TwoSided.Mean) < 0.01 * second.TwoSided.Mean);
    CHECK(std::abs(both[1].TwoSided.Percentile[1] - second.TwoSided.Percentile[1]) < 0.03 * second.TwoSided.Mean);
    CHECK(std::abs(both[1].TwoSided.Outline - second.TwoSided.Outline) < 0.01 * (1.0 + second.TwoSided.Outline));
    for (std::size_t point = 0; point < a.Points.size(); ++point)
    {
      CHECK(IsNear(both[1].Reference.Distance[point], second.Reference.Distance[point]));
    }
    for (std::size_t point = 0; point < b.Points.size(); ++point)
    {
      CHECK(IsNear(both[1].Mesh.Distance[point], second.Mesh.Distance[point]));
    }
  }
}

/// Vertical walls are weighted by their areas in each metric: far places count more where these are larger.
void TestWeights()
{
  TriangleSurface corner; // a square on the ground, and one that stands on end
  corner.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 2, 0, 2 } };
  corner.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 5 }, { 0, 5, 4 } };
  const TriangleSurface ground = MakeField(1, 2.0, [](double, double) { return 0.0; });
  const Metric tall(Eigen::Matrix2d::Identity(), 10.0);
  const std::vector<SurfaceDistance> found = MeasureSurfaceDistances(corner, ground, { Metric(), tall });
  // Means of the wall are 1 and 10; the wall is one half and ten elevenths of the area.
  CHECK(std::abs(found[0].ReferenceToMesh.Mean - 0.5) < 1e-3);
  CHECK(std::abs(found[1].ReferenceToMesh.Mean - 100.0 / 11.0) < 1e-2);
}
}

int TestPlaces(int, char*[])
{
  TestEdges();
  TestTwoMetrics();
  TestWeights();
  return Check::Result();
}
