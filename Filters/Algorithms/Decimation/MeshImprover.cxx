// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: costs; flips of edges; removal of vertices; insertion; rounds of all.

#include "MeshImprover.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/Predicates.h"
#include "Decimation.h"
#include "HeightMesh.h"
#include "MeshGroups.h"
#include "MeshRefiner.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The cost sums powers of errors at columns, and where inner edges cross grid lines, as slivers between columns do.
struct MeshCost
{
  /// Errors are divided by the unit; the angle is in degrees.
  MeshCost(DecimationPriority priority, double unit, double smallestAngle)
    : Power{ priority == DecimationPriority::LargestError ? 4 : 2, unit }
    , SmallestSine(SineOfDegrees(smallestAngle))
  {
  }

  /// Returns infinity if the cost reaches `most` or an error is too large.
  double TriangleCost(const HeightMesh& mesh, const std::array<VertexId, 3>& corners, double most = Infinity) const
  {
    double sum = 0.0;
    for (std::size_t horizon = 0; horizon < mesh.NumberOfHorizons() && sum < most; ++horizon)
    {
      const RaisedTriangle raised = { mesh.Raised(horizon, corners[0]), mesh.Raised(horizon, corners[1]),
        mesh.Raised(horizon, corners[2]) };
      sum += mesh.RasterAt(horizon, corners[0]).SumWithin(raised, this->Power, this->LargestError, most - sum);
    }
    return sum < most ? sum : Infinity;
  }

  /// Edges weigh less: at a cliff every edge is far from the grid lines it crosses, and would dominate.
  double EdgeCost(const HeightMesh& mesh, VertexId from, VertexId to) const
  {
    double sum = 0.0;
    for (std::size_t horizon = 0; horizon < mesh.NumberOfHorizons() && sum < Infinity; ++horizon)
    {
      const HeightRaster& raster = mesh.RasterAt(horizon, from);
      const RaisedPoint& start = mesh.Raised(horizon, from);
      const RaisedPoint& end = mesh.Raised(horizon, to);
      sum += this->LargestError == Infinity ? EdgeWeight * raster.MeasureCrossings(start, end, this->Power).Sum
        : raster.IsEdgeWithin(start, end, this->LargestError) ? 0.0
                                                              : Infinity;
    }
    return sum;
  }

  /// Existing edges keep the largest error already.
  double ExistingEdgeCost(const HeightMesh& mesh, VertexId from, VertexId to) const
  {
    return this->LargestError < Infinity ? 0.0 : this->EdgeCost(mesh, from, to);
  }

  std::vector<double> TriangleCosts(const HeightMesh& mesh, const Monitor& monitor) const
  {
    std::vector<double> costs(std::size_t(mesh.Triangles().Size()));
    mesh.ForEachTriangle(monitor,
      [&](TriangleId triangle)
      {
        for (std::size_t horizon = 0; horizon < mesh.NumberOfHorizons(); ++horizon)
        {
          costs[triangle] +=
            mesh.RasterOf(horizon, triangle).SumWithin(mesh.RaisedCorners(horizon, triangle), this->Power, Infinity);
        }
      });
    return costs;
  }

  bool IsWide(double squaredSine) const { return squaredSine >= this->SmallestSine * this->SmallestSine; }

  ErrorPower Power;
  /// No change makes a smaller angle in plan, unless one was smaller before.
  double SmallestSine;
  double LargestError = Infinity; // No change may exceed it.
};

/// Returns 0 for a flat or clockwise triangle.
double SquaredSineOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const double ab = double(SquaredDistance(a, b));
  const double bc = double(SquaredDistance(b, c));
  const double ca = double(SquaredDistance(c, a));
  const double area = double(SignedArea(a, b, c));
  return area > 0.0 ? area * area / std::max({ ab * bc, bc * ca, ca * ab }) : 0.0;
}

