// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageFrame_h
#define SeismicHorizonsImageFrame_h

#include "LatticeFrame.h"

#include <Eigen/Core>

#include <array>

namespace SeismicHorizons
{
/// An image can be rotated and stretched over a lattice, but not sheared. The first two axes are i and j.
struct ImageFrame
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero(); // of index (0, 0, 0)
  Eigen::Vector3d Spacing = Eigen::Vector3d::Ones(); // Positive.
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> Direction = Eigen::Matrix3d::Identity(); // columns are axes
  int VerticalSign = 1; // The third index is k or -k.
  double Deviation = 0.0; // Largest distance of a point from its place on the lattice, in columns.
};

// The first two functions throw InputError unless ColumnStep and RowStep are perpendicular.

/// The map is at z = 0, and its z is world z.
ImageFrame MakeMapFrame(const LatticeMatrix& toWorld);

/// The axes are right-handed, since ParaView renders no other volumes; the third index is -k if i, j and k are
/// left-handed.
ImageFrame MakeVolumeFrame(const LatticeMatrix& toWorld);

/// Steps that are not perpendicular are replaced by the nearest perpendicular steps, around the middle of the lattice.
ImageFrame MakeCubeFrame(const LatticeMatrix& toWorld, const std::array<int, 2>& columns);
}

#endif
