// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Targets of the decimation, and what must be true of its results, found by trying all triangles at all columns.

#ifndef SeismicHorizonsDecimationChecker_h
#define SeismicHorizonsDecimationChecker_h

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/ExactPlane.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"
#include "Tools/TriangleSets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace DecimationChecker
{
using namespace SeismicHorizons;
using TriangleSets::Canonical;
using TriangleSets::Triangle;

inline DecimationOptions Within(double error, bool fitHeights = false)
{
  DecimationOptions options;
  options.MaximumError = error;
  options.FitHeights = fitHeights;
  options.Effort = DecimationEffort::Fast;
  return options;
}

inline DecimationOptions AtMost(std::size_t points, bool fitHeights = false)
{
  DecimationOptions options = Within(0.0, fitHeights);
  options.MaximumNumberOfPoints = points;
  return options;
}

inline DecimationOptions Best(DecimationOptions options, double smallestAngle = 2.0)
{
  options.Effort = DecimationEffort::Best;
  options.SmallestAngle = smallestAngle;
  return options;
}
/// The result beside the horizon it was made of, both in whole columns.
class Checker
{
public:
  Checker(const BoundedHorizon& horizon, const Decimation& decimation)
    : Horizon(horizon)
    , Result(decimation)
    , Triangles(Canonical(
        decimation.Triangles, [&decimation](PointId vertex) { return decimation.Points.Source[std::size_t(vertex)]; }))
    , Heights(horizon.Height)
  {
    for (std::size_t vertex = 0; vertex < decimation.Points.Source.size(); ++vertex)
    {
      this->Heights[std::size_t(decimation.Points.Source[vertex])] = decimation.Points.Height[vertex];
    }
    for (const PlanePoint& place : horizon.Plane)
    {
      this->PointAt[{ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn }] =
        PointId(this->Columns.size());
      this->Columns.push_back({ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn });
    }
  }

  /// What is wrong; empty when nothing is.
  std::string Check(double bound, MeshChecker::Kind kind) const
  {
    const BoundedHorizon reduced = TestHorizons::Reduce(this->Horizon, this->Result.Points);
    const std::string mesh = MeshChecker::CheckMesh(reduced, this->Result.Triangles, kind);
    if (!mesh.empty())
    {
      return mesh;
    }
    if (kind == MeshChecker::Kind::Delaunay &&
      Canonical(this->Result.Triangles) != Canonical(Triangulate(reduced).Triangles))
    {
      return "not the mesh of the triangulation";
    }
    const std::string columns = this->CheckColumns(bound);
    return columns.empty() ? this->CheckSides(bound) : columns;
  }

private:
  double Area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) const
  {
    return double(ExactPlane::Cross({ b.X - a.X, b.Y - a.Y }, { c.X - a.X, c.Y - a.Y }));
  }

  const PlanePoint& At(PointId point) const { return this->Columns[std::size_t(point)]; }
  double Height(PointId point) const { return this->Horizon.Height[std::size_t(point)]; }
  double MeshHeight(PointId point) const { return this->Heights[std::size_t(point)]; }

  std::string CheckColumns(double bound) const
  {
    double largest = 0.0;
    double sum = 0.0;
    std::vector<bool> covered(this->Columns.size(), false);
    for (const Triangle& t : this->Triangles)
    {
      for (std::size_t point = 0; point < this->Columns.size(); ++point)
      {
        const PlanePoint& p = this->Columns[point];
        const double a = this->Area(this->At(t[1]), this->At(t[2]), p);
        const double b = this->Area(this->At(t[2]), this->At(t[0]), p);
        const double c = this->Area(this->At(t[0]), this->At(t[1]), p);
        if (a >= 0.0 && b >= 0.0 && c >= 0.0)
        {
          const double height =
            (a * this->MeshHeight(t[0]) + b * this->MeshHeight(t[1]) + c * this->MeshHeight(t[2])) / (a + b + c);
          const double error = std::abs(height - this->Horizon.Height[point]);
          largest = std::max(largest, error);
          sum += covered[point] ? 0.0 : error; // of several triangles, which meet there, the first one
          covered[point] = true;
        }
      }
    }
    std::ostringstream text;
    if (largest > bound + 1e-9 || std::abs(largest - this->Result.LargestError) > 1e-9)
    {
      text << "largest error " << largest << ", said " << this->Result.LargestError << ", bound " << bound;
    }
    const double mean = sum / double(std::max(this->Columns.size(), std::size_t(1)));
    if (std::abs(mean - this->Result.MeanError) > 1e-9)
    {
      text << "mean error " << mean << ", said " << this->Result.MeanError;
    }
    return text.str();
  }

  std::string CheckSides(double bound) const
  {
    std::map<std::pair<PointId, PointId>, int> sides;
    for (const Triangle& t : this->Triangles)
    {
      for (std::size_t n = 0; n < 3; ++n)
      {
        ++sides[std::minmax({ t[n], t[(n + 1) % 3] })];
      }
    }
    double largest = 0.0;
    for (const auto& side : sides)
    {
      if (side.second == 2)
      {
        largest = std::max(largest, this->LargestAlong(side.first.first, side.first.second, &PlanePoint::X));
        largest = std::max(largest, this->LargestAlong(side.first.first, side.first.second, &PlanePoint::Y));
      }
    }
    return largest > bound + 1e-9 ? "a side is " + std::to_string(largest) + " off" : std::string();
  }

  /// Where a side crosses the lattice lines of one kind between two points.
  double LargestAlong(PointId from, PointId to, std::int32_t PlanePoint::*axis) const
  {
    const auto across = axis == &PlanePoint::X ? &PlanePoint::Y : &PlanePoint::X;
    const PlanePoint& a = this->At(from);
    const PlanePoint& b = this->At(to);
    double largest = 0.0;
    for (std::int32_t line = std::min(a.*axis, b.*axis) + 1; line < std::max(a.*axis, b.*axis); ++line)
    {
      const double part = (double(line) - a.*axis) / (double(b.*axis) - a.*axis);
      const double place = a.*across + part * (double(b.*across) - a.*across);
      PlanePoint low{};
      low.*axis = line;
      low.*across = std::int32_t(std::floor(place));
      PlanePoint high = low;
      ++(high.*across);
      const auto one = this->PointAt.find(low);
      const auto other = this->PointAt.find(high);
      const double between = place - std::floor(place);
      const bool isBetween = between > 1e-9 && between < 1.0 - 1e-9;
      const LinkCuts* const cuts = this->Horizon.Cuts.get();
      const bool isCut = cuts && (axis == &PlanePoint::X ? cuts->IsCutNorth(low) : cuts->IsCutEast(low));
      if (isBetween && !isCut && one != this->PointAt.end() && other != this->PointAt.end() && this->CanSee(low, high))
      {
        const double expected = (1.0 - between) * this->Height(one->second) + between * this->Height(other->second);
        const double height = this->MeshHeight(from) + part * (this->MeshHeight(to) - this->MeshHeight(from));
        largest = std::max(largest, std::abs(height - expected));
      }
    }
    return largest;
  }

  /// Whether no loop crosses the line between two columns.
  bool CanSee(const PlanePoint& a, const PlanePoint& b) const
  {
    bool clear = true;
    this->Horizon.Boundary.ForEachEdge(
      [&](PointId from, PointId to) { clear = clear && !ExactPlane::DoCross(a, b, this->At(from), this->At(to)); });
    return clear;
  }

  const BoundedHorizon& Horizon;
  const Decimation& Result;
  const TriangleSets::Triangles Triangles;
  std::vector<double> Heights; // by point, for vertices those of the mesh
  Patches::Columns Columns;
  std::map<PlanePoint, PointId> PointAt;
};
}

#endif
