// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundarySimplification.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
class LoopSimplifier
{
public:
  LoopSimplifier(
    const std::vector<SpacePoint>& points, const Loops& boundary, double threshold, BoundarySimplification& result)
    : Points(points)
    , Threshold(threshold)
    , Result(result)
    , Visits(points.size(), 0)
  {
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      std::for_each(boundary.begin(loop), boundary.end(loop), [this](PointId point) { this->CountVisit(point); });
    }
    this->Result.Target.resize(points.size());
    std::iota(this->Result.Target.begin(), this->Result.Target.end(), 0);
  }

  /// Runs may wrap around the first point of a loop, so the walk begins at a point that stays.
  void Simplify(const PointId* first, const PointId* last)
  {
    this->Loop.assign(first, last);
    const std::size_t begin = this->FirstRunEnd();
    std::vector<PointId> kept;
    for (std::size_t from = 0; from < this->Loop.size();)
    {
      std::size_t to = from + 1;
      while (to < this->Loop.size() && !this->EndsRun(begin + to))
      {
        ++to;
      }
      this->SimplifyRun(begin + from, begin + to);
      kept.insert(kept.end(), this->Run.begin(), this->Run.end() - 1);
      from = to;
    }
    this->AppendFromLeast(kept);
  }

private:
  void CountVisit(PointId point)
  {
    unsigned char& visits = this->Visits[std::size_t(point)];
    visits = static_cast<unsigned char>(std::min(visits + 1, 2));
  }

  PointId At(std::size_t n) const { return this->Loop[n % this->Loop.size()]; }

  Eigen::Vector3d Place(PointId point) const
  {
    const SpacePoint& place = this->Points[std::size_t(point)];
    return { place.X, place.Y, place.Z };
  }

  /// Boundary points stand on whole columns, so that the products below are exact, and verticals nothing special.
  bool EndsRun(std::size_t n) const
  {
    const PointId point = this->At(n);
    if (this->Visits[std::size_t(point)] > 1)
    {
      return true;
    }
    const Eigen::Vector2d here = this->Place(point).head<2>();
    const Eigen::Vector2d in = here - this->Place(this->At(n + this->Loop.size() - 1)).head<2>();
    const Eigen::Vector2d out = this->Place(this->At(n + 1)).head<2>() - here;
    return in.x() * out.y() != in.y() * out.x() || in.dot(out) <= 0.0;
  }

  /// A closed loop turns somewhere, so there always is one.
  std::size_t FirstRunEnd() const
  {
    std::size_t n = 0;
    while (n + 1 < this->Loop.size() && !this->EndsRun(n))
    {
      ++n;
    }
    return n;
  }

  void SimplifyRun(std::size_t from, std::size_t to)
  {
    this->Run.clear();
    for (std::size_t n = from; n <= to; ++n)
    {
      this->Run.push_back(this->At(n));
    }
    while (this->DropOnce())
    {
    }
    this->SettleDropped(from, to);
  }

  /// One pass over the run: after a drop it goes on from the third point, else from the middle one.
  bool DropOnce()
  {
    if (this->Run.size() < 3)
    {
      return false;
    }
    std::size_t kept = 1;
    std::size_t middle = 1;
    while (middle + 1 < this->Run.size())
    {
      if (this->DistanceToLine(this->Run[middle], this->Run[kept - 1], this->Run[middle + 1]) < this->Threshold)
      {
        ++middle;
      }
      this->Run[kept++] = this->Run[middle++];
    }
    if (middle < this->Run.size())
    {
      this->Run[kept++] = this->Run[middle];
    }
    const bool dropped = kept < this->Run.size();
    this->Run.resize(kept);
    return dropped;
  }

  double DistanceToLine(PointId point, PointId a, PointId b) const
  {
    const Eigen::Vector3d along = this->Place(b) - this->Place(a);
    return along.cross(this->Place(point) - this->Place(a)).norm() / along.norm();
  }

  /// Every dropped point counts for the nearer end, in plan, of the edge that spans it.
  void SettleDropped(std::size_t from, std::size_t to)
  {
    std::size_t edge = 0;
    for (std::size_t n = from + 1; n < to; ++n)
    {
      const PointId point = this->At(n);
      if (point == this->Run[edge + 1])
      {
        ++edge;
        continue;
      }
      const PointId a = this->Run[edge];
      const PointId b = this->Run[edge + 1];
      this->Result.Deviation = std::max(this->Result.Deviation, this->DistanceToLine(point, a, b));
      const auto distance = [&](PointId end) { return (this->Place(point) - this->Place(end)).head<2>().norm(); };
      this->Result.Target[std::size_t(point)] = distance(b) < distance(a) ? b : a;
    }
  }

  /// The point of least x, then least y is a corner and so always kept; the loop goes on to begin there.
  void AppendFromLeast(std::vector<PointId>& kept)
  {
    const auto start = std::find(kept.begin(), kept.end(), this->Loop.front());
    std::rotate(kept.begin(), start == kept.end() ? kept.begin() : start, kept.end());
    std::for_each(kept.begin(), kept.end(), [this](PointId point) { this->Result.Boundary.Append(point); });
    this->Result.Boundary.Close();
  }

  const std::vector<SpacePoint>& Points;
  const double Threshold;
  BoundarySimplification& Result;
  std::vector<unsigned char> Visits; // 0, 1 or 2 for more than one
  std::vector<PointId> Loop;
  std::vector<PointId> Run;
};
}

//----------------------------------------------------------------------------------------------------------------------
BoundarySimplification SimplifyBoundary(
  const std::vector<SpacePoint>& points, const Loops& boundary, double threshold, const Monitor& monitor)
{
  if (!(threshold >= 0.0) || !std::isfinite(threshold))
  {
    std::ostringstream text;
    text << "distance threshold " << threshold << ", expected a number of lattice units that is at least 0";
    throw InputError(text.str());
  }
  BoundarySimplification result;
  LoopSimplifier simplifier(points, boundary, threshold, result);
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    if (loop % 64 == 0)
    {
      monitor.Progress(double(loop) / double(boundary.Size()));
    }
    simplifier.Simplify(boundary.begin(loop), boundary.end(loop));
  }
  return result;
}
}
