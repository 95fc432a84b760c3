// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonSampling_h
#define SeismicHorizonsHorizonSampling_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <cstddef>
#include <cstdint>
#include <string>

class vtkPolyData;

namespace SeismicHorizons
{
/// Stages and readers write such arrays, which are no attributes.
bool IsOwnArray(const std::string& name);

/// Throws InputError for 2^31 columns and more, which mostly come from a few distant points, and would fill disks.
std::size_t CountColumns(int columns, int rows, std::int64_t points);

/// z is `sign` times world z. Point arrays of real numbers are attributes, except the stages' own; meshes have none.
/// Throws InputError without a lattice, for bare points off columns, and for other polygons.
HorizonColumns SampleHorizon(vtkPolyData* horizon, int sign, const Monitor& monitor);

/// Covers the whole lattice, without attributes. Throws InputError for 2^31 columns and more, for a large lattice that
/// is nearly empty, and for a mesh over no column.
HorizonGrid SampleWholeLattice(vtkPolyData* horizon, int sign, const Monitor& monitor);
}

#endif
