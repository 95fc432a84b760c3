// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops that follow the borders of what hangs together from column to neighbouring column, in one pass over the lattice
// (Suzuki and Abe, "Topological structural analysis of digitized binary images by border following", 1985).
//
// The rows are read from left to right, and at every column it is known whether it lies inside a patch. Where a row
// comes from outside upon an occupied column that no walk has touched yet, a new patch begins, and its border is walked
// at once. Where a row leaves a patch the walk has left a mark: it looked at the empty column to the right. All that
// lies between entering and leaving belongs to the patch. Holes that have loops are walked where a row meets them
// first, and then are outside; all others are inside, islands included.

#ifndef SeismicHorizonsBorderScan_h
#define SeismicHorizonsBorderScan_h

#include "ColumnRaster.h"
#include "ExteriorBoundary.h"
#include "FaceWalk.h"

#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// What one sweep around a point found.
struct BorderTurn
{
  HopId Next; // the hop to go on with, or NoHop
  bool PassedEast; // whether the sweep looked at the column to the right, and found it empty
};

/// `Sweep` knows the hops of the graph: its Turn(place, from) sweeps clockwise after `from`, which ends the sweep.
template <typename Sweep>
class BorderScan
{
public:
  BorderScan(const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops, Sweep sweep,
    const BoundaryOptions& options)
    : Columns(columns)
    , Raster(raster)
    , Hops(hops)
    , Turns(std::move(sweep))
    , Options(options)
    , West(hops.Find({ -1, 0 }))
    , East(hops.Find({ 1, 0 }))
    , OutsideEast(columns.size(), false)
    , FilledHoleEast(options.HoleBoundaries ? columns.size() : 0, false)
  {
    this->Result.Patch.assign(columns.size(), -1);
  }

  ExteriorBoundary Run(const Monitor& monitor)
  {
    for (std::int64_t row = 0; row < this->Raster.Height(); ++row)
    {
      if (row % 64 == 0)
      {
        monitor.Progress(double(row) / double(this->Raster.Height()));
      }
      this->NumberRow(row * this->Raster.Width());
    }
    this->Result.NumberOfPatches = this->Result.Boundary.Size();
    for (std::size_t loop = 0; loop < this->HoleLoops.Size(); ++loop)
    {
      this->Result.Boundary.AppendLoop(this->HoleLoops, loop);
    }
    return std::move(this->Result);
  }

private:
  void NumberRow(std::int64_t first)
  {
    std::int32_t inside = -1;
    for (std::int64_t place = first; place < first + this->Raster.Width(); ++place)
    {
      const PointId point = this->Raster[place];
      if (point == NoPoint)
      {
        continue;
      }
      std::int32_t& patch = this->Result.Patch[std::size_t(point)];
      if (inside < 0)
      {
        if (patch < 0)
        {
          this->WalkOutline(place);
        }
        inside = patch;
      }
      patch = inside;
      if (this->OutsideEast[std::size_t(point)] || this->EntersHole(place, inside))
      {
        inside = -1;
      }
    }
  }

  /// Walks the border of the patch at a place whose western neighbour is outside.
  void WalkOutline(std::int64_t start)
  {
    this->Walk(start, this->West);
    this->NumberSteps(std::int32_t(this->Result.Boundary.Size()));
    AppendLoop(this->Columns, this->Steps, this->Result.Boundary);
    this->Mark(this->OutsideEast);
  }

  /// True when a hole that gets a loop lies to the right of a place. Of one that gets none the rim is remembered, and
  /// so is the border of an island in it, which turns the other way and has no columns inside.
  bool EntersHole(std::int64_t place, std::int32_t patch)
  {
    if (!this->Options.HoleBoundaries || this->Raster[place + 1] != NoPoint ||
      this->FilledHoleEast[std::size_t(this->Raster[place])])
    {
      return false;
    }
    this->Walk(place, this->East);
    const std::int64_t size = ColumnsInside(this->Hops, this->Steps);
    const bool isKept = size > 0 && size >= this->Options.SmallestHoleSize;
    if (isKept)
    {
      this->NumberSteps(patch);
      AppendLoop(this->Columns, this->Steps, this->HoleLoops);
    }
    this->Mark(isKept ? this->OutsideEast : this->FilledHoleEast);
    return isKept;
  }

  void Walk(std::int64_t start, HopId from)
  {
    this->PastEast.clear();
    const auto turn = [this](std::int64_t place, HopId last)
    {
      const BorderTurn result = this->Turns.Turn(place, last);
      if (result.PassedEast)
      {
        this->PastEast.push_back(this->Raster[place]);
      }
      return result.Next;
    };
    WalkFace(this->Raster, this->Hops, start, turn(start, from), turn, this->Steps);
  }

  void NumberSteps(std::int32_t patch)
  {
    for (const FaceStep& step : this->Steps)
    {
      this->Result.Patch[std::size_t(step.Point)] = patch;
    }
  }

  void Mark(std::vector<bool>& marks) const
  {
    for (const PointId point : this->PastEast)
    {
      marks[std::size_t(point)] = true;
    }
  }

  const std::vector<PlanePoint>& Columns;
  const ColumnRaster& Raster;
  const HopVectors& Hops;
  Sweep Turns;
  const BoundaryOptions& Options;
  const HopId West;
  const HopId East;
  ExteriorBoundary Result;
  Loops HoleLoops;
  std::vector<bool> OutsideEast; // outside begins to the right
  std::vector<bool> FilledHoleEast; // a hole without a loop begins to the right
  std::vector<FaceStep> Steps; // of the walk that was last
  std::vector<PointId> PastEast; // points of that walk with its empty side to the right
};
}

#endif
