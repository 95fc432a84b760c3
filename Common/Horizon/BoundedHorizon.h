// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The input of the interior simplification and the triangulation.

#ifndef SeismicHorizonsBoundedHorizon_h
#define SeismicHorizonsBoundedHorizon_h

#include "DroppedPoints.h"
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

/// A vertex that stays, at a height that need not be that of its point.
struct LockedHeight
{
  PointId Point = NoPoint;
  double Height = 0.0;
};

struct BoundedHorizon
{
  std::vector<PlanePoint> Plane; // sub-voxels; empty if places are columns
  PlanePoints Columns; // Not owned.
  std::vector<double> Height; // lattice units
  std::vector<std::int32_t> Patch; // Points of different patches are never merged.
  std::vector<std::int64_t> Count; // Original points per point; empty for one each.
  Loops Boundary;
  std::int32_t SubVoxelsPerColumn = 1;
  /// These have no patch, but their heights count on links that cross edges, and where they lie on loops.
  DroppedPoints Dropped;
  std::vector<PointId> Beside; // dropped points of other parts: no point is inserted where edges cross links to them
  std::vector<LockedHeight> Locked; // points of loops, ascending
  std::shared_ptr<const LinkCuts> Cuts; // Points on different sides of cuts are never merged; null without cuts.

  SubVoxelPlaces Places() const
  {
    return this->Plane.empty() ? SubVoxelPlaces(this->Columns, this->SubVoxelsPerColumn) : SubVoxelPlaces(this->Plane);
  }
  PlanePoints ColumnPlaces() const
  {
    assert(this->SubVoxelsPerColumn == 1);
    return this->Plane.empty() ? this->Columns : PlanePoints(this->Plane);
  }
};
}

#endif
