// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes within an error: the bound, found by trying all triangles at all columns, and all else that holds for meshes.

#include "Common/Parallel.h"
#include "Decimation/Decimation.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/MeshChecker.h"
#include "Tools/MonitorChecker.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"
#include "Tools/TriangleSets.h"
#include "Triangulation/Triangulation.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

using namespace SeismicHorizons;

namespace
{
using TriangleSets::Canonical;
using TriangleSets::Triangle;

DecimationOptions Within(double error, std::size_t points = 0, bool fitHeights = false)
{
  DecimationOptions options;
  options.MaximumError = error;
  options.MaximumNumberOfPoints = points;
  options.FitHeights = fitHeights;
  return options;
}

/// The result beside the horizon it was made of, both in whole columns.
class Checker
{
public:
  Checker(const BoundedHorizon& horizon, const Decimation& decimation)
    : Horizon(horizon)
    , Result(decimation)
    , Triangles(Canonical(
        decimation.Triangles, [&decimation](PointId vertex) { return decimation.Points.Source[std::size_t(vertex)]; }))
    , Heights(horizon.Height)
  {
    for (std::size_t vertex = 0; vertex < decimation.Points.Source.size(); ++vertex)
    {
      this->Heights[std::size_t(decimation.Points.Source[vertex])] = decimation.Points.Height[vertex];
    }
    for (const PlanePoint& place : horizon.Plane)
    {
      this->PointAt[{ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn }] =
        PointId(this->Columns.size());
      this->Columns.push_back({ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn });
    }
  }

  /// What is wrong; empty when nothing is.
  std::string Check(double bound) const
  {
    const BoundedHorizon reduced = TestHorizons::Reduce(this->Horizon, this->Result.Points);
    const std::string mesh = MeshChecker::CheckMesh(reduced, this->Result.Triangles);
    if (!mesh.empty())
    {
      return mesh;
    }
    if (Canonical(this->Result.Triangles) != Canonical(Triangulate(reduced).Triangles))
    {
      return "not the mesh of the triangulation";
    }
    const std::string columns = this->CheckColumns(bound);
    return columns.empty() ? this->CheckSides(bound) : columns;
  }

private:
  double Area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) const
  {
    return double(ExactPlane::Cross({ b.X - a.X, b.Y - a.Y }, { c.X - a.X, c.Y - a.Y }));
  }

  const PlanePoint& At(PointId point) const { return this->Columns[std::size_t(point)]; }
  double Height(PointId point) const { return this->Horizon.Height[std::size_t(point)]; }
  double MeshHeight(PointId point) const { return this->Heights[std::size_t(point)]; }

  std::string CheckColumns(double bound) const
  {
    double largest = 0.0;
    std::vector<bool> covered(this->Columns.size(), false);
    for (const Triangle& t : this->Triangles)
    {
      for (std::size_t point = 0; point < this->Columns.size(); ++point)
      {
        const PlanePoint& p = this->Columns[point];
        const double a = this->Area(this->At(t[1]), this->At(t[2]), p);
        const double b = this->Area(this->At(t[2]), this->At(t[0]), p);
        const double c = this->Area(this->At(t[0]), this->At(t[1]), p);
        if (a >= 0.0 && b >= 0.0 && c >= 0.0)
        {
          const double height =
            (a * this->MeshHeight(t[0]) + b * this->MeshHeight(t[1]) + c * this->MeshHeight(t[2])) / (a + b + c);
          largest = std::max(largest, std::abs(height - this->Horizon.Height[point]));
          covered[point] = true;
        }
      }
    }
    std::ostringstream text;
    if (largest > bound + 1e-9 || std::abs(largest - this->Result.LargestError) > 1e-9)
    {
      text << "largest error " << largest << ", said " << this->Result.LargestError << ", bound " << bound;
    }
    return text.str();
  }

  std::string CheckSides(double bound) const
  {
    std::map<std::pair<PointId, PointId>, int> sides;
    for (const Triangle& t : this->Triangles)
    {
      for (std::size_t n = 0; n < 3; ++n)
      {
        ++sides[std::minmax({ t[n], t[(n + 1) % 3] })];
      }
    }
    double largest = 0.0;
    for (const auto& side : sides)
    {
      if (side.second == 2)
      {
        largest = std::max(largest, this->LargestAlong(side.first.first, side.first.second, &PlanePoint::X));
        largest = std::max(largest, this->LargestAlong(side.first.first, side.first.second, &PlanePoint::Y));
      }
    }
    return largest > bound + 1e-9 ? "a side is " + std::to_string(largest) + " off" : std::string();
  }

