// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/TestHorizons.h"
#include "Tools/TriangleSets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

using namespace TestHorizons;
using namespace TriangleSets;

namespace
{
struct Hull
{
  BoundedHorizon Horizon;
  Triangulation Mesh;

  explicit Hull(const std::vector<PlanePoint>& places, std::int32_t subVoxelsPerColumn = SubVoxelsPerColumn)
  {
    this->Horizon.SubVoxelsPerColumn = subVoxelsPerColumn;
    this->Horizon.Plane = places;
    this->Horizon.Patch.assign(places.size(), 0);
    this->Horizon.Boundary = FindConvexHull(places);
    this->Mesh = Triangulate(this->Horizon);
  }

  Hull& Peel(const BoundaryLimits& limits)
  {
    RemoveOutsideTriangles(this->Horizon, this->Mesh, limits);
    return *this;
  }

  std::vector<PointId> Loop() const { return { this->Horizon.Boundary.begin(0), this->Horizon.Boundary.end(0) }; }
};

std::vector<PlanePoint> ToSubVoxels(const Patches::Columns& columns)
{
  return MakeLevelHorizon(columns).Plane;
}

Hull FromPicture(const std::vector<std::string>& picture)
{
  return Hull(ToSubVoxels(Patches::FromPicture(picture)));
}

double Distance(const PlanePoint& a, const PlanePoint& b)
{
  return std::hypot(double(a.X) - b.X, double(a.Y) - b.Y);
}

/// In degrees, at c.
double Angle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const double turn =
    std::atan2(double(a.Y) - c.Y, double(a.X) - c.X) - std::atan2(double(b.Y) - c.Y, double(b.X) - c.X);
  const double angle = std::abs(turn) * 45.0 / std::atan(1.0);
  return std::min(angle, 360.0 - angle);
}

/// The method in its plainest form: looks at all triangles again and again.
class PlainPeel
{
public:
  PlainPeel(const Hull& hull, const BoundaryLimits& limits)
    : Horizon(hull.Horizon)
    , Limits(limits)
    , Left(Canonical(hull.Mesh.Triangles))
  {
    while (this->TakeOffOne())
    {
    }
  }

  const Triangles& Result() const { return this->Left; }

private:
  bool TakeOffOne()
  {
    std::set<std::pair<PointId, PointId>> edges;
    for (const Triangle& t : this->Left)
    {
      edges.insert({ { t[0], t[1] }, { t[1], t[2] }, { t[2], t[0] } });
    }
    std::set<PointId> boundary;
    for (const auto& [from, to] : edges)
    {
      if (edges.count({ to, from }) == 0)
      {
        boundary.insert({ from, to });
      }
    }
    std::tuple<std::int64_t, PlanePoint, PlanePoint> longest;
    const Triangle* found = nullptr;
    for (const Triangle& t : this->Left)
    {
      for (std::size_t n = 0; n < 3; ++n)
      {
        const PlanePoint& a = this->At(t[n]);
        const PlanePoint& b = this->At(t[(n + 1) % 3]);
        const std::int64_t x = a.X - b.X;
        const std::int64_t y = a.Y - b.Y;
        const std::tuple<std::int64_t, PlanePoint, PlanePoint> edge(x * x + y * y, b, a);
        const bool isOpen = edges.count({ t[(n + 1) % 3], t[n] }) == 0 && boundary.count(t[(n + 2) % 3]) == 0;
        if (isOpen && this->IsOutside(a, b, this->At(t[(n + 2) % 3])) && (!found || longest < edge))
        {
          longest = edge;
          found = &t;
        }
      }
    }
    if (found)
    {
      this->Left.erase(Triangle(*found));
    }
    return found != nullptr;
  }

  const PlanePoint& At(PointId point) const { return this->Horizon.Plane[point]; }

  bool IsOutside(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) const
  {
    const double length = Distance(a, b) / this->Horizon.SubVoxelsPerColumn;
    return (this->Limits.LongestEdge > 0.0 && length > this->Limits.LongestEdge) ||
      Angle(a, b, c) > this->Limits.LargestAngle + 1e-6;
  }

  const BoundedHorizon& Horizon;
  const BoundaryLimits Limits;
  Triangles Left;
};

/// What must be true of any mesh that is left: sound, of all points, bounded by one loop that passes no point twice,
/// and all counts right.
void CheckSound(const Hull& peeled)
{
  CHECK_EQUAL(MeshChecker::CheckMesh(peeled.Horizon, peeled.Mesh.Triangles), std::string());
  CHECK_EQUAL(peeled.Horizon.Boundary.Size(), 1u);
  std::vector<PointId> loop = peeled.Loop();
  CHECK_EQUAL(peeled.Mesh.BoundaryEdges, loop.size());
  CHECK_EQUAL(peeled.Mesh.NonDelaunayEdges, 0u);
  const std::set<PointId> used(peeled.Mesh.Triangles.begin(), peeled.Mesh.Triangles.end());
  CHECK_EQUAL(used.size(), peeled.Horizon.Plane.size());
  std::sort(loop.begin(), loop.end());
  CHECK(std::adjacent_find(loop.begin(), loop.end()) == loop.end());
}

