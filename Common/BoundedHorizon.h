// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The input of the simplifications of the inside and of the triangulation.

#ifndef SeismicHorizonsBoundedHorizon_h
#define SeismicHorizonsBoundedHorizon_h

#include "LinkCuts.h"
#include "PlaneGeometry.h"
#include "Types.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// Places in sub-voxels, or those of columns, which are multiplied when they are asked for.
class SubVoxelPlaces
{
public:
  SubVoxelPlaces(PlanePoints places, std::int32_t factor)
    : Given(places)
    , Factor(factor)
  {
  }
  SubVoxelPlaces(const std::vector<PlanePoint>& places)
    : SubVoxelPlaces(places, 1)
  {
  }

  std::size_t size() const { return this->Given.size(); }
  PlanePoint operator[](std::size_t n) const { return this->Multiply(this->Given[n]); }

  PlaneBox Box() const
  {
    PlaneBox box(this->Given);
    if (!box.IsEmpty())
    {
      box.Least = this->Multiply(box.Least);
      box.Greatest = this->Multiply(box.Greatest);
    }
    return box;
  }

private:
  PlanePoint Multiply(const PlanePoint& place) const { return { place.X * this->Factor, place.Y * this->Factor }; }

  PlanePoints Given;
  std::int32_t Factor;
};

/// A horizon inside its boundary. The arrays have one entry per point.
struct BoundedHorizon
{
  std::vector<PlanePoint> Plane; // sub-voxels; or empty, and the places are
  PlanePoints Columns; // those of all points, which others own
  std::vector<double> Height; // lattice units
  std::vector<std::int32_t> Patch; // points of different patches are never merged
  std::vector<std::int64_t> Count; // how many points of the original horizon each one represents; empty: one
  Loops Boundary;
  std::int32_t SubVoxelsPerColumn = 1;
  std::shared_ptr<const LinkCuts> Cuts; // points on two sides of these are never merged; null: there are none

  /// Wherever they are from.
  SubVoxelPlaces Places() const
  {
    return this->Plane.empty() ? SubVoxelPlaces(this->Columns, this->SubVoxelsPerColumn) : SubVoxelPlaces(this->Plane);
  }
  /// The same where sub-voxels are columns.
  PlanePoints ColumnPlaces() const
  {
    assert(this->SubVoxelsPerColumn == 1);
    return this->Plane.empty() ? this->Columns : PlanePoints(this->Plane);
  }
};
}

#endif
