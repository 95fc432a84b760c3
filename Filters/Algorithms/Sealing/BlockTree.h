// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults divide space one by one, each the part that it is in. Blocks are the leaves of this tree.

#ifndef SeismicHorizonsBlockTree_h
#define SeismicHorizonsBlockTree_h

#include "SealedModel.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// By fault: 1 hanging wall, -1 footwall, 0 where the fault does not reach.
using BlockSides = std::vector<signed char>;

class BlockTree
{
public:
  explicit BlockTree(const std::vector<SealingFault>& faults)
    : Faults(faults)
    , Regions(faults.size(), BlockSides(faults.size(), 0))
  {
    for (std::size_t fault = 0; fault < faults.size(); ++fault)
    {
      for (const FaultSideOf& side : faults[fault].Region)
      {
        this->Regions[fault][side.Fault] = side.IsHanging ? 1 : -1;
      }
    }
  }

  bool Cuts(std::size_t fault, std::size_t horizon) const
  {
    const std::optional<std::size_t>& end = this->Faults[fault].EndsBelow;
    return !end || *end < horizon;
  }

  /// The block of a horizon whose heights count at a place. isHanging(fault) gives the place's side.
  template <typename IsHanging>
  BlockSides FindAt(std::size_t horizon, IsHanging&& isHanging) const
  {
    return this->Find(isHanging, [horizon](std::size_t end) { return end < horizon; });
  }

  /// The blocks of a horizon.
  std::vector<BlockSides> BlocksOf(std::size_t horizon) const
  {
    std::vector<BlockSides> blocks = { BlockSides(this->Faults.size(), 0) };
    for (std::size_t fault = 0; fault < this->Faults.size(); ++fault)
    {
      const std::size_t count = blocks.size();
      for (std::size_t n = 0; n < count && this->Cuts(fault, horizon); ++n)
      {
        if (this->Reaches(fault, blocks[n]))
        {
          blocks[n][fault] = 1;
          blocks.push_back(blocks[n]);
          blocks.back()[fault] = -1;
        }
      }
    }
    return blocks;
  }

  /// The block of a place. isHanging(fault) gives its side, isBelow(horizon) whether it is below the horizon.
  template <typename IsHanging, typename IsBelow>
  BlockSides Find(IsHanging&& isHanging, IsBelow&& isBelow) const
  {
    BlockSides sides(this->Faults.size(), 0);
    for (std::size_t fault = 0; fault < this->Faults.size(); ++fault)
    {
      const std::optional<std::size_t>& end = this->Faults[fault].EndsBelow;
      if (this->Reaches(fault, sides) && (!end || isBelow(*end)))
      {
        sides[fault] = isHanging(fault) ? 1 : -1;
      }
    }
    return sides;
  }

  /// Whether both may be parts of one block.
  static bool AreTogether(const BlockSides& a, const BlockSides& b)
  {
    for (std::size_t fault = 0; fault < a.size(); ++fault)
    {
      if (a[fault] * b[fault] < 0)
      {
        return false;
      }
    }
    return true;
  }

  /// Whether a place can be on both faults: no fault is between them, or they meet at or above the horizon where it ends.
  bool CanMeet(std::size_t a, std::size_t b) const
  {
    for (std::size_t fault = 0; fault < this->Faults.size(); ++fault)
    {
      const std::optional<std::size_t>& end = this->Faults[fault].EndsBelow;
      const bool isBetween = this->Regions[a][fault] * this->Regions[b][fault] < 0;
      if (isBetween && !(end && this->MeetAt(*end, a, b)))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool MeetAt(std::size_t horizon, std::size_t a, std::size_t b) const
  {
    const auto ends = [&](std::size_t fault) { return this->Faults[fault].EndsBelow == horizon; };
    return (this->Cuts(a, horizon) && (this->Cuts(b, horizon) || ends(b))) || (ends(a) && this->Cuts(b, horizon));
  }

  bool Reaches(std::size_t fault, const BlockSides& sides) const { return AreTogether(this->Regions[fault], sides); }

  const std::vector<SealingFault>& Faults;
  std::vector<BlockSides> Regions; // by fault
};
}

#endif