/// By hand: an L with arms three columns wide. The notch comes back; its corner is cut, as an outline cuts it.
void TestNotchOfAnL()
{
  const std::vector<std::string> picture = { "###...", "###...", "###...", "######", "######", "######" };
  CHECK_EQUAL(FromPicture(picture).Mesh.BoundaryEdges, 15u);
  for (const BoundaryLimits& limits : { BoundaryLimits{ 100.0, 0.0 }, { 180.0, 1.5 }, { 90.0, 2.0 } })
  {
    const Hull peeled = FromPicture(picture).Peel(limits);
    CheckSound(peeled);
    // 27 points, 19 of them on the outline.
    CHECK_EQUAL(peeled.Mesh.Triangles.size(), 3u * (2 * 27 - 2 - 19));
    CHECK_EQUAL(peeled.Mesh.BoundaryEdges, 19u);
    CHECK_EQUAL(peeled.Loop().front(), 0);
  }
}

/// An angle or an edge just as large as the limit stays.
void TestLimitsAreExact()
{
  const auto left = [](const std::vector<std::string>& picture, const BoundaryLimits& limits)
  { return FromPicture(picture).Peel(limits).Mesh.Triangles.size() / 3; };
  // An edge of two columns faces a right angle.
  const std::vector<std::string> gap = { "#.#", "###", "###" };
  CHECK_EQUAL(left(gap, {}), 7u);
  CHECK_EQUAL(left(gap, { 90.0, 0.0 }), 7u);
  CHECK_EQUAL(left(gap, { 89.999, 0.0 }), 6u);
  CHECK_EQUAL(left(gap, { 180.0, 2.0 }), 7u);
  CHECK_EQUAL(left(gap, { 180.0, 1.999 }), 6u);
  // One of three columns faces 108.43 degrees, and the edge behind it 135.
  const std::vector<std::string> wide = { "#..#", "####", "####" };
  CHECK_EQUAL(left(wide, {}), 10u);
  CHECK_EQUAL(left(wide, { 108.44, 0.0 }), 10u);
  CHECK_EQUAL(left(wide, { 108.43, 0.0 }), 8u);
}

/// Large as coordinates can be, nothing overflows.
void TestLargestCoordinates()
{
  constexpr std::int32_t most = (1 << 29) - 1;
  const std::vector<PlanePoint> places = { { -most, -most }, { most, -most }, { 0, 1 - most }, { 0, most } };
  CHECK_EQUAL(Hull(places, 1).Peel({ 180.0, 1e18 }).Mesh.Triangles.size(), 9u);
  CHECK_EQUAL(Hull(places, 1).Peel({ 180.0, 1073741820.0 }).Mesh.Triangles.size(), 6u);
  CHECK_EQUAL(Hull(places, 1).Peel({ 170.0, 0.0 }).Mesh.Triangles.size(), 6u);
}

void TestNothingToTakeOff()
{
  const std::vector<std::string> picture = { "##..", "##..", "####" };
  CHECK(FromPicture(picture).Peel({}).Mesh.Triangles == FromPicture(picture).Mesh.Triangles);
  CHECK(FromPicture(picture).Peel({}).Loop() == FromPicture(picture).Loop());
  for (const std::vector<std::string>& line : { std::vector<std::string>{ "#" }, { "##" }, { "#..#.#" } })
  {
    const Hull peeled = FromPicture(line).Peel({ 0.0, 0.1 });
    CHECK(peeled.Mesh.Triangles.empty());
    CHECK(peeled.Loop() == FromPicture(line).Loop());
    CHECK_EQUAL(peeled.Mesh.BoundaryEdges, 0u);
  }
  // However strict, the last triangle of a point stays.
  CHECK_EQUAL(FromPicture({ "##", "##" }).Peel({ 0.0, 0.1 }).Mesh.Triangles.size(), 6u);
}

/// Two groups of points stay joined by single triangles side by side.
void TestGroupsStayJoined()
{
  const Hull peeled = FromPicture({ "##........##", "##........##" }).Peel({ 180.0, 1.5 });
  CheckSound(peeled);
  CHECK_EQUAL(peeled.Mesh.Triangles.size(), 3u * 6);
  CheckSound(
    FromPicture({ "##......##", "##......##", "..........", "##......##", "##......##" }).Peel({ 180.0, 1.5 }));
}

/// Points at random, on a lattice and off it, with random limits.
std::vector<PlanePoint> RandomPlaces(int n, Patches::Random& random)
{
  if (n % 2 == 0)
  {
    return ToSubVoxels(Patches::Make(Patches::Shape(n / 2 % int(Patches::Shape::Count)), random));
  }
  std::set<PlanePoint> places;
  const std::int32_t size = 1 << (3 + random.Below(20));
  for (int point = 0; point < 4 + random.Below(80); ++point)
  {
    places.insert({ random.Below(size), random.Below(size) });
  }
  return { places.begin(), places.end() };
}

