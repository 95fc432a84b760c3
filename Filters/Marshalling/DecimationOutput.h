// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The output of a decimation.

#ifndef SeismicHorizonsDecimationOutput_h
#define SeismicHorizonsDecimationOutput_h

#include "Common/Lattice.h"
#include "Decimation/Decimation.h"

class vtkPolyData;

namespace SeismicHorizons
{
/// Makes `output` the mesh of the decimated `input`: points with their data, loops, triangles and figures. Moves the
/// triangles away.
void WriteDecimation(vtkPolyData* input, const Lattice& lattice, Decimation& decimation, vtkPolyData* output);
}

#endif
