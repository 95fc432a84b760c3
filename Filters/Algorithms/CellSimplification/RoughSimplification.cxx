// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One point per square cell inside the boundary (thesis 4.3.1, Alg. 4.1): vertex clustering on a regular grid in plan
// that preserves the boundary.
//
// Cells start at the least corner of the bounding box. Points of one patch (and side of the cuts, CellLeaves.cxx) in a
// cell are a group. A group with boundary points keeps these alone; the barycentre, or the input point nearest to it,
// represents any other group. A barycentre on the wrong side of a long boundary edge through the cell is replaced by
// the nearest point.

#include "CellSimplification.h"

#include "CellLeaves.h"

#include <numeric>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyRough(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor)
{
  if (horizon.Height.empty())
  {
    return Reduction();
  }
  CellLeaves leaves(horizon, options.CellSize, monitor.Step(0.0, 0.4));
  leaves.MakeGroups([&leaves](PointId point) { return std::int64_t(leaves.SideOf(point)); }, monitor.Step(0.4, 0.6));
  Reduction result = WriteLeaves(leaves, options.Representative, monitor.Step(0.6, 1.0));
  if (options.ListCells)
  {
    // Squares have no bottom and are shown at the mean height of their points.
    ListCells(leaves, result,
      [&horizon](const PointId* first, const PointId* last, int)
      {
        const double sum =
          std::accumulate(first, last, 0.0, [&](double z, PointId point) { return z + horizon.Height[point]; });
        return sum / double(last - first);
      });
  }
  return result;
}
}
