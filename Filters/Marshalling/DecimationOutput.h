// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The units of a decimation's error, and its output.

#ifndef SeismicHorizonsDecimationOutput_h
#define SeismicHorizonsDecimationOutput_h

#include "Common/Lattice.h"
#include "Decimation/Decimation.h"

#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
enum class ErrorUnit
{
  Lattice = 0, // 1 is one vertical index
  World = 1, // that of z
  Diagonal = 2 // 1 is the diagonal of the bounding box of all points, in lattice units
};

/// An error in lattice units. Throws InputError when it is negative or not finite. `columns` and `height` are the
/// places of all points.
double ErrorInLatticeUnits(
  double error, ErrorUnit unit, PlanePoints columns, const std::vector<double>& height, const Lattice& grid);

/// Makes `output` the mesh of the decimated `input`: points with their data, loops, triangles and figures. Moves the
/// triangles away.
void WriteDecimation(vtkPolyData* input, const Lattice& grid, Decimation& decimation, vtkPolyData* output);
}

#endif
