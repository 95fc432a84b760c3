// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CornerGraph.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
CornerGraph::CornerGraph(const LinkGrid& grid, std::vector<FaultCandidate> candidates)
  : Links(grid)
  , Candidates(std::move(candidates))
  , Kept(this->Candidates.size(), 1)
{
  for (const FaultCandidate& candidate : this->Candidates)
  {
    for (const std::int64_t corner : grid.CornersOf(candidate.Link))
    {
      this->Corners.push_back(corner);
    }
  }
  std::sort(this->Corners.begin(), this->Corners.end());
  this->Corners.erase(std::unique(this->Corners.begin(), this->Corners.end()), this->Corners.end());
  this->Degrees.assign(this->Corners.size(), 0);
  for (const FaultCandidate& candidate : this->Candidates)
  {
    const std::array<std::int64_t, 2> corners = grid.CornersOf(candidate.Link);
    this->EndsOfEdge.push_back({ this->FindVertex(corners[0]), this->FindVertex(corners[1]) });
  }
  this->EdgesAt = ItemLists<std::int32_t>(this->NumberOfVertices(),
    [this](auto&& add)
    {
      for (std::int32_t edge = 0; edge < this->NumberOfEdges(); ++edge)
      {
        add(this->Ends(edge)[0], edge);
        add(this->Ends(edge)[1], edge);
      }
    });
  for (const std::array<std::int32_t, 2>& ends : this->EndsOfEdge)
  {
    ++this->Degrees[std::size_t(ends[0])];
    ++this->Degrees[std::size_t(ends[1])];
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t CornerGraph::FindVertex(std::int64_t corner) const
{
  const auto place = std::lower_bound(this->Corners.begin(), this->Corners.end(), corner);
  return place != this->Corners.end() && *place == corner ? std::int32_t(place - this->Corners.begin()) : -1;
}

//----------------------------------------------------------------------------------------------------------------------
void CornerGraph::Drop(std::int32_t edge)
{
  this->Kept[std::size_t(edge)] = 0;
  --this->Degrees[std::size_t(this->Ends(edge)[0])];
  --this->Degrees[std::size_t(this->Ends(edge)[1])];
}
}
