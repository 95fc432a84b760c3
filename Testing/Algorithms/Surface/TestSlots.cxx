// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Outlines of a mesh stay on their side of the middle of narrow slots, whatever the vertical error.

#include "Common/Horizon/Predicates.h"
#include "SurfaceInputs.h"
#include "Tools/Check.h"

#include <algorithm>
#include <array>
#include <vector>

using namespace SeismicHorizons;
using namespace SurfaceInputs;

namespace
{
/// Whether a column is in a triangle of a mesh, or on its edges.
bool IsCovered(const Surface& surface, const PlanePoint& column)
{
  const auto& triangles = surface.Mesh.Triangles;
  for (std::size_t at = 0; at < triangles.size(); at += 3)
  {
    std::array<std::int64_t, 3> areas;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      areas[corner] = SignedArea(surface.Mesh.Points.Plane[std::size_t(triangles[at + corner])],
        surface.Mesh.Points.Plane[std::size_t(triangles[at + (corner + 1) % 3])], column);
    }
    const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
    if (*least >= 0 || *most <= 0)
    {
      return true;
    }
  }
  return false;
}

/// The columns of the middle of a ragged slot, 20 columns deep, that a mesh within an error covers.
int CountCoveredMiddles(int width, const SurfaceOptions& options, Patches::Random& random)
{
  Patches::Columns columns;
  const int middle = 15; // of an odd slot; an even one has its middle to the left
  for (int y = 0; y < 30; ++y)
  {
    const int left = middle - width / 2 - int(random.Below(2));
    const int right = left + width + int(random.Below(2));
    for (int x = 0; x < 31; ++x)
    {
      if (y >= 20 || x < left || x >= right)
      {
        columns.push_back({ x, y });
      }
    }
  }
  const std::vector<double> heights(columns.size(), 0.0);
  const Surface surface = MakeSurface({ PlanePoints(columns), heights }, options);
  int covered = 0;
  for (int y = 0; y < 19; ++y)
  {
    covered += IsCovered(surface, { middle - 1 + width % 2, y }) ? 1 : 0;
  }
  return covered;
}

}

int TestSlots(int, char*[])
{
  Patches::Random random(11);
  SurfaceOptions wide = Within(5.0);
  wide.OutlineTolerance = 5.0;
  int coveredByWide = 0;
  for (int n = 0; n < 60; ++n)
  {
    const int width = 3 + n % 4;
    CHECK_EQUAL(CountCoveredMiddles(width, Within(1.0 + n % 5), random), 0);
    coveredByWide += CountCoveredMiddles(width, wide, random);
  }
  CHECK(coveredByWide > 0);
  return Check::Result();
}
