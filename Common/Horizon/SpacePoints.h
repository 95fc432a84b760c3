// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSpacePoints_h
#define SeismicHorizonsSpacePoints_h

#include "BoundedHorizon.h"
#include "Types.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Points with heights in lattice units, computed on access, so that methods that look at few points need no memory.
/// Keeps references.
class SpacePoints
{
public:
  SpacePoints(PlanePoints plane, const std::vector<double>& height, std::int32_t subVoxelsPerColumn)
    : Plane(plane)
    , Height(height.data())
    , PerSubVoxel(1.0 / subVoxelsPerColumn)
  {
  }

  SpacePoints(PlanePoints plane, std::function<double(std::size_t)> heightAt, std::int32_t subVoxelsPerColumn)
    : Plane(plane)
    , HeightAt(std::move(heightAt))
    , PerSubVoxel(1.0 / subVoxelsPerColumn)
  {
  }

  SpacePoints(const BoundedHorizon& horizon)
    : SpacePoints(horizon.Plane, horizon.Height, horizon.SubVoxelsPerColumn)
  {
  }

  std::size_t size() const { return this->Plane.size(); }

  SpacePoint operator[](std::size_t n) const
  {
    return { this->Plane[n].X * this->PerSubVoxel, this->Plane[n].Y * this->PerSubVoxel,
      this->Height ? this->Height[n] : this->HeightAt(n) };
  }

  PlanePoints Columns() const
  {
    assert(this->PerSubVoxel == 1.0);
    return this->Plane;
  }

private:
  const PlanePoints Plane;
  const double* const Height = nullptr; // Null if HeightAt is used.
  const std::function<double(std::size_t)> HeightAt;
  const double PerSubVoxel; // A power of two, so that products are exact.
};
}

#endif
