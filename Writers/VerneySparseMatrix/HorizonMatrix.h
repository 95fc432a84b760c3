// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonMatrix_h
#define SeismicHorizonsHorizonMatrix_h

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <array>
#include <optional>

class vtkPolyData;

namespace SeismicHorizons
{
SparseMatrixSize ReadMatrixSize(vtkPolyData* horizon);

/// Returns world z of vertical index 0, and its step per index.
std::array<double, 2> ReadVerticalScale(vtkPolyData* horizon);

/// All points must have the same ID; without an array there is none.
std::optional<int> ReadSurfaceId(vtkPolyData* horizon);

/// vtkVerneySparseMatrixWriter documents the defaults of missing arrays. Throws InputError if points are not on
/// columns.
LatticeHorizon ReadVoxels(vtkPolyData* horizon, int surfaceId);
}

#endif
