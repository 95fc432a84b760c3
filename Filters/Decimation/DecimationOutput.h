// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDecimationOutput_h
#define SeismicHorizonsDecimationOutput_h

#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/Decimation/Decimation.h"

class vtkPolyData;

namespace SeismicHorizons
{
/// Moves the triangles out of the decimation.
void WriteDecimation(vtkPolyData* input, const Lattice& lattice, Decimation& decimation, vtkPolyData* output);
}

#endif
