// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stable, linear sort by a small integer key. A first pass counts the items, a second one assigns positions.
//
//     keys of the items        2  0  2  1
//     items per key            0: 1     1: 1     2: 2
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
/// Call Count for every item, EndCounting, NextPosition for every item, then First and End. `Positions` is a
/// std::vector or std::array whose type can count all items.
template <typename Positions>
class BasicCountingSort
{
public:
  using Position = typename Positions::value_type;

  /// The type fixes the number of keys.
  BasicCountingSort() = default;

  explicit BasicCountingSort(std::int64_t keys)
    : Starts(std::size_t(keys) + 2, 0)
  {
  }

  void Count(std::int64_t key) { ++this->Starts[std::size_t(key) + 2]; }

  void EndCounting() { std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin()); }

  Position Size() const { return this->Starts.back(); }

  Position NextPosition(std::int64_t key) { return this->Starts[std::size_t(key) + 1]++; }

  Position First(std::int64_t key) const { return this->Starts[std::size_t(key)]; }
  Position End(std::int64_t key) const { return this->Starts[std::size_t(key) + 1]; }
  /// First(key) for all keys, followed by the last End(key).
  const Position* Firsts() const { return this->Starts.data(); }

private:
  // Positions of a key begin at [key + 1] while they are assigned, which advances this entry to the next key, and
  // finally at [key].
  Positions Starts = {};
};

template <typename Position>
using CountingSort = BasicCountingSort<std::vector<Position>>;

template <typename Position, std::size_t Keys>
using SmallCountingSort = BasicCountingSort<std::array<Position, Keys + 2>>;

/// Lists per key share one block of memory; items keep their order.
template <typename Item, typename Position = std::size_t>
class ItemLists
{
public:
  ItemLists() = default;

  /// forEach(add) calls add(key, item) for all items. It runs twice and must repeat itself.
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

  std::size_t Size() const { return this->Items.size(); }
  std::size_t IndexOf(const Item* item) const { return std::size_t(item - this->Items.data()); }

private:
  CountingSort<Position> Sort;
  RawVector<Item> Items;
};
}

#endif
