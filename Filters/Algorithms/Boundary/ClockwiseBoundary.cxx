// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ClockwiseBoundary.h"

#include "ColumnRaster.h"
#include "FaceWalk.h"
#include "Islands.h"
#include "PatchComponents.h"
#include "PlanarHops.h"

#include <utility>

namespace SeismicHorizons
{
namespace
{
// Most faces are small and have no column inside. To walk such a one again takes less time than to remember its hops.
constexpr std::size_t SmallestWalkToRemember = 16;

/// Walks the faces of the graph: first the outlines of all components, then the holes.
class FaceFinder
{
public:
  FaceFinder(const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const Monitor& monitor)
    : Columns(columns)
    , Options(options)
    , Raster(columns, 2 * options.Radius)
    , Hops(options.Radius, this->Raster.Width())
    , Graph(this->Raster, columns.size(), this->Hops, monitor)
    , Parts(FindPatchComponents(this->Raster, columns.size(), options.Radius))
    , Walked(this->Graph.Size() + 1, false)
  {
  }

  ExteriorBoundary Run(const Monitor& monitor)
  {
    this->WalkOutlines(monitor.Step(0.0, this->Options.HoleBoundaries ? 0.4 : 0.9));
    if (this->Options.HoleBoundaries)
    {
      this->WalkHoles(monitor.Step(0.4, 0.9));
    }
    return this->Collect();
  }

private:
  void WalkOutlines(const Monitor& monitor)
  {
    const HopId west = this->Hops.Find({ -1, 0 });
    for (std::size_t part = 0; part < this->Parts.First.size(); ++part)
    {
      if (part % 64 == 0)
      {
        monitor.Progress(double(part) / double(this->Parts.First.size()));
      }
      const std::int64_t start = this->Parts.First[part];
      this->Walk(start, this->Graph.Next(start, west));
      if (this->Options.HoleBoundaries)
      {
        this->Remember();
      }
      AppendLoop(this->Columns, this->Steps, this->Faces);
    }
  }

  void WalkHoles(const Monitor& monitor)
  {
    for (std::int64_t row = 0; row < this->Raster.Height(); ++row)
    {
      if (row % 16 == 0)
      {
        monitor.Progress(double(row) / double(this->Raster.Height()));
      }
      const std::int64_t end = (row + 1) * this->Raster.Width();
      for (std::int64_t place = row * this->Raster.Width(); place < end; ++place)
      {
        if (this->Raster[place] != NoPoint && this->MayBeAtHole(place))
        {
          this->WalkHolesAt(place);
        }
      }
    }
  }

  /// Whether a point has an empty column beside it that has another one beside it. Around a point among eight others
  /// all faces are triangles between neighbours. An empty column among eight points lies on the hop that spans it, and
  /// in no face. So each face with columns inside has such points only.
  bool MayBeAtHole(std::int64_t place) const
  {
    const auto isEmpty = [this](std::int64_t column) { return this->Raster[column] == NoPoint; };
    return this->HasNeighbour(
      place, [&](std::int64_t column) { return isEmpty(column) && this->HasNeighbour(column, isEmpty); });
  }

  template <typename Condition>
  bool HasNeighbour(std::int64_t place, Condition&& condition) const
  {
    const std::int64_t up = this->Raster.Width();
    for (const std::int64_t offset : { std::int64_t(1), up + 1, up, up - 1, std::int64_t(-1), -up - 1, -up, 1 - up })
    {
      if (condition(place + offset))
      {
        return true;
      }
    }
    return false;
  }

  /// Walks the faces on the left of all hops from a place, but for those that are remembered.
  void WalkHolesAt(std::int64_t place)
  {
    const HopId first = this->Graph.Next(place, this->Hops.Size() - 1);
    HopId hop = first;
    while (hop != NoHop)
    {
      if (!this->Walked[this->NumberOf({ this->Raster[place], hop })])
      {
        this->WalkHole(place, hop);
      }
      hop = this->Graph.Next(place, hop);
      hop = hop == first ? NoHop : hop;
    }
  }

  void WalkHole(std::int64_t place, HopId hop)
  {
    this->Walk(place, hop);
    const std::int64_t inside = ColumnsInside(this->Hops, this->Steps);
    if (inside > 0 || this->Steps.size() >= SmallestWalkToRemember)
    {
      this->Remember();
    }
    if (inside > 0 && inside >= this->Options.SmallestHoleSize)
    {
      AppendLoop(this->Columns, this->Steps, this->Faces);
    }
  }

  void Walk(std::int64_t start, HopId first)
  {
    const auto next = [this](std::int64_t place, HopId from) { return this->Graph.Next(place, from); };
    WalkFace(this->Raster, this->Hops, start, first, next, this->Steps);
  }

  std::size_t NumberOf(const FaceStep& step) const { return this->Graph.NumberOf(step.Point, step.Hop); }

  /// Remembers the hops of the last walk.
  void Remember()
  {
    for (const FaceStep& step : this->Steps)
    {
      this->Walked[this->NumberOf(step)] = true;
    }
    this->Walked.back() = false; // the graph has this number for all hops between points with eight neighbours
  }

  /// Leaves out the outlines of islands that belong to another patch, and numbers the patches.
  ExteriorBoundary Collect()
  {
    const std::vector<std::int32_t> patchOf =
      AssignIslands(this->Columns, this->Raster, this->Parts.First, this->Faces);
    ExteriorBoundary result;
    std::vector<std::int32_t> number(patchOf.size(), NoPatch);
    for (std::size_t part = 0; part < number.size(); ++part)
    {
      if (patchOf[part] == std::int32_t(part))
      {
        number[part] = std::int32_t(result.Boundary.Size());
        result.Boundary.AppendLoop(this->Faces, part);
      }
    }
    result.NumberOfPatches = result.Boundary.Size();
    for (std::size_t loop = number.size(); loop < this->Faces.Size(); ++loop)
    {
      result.Boundary.AppendLoop(this->Faces, loop);
    }
    result.Patch = std::move(this->Parts.Component);
    for (std::int32_t& patch : result.Patch)
    {
      patch = number[std::size_t(patchOf[std::size_t(patch)])];
    }
    return result;
  }

  const std::vector<PlanePoint>& Columns;
  const BoundaryOptions& Options;
  const ColumnRaster Raster;
  const HopVectors Hops;
  const PlanarHops Graph;
  PatchComponents Parts;
  Loops Faces; // the outlines of all components, then the loops of holes
  std::vector<bool> Walked; // by the numbers of hops in the graph: the face to the left was walked
  std::vector<FaceStep> Steps; // of the last walk
};
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary FindClockwiseBoundary(
  const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const Monitor& monitor)
{
  return FaceFinder(columns, options, monitor.Step(0.0, 0.5)).Run(monitor.Step(0.5, 1.0));
}
}
