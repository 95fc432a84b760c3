// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a large horizon in parts, so that the points of a few rows are in memory at a time.
//
//     ---+-----------+---     Bands of rows are meshed first. Their edges along a cut between two bands go again: the
//        |  band     |        triangles near it are replaced by those of a strip, whose other edges stay.
//     ...|...........|...
//        |  strip    |  cut   So each edge is inside a part when it is made, and errors are bounded as in a mesh made
//     ...|...........|...     at once. Bands depend on the lattice alone, and the mesh does not depend on where the
//        |  band     |        points are.
//     ---+-----------+---

#ifndef SeismicHorizonsSurfaceParts_h
#define SeismicHorizonsSurfaceParts_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/PatchSpans.h"
#include "Surface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Points of successive rows.
struct PointWindow
{
  PointId First = 0;
  std::vector<PlanePoint> Columns;
  std::vector<double> Height; // lattice units
  std::vector<unsigned char> IsLeftOut; // of points without a patch; empty if all have one
};

/// The points of a horizon, numbered row by row.
class PointRows
{
public:
  virtual ~PointRows() = default;
  virtual PlaneBox Box() const = 0;
  virtual PlanePoint ColumnOf(PointId point) const = 0;
  /// The first point of this row or of a later one.
  virtual PointId FirstOf(std::int32_t row) const = 0;
  virtual PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const = 0;
};

class RowsInMemory : public PointRows
{
public:
  /// Columns ascend row by row, in the box. They and the heights must outlive this.
  RowsInMemory(PlanePoints columns, const std::vector<double>& height, const PlaneBox& box);

  PlaneBox Box() const override { return this->Area; }
  PlanePoint ColumnOf(PointId point) const override { return this->Columns[std::size_t(point)]; }
  PointId FirstOf(std::int32_t row) const override;
  PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const override;

private:
  const PlanePoints Columns;
  const std::vector<double>& Height;
  const PlaneBox Area;
};

/// The points of a horizon that is not in memory.
class RowReader
{
public:
  virtual ~RowReader() = default;
  /// Of all points; empty without any.
  virtual PlaneBox Box() const = 0;
  /// Adds the points of these rows, which may lie beyond the box, row by row.
  virtual void Read(std::int32_t firstRow, std::int32_t lastRow, std::vector<PlanePoint>& columns,
    std::vector<double>& height) const = 0;
};

/// Returns 0 for horizons that are meshed at once: small ones, those with a radius above 1, and meshes that are not
/// improved within an error.
std::int32_t RowsOfPart(const PlaneBox& box, const SurfaceOptions& options, int radius);

/// Takes the vertex of each point of a row, NoPoint for those without, row by row.
using TakeTargets = std::function<void(PointId first, const std::vector<PointId>& targets)>;

/// Fills the mesh and the figures of a surface with a boundary. Its targets are filled unless others take them.
void MakeInParts(const PointRows& rows, std::int32_t rowsOfPart, const SurfaceOptions& options, Surface& surface,
  const Monitor& monitor, const TakeTargets& take = {});

/// A surface without arrays by point.
struct RowSurface
{
  /// Sources are numbers of points row by row. Boundary.Patch, Kept, Dropped and targets are empty.
  Surface Made;
  PatchSpans Patches;
  std::int64_t DroppedPoints = 0; // of patches below the minimum size
};

/// The same surface as of the points in memory. Reads all rows three times, or once for horizons that are meshed at once;
/// throws InputError if these have more points than `mostAtOnce`. There must be no cuts.
RowSurface MakeSurface(const RowReader& rows, const SurfaceOptions& options, std::int64_t mostAtOnce,
  const TakeTargets& take, const Monitor& monitor = Monitor());
}

#endif
