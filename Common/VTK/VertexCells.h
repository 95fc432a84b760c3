// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVertexCells_h
#define SeismicHorizonsVertexCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkCellArray;

namespace SeismicHorizons
{
/// Makes a vertex cell per point, with 32-bit numbers if they suffice. The memory is shared and must not be modified.
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType numberOfPoints);

bool HasAllVertices(vtkCellArray* cells, vtkIdType numberOfPoints);
}

#endif
