// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryMarks.h"

#include "ColumnRaster.h"
#include "EmptyBands.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
std::vector<BoundaryKind> MarkLoops(const ExteriorBoundary& boundary)
{
  std::vector<BoundaryKind> marks(boundary.Patch.size(), BoundaryKind::Inside);
  // Holes first, so that a point on loops of both kinds counts as exterior.
  for (std::size_t loop = boundary.Boundary.Size(); loop-- > 0;)
  {
    const BoundaryKind kind = loop < boundary.NumberOfPatches ? BoundaryKind::Exterior : BoundaryKind::Hole;
    std::for_each(boundary.Boundary.begin(loop), boundary.Boundary.end(loop),
      [&](PointId point) { marks[std::size_t(point)] = kind; });
  }
  return marks;
}

/// What a point is that no loop runs through: what the points are that it shares an empty column at its corner with.
BoundaryKind KindOfCorner(const ColumnRaster& raster, const std::vector<BoundaryKind>& marks, std::int64_t place)
{
  const std::int64_t up = raster.Width();
  BoundaryKind kind = BoundaryKind::Inside;
  for (const std::int64_t aside : { std::int64_t(-1), std::int64_t(1) })
  {
    for (const std::int64_t upright : { -up, up })
    {
      if (raster[place + aside + upright] != NoPoint)
      {
        continue;
      }
      // As no loop runs through the point, both columns between it and the empty one are occupied.
      for (const std::int64_t beside : { place + aside, place + upright })
      {
        const BoundaryKind other = marks[std::size_t(raster[beside])];
        kind = kind == BoundaryKind::Exterior ? kind : other;
      }
    }
  }
  return kind;
}

/// Marks the points that no loop runs through and that have an empty column corner to corner.
void MarkCorners(
  const std::vector<PlanePoint>& columns, const std::vector<std::int32_t>& patches, std::vector<BoundaryKind>& marks)
{
  const std::vector<BoundaryKind> loops = marks;
  const ColumnRaster raster(columns);
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    if (loops[point] == BoundaryKind::Inside && patches[point] != NoPatch)
    {
      marks[point] = KindOfCorner(raster, loops, raster.Place(columns[point]));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
BoundaryOptions OptionsFor(BoundaryType type, const BoundaryOptions& options)
{
  BoundaryOptions result = options;
  if (type != BoundaryType::Exterior)
  {
    result.Radius = 1;
    result.HoleBoundaries = true;
    result.SmallestHoleSize = 1;
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<BoundaryKind> MarkBoundary(
  BoundaryType type, const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary)
{
  std::vector<BoundaryKind> marks = MarkLoops(boundary);
  if (type == BoundaryType::Topological8)
  {
    WithoutWideBands(
      columns, 1, [&](const std::vector<PlanePoint>& near) { MarkCorners(near, boundary.Patch, marks); });
  }
  return marks;
}
}
