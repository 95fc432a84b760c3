// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Filters/Algorithms/SurfaceDistance/DistanceProbe.h"
#include "Tools/Check.h"
#include "Tools/RandomSurfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace RandomSurfaces;

namespace
{
/// The lattice itself, columns of a skew survey of metres with a step of some, a flat and a steep world.
std::vector<Metric> Metrics()
{
  const auto plan = [](double a, double b, double c, double d)
  { return Eigen::Matrix2d((Eigen::Matrix2d() << a, b, c, d).finished()); };
  return { Metric(), Metric(plan(20.0, -9.0, 15.0, 12.5), -4.0), Metric(plan(25.0, 0.0, 0.0, 25.0), 1e-3),
    Metric(plan(0.0, 1e-3, -1e-3, 0.0), 1.0) };
}

double Flat(double, double)
{
  return 0.0;
}

/// By trying all triangles.
double DistanceByHand(const TriangleSurface& surface, const Metric& metric, const Eigen::Vector3d& place)
{
  double squared = std::numeric_limits<double>::infinity();
  for (const Corners& t : surface.Triangles)
  {
    squared = std::min(squared,
      SquaredDistanceToTriangle(
        metric(place), metric(surface.Point(t[0])), metric(surface.Point(t[1])), metric(surface.Point(t[2]))));
  }
  return std::sqrt(squared);
}

/// The largest coordinate in a metric, for what rounding may do.
double SizeOf(const TriangleSurface& surface, const Metric& metric, const Eigen::Vector3d& place)
{
  double size = metric(place).cwiseAbs().maxCoeff();
  for (const Eigen::Vector3d& point : surface.Points)
  {
    size = std::max(size, metric(point).cwiseAbs().maxCoeff());
  }
  return size;
}

/// Distances and heights are those that are found by hand, or in the tree, whatever structure is chosen.
void CheckPlaces(const std::string& name, const TriangleSurface& surface, const std::vector<Eigen::Vector3d>& places)
{
  const TriangleSearch search(surface);
  const TriangleTree tree(surface);
  const std::vector<Metric> all = Metrics();
  for (std::size_t other = 0; other < all.size(); ++other)
  {
    const std::vector<Metric> metrics = { all[0], all[other] };
    DistanceProbe probe(search, metrics);
    DistanceProbe largest(search, metrics);
    for (const Eigen::Vector3d& place : places)
    {
      largest.RaiseLargest(place);
      const MetricValues found = probe(place);
      for (std::size_t n = 0; n < metrics.size(); ++n)
      {
        const double expected = DistanceByHand(surface, metrics[n], place);
        std::int32_t hint = 0;
        const double byTree = std::sqrt(tree.SquaredDistance(place, hint, metrics[n]));
        const double tolerance = 1e-9 * expected + 1e-12 * SizeOf(surface, metrics[n], place);
        if (!CHECK(std::abs(found[n] - expected) <= tolerance && std::abs(byTree - expected) <= tolerance))
        {
          std::cerr << name << ", metric " << (n == 0 ? n : other) << " at " << place.transpose() << ": " << found[n]
                    << ", by hand " << expected << ", by tree " << byTree << '\n';
        }
      }
      const double height = probe.FindHeight(place, 1e-6);
      const double byTree = tree.FindHeight(place, 1e-6);
      CHECK(std::isnan(height) == std::isnan(byTree) &&
        (std::isnan(height) || std::abs(height - byTree) <= 1e-9 * (1.0 + std::abs(height))));
    }
    for (std::size_t n = 0; n < metrics.size(); ++n)
    {
      CHECK(std::abs(largest.Largest[n] - probe.Largest[n]) <= 1e-12 * probe.Largest[n]);
    }
  }
}

/// Places near a surface, at its points, and far away.
std::vector<Eigen::Vector3d> MakePlaces(
  const TriangleSurface& surface, int count, double reach, Patches::Random& random)
{
  std::vector<Eigen::Vector3d> places;
  for (int n = 0; n < count; ++n)
  {
    const Corners& t = surface.Triangles[random.Below(int(surface.Triangles.size()))];
    const double u = random.Fraction();
    const double v = random.Fraction() * (1.0 - u);
    const Eigen::Vector3d on = u * surface.Point(t[0]) + v * surface.Point(t[1]) + (1.0 - u - v) * surface.Point(t[2]);
    const double far = n % 10 == 0 ? 100.0 * reach : n % 3 == 0 ? 0.01 * reach : reach;
    places.push_back(n % 7 == 0 ? surface.Point(t[1]) : on);
    places.push_back(on + RandomPlace(random, far) - Eigen::Vector3d::Constant(0.5 * far));
  }
  return places;
}

bool HasRaster(const TriangleSurface& surface)
{
  return TriangleRaster(surface).IsWorthwhile();
}

void TestFields()
{
  Patches::Random random(5);
  for (const int count : { 1, 2, 9, 24 })
  {
    for (const double step : { 1.0, 0.01, 3.7 })
    {
      for (const double roughness : { 0.0, 0.3, 5.0, 1e3, 1e9 })
      {
        const TriangleSurface field =
          MakeField(count, step, [&](double, double) { return roughness * step * random.Fraction(); });
        CHECK(HasRaster(field));
        CheckPlaces("field", field, MakePlaces(field, 30, step * (1.0 + roughness), random));
        CheckPlaces("field, places beside", field, MakePlaces(MakeField(3, 20.0 * step, Flat), 10, step, random));
      }
    }
  }
}

double Lifted(double, double)
{
  return 1e9;
}

/// Moved away from the origin, turned over, lifted far up.
void TestPositions()
{
  Patches::Random random(6);
  TriangleSurface field = MakeField(12, 1.0, [&random](double, double) { return random.Fraction(); });
  std::vector<Eigen::Vector3d> places = MakePlaces(field, 40, 1.0, random);
  CheckPlaces("far below", MakeField(12, 1.0, Lifted), places);
  TriangleSurface down = field;
  for (Corners& t : down.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  CHECK(HasRaster(down));
  CheckPlaces("facing down", down, places);
  for (const double shift : { 0.5, 1e5, -1e9 })
  {
    TriangleSurface moved = field;
    for (Eigen::Vector3d& point : moved.Points)
    {
      point += Eigen::Vector3d(shift, -0.3 * shift, 7.0 * shift);
    }
    CheckPlaces("moved", moved, MakePlaces(moved, 40, 1.0, random));
  }
}

/// One triangle of every kind; only what has an area in plan has a raster.
void TestSingleTriangles()
{
  Patches::Random random(7);
  TriangleSurface one;
  one.Triangles = { { 0, 1, 2 } };
  for (const Eigen::Vector3d& last : { Eigen::Vector3d(0, 3, 1), Eigen::Vector3d(1, 1e-7, 1), Eigen::Vector3d(1, 0, 5),
         Eigen::Vector3d(2, 0, 1), Eigen::Vector3d(1e6, 1e6, 1e6), Eigen::Vector3d(4, 0, 2) })
  {
    one.Points = { { 0, 0, 0 }, { 4, 0, 2 }, last };
    CheckPlaces("one", one, MakePlaces(one, 40, 5.0, random));
  }
  one.Points = { { 0, 0, 0 }, { 4, 0, 2 }, { 1, 0, 5 } };
  CHECK(!HasRaster(one));
}

/// Triangles anywhere: many lie across each other.
void TestSoups()
{
  Patches::Random random(8);
  for (const int count : { 2, 5, 40, 300 })
  {
    const TriangleSurface soup = MakeSoup(count, 10.0, random);
    CheckPlaces("soup", soup, MakePlaces(soup, 60, 3.0, random));
  }
}

/// Two sheets, one over a part of the other, joined by a wall: an overhang. Places near its rim are nearest to either.
void TestOverhang()
{
  Patches::Random random(9);
  TriangleSurface folded = MakeField(12, 1.0, [&random](double, double) { return random.Fraction(); });
  const PointId first = PointId(folded.Points.size());
  const TriangleSurface above = MakeField(5, 1.3, [&random](double, double) { return 1.0 + random.Fraction(); });
  folded.Points.insert(folded.Points.end(), above.Points.begin(), above.Points.end());
  for (const Corners& t : above.Triangles)
  {
    folded.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  folded.Triangles.push_back({ 0, 1, first });
  CHECK(HasRaster(folded));
  CHECK(!TriangleRaster(folded).IsAlone(0));
  CHECK(TriangleRaster(folded).IsAlone(2 * 12 * 12 - 1));
  CheckPlaces("folded", folded, MakePlaces(folded, 200, 1.0, random));
}

/// Where no raster helps there is none: a pile, needles across everything, two heaps far from each other.
void TestNotWorthwhile()
{
  Patches::Random random(10);
  TriangleSurface pile;
  TriangleSurface needles;
  TriangleSurface heaps;
  for (PointId n = 0; n < 3 * 2000; n += 3)
  {
    for (TriangleSurface* const surface : { &pile, &needles, &heaps })
    {
      surface->Triangles.push_back({ n, n + 1, n + 2 });
    }
    const double far = n % 2 == 0 ? 0.0 : 1e7;
    for (int corner = 0; corner < 3; ++corner)
    {
      pile.Points.push_back(RandomPlace(random, 1.0) + Eigen::Vector3d(0, 0, n));
      heaps.Points.push_back(RandomPlace(random, 1.0) + Eigen::Vector3d(far, far, 0));
    }
    needles.Points.emplace_back(0, n, 0);
    needles.Points.emplace_back(6000, n, 1);
    needles.Points.emplace_back(6000, n + 1, 0);
  }
  for (const TriangleSurface& surface : { pile, needles, heaps })
  {
    CHECK(!HasRaster(surface));
    CheckPlaces("not worthwhile", surface, MakePlaces(surface, 10, 1.0, random));
  }
}

/// One huge triangle beside many small ones.
void TestHugeTriangle()
{
  Patches::Random random(11);
  TriangleSurface surface = MakeField(30, 0.1, [&random](double, double) { return 0.1 * random.Fraction(); });
  const PointId first = PointId(surface.Points.size());
  surface.Points.insert(surface.Points.end(), { { 3.0, 0.0, 0.0 }, { 40.0, -7.0, 55.0 }, { 12.0, 60.0, -20.0 } });
  surface.Triangles.push_back({ first, first + 1, first + 2 });
  CheckPlaces("huge", surface, MakePlaces(surface, 100, 2.0, random));
  CheckPlaces("around huge", surface, MakePlaces(MakeField(2, 30.0, Flat), 60, 20.0, random));
}

/// A square that reaches into a column of cells by less than the raster's slack is not listed there, and found all the
/// same from a place next to it.
void TestSlack()
{
  TriangleSurface surface = MakeField(8, 1.0, [](double, double) { return -4e-7; });
  const PointId first = PointId(surface.Points.size());
  surface.Points.insert(
    surface.Points.end(), { { 2.2, 2.0, 0.0 }, { 3.0 + 5e-7, 2.0, 0.0 }, { 3.0 + 5e-7, 3.0, 0.0 } });
  surface.Triangles.push_back({ first, first + 1, first + 2 });
  CHECK(HasRaster(surface));
  CheckPlaces("slack", surface, { { 3.0 + 7e-7, 2.5, 0.0 }, { 3.0 + 6e-7, 2.25, 1e-8 } });
}

/// Each triangle is visited once, in chunks of cells.
void TestEachOnce()
{
  Patches::Random random(12);
  for (const TriangleSurface& surface :
    { MakeField(40, 1.0, Flat), MakeSoup(50, 10.0, random), MakeField(7, 2.6, Flat) })
  {
    const TriangleSearch search(surface);
    std::vector<int> visits(surface.Triangles.size(), 0);
    for (std::int64_t first = 0; first < search.Pieces(); first += 7)
    {
      search.ForEachTriangle(
        first, std::min(first + 7, search.Pieces()), [&visits](std::int32_t triangle) { ++visits[triangle]; });
    }
    CHECK_EQUAL(std::count(visits.begin(), visits.end(), 1), std::ptrdiff_t(visits.size()));
  }
}

/// A metric measures as the mapped coordinates do, and never less than its weights say.
void TestMetrics()
{
  Patches::Random random(13);
  const Eigen::Matrix2d plan = (Eigen::Matrix2d() << 3.0, -2.0, 1.0, 5.0).finished();
  const Metric metric(plan, -0.5);
  for (int n = 0; n < 100; ++n)
  {
    const Eigen::Vector3d v = RandomPlace(random, 2.0) - Eigen::Vector3d::Ones();
    Eigen::Vector3d mapped(0.0, 0.0, -0.5 * v.z());
    mapped.head<2>() = plan * v.head<2>();
    CHECK(std::abs(metric.Length(v) - mapped.norm()) < 1e-12);
    CHECK((metric.Weights() * v.array()).matrix().norm() <= mapped.norm() + 1e-12);
    CHECK(std::abs(metric.Transposed(metric(v)).dot(v) - mapped.squaredNorm()) < 1e-12);
  }
  TriangleSurface one;
  one.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  one.Triangles = { { 0, 1, 2 } };
  CHECK(std::abs(metric.Area(one, one.Triangles[0]) - 8.5) < 1e-12);
  CHECK(std::abs(metric.SquaredPlanShrinkage() - 1.0 / (17.0 * 17.0)) < 1e-15);
}
}

int TestTriangleRaster(int, char*[])
{
  TestFields();
  TestPositions();
  TestSingleTriangles();
  TestSoups();
  TestOverhang();
  TestNotWorthwhile();
  TestHugeTriangle();
  TestSlack();
  TestEachOnce();
  TestMetrics();
  return Check::Result();
}
