// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Grading.h"

#include "Common/FixedChunks.h"
#include "WeightedHistogram.h"

#include <algorithm>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TrianglesPerChunk = 4096; // after which a thread locks the histogram
}

//----------------------------------------------------------------------------------------------------------------------
Grading MeasureGrading(const TriangleSurface& surface)
{
  WeightedHistogram histogram;
  ForEachChunk(std::int64_t(surface.Triangles.size()), TrianglesPerChunk, Monitor(),
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      std::vector<WeightedHistogram::Entry> entries;
      for (std::size_t n = std::size_t(first); n < std::size_t(last); ++n)
      {
        const Corners& t = surface.Triangles[n];
        const double sides[3] = { (surface.Point(t[1]) - surface.Point(t[0])).norm(),
          (surface.Point(t[2]) - surface.Point(t[1])).norm(), (surface.Point(t[0]) - surface.Point(t[2])).norm() };
        for (const auto [a, b] :
          { std::minmax(sides[0], sides[1]), std::minmax(sides[1], sides[2]), std::minmax(sides[2], sides[0]) })
        {
          entries.push_back(WeightedHistogram::MakeEntry(b == 0.0 ? 1.0 : b / a, 1));
        }
      }
      histogram.Add(entries);
    });
  return { histogram.Percentile(0.5), histogram.Percentile(0.95) };
}
}