// ---- Flips ---------------------------------------------------------------------------------------------------------
// Flips bring a mesh nearer to the horizon: data-dependent triangulation (Dyn, Levin and Rippa 1990, "Data dependent
// triangulations for piecewise linear interpolation").

// Without a minimum gain, edges of nearly equal cost flip back and forth.
constexpr double LeastGain = 1e-3;

constexpr std::int64_t FlipGrain = 64;

/// A round flips by gain, except in triangles that it has changed. Rounds end, as every flip lowers the total cost.
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
    this->Costs = this->Cost.TriangleCosts(this->Mesh, monitor.Step(0.0, 0.1));
    this->IsChanged.assign(std::size_t(this->Triangles.Size()), 1);
    std::vector<EdgeId> edges = this->FindEdges();
    const double first = double(edges.size());
    for (double fraction = 0.1; !edges.empty(); edges = this->FindEdges())
    {
      fraction = std::max(fraction, 1.0 - 0.9 * double(edges.size()) / first);
      monitor.Progress(fraction);
      this->FlipAll(this->FindCandidates(edges));
    }
  }

private:
  using EdgeId = std::int64_t; // three per triangle

  struct Candidate
  {
    EdgeId Edge = 0;
    double Gain = 0.0;
    std::array<double, 2> Costs = {};
  };

  std::vector<EdgeId> FindEdges() const
  {
    std::vector<EdgeId> edges;
    for (TriangleId triangle = 0; triangle < this->Triangles.Size(); ++triangle)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const TriangleId other = this->Triangles.Neighbour(triangle, edge);
        if (other > triangle && (this->IsChanged[triangle] != 0 || this->IsChanged[other] != 0) &&
          !this->Triangles.IsKeptEdge(triangle, edge))
        {
          edges.push_back(3 * EdgeId(triangle) + edge);
        }
      }
    }
    return edges;
  }

  std::vector<Candidate> FindCandidates(const std::vector<EdgeId>& edges) const
  {
    std::vector<Candidate> candidates(edges.size());
    ParallelFor(std::int64_t(edges.size()), FlipGrain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          candidates[n] = this->Try(edges[n]);
        }
      });
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                       [](const Candidate& candidate) { return !(candidate.Gain > 0.0); }),
      candidates.end());
    std::sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Gain != b.Gain ? a.Gain > b.Gain : a.Edge < b.Edge; });
    return candidates;
  }

  void FlipAll(const std::vector<Candidate>& candidates)
  {
    std::fill(this->IsChanged.begin(), this->IsChanged.end(), 0);
    for (const Candidate& candidate : candidates)
    {
      const auto triangle = TriangleId(candidate.Edge / 3);
      const int edge = int(candidate.Edge % 3);
      const TriangleId other = this->Triangles.Neighbour(triangle, edge);
      if (this->IsChanged[triangle] == 0 && this->IsChanged[other] == 0)
      {
        this->Triangles.Flip(triangle, edge);
        this->Costs[triangle] = candidate.Costs[0];
        this->Costs[other] = candidate.Costs[1];
        this->IsChanged[triangle] = 1;
        this->IsChanged[other] = 1;
      }
    }
  }

  /// Triangles a, b, c and b, a, d would become a, d, c and d, b, c.
  Candidate Try(EdgeId id) const
  {
    const TriangleId triangle = TriangleId(id / 3);
    const int edge = int(id % 3);
    const TriangleId other = this->Triangles.Neighbour(triangle, edge);
    const VertexId a = this->Triangles.Corner(triangle, edge);
    const VertexId b = this->Triangles.Corner(triangle, NextCorner(edge));
    const VertexId c = this->Triangles.Corner(triangle, PreviousCorner(edge));
    const VertexId d = this->Triangles.Beyond(triangle, edge);
    const auto sineOf = [this](VertexId p, VertexId q, VertexId r)
    { return SquaredSineOf(this->Triangles.Place(p), this->Triangles.Place(q), this->Triangles.Place(r)); };
    Candidate result;
    result.Edge = id;
    const double sine = std::min(sineOf(a, d, c), sineOf(d, b, c));
    const double sineBefore = std::min(sineOf(a, b, c), sineOf(b, a, d));
    if (sine <= 0.0 || (!this->Cost.IsWide(sine) && sine < sineBefore))
    {
      return result;
    }
    const double before = this->Cost.ExistingEdgeCost(this->Mesh, a, b) + this->Costs[triangle] + this->Costs[other];
    double most = (1.0 - LeastGain) * before;
    result.Costs[0] = this->Cost.TriangleCost(this->Mesh, { a, d, c }, most);
    most -= result.Costs[0];
    if (most > 0.0)
    {
      result.Costs[1] = this->Cost.TriangleCost(this->Mesh, { d, b, c }, most);
      most -= result.Costs[1];
    }
    if (most > 0.0)
    {
      const double after = result.Costs[0] + result.Costs[1] + this->Cost.EdgeCost(this->Mesh, c, d);
      result.Gain = after < (1.0 - LeastGain) * before ? before - after : 0.0;
    }
    return result;
  }

  HeightMesh& Mesh;
  PlaneMesh& Triangles;
  const MeshCost& Cost;
  std::vector<double> Costs;
  std::vector<unsigned char> IsChanged;
};

