// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneMesh.h"

#include "Common/Base/HeapArray.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int MostSteps = 100;

// Bands of this number of rows fit the cache.
constexpr std::uint64_t TileSide = 32;

constexpr int Opposite = 0; // to the third corner

std::vector<std::int32_t> NumbersIn(const std::vector<std::int32_t>& order, std::size_t size)
{
  std::vector<std::int32_t> numbers(size, -1);
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    numbers[order[n]] = std::int32_t(n);
  }
  return numbers;
}
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMesh::PlaneMesh(std::vector<PlanePoint> places, const RawVector<VertexId>& triangles)
  : Places(std::move(places))
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
void PlaneMesh::Connect()
{
  // Sorting brings the two triangles of an edge together.
  std::vector<std::tuple<VertexId, VertexId, TriangleId, int>> sides;
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
      this->Triangles[triangle].Neighbours[side] = neighbour;
      this->Triangles[neighbour].Neighbours[otherSide] = triangle;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t PlaneMesh::AreaAt(const PlanePoint& place, TriangleId triangle, int side) const
{
  return SignedArea(
    this->Place(this->Corner(triangle, side)), this->Place(this->Corner(triangle, NextCorner(side))), place);
}

//----------------------------------------------------------------------------------------------------------------------
TriangleId PlaneMesh::Locate(const PlanePoint& place, TriangleId near) const
{
  TriangleId triangle = near;
  // Around the boundary, a walk can run in circles.
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
void PlaneMesh::Insert(const PlanePoint& place, TriangleId triangle, std::vector<TriangleId>& around)
{
  around.clear();
  int onSide = -1;
  int sidesOn = 0;
  for (int side = 0; side < 3; ++side)
  {
    if (this->AreaAt(place, triangle, side) == 0)
    {
      onSide = side;
      ++sidesOn;
    }
  }
  const bool isOnBoundary = sidesOn == 1 && this->Neighbour(triangle, onSide) == NoTriangle;
  if (sidesOn > 1 || isOnBoundary)
  {
    return;
  }
  const auto vertex = VertexId(this->Places.size());
  this->Places.push_back(place);
  if (onSide >= 0)
  {
    this->CutKept(this->Corner(triangle, onSide), this->Corner(triangle, NextCorner(onSide)), vertex);
  }
  this->Split(vertex, triangle, around);
  if (onSide >= 0)
  {
    // The triangle between edge and vertex is flat; the vertex is its third corner.
    const TriangleId flat = around[onSide];
    around.push_back(this->Neighbour(flat, Opposite));
    this->Flip(flat, Opposite);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::CutKept(VertexId a, VertexId b, VertexId between)
{
  if (!this->Kept.empty() && this->Kept.erase(SideKey(a, b)) > 0)
  {
    this->Keep(a, between);
    this->Keep(between, b);
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Triangle n gets the old edge n first, and the vertex as third corner.
void PlaneMesh::Split(VertexId vertex, TriangleId triangle, std::vector<TriangleId>& around)
{
  const Triangle old = this->Triangles[triangle];
  const TriangleId size = this->Size();
  const std::array<TriangleId, 3> parts = { triangle, size, size + 1 };
  this->Triangles.resize(this->Triangles.size() + 2);
  for (int side = 0; side < 3; ++side)
  {
    this->Triangles[parts[side]] = { { old.Corners[side], old.Corners[NextCorner(side)], vertex },
      { old.Neighbours[side], parts[NextCorner(side)], parts[PreviousCorner(side)] } };
    this->Replace(old.Neighbours[side], triangle, parts[side]);
    around.push_back(parts[side]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
int PlaneMesh::SideTo(TriangleId triangle, TriangleId neighbour) const
{
  const auto& neighbours = this->Triangles[triangle].Neighbours;
  return neighbours[0] == neighbour ? 0 : neighbours[1] == neighbour ? 1 : 2;
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Replace(TriangleId triangle, TriangleId neighbour, TriangleId by)
{
  if (triangle != NoTriangle)
  {
    this->Triangles[triangle].Neighbours[this->SideTo(triangle, neighbour)] = by;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Flip(TriangleId triangle, int side)
{
  const TriangleId other = this->Neighbour(triangle, side);
  const Triangle one = this->Triangles[triangle];
  const Triangle two = this->Triangles[other];
  const int back = this->SideTo(other, triangle);
  const VertexId a = one.Corners[side];
  const VertexId b = one.Corners[NextCorner(side)];
  const VertexId c = one.Corners[PreviousCorner(side)];
  const VertexId d = two.Corners[PreviousCorner(back)];
  const TriangleId beyondBc = one.Neighbours[NextCorner(side)];
  const TriangleId beyondCa = one.Neighbours[PreviousCorner(side)];
  const TriangleId beyondAd = two.Neighbours[NextCorner(back)];
  const TriangleId beyondDb = two.Neighbours[PreviousCorner(back)];
  this->Triangles[triangle] = { { a, d, c }, { beyondAd, other, beyondCa } };
  this->Triangles[other] = { { d, b, c }, { beyondDb, beyondBc, triangle } };
  this->Replace(beyondAd, other, triangle);
  this->Replace(beyondBc, triangle, other);
}

//----------------------------------------------------------------------------------------------------------------------
VertexId PlaneMesh::Beyond(TriangleId triangle, int side) const
{
  const TriangleId other = this->Neighbour(triangle, side);
  return this->Corner(other, PreviousCorner(this->SideTo(other, triangle)));
}

//----------------------------------------------------------------------------------------------------------------------
int PlaneMesh::CornerAt(TriangleId triangle, VertexId vertex) const
{
  const auto& corners = this->Triangles[triangle].Corners;
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
}

//----------------------------------------------------------------------------------------------------------------------
bool PlaneMesh::IsDelaunay(TriangleId triangle, int side) const
{
  return this->Neighbour(triangle, side) == NoTriangle ||
    InCircle(this->Place(this->Corner(triangle, 0)), this->Place(this->Corner(triangle, 1)),
      this->Place(this->Corner(triangle, 2)), this->Place(this->Beyond(triangle, side))) <= 0 ||
    this->IsKeptSide(triangle, side);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Legalize(std::vector<TriangleId>& around)
{
  // A flip changes this triangle and adds another, so both are tested again.
  for (std::size_t n = 0; n < around.size(); ++n)
  {
    const TriangleId triangle = around[n];
    while (!this->IsDelaunay(triangle, Opposite))
    {
      around.push_back(this->Neighbour(triangle, Opposite));
      this->Flip(triangle, Opposite);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::FindRing(VertexId vertex, TriangleId first, std::vector<TriangleId>& ring) const
{
  ring.clear();
  TriangleId triangle = first;
  do
  {
    ring.push_back(triangle);
    triangle = this->Neighbour(triangle, PreviousCorner(this->CornerAt(triangle, vertex)));
    if (triangle == NoTriangle)
    {
      ring.clear();
      return;
    }
  } while (triangle != first);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Collapse(VertexId vertex, const std::vector<TriangleId>& ring, std::size_t n)
{
  const std::array<TriangleId, 2> gone = { ring[n], ring[(n + 1) % ring.size()] };
  const TriangleId before = ring[(n + ring.size() - 1) % ring.size()];
  const TriangleId after = ring[(n + 2) % ring.size()];
  const VertexId target = this->Corner(gone[0], PreviousCorner(this->CornerAt(gone[0], vertex)));
  const std::array<TriangleId, 2> outside = { this->Neighbour(gone[0], NextCorner(this->CornerAt(gone[0], vertex))),
    this->Neighbour(gone[1], NextCorner(this->CornerAt(gone[1], vertex))) };
  for (const TriangleId triangle : ring)
  {
    this->Triangles[triangle].Corners[this->CornerAt(triangle, vertex)] = target;
  }
  this->Replace(before, gone[0], outside[0]);
  this->Replace(outside[0], gone[0], before);
  this->Replace(after, gone[1], outside[1]);
  this->Replace(outside[1], gone[1], after);
  for (const TriangleId triangle : gone)
  {
    this->Triangles[triangle] = { { NoVertex, NoVertex, NoVertex }, { NoTriangle, NoTriangle, NoTriangle } };
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Compact()
{
  std::vector<TriangleId> left;
  for (TriangleId triangle = 0; triangle < this->Size(); ++triangle)
  {
    if (!this->IsGone(triangle))
    {
      left.push_back(triangle);
    }
  }
  this->Reorder(left);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::ReorderVertices(const std::vector<VertexId>& order)
{
  const std::vector<VertexId> numbers = NumbersIn(order, this->Places.size());
  this->Places = Gather<std::vector<PlanePoint>>(this->Places, order);
  for (Triangle& triangle : this->Triangles)
  {
    for (VertexId& corner : triangle.Corners)
    {
      corner = numbers[corner];
    }
  }
  std::unordered_set<std::uint64_t> kept;
  for (const std::uint64_t side : this->Kept)
  {
    kept.insert(SideKey(numbers[side >> 32U], numbers[side & 0xFFFFFFFFU]));
  }
  this->Kept.swap(kept);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::SortByPlace()
{
  std::vector<std::pair<std::uint64_t, TriangleId>> order;
  order.reserve(this->Triangles.size());
  for (TriangleId triangle = 0; triangle < this->Size(); ++triangle)
  {
    const PlanePoint& place = this->Place(this->Corner(triangle, 0));
    const auto x = std::uint64_t(std::int64_t(place.X) - std::numeric_limits<std::int32_t>::min());
    const auto y = std::uint64_t(std::int64_t(place.Y) - std::numeric_limits<std::int32_t>::min());
    order.emplace_back((y / TileSide) << 32U | x, triangle);
  }
  std::sort(order.begin(), order.end());
  std::vector<TriangleId> triangles;
  triangles.reserve(order.size());
  std::transform(
    order.begin(), order.end(), std::back_inserter(triangles), [](const auto& entry) { return entry.second; });
  this->Reorder(triangles);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Reorder(const std::vector<TriangleId>& order)
{
  const std::vector<TriangleId> numbers = NumbersIn(order, this->Triangles.size());
  this->Triangles = Gather<std::vector<Triangle>>(this->Triangles, order);
  for (Triangle& triangle : this->Triangles)
  {
    for (TriangleId& neighbour : triangle.Neighbours)
    {
      neighbour = neighbour == NoTriangle ? NoTriangle : numbers[neighbour];
    }
  }
}
}
