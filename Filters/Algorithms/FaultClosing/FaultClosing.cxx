// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Loops and open ends of cracks (Common/Horizon/Cracks.h) form a plane graph. Walks from open ends, along the first
// edges that a clockwise sweep meets, surround the cracks to their left.
// 2. Loops of cutoffs without a walk bound cracks of their own.
// 3. The enclosed regions are triangulated together.
//
//     o---o-------o---o        o    vertices of the mesh
//         : \     |            -    cutoffs
//         :   \   |            :    an open end
//     o---o-------o---o        \    inside the crack
//
// No points are added, so the result fits the mesh on both sides. Walks choose edges only at open ends.

#include "FaultClosing.h"

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>

namespace SeismicHorizons
{
namespace
{
struct GraphEdge
{
  PointId From;
  PointId To;
  std::size_t Next; // edge of the loop; unused for open ends
};

/// Returns 0 for the same direction, 1 up to half a turn clockwise, 2 beyond.
int HalfTurn(const PlanePoint& from, const PlanePoint& to)
{
  const std::int64_t left = SignedArea({ 0, 0 }, from, to);
  if (left == 0)
  {
    return ScalarProduct({ 0, 0 }, from, to) > 0 ? 0 : 1;
  }
  return left < 0 ? 1 : 2;
}

/// The direction of `from` comes last.
bool IsMetBefore(const PlanePoint& from, const PlanePoint& a, const PlanePoint& b)
{
  const auto part = [&from](const PlanePoint& vector) { return (HalfTurn(from, vector) + 2) % 3; };
  return part(a) != part(b) ? part(a) < part(b) : SignedArea({ 0, 0 }, a, b) < 0;
}

class CrackWalker
{
public:
  CrackWalker(const std::vector<PlanePoint>& plane, const Loops& boundary, const Cracks& cracks)
    : Plane(plane)
    , Boundary(boundary)
    , Open(cracks)
  {
    for (const Edge& openEnd : cracks.OpenEnds)
    {
      this->Leaving.emplace(openEnd.From, this->Edges.size());
      this->Edges.push_back({ openEnd.From, openEnd.To, 0 });
    }
    std::vector<PointId> ends = cracks.PointsOfOpenEnds();
    std::sort(ends.begin(), ends.end());
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      this->Starts.push_back(this->Edges.size());
      const PointId* const points = boundary.begin(loop);
      const std::size_t length = boundary.Length(loop);
      for (std::size_t n = 0; n < length; ++n)
      {
        if (length > 1 && std::binary_search(ends.begin(), ends.end(), points[n]))
        {
          this->Leaving.emplace(points[n], this->Edges.size());
        }
        const std::size_t next = n + 1 < length ? n + 1 : 0;
        this->Edges.push_back({ points[n], points[next], this->Starts.back() + next });
      }
    }
    this->IsWalked.assign(this->Edges.size(), false);
  }

  /// The cracks lie to the right of the loops returned.
  Loops Run()
  {
    Loops result;
    const auto append = [&result](const PointId* begin, const PointId* end)
    {
      std::for_each(std::make_reverse_iterator(end), std::make_reverse_iterator(begin),
        [&result](PointId point) { result.Append(point); });
      result.Close();
    };
    for (std::size_t openEnd = 0; openEnd < this->Open.OpenEnds.size(); ++openEnd)
    {
      if (!this->IsWalked[openEnd])
      {
        const std::vector<PointId> points = this->Walk(openEnd);
        append(points.data(), points.data() + points.size());
      }
    }
    for (const std::size_t loop : this->Open.Loops)
    {
      if (loop >= this->Boundary.Size())
      {
        throw InputError("a crack along loop " + std::to_string(loop) + ", expected less than the " +
          std::to_string(this->Boundary.Size()) + " of the boundary");
      }
      if (!this->IsWalked[this->Starts[loop]])
      {
        append(this->Boundary.begin(loop), this->Boundary.end(loop));
      }
    }
    return result;
  }

private:
  PlanePoint Vector(PointId from, PointId to) const
  {
    const PlanePoint& a = this->Plane[from];
    const PlanePoint& b = this->Plane[to];
    return { b.X - a.X, b.Y - a.Y };
  }

  std::vector<PointId> Walk(std::size_t first)
  {
    std::vector<PointId> points;
    std::size_t edge = first;
    do
    {
      if (this->IsWalked[edge])
      {
        throw InputError("crack not closed, from its open end between points " +
          std::to_string(this->Edges[first].From) + " and " + std::to_string(this->Edges[first].To) +
          ", expected open ends of cracks between the boundary loops");
      }
      this->IsWalked[edge] = true;
      points.push_back(this->Edges[edge].From);
      edge = this->Next(edge);
    } while (edge != first);
    return points;
  }

  std::size_t Next(std::size_t edge) const
  {
    assert(edge < this->Edges.size());
    const PointId point = this->Edges[edge].To;
    const auto [first, last] = this->Leaving.equal_range(point);
    if (first == last && edge < this->Open.OpenEnds.size())
    {
      throw InputError("open end of a crack at point " + std::to_string(point) +
        ", where no boundary loop begins, expected points of the loops");
    }
    if (first == last)
    {
      return this->Edges[edge].Next;
    }
    const PlanePoint back = this->Vector(point, this->Edges[edge].From);
    const auto toEnd = [&](const auto& leaving) { return this->Vector(point, this->Edges[leaving.second].To); };
    return std::min_element(
      first, last, [&](const auto& a, const auto& b) { return IsMetBefore(back, toEnd(a), toEnd(b)); })
      ->second;
  }

  const std::vector<PlanePoint>& Plane;
  const Loops& Boundary;
  const Cracks& Open;
  std::vector<GraphEdge> Edges; // open ends, then loops
  std::vector<std::size_t> Starts; // first edge by loop
  std::multimap<PointId, std::size_t> Leaving; // edges by point, at open ends
  std::vector<bool> IsWalked; // by edge
};
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> CloseFaults(
  const std::vector<PlanePoint>& plane, const Loops& boundary, const Cracks& cracks, const Monitor& monitor)
{
  const Loops outlines = CrackWalker(plane, boundary, cracks).Run();
  std::vector<PointId> points;
  outlines.ForEachPoint([&points](PointId point) { points.push_back(point); });
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  BoundedHorizon region;
  assert(points.empty() || std::size_t(points.back()) < plane.size());
  for (const PointId point : points)
  {
    region.Plane.push_back(plane[point]);
  }
  region.Patch.assign(points.size(), 0);
  region.Boundary = outlines.RenumberedBy([&points](PointId point)
    { return PointId(std::lower_bound(points.begin(), points.end(), point) - points.begin()); });
  // Builds that check meshes check this mesh in Triangulate().
  RawVector<PointId> triangles = Triangulate(region, TriangulationOptions(), monitor).Triangles;
  for (PointId& corner : triangles)
  {
    corner = points[corner];
  }
  return triangles;
}
}
