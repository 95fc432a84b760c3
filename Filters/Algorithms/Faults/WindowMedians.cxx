// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where no number is missing, many windows are processed side by side. Each column of seven numbers is sorted; sorted
// columns are merged to two, three and four, which neighbouring windows share, and the median is selected from the
// first four and the last three columns of a window. Sorting and merging are networks (Batcher 1968), without branches.
//
// Elsewhere, a window moves from place to place: one sorted column leaves, another one enters, in one pass over the
// sorted window.

#include "WindowMedians.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t ValuesOfWindow = WindowSide * WindowSide;

// ---- Networks -------------------------------------------------------------------------------------------------------

constexpr std::size_t NumberOfLanes = 64;
using LaneValues = std::array<float, NumberOfLanes>;
constexpr std::int64_t LanesPerBlock = std::int64_t(NumberOfLanes) - 2 * WindowReach;

using RowList = std::vector<std::size_t>;

/// The first row of a pair receives the smaller numbers. In Order, rows are ascending at the end.
struct Network
{
  std::vector<std::pair<std::size_t, std::size_t>> Pairs;
  RowList Order;

  void Run(LaneValues* rows) const
  {
    for (const auto& [first, second] : this->Pairs)
    {
      float* const a = rows[first].data();
      float* const b = rows[second].data();
      for (std::size_t n = 0; n < NumberOfLanes; ++n)
      {
        const float low = std::min(a[n], b[n]);
        b[n] = std::max(a[n], b[n]);
        a[n] = low;
      }
    }
  }
};

RowList EveryOther(const RowList& rows, std::size_t first)
{
  RowList result;
  for (std::size_t n = first; n < rows.size(); n += 2)
  {
    result.push_back(rows[n]);
  }
  return result;
}

RowList AddMerge(Network& network, const RowList& a, const RowList& b)
{
  if (a.empty() || b.empty())
  {
    return a.empty() ? b : a;
  }
  if (a.size() == 1 && b.size() == 1)
  {
    network.Pairs.emplace_back(a[0], b[0]);
    return { a[0], b[0] };
  }
  const RowList odd = AddMerge(network, EveryOther(a, 0), EveryOther(b, 0));
  const RowList even = AddMerge(network, EveryOther(a, 1), EveryOther(b, 1));
  RowList sorted = { odd[0] };
  for (std::size_t n = 0; n < even.size() || n + 1 < odd.size(); ++n)
  {
    if (n < even.size() && n + 1 < odd.size())
    {
      network.Pairs.emplace_back(even[n], odd[n + 1]);
    }
    if (n < even.size())
    {
      sorted.push_back(even[n]);
    }
    if (n + 1 < odd.size())
    {
      sorted.push_back(odd[n + 1]);
    }
  }
  return sorted;
}

RowList Range(std::size_t first, std::size_t last)
{
  RowList rows;
  for (std::size_t row = first; row < last; ++row)
  {
    rows.push_back(row);
  }
  return rows;
}

RowList AddSort(Network& network, std::size_t first, std::size_t last)
{
  const std::size_t middle = (first + last) / 2;
  if (last - first == 1)
  {
    return { first };
  }
  const RowList low = AddSort(network, first, middle);
  return AddMerge(network, low, AddSort(network, middle, last));
}

Network MakeSort(std::size_t size)
{
  Network network;
  network.Order = AddSort(network, 0, size);
  return network;
}

Network MakeMerge(std::size_t size, std::size_t others)
{
  Network network;
  network.Order = AddMerge(network, Range(0, size), Range(size, size + others));
  return network;
}

// ---- Windows without missing numbers --------------------------------------------------------------------------------

class WindowBlock
{
public:
  void Find(const std::array<const float*, WindowSide>& rows, float* medians)
  {
    static const Network sort = MakeSort(Side);
    static const Network toPairs = MakeMerge(Side, Side);
    static const Network toThree = MakeMerge(2 * Side, Side);
    static const Network toFour = MakeMerge(2 * Side, 2 * Side);
    for (std::size_t n = 0; n < Side; ++n)
    {
      std::copy_n(rows[n], NumberOfLanes, this->GridColumn[n].begin());
    }
    sort.Run(this->GridColumn.data());
    Copy(this->GridColumn.data(), sort, 0, this->Pair.data());
    Copy(this->GridColumn.data(), sort, 1, this->Pair.data() + Side);
    toPairs.Run(this->Pair.data());
    Copy(this->Pair.data(), toPairs, 0, this->Four.data());
    Copy(this->Pair.data(), toPairs, 2, this->Four.data() + 2 * Side);
    toFour.Run(this->Four.data());
    Copy(this->Pair.data(), toPairs, 4, this->Three.data());
    Copy(this->GridColumn.data(), sort, 6, this->Three.data() + 2 * Side);
    toThree.Run(this->Three.data());
    this->Select(toFour.Order, toThree.Order, medians);
  }

private:
  static constexpr std::size_t Side = std::size_t(WindowSide);

