// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageFrame_h
#define SeismicHorizonsImageFrame_h

#include "Common/LatticePlacement.h"

#include <array>

namespace SeismicHorizons
{
/// Where image data over a lattice lie in the world. The first two axes are i and j.
struct ImageFrame
{
  std::array<double, 3> Origin = {}; // of the index (0, 0, 0)
  std::array<double, 3> Spacing = {}; // positive
  std::array<double, 9> Direction = {}; // row by row; its columns are the axes
  int VerticalSign = 1; // the third index is k, or -k
};

// Both throw InputError when ColumnStep and RowStep are not perpendicular: image data can be turned and stretched, but
// not sheared.

/// The frame of a map at z = 0. z of the image is z of the world, whichever way vertical indices count.
ImageFrame MakeMapFrame(const LatticeMatrix& toWorld);

/// The frame of all voxels of a lattice, each at the place where the map puts it. The axes are always right-handed, as
/// ParaView draws no volume on others; where i, j and k are not, the third index is -k.
ImageFrame MakeVolumeFrame(const LatticeMatrix& toWorld);
}

#endif
