// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVertexCells_h
#define SeismicHorizonsVertexCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkCellArray;

namespace SeismicHorizons
{
/// One vertex cell for each of the points, in their order. Numbers are stored in 32 bits where they fit, else in 64, in
/// memory that all such cells share: whoever wants other numbers makes other arrays, as with all that datasets share.
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType numberOfPoints);

/// Whether cells are what that makes, so that they can be shared.
bool HasAllVertices(vtkCellArray* cells, vtkIdType numberOfPoints);
}

#endif
