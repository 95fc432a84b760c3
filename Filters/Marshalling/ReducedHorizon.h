// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The output of the stages that leave fewer points.

#ifndef SeismicHorizonsReducedHorizon_h
#define SeismicHorizonsReducedHorizon_h

#include "Common/DroppedPoints.h"
#include "Common/Lattice.h"
#include "Common/Types.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkIntArray;
class vtkPoints;
class vtkPolyData;

namespace SeismicHorizons
{
/// The array CellOrigin.
vtkSmartPointer<vtkIntArray> NewOriginArray(vtkIdType size);
void SetOrigin(vtkIntArray* array, vtkIdType n, const PointOrigin& origin);

/// The points that are left of `input`.
vtkSmartPointer<vtkPoints> MakePoints(vtkPolyData* input, const Lattice& lattice, const Reduction& reduction);

/// Makes `output`, which has these points already, the reduced `input`: vertices, loops, and all point data. PointCount
/// is summed. At averaged points floating point arrays and VerticalIndex (which is then of type double) are averaged,
/// weighted by PointCount; all other arrays, being labels, are taken from the nearest point that was merged. CellOrigin
/// is added when the reduction says where points come from, and Flatness when it says how flat cells were.
void WriteReduction(vtkPolyData* input, const Reduction& reduction, vtkPolyData* output);

/// Makes `output` what is left of `input` without some points: points, vertices, all point data, and loops, which are
/// over the points of the input. PointCount is that of the input, and 1 where it has none, with that of the points that
/// were dropped added. Where no point is, both share their arrays.
void WriteDropped(vtkPolyData* input, const DroppedPoints& dropped, const Loops& boundary, vtkPolyData* output);
}

#endif