/// Half of all angles are those that points of a lattice can make, so that they are met.
BoundaryLimits RandomLimits(Patches::Random& random)
{
  const double extent = std::pow(2.0, 6.0 * random.Fraction() - 1.0);
  const double angle = random.Chance(0.5) ? 45.0 * random.Below(4) : 180.0 * random.Fraction();
  switch (random.Below(3))
  {
    case 0:
      return { angle, 0.0 };
    case 1:
      return { 180.0, extent };
    default:
      return { angle, extent };
  }
}

void TestRandomPlaces()
{
  Patches::Random random(21);
  std::size_t takenOff = 0;
  for (int n = 0; n < 1000; ++n)
  {
    const Hull whole(RandomPlaces(n, random));
    const BoundaryLimits limits = RandomLimits(random);
    Hull peeled = whole;
    peeled.Peel(limits);
    if (whole.Mesh.Triangles.empty())
    {
      continue;
    }
    CheckSound(peeled);
    const Triangles left = Canonical(peeled.Mesh.Triangles);
    takenOff += whole.Mesh.Triangles.size() / 3 - left.size();
    CHECK(n % 5 != 0 || left == PlainPeel(whole, limits).Result());
    peeled.Peel(limits);
    CHECK(Canonical(peeled.Mesh.Triangles) == left);
  }
  CHECK(takenOff > 1000);
}

/// On a full lattice only what an outline has is shorter than two columns. So wherever the outline passes no point
/// twice, the mesh inside it and what is left of the hull are the same.
void TestOutlinesComeBack()
{
  Patches::Random random(22);
  int compared = 0;
  for (int n = 0; n < 600; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon outlined = MakeLevelHorizon(columns);
    std::vector<PointId> loop(outlined.Boundary.begin(0), outlined.Boundary.end(0));
    std::sort(loop.begin(), loop.end());
    if (outlined.Boundary.Size() == 1 && std::adjacent_find(loop.begin(), loop.end()) == loop.end())
    {
      const Hull peeled = Hull(outlined.Plane).Peel({ 180.0, 1.5 });
      CHECK(Canonical(peeled.Mesh.Triangles) == Canonical(Triangulate(outlined).Triangles));
      ++compared;
    }
  }
  CHECK(compared > 100);
}

/// Triangles by the places of their points.
std::set<std::array<PlanePoint, 3>> ByPlace(const Hull& hull)
{
  std::set<std::array<PlanePoint, 3>> result;
  for (const Triangle& t : Canonical(hull.Mesh.Triangles))
  {
    const auto at = [&](std::size_t corner) { return hull.Horizon.Plane[t[corner]]; };
    std::array<PlanePoint, 3> places = { at(0), at(1), at(2) };
    std::sort(places.begin(), places.end());
    result.insert(places);
  }
  return result;
}

void TestOrderOfPointsIsNoMatter()
{
  Patches::Random random(23);
  for (int n = 0; n < 200; ++n)
  {
    const std::vector<PlanePoint> places = RandomPlaces(n, random);
    const std::vector<PlanePoint> reversed(places.rbegin(), places.rend());
    const BoundaryLimits limits = RandomLimits(random);
    CHECK(ByPlace(Hull(places).Peel(limits)) == ByPlace(Hull(reversed).Peel(limits)));
  }
}

void TestErrors()
{
  const auto peel = [](double angle, double length) { FromPicture({ "##", "##" }).Peel({ angle, length }); };
  CHECK_THROWS_WITH(peel(-1.0, 0.0), "boundary angle -1, expected 0 to 180 degrees");
  CHECK_THROWS_WITH(peel(181.0, 0.0), "boundary angle 181, expected");
  CHECK_THROWS_WITH(peel(std::nan(""), 0.0), "boundary angle nan, expected");
  CHECK_THROWS_WITH(peel(180.0, -2.0), "boundary edge length -2, expected at least 0 lattice units");
  CHECK_THROWS_WITH(peel(180.0, std::nan("")), "boundary edge length nan, expected");
  CHECK_THROWS_WITH(peel(180.0, HUGE_VAL), "boundary edge length inf, expected");
}

/// Every other column: no edge is short enough, so that triangles go until all points are on the boundary.
void TestMonitor()
{
  std::vector<PlanePoint> places;
  for (int n = 0; n < 100 * 100; ++n)
  {
    places.push_back({ 2 * (n % 100), 2 * (n / 100) });
  }
  const Hull hull(places, 1);
  CHECK_EQUAL(MonitorChecker::Check(3,
                [&](const Monitor& monitor)
                {
                  Hull copy = hull;
                  RemoveOutsideTriangles(copy.Horizon, copy.Mesh, { 180.0, 1.0 }, monitor);
                }),
    std::string());
}
}

int TestOutsideTriangles(int, char*[])
{
  TestNotchOfAnL();
  TestLimitsAreExact();
  TestLargestCoordinates();
  TestNothingToTakeOff();
  TestGroupsStayJoined();
  TestRandomPlaces();
  TestOutlinesComeBack();
  TestOrderOfPointsIsNoMatter();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
