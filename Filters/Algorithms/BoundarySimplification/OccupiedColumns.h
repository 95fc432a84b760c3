// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsOccupiedColumns_h
#define SeismicHorizonsOccupiedColumns_h

#include "Common/PlaneGeometry.h"
#include "Common/SpacePoints.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Which columns of the bounding box of a horizon have points, and which of these are on loops, whose columns are
/// numbered from 0, row by row. A third of a byte per column of the box.
class OccupiedColumns
{
public:
  static constexpr std::size_t NoNumber = static_cast<std::size_t>(-1);

  /// Throws InputError when a point does not stand on a whole column. `isOnLoop` has for each point 0 when it is not.
  OccupiedColumns(const SpacePoints& points, const std::vector<unsigned char>& isOnLoop);

  /// How many columns have points of loops.
  std::size_t NumberOfLoopColumns() const { return this->LoopColumns; }

  /// Whether a column of the box has a point.
  bool IsOccupied(std::int64_t x, std::int64_t y) const
  {
    const std::int64_t place = this->Place(x, y);
    return (this->Words[std::size_t(place / WordBits)].Occupied >> (place % WordBits) & 1) != 0;
  }

  /// The number of a column with a point of a loop; NoNumber for all others.
  std::size_t LoopNumber(std::int64_t x, std::int64_t y) const
  {
    const std::int64_t place = this->Place(x, y);
    const Word& word = this->Words[std::size_t(place / WordBits)];
    const std::uint64_t bit = std::uint64_t(1) << (place % WordBits);
    return (word.OnLoop & bit) == 0 ? NoNumber
                                    : word.Before + std::size_t(__builtin_popcountll(word.OnLoop & (bit - 1)));
  }

private:
  static constexpr std::int64_t WordBits = 64;

  struct Word
  {
    std::uint64_t Occupied = 0;
    std::uint64_t OnLoop = 0;
    std::size_t Before = 0; // columns of loops in the words before
  };

  std::int64_t Place(std::int64_t x, std::int64_t y) const
  {
    return (y - this->Box.Least.Y) * this->Width + (x - this->Box.Least.X);
  }

  PlaneBox Box;
  std::int64_t Width = 0;
  std::size_t LoopColumns = 0;
  std::vector<Word> Words;
};
}

#endif