// ---- Removal -------------------------------------------------------------------------------------------------------
// Half-edge collapses remove inner vertices (Hoppe 1996, "Progressive meshes"), the cheapest first, except beside
// vertices that the round has removed.

// A round considers only this fraction of the candidates, so that the cheaper of two neighbours goes first.
constexpr double FractionOfRound = 0.25;

// Vertices of slivers cost this fraction, so that they go early.
constexpr double FractionOfSlivers = 0.01;

constexpr std::int64_t RemovalGrain = 16;

/// Triangles and ends are counter-clockwise; Ends[n] lies between triangles n - 1 and n.
struct Ring
{
  std::vector<TriangleId> Triangles;
  std::vector<VertexId> Ends;
  double Sum = 0.0;
  double Sine = 1.0; // square, of the smallest angle

  /// The number n may be up to twice the number of ends.
  VertexId End(std::size_t n) const { return this->Ends[n < this->Ends.size() ? n : n - this->Ends.size()]; }
};

class VertexRemoval
{
public:
  VertexRemoval(HeightMesh& mesh, const MeshCost& cost)
    : Mesh(mesh)
    , Cost(cost)
  {
  }

  void Run(std::size_t leastVertices, const Monitor& monitor)
  {
    if (this->Mesh.NumberOfVertices() <= leastVertices)
    {
      return;
    }
    this->Costs = this->Cost.TriangleCosts(this->Mesh, monitor.Step(0.0, 0.05));
    this->FindVertices();
    const double first = double(this->Mesh.NumberOfVertices());
    bool isPossible = true;
    while (isPossible && this->Mesh.NumberOfVertices() > leastVertices)
    {
      this->TryOld();
      const std::vector<Candidate> cheapest = this->FindCheapest();
      this->RemoveAll(cheapest, leastVertices);
      isPossible = !cheapest.empty();
      monitor.Progress(1.0 - 0.95 * double(this->Mesh.NumberOfVertices()) / first);
    }
    this->Mesh.Compact();
  }

private:
  struct Candidate
  {
    double Cost; // growth of the sum of errors; infinite if the vertex is needed
    VertexId Vertex;
    std::int32_t Edge; // collapsed edge of its ring
  };

  /// Least is a lower bound: the error of the vertex's own point.
  struct End
  {
    double Least;
    std::size_t Number;
  };

