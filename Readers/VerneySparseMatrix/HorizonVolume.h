// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns the voxels of horizons into a volume.

#ifndef SeismicHorizonsHorizonVolume_h
#define SeismicHorizonsHorizonVolume_h

#include "Common/Monitor.h"
#include "Common/Survey/ImageFrame.h"
#include "SparseMatrixFile.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace SeismicHorizons
{
/// What a volume holds besides the surface ID.
enum class VolumeAttribute
{
  None,
  Amplitude,
  Thickness
};

struct VolumeOptions
{
  VolumeAttribute Attribute = VolumeAttribute::None;
  int Background = 0; // the surface ID where there is no voxel
  int MemoryLimit = 0; // 2^20 bytes
};

/// The extent of image data for a box of voxels, and the other way round.
VoxelExtent ToImageExtent(const VoxelExtent& extent, const ImageFrame& frame);

/// Throws InputError when a volume takes more memory than allowed.
void CheckVolumeMemory(const VoxelExtent& imageExtent, const VolumeOptions& options);

/// Makes image data of that extent with a point for each cell of the lattice. Throws InputError when the background is
/// the ID of a horizon, and when an attribute is too large for single precision.
vtkSmartPointer<vtkImageData> MakeHorizonVolume(const std::vector<const LatticeHorizon*>& horizons,
  const LatticeFrame& frame, const VoxelExtent& imageExtent, const VolumeOptions& options, const Monitor& monitor);
}

#endif
