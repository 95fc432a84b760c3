// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapRegion.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
GapRegion::GapRegion(const ColumnIndex& index, const RasterFrame& frame, const LinkCuts* cuts,
  const std::vector<std::int64_t>& gap, int ringWidth)
{
  std::int64_t leftmost = index.Width();
  std::int64_t rightmost = 0;
  for (const std::int64_t place : gap)
  {
    leftmost = std::min(leftmost, place % index.Width());
    rightmost = std::max(rightmost, place % index.Width());
  }
  const std::int64_t margin = ringWidth + SiteBox::Margin;
  const std::int64_t bottom = gap.front() / index.Width();
  this->Width = rightmost - leftmost + 1 + 2 * margin;
  this->Height = gap.back() / index.Width() - bottom + 1 + 2 * margin;
  this->First = (bottom - margin) * index.Width() + leftmost - margin;
  this->Turned = this->Width > this->Height;
  if (this->Turned)
  {
    std::swap(this->Width, this->Height);
  }
  this->Kind.assign(std::size_t(this->Width * this->Height), PlaceKind::Other);
  this->Point.assign(this->Kind.size(), NoPoint);
  this->GapPlaces.reserve(gap.size());
  for (const std::int64_t place : gap)
  {
    const std::int64_t x = place % index.Width() - (leftmost - margin);
    const std::int64_t y = place / index.Width() - (bottom - margin);
    this->GapPlaces.push_back(this->Turned ? x * this->Width + y : y * this->Width + x);
    this->Kind[this->GapPlaces.back()] = PlaceKind::Gap;
  }
  if (cuts)
  {
    this->ReadCuts(frame, *cuts, index.Width());
  }
  this->AddRing(index, ringWidth);
}

//----------------------------------------------------------------------------------------------------------------------
void GapRegion::ReadCuts(const RasterFrame& frame, const LinkCuts& cuts, std::int64_t rasterWidth)
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
bool GapRegion::CanStep(std::int64_t place, int dx, int dy) const
{
  if (!this->HasCuts() || (dx == 0 && dy == 0))
  {
    return true;
  }
  if (dx == 0 || dy == 0)
  {
    return this->IsLinked(place, place + dy * this->Width + dx);
  }
  return this->IsWholeBlock(place + (dx < 0 ? -1 : 0) + (dy < 0 ? -this->Width : 0));
}

//----------------------------------------------------------------------------------------------------------------------
void GapRegion::AddRing(const ColumnIndex& index, int ringWidth)
{
  std::vector<bool> reached(this->Kind.size(), false);
  std::vector<std::int64_t> front = this->GapPlaces;
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
        const std::int64_t neighbour = place + (n / 3 - 1) * this->Width + (n % 3 - 1);
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
SiteBox GapRegion::MakeSites(bool withRing) const
{
  SiteBox box(this->Width, this->Height);
  for (std::size_t place = 0; place < this->Kind.size(); ++place)
  {
    if (this->Kind[place] == PlaceKind::Gap || (withRing && this->Kind[place] == PlaceKind::Ring))
    {
      box.Add(std::int64_t(place));
    }
  }
  return box;
}
}
