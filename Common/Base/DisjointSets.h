// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDisjointSets_h
#define SeismicHorizonsDisjointSets_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
/// The least number of a set is its representative.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size = 0)
    : Parents(size)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  std::int32_t Add()
  {
    this->Parents.push_back(std::int32_t(this->Parents.size()));
    return this->Parents.back();
  }

  std::int32_t Find(std::int32_t item)
  {
    while (this->Parents[std::size_t(item)] != item)
    {
      std::int32_t& parent = this->Parents[std::size_t(item)];
      parent = this->Parents[std::size_t(parent)]; // Path halving.
      item = parent;
    }
    return item;
  }

  /// Returns false if both were in one set.
  bool Join(std::int32_t a, std::int32_t b)
  {
    const std::int32_t first = this->Find(a);
    const std::int32_t second = this->Find(b);
    this->Parents[std::size_t(std::max(first, second))] = std::min(first, second);
    return first != second;
  }

private:
  std::vector<std::int32_t> Parents;
};
}

#endif
