// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OccupiedColumns.h"

#include "Common/Errors.h"

#include <sstream>

namespace SeismicHorizons
{
namespace
{
InputError BesideColumn(std::size_t point, const SpacePoint& place)
{
  std::ostringstream text;
  text << "point " << point << " at (" << place.X << ", " << place.Y
       << ") stands beside its column, expected whole columns: outlines get the fewest points before points are merged";
  return InputError(text.str());
}
}

//----------------------------------------------------------------------------------------------------------------------
OccupiedColumns::OccupiedColumns(const SpacePoints& points, const std::vector<unsigned char>& isOnLoop)
{
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    if (!points.IsOnColumn(point))
    {
      throw BesideColumn(point, points[point]);
    }
    this->Box.Add(points.Column(point));
  }
  if (this->Box.IsEmpty())
  {
    return;
  }
  this->Width = std::int64_t(this->Box.Greatest.X) - this->Box.Least.X + 1;
  const std::int64_t rows = std::int64_t(this->Box.Greatest.Y) - this->Box.Least.Y + 1;
  this->Words.resize(std::size_t(this->Width * rows / WordBits + 1));
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const PlanePoint column = points.Column(point);
    const std::int64_t place = this->Place(column.X, column.Y);
    const std::uint64_t bit = std::uint64_t(1) << (place % WordBits);
    Word& word = this->Words[std::size_t(place / WordBits)];
    word.Occupied |= bit;
    word.OnLoop |= isOnLoop[point] != 0 ? bit : 0;
  }
  for (Word& word : this->Words)
  {
    word.Before = this->LoopColumns;
    this->LoopColumns += std::size_t(__builtin_popcountll(word.OnLoop));
  }
}
}
