// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonSampling_h
#define SeismicHorizonsHorizonSampling_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Survey/HorizonGrid.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace SeismicHorizons
{
/// Stages and readers write such arrays, which are no attributes.
bool IsOwnArray(const std::string& name);

/// The direction in which z of a file increases.
enum class WrittenSense
{
  AsRead, // that of the field data, else up
  Elevation,
  Depth
};

/// The factor from world z to z of the file, 1 or -1.
int VerticalSign(const Horizon& horizon, WrittenSense sense);

/// The same for tables, whose names say elevation. Depths as read that are all above the datum become elevations, since
/// readers take columns of negative numbers for these.
int SignOfTable(const Horizon& horizon, WrittenSense sense);

/// Throws InputError for 2^31 columns and more, which mostly come from a few distant points, and would fill disks.
std::size_t CountColumns(int columns, int rows, std::int64_t points);

/// z is `sign` times world z. Point arrays of real numbers are attributes, except the stages' own; meshes have none.
/// Throws InputError without a lattice, for bare points off columns, and for other polygons.
HorizonColumns SampleHorizon(const Horizon& horizon, int sign, const Monitor& monitor);

/// Covers the whole lattice, without attributes. Throws InputError for 2^31 columns and more, for a large lattice that
/// is nearly empty, and for a mesh over no column.
HorizonGrid SampleWholeLattice(const Horizon& horizon, int sign, const Monitor& monitor);
}

#endif
