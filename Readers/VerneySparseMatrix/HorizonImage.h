// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonImage_h
#define SeismicHorizonsHorizonImage_h

#include "Common/Survey/LatticeFrame.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace SeismicHorizons
{
/// The image has a pixel per column of the bounding box; pixels without voxel are blanked, with nan as attributes.
/// Throws InputError if the steps of the lattice are not perpendicular.
vtkSmartPointer<vtkImageData> MakeHorizonImage(const LatticeHorizon& voxels, const LatticeFrame& frame);
}

#endif
