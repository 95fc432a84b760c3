// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexRemoval.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// What part of the candidates a round looks at: of neighbours the cheaper one should go.
constexpr double PartOfRound = 0.25;

// How many vertices a thread tries at a time.
constexpr std::int64_t Grain = 16;

/// The triangles around a vertex, counter-clockwise, and the ends of the sides that go from it, one between each two:
/// ends[n] is between the triangles n - 1 and n.
struct Ring
{
  std::vector<TriangleId> Triangles;
  std::vector<RaisedPoint> Ends;
  double Sum = 0.0; // of the errors now

  const RaisedPoint& End(std::size_t n) const { return this->Ends[n % this->Ends.size()]; }
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
    this->Mesh.MeasureAll(this->Cost.Power, monitor.Step(0.0, 0.05));
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
    double Cost; // by how much the sum of errors grows; infinite where the vertex can not go
    PointId Point;
    std::int32_t Side; // of its ring, that is collapsed
  };

  void FindVertices()
  {
    const PlaneMesh& mesh = this->Mesh.Triangles();
    this->TriangleAt.assign(this->Mesh.VertexMarks().size(), NoTriangle);
    for (TriangleId triangle = 0; triangle < mesh.Size(); ++triangle)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->TriangleAt[std::size_t(mesh.Corner(triangle, corner))] = triangle;
      }
    }
    this->Candidates.clear();
    for (PointId point = 0; std::size_t(point) < this->TriangleAt.size(); ++point)
    {
      if (this->Mesh.IsVertex(point) && !this->Mesh.IsOnLoop(point))
      {
        this->Candidates.push_back({ Infinity, point, 0 });
      }
    }
    this->IsOld.assign(this->TriangleAt.size(), 1);
  }

  /// The cheapest of those that can go, in their order.
  std::vector<Candidate> FindCheapest() const
  {
    const auto isCheaper = [](const Candidate& a, const Candidate& b)
    { return std::tie(a.Cost, a.Point) < std::tie(b.Cost, b.Point); };
    std::vector<Candidate> possible;
    std::copy_if(this->Candidates.begin(), this->Candidates.end(), std::back_inserter(possible),
      [](const Candidate& one) { return one.Cost < Infinity; });
    const auto size = std::ptrdiff_t(std::ceil(PartOfRound * double(possible.size())));
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
    ParallelFor(std::int64_t(this->Candidates.size()), Grain,
      [this](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          Candidate& candidate = this->Candidates[std::size_t(n)];
          if (this->IsOld[std::size_t(candidate.Point)] != 0)
          {
            candidate = this->Try(candidate.Point);
            this->IsOld[std::size_t(candidate.Point)] = 0;
          }
        }
      });
  }

  Candidate Try(PointId point) const
  {
    const Ring ring = this->FindRing(point);
    Candidate best{ Infinity, point, 0 };
    for (const End& end : this->FindEnds(ring, point))
    {
      const double most = ring.Sum + best.Cost;
      const double sum = end.Least < most ? this->SumAt(ring, end.Number, most) : Infinity;
      if (sum - ring.Sum < best.Cost)
      {
        best.Cost = sum - ring.Sum;
        best.Side = std::int32_t((end.Number + ring.Ends.size() - 1) % ring.Ends.size());
      }
    }
    return best;
  }

  /// An end of a ring to which the vertex could go, and what the sum of errors is then at least: that of its own point.
  struct End
  {
    double Least;
    std::size_t Number;
  };

  /// Those with the least first: that of the best one is compared with those of the others.
  std::vector<End> FindEnds(const Ring& ring, PointId point) const
  {
    std::vector<End> ends;
    for (std::size_t end = 0; end < ring.Ends.size(); ++end)
    {
      if (this->KeepsAngles(ring, end))
      {
        const double error = this->ErrorOf(point, ring, end);
        if (error <= this->Cost.LargestError)
        {
          ends.push_back({ this->Cost.Power.Raise(error), end });
        }
      }
    }
    std::sort(ends.begin(), ends.end(),
      [](const End& a, const End& b) { return std::tie(a.Least, a.Number) < std::tie(b.Least, b.Number); });
    return ends;
  }

  /// The distance of a vertex's point from the triangle that would be there.
  double ErrorOf(PointId point, const Ring& ring, std::size_t end) const
  {
    const RaisedPoint& to = ring.End(end);
    const PlanePoint& place = this->Mesh.Raised(point).Column;
    std::size_t n = end + 1;
    while (n + 2 < end + ring.Ends.size() && SignedArea(to.Column, ring.End(n + 1).Column, place) > 0)
    {
      ++n;
    }
    const RaisedPoint& b = ring.End(n);
    const RaisedPoint& c = ring.End(n + 1);
    const double area = double(SignedArea(to.Column, b.Column, c.Column));
    const double height = to.Height +
      ((b.Height - to.Height) * double(SignedArea(c.Column, to.Column, place)) +
        (c.Height - to.Height) * double(SignedArea(to.Column, b.Column, place))) /
        area;
    return std::abs(height - this->Mesh.ColumnHeight(point));
  }

  Ring FindRing(PointId point) const
  {
    const PlaneMesh& mesh = this->Mesh.Triangles();
    Ring ring;
    mesh.FindRing(point, this->TriangleAt[std::size_t(point)], ring.Triangles);
    const HeightRaster& raster = this->Mesh.RasterOf(ring.Triangles.front());
    for (const TriangleId triangle : ring.Triangles)
    {
      ring.Ends.push_back(this->Mesh.Raised(mesh.Corner(triangle, NextCorner(mesh.CornerAt(triangle, point)))));
      ring.Sum +=
        this->Mesh.Error(triangle).Sum + this->Cost.MeasureSide(raster, this->Mesh.Raised(point), ring.Ends.back()).Sum;
    }
    return ring;
  }

  /// Whether all triangles around could have their corner at one of the ends instead.
  bool KeepsAngles(const Ring& ring, std::size_t end) const
  {
    for (std::size_t n = end + 1; n + 1 < end + ring.Ends.size(); ++n)
    {
      const double sine = MeshCost::SmallestSineOf(ring.End(end).Column, ring.End(n).Column, ring.End(n + 1).Column);
      if (sine <= 0.0 || sine < this->Cost.SmallestSine)
      {
        return false;
      }
    }
    return true;
  }

  /// What the sum of errors is then; infinite when it is not below `most`, or an error too large.
  double SumAt(const Ring& ring, std::size_t end, double most) const
  {
    const HeightRaster& raster = this->Mesh.RasterOf(ring.Triangles.front());
    double sum = 0.0;
    const auto add = [&](const HeightError& error)
    {
      sum += error.Sum;
      return error.Largest <= this->Cost.LargestError && sum < most;
    };
    const RaisedPoint& to = ring.End(end);
    for (std::size_t n = end + 1; n + 1 < end + ring.Ends.size(); ++n)
    {
      const bool isInner = n > end + 1; // the side to this end: the first one is that of the ring
      if (!add(raster.Measure({ to, ring.End(n), ring.End(n + 1) }, this->Cost.Power)) ||
        (isInner && !add(this->Cost.MeasureSide(raster, to, ring.End(n)))))
      {
        return Infinity;
      }
    }
    return sum;
  }

  /// Those of a round, until so many vertices are left.
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
    this->Mesh.Measure(this->Changed, this->Cost.Power, Monitor());
    this->Candidates.erase(std::remove_if(this->Candidates.begin(), this->Candidates.end(),
                             [this](const Candidate& one) { return !this->Mesh.IsVertex(one.Point); }),
      this->Candidates.end());
  }

  /// Unless a neighbour was removed in this round.
  void Remove(const Candidate& candidate)
  {
    PlaneMesh& mesh = this->Mesh.Triangles();
    std::vector<TriangleId> ring;
    mesh.FindRing(candidate.Point, this->TriangleAt[std::size_t(candidate.Point)], ring);
    if (std::any_of(
          ring.begin(), ring.end(), [this](TriangleId one) { return this->IsChanged[std::size_t(one)] != 0; }))
    {
      return;
    }
    mesh.Collapse(candidate.Point, ring, std::size_t(candidate.Side));
    this->Mesh.MarkVertex(candidate.Point, false);
    for (const TriangleId triangle : ring)
    {
      this->IsChanged[std::size_t(triangle)] = 1;
      for (int corner = 0; corner < 3 && !mesh.IsGone(triangle); ++corner)
      {
        const std::size_t point = std::size_t(mesh.Corner(triangle, corner));
        this->TriangleAt[point] = triangle;
        this->IsOld[point] = 1;
      }
      if (!mesh.IsGone(triangle))
      {
        this->Changed.push_back(triangle);
      }
    }
  }

  HeightMesh& Mesh;
  const MeshCost& Cost;
  std::vector<TriangleId> TriangleAt; // by point: one of its triangles
  std::vector<Candidate> Candidates; // the vertices inside, in the order of their points: those next are near
  std::vector<unsigned char> IsOld; // by point: triangles around have changed since it was tried
  std::vector<unsigned char> IsChanged; // by triangle, in one round
  std::vector<TriangleId> Changed; // in one round
};
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveVertices(HeightMesh& mesh, const MeshCost& cost, std::size_t leastVertices, const Monitor& monitor)
{
  VertexRemoval(mesh, cost).Run(leastVertices, monitor);
}
}
