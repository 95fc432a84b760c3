// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The regular grid whose columns hold the points of a horizon, and its units:
//  - lattice units: 1 is a column horizontally and a vertical index upwards;
//  - sub-voxels: a power of two per column, 2^20 at most, and fewer on lattices of more than 511 columns, since
//    coordinates stay below 2^29 for exact predicates. They are used once a simplification merges points.

#ifndef SeismicHorizonsLattice_h
#define SeismicHorizonsLattice_h

#include "Types.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace SeismicHorizons
{
/// The sine of the angle between the steps is at most 1e-9, or a step is 0.
bool AreParallel(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// In lattice units. Sums of products of heights stay finite, and heights keep three decimals.
constexpr double LargestHeight = double(std::int64_t(1) << 50);

constexpr int MostColumnsPerSide = (1 << 28) - 1;

class Lattice
{
public:
  Lattice() = default;

  /// `dimensions` are along i, j and k, below 2^28 along i and j; `toWorld` is affine and invertible, x and y do not
  /// depend on k, nor z on i and j. Otherwise throws InputError.
  Lattice(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& toWorld);

  Eigen::Vector3d ToLattice(const Eigen::Vector3d& world) const { return this->FromWorld * world; }
  Eigen::Vector3d ToWorld(const Eigen::Vector3d& lattice) const { return this->IntoWorld * lattice; }

  /// i and j are right-handed in the world, so that orientations agree, seen from +z.
  bool KeepsOrientation() const { return this->IntoWorld.linear().topLeftCorner<2, 2>().determinant() > 0.0; }

  double ColumnArea() const { return std::abs(this->IntoWorld.linear().topLeftCorner<2, 2>().determinant()); }

  /// Length of a lattice unit in the world if it is isotropic up to rounding, else 0.
  double UniformScale() const;

  std::int32_t SubVoxelsPerColumn() const { return std::int32_t(1) << this->SubVoxelBits; }

  double LargestCoordinate() const;

  /// The largest move along i or j, in columns, for a move of one unit along world x and y.
  double ColumnsPerUnit() const
  {
    return this->FromWorld.linear().topLeftCorner<2, 2>().cwiseAbs().rowwise().sum().maxCoeff();
  }

  /// Throws InputError for places that are not finite, more than half a column outside the lattice, or beyond
  /// LargestHeight.
  void CheckInside(const Eigen::Vector3d& lattice, PointId point) const
  {
    if (!this->IsInside(lattice))
    {
      this->ThrowOutside(lattice, point);
    }
  }

  /// Throws InputError as CheckInside does.
  PlanePoint ToSubVoxels(const Eigen::Vector3d& lattice, PointId point) const
  {
    this->CheckInside(lattice, point);
    // This rounds halves away from 0 as std::lround does, several times faster.
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
