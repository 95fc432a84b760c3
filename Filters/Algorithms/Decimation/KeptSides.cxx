// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "KeptSides.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
KeptSides::KeptSides(PlaneMesh& mesh, std::size_t vertices)
  : Mesh(mesh)
  , TriangleAt(vertices, NoTriangle)
{
  for (TriangleId triangle = 0; triangle < mesh.Size(); ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->TriangleAt[std::size_t(mesh.Corner(triangle, corner))] = triangle;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool KeptSides::Keep(VertexId from, VertexId to)
{
  while (from != to)
  {
    Side crossed;
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
// Calls visit(triangle, corner) around a vertex until it returns true: counter-clockwise, then clockwise from the
// first.
template <typename Visitor>
bool KeptSides::AnyAround(VertexId vertex, Visitor&& visit) const
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
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// AnyAround misses triangles where the boundary touches itself. This is rare.
template <typename Visitor>
bool KeptSides::AnyBeside(VertexId vertex, Visitor&& visit) const
{
  for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
  {
    const int corner = this->Mesh.CornerAt(triangle, vertex);
    if (this->Mesh.Corner(triangle, corner) == vertex && visit(triangle, corner))
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// A line leaves its first vertex along an edge to `next`, or across the edge `crossed`.
bool KeptSides::FindStart(VertexId from, VertexId to, Side& crossed, VertexId& next) const
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
  return this->AnyAround(from, isStart) || this->AnyBeside(from, isStart);
}

//----------------------------------------------------------------------------------------------------------------------
// Returns false if an edge across the line must stay.
bool KeptSides::FindCrossed(VertexId from, VertexId to, Side side, VertexId& end)
{
  const PlanePoint& a = this->Mesh.Place(from);
  const PlanePoint& b = this->Mesh.Place(to);
  this->Crossed.clear();
  while (true)
  {
    const TriangleId beyond = this->Mesh.Neighbour(side.Triangle, side.Number);
    if (beyond == NoTriangle || this->Mesh.IsKeptSide(side.Triangle, side.Number))
    {
      return false;
    }
    this->Crossed.push_back(
      { this->Mesh.Corner(side.Triangle, side.Number), this->Mesh.Corner(side.Triangle, NextCorner(side.Number)) });
    const int back = this->Mesh.SideTo(beyond, side.Triangle);
    const VertexId apex = this->Mesh.Corner(beyond, PreviousCorner(back));
    const std::int64_t turn = SignedArea(a, b, this->Mesh.Place(apex));
    if (turn == 0)
    {
      end = apex;
      return true;
    }
    // The next edge joins the apex to the corner across the line.
    side = { beyond, turn > 0 ? NextCorner(back) : PreviousCorner(back) };
  }
}

//----------------------------------------------------------------------------------------------------------------------
void KeptSides::FlipCrossed(VertexId from, VertexId end)
{
  const PlanePoint& a = this->Mesh.Place(from);
  const PlanePoint& b = this->Mesh.Place(end);
  while (!this->Crossed.empty())
  {
    const Line line = this->Crossed.front();
    this->Crossed.pop_front();
    const Side side = this->FindSide(line.From, line.To);
    if (!this->IsConvex(side))
    {
      this->Crossed.push_back(line);
      continue;
    }
    const VertexId one = this->Mesh.Corner(side.Triangle, PreviousCorner(side.Number));
    const VertexId other = this->Mesh.Beyond(side.Triangle, side.Number);
    this->Flip(side);
    if (ProperlyCross(a, b, this->Mesh.Place(one), this->Mesh.Place(other)))
    {
      this->Crossed.push_back({ one, other });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The triangle lies left of the edge.
KeptSides::Side KeptSides::FindSide(VertexId a, VertexId b) const
{
  Side side;
  const auto isIt = [&](TriangleId triangle, int corner)
  {
    side = { triangle, corner };
    return this->Mesh.Corner(triangle, corner) == a && this->Mesh.Corner(triangle, NextCorner(corner)) == b;
  };
  if (this->AnyAround(a, isIt))
  {
    return side;
  }
  this->AnyBeside(a, isIt);
  return side;
}

//----------------------------------------------------------------------------------------------------------------------
// The other diagonal must lie strictly inside.
bool KeptSides::IsConvex(const Side& side) const
{
  return ProperlyCross(this->Mesh.Place(this->Mesh.Corner(side.Triangle, side.Number)),
    this->Mesh.Place(this->Mesh.Corner(side.Triangle, NextCorner(side.Number))),
    this->Mesh.Place(this->Mesh.Corner(side.Triangle, PreviousCorner(side.Number))),
    this->Mesh.Place(this->Mesh.Beyond(side.Triangle, side.Number)));
}

//----------------------------------------------------------------------------------------------------------------------
void KeptSides::Flip(const Side& side)
{
  const TriangleId other = this->Mesh.Neighbour(side.Triangle, side.Number);
  this->Mesh.Flip(side.Triangle, side.Number);
  for (const TriangleId triangle : { side.Triangle, other })
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->TriangleAt[std::size_t(this->Mesh.Corner(triangle, corner))] = triangle;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void KeptSides::Legalize()
{
  bool isAnyFlipped = true;
  while (isAnyFlipped)
  {
    isAnyFlipped = false;
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int side = 0; side < 3; ++side)
      {
        if (!this->Mesh.IsDelaunay(triangle, side))
        {
          this->Flip({ triangle, side });
          isAnyFlipped = true;
        }
      }
    }
  }
}
}
