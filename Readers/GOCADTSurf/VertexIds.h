// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps ids of vertices to indices. Ids may start anywhere and have gaps, but are mostly consecutive; such a run needs
// no table.

#ifndef SeismicHorizonsVertexIds_h
#define SeismicHorizonsVertexIds_h

#include "Common/Horizon/Types.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace SeismicHorizons
{
class VertexIds
{
public:
  /// Returns false if the id exists.
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
  /// The mixer of splitmix64 prevents patterns of ids from filling a single bucket.
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
  PointId Run = 0; // Vertices with consecutive ids from the first.
  PointId Size = 0;
  std::unordered_map<std::int64_t, PointId, Hash> Others;
};
}

#endif
