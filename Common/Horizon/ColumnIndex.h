// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the point in a column. A place is a row-major position in the bounding box, with an empty rim so that searches
// need no bounds checks. Each place has a bit, and each 64 places the number of points before them. This gives the
// point if points are row-major, as from all readers, or else its position in a table. The index takes 12 bytes per 64
// columns, a tenth of one number per column. Row-major columns need no array, since the bits also give the column of a
// point.

#ifndef SeismicHorizonsColumnIndex_h
#define SeismicHorizonsColumnIndex_h

#include "Common/Base/Errors.h"
#include "Common/Base/Portable.h"
#include "PlaneGeometry.h"
#include "Types.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A bit per place of a box, so that 64 columns are tested at a time.
class PlaceSet
{
public:
  /// The first place is the lowest bit.
  using Window = Bits128;
  static constexpr int WordBits = 64;

  PlaceSet() = default;
  PlaceSet(std::int64_t width, std::int64_t height);

  /// Returns 64 places, from the multiple of 64 at or below `place`.
  std::uint64_t WordAt(std::int64_t place) const { return this->Words[this->WordOf(place)]; }

  void Add(std::int64_t place) { this->Words[this->WordOf(place)] |= Bit(place); }

  bool Contains(std::int64_t place) const { return (this->Words[this->WordOf(place)] & Bit(place)) != 0; }

  /// At least 65 bits are valid; `place` may be up to a row before the box.
  Window From(std::int64_t place) const
  {
    const std::uint64_t* const word = this->Words.data() + this->WordOf(place);
    const int shift = int(std::uint64_t(place) % WordBits);
    const Window window = (Window(word[1]) << WordBits | word[0]) >> shift;
    return shift == 0 ? window : window | Window(word[2]) << (2 * WordBits - shift);
  }

  /// Adds places with eight neighbours in the set, except where except(first), for 64 places, has bits.
  template <typename Except>
  void AddSurrounded(Except&& except)
  {
    // No two added places are neighbours, so that additions are independent.
    for (std::int64_t place = 0; place < this->Places; place += WordBits)
    {
      this->Words[this->WordOf(place)] |= this->Surrounded(place) & ~except(place);
    }
  }

  /// Returns the places, of 64, that have all eight neighbours.
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
  /// The margin before the first place exceeds a row, in whole words.
  std::size_t WordOf(std::int64_t place) const { return std::size_t(place + this->Margin) / WordBits; }

  std::int64_t Width = 0;
  std::int64_t Places = 0;
  std::int64_t Margin = 0;
  std::vector<std::uint64_t> Words;
};

class PlaceNumbers
{
public:
  static constexpr std::int64_t None = -1;

  /// Numbers the places whose bits are set, of the next 64.
  void Append(std::uint64_t bits)
  {
    this->Words.push_back({ bits, this->Count });
    this->Count += CountBits(bits);
  }

  std::int64_t Size() const { return this->Count; }

  /// Returns None for places without number.
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
    std::int64_t Before; // numbered places in earlier words
  };

  std::int64_t Count = 0;
  std::vector<Word> Words;
};

InputError SameColumnError(PointId first, PointId second, const PlanePoint& column);

/// The extent of columns, and whether they ascend row by row, as from all readers, so that none is double.
struct ColumnRows
{
  PlaneBox Box;
  PlanePoint First;
  PlanePoint Last;
  bool AreAscending = true;

  static ColumnRows Of(const PlanePoint& column)
  {
    ColumnRows rows{ PlaneBox(), column, column };
    rows.Box.Add(column);
    return rows;
  }
  static ColumnRows Of(PlanePoints columns);

  void Add(const ColumnRows& next)
  {
    const bool isFirst = this->Box.IsEmpty();
    const bool isAfter = isFirst || next.Box.IsEmpty() || PrecedesByRow(this->Last, next.First);
    this->AreAscending = this->AreAscending && next.AreAscending && isAfter;
    this->First = isFirst ? next.First : this->First;
    this->Last = next.Box.IsEmpty() ? this->Last : next.Last;
    this->Box.Add(next.Box);
  }
};

bool AreScattered(PlanePoints columns);

/// Narrows empty rows and columns that no step of `reach` columns can cross, such that still none can. Connections by
/// such steps and the order of columns remain. Time is near n log n. Throws InputError if two points share a column.
std::vector<PlanePoint> NarrowEmptyBands(PlanePoints columns, int reach);

class ColumnIndex
{
public:
  static constexpr int AllBands = 0;
  static constexpr int LongestReach = 64; // columns

  /// `rim` is in columns. With a reach, scattered columns are indexed without wide empty bands, which saves memory. Refers
  /// to the memory of the columns. Throws InputError if two points share a column.
  explicit ColumnIndex(PlanePoints columns, std::int32_t rim = 1, int reach = AllBands);

  /// Indexes the columns that forEachColumn(add) adds row by row from the least y, each row from the least x. They must
  /// lie in the box. The index keeps no array of them. Throws InputError if two points share a column.
  template <typename ForEachColumn>
  ColumnIndex(const PlaneBox& box, std::int32_t rim, ForEachColumn&& forEachColumn)
  {
    if (!box.IsEmpty())
    {
      this->SetBox(box, rim);
      this->Before.reserve(this->NumberOfWords());
      forEachColumn([this](const PlanePoint& column) { this->Append(column); });
      this->Before.resize(this->NumberOfWords(), this->Count);
    }
  }

