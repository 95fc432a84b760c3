// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneMesh.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/HeapArray.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int MostSteps = 100;

// Bands of this number of rows fit the cache.
constexpr std::uint64_t TileSide = 32;

constexpr int Opposite = 0; // to the third corner

constexpr std::int64_t ChangesPerChunk = 1024;

template <typename Call>
void ForEachBelow(std::size_t size, Call&& call)
{
  ParallelFor(std::int64_t(size), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        call(n);
      }
    });
}

std::vector<std::int32_t> NumbersIn(const std::vector<std::int32_t>& order, std::size_t size)
{
  std::vector<std::int32_t> numbers(size, -1);
  ForEachBelow(order.size(), [&](std::int64_t n) { numbers[order[n]] = std::int32_t(n); });
  return numbers;
}
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMesh::PlaneMesh(std::vector<PlanePoint> places, const RawVector<VertexId>& triangles)
{
  this->Replace(std::move(places), triangles);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Replace(std::vector<PlanePoint> places, const RawVector<VertexId>& triangles)
{
  assert(triangles.size() % 3 == 0);
  this->Places = std::move(places);
  this->Triangles.clear();
  this->Triangles.reserve(triangles.size() / 3);
  for (std::size_t first = 0; first < triangles.size(); first += 3)
  {
    this->Triangles.push_back(
      { { triangles[first], triangles[first + 1], triangles[first + 2] }, { NoTriangle, NoTriangle, NoTriangle } });
  }
  this->Connect();
}

//----------------------------------------------------------------------------------------------------------------------
VertexId PlaneMesh::HigherEnd(TriangleId triangle, int edge) const
{
  return std::max(this->Corner(triangle, edge), this->Corner(triangle, NextCorner(edge)));
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Connect()
{
  // The last triangle at each edge, listed at the lower end of the edge. Edges of meshes that cover a place twice may have
  // more than two, which are refused once all points are in triangles.
  constexpr std::int32_t None = -1;
  std::vector<std::int32_t> first(this->Places.size(), None);
  std::vector<std::int32_t> next(3 * this->Triangles.size(), None);
  for (TriangleId triangle = 0; triangle < this->Size(); ++triangle)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const auto [low, high] = std::minmax({ this->Corner(triangle, edge), this->Corner(triangle, NextCorner(edge)) });
      std::int32_t* last = &first[std::size_t(low)];
      while (*last != None && this->HigherEnd(*last / 3, *last % 3) != high)
      {
        last = &next[std::size_t(*last)];
      }
      const std::int32_t other = *last;
      *last = 3 * triangle + edge;
      if (other != None)
      {
        this->Triangles[triangle].Neighbours[edge] = other / 3;
        this->Triangles[other / 3].Neighbours[other % 3] = triangle;
        next[std::size_t(*last)] = next[std::size_t(other)];
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
VertexId PlaneMesh::Add(const PlanePoint& place)
{
  this->Places.push_back(place);
  return VertexId(this->Places.size() - 1);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TriangleId> PlaneMesh::Exchange(const std::vector<TriangleId>& gone, const RawVector<VertexId>& added)
{
  std::vector<OpenEdge> open = this->OpenAround(gone);
  std::vector<TriangleId> numbers(gone.begin(), gone.begin() + std::min(gone.size(), added.size() / 3));
  while (3 * numbers.size() < added.size())
  {
    numbers.push_back(this->Size());
    this->Triangles.emplace_back();
  }
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    this->Triangles[numbers[n]] = { { added[3 * n], added[3 * n + 1], added[3 * n + 2] },
      { NoTriangle, NoTriangle, NoTriangle } };
    for (int edge = 0; edge < 3; ++edge)
    {
      open.push_back(this->OpenEdgeOf(numbers[n], edge));
    }
  }
  std::sort(open.begin(), open.end(), [](const OpenEdge& a, const OpenEdge& b) { return a.Key < b.Key; });
  for (std::size_t n = 1; n < open.size(); ++n)
  {
    if (open[n].Key == open[n - 1].Key)
    {
      this->Triangles[open[n].Triangle].Neighbours[open[n].Number] = open[n - 1].Triangle;
      this->Triangles[open[n - 1].Triangle].Neighbours[open[n - 1].Number] = open[n].Triangle;
    }
  }
  for (std::size_t n = gone.size(); n > numbers.size(); --n)
  {
    this->MoveLastTo(gone[n - 1]);
  }
  return numbers;
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMesh::OpenEdge PlaneMesh::OpenEdgeOf(TriangleId triangle, int edge) const
{
  return { EdgeKey(this->Corner(triangle, edge), this->Corner(triangle, NextCorner(edge))), triangle, edge };
}

//----------------------------------------------------------------------------------------------------------------------
// Detaches the other triangles, and finds their edges there and on the boundary.
std::vector<PlaneMesh::OpenEdge> PlaneMesh::OpenAround(const std::vector<TriangleId>& gone)
{
  std::vector<OpenEdge> open;
  const auto isGone = [&gone](TriangleId triangle) { return std::binary_search(gone.begin(), gone.end(), triangle); };
  for (TriangleId triangle = 0; triangle < this->Size(); ++triangle)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      if (this->Neighbour(triangle, edge) == NoTriangle && !isGone(triangle))
      {
        open.push_back(this->OpenEdgeOf(triangle, edge));
      }
    }
  }
  for (const TriangleId triangle : gone)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const TriangleId beyond = this->Neighbour(triangle, edge);
      if (beyond != NoTriangle && !isGone(beyond))
      {
        const int back = this->EdgeTo(beyond, triangle);
        open.push_back(this->OpenEdgeOf(beyond, back));
        this->Triangles[beyond].Neighbours[back] = NoTriangle;
      }
    }
  }
  return open;
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::MoveLastTo(TriangleId triangle)
{
  const TriangleId last = this->Size() - 1;
  if (triangle != last)
  {
    this->Triangles[triangle] = this->Triangles[last];
    for (const TriangleId beyond : this->Triangles[triangle].Neighbours)
    {
      this->Replace(beyond, last, triangle);
    }
  }
  this->Triangles.pop_back();
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t PlaneMesh::AreaAt(const PlanePoint& place, TriangleId triangle, int edge) const
{
  return SignedArea(
    this->Place(this->Corner(triangle, edge)), this->Place(this->Corner(triangle, NextCorner(edge))), place);
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
    for (int edge = 0; edge < 3 && next == NoTriangle; ++edge)
    {
      const bool isBeyond = this->AreaAt(place, triangle, edge) < 0;
      isInside = isInside && !isBeyond;
      next = isBeyond ? this->Neighbour(triangle, edge) : NoTriangle;
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
PlaneMesh::Room PlaneMesh::AddRoom(std::size_t vertices)
{
  const Room first{ VertexId(this->Places.size()), this->Size() };
  this->Places.resize(this->Places.size() + vertices);
  this->Triangles.resize(this->Triangles.size() + 2 * vertices,
    { { NoVertex, NoVertex, NoVertex }, { NoTriangle, NoTriangle, NoTriangle } });
  return first;
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Insert(const PlanePoint& place, TriangleId triangle, const Room& room, std::vector<TriangleId>& around)
{
  assert(!this->IsGone(triangle));
  around.clear();
  int onEdge = -1;
  int edgesOn = 0;
  for (int edge = 0; edge < 3; ++edge)
  {
    if (this->AreaAt(place, triangle, edge) == 0)
    {
      onEdge = edge;
      ++edgesOn;
    }
  }
  const bool isOnBoundary = edgesOn == 1 && this->Neighbour(triangle, onEdge) == NoTriangle;
  if (edgesOn > 1 || isOnBoundary)
  {
    return;
  }
  this->Places[room.Vertex] = place;
  if (onEdge >= 0)
  {
    this->CutKept(this->Corner(triangle, onEdge), this->Corner(triangle, NextCorner(onEdge)), room.Vertex);
  }
  this->Split(room, triangle, around);
  if (onEdge >= 0)
  {
    // The triangle between edge and vertex is flat; the vertex is its third corner.
    const TriangleId flat = around[onEdge];
    around.push_back(this->Neighbour(flat, Opposite));
    this->Flip(flat, Opposite);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::CutKept(VertexId a, VertexId b, VertexId between)
{
  if (!this->Kept.empty() && this->Kept.erase(EdgeKey(a, b)) > 0)
  {
    this->Keep(a, between);
    this->Keep(between, b);
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Triangle n gets the old edge n first, and the vertex as third corner.
void PlaneMesh::Split(const Room& room, TriangleId triangle, std::vector<TriangleId>& around)
{
  const Triangle old = this->Triangles[triangle];
  const std::array<TriangleId, 3> parts = { triangle, room.First, room.First + 1 };
  for (int edge = 0; edge < 3; ++edge)
  {
    this->Triangles[parts[edge]] = { { old.Corners[edge], old.Corners[NextCorner(edge)], room.Vertex },
      { old.Neighbours[edge], parts[NextCorner(edge)], parts[PreviousCorner(edge)] } };
    this->Replace(old.Neighbours[edge], triangle, parts[edge]);
    around.push_back(parts[edge]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::CloseGaps(
  const Room& first, std::vector<TriangleId>& changed, const std::vector<unsigned char>& isChanged)
{
  std::vector<VertexId> vertices; // new numbers
  VertexId next = first.Vertex;
  for (TriangleId triangle = first.First; triangle < this->Size(); triangle += 2)
  {
    vertices.push_back(next);
    next += this->IsGone(triangle) ? 0 : 1;
  }
  if (std::size_t(next) == this->Places.size())
  {
    return;
  }
  const auto renumbered = [&](TriangleId triangle)
  {
    const TriangleId place = triangle - first.First;
    return place < 0 ? triangle : first.First + 2 * (vertices[place / 2] - first.Vertex) + place % 2;
  };
  this->RenumberBeside(changed, isChanged, renumbered);
  ForEachBelow(changed.size(),
    [&](std::int64_t n)
    {
      Triangle& triangle = this->Triangles[changed[n]];
      for (VertexId& corner : triangle.Corners)
      {
        corner = corner < first.Vertex ? corner : vertices[corner - first.Vertex];
      }
      for (TriangleId& neighbour : triangle.Neighbours)
      {
        neighbour = renumbered(neighbour);
      }
    });
  for (std::size_t n = 0; n < vertices.size(); ++n)
  {
    const Room from = first.At(n);
    const Room to = first.At(std::size_t(vertices[n] - first.Vertex));
    if (!this->IsGone(from.First))
    {
      this->Places[to.Vertex] = this->Places[from.Vertex];
      this->Triangles[to.First] = this->Triangles[from.First];
      this->Triangles[to.First + 1] = this->Triangles[from.First + 1];
    }
  }
  this->Places.resize(std::size_t(next));
  this->Triangles.resize(std::size_t(first.At(std::size_t(next - first.Vertex)).First));
  std::transform(changed.begin(), changed.end(), changed.begin(), renumbered);
}

//----------------------------------------------------------------------------------------------------------------------
// Neighbours that have not changed get the new numbers.
template <typename Renumber>
void PlaneMesh::RenumberBeside(
  const std::vector<TriangleId>& changed, const std::vector<unsigned char>& isChanged, const Renumber& renumbered)
{
  struct Neighbour
  {
    TriangleId Triangle;
    int Edge;
    TriangleId Number;
  };
  const auto beside = CollectChunks<Neighbour>(std::int64_t(changed.size()), ChangesPerChunk, Monitor(),
    [&](std::vector<Neighbour>& found, std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        for (const TriangleId other : this->Triangles[changed[n]].Neighbours)
        {
          if (other != NoTriangle && isChanged[other] == 0)
          {
            found.push_back({ other, this->EdgeTo(other, changed[n]), renumbered(changed[n]) });
          }
        }
      }
    });
  ForEachBelow(beside.size(),
    [&](std::int64_t n) { this->Triangles[beside[n].Triangle].Neighbours[beside[n].Edge] = beside[n].Number; });
}

//----------------------------------------------------------------------------------------------------------------------
int PlaneMesh::EdgeTo(TriangleId triangle, TriangleId neighbour) const
{
  // Loops that enclose a surface twice give meshes without this neighbour, which are refused once all points are in
  // triangles.
  const auto& neighbours = this->Triangles[triangle].Neighbours;
  return neighbours[0] == neighbour ? 0 : neighbours[1] == neighbour ? 1 : 2;
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Replace(TriangleId triangle, TriangleId neighbour, TriangleId by)
{
  if (triangle != NoTriangle)
  {
    this->Triangles[triangle].Neighbours[this->EdgeTo(triangle, neighbour)] = by;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Flip(TriangleId triangle, int edge)
{
  const TriangleId other = this->Neighbour(triangle, edge);
  assert(other != NoTriangle && !this->IsKeptEdge(triangle, edge));
  const Triangle one = this->Triangles[triangle];
  const Triangle two = this->Triangles[other];
  const int back = this->EdgeTo(other, triangle);
  const VertexId a = one.Corners[edge];
  const VertexId b = one.Corners[NextCorner(edge)];
  const VertexId c = one.Corners[PreviousCorner(edge)];
  const VertexId d = two.Corners[PreviousCorner(back)];
  const TriangleId beyondBc = one.Neighbours[NextCorner(edge)];
  const TriangleId beyondCa = one.Neighbours[PreviousCorner(edge)];
  const TriangleId beyondAd = two.Neighbours[NextCorner(back)];
  const TriangleId beyondDb = two.Neighbours[PreviousCorner(back)];
  this->Triangles[triangle] = { { a, d, c }, { beyondAd, other, beyondCa } };
  this->Triangles[other] = { { d, b, c }, { beyondDb, beyondBc, triangle } };
  this->Replace(beyondAd, other, triangle);
  this->Replace(beyondBc, triangle, other);
}

//----------------------------------------------------------------------------------------------------------------------
VertexId PlaneMesh::Beyond(TriangleId triangle, int edge) const
{
  const TriangleId other = this->Neighbour(triangle, edge);
  assert(other != NoTriangle);
  return this->Corner(other, PreviousCorner(this->EdgeTo(other, triangle)));
}

//----------------------------------------------------------------------------------------------------------------------
double PlaneMesh::SineOf(TriangleId triangle) const
{
  const auto& [a, b, c] = this->Corners(triangle);
  return SineOfSmallestAngle(this->Place(a), this->Place(b), this->Place(c));
}

//----------------------------------------------------------------------------------------------------------------------
int PlaneMesh::CornerAt(TriangleId triangle, VertexId vertex) const
{
  const auto& corners = this->Triangles[triangle].Corners;
  assert(corners[0] == vertex || corners[1] == vertex || corners[2] == vertex);
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
}

//----------------------------------------------------------------------------------------------------------------------
bool PlaneMesh::IsDelaunay(TriangleId triangle, int edge) const
{
  return this->Neighbour(triangle, edge) == NoTriangle ||
    InCircle(this->Place(this->Corner(triangle, 0)), this->Place(this->Corner(triangle, 1)),
      this->Place(this->Corner(triangle, 2)), this->Place(this->Beyond(triangle, edge))) <= 0 ||
    this->IsKeptEdge(triangle, edge);
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
void PlaneMesh::MakeDelaunay(std::vector<TriangleId>& triangles)
{
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      if (!this->IsDelaunay(triangles[n], edge))
      {
        const TriangleId other = this->Neighbour(triangles[n], edge);
        this->Flip(triangles[n], edge);
        triangles.insert(triangles.end(), { triangles[n], other });
        break;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::MakeDelaunay()
{
  std::vector<TriangleId> all(this->Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  this->MakeDelaunay(all);
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
  assert(ring.size() >= 3 && n < ring.size());
  const std::array<TriangleId, 2> gone = { ring[n], ring[(n + 1) % ring.size()] };
  const TriangleId before = ring[(n + ring.size() - 1) % ring.size()];
  const TriangleId after = ring[(n + 2) % ring.size()];
  const VertexId target = this->Corner(gone[0], PreviousCorner(this->CornerAt(gone[0], vertex)));
  assert(!this->IsKept(vertex, target));
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
  ForEachBelow(this->Triangles.size(),
    [&](std::int64_t triangle)
    {
      for (VertexId& corner : this->Triangles[triangle].Corners)
      {
        corner = numbers[corner];
      }
    });
  std::unordered_set<std::uint64_t> kept;
  for (const std::uint64_t edge : this->Kept)
  {
    kept.insert(EdgeKey(numbers[edge >> 32U], numbers[edge & 0xFFFFFFFFU]));
  }
  this->Kept.swap(kept);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::SortByPlace()
{
  std::vector<std::pair<std::uint64_t, TriangleId>> order(this->Triangles.size());
  ForEachBelow(order.size(),
    [&](std::int64_t triangle)
    {
      const PlanePoint& place = this->Place(this->Corner(TriangleId(triangle), 0));
      const auto x = std::uint64_t(std::int64_t(place.X) - std::numeric_limits<std::int32_t>::min());
      const auto y = std::uint64_t(std::int64_t(place.Y) - std::numeric_limits<std::int32_t>::min());
      order[triangle] = { (y / TileSide) << 32U | x, TriangleId(triangle) };
    });
  ParallelSort(order, std::less<>());
  std::vector<TriangleId> triangles(order.size());
  ForEachBelow(order.size(), [&](std::int64_t n) { triangles[n] = order[n].second; });
  this->Reorder(triangles);
}

//----------------------------------------------------------------------------------------------------------------------
void PlaneMesh::Reorder(const std::vector<TriangleId>& order)
{
  const std::vector<TriangleId> numbers = NumbersIn(order, this->Triangles.size());
  std::vector<Triangle> triangles(order.size());
  ForEachBelow(order.size(),
    [&](std::int64_t n)
    {
      triangles[n] = this->Triangles[order[n]];
      for (TriangleId& neighbour : triangles[n].Neighbours)
      {
        neighbour = neighbour == NoTriangle ? NoTriangle : numbers[neighbour];
      }
    });
  this->Triangles.swap(triangles);
}

// ---- KeptEdges ------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
KeptEdges::KeptEdges(PlaneMesh& mesh, std::size_t vertices)
  : Mesh(mesh)
  , TriangleAt(vertices, NoTriangle)
{
  for (TriangleId triangle = 0; triangle < mesh.Size(); ++triangle)
  {
    for (const VertexId corner : mesh.Corners(triangle))
    {
      this->TriangleAt[std::size_t(corner)] = triangle;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool KeptEdges::Keep(VertexId from, VertexId to)
{
  while (from != to)
  {
    Edge crossed;
    VertexId next = NoVertex;
    if (this->TriangleAt[std::size_t(from)] == NoTriangle || !this->FindStart(from, to, crossed, next))
    {
      return false;
    }
    if (next == NoVertex)
    {
      if (!this->FindCrossed(from, to, crossed, next))
      {
        return false;
      }
      this->FlipCrossed(from, next);
    }
    this->Mesh.Keep(from, next);
    from = next;
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
// Calls visit(triangle, corner) around a vertex until it returns true: counter-clockwise, then clockwise from the first.
// Triangles where the boundary touches itself, which are rare, are searched for last.
template <typename Visitor>
bool KeptEdges::AnyAround(VertexId vertex, Visitor&& visit) const
{
  const TriangleId first = this->TriangleAt[std::size_t(vertex)];
  TriangleId triangle = first;
  do
  {
    const int corner = this->Mesh.CornerAt(triangle, vertex);
    if (visit(triangle, corner))
    {
      return true;
    }
    triangle = this->Mesh.Neighbour(triangle, PreviousCorner(corner));
  } while (triangle != NoTriangle && triangle != first);
  if (triangle == NoTriangle)
  {
    triangle = this->Mesh.Neighbour(first, this->Mesh.CornerAt(first, vertex));
    while (triangle != NoTriangle)
    {
      const int corner = this->Mesh.CornerAt(triangle, vertex);
      if (visit(triangle, corner))
      {
        return true;
      }
      triangle = this->Mesh.Neighbour(triangle, corner);
    }
  }
  for (triangle = 0; triangle < this->Mesh.Size(); ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (this->Mesh.Corner(triangle, corner) == vertex && visit(triangle, corner))
      {
        return true;
      }
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// A line leaves its first vertex along an edge to `next`, or across the edge `crossed`.
bool KeptEdges::FindStart(VertexId from, VertexId to, Edge& crossed, VertexId& next) const
{
  const PlanePoint& a = this->Mesh.Place(from);
  const PlanePoint& b = this->Mesh.Place(to);
  const auto isStart = [&](TriangleId triangle, int corner)
  {
    const VertexId right = this->Mesh.Corner(triangle, NextCorner(corner));
    const VertexId left = this->Mesh.Corner(triangle, PreviousCorner(corner));
    for (const VertexId end : { right, left })
    {
      if (SignedArea(a, b, this->Mesh.Place(end)) == 0 && ScalarProduct(a, b, this->Mesh.Place(end)) > 0)
      {
        next = end;
        return true;
      }
    }
    crossed = { triangle, NextCorner(corner) };
    return SignedArea(a, b, this->Mesh.Place(right)) < 0 && SignedArea(a, b, this->Mesh.Place(left)) > 0;
  };
  return this->AnyAround(from, isStart);
}

//----------------------------------------------------------------------------------------------------------------------
// Returns false if an edge across the line must stay.
bool KeptEdges::FindCrossed(VertexId from, VertexId to, Edge edge, VertexId& end)
{
  const PlanePoint& a = this->Mesh.Place(from);
  const PlanePoint& b = this->Mesh.Place(to);
  this->Crossed.clear();
  while (true)
  {
    const TriangleId beyond = this->Mesh.Neighbour(edge.Triangle, edge.Number);
    if (beyond == NoTriangle || this->Mesh.IsKeptEdge(edge.Triangle, edge.Number))
    {
      return false;
    }
    this->Crossed.push_back(
      { this->Mesh.Corner(edge.Triangle, edge.Number), this->Mesh.Corner(edge.Triangle, NextCorner(edge.Number)) });
    const int back = this->Mesh.EdgeTo(beyond, edge.Triangle);
    const VertexId apex = this->Mesh.Corner(beyond, PreviousCorner(back));
    const std::int64_t turn = SignedArea(a, b, this->Mesh.Place(apex));
    if (turn == 0)
    {
      end = apex;
      return true;
    }
    // The next edge joins the apex to the corner across the line.
    edge = { beyond, turn > 0 ? NextCorner(back) : PreviousCorner(back) };
  }
}

//----------------------------------------------------------------------------------------------------------------------
void KeptEdges::FlipCrossed(VertexId from, VertexId end)
{
  const PlanePoint& a = this->Mesh.Place(from);
  const PlanePoint& b = this->Mesh.Place(end);
  while (!this->Crossed.empty())
  {
    const std::array<VertexId, 2> line = this->Crossed.front();
    this->Crossed.pop_front();
    const Edge edge = this->FindEdge(line[0], line[1]);
    if (!this->IsConvex(edge))
    {
      this->Crossed.push_back(line);
      continue;
    }
    const VertexId one = this->Mesh.Corner(edge.Triangle, PreviousCorner(edge.Number));
    const VertexId other = this->Mesh.Beyond(edge.Triangle, edge.Number);
    this->Flip(edge);
    if (ProperlyCross(a, b, this->Mesh.Place(one), this->Mesh.Place(other)))
    {
      this->Crossed.push_back({ one, other });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The triangle lies left of the edge.
KeptEdges::Edge KeptEdges::FindEdge(VertexId a, VertexId b) const
{
  Edge edge;
  const auto isIt = [&](TriangleId triangle, int corner)
  {
    edge = { triangle, corner };
    return this->Mesh.Corner(triangle, corner) == a && this->Mesh.Corner(triangle, NextCorner(corner)) == b;
  };
  this->AnyAround(a, isIt);
  return edge;
}

//----------------------------------------------------------------------------------------------------------------------
// The other diagonal must lie strictly inside.
bool KeptEdges::IsConvex(const Edge& edge) const
{
  return ProperlyCross(this->Mesh.Place(this->Mesh.Corner(edge.Triangle, edge.Number)),
    this->Mesh.Place(this->Mesh.Corner(edge.Triangle, NextCorner(edge.Number))),
    this->Mesh.Place(this->Mesh.Corner(edge.Triangle, PreviousCorner(edge.Number))),
    this->Mesh.Place(this->Mesh.Beyond(edge.Triangle, edge.Number)));
}

//----------------------------------------------------------------------------------------------------------------------
void KeptEdges::Flip(const Edge& edge)
{
  const TriangleId other = this->Mesh.Neighbour(edge.Triangle, edge.Number);
  this->Mesh.Flip(edge.Triangle, edge.Number);
  for (const TriangleId triangle : { edge.Triangle, other })
  {
    for (const VertexId corner : this->Mesh.Corners(triangle))
    {
      this->TriangleAt[std::size_t(corner)] = triangle;
    }
  }
}
}
