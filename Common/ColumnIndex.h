// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which point of a horizon is in a column. A column has a place: its position, row by row, in the bounding box of the
// horizon, which has an empty rim, so that searches look at neighbours without a test for the sides of the box. There
// is a bit for each place, and for each 64 of them how many points come before: the number of a point is that count
// where points come row by row, as all readers give them, and else is looked up by it. So the index takes 12 bytes per
// 64 columns, a tenth of what a number for each column takes.

#ifndef SeismicHorizonsColumnIndex_h
#define SeismicHorizonsColumnIndex_h

#include "Errors.h"
#include "Portable.h"
#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Some places of a box, a bit each: 64 neighbouring columns are looked at in a time.
class PlaceSet
{
public:
  /// Bits of successive places, the first lowest.
  using Window = Bits128;
  static constexpr int WordBits = 64;

  PlaceSet() = default;
  /// None of so many columns and rows.
  PlaceSet(std::int64_t width, std::int64_t height);

  /// The 64 places among which one is, from a multiple of 64 on.
  std::uint64_t WordAt(std::int64_t place) const { return this->Words[this->WordOf(place)]; }

  void Add(std::int64_t place) { this->Words[this->WordOf(place)] |= Bit(place); }

  bool Contains(std::int64_t place) const { return (this->Words[this->WordOf(place)] & Bit(place)) != 0; }

  /// The places from one on, at most a row before the box; at least the first 65 bits are valid.
  Window From(std::int64_t place) const
  {
    const std::uint64_t* const word = this->Words.data() + this->WordOf(place);
    const int shift = int(std::uint64_t(place) % WordBits);
    const Window window = (Window(word[1]) << WordBits | word[0]) >> shift;
    return shift == 0 ? window : window | Window(word[2]) << (2 * WordBits - shift);
  }