  /// Where a side crosses the lattice lines of one kind between two points.
  double LargestAlong(PointId from, PointId to, std::int32_t PlanePoint::*axis) const
  {
    const auto across = axis == &PlanePoint::X ? &PlanePoint::Y : &PlanePoint::X;
    const PlanePoint& a = this->At(from);
    const PlanePoint& b = this->At(to);
    double largest = 0.0;
    for (std::int32_t line = std::min(a.*axis, b.*axis) + 1; line < std::max(a.*axis, b.*axis); ++line)
    {
      const double part = (double(line) - a.*axis) / (double(b.*axis) - a.*axis);
      const double place = a.*across + part * (double(b.*across) - a.*across);
      PlanePoint low{};
      low.*axis = line;
      low.*across = std::int32_t(std::floor(place));
      PlanePoint high = low;
      ++(high.*across);
      const auto one = this->PointAt.find(low);
      const auto other = this->PointAt.find(high);
      const double between = place - std::floor(place);
      const bool isBetween = between > 1e-9 && between < 1.0 - 1e-9;
      if (isBetween && one != this->PointAt.end() && other != this->PointAt.end() && this->CanSee(low, high))
      {
        const double expected = (1.0 - between) * this->Height(one->second) + between * this->Height(other->second);
        const double height = this->MeshHeight(from) + part * (this->MeshHeight(to) - this->MeshHeight(from));
        largest = std::max(largest, std::abs(height - expected));
      }
    }
    return largest;
  }

  /// Whether no loop crosses the line between two columns.
  bool CanSee(const PlanePoint& a, const PlanePoint& b) const
  {
    bool clear = true;
    this->Horizon.Boundary.ForEachEdge(
      [&](PointId from, PointId to) { clear = clear && !ExactPlane::DoCross(a, b, this->At(from), this->At(to)); });
    return clear;
  }

  const BoundedHorizon& Horizon;
  const Decimation& Result;
  const TriangleSets::Triangles Triangles;
  std::vector<double> Heights; // by point, for vertices those of the mesh
  Patches::Columns Columns;
  std::map<PlanePoint, PointId> PointAt;
};

/// Noise, cliffs, terraces, spikes or a fold.
double HeightOf(int kind, const PlanePoint& column, Patches::Random& random)
{
  switch (kind)
  {
    case 0:
      return std::floor(40.0 * random.Fraction());
    case 1:
      return column.X > column.Y ? 100.0 : 0.0;
    case 2:
      return double(column.X / 4 * 3);
    case 3:
      return random.Chance(0.02) ? 50.0 : 5.0;
    default:
      return 10.0 * std::sin(0.3 * column.X + 0.2 * column.Y) + random.Fraction();
  }
}

void TestRandomPatches()
{
  Patches::Random random(41);
  for (int n = 0; n < 10000; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    std::vector<double> heights;
    for (const PlanePoint& column : columns)
    {
      heights.push_back(HeightOf(n % 5, column, random));
    }
    BoundaryOptions boundary;
    boundary.HoleBoundaries = n % 3 == 0;
    boundary.Radius = 1 + n % 2;
    BoundedHorizon horizon = TestHorizons::MakeHorizon(columns, heights, boundary);
    if (n % 2 == 0)
    {
      horizon = TestHorizons::Drop(
        horizon, SimplifyBoundary(TestHorizons::ToSpacePoints(horizon), horizon.Boundary, { 1.0, false, 1.5 }));
    }
    const double bound = std::array<double, 5>{ 0.0, 0.3, 0.75, 3.0, 100.0 }[std::size_t(random.Below(5))];
    const Decimation result = Decimate(horizon, Within(bound, 0, n % 4 < 2));
    const std::string problem = Checker(horizon, result).Check(bound);
    if (!CHECK_EQUAL(problem, std::string()))
    {
      std::cerr << "patch " << n << ", bound " << bound << '\n';
    }
  }
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
  BoundedHorizon horizon = TestHorizons::MakeHorizon(columns, heights);
  horizon = TestHorizons::Drop(
    horizon, SimplifyBoundary(TestHorizons::ToSpacePoints(horizon), horizon.Boundary, { 1e-6, false, 0.0 }));
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
  BoundedHorizon horizon = TestHorizons::MakeLevelHorizon(columns);
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
  BoundedHorizon horizon = TestHorizons::MakeLevelHorizon(columns);
  std::generate(horizon.Height.begin(), horizon.Height.end(), [&random]() { return random.Fraction(); });
  double before = std::numeric_limits<double>::infinity();
  for (const std::size_t most : { 156, 157, 200, 400, 1600 })
  {
    const Decimation result = Decimate(horizon, Within(0.0, most));
    CHECK_EQUAL(result.Points.Source.size(), most);
    CHECK(result.LargestError <= before || most < 400);
    before = result.LargestError;
  }
  CHECK_EQUAL(before, 0.0);
  CHECK_THROWS_WITH(Decimate(horizon, Within(0.0, 155)),
    "maximum number of points 155, expected at least the 156 of the loops, which are kept");
  // The bound still holds when it takes fewer points.
  CHECK_EQUAL(Decimate(horizon, Within(100.0, 1000)).Points.Source.size(), 156u);
}

