// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From possible faulted links to lines: a graph, a forest in it, and its branches.

#ifndef SeismicHorizonsFaultForest_h
#define SeismicHorizonsFaultForest_h

#include "Common/Base/CountingSort.h"
#include "LinkGrid.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
struct FaultCandidate
{
  std::int64_t Link = 0;
  float Size = 0.0F; // size of the step; 0 for links that only join candidates
  bool IsStrong = false;

  friend bool operator<(const FaultCandidate& a, const FaultCandidate& b) { return a.Link < b.Link; }
  friend bool operator==(const FaultCandidate& a, const FaultCandidate& b) { return a.Link == b.Link; }
};

/// Sorts candidates by link. At the same link a candidate has priority over `more`.
void AddCandidates(std::vector<FaultCandidate>& candidates, const std::vector<FaultCandidate>& more);

/// Edges are candidates, vertices the corners that their cuts connect.
class CornerGraph
{
public:
  /// Candidates must have distinct links. The object keeps a reference to the grid.
  CornerGraph(const LinkGrid& grid, std::vector<FaultCandidate> candidates);

  std::int32_t NumberOfVertices() const { return std::int32_t(this->Corners.size()); }
  std::int32_t NumberOfEdges() const { return std::int32_t(this->Candidates.size()); }
  const LinkGrid& Grid() const { return this->Links; }
  const FaultCandidate& Edge(std::int32_t edge) const { return this->Candidates[edge]; }
  const std::array<std::int32_t, 2>& Ends(std::int32_t edge) const { return this->EndsOfEdge[edge]; }

  std::int64_t Corner(std::int32_t vertex) const { return this->Corners[vertex]; }
  std::int32_t FindVertex(std::int64_t corner) const;

  bool IsKept(std::int32_t edge) const { return this->Kept[edge] != 0; }
  void Drop(std::int32_t edge);
  int Degree(std::int32_t vertex) const { return this->Degrees[vertex]; }

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
  ItemLists<std::int32_t> EdgesAt;
  std::vector<unsigned char> Kept;
  std::vector<unsigned char> Degrees;
};

/// One link joins the end of a candidate to another group, or two on which the surface steps the same way by at least
/// `least`. step(link) is the height difference without the dip, or NaN.
std::vector<FaultCandidate> BridgeEnds(const LinkGrid& grid, std::vector<FaultCandidate> candidates,
  const std::function<float(std::int64_t)>& step, float least);

struct ForestLimits
{
  int SmallestExtent = 0; // columns
  int SmallestBranch = 0; // links
  int FewestStrong = 0; // candidates of a group
};

void KeepForest(CornerGraph& graph, const ForestLimits& limits);

/// The cut is followed from its first end to its second if forward.
struct ForestStep
{
  std::int32_t Edge = 0;
  bool IsForward = true;
};

/// The longest path through each tree comes first, then the longest branches.
std::vector<std::vector<ForestStep>> ListLines(const CornerGraph& graph);
}

#endif
