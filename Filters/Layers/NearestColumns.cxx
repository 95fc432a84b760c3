// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestColumns.h"

#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
// Bins are nearly squares. Along an axis that is very short there is one.
NearestColumns::NearestColumns(PlanePoints columns)
  : Columns(columns)
{
  assert(columns.size() > 0);
  constexpr double shortest = 0.001 / 3.0; // of both lengths together
  const PlaneBox box(columns);
  const double lengths[] = { double(box.Greatest.X) - box.Least.X, double(box.Greatest.Y) - box.Least.Y };
  const double sum = lengths[0] + lengths[1];
  double scale = double(columns.size());
  int longAxes = 0;
  for (const double length : lengths)
  {
    if (length > sum * shortest)
    {
      scale /= length / sum;
      ++longAxes;
    }
  }
  scale = longAxes == 2 ? std::pow(scale, 0.5) : scale;
  const auto binsOf = [&](double length)
  { return length > sum * shortest ? std::max<std::int64_t>(1, std::int64_t(scale * length / sum)) : 1; };
  this->X = { double(box.Least.X), 0.0, binsOf(lengths[0]) };
  this->Y = { double(box.Least.Y), 0.0, binsOf(lengths[1]) };
  while (this->X.Bins * this->Y.Bins > std::int64_t(columns.size()))
  {
    this->X.Bins = std::max<std::int64_t>(1, this->X.Bins - 1);
    this->Y.Bins = std::max<std::int64_t>(1, this->Y.Bins - 1);
  }
  this->X.BinsPerColumn = this->X.Bins > 1 ? 1.0 / (lengths[0] / double(this->X.Bins)) : 0.0;
  this->Y.BinsPerColumn = this->Y.Bins > 1 ? 1.0 / (lengths[1] / double(this->Y.Bins)) : 0.0;
  this->Bins = ItemLists<PointId>(this->X.Bins * this->Y.Bins,
    [this](auto&& add)
    {
      for (std::size_t point = 0; point < this->Columns.size(); ++point)
      {
        const PlanePoint& column = this->Columns[point];
        add(this->X.BinOf(column.X) * this->Y.Bins + this->Y.BinOf(column.Y), PointId(point));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t NearestColumns::Axis::BinOf(double place) const
{
  return std::clamp<std::int64_t>(std::int64_t((place - this->Least) * this->BinsPerColumn), 0, this->Bins - 1);
}

//----------------------------------------------------------------------------------------------------------------------
void NearestColumns::Compare(std::int64_t x, std::int64_t y, const PlanePoint& place, Nearest& nearest) const
{
  if (x < 0 || y < 0 || x >= this->X.Bins || y >= this->Y.Bins)
  {
    return;
  }
  const std::int64_t bin = x * this->Y.Bins + y;
  for (const PointId* point = this->Bins.begin(bin); point != this->Bins.end(bin); ++point)
  {
    const std::int64_t distance = SquaredDistance(place, this->Columns[std::size_t(*point)]);
    if (nearest.Point == NoPoint || distance < nearest.SquaredDistance)
    {
      nearest = { *point, distance };
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Rings of bins around the place are searched until one has a column, then all bins within its distance.
PointId NearestColumns::Find(const PlanePoint& place) const
{
  Nearest nearest;
  const std::int64_t atX = this->X.BinOf(place.X);
  const std::int64_t atY = this->Y.BinOf(place.Y);
  for (std::int64_t ring = 0; nearest.Point == NoPoint; ++ring)
  {
    for (std::int64_t x = atX - ring; x <= atX + ring; ++x)
    {
      const bool isSide = x == atX - ring || x == atX + ring;
      for (std::int64_t y = atY - ring; y <= atY + ring; y += isSide ? 1 : 2 * ring)
      {
        this->Compare(x, y, place, nearest);
      }
    }
  }
  const double distance = std::sqrt(double(nearest.SquaredDistance));
  for (std::int64_t x = this->X.BinOf(place.X - distance); x <= this->X.BinOf(place.X + distance); ++x)
  {
    for (std::int64_t y = this->Y.BinOf(place.Y - distance); y <= this->Y.BinOf(place.Y + distance); ++y)
    {
      this->Compare(x, y, place, nearest);
    }
  }
  return nearest.Point;
}
}
