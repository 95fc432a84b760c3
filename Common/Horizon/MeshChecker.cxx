// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Three passes check the triangles; their edges, sorted so that twins are found by bisection; and the patches. Geometry
// uses its own 128-bit arithmetic, so that faults in the predicates show.

#include "MeshChecker.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace SeismicHorizons::MeshChecker
{
namespace
{
struct MeshEdge
{
  PointId From;
  PointId To;
  PointId Third;
  std::size_t Triangle;

  std::pair<PointId, PointId> Ends() const { return { this->From, this->To }; }
};

std::string ReportTriangle(const Triangles& triangles, std::size_t triangle)
{
  const PointId* const corner = triangles.data() + 3 * triangle;
  return "triangle " + std::to_string(triangle) + " of points " + std::to_string(corner[0]) + ", " +
    std::to_string(corner[1]) + ", " + std::to_string(corner[2]);
}

class Checker
{
public:
  Checker(const std::vector<PlanePoint>& plane, const Loops& boundary, const Triangles& triangles)
    : Plane(plane)
    , Boundary(boundary)
    , Corners(triangles)
  {
  }

  std::string CheckTriangles(Kind kind)
  {
    if (!this->LookAtTriangles() || !this->LookForDoubleEdges() || !this->CompareAreas() || !this->LookForUnused())
    {
      return this->Wrong;
    }
    this->LookAtEdges(kind);
    return this->Wrong;
  }

  /// Euler's formula for a patch: points - edges + triangles = 1 - holes.
  std::string CheckEuler(const std::vector<std::int32_t>& patches) const
  {
    std::map<std::int32_t, std::int64_t> sums;
    for (const std::int32_t patch : patches)
    {
      ++sums[patch];
    }
    std::set<std::pair<PointId, PointId>> undirected;
    const auto add = [&undirected](PointId from, PointId to) { undirected.insert(std::minmax(from, to)); };
    std::for_each(this->Edges.begin(), this->Edges.end(), [&add](const MeshEdge& edge) { add(edge.From, edge.To); });
    this->Boundary.ForEachEdge(add);
    for (const auto& edge : undirected)
    {
      --sums[patches[edge.first]];
    }
    for (std::size_t corner = 0; corner < this->Corners.size(); corner += 3)
    {
      ++sums[patches[this->Corners[corner]]];
    }
    // One loop of each patch is its outline.
    for (std::size_t loop = 0; loop < this->Boundary.Size(); ++loop)
    {
      ++sums[patches[*this->Boundary.begin(loop)]];
    }
    const auto wrong = std::find_if(sums.begin(), sums.end(), [](const auto& sum) { return sum.second != 2; });
    return wrong == sums.end() ? std::string() : "Euler's formula fails for patch " + std::to_string(wrong->first);
  }

private:
  const PlanePoint& At(PointId point) const { return this->Plane[point]; }

  bool Fail(const std::string& what)
  {
    this->Wrong = what;
    return false;
  }

  bool Fail(const char* what, const MeshEdge& edge)
  {
    return this->Fail(std::string(what) + " " + std::to_string(edge.From) + " - " + std::to_string(edge.To) + ", " +
      ReportTriangle(this->Corners, edge.Triangle));
  }

  bool LookAtTriangles()
  {
    if (this->Corners.size() % 3 != 0)
    {
      return this->Fail(std::to_string(this->Corners.size()) + " corners, expected three of each triangle");
    }
    this->Edges.reserve(this->Corners.size());
    for (std::size_t triangle = 0; triangle < this->Corners.size() / 3; ++triangle)
    {
      const PointId* const corner = this->Corners.data() + 3 * triangle;
      const auto isPoint = [&](PointId point) { return point >= 0 && std::size_t(point) < this->Plane.size(); };
      if (!std::all_of(corner, corner + 3, isPoint))
      {
        return this->Fail("no point of the plane in " + ReportTriangle(this->Corners, triangle));
      }
      for (int n = 0; n < 3; ++n)
      {
        this->Edges.push_back({ corner[n], corner[(n + 1) % 3], corner[(n + 2) % 3], triangle });
      }
      const Int128 area = Turn(this->At(corner[0]), this->At(corner[1]), this->At(corner[2]));
      if (area <= 0)
      {
        return this->Fail("triangle facing down at", this->Edges[3 * triangle]);
      }
      this->MeshArea += area;
    }
    return true;
  }

  bool LookForDoubleEdges()
  {
    std::sort(
      this->Edges.begin(), this->Edges.end(), [](const MeshEdge& a, const MeshEdge& b) { return a.Ends() < b.Ends(); });
    const auto found = std::adjacent_find(this->Edges.begin(), this->Edges.end(),
      [](const MeshEdge& a, const MeshEdge& b) { return a.Ends() == b.Ends(); });
    return found == this->Edges.end() || this->Fail("two triangles left of", *found);
  }

  bool CompareAreas()
  {
    Int128 area = 0;
    this->Boundary.ForEachEdge([&](PointId from, PointId to) { area += Turn({ 0, 0 }, this->At(to), this->At(from)); });
    return area == this->MeshArea || this->Fail("area of the mesh, expected that of the boundary");
  }

  bool LookForUnused()
  {
    std::vector<bool> used(this->Plane.size(), false);
    const auto use = [&used](PointId point) { used[point] = true; };
    std::for_each(this->Corners.begin(), this->Corners.end(), use);
    this->Boundary.ForEachPoint(use);
    const auto unused = std::find(used.begin(), used.end(), false);
    return unused == used.end() || this->Fail("unused point " + std::to_string(unused - used.begin()));
  }

  bool LookAtEdges(Kind kind)
  {
    // The surface is to the right of boundary edges, so that triangles have the reversed edges.
    std::vector<std::pair<PointId, PointId>> reverses;
    this->Boundary.ForEachEdge([&](PointId from, PointId to) { reverses.push_back({ to, from }); });
    std::sort(reverses.begin(), reverses.end());
    const auto isReverse = [&reverses](PointId from, PointId to)
    { return std::binary_search(reverses.begin(), reverses.end(), std::make_pair(from, to)); };
    for (const MeshEdge& edge : this->Edges)
    {
      const MeshEdge* const twin = this->Find(edge.To, edge.From);
      const bool hasSurface = isReverse(edge.From, edge.To);
      const bool isWalkedBack = isReverse(edge.To, edge.From);
      if ((hasSurface && !isWalkedBack) != (twin == nullptr))
      {
        return this->Fail("boundary and mesh differ at", edge);
      }
      if (kind == Kind::Delaunay && twin != nullptr && !hasSurface &&
        SideOfCircle(this->At(edge.From), this->At(edge.To), this->At(edge.Third), this->At(twin->Third)) > 0)
      {
        return this->Fail("not Delaunay:", edge);
      }
    }
    for (const auto& [from, to] : reverses)
    {
      if (!isReverse(to, from) && this->Find(from, to) == nullptr)
      {
        return this->Fail("no triangle at boundary " + std::to_string(from) + " - " + std::to_string(to));
      }
    }
    return true;
  }

  const MeshEdge* Find(PointId from, PointId to) const
  {
    const std::pair<PointId, PointId> ends(from, to);
    const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), ends,
      [](const MeshEdge& edge, const auto& e) { return edge.Ends() < e; });
    return found != this->Edges.end() && found->Ends() == ends ? &*found : nullptr;
  }

  const std::vector<PlanePoint>& Plane;
  const Loops& Boundary;
  const Triangles& Corners;
  std::vector<MeshEdge> Edges; // sorted by their ends after the first pass
  Int128 MeshArea = 0; // Twice the area.
  std::string Wrong;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckTriangles(
  const std::vector<PlanePoint>& plane, const Loops& boundary, const Triangles& triangles, Kind kind)
{
  return Checker(plane, boundary, triangles).CheckTriangles(kind);
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckMesh(const BoundedHorizon& horizon, const Triangles& triangles, Kind kind)
{
  Checker checker(horizon.Plane, horizon.Boundary, triangles);
  const std::string wrong = checker.CheckTriangles(kind);
  return wrong.empty() ? checker.CheckEuler(horizon.Patch) : wrong;
}

//----------------------------------------------------------------------------------------------------------------------
void Require(const char* method, const std::vector<PlanePoint>& plane, const Loops& boundary,
  const Triangles& triangles, Kind kind)
{
  const std::string wrong = CheckTriangles(plane, boundary, triangles, kind);
  if (!wrong.empty())
  {
    throw std::logic_error(std::string(method) + " made a wrong mesh: " + wrong);
  }
}

//----------------------------------------------------------------------------------------------------------------------
Int128 Turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  return Int128(b.X - a.X) * (c.Y - a.Y) - Int128(b.Y - a.Y) * (c.X - a.X);
}

//----------------------------------------------------------------------------------------------------------------------
// Expands the 4 x 4 determinant by cofactors.
int SideOfCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const auto lift = [&d](const PlanePoint& p)
  { return Int128(p.X - d.X) * (p.X - d.X) + Int128(p.Y - d.Y) * (p.Y - d.Y); };
  const Int128 side = lift(a) * Turn(d, b, c) - lift(b) * Turn(d, a, c) + lift(c) * Turn(d, a, b);
  return int(side > 0) - int(side < 0);
}
}
