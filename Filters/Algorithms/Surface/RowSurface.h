// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a mesh from points that are read row by row, of a horizon that need not fit into memory.

#ifndef SeismicHorizonsRowSurface_h
#define SeismicHorizonsRowSurface_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/PatchSpans.h"
#include "PartAssembly.h"
#include "Surface.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class RowReader
{
public:
  virtual ~RowReader() = default;
  /// Of all points; empty without any.
  virtual PlaneBox Box() const = 0;
  /// Adds the points of these rows, which lie in the box, row by row.
  virtual void Read(std::int32_t firstRow, std::int32_t lastRow, std::vector<PlanePoint>& columns,
    std::vector<double>& height) const = 0;
};

/// A surface without arrays by point.
struct RowSurface
{
  /// Sources are numbers of points row by row. Boundary.Patch, Kept, Dropped and targets are empty.
  Surface Made;
  PatchSpans Patches;
  std::int64_t DroppedPoints = 0; // of patches below the minimum size
};

/// The same surface as of the points in memory. Reads all rows three times, or twice for horizons that are meshed at once
/// (SurfaceParts.h); throws InputError if these have more points than `mostAtOnce`. There must be no cuts.
RowSurface MakeSurface(const RowReader& rows, const SurfaceOptions& options, std::int64_t mostAtOnce,
  const TakeTargets& take, const Monitor& monitor = Monitor());
}

#endif
