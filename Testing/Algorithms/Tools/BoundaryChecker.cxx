// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryChecker.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "ExactPlane.h"

#include <algorithm>
#include <limits>
#include <map>

namespace BoundaryChecker
{
using namespace ExactPlane;
using SeismicHorizons::BoundaryOptions;
using SeismicHorizons::BoundedHorizon;
using SeismicHorizons::Edge;
using SeismicHorizons::ExteriorBoundary;
using SeismicHorizons::PointId;

namespace
{
std::string Describe(const char* what, PointId a, PointId b)
{
  return std::string(what) + " " + std::to_string(a) + " - " + std::to_string(b);
}

/// The loops of a boundary one by one, and what they are.
class BoundaryParts
{
public:
  BoundaryParts(const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary)
    : Columns(columns)
    , Boundary(boundary)
  {
    for (std::size_t loop = 0; loop < boundary.Boundary.Size(); ++loop)
    {
      this->Single.emplace_back().AppendLoop(boundary.Boundary, loop);
    }
  }

  std::size_t Size() const { return this->Single.size(); }
  bool IsHole(std::size_t loop) const { return loop >= this->Boundary.NumberOfPatches; }
  std::int32_t PatchOf(std::size_t loop) const
  {
    return this->Boundary.Patch[std::size_t(*this->Boundary.Boundary.begin(loop))];
  }
  int Locate(std::size_t loop, const PlanePoint& place) const
  {
    // A loop of one point has no edges.
    const bool isPoint =
      this->Single[loop].TotalLength() == 1 && this->Columns[std::size_t(*this->Single[loop].begin(0))] == place;
    return isPoint ? 0 : ExactPlane::Locate(this->Columns, this->Single[loop], place);
  }

  Wide TwiceArea(std::size_t loop) const
  {
    Wide area = 0;
    this->Single[loop].ForEachEdge([&](PointId from, PointId to)
      { area += Cross(this->Columns[std::size_t(from)], this->Columns[std::size_t(to)]); });
    return area;
  }

  /// Columns strictly inside a loop.
  std::int64_t CountInside(std::size_t loop) const
  {
    const SeismicHorizons::PlaneBox box(this->Columns);
    std::int64_t inside = 0;
    for (std::int32_t i = box.Least.X; i <= box.Greatest.X; ++i)
    {
      for (std::int32_t j = box.Least.Y; j <= box.Greatest.Y; ++j)
      {
        inside += this->Locate(loop, { i, j }) > 0 ? 1 : 0;
      }
    }
    return inside;
  }

private:
  const std::vector<PlanePoint>& Columns;
  const ExteriorBoundary& Boundary;
  std::vector<Loops> Single;
};

/// Edges are at most so many columns long along each axis, cross none, and pass over no point.
std::string CheckEdges(const std::vector<PlanePoint>& columns, const Loops& boundary, int longest)
{
  std::vector<Edge> edges;
  boundary.ForEachEdge([&](PointId from, PointId to) { edges.push_back({ from, to }); });
  for (std::size_t n = 0; n < edges.size(); ++n)
  {
    const PlanePoint& a = columns[std::size_t(edges[n].From)];
    const PlanePoint& b = columns[std::size_t(edges[n].To)];
    if (a == b || Apart(a, b) > longest)
    {
      return Describe("length of edge", edges[n].From, edges[n].To);
    }
    for (std::size_t m = 0; m < n; ++m)
    {
      const PlanePoint& c = columns[std::size_t(edges[m].From)];
      if (Apart(a, c) / 2 <= longest && DoCross(a, b, c, columns[std::size_t(edges[m].To)]))
      {
        return Describe("crossing of the edges from", edges[n].From, edges[m].From);
      }
    }
    for (std::size_t point = 0; Apart(a, b) > 1 && point < columns.size(); ++point)
    {
      if (columns[point] != a && columns[point] != b && IsOnSegment(a, b, columns[point]))
      {
        return Describe("point on edge from", PointId(point), edges[n].From);
      }
    }
  }
  return {};
}

/// Points within the radius have one number.
std::string CheckConnection(const std::vector<PlanePoint>& columns, const std::vector<std::int32_t>& patch, int radius)
{
  for (std::size_t a = 0; a < columns.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      if (patch[a] != patch[b] && Apart(columns[a], columns[b]) <= radius)
      {
        return Describe("two patches within the radius at", PointId(a), PointId(b));
      }
    }
  }
  return {};
}

std::string CheckLoops(const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary,
  const BoundaryParts& parts, const BoundaryOptions& options)
{
  for (std::size_t loop = 0; loop < parts.Size(); ++loop)
  {
    const std::string name = " of loop " + std::to_string(loop);
    if (parts.IsHole(loop) ? !options.KeepHoles && !options.Cuts : parts.PatchOf(loop) != std::int32_t(loop))
    {
      return "number" + name;
    }
    if (parts.IsHole(loop) != (parts.TwiceArea(loop) > 0))
    {
      return "direction" + name;
    }
    if (parts.IsHole(loop) && !options.Cuts &&
      parts.CountInside(loop) < std::max<std::int64_t>(1, options.SmallestHoleSize))
    {
      return "size" + name;
    }
    const PlanePoint& first = columns[std::size_t(*boundary.Boundary.begin(loop))];
    for (const PointId* point = boundary.Boundary.begin(loop); point != boundary.Boundary.end(loop); ++point)
    {
      if (columns[std::size_t(*point)] < first || boundary.Patch[std::size_t(*point)] != parts.PatchOf(loop))
      {
        return "start or patch" + name;
      }
    }
  }
  return {};
}

/// A point is in the patch around it, and in no other.
std::string CheckInside(
  const std::vector<PlanePoint>& columns, const std::vector<std::int32_t>& patch, const BoundaryParts& parts)
{
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    // For each patch: 1 inside its loop or on it, less 1 inside one of its holes.
    std::map<std::int32_t, int> depth;
    for (std::size_t loop = 0; loop < parts.Size(); ++loop)
    {
      const int side = parts.Locate(loop, columns[point]);
      depth[parts.PatchOf(loop)] += parts.IsHole(loop) ? -int(side > 0) : int(side >= 0);
    }
    for (const auto& [number, inside] : depth)
    {
      if (inside != int(number == patch[point]))
      {
        return "point " + std::to_string(point) + " and patch " + std::to_string(number);
      }
    }
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckBoundary(
  const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary, const BoundaryOptions& options)
{
  const BoundaryParts parts(columns, boundary);
  std::string wrong = CheckEdges(columns, boundary.Boundary, options.Radius);
  wrong = wrong.empty() && !options.Cuts ? CheckConnection(columns, boundary.Patch, options.Radius) : wrong;
  wrong = wrong.empty() ? CheckLoops(columns, boundary, parts, options) : wrong;
  return wrong.empty() ? CheckInside(columns, boundary.Patch, parts) : wrong;
}

//----------------------------------------------------------------------------------------------------------------------
std::string CheckCrossings(const BoundedHorizon& horizon)
{
  return CheckEdges(horizon.Plane, horizon.Boundary, std::numeric_limits<int>::max());
}
}
