// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places of a box of the lattice near a group of columns, numbered row by row. Only these take memory, so that a narrow
// diagonal hole is not charged for its bounding box.

#ifndef SeismicHorizonsBoxPlaces_h
#define SeismicHorizonsBoxPlaces_h

#include "Common/Horizon/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct BoxRun
{
  std::int32_t Row;
  std::int32_t First;
  std::int32_t Last;
};

std::vector<BoxRun> Merged(std::vector<BoxRun> runs);

class BoxPlaces
{
public:
  /// `reach` is at least 2, so that only neighbours along a row have successive numbers.
  BoxPlaces(const std::vector<BoxRun>& runs, int reach);

  const std::vector<BoxRun> Runs; // Two boxes with equal runs are equal.

  std::int64_t Size() const { return std::int64_t(this->Places.size()); }

  PlanePoint Column(std::int64_t place) const { return this->Places[std::size_t(place)].Column; }
  std::int64_t Find(const PlanePoint& column) const;

  std::int64_t Above(std::int64_t place) const { return place + this->Places[std::size_t(place)].ToAbove; }
  std::int64_t Below(std::int64_t place) const { return place - this->Places[std::size_t(place)].ToBelow; }
  std::int64_t Beside(std::int64_t place, int dx, int dy) const
  {
    for (; dy > 0; --dy)
    {
      place = this->Above(place);
    }
    for (; dy < 0; ++dy)
    {
      place = this->Below(place);
    }
    return place + dx;
  }

private:
  struct BoxPlace
  {
    PlanePoint Column;
    std::int32_t ToAbove = 0; // Two rows have few enough places for 32 bits.
    std::int32_t ToBelow = 0;
  };

  std::vector<std::int64_t> Begins;
  std::vector<BoxPlace> Places;
};
}

#endif
