// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The edges of a triangle mesh, each once.

#ifndef SeismicHorizonsSurfaceEdges_h
#define SeismicHorizonsSurfaceEdges_h

#include "TriangleSurface.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class SurfaceEdges
{
public:
  /// Linear; 8 bytes per point and 12 per triangle.
  explicit SurfaceEdges(const TriangleSurface& surface);

  /// Calls visit(low, high, triangles) for each edge whose end of lower number is in a range of points, with the number
  /// of triangles it belongs to. A triangle with a corner twice has its one edge twice.
  template <typename Visitor>
  void ForEach(std::int64_t firstPoint, std::int64_t lastPoint, Visitor&& visit) const
  {
    for (std::int64_t low = firstPoint; low < lastPoint; ++low)
    {
      const std::uint32_t end = this->Start[std::size_t(low) + 1];
      for (std::uint32_t first = this->Start[std::size_t(low)]; first < end;)
      {
        std::uint32_t next = first + 1;
        while (next < end && this->Highs[next] == this->Highs[first])
        {
          ++next;
        }
        visit(PointId(low), this->Highs[first], next - first);
        first = next;
      }
    }
  }

private:
  std::vector<std::uint32_t> Start; // by point of lower number: where its list begins
  std::vector<PointId> Highs; // the other ends, sorted in each list
};

/// The edges of one triangle alone, each as a triangle without an area, in plan (z = 0), over points of their own.
TriangleSurface FindOutline(const TriangleSurface& surface, const SurfaceEdges& edges);
}

#endif
