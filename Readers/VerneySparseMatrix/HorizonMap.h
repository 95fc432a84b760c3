// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonMap_h
#define SeismicHorizonsHorizonMap_h

#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/LatticeHorizon.h"
#include "Common/Survey/LatticeImage.h"

namespace SeismicHorizons
{
/// The map has a pixel per column of the bounding box; pixels without voxel are blanked, with nan as attributes.
/// Throws InputError if the steps of the lattice are not perpendicular.
LatticeImage MakeHorizonMap(const LatticeHorizon& voxels, const LatticeFrame& frame);
}

#endif
