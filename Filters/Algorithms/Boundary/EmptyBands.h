// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brings the parts of a horizon closer together that are far apart, so that a raster of its columns stays small.

#ifndef SeismicHorizonsEmptyBands_h
#define SeismicHorizonsEmptyBands_h

#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Whether the bounding box of the columns is much larger than they are many.
bool AreScattered(const std::vector<PlanePoint>& columns);

/// Rows and columns of the lattice that are empty from end to end form bands. This narrows bands that no hop of at most
/// `radius` columns can cross, just so far that none can. No patch and no loop reaches over such a band: patches, loops
/// and the order of columns stay what they were. Takes time near n log n. Throws InputError when two points stand in
/// the same column.
/// Throws InputError when two points stand in the same column.
std::vector<PlanePoint> NarrowEmptyBands(std::vector<PlanePoint> columns, int radius);

/// Gives work(columns), where scattered columns are brought together before.
template <typename Work>
auto WithoutWideBands(const std::vector<PlanePoint>& columns, int radius, Work&& work)
{
  return AreScattered(columns) ? work(NarrowEmptyBands(columns, radius)) : work(columns);
}
}

#endif
