// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns the voxels of a horizon into a map.

#ifndef SeismicHorizonsHorizonImage_h
#define SeismicHorizonsHorizonImage_h

#include "Common/Survey/LatticeFrame.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace SeismicHorizons
{
/// Makes an image with a pixel for each column of the horizon's bounding box. Pixels without a voxel are blanked, and
/// their attributes are nan. Throws InputError when the steps of the lattice are not perpendicular.
vtkSmartPointer<vtkImageData> MakeHorizonImage(const LatticeHorizon& voxels, const LatticeFrame& frame);
}

#endif
