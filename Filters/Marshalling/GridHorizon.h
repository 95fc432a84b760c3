// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons in unstructured grids: Threshold, Clip and Merge Blocks turn a vtkPolyData into one.

#ifndef SeismicHorizonsGridHorizon_h
#define SeismicHorizonsGridHorizon_h

#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace SeismicHorizons
{
/// The points of a grid with their arrays, its vertices, lines and polygons, and its field data. Cell data are left
/// out. Throws InputError on cells of other kinds.
vtkSmartPointer<vtkPolyData> ToPolyData(vtkUnstructuredGrid* grid);
}

#endif
