// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCornerGraph_h
#define SeismicHorizonsCornerGraph_h

#include "Common/CountingSort.h"
#include "LinkGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A link that a fault may cut.
struct FaultCandidate
{
  std::int64_t Link = 0;
  float Size = 0.0F; // of its step; 0 for one that only joins others
  bool IsStrong = false;
};

/// The graph of some candidates: its edges are the candidates, its vertices the corners that their cuts join. Edges can
/// be dropped.
class CornerGraph
{
public:
  /// No two candidates may have the same link. Keeps the grid.
  CornerGraph(const LinkGrid& grid, std::vector<FaultCandidate> candidates);

  std::int32_t NumberOfVertices() const { return std::int32_t(this->Corners.size()); }
  std::int32_t NumberOfEdges() const { return std::int32_t(this->Candidates.size()); }
  const LinkGrid& Grid() const { return this->Links; }
  const std::vector<FaultCandidate>& Edges() const { return this->Candidates; }
  const FaultCandidate& Edge(std::int32_t edge) const { return this->Candidates[std::size_t(edge)]; }
  /// From where to where its cut leads.
  const std::array<std::int32_t, 2>& Ends(std::int32_t edge) const { return this->EndsOfEdge[std::size_t(edge)]; }

  std::int64_t Corner(std::int32_t vertex) const { return this->Corners[std::size_t(vertex)]; }
  /// The vertex at a corner, or -1.
  std::int32_t FindVertex(std::int64_t corner) const;

  bool IsKept(std::int32_t edge) const { return this->Kept[std::size_t(edge)] != 0; }
  void Drop(std::int32_t edge);
  /// How many edges a vertex has that are not dropped.
  int Degree(std::int32_t vertex) const { return this->Degrees[std::size_t(vertex)]; }

  /// Calls visit(edge, opposite vertex) for these, by their number.
  template <typename Visitor>
  void ForEachEdgeAt(std::int32_t vertex, Visitor&& visit) const
  {
    for (const std::int32_t* edge = this->EdgesAt.begin(vertex); edge != this->EdgesAt.end(vertex); ++edge)
    {
      if (this->IsKept(*edge))
      {
        const std::array<std::int32_t, 2>& ends = this->Ends(*edge);
        visit(*edge, ends[ends[0] == vertex ? 1 : 0]);
      }
    }
  }

private:
  const LinkGrid& Links;
  std::vector<FaultCandidate> Candidates;
  std::vector<std::int64_t> Corners; // of vertices, ascending
  std::vector<std::array<std::int32_t, 2>> EndsOfEdge;
  ItemLists<std::int32_t> EdgesAt; // each vertex
  std::vector<unsigned char> Kept;
  std::vector<unsigned char> Degrees;
};
}

#endif
