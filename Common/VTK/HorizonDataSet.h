// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns horizons into the points that the stages work on (Documentation/DataModel.md), and adds the field data that
// datasets of any kind have.

#ifndef SeismicHorizonsHorizonDataSet_h
#define SeismicHorizonsHorizonDataSet_h

#include "Common/LatticeHorizon.h"
#include "Common/Survey/ImageFrame.h"
#include "Common/Survey/LatticeFrame.h"

#include "vtkSmartPointer.h"

class vtkFieldData;
class vtkImageData;
class vtkPolyData;

namespace SeismicHorizons
{
/// Adds the lattice and its place in the world, and of the survey what is known: line numbers and units.
void AddFrameFields(vtkFieldData* data, const LatticeFrame& frame);

void PlaceImage(vtkImageData* image, const ImageFrame& frame);

/// Makes a point and a vertex cell of each column of a horizon. Its memory is handed on to the arrays of the points.
vtkSmartPointer<vtkPolyData> MakeHorizonPoints(LatticeHorizon horizon, const LatticeFrame& frame);
}

#endif
