// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleSurface.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"

#include <atomic>
#include <cassert>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t GrainOfLists = 4096;

void CheckPoint(const Eigen::Vector3d& place, std::int64_t point, const char* name)
{
  if (!(place.cwiseAbs().maxCoeff() <= LargestCoordinate) || !place.allFinite())
  {
    std::ostringstream text;
    text << name << ": point " << point << " at (" << place.x() << ", " << place.y() << ", " << place.z()
         << "), expected finite coordinates of at most " << LargestCoordinate;
    throw InputError(text.str());
  }
}

void CheckCorners(const TriangleSurface& surface, std::int64_t triangle, const char* name)
{
  for (const PointId corner : surface.Triangles[triangle])
  {
    if (corner < 0 || std::size_t(corner) >= surface.Points.size())
    {
      throw InputError(std::string(name) + ": triangle " + std::to_string(triangle) + " has the corner " +
        std::to_string(corner) + ", expected points from 0 to " + std::to_string(surface.Points.size() - 1));
    }
  }
}

template <typename Visitor>
void ForEachSide(const std::vector<Corners>& triangles, Visitor&& visit)
{
  for (const Corners& t : triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      const auto [low, high] = std::minmax(t[n], t[(n + 1) % 3]);
      if (low != high)
      {
        visit(low, high);
      }
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckSurface(const TriangleSurface& surface, const char* name)
{
  if (surface.Triangles.empty())
  {
    throw InputError(std::string(name) + ": " + std::to_string(surface.Points.size()) +
      " points and no triangles, expected a triangle mesh");
  }
  ParallelFor(std::int64_t(surface.Points.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        CheckPoint(surface.Points[point], point, name);
      }
    });
  std::atomic<bool> hasArea = false;
  ParallelFor(std::int64_t(surface.Triangles.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      bool found = false;
      for (std::int64_t triangle = first; triangle < last; ++triangle)
      {
        CheckCorners(surface, triangle, name);
        const Corners& corners = surface.Triangles[triangle];
        found = found || (surface.Counts(corners) && surface.Area(corners) > 0.0);
      }
      if (found)
      {
        hasArea = true;
      }
    });
  if (!hasArea)
  {
    throw InputError(std::string(name) + ": " + std::to_string(surface.Triangles.size()) +
      " triangles without any area" + (surface.LeftOut.empty() ? "" : " away from points that are left out") +
      ", expected a surface");
  }
}

//----------------------------------------------------------------------------------------------------------------------
double MeasureDiagonal(const TriangleSurface& surface)
{
  Eigen::AlignedBox3d box;
  for (const Corners& triangle : surface.Triangles)
  {
    box.extend(surface.Box(triangle));
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceEdges::SurfaceEdges(const TriangleSurface& surface)
  : Highs(std::int64_t(surface.Points.size()), [&surface](auto&& add) { ForEachSide(surface.Triangles, add); })
{
  ParallelFor(std::int64_t(surface.Points.size()), GrainOfLists,
    [this](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        std::sort(this->Highs.begin(point), this->Highs.end(point));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
TriangleSurface FindOutline(const TriangleSurface& surface, const SurfaceEdges& edges)
{
  TriangleSurface outline;
  std::vector<PointId> number(surface.Points.size(), NoPoint);
  const auto keep = [&](PointId point)
  {
    PointId& kept = number[point];
    if (kept == NoPoint)
    {
      kept = PointId(outline.Points.size());
      outline.Points.emplace_back(surface.Point(point).x(), surface.Point(point).y(), 0.0);
    }
    return kept;
  };
  edges.ForEach(0, std::int64_t(surface.Points.size()),
    [&](PointId low, PointId high, std::uint32_t triangles)
    {
      assert(low < high);
      if (triangles == 1)
      {
        const PointId from = keep(low);
        const PointId to = keep(high);
        outline.Triangles.push_back({ from, to, to });
      }
    });
  return outline;
}
}