  void FindVertices()
  {
    const PlaneMesh& mesh = this->Mesh.Triangles();
    this->TriangleAt.resize(std::size_t(this->Mesh.EndOfVertices()));
    this->IsOld.resize(this->TriangleAt.size());
    for (TriangleId triangle = 0; triangle < mesh.Size(); ++triangle)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->TriangleAt[mesh.Corner(triangle, corner)] = triangle;
        if (mesh.IsKeptEdge(triangle, corner)) // its ends may lie on a longer kept line
        {
          this->Mesh.Fix(mesh.Corner(triangle, corner));
          this->Mesh.Fix(mesh.Corner(triangle, NextCorner(corner)));
        }
      }
    }
    for (const VertexId vertex : this->Mesh.InnerVertices())
    {
      if (!this->Mesh.IsFixed(vertex))
      {
        this->Candidates.push_back({ Infinity, vertex, 0 });
        this->IsOld[vertex] = 1;
      }
    }
  }

  std::vector<Candidate> FindCheapest() const
  {
    const auto isCheaper = [](const Candidate& a, const Candidate& b)
    { return std::tie(a.Cost, a.Vertex) < std::tie(b.Cost, b.Vertex); };
    std::vector<Candidate> possible;
    std::copy_if(this->Candidates.begin(), this->Candidates.end(), std::back_inserter(possible),
      [](const Candidate& one) { return one.Cost < Infinity; });
    const auto size = std::ptrdiff_t(std::ceil(FractionOfRound * double(possible.size())));
    if (size > 0)
    {
      std::nth_element(possible.begin(), possible.begin() + (size - 1), possible.end(), isCheaper);
    }
    possible.resize(std::size_t(size));
    std::sort(possible.begin(), possible.end(), isCheaper);
    return possible;
  }

  void TryOld()
  {
    ParallelFor(std::int64_t(this->Candidates.size()), RemovalGrain,
      [this](std::int64_t first, std::int64_t last)
      {
        Ring ring;
        std::vector<End> ends;
        for (std::int64_t n = first; n < last; ++n)
        {
          Candidate& candidate = this->Candidates[n];
          if (this->IsOld[candidate.Vertex] != 0)
          {
            candidate = this->Try(candidate.Vertex, ring, ends);
            this->IsOld[candidate.Vertex] = 0;
          }
        }
      });
  }

  Candidate Try(VertexId vertex, Ring& ring, std::vector<End>& ends) const
  {
    this->FindRing(vertex, ring);
    this->FindEnds(ring, vertex, ends);
    Candidate best{ Infinity, vertex, 0 };
    for (const End& end : ends)
    {
      const double most = ring.Sum + best.Cost;
      const double sum = end.Least < most ? this->SumAt(ring, end.Number, most) : Infinity;
      if (sum - ring.Sum < best.Cost)
      {
        best.Cost = sum - ring.Sum;
        best.Edge = std::int32_t((end.Number + ring.Ends.size() - 1) % ring.Ends.size());
      }
    }
    best.Cost *= !this->Cost.IsWide(ring.Sine) && best.Cost > 0.0 ? FractionOfSlivers : 1.0;
    return best;
  }

  /// The least bounds come first, so that most ends are skipped.
  void FindEnds(const Ring& ring, VertexId vertex, std::vector<End>& ends) const
  {
    ends.clear();
    for (std::size_t end = 0; end < ring.Ends.size(); ++end)
    {
      if (this->KeepsAngles(ring, end))
      {
        const double least = this->LeastCostOf(vertex, ring, end);
        if (least < Infinity)
        {
          ends.push_back({ least, end });
        }
      }
    }
    std::sort(ends.begin(), ends.end(),
      [](const End& a, const End& b) { return std::tie(a.Least, a.Number) < std::tie(b.Least, b.Number); });
  }

  /// Looks only at the triangle that would cover the vertex.
  double LeastCostOf(VertexId vertex, const Ring& ring, std::size_t end) const
  {
    const VertexId to = ring.End(end);
    const PlanePoint& place = this->Place(vertex);
    std::size_t n = end + 1;
    while (n + 2 < end + ring.Ends.size() && SignedArea(this->Place(to), this->Place(ring.End(n + 1)), place) > 0)
    {
      ++n;
    }
    double cost = 0.0;
    for (std::size_t horizon = 0; horizon < this->Mesh.NumberOfHorizons(); ++horizon)
    {
      const double error = this->ErrorOf(horizon, vertex, { to, ring.End(n), ring.End(n + 1) });
      cost += error <= this->Cost.LargestError ? this->Cost.Power.Raise(error) : Infinity;
    }
    return cost;
  }

  double ErrorOf(std::size_t horizon, VertexId vertex, const std::array<VertexId, 3>& corners) const
  {
    const PlanePoint& place = this->Place(vertex);
    const RaisedPoint& a = this->Mesh.Raised(horizon, corners[0]);
    const RaisedPoint& b = this->Mesh.Raised(horizon, corners[1]);
    const RaisedPoint& c = this->Mesh.Raised(horizon, corners[2]);
    const double area = double(SignedArea(a.Column, b.Column, c.Column));
    const double height = a.Height +
      ((b.Height - a.Height) * double(SignedArea(c.Column, a.Column, place)) +
        (c.Height - a.Height) * double(SignedArea(a.Column, b.Column, place))) /
        area;
    return std::abs(height - this->Mesh.ColumnHeight(horizon, vertex));
  }

  const PlanePoint& Place(VertexId vertex) const { return this->Mesh.Raised(vertex).Column; }

  void FindRing(VertexId vertex, Ring& ring) const
  {
    const PlaneMesh& mesh = this->Mesh.Triangles();
    ring.Ends.clear();
    ring.Sum = 0.0;
    ring.Sine = 1.0;
    mesh.FindRing(vertex, this->TriangleAt[vertex], ring.Triangles);
    for (const TriangleId triangle : ring.Triangles)
    {
      ring.Ends.push_back(mesh.Corner(triangle, NextCorner(mesh.CornerAt(triangle, vertex))));
      ring.Sum += this->Costs[triangle] + this->Cost.ExistingEdgeCost(this->Mesh, vertex, ring.Ends.back());
    }
    for (std::size_t n = 0; n < ring.Ends.size(); ++n)
    {
      ring.Sine =
        std::min(ring.Sine, SquaredSineOf(this->Place(vertex), this->Place(ring.End(n)), this->Place(ring.End(n + 1))));
    }
  }

  /// Angles that are too small may grow without becoming large enough.
  bool KeepsAngles(const Ring& ring, std::size_t end) const
  {
    for (std::size_t n = end + 1; n + 1 < end + ring.Ends.size(); ++n)
    {
      const double sine =
        SquaredSineOf(this->Place(ring.End(end)), this->Place(ring.End(n)), this->Place(ring.End(n + 1)));
      if (sine <= 0.0 || (!this->Cost.IsWide(sine) && sine <= ring.Sine))
      {
        return false;
      }
    }
    return true;
  }

  /// Returns infinity if the sum reaches `most`.
  double SumAt(const Ring& ring, std::size_t end, double most) const
  {
    const VertexId to = ring.End(end);
    double sum = 0.0;
    for (std::size_t n = end + 1; n + 1 < end + ring.Ends.size() && sum < most; ++n)
    {
      const bool isInner = n > end + 1; // the first edge is in the ring
      sum += this->Cost.TriangleCost(this->Mesh, { to, ring.End(n), ring.End(n + 1) }, most - sum);
      sum += isInner && sum < most ? this->Cost.EdgeCost(this->Mesh, to, ring.End(n)) : 0.0;
    }
    return sum < most ? sum : Infinity;
  }

  void RemoveAll(const std::vector<Candidate>& cheapest, std::size_t leastVertices)
  {
    this->IsChanged.assign(std::size_t(this->Mesh.Triangles().Size()), 0);
    this->Changed.clear();
    for (const Candidate& candidate : cheapest)
    {
      if (this->Mesh.NumberOfVertices() > leastVertices)
      {
        this->Remove(candidate);
      }
    }
    ParallelFor(std::int64_t(this->Changed.size()), FlipGrain,
      [this](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          const TriangleId triangle = this->Changed[n];
          this->Costs[triangle] = this->Cost.TriangleCost(this->Mesh, this->Mesh.Triangles().Corners(triangle));
        }
      });
    this->Candidates.erase(std::remove_if(this->Candidates.begin(), this->Candidates.end(),
                             [this](const Candidate& one) { return this->Mesh.IsRemoved(one.Vertex); }),
      this->Candidates.end());
  }

  /// A neighbour may have been removed in this round.
  void Remove(const Candidate& candidate)
  {
    PlaneMesh& mesh = this->Mesh.Triangles();
    std::vector<TriangleId> ring;
    mesh.FindRing(candidate.Vertex, this->TriangleAt[candidate.Vertex], ring);
    if (std::any_of(ring.begin(), ring.end(), [this](TriangleId one) { return this->IsChanged[one] != 0; }))
    {
      return;
    }
    mesh.Collapse(candidate.Vertex, ring, std::size_t(candidate.Edge));
    this->Mesh.Remove(candidate.Vertex);
    for (const TriangleId triangle : ring)
    {
      this->IsChanged[triangle] = 1;
      if (mesh.IsGone(triangle))
      {
        continue;
      }
      this->Changed.push_back(triangle);
      for (const VertexId vertex : mesh.Corners(triangle))
      {
        this->TriangleAt[vertex] = triangle;
        this->IsOld[vertex] = 1;
      }
    }
  }

  HeightMesh& Mesh;
  const MeshCost& Cost;
  std::vector<double> Costs;
  std::vector<TriangleId> TriangleAt; // by vertex: one of its triangles
  std::vector<Candidate> Candidates; // neighbours are close together
  std::vector<unsigned char> IsOld; // by vertex: its triangles have changed
  std::vector<unsigned char> IsChanged;
  std::vector<TriangleId> Changed;
};

