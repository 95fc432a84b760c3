// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshChecker.h"

#include "ExactPlane.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace MeshChecker
{
using namespace ExactPlane;
using SeismicHorizons::BoundedHorizon;
using SeismicHorizons::PointId;
using SeismicHorizons::RawVector;

namespace
{
using Edge = std::pair<PointId, PointId>;

std::string Describe(const char* what, PointId a, PointId b)
{
  return std::string(what) + " " + std::to_string(a) + " - " + std::to_string(b);
}

using EdgeTriangles = std::map<Edge, PointId>; // the third point to the left of a directed edge

std::string CollectEdges(
  const BoundedHorizon& horizon, const RawVector<PointId>& triangles, EdgeTriangles& edges, Wide& area)
{
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    const PointId* const t = triangles.data() + corner;
    const Wide size =
      Turn(horizon.Plane[std::size_t(t[0])], horizon.Plane[std::size_t(t[1])], horizon.Plane[std::size_t(t[2])]);
    area += size;
    for (int n = 0; n < 3; ++n)
    {
      if (size <= 0 || !edges.insert({ { t[n], t[(n + 1) % 3] }, t[(n + 2) % 3] }).second)
      {
        return Describe(size <= 0 ? "triangle facing down at" : "two triangles left of", t[n], t[(n + 1) % 3]);
      }
    }
  }
  return {};
}

/// The boundary edges with surface on one side, in the direction that has it to the left, and twice the area they
/// enclose.
std::set<Edge> CollectBoundaryEdges(const BoundedHorizon& horizon, Wide& area)
{
  std::set<Edge> boundaryEdges;
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const PlanePoint& a = horizon.Plane[std::size_t(to)];
      const PlanePoint& b = horizon.Plane[std::size_t(from)];
      area += Cross(a, b);
      if (boundaryEdges.erase({ from, to }) == 0)
      {
        boundaryEdges.insert({ to, from });
      }
    });
  return boundaryEdges;
}

std::string CheckEdges(
  const BoundedHorizon& horizon, const EdgeTriangles& edges, const std::set<Edge>& boundaryEdges, Kind kind)
{
  const auto at = [&](PointId point) { return horizon.Plane[std::size_t(point)]; };
  for (const auto& [edge, third] : edges)
  {
    const auto twin = edges.find({ edge.second, edge.first });
    const bool onBoundary = boundaryEdges.count(edge) != 0;
    if (onBoundary != (twin == edges.end()))
    {
      return Describe("boundary and mesh differ at", edge.first, edge.second);
    }
    if (!onBoundary && kind == Kind::Delaunay &&
      SideOfCircle(at(edge.first), at(edge.second), at(third), at(twin->second)) > 0)
    {
      return Describe("not Delaunay:", edge.first, edge.second);
    }
  }
  for (const Edge& edge : boundaryEdges)
  {
    if (edges.count(edge) == 0)
    {
      return Describe("no triangle at boundary", edge.first, edge.second);
    }
  }
  return {};
}

/// Points - edges + triangles = 1 for each patch, which is one loop and what it encloses, less 1 for each hole.
std::string CheckEuler(const BoundedHorizon& horizon, const EdgeTriangles& edges)
{
  std::map<std::int32_t, std::int64_t> sum;
  for (const std::int32_t patch : horizon.Patch)
  {
    ++sum[patch];
  }
  std::set<Edge> undirected;
  for (const auto& [edge, third] : edges)
  {
    undirected.insert(std::minmax(edge.first, edge.second));
  }
  horizon.Boundary.ForEachEdge([&](PointId from, PointId to) { undirected.insert(std::minmax(from, to)); });
  for (const Edge& edge : undirected)
  {
    --sum[horizon.Patch[std::size_t(edge.first)]];
  }
  // One loop of each patch is not that of a hole.
  for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
  {
    ++sum[horizon.Patch[std::size_t(*horizon.Boundary.begin(loop))]];
  }
  std::map<std::int32_t, std::int64_t> corners;
  for (const auto& [edge, third] : edges)
  {
    ++corners[horizon.Patch[std::size_t(edge.first)]];
  }
  for (const auto& [patch, count] : sum)
  {
    if (count + corners[patch] / 3 != 2)
    {
      return "Euler's formula fails for patch " + std::to_string(patch);
    }
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckMesh(const BoundedHorizon& horizon, const RawVector<PointId>& triangles, Kind kind)
{
  EdgeTriangles edges;
  Wide meshArea = 0;
  Wide boundaryArea = 0;
  std::string wrong = CollectEdges(horizon, triangles, edges, meshArea);
  const std::set<Edge> boundaryEdges = CollectBoundaryEdges(horizon, boundaryArea);
  if (wrong.empty() && meshArea != boundaryArea)
  {
    wrong = "area of the mesh";
  }
  std::vector<bool> used(horizon.Plane.size(), false);
  for (const PointId point : triangles)
  {
    used[std::size_t(point)] = true;
  }
  for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
  {
    std::for_each(horizon.Boundary.begin(loop), horizon.Boundary.end(loop),
      [&used](PointId point) { used[std::size_t(point)] = true; });
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (wrong.empty() && unused != used.end())
  {
    wrong = "unused point " + std::to_string(unused - used.begin());
  }
  wrong = wrong.empty() ? CheckEdges(horizon, edges, boundaryEdges, kind) : wrong;
  return wrong.empty() ? CheckEuler(horizon, edges) : wrong;
}
}
