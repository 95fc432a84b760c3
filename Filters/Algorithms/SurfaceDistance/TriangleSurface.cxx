// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleSurface.h"

#include "Common/Errors.h"

#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
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
}

//----------------------------------------------------------------------------------------------------------------------
void CheckSurface(const TriangleSurface& surface, const char* name)
{
  if (surface.Triangles.empty())
  {
    throw InputError(std::string(name) + ": " + std::to_string(surface.Points.size()) +
      " points and no triangles, expected a triangle mesh");
  }
  for (std::size_t point = 0; point < surface.Points.size(); ++point)
  {
    CheckPoint(surface.Points[point], point, name);
  }
  double area = 0.0;
  for (std::size_t triangle = 0; triangle < surface.Triangles.size(); ++triangle)
  {
    for (const PointId corner : surface.Triangles[triangle])
    {
      if (corner < 0 || std::size_t(corner) >= surface.Points.size())
      {
        throw InputError(std::string(name) + ": triangle " + std::to_string(triangle) + " has the corner " +
          std::to_string(corner) + ", expected points from 0 to " + std::to_string(surface.Points.size() - 1));
      }
    }
    area += surface.Area(surface.Triangles[triangle]);
  }
  if (!(area > 0.0))
  {
    throw InputError(std::string(name) + ": " + std::to_string(surface.Triangles.size()) +
      " triangles without any area, expected a surface");
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
