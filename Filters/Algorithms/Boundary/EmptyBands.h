// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Moves parts of a horizon that are far apart closer together, so that a raster of its columns stays small.

#ifndef SeismicHorizonsEmptyBands_h
#define SeismicHorizonsEmptyBands_h

#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Whether the bounding box of the columns has many times as many columns.
bool AreScattered(const std::vector<PlanePoint>& columns);

/// Narrows the bands that neighbouring rows of the lattice, or neighbouring columns of it, form when they are empty
/// from end to end: those that no hop of at most `radius` columns can cross, and only so far that still none can. No
/// patch and no loop reaches across such a band, so that patches, loops and the order of columns stay what they were.
/// Takes time near n log n. Throws InputError when two points stand in the same column.
std::vector<PlanePoint> NarrowEmptyBands(std::vector<PlanePoint> columns, int radius);

/// Gives work(columns), or work(NarrowEmptyBands(columns)) when they are scattered.
template <typename Work>
auto WithoutWideBands(const std::vector<PlanePoint>& columns, int radius, Work&& work)
{
  return AreScattered(columns) ? work(NarrowEmptyBands(columns, radius)) : work(columns);
}
}

#endif
