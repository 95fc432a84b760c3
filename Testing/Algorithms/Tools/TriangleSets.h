// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of meshes as sets, for comparing meshes.

#ifndef SeismicHorizonsTriangleSets_h
#define SeismicHorizonsTriangleSets_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace TriangleSets
{
using SeismicHorizons::PointId;
using SeismicHorizons::RawVector;
using Triangle = std::array<PointId, 3>;
using Triangles = std::set<Triangle>;

/// The triangles of a mesh, each from its least point on, with number(point) for each point.
template <typename Number>
Triangles Canonical(const RawVector<PointId>& corners, Number&& number)
{
  Triangles result;
  for (std::size_t corner = 0; corner < corners.size(); corner += 3)
  {
    Triangle triangle = { number(corners[corner]), number(corners[corner + 1]), number(corners[corner + 2]) };
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.insert(triangle);
  }
  return result;
}

/// The same with the numbers that points have.
inline Triangles Canonical(const RawVector<PointId>& corners)
{
  return Canonical(corners, [](PointId point) { return point; });
}
}

#endif
