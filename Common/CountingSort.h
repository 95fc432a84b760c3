// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorts items by a small whole number, their key, in linear time. Items with the same key keep their order. All items
// are visited twice: the first time they are counted, the second time each is given its position.
//
//     keys of the items        2  0  2  1
//     how many of each key     0: 1     1: 1     2: 2
//     positions                0: 0     1: 1     2: 2 and 3
//     the items, sorted        0  1  2  2

#ifndef SeismicHorizonsCountingSort_h
#define SeismicHorizonsCountingSort_h

#include "RawVector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
/// Where the items of each key stand when all are sorted. To be called in this order: Count for every item,
/// EndCounting, NextPosition for every item, then First and End for any key. `Positions` is a std::vector or std::array
/// of a type that can count all items.
template <typename Positions>
class BasicCountingSort
{
public:
  using Position = typename Positions::value_type;

  /// For a number of keys that is fixed by the type.
  BasicCountingSort() = default;

  /// For keys from 0 to below `keys`.
  explicit BasicCountingSort(std::int64_t keys)
    : Starts(std::size_t(keys) + 2, 0)
  {
  }

  void Count(std::int64_t key) { ++this->Starts[std::size_t(key) + 2]; }

  void EndCounting() { std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin()); }

  /// How many items there are.
  Position Size() const { return this->Starts.back(); }

  Position NextPosition(std::int64_t key) { return this->Starts[std::size_t(key) + 1]++; }

  /// The items of a key have the positions from First to before End.
  Position First(std::int64_t key) const { return this->Starts[std::size_t(key)]; }
  Position End(std::int64_t key) const { return this->Starts[std::size_t(key) + 1]; }
  /// First(key) for all keys, one after the other, and then End(key) of the last one.
  const Position* Firsts() const { return this->Starts.data(); }

private:
  // The positions of a key begin at [key + 1] until they are given away, which counts this entry up to where those of
  // the next key begin. So they begin at [key] in the end.
  Positions Starts = {};
};

template <typename Position>
using CountingSort = BasicCountingSort<std::vector<Position>>;

/// The same for few keys, without memory of the heap.
template <typename Position, std::size_t Keys>
using SmallCountingSort = BasicCountingSort<std::array<Position, Keys + 2>>;

/// Lists of items, one list for each key, in one piece of memory. Items of a list keep the order they came in.
template <typename Item, typename Position = std::size_t>
class ItemLists
{
public:
  /// Without keys.
  ItemLists() = default;

  /// For keys from 0 to below `keys`. `forEach(add)` calls add(key, item) for all items; it is run twice, and must do
  /// the same both times.
  template <typename ForEach>
  ItemLists(std::int64_t keys, ForEach&& forEach)
    : Sort(keys)
  {
    forEach([this](std::int64_t key, const Item&) { this->Sort.Count(key); });
    this->Sort.EndCounting();
    this->Items.resize(this->Sort.Size());
    forEach([this](std::int64_t key, const Item& item) { this->Items[this->Sort.NextPosition(key)] = item; });
  }

  const Item* begin(std::int64_t key) const { return this->Items.data() + this->Sort.First(key); }
  const Item* end(std::int64_t key) const { return this->Items.data() + this->Sort.End(key); }
  Item* begin(std::int64_t key) { return this->Items.data() + this->Sort.First(key); }
  Item* end(std::int64_t key) { return this->Items.data() + this->Sort.End(key); }

  bool IsEmpty(std::int64_t key) const { return this->Sort.First(key) == this->Sort.End(key); }

  /// How many items all lists have together.
  std::size_t Size() const { return this->Items.size(); }
  /// The position of an item among all of them, from 0.
  std::size_t IndexOf(const Item* item) const { return std::size_t(item - this->Items.data()); }

private:
  CountingSort<Position> Sort;
  RawVector<Item> Items;
};
}

#endif
