// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DelaunayMesh.h"

#include "Common/Predicates.h"

#include <algorithm>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr int MostSteps = 100;

// The side of a triangle that is opposite to its third corner.
constexpr int Opposite = 0;

constexpr int Previous(int corner)
{
  return corner == 0 ? 2 : corner - 1;
}
}

//----------------------------------------------------------------------------------------------------------------------
DelaunayMesh::DelaunayMesh(const std::vector<PlanePoint>& plane, const RawVector<PointId>& triangles)
  : Plane(plane)
{
  this->Triangles.reserve(triangles.size() / 3);
  for (std::size_t first = 0; first < triangles.size(); first += 3)
  {
    this->Triangles.push_back(
      { { triangles[first], triangles[first + 1], triangles[first + 2] }, { NoTriangle, NoTriangle, NoTriangle } });
  }
  this->Connect();
}

//----------------------------------------------------------------------------------------------------------------------
void DelaunayMesh::Connect()
{
  // Sides by their lesser and greater point, so that those of two triangles follow each other.
  std::vector<std::tuple<PointId, PointId, TriangleId, int>> sides;
  sides.reserve(3 * this->Triangles.size());
  for (TriangleId triangle = 0; triangle < this->Size(); ++triangle)
  {
    for (int side = 0; side < 3; ++side)
    {
      const auto ends = std::minmax({ this->Corner(triangle, side), this->Corner(triangle, NextCorner(side)) });
      sides.emplace_back(ends.first, ends.second, triangle, side);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t n = 1; n < sides.size(); ++n)
  {
    const auto& [a, b, triangle, side] = sides[n - 1];
    const auto& [c, d, neighbour, otherSide] = sides[n];
    if (a == c && b == d)
    {
      this->Triangles[std::size_t(triangle)].Neighbours[std::size_t(side)] = neighbour;
      this->Triangles[std::size_t(neighbour)].Neighbours[std::size_t(otherSide)] = triangle;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Twice the signed area of a place and a side: positive to the left, where the triangle is.
std::int64_t DelaunayMesh::AreaAt(const PlanePoint& place, TriangleId triangle, int side) const
{
  return SignedArea(
    this->Place(this->Corner(triangle, side)), this->Place(this->Corner(triangle, NextCorner(side))), place);
}

//----------------------------------------------------------------------------------------------------------------------
TriangleId DelaunayMesh::Locate(PointId point, TriangleId near) const
{
  const PlanePoint& place = this->Place(point);
  TriangleId triangle = near;
  // Around the boundary a walk could go in circles.
  for (int steps = 0; steps < MostSteps; ++steps)
  {
    bool isInside = true;
    TriangleId next = NoTriangle;
    for (int side = 0; side < 3 && next == NoTriangle; ++side)
    {
      const bool isBeyond = this->AreaAt(place, triangle, side) < 0;
      isInside = isInside && !isBeyond;
      next = isBeyond ? this->Neighbour(triangle, side) : NoTriangle;
    }
    if (next == NoTriangle)
    {
      return isInside ? triangle : NoTriangle;
    }
    triangle = next;
  }
  return NoTriangle;
}

//----------------------------------------------------------------------------------------------------------------------
const std::vector<TriangleId>& DelaunayMesh::Insert(PointId point, TriangleId triangle)
{
  this->Changed.clear();
  int onSide = -1;
  int sidesOn = 0;
  for (int side = 0; side < 3; ++side)
  {
    if (this->AreaAt(this->Place(point), triangle, side) == 0)
    {
      onSide = side;
      ++sidesOn;
    }
  }
  const bool isOnBoundary = sidesOn == 1 && this->Neighbour(triangle, onSide) == NoTriangle;
  if (sidesOn > 1 || isOnBoundary)
  {
    return this->Changed;
  }
  this->Split(point, triangle);
  if (onSide >= 0)
  {
    // The triangle between the side and the point has no area. Its third corner is the point.
    const TriangleId flat = this->Changed[std::size_t(onSide)];
    this->Changed.push_back(this->Neighbour(flat, Opposite));
    this->Flip(flat, Opposite);
  }
  this->Legalize();
  return this->Changed;
}

//----------------------------------------------------------------------------------------------------------------------
/// Makes three triangles of one: number n has the side n of the old one first, and the point as its third corner.
void DelaunayMesh::Split(PointId point, TriangleId triangle)
{
  const Triangle old = this->Triangles[std::size_t(triangle)];
  const TriangleId size = this->Size();
  const std::array<TriangleId, 3> parts = { triangle, size, size + 1 };
  this->Triangles.resize(this->Triangles.size() + 2);
  for (int side = 0; side < 3; ++side)
  {
    this->Triangles[std::size_t(parts[side])] = { { old.Corners[side], old.Corners[NextCorner(side)], point },
      { old.Neighbours[side], parts[NextCorner(side)], parts[Previous(side)] } };
    this->Replace(old.Neighbours[side], triangle, parts[side]);
    this->Changed.push_back(parts[side]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
int DelaunayMesh::SideTo(TriangleId triangle, TriangleId neighbour) const
{
  const auto& neighbours = this->Triangles[std::size_t(triangle)].Neighbours;
  return neighbours[0] == neighbour ? 0 : neighbours[1] == neighbour ? 1 : 2;
}

//----------------------------------------------------------------------------------------------------------------------
void DelaunayMesh::Replace(TriangleId triangle, TriangleId neighbour, TriangleId by)
{
  if (triangle != NoTriangle)
  {
    this->Triangles[std::size_t(triangle)].Neighbours[std::size_t(this->SideTo(triangle, neighbour))] = by;
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Two triangles a, b, c and b, a, d become d, b, c and a, d, c, so that their common side is from d to c.
void DelaunayMesh::Flip(TriangleId triangle, int side)
{
  const TriangleId other = this->Neighbour(triangle, side);
  const Triangle one = this->Triangles[std::size_t(triangle)];
  const Triangle two = this->Triangles[std::size_t(other)];
  const int back = this->SideTo(other, triangle);
  const PointId a = one.Corners[side];
  const PointId b = one.Corners[NextCorner(side)];
  const PointId c = one.Corners[Previous(side)];
  const PointId d = two.Corners[Previous(back)];
  const TriangleId beyondBc = one.Neighbours[NextCorner(side)];
  const TriangleId beyondCa = one.Neighbours[Previous(side)];
  const TriangleId beyondAd = two.Neighbours[NextCorner(back)];
  const TriangleId beyondDb = two.Neighbours[Previous(back)];
  this->Triangles[std::size_t(triangle)] = { { a, d, c }, { beyondAd, other, beyondCa } };
  this->Triangles[std::size_t(other)] = { { d, b, c }, { beyondDb, beyondBc, triangle } };
  this->Replace(beyondAd, other, triangle);
  this->Replace(beyondBc, triangle, other);
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether the corner beyond a side lies in the circle of the triangle.
bool DelaunayMesh::MustFlip(TriangleId triangle, int side) const
{
  const TriangleId other = this->Neighbour(triangle, side);
  if (other == NoTriangle)
  {
    return false;
  }
  const PointId beyond = this->Corner(other, Previous(this->SideTo(other, triangle)));
  return InCircle(this->Place(this->Corner(triangle, 0)), this->Place(this->Corner(triangle, 1)),
           this->Place(this->Corner(triangle, 2)), this->Place(beyond)) > 0;
}

//----------------------------------------------------------------------------------------------------------------------
/// Flips the sides opposite to the point until all triangles around it are Delaunay. It is the third corner of all of
/// them, and remains so.
void DelaunayMesh::Legalize()
{
  // A flip adds one triangle to those around the point, and changes another one. Both are looked at again.
  for (std::size_t n = 0; n < this->Changed.size(); ++n)
  {
    const TriangleId triangle = this->Changed[n];
    while (this->MustFlip(triangle, Opposite))
    {
      this->Changed.push_back(this->Neighbour(triangle, Opposite));
      this->Flip(triangle, Opposite);
    }
  }
}
}
