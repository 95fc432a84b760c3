// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The voxels that a ray passes through, one after the other (Amanatides and Woo, "A fast voxel traversal algorithm for
// ray tracing", 1987). At each step two borders are ahead of the ray, one across x and one across y. It goes on into
// the voxel behind the one that it meets first. (Thesis Alg. 5.2 advances along both axes at once.)
//
//      +-------+-------+-------+
//      |       |       | 4   / |        The ray starts at *, in voxel 0. It meets the border to the right of that voxel
//      +-------+-------+---/---+        before the one above, and goes on into voxel 1. Of voxel 1 it meets the border
//      |       |       | / 3   |        above first, and goes on into voxel 2.
//      |       | 2     /       |
//      |       |     / |       |
//      +-------+---/---+-------+
//      |       | / 1   |       |
//      | 0     /       |       |
//      |     * |       |       |
//      +-------+-------+-------+

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
  /// Starts at a place, in units of voxels and not below 0. The direction must not be zero.
  VoxelWalk(double x, double y, double directionX, double directionY)
    : AlongX(x, directionX)
    , AlongY(y, directionY)
  {
  }

  /// The voxel in which the walk is.
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
    // How far the next border is along the ray, and how far apart borders are, in units of the direction's length.
    double NextBorder = std::numeric_limits<double>::infinity();
    double BorderDistance = std::numeric_limits<double>::infinity();
  };

  Axis AlongX;
  Axis AlongY;
};
}

#endif
