// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsReducedHorizon_h
#define SeismicHorizonsReducedHorizon_h

#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkIntArray;
class vtkPoints;
class vtkPolyData;

namespace SeismicHorizons
{
vtkSmartPointer<vtkIntArray> NewOriginArray(vtkIdType size);
void SetOrigin(vtkIntArray* array, vtkIdType n, const PointOrigin& origin);

vtkSmartPointer<vtkPoints> MakePoints(vtkPolyData* input, const Lattice& lattice, const Reduction& reduction);

/// `output` has its points. PointCount is summed; averaged points get means of floating-point arrays and of
/// VerticalIndex, which becomes double, weighted by PointCount, and other values of the nearest merged point.
void WriteReduction(vtkPolyData* input, const Reduction& reduction, vtkPolyData* output);

/// Loops are given in points of the input. Counts of dropped points are added to PointCount. Arrays are shared if no
/// point is dropped.
void WriteDropped(vtkPolyData* input, const DroppedPoints& dropped, const Loops& boundary, vtkPolyData* output);
}

#endif
