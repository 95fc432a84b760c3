// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds all loops in one pass over the lattice, where patches are connected from column to neighbouring column (Suzuki
// and Abe, "Topological structural analysis of digitized binary images by border following", 1985).
//
// The rows are read from left to right, and at every column it is known whether it lies inside a patch. Where a row
// comes from outside to a point that no walk has visited yet, a new patch begins, and its outline is walked at once.
// The walk marks the points that have its outer side to their right: there the rows leave the patch. All points between
// entering and leaving a patch belong to it. The loop of a hole is walked where a row meets the hole first, and what is
// in the hole counts as outside then. In a hole that gets no loop everything belongs to the patch, islands included.
//
//      . . # # # . .        The row in the middle enters the patch at its first point, and leaves it at its second one,
//      . . # . # . .        which the walk around the patch has marked. The empty column between them is in a hole.
//      . . # # # . .

#ifndef SeismicHorizonsBorderScan_h
#define SeismicHorizonsBorderScan_h

#include "ColumnRaster.h"
#include "ExteriorBoundary.h"
#include "FaceWalk.h"

#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// What a sweep around a point found.
struct SweepResult
{
  HopId Next; // the hop that the walk leaves the point by, or NoHop
  bool PassedEast; // whether the sweep passed the column to the right, which is empty then
};

/// `Graph` is a plane graph of hops: its Sweep(place, from) gives the first hop of the graph from a place that a
/// clockwise sweep after `from` meets, where `from` comes last; its LeadsEast(place) tells whether there is a hop to
/// the column to the right.
template <typename Graph>
class BorderScan
{
public:
  BorderScan(const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops, Graph graph,
    const BoundaryOptions& options)
    : Columns(columns)
    , Raster(raster)
    , Hops(hops)
    , HopGraph(std::move(graph))
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
  /// Gives the points of a row to their patches, and walks the loops that it meets first.
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

  /// Walks the outline of a new patch from a place with the outside to its left.
  void WalkOutline(std::int64_t start)
  {
    this->Walk(start, this->West);
    this->NumberSteps(std::int32_t(this->Result.Boundary.Size()));
    AppendLoop(this->Columns, this->Steps, this->Result.Boundary);
    this->Mark(this->OutsideEast);
  }

  /// True when a hole that gets a loop lies to the right of a place. The points around one that gets none are marked,
  /// so that it is walked once; so are those of islands in it, whose outlines run the other way and so have no size.
  bool EntersHole(std::int64_t place, std::int32_t patch)
  {
    if (!this->Options.HoleBoundaries || this->HopGraph.LeadsEast(place) ||
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
    const auto next = [this](std::int64_t place, HopId last)
    {
      const SweepResult result = this->HopGraph.Sweep(place, last);
      if (result.PassedEast)
      {
        this->PastEast.push_back(this->Raster[place]);
      }
      return result.Next;
    };
    WalkFace(this->Raster, this->Hops, start, next(start, from), next, this->Steps);
  }

  /// Gives the points of the last walk to a patch.
  void NumberSteps(std::int32_t patch)
  {
    DropStepsInGaps(this->Steps);
    for (const FaceStep& step : this->Steps)
    {
      this->Result.Patch[std::size_t(step.Point)] = patch;
    }
  }

  /// Marks the points of the last walk whose sweeps passed the column to their right.
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
  Graph HopGraph;
  const BoundaryOptions& Options;
  const HopId West;
  const HopId East;
  ExteriorBoundary Result;
  Loops HoleLoops;
  std::vector<bool> OutsideEast; // by point: the outside of its patch begins to the right
  std::vector<bool> FilledHoleEast; // by point: a hole without a loop begins to the right
  std::vector<FaceStep> Steps; // of the last walk
  std::vector<PointId> PastEast; // points of the last walk whose sweeps passed the column to their right
};
}

#endif
