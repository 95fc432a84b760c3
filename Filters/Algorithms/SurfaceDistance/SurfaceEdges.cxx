// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceEdges.h"

#include "Common/Parallel.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 4096; // points that a thread takes at a time

/// Calls visit(low, high) for the sides of all triangles.
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
SurfaceEdges::SurfaceEdges(const TriangleSurface& surface)
  : Highs(std::int64_t(surface.Points.size()), [&surface](auto&& add) { ForEachSide(surface.Triangles, add); })
{
  ParallelFor(std::int64_t(surface.Points.size()), Grain,
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
    PointId& kept = number[std::size_t(point)];
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
