// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: costs and angles; collapses; moves; flips.

#include "GroupMesh.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "GroupHeights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace SeismicHorizons
{
namespace
{
constexpr double Never = StarTrial::Never;

// Rounds end below this fraction of the inner vertices.
constexpr double LeastFractionOfRound = 0.01;

// Only this number of ends of a vertex is tried, those first where its own column would be nearest.
constexpr int MostEnds = 3;

// Vertices of slivers cost this fraction, so that they go early.
constexpr double FractionOfSlivers = 0.01;

// Without a minimum gain, edges of nearly equal cost flip back and forth.
constexpr double LeastGain = 1e-3;
// From this gain on, a new height is worth a look at the neighbours.
constexpr double GainThatMatters = 0.02;

/// Returns a negative number for a flat or clockwise triangle.
double SquaredSineOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const double area = double(SignedArea(a, b, c));
  if (area <= 0.0)
  {
    return -1.0;
  }
  const double ab = double(SquaredDistance(a, b));
  const double bc = double(SquaredDistance(b, c));
  const double ca = double(SquaredDistance(c, a));
  return area * area / std::max({ ab * bc, bc * ca, ca * ab });
}

/// Triangles and ends are counter-clockwise; Triangles[n] lies between ends n and n + 1.
struct Ring
{
  std::vector<TriangleId> Triangles;
  std::vector<VertexId> Ends;
};

template <typename Real>
class GroupMesh
{
public:
  GroupMesh(Group& group, const GroupOptions& options)
    : Options(options)
    , Mesh(group.Mesh)
    , Vertices(group.Vertices)
    , Heights(group, options)
    , SquaredSine(SineOfDegrees(options.SmallestAngle) * SineOfDegrees(options.SmallestAngle))
    , TriangleAt(group.Vertices.size(), NoTriangle)
    , RoomAt(group.Vertices.size(), options.MostTriangles)
    , Costs(std::size_t(group.Mesh.Size()))
    , IsChanged(std::size_t(group.Mesh.Size()))
  {
    this->Heights.SetPower(options.Power);
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      this->Costs[triangle] = this->Heights.CostOf(this->Mesh.Corners(triangle), false);
      for (int corner = 0; corner < 3; ++corner)
      {
        GroupVertex& vertex = this->Vertices[this->Mesh.Corner(triangle, corner)];
        this->TriangleAt[this->Mesh.Corner(triangle, corner)] = triangle;
        this->IsChanged[triangle] |= vertex.Marks;
        --this->RoomAt[this->Mesh.Corner(triangle, corner)];
        if (this->Mesh.Neighbour(triangle, corner) == NoTriangle)
        {
          this->SetBetween(this->Mesh.Corner(triangle, corner));
          this->SetBetween(this->Mesh.Corner(triangle, NextCorner(corner)));
        }
      }
    }
  }

  void Run(const std::vector<GroupStep>& steps, int mostRounds)
  {
    const bool isToRemove = std::find(steps.begin(), steps.end(), GroupStep::Collapse) != steps.end();
    std::size_t before = CountInner(this->Vertices);
    for (int round = 0; round < mostRounds; ++round)
    {
      for (const GroupStep step : steps)
      {
        this->Do(step);
      }
      const std::size_t left = CountInner(this->Vertices);
      if (isToRemove && double(before - left) < LeastFractionOfRound * double(left))
      {
        break;
      }
      before = left;
    }
    this->Mesh.Compact();
  }

private:
  struct Candidate
  {
    double Cost = Never; // growth of the sum
    VertexId To = NoVertex;
    PlanePoint Place = { 0, 0 };
  };

  /// How far the column of a vertex would be from the triangle that an end would give it.
  struct End
  {
    double Error;
    std::size_t Number;
  };

  /// Two groups have half of the room each.
  void SetBetween(VertexId vertex)
  {
    this->RoomAt[vertex] -= this->Vertices[vertex].IsFixed ? 0 : this->Options.MostTriangles / 2;
    this->Vertices[vertex].IsFixed = true;
  }

  void Do(GroupStep step)
  {
    switch (step)
    {
      case GroupStep::Collapse:
        this->CollapseAll();
        break;
      case GroupStep::CollapseChosen:
        this->CollapseChosen();
        break;
      case GroupStep::FindCosts:
        this->FindCosts();
        break;
      case GroupStep::Move:
        this->MoveAll();
        break;
      case GroupStep::Flip:
        this->FlipAll();
        break;
      case GroupStep::FitSquares:
        this->FitSquares();
        break;
    }
  }

  const PlanePoint& Place(VertexId vertex) const { return this->Mesh.Place(vertex); }

  void FindRing(VertexId vertex, Ring& ring) const
  {
    this->Mesh.FindRing(vertex, this->TriangleAt[vertex], ring.Triangles);
    ring.Ends.clear();
    for (const TriangleId triangle : ring.Triangles)
    {
      ring.Ends.push_back(this->Mesh.Corner(triangle, NextCorner(this->Mesh.CornerAt(triangle, vertex))));
    }
  }

  // ---- Costs and angles --------------------------------------------------------------------------------------------
  /// The column of the vertex counts once.
  double CostOf(VertexId vertex, const Ring& ring) const
  {
    double cost = (1.0 - double(ring.Triangles.size())) * this->Heights.OwnCost(vertex);
    for (const TriangleId triangle : ring.Triangles)
    {
      cost += this->Costs[triangle];
    }
    return cost;
  }

  void SetChanged(TriangleId triangle)
  {
    this->Costs[triangle] = this->Heights.CostOf(this->Mesh.Corners(triangle), false);
    this->IsChanged[triangle] = 1;
  }

  /// Of the smallest angle of a star; negative if the place does not see the whole ring.
  double SineOf(const PlanePoint& place, const std::vector<VertexId>& ring, bool isClosed) const
  {
    double least = 1.0;
    for (std::size_t n = 0; n + (isClosed ? 0 : 1) < ring.size() && least > 0.0; ++n)
    {
      const VertexId next = ring[n + 1 == ring.size() ? 0 : n + 1];
      least = std::min(least, SquaredSineOf(place, this->Place(ring[n]), this->Place(next)));
    }
    return least;
  }

  bool KeepsAngles(double squaredSine, double before) const
  {
    return squaredSine > 0.0 && (squaredSine >= this->SquaredSine || squaredSine >= before);
  }

  // ---- Collapses ---------------------------------------------------------------------------------------------------
  /// Vertices go in the order of their numbers: if the cheapest went first, as many would be left, in twice the time.
  void CollapseAll()
  {
    bool isAny = true;
    while (isAny)
    {
      isAny = false;
      for (VertexId vertex = 0; vertex < VertexId(this->Vertices.size()); ++vertex)
      {
        std::uint8_t& marks = this->Vertices[vertex].Marks;
        if (this->Vertices[vertex].IsInner() && (marks & TryCollapse) != 0)
        {
          marks &= std::uint8_t(~TryCollapse);
          isAny = this->CollapseWithin(Never, vertex) || isAny;
        }
      }
    }
  }

  void CollapseChosen()
  {
    const double most = this->Options.MostCost + LeastGain * std::abs(this->Options.MostCost); // of another group
    for (VertexId vertex = 0; vertex < VertexId(this->Vertices.size()); ++vertex)
    {
      if (this->Vertices[vertex].IsInner() && this->Vertices[vertex].IsChosen)
      {
        this->CollapseWithin(most, vertex);
      }
    }
  }

  void FindCosts()
  {
    for (VertexId vertex = 0; vertex < VertexId(this->Vertices.size()); ++vertex)
    {
      GroupVertex& own = this->Vertices[vertex];
      if (own.IsInner() && (own.Marks & TryCollapse) != 0)
      {
        own.Marks &= std::uint8_t(~TryCollapse);
        own.Cost = this->FindBest(vertex).Cost;
      }
    }
  }

  bool CollapseWithin(double most, VertexId vertex)
  {
    const Candidate best = this->FindBest(vertex);
    if (best.To == NoVertex || best.Cost > most)
    {
      this->Vertices[vertex].Cost = best.Cost;
      return false;
    }
    this->CollapseTo(vertex, best);
    return true;
  }

  Candidate FindBest(VertexId vertex)
  {
    this->FindRing(vertex, this->Own);
    this->FindEnds(vertex);
    const double sine = this->SineOf(this->Place(vertex), this->Own.Ends, true);
    Candidate best;
    int tried = 0;
    for (std::size_t n = 0; n < this->Ends.size() && tried < MostEnds; ++n)
    {
      const bool isFixed = this->Vertices[this->Own.Ends[this->Ends[n].Number]].IsFixed;
      const bool isTried = isFixed ? this->TryFixedEnd(vertex, this->Ends[n].Number, sine, best)
                                   : this->TryFreeEnd(vertex, this->Ends[n].Number, sine, best);
      tried += isTried ? 1 : 0;
    }
    const bool isSliver = sine < this->SquaredSine && best.Cost > 0.0;
    best.Cost *= isSliver && best.To != NoVertex ? FractionOfSlivers : 1.0;
    return best;
  }

  void FindEnds(VertexId vertex)
  {
    const std::vector<VertexId>& ends = this->Own.Ends;
    const std::size_t size = ends.size();
    const auto end = [&](std::size_t n) { return ends[n < size ? n : n - size]; };
    this->Ends.clear();
    for (std::size_t n = 0; n < size; ++n)
    {
      std::size_t other = n + 1;
      while (
        other + 2 < n + size && SignedArea(this->Place(end(n)), this->Place(end(other + 1)), this->Place(vertex)) > 0)
      {
        ++other;
      }
      this->Ends.push_back({ this->DistanceFrom(vertex, { end(n), end(other), end(other + 1) }), n });
    }
    std::sort(this->Ends.begin(), this->Ends.end(),
      [](const End& a, const End& b) { return a.Error != b.Error ? a.Error < b.Error : a.Number < b.Number; });
  }

  double DistanceFrom(VertexId vertex, const std::array<VertexId, 3>& corners) const
  {
    const auto& [a, b, c] = corners;
    const double area = double(SignedArea(this->Place(a), this->Place(b), this->Place(c)));
    if (area <= 0.0)
    {
      return Never;
    }
    const double ofB = double(SignedArea(this->Place(c), this->Place(a), this->Place(vertex))) / area;
    const double ofC = double(SignedArea(this->Place(a), this->Place(b), this->Place(vertex))) / area;
    double distance = 0.0;
    for (std::size_t horizon = 0; horizon < this->Heights.Size(); ++horizon)
    {
      const double height = this->Heights.Height(horizon, a);
      distance += std::abs(height + ofB * (this->Heights.Height(horizon, b) - height) +
        ofC * (this->Heights.Height(horizon, c) - height) - this->Heights.Height(horizon, vertex));
    }
    return distance;
  }

  /// Sets the outline to the ring without an end.
  void CutRing(std::size_t end)
  {
    this->Outline.clear();
    for (std::size_t n = 1; n < this->Own.Ends.size(); ++n)
    {
      this->Outline.push_back(this->Own.Ends[(end + n) % this->Own.Ends.size()]);
    }
  }

  /// Returns false if angles forbid it.
  bool TryFixedEnd(VertexId vertex, std::size_t end, double sineBefore, Candidate& best)
  {
    const VertexId to = this->Own.Ends[end];
    this->CutRing(end);
    const int more = int(this->Own.Ends.size()) - 4;
    if (more > std::max(0, this->RoomAt[to]) ||
      !this->KeepsAngles(this->SineOf(this->Place(to), this->Outline, false), sineBefore))
    {
      return false;
    }
    StarTrial trial;
    trial.Place = this->Place(to);
    trial.IsClosed = false;
    trial.IsFree = false;
    trial.Owner = vertex;
    this->Heights.GetHeights(to, this->TrialHeights);
    this->Try(trial, to, this->CostOf(vertex, this->Own), best);
    return true;
  }

  void Try(StarTrial& trial, VertexId to, double before, Candidate& best)
  {
    trial.Ring = &this->Outline;
    trial.Most = before + best.Cost;
    const double cost = this->Heights.Try(trial, this->TrialHeights);
    if (cost < Never)
    {
      best = { cost - before, to, trial.Place };
      this->BestHeights = this->TrialHeights;
    }
  }

  /// The end stays in its column or moves half-way.
  bool TryFreeEnd(VertexId vertex, std::size_t end, double sineOfVertex, Candidate& best)
  {
    const VertexId to = this->Own.Ends[end];
    this->FindRing(to, this->Other);
    const std::vector<VertexId>& others = this->Other.Ends;
    const auto back = std::size_t(std::find(others.begin(), others.end(), vertex) - others.begin());
    this->CutRing(end);
    for (std::size_t n = 2; n + 1 < others.size(); ++n)
    {
      this->Outline.push_back(others[(back + n) % others.size()]);
    }
    if (int(this->Outline.size()) > std::max(this->Options.MostTriangles, int(others.size())))
    {
      return false;
    }
    const double shared = this->Costs[this->Own.Triangles[end]] +
      this->Costs[this->Own.Triangles[end == 0 ? this->Own.Triangles.size() - 1 : end - 1]];
    const double before = this->CostOf(vertex, this->Own) + this->CostOf(to, this->Other) - shared;
    const double sineBefore = std::min(sineOfVertex, this->SineOf(this->Place(to), others, true));
    const PlanePoint& from = this->Place(vertex);
    const PlanePoint& there = this->Place(to);
    bool isTried = this->TryAt(there, vertex, to, before, sineBefore, best);
    const PlanePoint middle = { (from.X + there.X) / 2, (from.Y + there.Y) / 2 };
    if (middle != from && middle != there)
    {
      isTried = this->TryAt(middle, vertex, to, before, sineBefore, best) || isTried;
    }
    return isTried;
  }

  bool TryAt(const PlanePoint& place, VertexId vertex, VertexId to, double before, double sineBefore, Candidate& best)
  {
    if (!this->KeepsAngles(this->SineOf(place, this->Outline, true), sineBefore) || !this->SetStart(place, vertex, to))
    {
      return false;
    }
    StarTrial trial;
    trial.Place = place;
    trial.IsFree = this->Options.FitHeights;
    trial.Owner = vertex;
    trial.Other = to;
    this->Try(trial, to, before, best);
    return true;
  }

  /// Returns false where no vertex may be.
  bool SetStart(const PlanePoint& place, VertexId vertex, VertexId to)
  {
    this->Heights.GetHeights(to, this->TrialHeights);
    if (place == this->Place(to))
    {
      return true;
    }
    if (!this->Options.FitHeights)
    {
      return this->Heights.CanBeAt(place) && this->Heights.GetColumn(place, this->TrialHeights);
    }
    for (std::size_t horizon = 0; horizon < this->TrialHeights.size(); ++horizon)
    {
      this->TrialHeights[horizon] = 0.5 * (this->TrialHeights[horizon] + this->Heights.Height(horizon, vertex));
    }
    return this->Heights.CanBeAt(place);
  }

  void CollapseTo(VertexId vertex, const Candidate& candidate)
  {
    const VertexId to = candidate.To;
    const std::vector<VertexId>& ends = this->Own.Ends;
    const auto n = std::size_t(std::find(ends.begin(), ends.end(), to) - ends.begin());
    this->RoomAt[to] -= int(ends.size()) - 4;
    ++this->RoomAt[ends[(n + 1) % ends.size()]];
    ++this->RoomAt[ends[(n + ends.size() - 1) % ends.size()]];
    this->Mesh.Collapse(vertex, this->Own.Triangles, (n + ends.size() - 1) % ends.size());
    this->Vertices[vertex].IsGone = true;
    for (const TriangleId triangle : this->Own.Triangles)
    {
      this->TriangleAt[to] = this->Mesh.IsGone(triangle) ? this->TriangleAt[to] : triangle;
    }
    if (!this->Vertices[to].IsFixed)
    {
      this->Mesh.MoveTo(to, candidate.Place);
      this->Heights.SetHeights(to, this->BestHeights);
      this->Heights.Inherit(vertex, to);
      this->FindRing(to, this->Own);
    }
    for (const TriangleId triangle : this->Own.Triangles)
    {
      if (!this->Mesh.IsGone(triangle))
      {
        this->SetChanged(triangle);
        for (const VertexId corner : this->Mesh.Corners(triangle))
        {
          this->TriangleAt[corner] = triangle;
          this->Vertices[corner].Marks = TryAll;
        }
      }
    }
  }

  // ---- Moves -------------------------------------------------------------------------------------------------------
  void MoveAll()
  {
    for (VertexId vertex = 0; vertex < VertexId(this->Vertices.size()); ++vertex)
    {
      std::uint8_t& marks = this->Vertices[vertex].Marks;
      if (this->Vertices[vertex].IsInner() && (marks & TryMove) != 0)
      {
        marks &= std::uint8_t(~TryMove);
        this->Move(vertex);
      }
    }
  }

  /// To the next column that lowers the cost most, along one axis; or only to another height.
  void Move(VertexId vertex)
  {
    this->FindRing(vertex, this->Own);
    const PlanePoint start = this->Place(vertex);
    StarTrial trial;
    trial.Place = start;
    trial.Ring = &this->Own.Ends;
    trial.IsFree = this->Options.FitHeights;
    this->Heights.GetHeights(vertex, this->TrialHeights);
    double least = this->Heights.Try(trial, this->TrialHeights);
    if (!(least < Never))
    {
      return;
    }
    this->BestHeights = this->TrialHeights;
    trial.Owner = vertex;
    PlanePoint best = start;
    const double sine = this->SineOf(start, this->Own.Ends, true);
    for (const PlanePoint& place : this->PlacesDown(start))
    {
      trial.Place = place;
      trial.Most = (1.0 - LeastGain) * least;
      this->TrialHeights = this->BestHeights;
      const bool isPossible = this->Heights.CanBeAt(place) &&
        this->KeepsAngles(this->SineOf(place, this->Own.Ends, true), sine) &&
        (this->Options.FitHeights || this->Heights.GetColumn(place, this->TrialHeights));
      const double cost = isPossible ? this->Heights.Try(trial, this->TrialHeights) : Never;
      if (cost < Never)
      {
        least = cost;
        best = place;
        this->BestHeights = this->TrialHeights;
      }
    }
    this->MoveTo(vertex, best, least);
  }

  std::array<PlanePoint, 2> PlacesDown(const PlanePoint& start) const
  {
    const auto [x, y] = this->Heights.Descent();
    const PlanePoint alongX = { start.X + (x > 0.0 ? 1 : -1), start.Y };
    const PlanePoint alongY = { start.X, start.Y + (y > 0.0 ? 1 : -1) };
    return std::abs(x) > std::abs(y) ? std::array<PlanePoint, 2>{ alongX, alongY }
                                     : std::array<PlanePoint, 2>{ alongY, alongX };
  }

  void MoveTo(VertexId vertex, const PlanePoint& place, double cost)
  {
    const double before = this->CostOf(vertex, this->Own);
    const bool isMoved = place != this->Place(vertex);
    if (!isMoved && !(cost < (1.0 - LeastGain) * before))
    {
      return;
    }
    this->Mesh.MoveTo(vertex, place);
    this->Heights.SetHeights(vertex, this->BestHeights);
    std::for_each(this->Own.Triangles.begin(), this->Own.Triangles.end(),
      [this](TriangleId triangle) { this->SetChanged(triangle); });
    const bool matters = isMoved || cost < (1.0 - GainThatMatters) * before;
    std::for_each(this->Own.Ends.begin(), this->Own.Ends.end(),
      [&](VertexId end) { this->Vertices[end].Marks |= matters ? TryAll : 0; });
    this->Vertices[vertex].Marks |= isMoved ? TryAll : TryCollapse;
  }

  /// Lowers the sum of squares as far as the error allows, one height after the other.
  void FitSquares()
  {
    this->Heights.SetPower(2);
    for (VertexId vertex = 0; vertex < VertexId(this->Vertices.size()); ++vertex)
    {
      if (this->Vertices[vertex].IsInner() && this->Options.FitHeights)
      {
        this->FindRing(vertex, this->Own);
        StarTrial trial;
        trial.Place = this->Place(vertex);
        trial.Ring = &this->Own.Ends;
        this->Heights.GetHeights(vertex, this->TrialHeights);
        if (this->Heights.Try(trial, this->TrialHeights) < Never)
        {
          this->Heights.SetHeights(vertex, this->TrialHeights);
        }
      }
    }
    this->Heights.SetPower(this->Options.Power);
  }

  // ---- Flips -------------------------------------------------------------------------------------------------------
  void FlipAll()
  {
    std::vector<TriangleId> open;
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      if (!this->Mesh.IsGone(triangle) && this->IsChanged[triangle] != 0)
      {
        open.push_back(triangle);
      }
    }
    std::vector<unsigned char> isOpen(this->IsChanged.size(), 0);
    std::for_each(open.begin(), open.end(), [&](TriangleId triangle) { isOpen[triangle] = 1; });
    for (std::size_t n = 0; n < open.size(); ++n)
    {
      const TriangleId triangle = open[n];
      isOpen[triangle] = 0;
      for (int edge = 0; edge < 3; ++edge)
      {
        const TriangleId other = this->Mesh.Neighbour(triangle, edge);
        const bool isLater = other != NoTriangle && isOpen[other] != 0 && other < triangle;
        if (other == NoTriangle || isLater || !this->Flip(triangle, edge))
        {
          continue;
        }
        for (const TriangleId changed : { triangle, other })
        {
          if (isOpen[changed] == 0)
          {
            isOpen[changed] = 1;
            open.push_back(changed);
          }
        }
        break;
      }
    }
    std::fill(this->IsChanged.begin(), this->IsChanged.end(), 0);
  }

  /// Triangles a, b, c and b, a, d become a, d, c and d, b, c, if that costs less, or a or b has too many.
  bool Flip(TriangleId triangle, int edge)
  {
    const TriangleId other = this->Mesh.Neighbour(triangle, edge);
    const VertexId a = this->Mesh.Corner(triangle, edge);
    const VertexId b = this->Mesh.Corner(triangle, NextCorner(edge));
    const VertexId c = this->Mesh.Corner(triangle, PreviousCorner(edge));
    const VertexId d = this->Mesh.Beyond(triangle, edge);
    const auto sineOf = [this](VertexId p, VertexId q, VertexId r)
    { return SquaredSineOf(this->Place(p), this->Place(q), this->Place(r)); };
    if (!this->KeepsAngles(std::min(sineOf(a, d, c), sineOf(d, b, c)), std::min(sineOf(a, b, c), sineOf(b, a, d))) ||
      this->Mesh.IsKept(a, b) || std::min(this->RoomAt[c], this->RoomAt[d]) < 1)
    {
      return false;
    }
    const bool areTooMany = std::min(this->RoomAt[a], this->RoomAt[b]) < 0;
    const double most = areTooMany ? Never : (1.0 - LeastGain) * (this->Costs[triangle] + this->Costs[other]);
    const double one = this->Heights.CostOf({ a, d, c }, true, most);
    const double two = one < most ? this->Heights.CostOf({ d, b, c }, true, most - one) : Never;
    if (!(one + two < most) || !this->Heights.IsEdgeWithin(c, d))
    {
      return false;
    }
    this->Mesh.Flip(triangle, edge);
    --this->RoomAt[c];
    --this->RoomAt[d];
    ++this->RoomAt[a];
    ++this->RoomAt[b];
    this->Costs[triangle] = one;
    this->Costs[other] = two;
    for (const VertexId corner : { a, b, c, d })
    {
      this->TriangleAt[corner] = corner == b ? other : triangle;
      this->Vertices[corner].Marks = TryAll;
    }
    return true;
  }

  const GroupOptions Options;
  PlaneMesh& Mesh;
  std::vector<GroupVertex>& Vertices;
  GroupHeights<Real> Heights;
  const double SquaredSine;
  std::vector<TriangleId> TriangleAt; // by vertex: one of its triangles
  std::vector<int> RoomAt; // by vertex: for how many more triangles
  std::vector<double> Costs; // by triangle
  std::vector<unsigned char> IsChanged; // by triangle: since the last flips
  // Of the vertex that is looked at:
  Ring Own;
  Ring Other; // of the other end
  std::vector<End> Ends;
  std::vector<VertexId> Outline; // of the star after a collapse
  std::vector<double> TrialHeights;
  std::vector<double> BestHeights;
};
}

//----------------------------------------------------------------------------------------------------------------------
void ImproveGroup(Group& group, const GroupOptions& options, const std::vector<GroupStep>& steps, int mostRounds)
{
  if (GroupHeights<float>::IsEnough(group, options.Error))
  {
    GroupMesh<float>(group, options).Run(steps, mostRounds);
  }
  else
  {
    GroupMesh<double>(group, options).Run(steps, mostRounds);
  }
}
}
