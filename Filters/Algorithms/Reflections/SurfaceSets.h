// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What BestFirstJoining.cxx keeps of parts of surfaces: their picks, and for large ones their columns as bits.

#ifndef SeismicHorizonsSurfaceSets_h
#define SeismicHorizonsSurfaceSets_h

#include "Common/Base/RawVector.h"
#include "ReflectionFinder.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class ColumnSet
{
public:
  bool Has(int i, int j) const
  {
    const int word = (i >> WordShift) - this->FirstWord;
    const int row = j - this->FirstRow;
    const bool isInside = unsigned(word) < unsigned(this->Words) && unsigned(row) < unsigned(this->Rows);
    return isInside && (this->Bits[this->WordAt(word, row)] >> (i & WordMask) & 1U) != 0;
  }

  void Add(int i, int j)
  {
    int word = (i >> WordShift) - this->FirstWord;
    int row = j - this->FirstRow;
    if (unsigned(word) >= unsigned(this->Words) || unsigned(row) >= unsigned(this->Rows))
    {
      this->Include(i >> WordShift, j);
      word = (i >> WordShift) - this->FirstWord;
      row = j - this->FirstRow;
    }
    this->Bits[this->WordAt(word, row)] |= std::uint64_t(1) << (i & WordMask);
  }

private:
  static constexpr int WordShift = 6;
  static constexpr int WordMask = 63;

  std::size_t WordAt(int word, int row) const { return std::size_t(row) * this->Words + word; }

  /// Rows grow by half more than needed, so that growth is rare.
  void Include(int word, int row)
  {
    ColumnSet larger;
    const bool isEmpty = this->Rows == 0;
    larger.FirstWord = isEmpty ? word : std::min(this->FirstWord, word);
    larger.Words = (isEmpty ? word + 1 : std::max(this->FirstWord + this->Words, word + 1)) - larger.FirstWord;
    const int more = 2 + this->Rows / 2;
    const int low = isEmpty ? row : this->FirstRow;
    const int end = isEmpty ? row + 1 : this->FirstRow + this->Rows;
    larger.FirstRow = row < low || isEmpty ? std::max(0, row - more) : low;
    larger.Rows = (row >= end || isEmpty ? row + 1 + more : end) - larger.FirstRow;
    larger.Bits.assign(std::size_t(larger.Rows) * larger.Words, 0);
    for (int r = 0; r < this->Rows; ++r)
    {
      std::copy_n(this->Bits.begin() + this->WordAt(0, r), this->Words,
        larger.Bits.begin() + larger.WordAt(this->FirstWord - larger.FirstWord, r + this->FirstRow - larger.FirstRow));
    }
    *this = std::move(larger);
  }

  int FirstWord = 0;
  int FirstRow = 0;
  int Words = 0;
  int Rows = 0;
  std::vector<std::uint64_t> Bits;
};

/// Sets have at most one pick per column, and the number of one of their picks. Members form a ring.
class SurfaceSets
{
public:
  explicit SurfaceSets(const ReflectionPicks& picks)
    : Picks(picks)
    , Labels(picks.Places.size(), NoPoint - 1)
    , Members(picks.Places.size())
  {
    picks.ForEach([this](PointId pick, std::int32_t column) { this->Members[pick] = { pick, column }; });
  }

  /// Returns NoPoint for a dropped pick.
  PointId SetOf(PointId pick) const
  {
    const PointId label = this->Labels[pick];
    return label < NoPoint ? pick : label;
  }
  PointId SizeOf(PointId set) const { return (NoPoint - this->Labels[set]) & ~WaitBit; }
  std::int32_t ColumnOf(PointId pick) const { return this->Members[pick].Column; }

  bool Waits(PointId set) const { return ((NoPoint - this->Labels[set]) & WaitBit) != 0; }
  void SetWaits(PointId set, bool waits)
  {
    assert(this->SetOf(set) == set);
    this->Labels[set] = NoPoint - (this->SizeOf(set) | (waits ? WaitBit : 0));
  }

  template <typename Visit>
  void ForEachMember(PointId set, Visit&& visit) const
  {
    PointId pick = set;
    do
    {
      if (!visit(pick))
      {
        return;
      }
      pick = this->Members[pick].Next;
    } while (pick != set);
  }

  /// For small sets. Picks of the column may belong to other threads.
  bool HasColumn(PointId set, std::int64_t column) const
  {
    bool isFound = false;
    this->ForEachMember(set,
      [&](PointId pick)
      {
        isFound = this->ColumnOf(pick) == column;
        return !isFound;
      });
    return isFound;
  }

  /// `shared` members, in the order of the ring, are dropped.
  void Absorb(PointId big, PointId small, const std::vector<PointId>& shared)
  {
    assert(big != small && this->SetOf(big) == big && this->SetOf(small) == small);
    PointId size = this->SizeOf(big);
    PointId pick = small;
    auto dropped = shared.begin();
    do
    {
      const PointId next = this->Members[pick].Next;
      if (dropped != shared.end() && *dropped == pick)
      {
        this->Labels[pick] = NoPoint;
        ++dropped;
      }
      else
      {
        this->Labels[pick] = big;
        this->Members[pick].Next = std::exchange(this->Members[big].Next, pick);
        ++size;
      }
      pick = next;
    } while (pick != small);
    this->Labels[big] = NoPoint - size;
  }

  RawVector<PointId> TakeLabels()
  {
    for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
    {
      this->Labels[pick] = this->SetOf(pick);
    }
    return std::move(this->Labels);
  }

private:
  struct Member
  {
    PointId Next = NoPoint;
    std::int32_t Column = 0;
  };

  const ReflectionPicks& Picks;
  // The naming pick of a set has a label below NoPoint by the size of the set; picks are fewer than 2^30, which leaves
  // a bit for waiting sets.
  static constexpr PointId WaitBit = PointId(1) << 30;
  RawVector<PointId> Labels;
  RawVector<Member> Members;
};
}

#endif
