// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A set of columns: a bit for each column of a rectangle around them, which grows.

#ifndef SeismicHorizonsColumnSet_h
#define SeismicHorizonsColumnSet_h

#include <algorithm>
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

  /// `i` and `j` are at least 0.
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

  std::size_t WordAt(int word, int row) const
  {
    return std::size_t(row) * std::size_t(this->Words) + std::size_t(word);
  }

  /// Makes the rectangle larger; rows by a half more than it takes, so that it seldom grows.
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
    larger.Bits.assign(std::size_t(larger.Words) * std::size_t(larger.Rows), 0);
    for (int r = 0; r < this->Rows; ++r)
    {
      const auto begin = this->Bits.begin() + std::ptrdiff_t(this->WordAt(0, r));
      std::copy(begin, begin + this->Words,
        larger.Bits.begin() +
          std::ptrdiff_t(larger.WordAt(this->FirstWord - larger.FirstWord, r + this->FirstRow - larger.FirstRow)));
    }
    *this = std::move(larger);
  }

  int FirstWord = 0; // a word has the bits of 64 columns along i
  int FirstRow = 0;
  int Words = 0; // of a row
  int Rows = 0;
  std::vector<std::uint64_t> Bits;
};
}

#endif
