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

  /// Calls visit(low, high, triangles) for each edge whose end of lower number is in a range of points: its ends, and
  /// how many triangles it is a side of. A triangle that has one point as two of its corners counts twice for its one
  /// edge.
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

/// The edges that are a side of one triangle alone, in plan (z = 0). Each is given as a triangle without an area, over
/// points of their own.
TriangleSurface FindOutline(const TriangleSurface& surface, const SurfaceEdges& edges);
}

#endif
