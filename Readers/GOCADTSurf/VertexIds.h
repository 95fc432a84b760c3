// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the ids that a file gives vertices to their numbers, from 0. Ids may begin anywhere and have gaps. Nearly always
// they count up from the first one, so that a vertex of such a run is found without a table.

#ifndef SeismicHorizonsVertexIds_h
#define SeismicHorizonsVertexIds_h

#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace SeismicHorizons
{
class VertexIds
{
public:
  /// Gives the next vertex an id. False when another one has it.
  bool Add(std::int64_t id)
  {
    if (this->Size == 0)
    {
      this->FirstId = id;
    }
    if (this->Find(id) != NoPoint)
    {
      return false;
    }
    if (this->Run == this->Size && id - this->FirstId == this->Run)
    {
      ++this->Run;
    }
    else
    {
      this->Others.emplace(id, this->Size);
    }
    ++this->Size;
    return true;
  }

  /// The vertex of an id, or NoPoint.
  PointId Find(std::int64_t id) const
  {
    if (id >= this->FirstId && id - this->FirstId < this->Run)
    {
      return static_cast<PointId>(id - this->FirstId);
    }
    const auto found = this->Others.find(id);
    return found == this->Others.end() ? NoPoint : found->second;
  }

private:
  /// Spreads all bits, so that no pattern of ids fills a single bucket of the table (the mixer of splitmix64).
  struct Hash
  {
    std::size_t operator()(std::int64_t id) const
    {
      auto bits = static_cast<std::uint64_t>(id) + 0x9e3779b97f4a7c15u;
      bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
      bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
      return static_cast<std::size_t>(bits ^ (bits >> 31));
    }
  };

  std::int64_t FirstId = 0;
  PointId Run = 0; // vertices from the first on whose ids count up one by one
  PointId Size = 0;
  std::unordered_map<std::int64_t, PointId, Hash> Others; // all vertices behind the run
};
}

#endif