/// As many vertices are nearer on average, loops stay, and no height moves farther than the bound.
void TestFitHeights()
{
  const Patches::Columns columns = Square(60);
  BoundedHorizon smooth = TestHorizons::MakeLevelHorizon(columns);
  BoundedHorizon horizon = smooth;
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    smooth.Height[point] = 8.0 * std::sin(0.2 * columns[point].X) * std::cos(0.17 * columns[point].Y);
    horizon.Height[point] = std::round(smooth.Height[point]);
  }
  const Decimation fitted = Decimate(smooth, Within(0.0, 400, true));
  CHECK_EQUAL(fitted.Points.Source.size(), 400u);
  CHECK(fitted.MeanError < 0.95 * Decimate(smooth, Within(0.0, 400)).MeanError);
  const Decimation bound = Decimate(horizon, Within(0.75, 0, true));
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

void TestThreads()
{
  Patches::Random random(9);
  const Patches::Columns columns = Square(120);
  const BoundedHorizon horizon = TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random));
  const int before = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1;
  const Decimation one = Decimate(horizon);
  Detail::NumberOfThreads() = 5;
  const Decimation five = Decimate(horizon);
  Detail::NumberOfThreads() = before;
  CHECK(one.Triangles == five.Triangles && one.Points.Source == five.Points.Source);
  CHECK(one.Points.Target == five.Points.Target && one.Errors == five.Errors && one.MeanError == five.MeanError);
}

void TestErrors()
{
  BoundedHorizon horizon = TestHorizons::MakeLevelHorizon(Square(5));
  CHECK_THROWS_WITH(Decimate(horizon, Within(-1.0)), "maximum error -1, expected at least 0 lattice units");
  CHECK_THROWS_WITH(
    Decimate(horizon, Within(std::nan(""))), "maximum error nan, expected a finite number, at least 0 lattice units");
  BoundedHorizon moved = horizon;
  ++moved.Plane[12].X;
  CHECK_THROWS_WITH(Decimate(moved), "point 12 stands beside its column, expected whole columns");
  BoundedHorizon twice = horizon;
  twice.Plane[12] = twice.Plane[11];
  CHECK_THROWS_WITH(Decimate(twice), "points 11 and 12 both in column (1, 2), expected at most one point");
  BoundedHorizon outside = horizon;
  outside.Plane[12] = { 9 * horizon.SubVoxelsPerColumn, 0 };
  CHECK_THROWS_WITH(Decimate(outside), "point 12 lies outside the boundary of its patch, expected loops around all");
  CHECK_EQUAL(Decimate(BoundedHorizon()).Triangles.size(), 0u);
  // Patches that someone took out leave gaps in the numbers.
  BoundedHorizon later = horizon;
  later.Patch.assign(later.Patch.size(), 3);
  CHECK(Decimate(later).Triangles == Decimate(horizon).Triangles);
}

void TestStop()
{
  Patches::Random random(9);
  const Patches::Columns columns = Square(60);
  const BoundedHorizon horizon = TestHorizons::MakeHorizon(columns, TestHorizons::MakeHeights(columns, random));
  CHECK_EQUAL(
    MonitorChecker::Check(8, [&](const Monitor& monitor) { Decimate(horizon, Within(0.1), monitor); }), std::string());
}
}

int TestDecimation(int, char*[])
{
  TestRandomPatches();
  TestPlane();
  TestSpike();
  TestNumberOfPoints();
  TestFitHeights();
  TestThreads();
  TestErrors();
  TestStop();
  return Check::Result();
}
