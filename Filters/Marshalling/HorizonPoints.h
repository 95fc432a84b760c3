// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points of a vtkPolyData count, copies of some of them, and what they are coloured by.

#ifndef SeismicHorizonsHorizonPoints_h
#define SeismicHorizonsHorizonPoints_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkIdList;
class vtkPolyData;

namespace SeismicHorizons
{
/// How many points are not hidden. The array vtkGhostType hides points, or marks them as those of another process.
vtkIdType CountVisiblePoints(vtkPolyData* horizon);

/// The horizon itself; or, when some of its points are hidden, the others alone, without cells.
vtkSmartPointer<vtkPolyData> WithoutHiddenPoints(vtkPolyData* horizon);

/// Gives `output` some of the points of `input`, with their arrays.
void CopyPoints(vtkPolyData* input, vtkIdList* kept, vtkPolyData* output);

/// Makes the vertical index, where there is one, the active scalars, by which windows colour.
void ActivateHeight(vtkPolyData* horizon);
}

#endif
