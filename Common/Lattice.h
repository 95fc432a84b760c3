// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The regular grid a horizon lives on, and the two ways in which the algorithms see a place on it:
//  - lattice units: 1 is one column sideways and one vertical index upwards;
//  - sub-voxels: the plane coordinates as integers, each column cut into a power of two. As fine as 30-bit numbers
//    allow, so that every question the triangulation asks of them has an exact answer in integers.

#ifndef SeismicHorizonsLattice_h
#define SeismicHorizonsLattice_h

#include "Types.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace SeismicHorizons
{
class Lattice
{
public:
  Lattice() = default;

  /// `toWorld` is the affine map from (i, j, k) to world coordinates. Throws InputError on dimensions that are not
  /// positive or exceed 2^28 columns a side, and on a map that is not finite, not affine, can not be inverted or
  /// tilts columns against each other (x and y may not depend on k, nor z on i and j).
  Lattice(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& toWorld);

  Eigen::Vector3d ToLattice(const Eigen::Vector3d& world) const { return this->FromWorld * world; }
  Eigen::Vector3d ToWorld(const Eigen::Vector3d& lattice) const { return this->IntoWorld * lattice; }

  /// True when i, j, k are a right-handed frame in the world's x, y plane: then what turns counter-clockwise on the
  /// lattice does so in the world, seen from +z.
  bool KeepsOrientation() const { return this->IntoWorld.linear().topLeftCorner<2, 2>().determinant() > 0.0; }

  /// The area of a column seen from above, in square units of the world.
  double ColumnArea() const { return std::abs(this->IntoWorld.linear().topLeftCorner<2, 2>().determinant()); }

  /// The length of a lattice unit in the world where it is the same in all directions, to rounding; else 0.
  double UniformScale() const;

  /// How many times a column is halved to give sub-voxels.
  int GetSubVoxelBits() const { return this->SubVoxelBits; }
  std::int32_t SubVoxelsPerColumn() const { return std::int32_t(1) << this->SubVoxelBits; }

  /// The sub-voxel nearest to a place in lattice units. Throws InputError when it is not finite or lies outside the
  /// lattice by more than half a column; `point` names it in the message.
  PlanePoint ToSubVoxels(const Eigen::Vector3d& lattice, PointId point) const;

  double ToLatticeUnits(std::int32_t subVoxels) const { return double(subVoxels) / this->SubVoxelsPerColumn(); }

private:
  std::array<int, 3> Dimensions = { 1, 1, 1 };
  Eigen::Affine3d IntoWorld = Eigen::Affine3d::Identity();
  Eigen::Affine3d FromWorld = Eigen::Affine3d::Identity();
  int SubVoxelBits = 0;
};
}

#endif
