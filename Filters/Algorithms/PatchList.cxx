// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchList.h"

#include "Errors.h"

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

PointLists DealOutPoints(const BoundedHorizon& horizon, std::int64_t patches)
{
  return PointLists(patches,
    [&](auto&& add)
    {
      for (std::size_t point = 0; point < horizon.Patch.size(); ++point)
      {
        add(horizon.Patch[point], PointId(point));
      }
    });
}

CellLists<std::size_t> DealOutLoops(const BoundedHorizon& horizon, std::int64_t patches)
{
  return CellLists<std::size_t>(patches,
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
Frame Normalise(std::vector<PlanePoint>& places)
{
  PlanePoint least = places.front();
  for (const PlanePoint& place : places)
  {
    least = { std::min(least.X, place.X), std::min(least.Y, place.Y) };
  }
  std::int32_t bits = 0;
  for (const PlanePoint& place : places)
  {
    bits |= (place.X - least.X) | (place.Y - least.Y);
  }
  int shift = 0;
  while (bits != 0 && ((bits >> shift) & 1) == 0)
  {
    ++shift;
  }
  for (PlanePoint& place : places)
  {
    place = { (place.X - least.X) >> shift, (place.Y - least.Y) >> shift };
  }
  return { least, shift };
}

//----------------------------------------------------------------------------------------------------------------------
PatchList::PatchList(const BoundedHorizon& horizon)
  : Horizon(horizon)
  , Patches(CountPatches(horizon.Patch))
  , Points(DealOutPoints(horizon, this->Patches))
  , LoopsOf(DealOutLoops(horizon, this->Patches))
  , LocalNumber(horizon.Patch.size(), NoPoint)
{
}

//----------------------------------------------------------------------------------------------------------------------
Patch PatchList::Get(std::int64_t number)
{
  Patch patch;
  patch.Points.assign(this->Points.begin(number), this->Points.end(number));
  patch.Places.resize(patch.Points.size());
  for (std::size_t point = 0; point < patch.Points.size(); ++point)
  {
    this->LocalNumber[std::size_t(patch.Points[point])] = PointId(point);
    patch.Places[point] = this->Horizon.Plane[std::size_t(patch.Points[point])];
  }
  if (!patch.Places.empty())
  {
    patch.PlacesFrame = Normalise(patch.Places);
  }
  for (const std::size_t* loop = this->LoopsOf.begin(number); loop != this->LoopsOf.end(number); ++loop)
  {
    this->AddLoop(*loop, std::int32_t(number), patch);
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
    patch.Boundary.Append(this->LocalNumber[std::size_t(*point)]);
  }
  patch.Boundary.Close();
}
}
