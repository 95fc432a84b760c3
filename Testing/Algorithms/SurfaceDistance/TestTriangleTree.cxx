// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Filters/Algorithms/SurfaceDistance/DistanceProbe.h"
#include "Tools/Check.h"
#include "Tools/RandomSurfaces.h"

#include <algorithm>
#include <limits>

using namespace RandomSurfaces;

namespace
{
/// The same by another formula: the face where the foot of the perpendicular is inside, else the nearest side.
double DistanceByFormula(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  double squared = std::min(
    { SquaredDistanceToSegment(p, a, b), SquaredDistanceToSegment(p, b, c), SquaredDistanceToSegment(p, c, a) });
  if (normal.squaredNorm() > 1e-12 && (b - a).cross(p - a).dot(normal) > 0.0 &&
    (c - b).cross(p - b).dot(normal) > 0.0 && (a - c).cross(p - c).dot(normal) > 0.0)
  {
    const double height = (p - a).dot(normal);
    squared = std::min(squared, height * height / normal.squaredNorm());
  }
  return std::sqrt(squared);
}

double DistanceByHand(const TriangleSurface& surface, const Eigen::Vector3d& p)
{
  double distance = std::numeric_limits<double>::infinity();
  for (const Corners& t : surface.Triangles)
  {
    distance = std::min(distance, DistanceByFormula(p, surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2])));
  }
  return distance;
}

void TestClosestPoint()
{
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(4, 0, 0);
  const Eigen::Vector3d c(0, 4, 0);
  CHECK_EQUAL(SquaredDistanceToTriangle({ 1, 1, 3 }, a, b, c), 9.0); // the face
  CHECK_EQUAL(SquaredDistanceToTriangle({ 2, -3, 4 }, a, b, c), 25.0); // a side
  CHECK_EQUAL(SquaredDistanceToTriangle({ 4, 4, 0 }, a, b, c), 8.0); // the slanted side
  CHECK_EQUAL(SquaredDistanceToTriangle({ -3, -4, 12 }, a, b, c), 169.0); // a corner
  CHECK_EQUAL(SquaredDistanceToTriangle({ 6, 0, 0 }, a, b, b), 4.0); // a segment
  CHECK_EQUAL(SquaredDistanceToTriangle({ 2, 3, 4 }, a, b, { 1, 0, 0 }), 25.0); // three corners on one line
  CHECK_EQUAL(SquaredDistanceToTriangle({ 2, 3, 6 }, a, a, a), 49.0); // a point
}

/// Soups of all sizes, from near and from far away, hints from anywhere.
void TestAgainstBruteForce()
{
  Patches::Random random(7);
  for (const int count : { 1, 2, 3, 4, 5, 16, 17, 63, 64, 65, 200, 1000 })
  {
    const TriangleSurface surface = MakeSoup(count, 10.0, random);
    const TriangleTree tree(surface);
    std::int32_t hint = 0;
    for (int query = 0; query < 200; ++query)
    {
      const double reach = query % 10 == 0 ? 1e6 : 15.0;
      const Eigen::Vector3d place = RandomPlace(random, reach) - Eigen::Vector3d::Constant(0.2 * reach);
      const double expected = DistanceByHand(surface, place);
      hint = query % 3 == 0 ? random.Below(count) : hint;
      const double found = std::sqrt(tree.SquaredDistance(place, hint));
      CHECK(std::abs(found - expected) <= 1e-7 + 1e-12 * expected);
      CHECK(hint >= 0 && hint < count);
    }
  }
}

/// A place on the surface is at distance 0, however flat the surface is.
void TestHeights()
{
  const auto height = [](double x, double y) { return 3.0 + 0.25 * x - 0.5 * y; };
  const TriangleSurface surface = MakeField(20, 1.5, height);
  const TriangleTree tree(surface);
  Patches::Random random(3);
  for (int query = 0; query < 500; ++query)
  {
    const Eigen::Vector3d place = RandomPlace(random, 30.0);
    const double z = height(place.x(), place.y());
    CHECK(std::abs(tree.FindHeight(place, 1e-6) - z) < 1e-9);
    std::int32_t hint = 0;
    CHECK(tree.SquaredDistance({ place.x(), place.y(), z }, hint) < 1e-20);
  }
  for (const Eigen::Vector3d& corner : surface.Points)
  {
    CHECK(std::abs(tree.FindHeight(corner + Eigen::Vector3d(0, 0, 5), 1e-6) - corner.z()) < 1e-9);
  }
  // The tolerance reaches a little over the rim, and no further.
  CHECK(std::abs(tree.FindHeight({ -1e-7, 3.0, 0.0 }, 1e-6) - height(0.0, 3.0)) < 1e-6);
  CHECK(std::isnan(tree.FindHeight({ -1e-3, 3.0, 0.0 }, 1e-6)));
  CHECK(std::isnan(tree.FindHeight({ 1e7, 3.0, 0.0 }, 1e-6)));
}

/// Of two sheets the nearer one counts, and a vertical triangle does not.
void TestSheets()
{
  TriangleSurface surface;
  surface.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 10 }, { 4, 0, 10 }, { 0, 4, 10 } };
  surface.Triangles = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 1, 4 } };
  const TriangleTree tree(surface);
  CHECK_EQUAL(tree.FindHeight({ 1, 1, 4 }, 1e-6), 0.0);
  CHECK_EQUAL(tree.FindHeight({ 1, 1, 6 }, 1e-6), 10.0);
  CHECK_EQUAL(tree.FindHeight({ 2, 0, 5.5 }, 1e-6), 10.0);
  CHECK(std::isnan(tree.FindHeight({ 3, 3, 5 }, 1e-6)));
}
}

int TestTriangleTree(int, char*[])
{
  TestClosestPoint();
  TestAgainstBruteForce();
  TestHeights();
  TestSheets();
  return Check::Result();
}
