// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The regular grid whose columns hold the points of a horizon, and the two units of places on it:
//  - lattice units: 1 is one column sideways, and one vertical index upwards;
//  - sub-voxels: coordinates in the plane as integers. Each column is cut into a power of two, 2^20 at most, and fewer
//    on lattices of more than 511 columns: coordinates stay below 2^29, so that the predicates are exact.
// Points stand on whole columns until a simplification merges some: only then are there sub-voxels.

#ifndef SeismicHorizonsLattice_h
#define SeismicHorizonsLattice_h

#include "Types.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace SeismicHorizons
{
/// Whether the steps from a column to its two neighbours are too nearly parallel to span a lattice: the sine of the
/// angle between them is at most 1e-9, or one of them is 0. Lengths do not matter otherwise.
bool AreParallel(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// How far up or down a point may be, in lattice units. Products of heights and their sums over all points stay finite,
/// and heights are still known to a thousandth.
constexpr double LargestHeight = double(std::int64_t(1) << 50);

/// The most columns along a side of a lattice.
constexpr int MostColumnsPerSide = (1 << 28) - 1;

class Lattice
{
public:
  Lattice() = default;

  /// `dimensions` are the numbers of columns along i and j and of vertical indices; `toWorld` is the affine map from
  /// (i, j, k) to world coordinates. Throws InputError on dimensions that are not positive, on 2^28 columns or more
  /// along i or j, and on a map that is not finite, not affine, cannot be inverted, or whose columns are not vertical:
  /// x and y may not depend on k, nor z on i and j.
  Lattice(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& toWorld);

  Eigen::Vector3d ToLattice(const Eigen::Vector3d& world) const { return this->FromWorld * world; }
  Eigen::Vector3d ToWorld(const Eigen::Vector3d& lattice) const { return this->IntoWorld * lattice; }

  /// True when i, j, k are a right-handed frame in the world's x, y plane: then what turns counter-clockwise on the
  /// lattice does so in the world, seen from +z.
  bool KeepsOrientation() const { return this->IntoWorld.linear().topLeftCorner<2, 2>().determinant() > 0.0; }

  /// The area of a column seen from above, in square units of the world.
  double ColumnArea() const { return std::abs(this->IntoWorld.linear().topLeftCorner<2, 2>().determinant()); }

  /// The length of a lattice unit in the world, when it is the same in all directions up to rounding; else 0.
  double UniformScale() const;

  /// How many sub-voxels a column has along i and along j: a power of two.
  std::int32_t SubVoxelsPerColumn() const { return std::int32_t(1) << this->SubVoxelBits; }

  /// The largest size that an x or y in the world has on the lattice.
  double LargestCoordinate() const;

  /// By how many columns a place moves at most, along i or j, when both its x and y move by one unit of the world.
  double ColumnsPerUnit() const
  {
    return this->FromWorld.linear().topLeftCorner<2, 2>().cwiseAbs().rowwise().sum().maxCoeff();
  }

  /// Throws InputError when a place in lattice units is not finite, lies outside the lattice by more than half a
  /// column, or is further up or down than LargestHeight; `point` names it in the message.
  void CheckInside(const Eigen::Vector3d& lattice, PointId point) const
  {
    if (!this->IsInside(lattice))
    {
      this->ThrowOutside(lattice, point);
    }
  }

  /// The sub-voxel nearest to a place in lattice units. Throws InputError as CheckInside does.
  PlanePoint ToSubVoxels(const Eigen::Vector3d& lattice, PointId point) const
  {
    this->CheckInside(lattice, point);
    // Halves are rounded away from 0, as std::lround does, which takes several times as long.
    const auto round = [](double value) { return std::int32_t(value + (value < 0.0 ? -0.5 : 0.5)); };
    const double scale = this->SubVoxelsPerColumn();
    return { round(lattice.x() * scale), round(lattice.y() * scale) };
  }

  double ToLatticeUnits(std::int32_t subVoxels) const { return double(subVoxels) / this->SubVoxelsPerColumn(); }

private:
  bool IsInside(const Eigen::Vector3d& lattice) const
  {
    return std::abs(lattice.z()) <= LargestHeight && lattice.x() >= -0.5 && lattice.x() <= this->Dimensions[0] - 0.5 &&
      lattice.y() >= -0.5 && lattice.y() <= this->Dimensions[1] - 0.5;
  }
  [[noreturn]] void ThrowOutside(const Eigen::Vector3d& lattice, PointId point) const;

  std::array<int, 3> Dimensions = { 1, 1, 1 };
  Eigen::Affine3d IntoWorld = Eigen::Affine3d::Identity();
  Eigen::Affine3d FromWorld = Eigen::Affine3d::Identity();
  int SubVoxelBits = 0;
};
}

#endif
