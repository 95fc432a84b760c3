// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Threshold, Clip and Merge Blocks turn a vtkPolyData into an unstructured grid.

#ifndef SeismicHorizonsGridHorizon_h
#define SeismicHorizonsGridHorizon_h

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace SeismicHorizons
{
/// Drops cell data. Throws InputError on cells other than vertices, lines and polygons.
vtkSmartPointer<vtkPolyData> ToPolyData(vtkUnstructuredGrid* grid);
}

#endif
