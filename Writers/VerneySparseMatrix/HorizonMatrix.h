// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonMatrix_h
#define SeismicHorizonsHorizonMatrix_h

#include "VerneySparseMatrix/SparseMatrixParser.h"

#include <array>
#include <optional>

class vtkPolyData;

namespace SeismicHorizons
{
/// The cells of the lattice of a horizon.
SparseMatrixSize ReadMatrixSize(vtkPolyData* horizon);

/// World z of vertical index 0, and from each to the next.
std::array<double, 2> ReadVerticalScale(vtkPolyData* horizon);

/// The surface ID of a horizon by its points, which all have to have the same; none without such an array.
std::optional<int> ReadSurfaceId(vtkPolyData* horizon);

/// The points of a horizon as voxels; what they lack is made up as vtkVerneySparseMatrixWriter says. Throws InputError
/// when the points do not stand on whole columns.
LatticeHorizon ReadVoxels(vtkPolyData* horizon, int surfaceId);
}

#endif
