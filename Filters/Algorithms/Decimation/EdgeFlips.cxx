// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeFlips.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// Sides of about equal cost would be flipped to and fro.
constexpr double LeastGain = 1e-3;

// How many sides a thread tries at a time.
constexpr std::int64_t Grain = 64;
}

//----------------------------------------------------------------------------------------------------------------------
void EdgeFlips::Run(const Monitor& monitor)
{
  this->Mesh.MeasureAll(this->Cost.Power, monitor.Step(0.0, 0.1));
  std::vector<SideId> sides;
  for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
  {
    this->AddSides(triangle, sides);
  }
  std::vector<TriangleId> changed;
  this->Settle(std::move(sides), changed, monitor.Step(0.1, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
void EdgeFlips::RunAround(std::vector<TriangleId>& triangles, const Monitor& monitor)
{
  this->Mesh.Measure(triangles, this->Cost.Power, Monitor());
  std::vector<SideId> sides;
  for (const TriangleId triangle : triangles)
  {
    this->AddSides(triangle, sides);
  }
  this->Settle(std::move(sides), triangles, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
// Each side by the lesser of its two triangles, so that it is tried once.
void EdgeFlips::AddSides(TriangleId triangle, std::vector<SideId>& sides) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  for (int side = 0; side < 3; ++side)
  {
    const TriangleId other = mesh.Neighbour(triangle, side);
    if (other != NoTriangle)
    {
      sides.push_back(
        triangle < other ? 3 * SideId(triangle) + side : 3 * SideId(other) + mesh.SideTo(other, triangle));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// In rounds: all sides are tried at once, then those that gain are flipped, but for those of triangles that a flip of
// the round has changed. Each flip makes the sum of all costs less, so that they come to an end.
void EdgeFlips::Settle(std::vector<SideId> sides, std::vector<TriangleId>& changed, const Monitor& monitor)
{
  const std::size_t first = sides.size();
  while (!sides.empty())
  {
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    const std::vector<Candidate> candidates = this->FindCandidates(sides, Monitor());
    monitor.Progress(1.0 - double(sides.size()) / double(first + 1));
    this->IsChanged.assign(std::size_t(this->Mesh.Triangles().Size()), 0);
    sides.clear();
    const std::size_t before = changed.size();
    for (const Candidate& candidate : candidates)
    {
      const TriangleId triangle = TriangleId(candidate.Side / 3);
      const int side = int(candidate.Side % 3);
      const TriangleId other = this->Mesh.Triangles().Neighbour(triangle, side);
      if (other == NoTriangle || this->IsChanged[std::size_t(triangle)] != 0 || this->IsChanged[std::size_t(other)] != 0)
      {
        continue;
      }
      this->Mesh.Triangles().Flip(triangle, side);
      this->Mesh.SetError(triangle, candidate.Errors[0]);
      this->Mesh.SetError(other, candidate.Errors[1]);
      for (const TriangleId one : { triangle, other })
      {
        this->IsChanged[std::size_t(one)] = 1;
        changed.push_back(one);
      }
    }
    std::for_each(changed.begin() + std::ptrdiff_t(before), changed.end(),
      [&](TriangleId triangle) { this->AddSides(triangle, sides); });
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<EdgeFlips::Candidate> EdgeFlips::FindCandidates(
  const std::vector<SideId>& sides, const Monitor& monitor) const
{
  std::vector<Candidate> candidates(sides.size());
  ParallelFor(std::int64_t(sides.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        candidates[std::size_t(n)] = this->Try(sides[std::size_t(n)]);
      }
    });
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [](const Candidate& candidate) { return !(candidate.Gain > 0.0); }),
    candidates.end());
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Gain != b.Gain ? a.Gain > b.Gain : a.Side < b.Side; });
  return candidates;
}

//----------------------------------------------------------------------------------------------------------------------
// Triangles a, b, c and b, a, d would become a, d, c and d, b, c.
EdgeFlips::Candidate EdgeFlips::Try(SideId id) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  const TriangleId triangle = TriangleId(id / 3);
  const int side = int(id % 3);
  const TriangleId other = mesh.Neighbour(triangle, side);
  const RaisedPoint a = this->Mesh.Raised(mesh.Corner(triangle, side));
  const RaisedPoint b = this->Mesh.Raised(mesh.Corner(triangle, NextCorner(side)));
  const RaisedPoint c = this->Mesh.Raised(mesh.Corner(triangle, PreviousCorner(side)));
  const RaisedPoint d = this->Mesh.Raised(mesh.Beyond(triangle, side));
  Candidate result;
  result.Side = id;
  const double sine = std::min(MeshCost::SmallestSineOf(a.Column, d.Column, c.Column),
    MeshCost::SmallestSineOf(d.Column, b.Column, c.Column));
  if (sine <= 0.0 ||
    (sine < this->Cost.SmallestSine &&
      sine < MeshCost::SmallestSineOf(a.Column, b.Column, c.Column) &&
      sine < MeshCost::SmallestSineOf(b.Column, a.Column, d.Column)))
  {
    return result;
  }
  const HeightRaster& raster = this->Mesh.RasterOf(triangle);
  const HeightError before = raster.MeasureCrossings(a, b, this->Cost.Power);
  const HeightError& one = this->Mesh.Error(triangle);
  const HeightError& two = this->Mesh.Error(other);
  const double sum = before.Sum + one.Sum + two.Sum;
  const double most = (1.0 - LeastGain) * sum;
  const double largest = std::max({ before.Largest, one.Largest, two.Largest, this->Cost.LargestError });
  result.Errors[0] = raster.Measure({ a, d, c }, this->Cost.Power);
  if (result.Errors[0].Sum >= most || result.Errors[0].Largest > largest)
  {
    return result;
  }
  result.Errors[1] = raster.Measure({ d, b, c }, this->Cost.Power);
  const HeightError after = raster.MeasureCrossings(c, d, this->Cost.Power);
  const double sumAfter = result.Errors[0].Sum + result.Errors[1].Sum + after.Sum;
  if (sumAfter < most && result.Errors[1].Largest <= largest && after.Largest <= largest)
  {
    result.Gain = sum - sumAfter;
  }
  return result;
}
}
