// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sets of places of a column raster, a bit each: 64 neighbouring columns are looked at in a time.

#ifndef SeismicHorizonsPlaceSet_h
#define SeismicHorizonsPlaceSet_h

#include "ColumnRaster.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Position of the lowest bit of a number that is not 0.
inline int LowestBit(std::uint64_t bits)
{
  return __builtin_ctzll(bits);
}

class PlaceSet
{
public:
  /// Bits of successive places, the first lowest.
  __extension__ typedef unsigned __int128 Window;
  static constexpr int WordBits = 64;

  /// The places with points.
  explicit PlaceSet(const ColumnRaster& raster);

  /// The places from one on, at most a row before the raster; at least the first 65 bits are valid.
  Window From(std::int64_t place) const
  {
    const std::int64_t bit = place + this->Margin;
    const std::uint64_t* const word = this->Words.data() + bit / WordBits;
    const int shift = int(bit % WordBits);
    const Window window = (Window(word[1]) << WordBits | word[0]) >> shift;
    return shift == 0 ? window : window | Window(word[2]) << (2 * WordBits - shift);
  }

  bool Contains(std::int64_t place) const { return (this->From(place) & 1U) != 0; }

  /// Adds places whose eight neighbours are all in the set, but for those for which `except(first)` has bits: it gives
  /// a bit for each of 64 places.
  template <typename Except>
  void AddSurrounded(Except&& except)
  {
    // No two of the places that are added are neighbours, so that one does not change what is found of another.
    for (std::int64_t place = 0; place < this->Places; place += WordBits)
    {
      this->Words[std::size_t((this->Margin + place) / WordBits)] |= this->Surrounded(place) & ~except(place);
    }
  }

  /// Those of 64 places that have all eight neighbours in the set.
  std::uint64_t Surrounded(std::int64_t place) const
  {
    std::uint64_t all = std::uint64_t(this->From(place - 1) & this->From(place + 1));
    for (const std::int64_t row : { place - this->Width, place + this->Width })
    {
      all &= std::uint64_t(this->From(row - 1) & this->From(row) & this->From(row + 1));
    }
    return all;
  }

private:
  const std::int64_t Width; // of the raster
  const std::int64_t Places;
  const std::int64_t Margin; // bits of no place before the first one: more than a row, in whole words
  std::vector<std::uint64_t> Words;
};

/// Numbers some places of a raster from 0, in their order.
class PlaceNumbers
{
public:
  static constexpr std::int64_t None = -1;

  /// Numbers those of the next 64 places whose bits are set.
  void Append(std::uint64_t bits)
  {
    this->Words.push_back({ bits, this->Count });
    this->Count += __builtin_popcountll(bits);
  }

  /// How many places have numbers.
  std::int64_t Size() const { return this->Count; }

  /// The number of a place, or None.
  std::int64_t operator[](std::int64_t place) const
  {
    const Word& word = this->Words[std::size_t(place / PlaceSet::WordBits)];
    const std::uint64_t bit = std::uint64_t(1) << (place % PlaceSet::WordBits);
    return (word.Bits & bit) != 0 ? word.Before + __builtin_popcountll(word.Bits & (bit - 1)) : None;
  }

private:
  struct Word
  {
    std::uint64_t Bits;
    std::int64_t Before; // how many there are in the words before
  };

  std::int64_t Count = 0;
  std::vector<Word> Words;
};
}

#endif
