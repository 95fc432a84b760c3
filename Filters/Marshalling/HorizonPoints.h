// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points of a vtkPolyData count, copies of some of them, and what they are coloured by.

#ifndef SeismicHorizonsHorizonPoints_h
#define SeismicHorizonsHorizonPoints_h

#include "Common/KeptPoints.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>

class vtkAbstractArray;
class vtkPolyData;

namespace SeismicHorizons
{
/// How many points are not hidden. The array vtkGhostType hides points, or marks them as those of another process.
vtkIdType CountVisiblePoints(vtkPolyData* horizon);

/// The horizon itself; or, when some of its points are hidden, the others alone, without cells.
vtkSmartPointer<vtkPolyData> WithoutHiddenPoints(vtkPolyData* horizon);

/// What an array has at some points, on threads.
vtkSmartPointer<vtkAbstractArray> CopyTuples(vtkAbstractArray* array, const KeptPoints& kept);

/// Adds what was made of the n-th point array of `input` to `output`, as the active scalars, say, when it is those.
void AddPointArray(vtkPolyData* input, int n, vtkAbstractArray* made, vtkPolyData* output);

/// Gives `output` some of the points of `input`, with their arrays and a vertex cell for each. Where all are kept, both
/// share the arrays.
void CopyPoints(vtkPolyData* input, const KeptPoints& kept, vtkPolyData* output);

/// Throws InputError when heights, height(point) in lattice units, do not rise with the vertical index: Transform moves
/// points, and leaves the lattice in the field data as it is.
void CheckHeights(vtkPolyData* horizon, const std::function<double(vtkIdType)>& height);

/// Makes the vertical index, where there is one, the active scalars, by which windows colour.
void ActivateHeight(vtkPolyData* horizon);
}

#endif
