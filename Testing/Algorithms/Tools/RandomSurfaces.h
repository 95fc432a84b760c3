// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangle meshes for the tests of distances.

#ifndef SeismicHorizonsRandomSurfaces_h
#define SeismicHorizonsRandomSurfaces_h

#include "Filters/Algorithms/SurfaceDistance/TriangleSurface.h"
#include "Patches.h"

#include <cmath>

namespace RandomSurfaces
{
using namespace SeismicHorizons;

/// A height field over squares of side `step`, `count` of them along each axis, as two triangles each.
template <typename Height>
TriangleSurface MakeField(int count, double step, Height&& height)
{
  TriangleSurface surface;
  for (int j = 0; j <= count; ++j)
  {
    for (int i = 0; i <= count; ++i)
    {
      surface.Points.emplace_back(i * step, j * step, height(i * step, j * step));
    }
  }
  for (PointId j = 0; j < count; ++j)
  {
    for (PointId i = 0; i < count; ++i)
    {
      const PointId corner = j * (count + 1) + i;
      surface.Triangles.push_back({ corner, corner + 1, corner + count + 2 });
      surface.Triangles.push_back({ corner, corner + count + 2, corner + count + 1 });
    }
  }
  return surface;
}

inline Eigen::Vector3d RandomPlace(Patches::Random& random, double size)
{
  const double x = random.Fraction();
  const double y = random.Fraction();
  return size * Eigen::Vector3d(x, y, random.Fraction());
}

/// Triangles anywhere in a cube of that size: large and small, and some that are needles, points or vertical.
inline TriangleSurface MakeSoup(int count, double size, Patches::Random& random)
{
  TriangleSurface surface;
  for (PointId n = 0; n < 3 * count; n += 3)
  {
    const double spread = random.Chance(0.1) ? size : 0.1 * size;
    const Eigen::Vector3d middle = RandomPlace(random, size);
    for (int corner = 0; corner < 3; ++corner)
    {
      surface.Points.push_back(middle + RandomPlace(random, spread));
    }
    Eigen::Vector3d& last = surface.Points.back();
    const int kind = random.Below(8);
    if (kind == 0) // a needle or a segment
    {
      last = 0.5 * (surface.Points[n] + surface.Points[n + 1]);
    }
    else if (kind == 1) // vertical
    {
      last.head<2>() = surface.Points[n].head<2>();
    }
    surface.Triangles.push_back({ n, kind == 2 ? n : n + 1, kind == 2 || kind == 3 ? n : n + 2 });
  }
  return surface;
}
}

#endif
