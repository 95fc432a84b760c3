// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Documentation/DataModel.md describes the points.

#ifndef SeismicHorizonsHorizonDataSet_h
#define SeismicHorizonsHorizonDataSet_h

#include "Common/Survey/ImageFrame.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/LatticeHorizon.h"

#include "vtkSmartPointer.h"

class vtkFieldData;
class vtkImageData;
class vtkPolyData;

namespace SeismicHorizons
{
/// Adds the lattice, its map to the world, line numbers and units.
void AddFrameFields(vtkFieldData* data, const LatticeFrame& frame);

void PlaceImage(vtkImageData* image, const ImageFrame& frame);

vtkSmartPointer<vtkPolyData> MakeHorizonPoints(LatticeHorizon horizon, const LatticeFrame& frame);
}

#endif
