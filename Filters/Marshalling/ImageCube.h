// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From images to seismic cubes.

#ifndef SeismicHorizonsImageCube_h
#define SeismicHorizonsImageCube_h

#include "Common/Survey/LatticeFrame.h"
#include "Reflections/TraceCube.h"

#include <array>

class vtkDataArray;
class vtkImageData;

namespace SeismicHorizons
{
struct ImageCube
{
  TraceCube Traces; // into the memory of the image
  std::array<int, 3> FirstIndex = { 0, 0, 0 }; // of the lattice, at the first trace and sample
  LatticeFrame Frame;
};

/// A cube whose traces run along k. Points that are hidden have no sample, and neither have numbers that are not
/// finite.
///
/// With the field data arrays LatticeDimensions and LatticeToWorld the extent of the image counts on that lattice, and
/// its points have to lie there. Without them the lattice is that of the image. Throws InputError on an array that is
/// not one number for each point, on images whose k axis is not vertical, or that have no sample, and on wrong
/// lattices. The image has to outlive the cube.
ImageCube MakeImageCube(vtkImageData* image, vtkDataArray* amplitudes);
}

#endif