  static void Copy(const LaneValues* from, const Network& sorted, std::size_t shift, LaneValues* to)
  {
    for (std::size_t n = 0; n < sorted.Order.size(); ++n)
    {
      const LaneValues& row = from[sorted.Order[n]];
      std::copy(row.begin() + shift, row.end(), to[n].begin());
    }
  }

  /// The median is the least number that has half of the window at or below it in both sorted sets.
  void Select(const RowList& ofFour, const RowList& ofThree, float* medians) const
  {
    constexpr std::size_t rank = std::size_t(ValuesOfWindow) / 2;
    LaneValues result = this->Four[ofFour[rank]];
    for (std::size_t n = 0; n < ofThree.size(); ++n)
    {
      const LaneValues& four = this->Four[ofFour[rank - 1 - n]];
      const LaneValues& three = this->Three[ofThree[n]];
      for (std::size_t lane = 0; lane < NumberOfLanes; ++lane)
      {
        result[lane] = std::min(result[lane], std::max(four[lane], three[lane]));
      }
    }
    std::copy_n(result.begin(), LanesPerBlock, medians);
  }

  // The last lanes are not used after a merge.
  std::array<LaneValues, Side> GridColumn = {};
  std::array<LaneValues, 2 * Side> Pair = {};
  std::array<LaneValues, 3 * Side> Three = {};
  std::array<LaneValues, 4 * Side> Four = {};
};

// ---- Other windows --------------------------------------------------------------------------------------------------

struct SortedColumn
{
  std::array<float, std::size_t(WindowSide)> Values;
  int Size = 0;

  void Insert(float value)
  {
    int place = this->Size++;
    for (; place > 0 && this->Values[place - 1] > value; --place)
    {
      this->Values[place] = this->Values[place - 1];
    }
    this->Values[place] = value;
  }
};

class SortedWindow
{
public:
  void Replace(const SortedColumn& leaving, const SortedColumn& coming)
  {
    std::array<float, std::size_t(ValuesOfWindow)> next;
    std::size_t size = 0;
    int left = 0;
    int came = 0;
    for (std::size_t n = 0; n < this->Size; ++n)
    {
      const float value = this->Values[n];
      if (left < leaving.Size && leaving.Values[left] == value)
      {
        ++left;
        continue;
      }
      while (came < coming.Size && coming.Values[came] < value)
      {
        next[size++] = coming.Values[came++];
      }
      next[size++] = value;
    }
    while (came < coming.Size)
    {
      next[size++] = coming.Values[came++];
    }
    std::copy(next.begin(), next.begin() + size, this->Values.begin());
    this->Size = size;
  }

  float Median() const { return this->Values[this->Size == 0 ? 0 : (this->Size - 1) / 2]; }

private:
  std::array<float, std::size_t(ValuesOfWindow)> Values = {};
  std::size_t Size = 0;
};

void FindOneByOne(const std::array<const float*, WindowSide>& rows, std::int64_t width, std::int64_t first,
  std::int64_t last, float* medians)
{
  std::array<SortedColumn, WindowSide> gridColumns; // a ring
  SortedWindow window;
  for (std::int64_t x = first - 2 * WindowReach; x < last; ++x)
  {
    SortedColumn coming;
    const std::int64_t place = x + WindowReach;
    for (std::size_t n = 0; n < rows.size() && place >= 0 && place < width; ++n)
    {
      if (!std::isnan(rows[n][place]))
      {
        coming.Insert(rows[n][place]);
      }
    }
    SortedColumn& oldest = gridColumns[std::size_t(x - first + 2 * WindowReach) % gridColumns.size()];
    window.Replace(oldest, coming);
    oldest = coming;
    if (x >= first)
    {
      medians[x] = window.Median();
    }
  }
}

std::int64_t FindEnd(
  const std::array<const float*, WindowSide>& rows, std::int64_t width, std::int64_t x, bool isMissing)
{
  const auto hasMissing = [&](std::int64_t place)
  {
    float sum = 0.0F;
    for (const float* const row : rows)
    {
      sum += row[place];
    }
    return std::isnan(sum);
  };
  while (x < width && hasMissing(x) != isMissing)
  {
    ++x;
  }
  return x;
}
}

//----------------------------------------------------------------------------------------------------------------------
void FindWindowMedians(const std::array<const float*, WindowSide>& rows, std::int64_t width, float* medians)
{
  WindowBlock block;
  std::int64_t done = 0;
  for (std::int64_t end = 0; end < width;)
  {
    const std::int64_t begin = FindEnd(rows, width, end, false);
    end = FindEnd(rows, width, begin, true);
    const std::int64_t first = begin + WindowReach;
    const std::int64_t last = end - WindowReach;
    if (last - first < LanesPerBlock)
    {
      continue;
    }
    FindOneByOne(rows, width, done, first, medians);
    for (std::int64_t x = first; x < last; x += LanesPerBlock)
    {
      const std::int64_t start = std::min(x, last - LanesPerBlock);
      std::array<const float*, WindowSide> gridColumns;
      std::transform(
        rows.begin(), rows.end(), gridColumns.begin(), [&](const float* row) { return row + start - WindowReach; });
      block.Find(gridColumns, medians + start);
    }
    done = last;
  }
  FindOneByOne(rows, width, done, width, medians);
}
}
