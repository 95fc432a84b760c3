// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickCollector_h
#define SeismicHorizonsPickCollector_h

#include "Common/Survey/PickTable.h"
#include "PickBlock.h"

#include <cstdint>
#include <string>
#include <unordered_map>

namespace SeismicHorizons
{
/// Puts blocks of picks together, in their order.
class PickCollector
{
public:
  explicit PickCollector(const TextLayout& layout);

  /// Makes room for so many picks. More may come.
  void Reserve(std::size_t picks);

  /// Throws InputError, with the number of the line, where a block has an error, and where lines follow an end mark.
  void Add(const PickBlock& block);

  std::size_t Size() const { return this->Picks; }

  /// All that was added. Throws InputError where that is not what the file says it has.
  PickTable Take();

private:
  void AddNames(const PickBlock& block);
  std::vector<double>& Column(std::size_t column);

  const TextLayout& Layout;
  PickTable Table;
  std::size_t Picks = 0;
  std::int64_t Lines = 0; // before the next block
  bool HasEnded = false;
  std::unordered_map<std::string, int> Numbers; // of names
};
}

#endif
