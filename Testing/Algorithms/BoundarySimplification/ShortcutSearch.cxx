// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShortcutSearch.h"

#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <cmath>

using namespace SeismicHorizons;

namespace
{
constexpr double Rounding = 1e-9;
}

//----------------------------------------------------------------------------------------------------------------------
ShortcutSearch::ShortcutSearch(const BoundedHorizon& horizon, double tolerance, double threshold)
  : Horizon(horizon)
  , Tolerance(tolerance)
  , Threshold(threshold)
{
  horizon.Boundary.ForEachPoint([this](PointId point) { ++this->Visits[point]; });
}

//----------------------------------------------------------------------------------------------------------------------
/// A whole loop from one of its positions back to it.
ShortcutSearch::Ids ShortcutSearch::Around(std::size_t loop, std::size_t first) const
{
  Ids chain(this->Horizon.Boundary.begin(loop), this->Horizon.Boundary.end(loop));
  std::rotate(chain.begin(), chain.begin() + std::ptrdiff_t(first), chain.end());
  chain.push_back(chain.front());
  return chain;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ShortcutSearch::CheckLoop(std::size_t loop, const Loops& others, std::size_t other) const
{
  const PointId* const begin = this->Horizon.Boundary.begin(loop);
  const PointId* const end = this->Horizon.Boundary.end(loop);
  // A loop begins anywhere, also at a point that it visits again: so at the visit that leaves the rest in order.
  for (const PointId* first = std::find(begin, end, *others.begin(other)); first != end;
       first = std::find(first + 1, end, *others.begin(other)))
  {
    const Ids chain = this->Around(loop, std::size_t(first - begin));
    Ids kept(others.begin(other), others.end(other));
    kept.push_back(kept.front());
    std::size_t next = 1;
    std::size_t from = 0;
    bool isFine = true;
    for (std::size_t n = 1; n < chain.size() && next < kept.size(); ++n)
    {
      const bool isLast = next + 1 == kept.size();
      if (chain[n] == kept[next] && (!isLast || n + 1 == chain.size()))
      {
        isFine = isFine &&
          this->MayTakePlace(Ids(chain.begin() + std::ptrdiff_t(from), chain.begin() + std::ptrdiff_t(n) + 1));
        from = n;
        ++next;
      }
      else
      {
        isFine = isFine && !this->IsFixed(chain[n]);
      }
    }
    if (isFine && next == kept.size() && (kept.size() > 3 || chain.size() == kept.size()))
    {
      return {};
    }
  }
  return "loop " + std::to_string(loop) + " is not made of edges that may be";
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutSearch::MayTakePlace(const Ids& chain) const
{
  if (chain.size() == 2)
  {
    return true;
  }
  // Two loops could have the same edge, unless it has points of the chain on it.
  const auto isOnEdge = [&](PointId point)
  {
    const PlanePoint& a = this->Horizon.Plane[std::size_t(chain.front())];
    const PlanePoint& b = this->Horizon.Plane[std::size_t(chain.back())];
    return OnOpenSegment(a, b, this->Horizon.Plane[std::size_t(point)]);
  };
  const bool isNew = !this->IsFixed(chain.front()) || !this->IsFixed(chain.back()) ||
    std::all_of(chain.begin() + 1, chain.end() - 1, isOnEdge);
  return isNew && chain.front() != chain.back() && this->IsNear(chain) && !this->SweepsOver(chain);
}

//----------------------------------------------------------------------------------------------------------------------
bool ShortcutSearch::IsNear(const Ids& chain) const
{
  const auto place = [this](PointId point, double& x, double& y, double& z)
  {
    x = double(this->Horizon.Plane[std::size_t(point)].X) / this->Horizon.SubVoxelsPerColumn;
    y = double(this->Horizon.Plane[std::size_t(point)].Y) / this->Horizon.SubVoxelsPerColumn;
    z = this->Horizon.Height[std::size_t(point)];
  };
  double a[3];
  double b[3];
  place(chain.front(), a[0], a[1], a[2]);
  place(chain.back(), b[0], b[1], b[2]);
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  return std::all_of(chain.begin() + 1, chain.end() - 1,
    [&](PointId point)
    {
      double p[3];
      place(point, p[0], p[1], p[2]);
      const double along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length;
      const double part = std::clamp(along / length, 0.0, 1.0);
      const double off = std::hypot(a[0] + part * (b[0] - a[0]) - p[0], a[1] + part * (b[1] - a[1]) - p[1]);
      return off <= this->Tolerance + Rounding &&
        std::abs(a[2] + part * (b[2] - a[2]) - p[2]) <= this->Threshold + Rounding;
    });
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether a point that is not of the chain lies on the edge between its ends, or between both.
bool ShortcutSearch::SweepsOver(const Ids& chain) const
{
  const PlanePoint& a = this->Horizon.Plane[std::size_t(chain.front())];
  const PlanePoint& b = this->Horizon.Plane[std::size_t(chain.back())];
  for (PointId point = 0; point < PointId(this->Horizon.Plane.size()); ++point)
  {
    const PlanePoint& place = this->Horizon.Plane[std::size_t(point)];
    if (std::find(chain.begin(), chain.end(), point) == chain.end() &&
      (OnOpenSegment(a, b, place) || this->IsSwept(chain, place)))
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether the chain and the edge back turn around a place, by the angles of its edges seen from there.
bool ShortcutSearch::IsSwept(const Ids& chain, const PlanePoint& place) const
{
  double turn = 0.0;
  for (std::size_t n = 0; n < chain.size(); ++n)
  {
    const PlanePoint& from = this->Horizon.Plane[std::size_t(chain[n])];
    const PlanePoint& to = this->Horizon.Plane[std::size_t(chain[n + 1 < chain.size() ? n + 1 : 0])];
    turn += std::atan2(double(SignedArea(place, from, to)), double(ScalarProduct(place, from, to)));
  }
  return std::abs(turn) > 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> ShortcutSearch::LeastPoints(std::size_t loop) const
{
  const Ids points = this->Around(loop, 0);
  const auto fixed = std::find_if(points.begin(), points.end(), [this](PointId point) { return this->IsFixed(point); });
  std::vector<std::size_t> least;
  for (std::size_t first = 0; first + 1 < points.size(); ++first)
  {
    least.push_back(fixed == points.end() ? this->LeastEdges(this->Around(loop, first)) : 0);
  }
  if (fixed != points.end())
  {
    // Chain by chain, whichever point is chosen.
    const Ids whole = this->Around(loop, std::size_t(fixed - points.begin()));
    std::size_t edges = 0;
    for (auto from = whole.begin(); from + 1 != whole.end();)
    {
      const auto to = std::find_if(from + 1, whole.end(), [this](PointId point) { return this->IsFixed(point); });
      edges += this->LeastEdges(Ids(from, to + 1));
      from = to;
    }
    least.assign(least.size(), edges);
  }
  return least;
}

//----------------------------------------------------------------------------------------------------------------------
/// By the number of edges: which points can be reached with so many.
std::size_t ShortcutSearch::LeastEdges(const Ids& chain) const
{
  std::vector<std::vector<std::size_t>> next(chain.size());
  for (std::size_t from = 0; from < chain.size(); ++from)
  {
    for (std::size_t to = from + 1; to < chain.size(); ++to)
    {
      const Ids part(chain.begin() + std::ptrdiff_t(from), chain.begin() + std::ptrdiff_t(to) + 1);
      if (this->MayTakePlace(part))
      {
        next[from].push_back(to);
      }
    }
  }
  std::vector<bool> reached(chain.size(), false);
  reached[0] = true;
  for (std::size_t edges = 1;; ++edges)
  {
    std::vector<bool> further(chain.size(), false);
    for (std::size_t from = 0; from < chain.size(); ++from)
    {
      for (const std::size_t to : next[from])
      {
        further[to] = further[to] || reached[from];
      }
    }
    const std::size_t leastEdges = chain.front() == chain.back() ? 3 : 1;
    if (further.back() && edges >= std::min(leastEdges, chain.size() - 1))
    {
      return edges;
    }
    reached = further;
  }
}
