// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleSurface.h"

#include "Common/Errors.h"
#include "Common/Parallel.h"

#include <atomic>
#include <cstdint>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 16384; // points or triangles that a thread takes at a time

void CheckPoint(const Eigen::Vector3d& place, std::size_t point, const char* name)
{
  if (!(place.cwiseAbs().maxCoeff() <= LargestCoordinate) || !place.allFinite())
  {
    std::ostringstream text;
    text << name << ": point " << point << " at (" << place.x() << ", " << place.y() << ", " << place.z()
         << "), expected finite coordinates of at most " << LargestCoordinate;
    throw InputError(text.str());
  }
}

void CheckCorners(const TriangleSurface& surface, std::size_t triangle, const char* name)
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
      for (std::size_t point = std::size_t(first); point < std::size_t(last); ++point)
      {
        CheckPoint(surface.Points[point], point, name);
      }
    });
  std::atomic<bool> hasArea = false;
  ParallelFor(std::int64_t(surface.Triangles.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      bool found = false;
      for (std::size_t triangle = std::size_t(first); triangle < std::size_t(last); ++triangle)
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
    for (const PointId corner : triangle)
    {
      box.extend(surface.Point(corner));
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}
}
