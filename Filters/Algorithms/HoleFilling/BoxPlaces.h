// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places of a box of the lattice near a group of columns. They are numbered row by row, and only they take memory: a
// narrow gap that runs diagonally takes what one along an axis does, and not its bounding box.

#ifndef SeismicHorizonsBoxPlaces_h
#define SeismicHorizonsBoxPlaces_h

#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Successive columns of a row of the box, at least one.
struct BoxRun
{
  std::int32_t Row;
  std::int32_t First;
  std::int32_t Last;
};

/// The columns of some runs, which may overlap, by as few runs as hold them, row by row.
std::vector<BoxRun> Merged(std::vector<BoxRun> runs);

class BoxPlaces
{
public:
  /// All columns that are at most `reach` rows and at most `reach` columns from one of some runs: at least 2, so that
  /// only neighbours along a row have successive numbers.
  BoxPlaces(const std::vector<BoxRun>& runs, int reach);

  std::int64_t Size() const { return std::int64_t(this->Places.size()); }
  /// What holds all places, row by row: two boxes with the same runs are the same.
  const std::vector<BoxRun>& GetRuns() const { return this->Runs; }

  /// Where a place is in the box.
  PlanePoint Column(std::int64_t place) const { return this->Places[std::size_t(place)].Column; }
  /// The place of a column that has one.
  std::int64_t Find(const PlanePoint& column) const;

  /// The places in the rows above and below, where there are any.
  std::int64_t Above(std::int64_t place) const { return place + this->Places[std::size_t(place)].ToAbove; }
  std::int64_t Below(std::int64_t place) const { return place - this->Places[std::size_t(place)].ToBelow; }
  /// The place so many columns and rows away, no further than the reach from one of a run.
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
    std::int32_t ToAbove = 0; // as two rows have less places than fit it
    std::int32_t ToBelow = 0;
  };

  std::vector<BoxRun> Runs;
  std::vector<std::int64_t> Begins; // the first place of each run
  std::vector<BoxPlace> Places;
};
}

#endif
