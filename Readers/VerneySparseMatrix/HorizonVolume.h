// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonVolume_h
#define SeismicHorizonsHorizonVolume_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/LatticeImage.h"
#include "SparseMatrixFile.h"

#include <vector>

namespace SeismicHorizons
{
enum class VolumeAttribute
{
  None,
  Amplitude,
  Thickness
};

struct VolumeOptions
{
  VolumeAttribute Attribute = VolumeAttribute::None;
  int Background = 0; // Surface ID of points without a voxel.
  int MemoryLimit = 0; // 2^20 bytes
};

/// The conversion is its own inverse.
VoxelExtent ToImageExtent(const VoxelExtent& extent, const ImageFrame& frame);

void CheckVolumeMemory(const VoxelExtent& imageExtent, const VolumeOptions& options);

/// Throws InputError if the background is the ID of a horizon, or an attribute exceeds single precision.
LatticeImage MakeHorizonVolume(const std::vector<const LatticeHorizon*>& horizons, const LatticeFrame& frame,
  const VoxelExtent& imageExtent, const VolumeOptions& options, const Monitor& monitor);
}

#endif
