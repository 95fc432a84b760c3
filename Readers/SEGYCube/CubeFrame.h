// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCubeFrame_h
#define SeismicHorizonsCubeFrame_h

#include "Common/LatticePlacement.h"

#include <Eigen/Core>

#include <array>

namespace SeismicHorizons
{
/// Where the points of an image are. Images can be turned and stretched, but not sheared.
struct CubeFrame
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero(); // of point (0, 0, 0)
  Eigen::Vector3d Spacing = Eigen::Vector3d::Ones();
  Eigen::Matrix3d Direction = Eigen::Matrix3d::Identity(); // its columns are the axes
  double Deviation = 0.0; // from a point to its place on the lattice, in columns, at most
};

/// The frame of a lattice whose columns are vertical. Where its steps are not perpendicular it is the one between them,
/// with the middle of the lattice in its place.
CubeFrame MakeCubeFrame(const LatticeMatrix& toWorld, const std::array<int, 2>& columns);
}

#endif
