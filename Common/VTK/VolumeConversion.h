// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVolumeConversion_h
#define SeismicHorizonsVolumeConversion_h

#include "Common/Horizon/VolumeGrid.h"

class vtkUnstructuredGrid;

namespace SeismicHorizons
{
VolumeGrid FromVTK(vtkUnstructuredGrid* grid);
/// Replaces the output.
void ToVTK(const VolumeGrid& grid, vtkUnstructuredGrid* output);
}

#endif
