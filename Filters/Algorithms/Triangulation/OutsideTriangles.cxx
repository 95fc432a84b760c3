// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles at boundary edges beyond a limit are candidates, in a queue by the length of the edge. Once one is removed,
// the boundary follows its other two edges. A triangle stays if the opposite point is on the boundary, which keeps the
// mesh connected.
//
// The thesis (5.3.8) removes triangles where edges of a known outline enclose less than 180 degrees on the outside.
// Here the outline is unknown: the user limits the angle that faces a boundary edge, and the length of this edge. The
// order and the rule for connectivity are from Duckham et al., "Efficient generation of simple polygons for
// characterizing the shape of a set of points in the plane", 2008.

#include "Triangulation.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
/// The chain turns only right, with all other points on it or to its right.
template <typename Iterator>
std::vector<PointId> MakeHullChain(Iterator first, Iterator last, const std::vector<PlanePoint>& places)
{
  std::vector<PointId> chain;
  for (; first != last; ++first)
  {
    while (chain.size() > 1 && SignedArea(places[chain[chain.size() - 2]], places[chain.back()], places[*first]) > 0)
    {
      chain.pop_back();
    }
    chain.push_back(*first);
  }
  return chain;
}

// Angles are rounded to 2^-30 radians, which is finer than the 10^-7 degrees of BoundaryLimits, and products with
// squared distances fit into 128 bits.
constexpr double DirectionLength = 1 << 30;

constexpr double LongerThanAnyEdge = 2147483648.0; // 2^31, as coordinates are below 2^29

class WholeLimits
{
public:
  WholeLimits(const BoundaryLimits& limits, std::int32_t subVoxelsPerColumn)
  {
    const double angle = limits.LargestAngle * std::atan(1.0) / 45.0;
    this->Cosine = std::llround(DirectionLength * std::cos(angle));
    this->Sine = std::llround(DirectionLength * std::sin(angle));
    const double longest = limits.LongestEdge * subVoxelsPerColumn;
    if (longest > 0.0 && longest < LongerThanAnyEdge)
    {
      this->SquaredLength = std::int64_t(std::floor(longest * longest));
    }
  }

  /// The triangle must be counter-clockwise, with the edge a-b opposite to the angle at c.
  bool AreExceeded(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) const
  {
    return SquaredDistance(a, b) > this->SquaredLength || this->IsAngleExceeded(a, b, c);
  }

private:
  /// The scalar and cross product are the coordinates of a direction at the angle. Both angles are within 180 degrees,
  /// so that a left turn from the limit exceeds it.
  bool IsAngleExceeded(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) const
  {
    const std::int64_t along = ScalarProduct(c, a, b);
    const std::int64_t across = SignedArea(a, b, c);
    return Int128(this->Cosine) * across - Int128(this->Sine) * along > 0;
  }

  std::int64_t Cosine;
  std::int64_t Sine;
  std::int64_t SquaredLength = std::numeric_limits<std::int64_t>::max();
};

using CornerId = std::uint32_t;