  /// Adds places whose eight neighbours are all in the set, but for those for which `except(first)` has bits: it gives
  /// a bit for each of 64 places.
  template <typename Except>
  void AddSurrounded(Except&& except)
  {
    // No two of the places that are added are neighbours, so that one does not change what is found of another.
    for (std::int64_t place = 0; place < this->Places; place += WordBits)
    {
      this->Words[this->WordOf(place)] |= this->Surrounded(place) & ~except(place);
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
  static std::uint64_t Bit(std::int64_t place) { return std::uint64_t(1) << (std::uint64_t(place) % WordBits); }
  /// Before the first place there are bits of none: more than a row, in whole words.
  std::size_t WordOf(std::int64_t place) const { return std::size_t(place + this->Margin) / WordBits; }

  std::int64_t Width = 0;
  std::int64_t Places = 0;
  std::int64_t Margin = 0;
  std::vector<std::uint64_t> Words;
};

/// Numbers some places from 0, in their order.
class PlaceNumbers
{
public:
  static constexpr std::int64_t None = -1;

  /// Numbers those of the next 64 places whose bits are set.
  void Append(std::uint64_t bits)
  {
    this->Words.push_back({ bits, this->Count });
    this->Count += CountBits(bits);
  }

  /// How many places have numbers.
  std::int64_t Size() const { return this->Count; }

  /// The number of a place, or None.
  std::int64_t operator[](std::int64_t place) const
  {
    const Word& word = this->Words[std::size_t(place) / PlaceSet::WordBits];
    const std::uint64_t bit = std::uint64_t(1) << (std::uint64_t(place) % PlaceSet::WordBits);
    return (word.Bits & bit) != 0 ? word.Before + CountBits(word.Bits & (bit - 1)) : None;
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

/// What is wrong when two points, the lesser number first, are in one column.
InputError SameColumnError(PointId first, PointId second, const PlanePoint& column);

/// Whether the bounding box of the columns has many times as many columns.
bool AreScattered(PlanePoints columns);

/// Narrows the bands that neighbouring rows of the lattice, or neighbouring columns of it, form when they are empty
/// from end to end: those that no step of at most `reach` columns can cross, and only so far that still none can. What
/// such steps connect, and the order of columns, stay what they were. Takes time near n log n. Throws InputError when
/// two points stand in the same column.
std::vector<PlanePoint> NarrowEmptyBands(PlanePoints columns, int reach);

class ColumnIndex
{
public:
  static constexpr int AllBands = 0;
  static constexpr int LongestReach = 64; // that any method of ours asks for

  /// `rim` is the width of the rim in columns. With a reach, columns that are scattered are indexed without wide bands
  /// (NarrowEmptyBands), so that parts that are far apart take no more memory than parts side by side. Keeps a
  /// reference to the memory of the columns. Throws InputError when two points stand in the same column.
  explicit ColumnIndex(PlanePoints columns, std::int32_t rim = 1, int reach = AllBands);

  /// The columns of the points as the index has them: as they were given, or without wide bands.
  PlanePoints Columns() const { return this->Narrow.empty() ? this->Given : PlanePoints(this->Narrow); }

  /// How many columns and rows there are, with the rim.
  std::int64_t Width() const { return this->SizeX; }
  std::int64_t Height() const { return this->SizeY; }
  std::int64_t NumberOfPlaces() const { return this->SizeX * this->SizeY; }

  /// That of the column above is Width() further.
  std::int64_t Place(const PlanePoint& column) const
  {
    return (std::int64_t(column.Y) - this->MinY) * this->SizeX + (std::int64_t(column.X) - this->MinX);
  }

  bool Has(std::int64_t place) const { return this->Points.Contains(place); }

  /// The point at a place, or NoPoint.
  PointId operator[](std::int64_t place) const { return this->Has(place) ? this->PointOf(this->Rank(place)) : NoPoint; }

  /// The point in a column, which may lie anywhere, or NoPoint.
  PointId PointAt(const PlanePoint& column) const
  {
    const std::int64_t x = std::int64_t(column.X) - this->MinX;
    const std::int64_t y = std::int64_t(column.Y) - this->MinY;
    const bool isInside = x >= 0 && y >= 0 && x < this->SizeX && y < this->SizeY;
    return isInside ? (*this)[y * this->SizeX + x] : NoPoint;
  }

  /// The places with points.
  const PlaceSet& Occupied() const { return this->Points; }

  /// Calls visit(place, point) for the points at the places from `first` to before `last`.
  template <typename Visitor>
  void ForEachPoint(std::int64_t first, std::int64_t last, Visitor&& visit) const
  {
    std::int64_t rank = first < last ? this->Rank(first) : 0;
    // Word by word, of which the first and the last may count in part: most calls are for a few places.
    for (std::int64_t place = first; place < last;)
    {
      const auto shift = std::int64_t(std::uint64_t(place) % PlaceSet::WordBits);
      const std::int64_t count = std::min(last - place, PlaceSet::WordBits - shift);
      std::uint64_t bits = this->Points.WordAt(place) >> shift << (PlaceSet::WordBits - count);
      for (bits >>= PlaceSet::WordBits - count; bits != 0; bits &= bits - 1)
      {
        visit(place + LowestBit(bits), this->PointOf(rank++));
      }
      place += count;
    }
  }

private:
  /// How many points come before a place.
  std::int64_t Rank(std::int64_t place) const
  {
    const std::uint64_t bit = std::uint64_t(1) << (std::uint64_t(place) % PlaceSet::WordBits);
    return this->Before[std::size_t(place) / PlaceSet::WordBits] + CountBits(this->Points.WordAt(place) & (bit - 1));
  }

  PointId PointOf(std::int64_t rank) const { return this->Order.empty() ? PointId(rank) : this->Order[rank]; }

  void CountPoints();
  void SortPoints();

  PlanePoints Given;
  std::vector<PlanePoint> Narrow; // empty unless bands were narrowed
  std::int64_t MinX = 0;
  std::int64_t MinY = 0;
  std::int64_t SizeX = 0;
  std::int64_t SizeY = 0;
  PlaceSet Points;
  std::vector<std::uint32_t> Before; // for each 64 places
  std::vector<PointId> Order; // the points row by row; empty when they are so
};
}

#endif
