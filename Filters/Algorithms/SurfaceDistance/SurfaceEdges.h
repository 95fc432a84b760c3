// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The edges of a triangle mesh, each once.

#ifndef SeismicHorizonsSurfaceEdges_h
#define SeismicHorizonsSurfaceEdges_h

#include "Common/CountingSort.h"
#include "TriangleSurface.h"

#include <algorithm>
#include <cstdint>

namespace SeismicHorizons
{
class SurfaceEdges
{
public:
  /// Linear; 4 bytes per point and 12 per triangle.
  explicit SurfaceEdges(const TriangleSurface& surface);

  /// Calls visit(low, high, triangles) for each edge whose end of lower number is in a range of points, with the number
  /// of triangles it belongs to. A triangle with a corner twice has its one edge twice.
  template <typename Visitor>
  void ForEach(std::int64_t firstPoint, std::int64_t lastPoint, Visitor&& visit) const
  {
    for (std::int64_t low = firstPoint; low < lastPoint; ++low)
    {
      const PointId* const end = this->Highs.end(low);
      for (const PointId* first = this->Highs.begin(low); first != end;)
      {
        const PointId* const next = std::find_if(first, end, [first](PointId high) { return high != *first; });
        visit(PointId(low), *first, std::uint32_t(next - first));
        first = next;
      }
    }
  }

private:
  ItemLists<PointId, std::uint32_t> Highs; // by the end of lower number: the other ends, sorted, one for each triangle
};

/// The edges of one triangle alone, each as a triangle without an area, in plan (z = 0), over points of their own.
TriangleSurface FindOutline(const TriangleSurface& surface, const SurfaceEdges& edges);
}

#endif