CornerId NextInTriangle(CornerId corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

using CornersOfPoints = ItemLists<CornerId, CornerId>;

CornersOfPoints ListCorners(std::size_t points, const RawVector<PointId>& triangles)
{
  return CornersOfPoints(std::int64_t(points),
    [&triangles](auto&& add)
    {
      for (CornerId corner = 0; corner < triangles.size(); ++corner)
      {
        add(triangles[corner], corner);
      }
    });
}

class OutsideRemover
{
public:
  OutsideRemover(const BoundedHorizon& hull, RawVector<PointId>& triangles, const BoundaryLimits& limits)
    : Places(hull.Plane)
    , Triangles(triangles)
    , Limits(limits, hull.SubVoxelsPerColumn)
    , Corners(ListCorners(hull.Plane.size(), triangles))
    , Next(hull.Plane.size(), NoPoint)
  {
    hull.Boundary.ForEachEdge([this](PointId from, PointId to) { this->Next[from] = to; });
    hull.Boundary.ForEachEdge([this](PointId from, PointId to) { this->Consider(from, to); });
  }

  void Run(const Monitor& monitor)
  {
    const std::size_t all = this->Triangles.size() / 3;
    for (std::size_t done = 0; !this->Outside.empty(); ++done)
    {
      if (done % 4096 == 0)
      {
        monitor.Progress(double(done) / double(all));
      }
      const Candidate longest = this->Outside.top();
      this->Outside.pop();
      if (!this->IsOnBoundary(longest.Third))
      {
        this->Remove(longest);
      }
    }
    this->Compact();
  }

  Loops Boundary(PointId start) const
  {
    Loops boundary;
    PointId point = start;
    do
    {
      boundary.Append(point);
      point = this->Next[point];
    } while (point != start);
    boundary.Close();
    return boundary;
  }

private:
  struct Candidate
  {
    std::int64_t SquaredLength;
    PlanePoint FromPlace;
    PlanePoint ToPlace;
    PointId From;
    PointId To;
    PointId Third;
    CornerId FirstCorner;

    /// Comparing places makes the result independent of the order of the points.
    bool operator<(const Candidate& other) const
    {
      return std::tie(this->SquaredLength, this->FromPlace, this->ToPlace) <
        std::tie(other.SquaredLength, other.FromPlace, other.ToPlace);
    }
  };

  const PlanePoint& At(PointId point) const { return this->Places[point]; }

  bool IsOnBoundary(PointId point) const { return this->Next[point] != NoPoint; }

  CornerId Find(PointId from, PointId to) const
  {
    const CornerId* const corner = std::find_if(this->Corners.begin(from), this->Corners.end(from),
      [this, to](CornerId found) { return this->Triangles[NextInTriangle(found)] == to; });
    assert(corner != this->Corners.end(from));
    return *corner;
  }

  /// The triangle has the reverse of this edge.
  void Consider(PointId from, PointId to)
  {
    const CornerId corner = this->Find(to, from);
    const PointId third = this->Triangles[NextInTriangle(NextInTriangle(corner))];
    if (!this->IsOnBoundary(third) && this->Limits.AreExceeded(this->At(to), this->At(from), this->At(third)))
    {
      this->Outside.push({ SquaredDistance(this->At(from), this->At(to)), this->At(from), this->At(to), from, to, third,
        corner - corner % 3 });
    }
  }

  void Remove(const Candidate& outside)
  {
    this->Triangles[outside.FirstCorner] = NoPoint;
    this->Next[outside.From] = outside.Third;
    this->Next[outside.Third] = outside.To;
    this->Consider(outside.From, outside.Third);
    this->Consider(outside.Third, outside.To);
  }

  void Compact()
  {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < this->Triangles.size(); first += 3)
    {
      if (this->Triangles[first] != NoPoint)
      {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
          this->Triangles[kept++] = this->Triangles[first + corner];
        }
      }
    }
    this->Triangles.resize(kept);
  }

  const std::vector<PlanePoint>& Places;
  RawVector<PointId>& Triangles;
  const WholeLimits Limits;
  const CornersOfPoints Corners;
  std::vector<PointId> Next; // along the boundary, or NoPoint
  std::priority_queue<Candidate> Outside;
};
}

//----------------------------------------------------------------------------------------------------------------------
// Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
Loops FindConvexHull(const std::vector<PlanePoint>& places)
{
  assert(!places.empty());
  std::vector<PointId> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&places](PointId a, PointId b) { return places[a] < places[b]; });
  const std::vector<PointId> upper = MakeHullChain(order.begin(), order.end(), places);
  const std::vector<PointId> lower = MakeHullChain(order.rbegin(), order.rend(), places);
  Loops hull;
  std::for_each(upper.begin(), upper.end(), [&hull](PointId point) { hull.Append(point); });
  for (std::size_t n = 1; n + 1 < lower.size(); ++n)
  {
    hull.Append(lower[n]);
  }
  hull.Close();
  return hull;
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveOutsideTriangles(
  BoundedHorizon& hull, Triangulation& mesh, const BoundaryLimits& limits, const Monitor& monitor)
{
  CheckWithin("boundary angle", limits.LargestAngle, 0.0, 180.0, " degrees");
  CheckAtLeast("boundary edge length", limits.LongestEdge, 0.0, " lattice units");
  const bool unlimited = limits.LargestAngle == 180.0 && limits.LongestEdge == 0.0;
  if (unlimited || mesh.Triangles.empty())
  {
    return;
  }
  monitor.Progress(0.0);
  OutsideRemover remover(hull, mesh.Triangles, limits);
  remover.Run(monitor.Step(0.5, 1.0));
  hull.Boundary = remover.Boundary(*hull.Boundary.begin(0));
  mesh.BoundaryEdges = hull.Boundary.TotalLength();
  if (MeshChecker::IsOn)
  {
    MeshChecker::Require("RemoveOutsideTriangles", hull.Plane, hull.Boundary, mesh.Triangles);
  }
}
}
