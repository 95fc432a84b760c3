// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ClockwiseBoundary.h"

#include "Common/Horizon/ColumnIndex.h"
#include "CutFaces.h"
#include "Hops.h"
#include "PatchComponents.h"
#include "PlanarHops.h"
#include "SeamGaps.h"

#include <memory>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Most faces are small and enclose no column; walking one again is faster than remembering its hops.
constexpr std::size_t SmallestWalkToRemember = 16;

constexpr std::size_t Batch = 256;

std::unique_ptr<const CutBlocks> FindCutBlocks(
  const BoundaryOptions& options, PlanePoints columns, const ColumnIndex& index)
{
  return options.Cuts ? std::make_unique<const CutBlocks>(*options.Cuts, columns, index) : nullptr;
}

/// With cuts, holes without a loop are walked as well, and CutFaces decides which of them stay open.
class FaceFinder
{
public:
  FaceFinder(
    const ColumnIndex& index, const BoundaryOptions& options, const SeamPresence& seams, const Monitor& monitor)
    : Columns(index.Columns())
    , Options(options)
    , Index(index)
    , Hops(options.Radius, this->Index.Width())
    , Gaps(this->Columns, this->Index, options, seams)
    , Blocks(FindCutBlocks(options, this->Columns, this->Index))
    , Graph(this->Index, this->Hops, this->Gaps, this->Blocks.get(), monitor)
    , Parts(options.Cuts ? FindHopComponents(this->Columns, this->Index, this->Hops, this->Graph)
                         : FindPatchComponents(this->Index, this->Columns.size(), options.Radius))
    , Walked(this->Graph.Size() + 1, false)
    , WalksHoles(options.HoleBoundaries || options.Cuts)
  {
    if (options.Cuts)
    {
      this->Cracks.emplace(this->Columns, this->Index, this->Hops, *this->Blocks);
    }
    this->Gaps.Join(this->Index, this->Parts);
  }

  ExteriorBoundary Run(const Monitor& monitor)
  {
    this->WalkOutlines(monitor.Step(0.0, this->WalksHoles ? 0.4 : 0.9));
    if (this->WalksHoles)
    {
      this->WalkHoles(monitor.Step(0.4, 0.9));
    }
    if (this->Cracks)
    {
      this->Faces = this->Cracks->Select(this->Faces, this->Parts.First);
    }
    return this->Collect();
  }

  std::vector<CrackSide> FindCrackSides() const
  {
    return FindCrackFaces(this->Columns, this->Index, this->Hops, this->Graph);
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
      if (this->Cracks)
      {
        this->Cracks->AddOutline(this->Steps);
      }
      DropStepsInGaps(this->Steps);
      if (this->WalksHoles)
      {
        this->Remember();
      }
      AppendLoop(this->Columns, this->Steps, this->Faces);
    }
  }

  void WalkHoles(const Monitor& monitor)
  {
    const std::vector<std::int64_t>& places = this->Graph.PlacesBesideGaps();
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      if (n % Batch == 0)
      {
        monitor.Progress(double(n) / double(places.size()));
      }
      this->WalkHolesAt(places[n]);
    }
  }

  void WalkHolesAt(std::int64_t place)
  {
    const HopId first = this->Graph.Next(place, this->Hops.Size() - 1);
    HopId hop = first;
    while (hop != NoHop)
    {
      if (!this->Walked[this->Graph.NumberOf(place, hop)])
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
    const bool isHole = this->Options.HoleBoundaries && inside > 0 && inside >= this->Options.SmallestHoleSize;
    const bool hasLoop = this->Cracks ? this->Cracks->AddHole(this->Steps, isHole, inside > 0) : isHole;
    DropStepsInGaps(this->Steps);
    if (hasLoop || inside > 0 || this->Steps.size() >= SmallestWalkToRemember)
    {
      this->Remember();
    }
    if (hasLoop)
    {
      AppendLoop(this->Columns, this->Steps, this->Faces);
    }
  }

  void Walk(std::int64_t start, HopId first)
  {
    const auto next = [this](std::int64_t place, HopId from) { return this->Graph.Next(place, from); };
    WalkFace(this->Index, this->Hops, start, first, next, this->Steps);
  }

  void Remember()
  {
    for (const FaceStep& step : this->Steps)
    {
      this->Walked[this->Graph.NumberOf(this->Index.Place(this->Columns[step.Point]), step.Hop)] = true;
    }
    this->Walked.back() = false; // Hops between points that are not beside empty columns share this number.
  }

  /// Islands that belong to another patch lose their outlines.
  ExteriorBoundary Collect()
  {
    const std::vector<std::int32_t> patchOf = AssignIslands(this->Columns, this->Index, this->Parts.First, this->Faces);
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
      patch = number[patchOf[patch]];
    }
    return result;
  }

  const PlanePoints Columns;
  const BoundaryOptions& Options;
  const ColumnIndex& Index;
  const HopVectors Hops;
  const SeamGaps Gaps;
  const std::unique_ptr<const CutBlocks> Blocks; // null without cuts
  const PlanarHops Graph;
  PatchComponents Parts;
  Loops Faces; // Outlines of all components come first, loops of holes follow.
  std::vector<bool> Walked; // by number in Graph: the face on its left was walked
  const bool WalksHoles;
  std::optional<CutFaces> Cracks;
  std::vector<FaceStep> Steps;
};
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary FindClockwiseBoundary(const ColumnIndex& index, const BoundaryOptions& options,
  const SeamPresence& seams, std::vector<CrackSide>& cracks, const Monitor& monitor)
{
  FaceFinder finder(index, options, seams, monitor.Step(0.0, 0.5));
  cracks = finder.FindCrackSides();
  return finder.Run(monitor.Step(0.5, 1.0));
}
}
