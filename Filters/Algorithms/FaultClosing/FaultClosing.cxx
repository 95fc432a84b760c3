// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Loops and open ends of cracks (Common/Horizon/Cracks.h) form a plane graph. Walks from open ends, along the first edges
// that a clockwise sweep meets, surround the cracks to their left.
// 2. Loops of cutoffs without a walk bound cracks of their own.
// 3. The enclosed regions are triangulated together.
//
//     o---o-------o---o        o    vertices of the mesh
//         : \     |            -    cutoffs
//         :   \   |            :    an open end
//     o---o-------o---o        \    inside the crack
//
// No points are added, so the result fits the mesh on both sides. A loop edge is known by its position, counted through
// all loops. Walks choose edges only at open ends.

#include "FaultClosing.h"

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct GraphEdge
{
  bool IsOpenEnd;
  std::size_t Number;
};

struct LeavingEdge
{
  PointId From;
  GraphEdge Edge;

  friend bool operator<(const LeavingEdge& a, const LeavingEdge& b) { return a.From < b.From; }
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
    , IsWalked(cracks.OpenEnds.size(), false)
  {
    this->CountPositions();
    this->FindLeavingEdges();
  }

  /// The cracks lie to the right of the loops returned.
  Loops Run()
  {
    for (std::size_t openEnd = 0; openEnd < this->Open.OpenEnds.size(); ++openEnd)
    {
      if (!this->IsWalked[openEnd])
      {
        this->Walk({ true, openEnd });
        this->AppendWalk();
      }
    }
    for (const std::size_t loop : this->Open.Loops)
    {
      this->AppendLoop(loop);
    }
    return std::move(this->Result);
  }

private:
  void CountPositions()
  {
    this->Ends.reserve(this->Boundary.Size());
    std::size_t end = 0;
    for (std::size_t loop = 0; loop < this->Boundary.Size(); ++loop)
    {
      end += this->Boundary.Length(loop);
      this->Ends.push_back(end);
    }
    this->IsCutoff.assign(end, false);
  }

  void FindLeavingEdges()
  {
    for (std::size_t openEnd = 0; openEnd < this->Open.OpenEnds.size(); ++openEnd)
    {
      this->Leaving.push_back({ this->Open.OpenEnds[openEnd].From, { true, openEnd } });
    }
    std::vector<PointId> ends = this->Open.PointsOfOpenEnds();
    std::sort(ends.begin(), ends.end());
    for (std::size_t loop = 0; loop < this->Boundary.Size() && !ends.empty(); ++loop)
    {
      for (std::size_t n = 0; this->Boundary.Length(loop) > 1 && n < this->Boundary.Length(loop); ++n)
      {
        const PointId point = this->Boundary.begin(loop)[n];
        if (std::binary_search(ends.begin(), ends.end(), point))
        {
          this->Leaving.push_back({ point, { false, this->StartOf(loop) + n } });
        }
      }
    }
    std::stable_sort(this->Leaving.begin(), this->Leaving.end());
  }

  std::size_t StartOf(std::size_t loop) const { return loop == 0 ? 0 : this->Ends[loop - 1]; }

  std::size_t LoopOf(std::size_t position) const
  {
    return std::upper_bound(this->Ends.begin(), this->Ends.end(), position) - this->Ends.begin();
  }

  std::size_t After(std::size_t position) const
  {
    const std::size_t loop = this->LoopOf(position);
    assert(loop < this->Ends.size());
    return position + 1 < this->Ends[loop] ? position + 1 : this->StartOf(loop);
  }

  PointId At(std::size_t position) const
  {
    const std::size_t loop = this->LoopOf(position);
    return this->Boundary.begin(loop)[position - this->StartOf(loop)];
  }

  PointId FromOf(const GraphEdge& edge) const
  {
    return edge.IsOpenEnd ? this->Open.OpenEnds[edge.Number].From : this->At(edge.Number);
  }

  PointId ToOf(const GraphEdge& edge) const
  {
    return edge.IsOpenEnd ? this->Open.OpenEnds[edge.Number].To : this->At(this->After(edge.Number));
  }

  PlanePoint Vector(PointId from, PointId to) const
  {
    const PlanePoint& a = this->Plane[from];
    const PlanePoint& b = this->Plane[to];
    return { b.X - a.X, b.Y - a.Y };
  }

  void Walk(const GraphEdge& first)
  {
    this->Points.clear();
    GraphEdge edge = first;
    do
    {
      std::vector<bool>& walked = edge.IsOpenEnd ? this->IsWalked : this->IsCutoff;
      if (walked[edge.Number])
      {
        const Edge& openEnd = this->Open.OpenEnds[first.Number];
        throw InputError("crack not closed, from its open end between points " + std::to_string(openEnd.From) +
          " and " + std::to_string(openEnd.To) + ", expected open ends of cracks between the boundary loops");
      }
      walked[edge.Number] = true;
      this->Points.push_back(this->FromOf(edge));
      edge = this->Next(edge);
    } while (!edge.IsOpenEnd || edge.Number != first.Number);
  }

  GraphEdge Next(const GraphEdge& edge) const
  {
    const PointId point = this->ToOf(edge);
    const auto [first, last] = std::equal_range(this->Leaving.begin(), this->Leaving.end(), LeavingEdge{ point, {} });
    if (first == last && edge.IsOpenEnd)
    {
      throw InputError("open end of a crack at point " + std::to_string(point) +
        ", where no boundary loop begins, expected points of the loops");
    }
    if (first == last)
    {
      return { false, this->After(edge.Number) };
    }
    const PlanePoint back = this->Vector(point, this->FromOf(edge));
    const auto toEnd = [&](const LeavingEdge& leaving) { return this->Vector(point, this->ToOf(leaving.Edge)); };
    return std::min_element(
      first, last, [&](const LeavingEdge& a, const LeavingEdge& b) { return IsMetBefore(back, toEnd(a), toEnd(b)); })
      ->Edge;
  }

  void AppendWalk()
  {
    std::for_each(this->Points.rbegin(), this->Points.rend(), [this](PointId point) { this->Result.Append(point); });
    this->Result.Close();
  }

  void AppendLoop(std::size_t loop)
  {
    if (loop >= this->Boundary.Size())
    {
      throw InputError("a crack along loop " + std::to_string(loop) + ", expected less than the " +
        std::to_string(this->Boundary.Size()) + " of the boundary");
    }
    if (!this->IsCutoff[this->StartOf(loop)])
    {
      this->Points.assign(this->Boundary.begin(loop), this->Boundary.end(loop));
      this->AppendWalk();
    }
  }

  const std::vector<PlanePoint>& Plane;
  const Loops& Boundary;
  const Cracks& Open;
  std::vector<std::size_t> Ends; // of loops, as positions
  std::vector<bool> IsWalked;
  std::vector<bool> IsCutoff; // by position
  std::vector<LeavingEdge> Leaving; // at open ends, sorted
  std::vector<PointId> Points; // of the last walk
  Loops Result;
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
