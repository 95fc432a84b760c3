// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a horizon whose rows are read as needed, so that it may be larger than memory.

#ifndef SeismicHorizonsSurfaceByRows_h
#define SeismicHorizonsSurfaceByRows_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "SurfaceStage.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The points of a horizon that is not in memory, as readers make them.
class HorizonRows
{
public:
  virtual ~HorizonRows() = default;
  /// The columns of all points; empty without any.
  virtual PlaneBox Box() const = 0;
  virtual std::int64_t CountPoints(std::int32_t firstRow, std::int32_t lastRow) const = 0;
  /// Returns the points of these rows, row by row. In the field data, dropped duplicates and the ledger are those of these
  /// rows.
  virtual Horizon Read(std::int32_t firstRow, std::int32_t lastRow) const = 0;
};

/// Fills the same mesh as of the points in memory. Throws InputError if the horizon must be meshed at once and has more
/// than `mostAtOnce` points. Returns warnings.
std::vector<std::string> RunSurfaceByRows(const HorizonRows& rows, const SurfaceStageOptions& options,
  std::int64_t mostAtOnce, Horizon& mesh, const Monitor& monitor);
}

#endif
