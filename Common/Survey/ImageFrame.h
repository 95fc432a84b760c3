// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageFrame_h
#define SeismicHorizonsImageFrame_h

#include "LatticeFrame.h"

#include <Eigen/Core>

#include <array>

namespace SeismicHorizons
{
/// Where image data over a lattice lie in the world: they can be turned and stretched, but not sheared. The first two
/// axes are i and j.
struct ImageFrame
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero(); // of the index (0, 0, 0)
  Eigen::Vector3d Spacing = Eigen::Vector3d::Ones(); // positive
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> Direction = Eigen::Matrix3d::Identity(); // its columns are the axes
  int VerticalSign = 1; // the third index is k, or -k
  double Deviation = 0.0; // from a point to its place on the lattice, in columns, at most
};

// The first two throw InputError when ColumnStep and RowStep are not perpendicular.

/// The frame of a map at z = 0. z of the image is z of the world, whichever way vertical indices count.
ImageFrame MakeMapFrame(const LatticeMatrix& toWorld);

/// The frame of all voxels of a lattice, each at the place where the map puts it. The axes are always right-handed, as
/// ParaView draws no volume on others; where i, j and k are not, the third index is -k.
ImageFrame MakeVolumeFrame(const LatticeMatrix& toWorld);

/// The frame of a lattice whose columns are vertical. Where its steps are not perpendicular it is the one between them,
/// with the middle of the lattice in its place.
ImageFrame MakeCubeFrame(const LatticeMatrix& toWorld, const std::array<int, 2>& columns);
}

#endif
