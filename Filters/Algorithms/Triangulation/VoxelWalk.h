// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The voxels that a ray meets, one after the other (Amanatides and Woo, "A fast voxel traversal algorithm for ray
// tracing", 1987; thesis Alg. 5.2, which advances along all axes at once where the paper, and this, take the axis whose
// next voxel border is nearest).

#ifndef SeismicHorizonsVoxelWalk_h
#define SeismicHorizonsVoxelWalk_h

#include <cmath>
#include <cstdint>
#include <limits>

namespace SeismicHorizons
{
class VoxelWalk
{
public:
  /// Starts at a place, in units of voxels and not below 0, and goes in a direction that is not zero.
  VoxelWalk(double x, double y, double directionX, double directionY)
    : AlongX(x, directionX)
    , AlongY(y, directionY)
  {
  }

  std::int64_t X() const { return this->AlongX.Voxel; }
  std::int64_t Y() const { return this->AlongY.Voxel; }

  void Next()
  {
    Axis& nearest = this->AlongX.NextBorder < this->AlongY.NextBorder ? this->AlongX : this->AlongY;
    nearest.Voxel += nearest.Step;
    nearest.NextBorder += nearest.BorderDistance;
  }

private:
  struct Axis
  {
    Axis(double start, double direction)
      : Voxel(std::int64_t(start))
      , Step(direction < 0.0 ? -1 : 1)
    {
      if (direction != 0.0)
      {
        const double border = double(this->Voxel) + (direction < 0.0 ? 0.0 : 1.0);
        this->NextBorder = (border - start) / direction;
        this->BorderDistance = 1.0 / std::abs(direction);
      }
    }

    std::int64_t Voxel;
    std::int64_t Step;
    // How far along the ray the next border is, and how far apart borders are.
    double NextBorder = std::numeric_limits<double>::infinity();
    double BorderDistance = std::numeric_limits<double>::infinity();
  };

  Axis AlongX;
  Axis AlongY;
};
}

#endif
