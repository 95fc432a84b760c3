// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchList.h"

#include "Common/Errors.h"

#include <algorithm>
#include <string>

namespace SeismicHorizons
{
namespace
{
std::int64_t CountPatches(const std::vector<std::int32_t>& patches)
{
  const auto range = std::minmax_element(patches.begin(), patches.end());
  if (*range.first < 0 || std::size_t(*range.second) >= patches.size())
  {
    throw InputError("patch numbers from " + std::to_string(*range.first) + " to " + std::to_string(*range.second) +
      ", expected numbers from 0 that are less than the " + std::to_string(patches.size()) + " points");
  }
  return std::int64_t(*range.second) + 1;
}

PointLists PointsByPatch(const BoundedHorizon& horizon, const std::vector<PointId>& points, std::int64_t patches)
{
  return PointLists(patches,
    [&](auto&& add)
    {
      for (const PointId point : points)
      {
        add(horizon.Patch[std::size_t(point)], point);
      }
    });
}

EdgeLists SidesByPatch(
  const BoundedHorizon& horizon, const FullBlocks& blocks, const std::vector<PointId>& loose, std::int64_t patches)
{
  return EdgeLists(patches,
    [&](auto&& add)
    {
      blocks.ForEachSide(horizon, loose,
        [&](PointId from, PointId to) {
          add(horizon.Patch[std::size_t(from)], Edge{ from, to });
        });
    });
}

ItemLists<std::size_t> LoopsByPatch(const BoundedHorizon& horizon, std::int64_t patches)
{
  return ItemLists<std::size_t>(patches,
    [&](auto&& add)
    {
      for (std::size_t loop = 0; loop < horizon.Boundary.Size(); ++loop)
      {
        add(horizon.Patch[std::size_t(*horizon.Boundary.begin(loop))], loop);
      }
    });
}
}

//----------------------------------------------------------------------------------------------------------------------
PatchList::PatchList(const BoundedHorizon& horizon, const PlaneFrame& frame, const FullBlocks& blocks)
  : Horizon(horizon)
  , Frame(frame)
  , Patches(CountPatches(horizon.Patch))
  , Loose(blocks.FindLoosePoints(horizon))
  , Points(PointsByPatch(horizon, this->Loose, this->Patches))
  , LoopsOf(LoopsByPatch(horizon, this->Patches))
  , BlockSides(SidesByPatch(horizon, blocks, this->Loose, this->Patches))
  , LocalNumber(horizon.Patch.size())
{
}

//----------------------------------------------------------------------------------------------------------------------
Patch PatchList::Get(std::int64_t number)
{
  Patch patch;
  patch.Points.assign(this->Points.begin(number), this->Points.end(number));
  patch.Places.reserve(patch.Points.size());
  for (const PointId point : patch.Points)
  {
    this->LocalNumber[std::size_t(point)] = PointId(patch.Places.size());
    patch.Places.push_back(this->Horizon.Plane[std::size_t(point)]);
  }
  if (!patch.Places.empty())
  {
    patch.Frame = PlaneFrame(patch.Places);
    // The unit is that of all points, as those that blocks cover may lie between those that are left.
    patch.Frame.Shift = this->Frame.Shift;
  }
  for (PlanePoint& place : patch.Places)
  {
    place = patch.Frame.Inward(place);
  }
  for (const std::size_t* loop = this->LoopsOf.begin(number); loop != this->LoopsOf.end(number); ++loop)
  {
    this->AddLoop(*loop, std::int32_t(number), patch);
  }
  for (const Edge* side = this->BlockSides.begin(number); side != this->BlockSides.end(number); ++side)
  {
    patch.BlockSides.push_back({ this->NumberInPatch(side->From), this->NumberInPatch(side->To) });
  }
  return patch;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchList::AddLoop(std::size_t loop, std::int32_t number, Patch& patch) const
{
  const Loops& boundary = this->Horizon.Boundary;
  for (const PointId* point = boundary.begin(loop); point != boundary.end(loop); ++point)
  {
    const std::int32_t found = this->Horizon.Patch[std::size_t(*point)];
    if (found != number)
    {
      throw InputError("boundary loop " + std::to_string(loop) + " runs from patch " + std::to_string(number) +
        " to patch " + std::to_string(found) + " at point " + std::to_string(*point) +
        ", expected loops that stay in one patch");
    }
    patch.Boundary.Append(this->NumberInPatch(*point));
  }
  patch.Boundary.Close();
}
}
