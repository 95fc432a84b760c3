// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexRemoval.h"

#include "Common/Parallel.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
// What part of the candidates goes in a round: of neighbours the cheaper one should go.
constexpr double PartOfRound = 0.25;

// How many vertices a thread tries at a time.
constexpr std::int64_t Grain = 16;
}

//----------------------------------------------------------------------------------------------------------------------
void VertexRemoval::Run(std::size_t leastVertices, const Monitor& monitor)
{
  this->Mesh.MeasureAll(this->Cost.Power, monitor.Step(0.0, 0.1));
  this->FindTriangles();
  std::vector<PointId> points;
  for (PointId point = 0; std::size_t(point) < this->TriangleAt.size(); ++point)
  {
    if (this->Mesh.IsVertex(point) && !this->Mesh.IsOnLoop(point))
    {
      points.push_back(point);
    }
  }
  this->Candidates.resize(this->TriangleAt.size());
  while (!points.empty() && this->Mesh.NumberOfVertices() > leastVertices)
  {
    this->FindCandidates(points, Monitor());
    points = this->RemoveCheapest(leastVertices);
  }
  this->Mesh.Compact();
}

//----------------------------------------------------------------------------------------------------------------------
void VertexRemoval::FindTriangles()
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  this->TriangleAt.assign(this->Mesh.Heights().size(), NoTriangle);
  for (TriangleId triangle = 0; triangle < mesh.Size(); ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->TriangleAt[std::size_t(mesh.Corner(triangle, corner))] = triangle;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void VertexRemoval::FindCandidates(const std::vector<PointId>& points, const Monitor& monitor)
{
  ParallelFor(std::int64_t(points.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<TriangleId> ring;
      for (std::int64_t n = first; n < last; ++n)
      {
        const PointId point = points[std::size_t(n)];
        this->Candidates[std::size_t(point)] = this->Try(point, ring);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
VertexRemoval::Candidate VertexRemoval::Try(PointId point, std::vector<TriangleId>& ring) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  mesh.FindRing(point, this->TriangleAt[std::size_t(point)], ring);
  Candidate best;
  best.Point = point;
  // The far ends of the ring's sides, those that are between ring[n - 1] and ring[n].
  std::vector<PointId> ends;
  double before = 0.0;
  double largest = this->Cost.LargestError;
  const HeightRaster& raster = this->Mesh.RasterOf(ring.front());
  for (const TriangleId triangle : ring)
  {
    ends.push_back(mesh.Corner(triangle, NextCorner(mesh.CornerAt(triangle, point))));
    const HeightError ofSide =
      raster.MeasureCrossings(this->Mesh.Raised(point), this->Mesh.Raised(ends.back()), this->Cost.Power);
    before += this->Mesh.Error(triangle).Sum + ofSide.Sum;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t end = 0; end < ends.size(); ++end)
  {
    double sum = 0.0;
    if (this->TrySide(ring, ends, end, least, largest, sum))
    {
      least = sum;
      best.Side = (end + ring.size() - 1) % ring.size();
      best.IsPossible = true;
    }
  }
  best.Cost = least - before;
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
// Whether all triangles of a ring could have their corner at the ring's vertex at one of the ends instead.
bool VertexRemoval::TrySide(const std::vector<TriangleId>& ring, const std::vector<PointId>& ends, std::size_t target,
  double most, double largest, double& sum) const
{
  const std::size_t size = ring.size();
  const RaisedPoint to = this->Mesh.Raised(ends[target]);
  for (std::size_t n = 1; n + 1 < size; ++n)
  {
    const PlanePoint& a = this->Mesh.Raised(ends[(target + n) % size]).Column;
    const PlanePoint& b = this->Mesh.Raised(ends[(target + n + 1) % size]).Column;
    const double sine = MeshCost::SmallestSineOf(to.Column, a, b);
    if (sine <= 0.0 || sine < this->Cost.SmallestSine)
    {
      return false;
    }
  }
  const HeightRaster& raster = this->Mesh.RasterOf(ring.front());
  for (std::size_t n = 1; n + 1 < size; ++n)
  {
    const RaisedPoint a = this->Mesh.Raised(ends[(target + n) % size]);
    const RaisedPoint b = this->Mesh.Raised(ends[(target + n + 1) % size]);
    HeightError error = raster.Measure({ to, a, b }, this->Cost.Power);
    sum += error.Sum;
    if (error.Largest > largest || !(sum < most))
    {
      return false;
    }
    if (n > 1)
    {
      error = raster.MeasureCrossings(to, a, this->Cost.Power);
      sum += error.Sum;
      if (error.Largest > largest || !(sum < most))
      {
        return false;
      }
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
// Gives the vertices whose rings were changed.
std::vector<PointId> VertexRemoval::RemoveCheapest(std::size_t leastVertices)
{
  std::vector<Candidate> possible;
  std::copy_if(this->Candidates.begin(), this->Candidates.end(), std::back_inserter(possible),
    [](const Candidate& candidate) { return candidate.IsPossible; });
  std::sort(possible.begin(), possible.end(),
    [](const Candidate& a, const Candidate& b) { return a.Cost != b.Cost ? a.Cost < b.Cost : a.Point < b.Point; });
  PlaneMesh& mesh = this->Mesh.Triangles();
  this->IsChanged.assign(std::size_t(mesh.Size()), 0);
  std::vector<TriangleId> changed;
  std::vector<TriangleId> ring;
  const std::size_t most = std::size_t(std::ceil(PartOfRound * double(possible.size())));
  for (std::size_t n = 0; n < most && this->Mesh.NumberOfVertices() > leastVertices; ++n)
  {
    const PointId point = possible[n].Point;
    mesh.FindRing(point, this->TriangleAt[std::size_t(point)], ring);
    if (std::any_of(
          ring.begin(), ring.end(), [this](TriangleId one) { return this->IsChanged[std::size_t(one)] != 0; }))
    {
      continue;
    }
    mesh.Collapse(point, ring, possible[n].Side);
    this->Mesh.MarkVertex(point, false);
    this->Candidates[std::size_t(point)] = Candidate();
    for (const TriangleId triangle : ring)
    {
      this->IsChanged[std::size_t(triangle)] = 1;
      if (!mesh.IsGone(triangle))
      {
        changed.push_back(triangle);
        for (int corner = 0; corner < 3; ++corner)
        {
          this->TriangleAt[std::size_t(mesh.Corner(triangle, corner))] = triangle;
        }
      }
    }
  }
  this->Mesh.Measure(changed, this->Cost.Power, Monitor());
  std::vector<PointId> points;
  for (const TriangleId triangle : changed)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const PointId point = mesh.Corner(triangle, corner);
      if (!this->Mesh.IsOnLoop(point))
      {
        points.push_back(point);
      }
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}
}