  /// This is empty without an array of columns.
  PlanePoints Columns() const { return this->Narrow.empty() ? this->Given : PlanePoints(this->Narrow); }

  std::size_t NumberOfPoints() const { return this->Count; }
  bool IsRowMajor() const { return this->Order.empty(); }

  std::int64_t Width() const { return this->SizeX; }
  std::int64_t Height() const { return this->SizeY; }
  std::int64_t NumberOfPlaces() const { return this->SizeX * this->SizeY; }

  /// The place above is Width() further.
  std::int64_t Place(const PlanePoint& column) const
  {
    return (std::int64_t(column.Y) - this->MinY) * this->SizeX + (std::int64_t(column.X) - this->MinX);
  }

  std::int64_t PlaceOf(PointId point) const
  {
    const PlanePoints columns = this->Columns();
    return columns.empty() ? this->PlaceAtRank(std::uint32_t(point)) : this->Place(columns[std::size_t(point)]);
  }

  /// Returns the column as in Columns(), also without an array.
  PlanePoint ColumnOf(PointId point) const
  {
    const PlanePoints columns = this->Columns();
    return columns.empty() ? this->GivenColumn(this->PlaceAtRank(std::uint32_t(point))) : columns[std::size_t(point)];
  }

  /// Returns the given column at a place. In narrowed bands and in the rim, columns are counted from the last one before.
  PlanePoint GivenColumn(std::int64_t place) const
  {
    const std::int64_t x = place % this->SizeX;
    const std::int64_t y = place / this->SizeX;
    return this->Narrow.empty() ? PlanePoint{ std::int32_t(this->MinX + x), std::int32_t(this->MinY + y) }
                                : PlanePoint{ this->GivenX[std::size_t(x)], this->GivenY[std::size_t(y)] };
  }

  bool Has(std::int64_t place) const { return this->Points.Contains(place); }

  PointId operator[](std::int64_t place) const { return this->Has(place) ? this->PointOf(this->Rank(place)) : NoPoint; }

  /// The column may be outside the box.
  PointId PointAt(const PlanePoint& column) const
  {
    const std::int64_t x = std::int64_t(column.X) - this->MinX;
    const std::int64_t y = std::int64_t(column.Y) - this->MinY;
    const bool isInside = x >= 0 && y >= 0 && x < this->SizeX && y < this->SizeY;
    return isInside ? (*this)[y * this->SizeX + x] : NoPoint;
  }

  const PlaceSet& Occupied() const { return this->Points; }

  /// Returns the number of points before a place, row by row.
  std::int64_t Rank(std::int64_t place) const
  {
    const std::uint64_t bit = std::uint64_t(1) << (std::uint64_t(place) % PlaceSet::WordBits);
    return this->Before[std::size_t(place) / PlaceSet::WordBits] + CountBits(this->Points.WordAt(place) & (bit - 1));
  }

  PointId PointOf(std::int64_t rank) const { return this->Order.empty() ? PointId(rank) : this->Order[rank]; }

  /// Calls visit(place, point) from `first` to before `last`.
  template <typename Visitor>
  void ForEachPoint(std::int64_t first, std::int64_t last, Visitor&& visit) const
  {
    std::int64_t rank = first < last ? this->Rank(first) : 0;
    // Most calls are for a few places.
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
  std::size_t NumberOfWords() const { return std::size_t((this->NumberOfPlaces() - 1) / PlaceSet::WordBits + 1); }

  void SetBox(const PlaneBox& box, std::int32_t rim);

  void Append(const PlanePoint& column)
  {
    const std::int64_t place = this->Place(column);
    if (this->Count > 0 && place == this->Last)
    {
      throw SameColumnError(PointId(this->Count - 1), PointId(this->Count), column);
    }
    assert(place > this->Last && place < this->NumberOfPlaces() && this->GivenColumn(place) == column);
    this->Before.resize(std::size_t(place) / PlaceSet::WordBits + 1, this->Count);
    this->Points.Add(place);
    this->Last = place;
    ++this->Count;
  }

  std::int64_t PlaceAtRank(std::uint32_t rank) const;
  void AddRows();
  void CountPoints();
  void SortPoints();

  PlanePoints Given;
  std::vector<PlanePoint> Narrow;
  std::vector<std::int32_t> GivenX; // Given coordinates by x of the place; empty if no band is narrowed.
  std::vector<std::int32_t> GivenY;
  std::int64_t MinX = 0;
  std::int64_t MinY = 0;
  std::int64_t SizeX = 0;
  std::int64_t SizeY = 0;
  std::int64_t Last = -1; // the place that was added last without an array
  std::uint32_t Count = 0; // number of points
  PlaceSet Points;
  std::vector<std::uint32_t> Before; // Number of points before each 64 places.
  std::vector<PointId> Order; // Empty if the points are row-major.
};
}

#endif
