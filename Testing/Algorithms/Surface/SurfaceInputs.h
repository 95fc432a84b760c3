// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points and options of surfaces.

#ifndef SeismicHorizonsSurfaceInputs_h
#define SeismicHorizonsSurfaceInputs_h

#include "Filters/Algorithms/Surface/Surface.h"
#include "Tools/Patches.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SurfaceInputs
{
using namespace SeismicHorizons;

/// The points of a surface with the memory for them.
struct Points
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Height;

  operator SurfacePoints() const { return { this->Columns, this->Height }; }
};

template <typename Height>
Points MakePoints(const Patches::Columns& columns, Height&& height)
{
  Points points;
  for (const PlanePoint& column : columns)
  {
    points.Columns.push_back(column);
    points.Height.push_back(height(column));
  }
  return points;
}

inline Patches::Columns Rectangle(int width, int height)
{
  return Patches::FromPicture(std::vector<std::string>(std::size_t(height), std::string(std::size_t(width), '#')));
}

inline SurfaceOptions Within(double error)
{
  SurfaceOptions options;
  options.MaximumError = error;
  return options;
}

inline SurfaceOptions AtMost(std::size_t triangles)
{
  SurfaceOptions options;
  options.MaximumNumberOfTriangles = triangles;
  return options;
}

inline std::size_t CountTriangles(const Surface& surface)
{
  return surface.Mesh.Triangles.size() / 3;
}
}

#endif