// ---- Insertion -----------------------------------------------------------------------------------------------------
// Heights are fitted at a larger error, and move less than the error, to leave room for points that are not fitted.
constexpr double ErrorBeforeFit = 1.3;
constexpr double ReachOfFit = 0.9;

// ---- Numbers of vertices -------------------------------------------------------------------------------------------
// After this number of halvings, any angle will do.
constexpr int MostHalvings = 12;

// The stop half-way leaves this multiple of the final inner vertices. Two or three stops lower errors by 0.5 % and take
// a fifth longer.
constexpr double HalfWay = 1.5;
}

//----------------------------------------------------------------------------------------------------------------------
void InsertToError(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule)
{
  const double error = options.MaximumError;
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  if (options.FitHeights && error > 0.0)
  {
    refiner.InsertWhereFar(ErrorBeforeFit * error, monitor.Step(0.0, 0.5));
    mesh.SortByPlace();
    mesh.SetAllHeights(FitAllHeights(mesh, FitAim::LargestError, ReachOfFit * error, rule, monitor.Step(0.5, 0.6)));
  }
  refiner.InsertWhereFar(error, monitor.Step(0.6, 0.8));
  refiner.InsertAtEdges(options.MaximumCrossingError(), monitor.Step(0.8, 0.9));
  for (std::size_t before = 0; options.Effort == DecimationEffort::Fast && options.SmallestAngle > 0.0;)
  {
    before = mesh.NumberOfVertices();
    refiner.InsertAtSlivers(options.SmallestAngle);
    if (mesh.NumberOfVertices() == before)
    {
      break;
    }
    refiner.InsertWhereFar(error, monitor.Step(0.9, 0.95));
    refiner.InsertAtEdges(options.MaximumCrossingError(), monitor.Step(0.95, 1.0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ImproveWithinError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const ColumnRule& rule)
{
  mesh.SortByPlace();
  ImproveInGroups(mesh, options, rule, monitor.Step(0.0, 0.9));
  // Groups leave room for rounding, so this changes nothing; but the bound is measured before it is promised.
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  refiner.InsertWhereFar(options.MaximumError, monitor.Step(0.9, 0.95));
  refiner.InsertAtEdges(options.MaximumCrossingError(), monitor.Step(0.95, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
void ReduceToNumber(HeightMesh& mesh, std::size_t vertices, const DecimationOptions& options, const Monitor& monitor)
{
  const double largest = mesh.LargestError();
  mesh.SortByPlace();
  MeshCost cost(options.Priority, largest > 0.0 ? largest : 1.0, options.SmallestAngle);
  EdgeFlips(mesh, cost).Run(monitor.Step(0.0, 0.2));
  // A mesh flipped and fitted half-way shows better which vertices can go.
  const std::size_t onLoops = mesh.NumberOfVertices() - mesh.NumberOfInnerVertices();
  assert(vertices >= onLoops);
  const std::size_t halfWay = onLoops + std::size_t(HalfWay * double(vertices - onLoops));
  const auto improve = [&](const Monitor& step)
  {
    EdgeFlips(mesh, cost).Run(step.Step(0.0, 0.6));
    if (options.FitHeights)
    {
      FitToNumber(mesh, options.Priority, step.Step(0.6, 1.0));
    }
  };
  VertexRemoval(mesh, cost).Run(halfWay, monitor.Step(0.2, 0.5));
  improve(monitor.Step(0.5, 0.65));
  VertexRemoval(mesh, cost).Run(vertices, monitor.Step(0.65, 0.8));
  // Angles that prevent removal may become smaller.
  const double sine = cost.SmallestSine;
  for (int halving = 1; mesh.NumberOfVertices() > vertices && cost.SmallestSine > 0.0; ++halving)
  {
    cost.SmallestSine = halving < MostHalvings ? 0.5 * cost.SmallestSine : 0.0;
    const double fraction = 0.8 + 0.05 * double(halving) / (MostHalvings + 1);
    VertexRemoval(mesh, cost).Run(vertices, monitor.Step(fraction, fraction));
  }
  cost.SmallestSine = sine;
  improve(monitor.Step(0.85, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
void FlipToNumber(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const double largest = mesh.LargestError();
  mesh.SortByPlace();
  MeshCost cost(options.Priority, largest > 0.0 ? largest : 1.0, options.SmallestAngle);
  if (options.Priority == DecimationPriority::LargestError)
  {
    cost.LargestError = largest + mesh.Rounding();
  }
  EdgeFlips(mesh, cost).Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void FitToNumber(HeightMesh& mesh, DecimationPriority priority, const Monitor& monitor)
{
  mesh.Measure(mesh.AllTriangles(), ErrorPower(), 0.0, monitor.Step(0.0, 0.1));
  const double largest = mesh.LargestError();
  if (!(largest > 0.0))
  {
    return;
  }
  const bool isForLargest = priority == DecimationPriority::LargestError;
  const FitAim aim = isForLargest ? FitAim::LargestError : FitAim::Mean;
  const std::vector<InnerHeights> heights = FitAllHeights(mesh, aim, largest, HeightRule(), monitor.Step(0.1, 1.0));
  if (isForLargest)
  {
    MoveHeightsWithin(mesh, largest, heights);
    return;
  }
  const std::vector<InnerHeights> before = mesh.HeightsOf(heights.front().Vertices);
  const HeightMesh::ErrorSums sums = mesh.SumErrors(largest);
  mesh.SetAllHeights(heights);
  const HeightMesh::ErrorSums fitted = mesh.SumErrors(largest);
  if (fitted.Errors > sums.Errors || fitted.Squares > sums.Squares)
  {
    mesh.SetAllHeights(before);
  }
}
}
