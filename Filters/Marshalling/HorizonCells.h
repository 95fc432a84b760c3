// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells out of the plain data of the algorithms.

#ifndef SeismicHorizonsHorizonCells_h
#define SeismicHorizonsHorizonCells_h

#include "Common/Lattice.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include "vtkSmartPointer.h"

class vtkCellArray;

namespace SeismicHorizons
{
/// One closed polyline for each loop: its last point is its first one again.
vtkSmartPointer<vtkCellArray> MakePolylines(const Loops& loops);
vtkSmartPointer<vtkCellArray> MakeTriangles(const RawVector<PointId>& triangles);

/// Turns triangles that are counter-clockwise on a lattice so that they are in the world.
void FaceUp(const Lattice& grid, RawVector<PointId>& triangles);
}

#endif
