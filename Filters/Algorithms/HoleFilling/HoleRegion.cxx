// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HoleRegion.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
HoleRegion::HoleRegion(const ColumnIndex& index, const RasterFrame& frame, const LinkCuts* cuts,
  const std::vector<std::int64_t>& hole, int ringWidth)
{
  std::int64_t leftmost = index.Width();
  std::int64_t rightmost = 0;
  for (const std::int64_t place : hole)
  {
    leftmost = std::min(leftmost, place % index.Width());
    rightmost = std::max(rightmost, place % index.Width());
  }
  const std::int64_t margin = ringWidth + SiteBox::Margin;
  const std::int64_t bottom = hole.front() / index.Width();
  const std::int64_t top = hole.back() / index.Width();
  this->First = (bottom - margin) * index.Width() + leftmost - margin;
  this->Turned = rightmost - leftmost > top - bottom;
  const auto inBox = [&](std::int64_t place)
  {
    const auto x = std::int32_t(place % index.Width() - (leftmost - margin));
    const auto y = std::int32_t(place / index.Width() - (bottom - margin));
    return this->Turned ? PlanePoint{ y, x } : PlanePoint{ x, y };
  };
  std::vector<BoxRun> runs;
  for (const std::int64_t place : hole)
  {
    const PlanePoint column = inBox(place);
    runs.push_back({ column.Y, column.X, column.X });
  }
  this->Near = std::make_shared<const BoxPlaces>(runs, int(margin));
  this->Kind.assign(std::size_t(this->Near->Size()), PlaceKind::Other);
  this->Point.assign(this->Kind.size(), NoPoint);
  this->HolePlaces.reserve(hole.size());
  for (const std::int64_t place : hole)
  {
    this->HolePlaces.push_back(this->Near->Find(inBox(place)));
    this->Kind[this->HolePlaces.back()] = PlaceKind::Hole;
  }
  if (cuts)
  {
    this->ReadCuts(frame, *cuts, index.Width());
  }
  this->AddRing(index, ringWidth);
}

//----------------------------------------------------------------------------------------------------------------------
void HoleRegion::ReadCuts(const RasterFrame& frame, const LinkCuts& cuts, std::int64_t rasterWidth)
{
  this->Cuts.resize(this->Kind.size());
  for (std::size_t place = 0; place < this->Cuts.size(); ++place)
  {
    const PlanePoint column = frame.Column(this->InRaster(std::int64_t(place), rasterWidth));
    const bool east = cuts.IsCutEast(column);
    const bool north = cuts.IsCutNorth(column);
    this->Cuts[place] = static_cast<unsigned char>(
      ((this->Turned ? north : east) ? EastBit : 0) | ((this->Turned ? east : north) ? NorthBit : 0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool HoleRegion::CanStep(std::int64_t place, int dx, int dy) const
{
  if (!this->HasCuts() || (dx == 0 && dy == 0))
  {
    return true;
  }
  if (dx == 0 || dy == 0)
  {
    return this->IsLinked(place, this->Near->Beside(place, dx, dy));
  }
  return this->IsWholeBlock(this->Near->Beside(place, dx < 0 ? -1 : 0, dy < 0 ? -1 : 0));
}

//----------------------------------------------------------------------------------------------------------------------
void HoleRegion::AddRing(const ColumnIndex& index, int ringWidth)
{
  std::vector<bool> reached(this->Kind.size(), false);
  std::vector<std::int64_t> front = this->HolePlaces;
  for (const std::int64_t place : front)
  {
    reached[place] = true;
  }
  std::vector<std::int64_t> next;
  for (int step = 0; step < ringWidth; ++step)
  {
    for (const std::int64_t place : front)
    {
      for (int n = 0; n < 9; ++n)
      {
        const std::int64_t neighbour = this->Near->Beside(place, n % 3 - 1, n / 3 - 1);
        if (!reached[neighbour] && this->CanStep(place, n % 3 - 1, n / 3 - 1))
        {
          reached[neighbour] = true;
          next.push_back(neighbour);
          const PointId point = index[this->InRaster(neighbour, index.Width())];
          this->Point[neighbour] = point;
          this->Kind[neighbour] = point == NoPoint ? PlaceKind::Other : PlaceKind::Ring;
        }
      }
    }
    front.swap(next);
    next.clear();
  }
}

//----------------------------------------------------------------------------------------------------------------------
SiteBox HoleRegion::MakeSites(bool withRing) const
{
  SiteBox box(this->Near);
  for (std::size_t place = 0; place < this->Kind.size(); ++place)
  {
    if (this->Kind[place] == PlaceKind::Hole || (withRing && this->Kind[place] == PlaceKind::Ring))
    {
      box.Add(std::int64_t(place));
    }
  }
  return box;
}
}
