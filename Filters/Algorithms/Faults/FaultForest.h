// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From links that a fault may cut to lines: a graph of them, a forest in it, and its branches one after the other.

#ifndef SeismicHorizonsFaultForest_h
#define SeismicHorizonsFaultForest_h

#include "Common/CountingSort.h"
#include "LinkGrid.h"

#include <array>
#include <cstdint>
#include <functional>
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
  /// No two candidates may have the same link. Keeps a reference to the grid.
  CornerGraph(const LinkGrid& grid, std::vector<FaultCandidate> candidates);

  std::int32_t NumberOfVertices() const { return std::int32_t(this->Corners.size()); }
  std::int32_t NumberOfEdges() const { return std::int32_t(this->Candidates.size()); }
  const LinkGrid& Grid() const { return this->Links; }
  const FaultCandidate& Edge(std::int32_t edge) const { return this->Candidates[edge]; }
  /// From where to where its cut leads.
  const std::array<std::int32_t, 2>& Ends(std::int32_t edge) const { return this->EndsOfEdge[edge]; }

  std::int64_t Corner(std::int32_t vertex) const { return this->Corners[vertex]; }
  /// The vertex at a corner, or -1.
  std::int32_t FindVertex(std::int64_t corner) const;

  bool IsKept(std::int32_t edge) const { return this->Kept[edge] != 0; }
  void Drop(std::int32_t edge);
  /// How many edges a vertex has that are not dropped.
  int Degree(std::int32_t vertex) const { return this->Degrees[vertex]; }

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

/// The candidates, and links that join the end of one to another group: one link between, or two on which the surface
/// steps the same way as where the candidate ends, by at least `least`. step(link) is the height beyond it minus that
/// before it, less the dip; nan where it is not known.
std::vector<FaultCandidate> BridgeEnds(const LinkGrid& grid, std::vector<FaultCandidate> candidates,
  const std::function<float(std::int64_t)>& step, float least);

/// Which groups and branches are too small for a fault.
struct ForestLimits
{
  int SmallestExtent = 0; // columns
  int SmallestBranch = 0; // links
  int FewestStrong = 0; // candidates of a group
};

/// Keeps the maximum spanning forest by the sizes of steps, without trees and branches that are too small.
void KeepForest(CornerGraph& graph, const ForestLimits& limits);

/// A step along a line, and whether the candidate's cut is walked from its first end to its second.
struct ForestStep
{
  std::int32_t Edge = 0;
  bool IsForward = true;
};

/// The kept edges, which are a forest, as lines: the longest path through each tree, then the longest paths that branch
/// off from it.
std::vector<std::vector<ForestStep>> ListLines(const CornerGraph& graph);
}

#endif
