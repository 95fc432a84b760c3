// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The output of the stages that leave fewer points.

#ifndef SeismicHorizonsReducedHorizon_h
#define SeismicHorizonsReducedHorizon_h

#include "Common/Lattice.h"
#include "Common/Types.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkIntArray;
class vtkPolyData;

namespace SeismicHorizons
{
/// The array CellOrigin.
vtkSmartPointer<vtkIntArray> NewOriginArray(vtkIdType size);
void SetOrigin(vtkIntArray* array, vtkIdType n, const PointOrigin& origin);

/// Whether a reduction may make new points out of several old ones.
enum class Merging
{
  DropsPoints,
  AveragesPoints
};

/// Makes `output` the reduced `input`: points, vertices, loops, and all point data. PointCount is summed. At averaged
/// points floating point arrays and VerticalIndex (which is then of type double) are averaged, weighted by
/// PointCount; all other arrays, being labels, are taken from the nearest point that was merged. CellOrigin is added
/// when the reduction says where points come from, and Flatness when it says how flat cells were.
void WriteReduction(
  vtkPolyData* input, const Lattice& grid, const Reduction& reduction, Merging merging, vtkPolyData* output);
}

#endif
