// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeFlips.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// Sides of about equal cost would be flipped to and fro.
constexpr double LeastGain = 1e-3;

// How many sides a thread tries at a time.
constexpr std::int64_t Grain = 64;

/// In rounds: all sides whose triangles have changed are tried at once, then those that gain are flipped, but for those
/// of triangles that a flip of the round has changed. Each flip makes the sum of all costs less, so that this ends.
class EdgeFlips
{
public:
  EdgeFlips(HeightMesh& mesh, const MeshCost& cost)
    : Mesh(mesh)
    , Triangles(mesh.Triangles())
    , Cost(cost)
  {
  }

  void Run(const Monitor& monitor)
  {
    this->Mesh.MeasureAll(this->Cost.Power, monitor.Step(0.0, 0.1));
    this->IsChanged.assign(std::size_t(this->Triangles.Size()), 1);
    std::vector<SideId> sides = this->FindSides();
    const double first = double(sides.size());
    for (double part = 0.1; !sides.empty(); sides = this->FindSides())
    {
      part = std::max(part, 1.0 - 0.9 * double(sides.size()) / first);
      monitor.Progress(part);
      this->FlipAll(this->FindCandidates(sides));
    }
  }

private:
  using SideId = std::int64_t; // three per triangle

  struct Candidate
  {
    SideId Side = 0;
    double Gain = 0.0;
    std::array<HeightError, 2> Errors; // of the two new triangles
  };

  /// The inner sides of triangles that have changed: each by the first of its two triangles.
  std::vector<SideId> FindSides() const
  {
    std::vector<SideId> sides;
    for (TriangleId triangle = 0; triangle < this->Triangles.Size(); ++triangle)
    {
      for (int side = 0; side < 3; ++side)
      {
        const TriangleId other = this->Triangles.Neighbour(triangle, side);
        if (other > triangle &&
          (this->IsChanged[std::size_t(triangle)] != 0 || this->IsChanged[std::size_t(other)] != 0))
        {
          sides.push_back(3 * SideId(triangle) + side);
        }
      }
    }
    return sides;
  }

  /// Those that gain, the largest gain first.
  std::vector<Candidate> FindCandidates(const std::vector<SideId>& sides) const
  {
    std::vector<Candidate> candidates(sides.size());
    ParallelFor(std::int64_t(sides.size()), Grain,
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

  void FlipAll(const std::vector<Candidate>& candidates)
  {
    std::fill(this->IsChanged.begin(), this->IsChanged.end(), 0);
    for (const Candidate& candidate : candidates)
    {
      const auto triangle = TriangleId(candidate.Side / 3);
      const int side = int(candidate.Side % 3);
      const TriangleId other = this->Triangles.Neighbour(triangle, side);
      if (this->IsChanged[std::size_t(triangle)] == 0 && this->IsChanged[std::size_t(other)] == 0)
      {
        this->Triangles.Flip(triangle, side);
        this->Mesh.SetError(triangle, candidate.Errors[0]);
        this->Mesh.SetError(other, candidate.Errors[1]);
        this->IsChanged[std::size_t(triangle)] = 1;
        this->IsChanged[std::size_t(other)] = 1;
      }
    }
  }

  /// Triangles a, b, c and b, a, d would become a, d, c and d, b, c.
  Candidate Try(SideId id) const
  {
    const TriangleId triangle = TriangleId(id / 3);
    const int side = int(id % 3);
    const TriangleId other = this->Triangles.Neighbour(triangle, side);
    const RaisedPoint a = this->Mesh.Raised(this->Triangles.Corner(triangle, side));
    const RaisedPoint b = this->Mesh.Raised(this->Triangles.Corner(triangle, NextCorner(side)));
    const RaisedPoint c = this->Mesh.Raised(this->Triangles.Corner(triangle, PreviousCorner(side)));
    const RaisedPoint d = this->Mesh.Raised(this->Triangles.Beyond(triangle, side));
    Candidate result;
    result.Side = id;
    const double sine = std::min(
      MeshCost::SmallestSineOf(a.Column, d.Column, c.Column), MeshCost::SmallestSineOf(d.Column, b.Column, c.Column));
    if (sine <= 0.0 ||
      (sine < this->Cost.SmallestSine && sine < MeshCost::SmallestSineOf(a.Column, b.Column, c.Column) &&
        sine < MeshCost::SmallestSineOf(b.Column, a.Column, d.Column)))
    {
      return result;
    }
    const HeightRaster& raster = this->Mesh.RasterOf(triangle);
    const HeightError before = this->Cost.MeasureSide(raster, a, b);
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
    const HeightError after = this->Cost.MeasureSide(raster, c, d);
    const double sumAfter = result.Errors[0].Sum + result.Errors[1].Sum + after.Sum;
    if (sumAfter < most && result.Errors[1].Largest <= largest && after.Largest <= largest)
    {
      result.Gain = sum - sumAfter;
    }
    return result;
  }

  HeightMesh& Mesh;
  PlaneMesh& Triangles;
  const MeshCost& Cost;
  std::vector<unsigned char> IsChanged; // by triangle, in the last round
};
}

//----------------------------------------------------------------------------------------------------------------------
void FlipEdges(HeightMesh& mesh, const MeshCost& cost, const Monitor& monitor)
{
  EdgeFlips(mesh, cost).Run(monitor);
}
}
