// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Candidates whose cuts meet in corners form a group.
//
//  1. BridgeEnds: one or two links join the end of a single candidate to another group.
//  2. KeepForest: each group keeps its maximum spanning tree (Kruskal, 1956). Small trees are dropped, then short
//     branches, shortest first, then trees that have become too small.
//  3. ListLines: the longest path through each tree, from the vertex farthest from any other (Bulterman et al., 2002),
//     then branches, which continue along the longest path. A closed fault is opened at its smallest step.

#include "FaultForest.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void AddCandidates(std::vector<FaultCandidate>& candidates, const std::vector<FaultCandidate>& more)
{
  candidates.insert(candidates.end(), more.begin(), more.end());
  std::stable_sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
}

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
    const auto [first, second] = this->EndsOfEdge.back();
    assert(first >= 0 && second > first);
    ++this->Degrees[first];
    ++this->Degrees[second];
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
  assert(this->IsKept(edge));
  this->Kept[edge] = 0;
  --this->Degrees[this->Ends(edge)[0]];
  --this->Degrees[this->Ends(edge)[1]];
}

namespace
{
template <typename Visitor>
void ForEachKept(const CornerGraph& graph, Visitor&& visit)
{
  for (std::int32_t edge = 0; edge < graph.NumberOfEdges(); ++edge)
  {
    if (graph.IsKept(edge))
    {
      visit(edge);
    }
  }
}

DisjointSets JoinKept(const CornerGraph& graph)
{
  DisjointSets groups(graph.NumberOfVertices());
  ForEachKept(graph, [&](std::int32_t edge) { groups.Join(graph.Ends(edge)[0], graph.Ends(edge)[1]); });
  return groups;
}

// ---- Bridges --------------------------------------------------------------------------------------------------------

struct CornerStep
{
  std::int64_t Link = -1; // -1 outside the box
  std::int64_t Target = -1;
  bool IsForward = true;
};

constexpr int NumberOfDirections = 4; // The directions are east, north, west, south.

CornerStep StepFrom(const LinkGrid& grid, std::int64_t corner, int direction)
{
  const bool isForward = direction < 2;
  const bool isAcrossNorth = direction % 2 == 0;
  std::int64_t x = grid.CornerX(corner);
  std::int64_t y = grid.CornerY(corner);
  std::int64_t& changed = isAcrossNorth ? x : y;
  changed += isForward ? 1 : -1;
  const std::int64_t target = grid.CornerOf(x, y);
  changed += isForward ? 0 : 1; // The column of the link is below and left of the end of a forward step.
  if (x < 0 || y < 0 || x >= grid.Width() || y >= grid.Height())
  {
    return {};
  }
  const std::int64_t link = grid.LinkOf(x, y, isAcrossNorth ? LinkSide::North : LinkSide::East);
  return grid.IsInside(link) ? CornerStep{ link, target, isForward } : CornerStep{};
}

using StepAcross = std::function<float(std::int64_t)>; // height difference without the dip, by link, or NaN

float LeftStep(const StepAcross& step, std::int64_t link, bool isForward)
{
  return IsLeftBeyond(LinkGrid::SideOf(link), isForward) ? step(link) : -step(link);
}

/// Returns the step to the left of the only edge at a vertex, on the way to the vertex or from it.
float OnlyLeftStep(const CornerGraph& graph, const StepAcross& step, std::int32_t vertex, bool isTo)
{
  std::int32_t only = -1;
  graph.ForEachEdgeAt(vertex, [&only](std::int32_t edge, std::int32_t) { only = edge; });
  assert(only >= 0 && graph.Degree(vertex) == 1);
  return LeftStep(step, graph.Edge(only).Link, graph.Ends(only)[isTo ? 1 : 0] == vertex);
}

/// A path of two links must end at a single candidate with its left on the same side.
std::vector<std::int64_t> FindBridges(const CornerGraph& graph, const StepAcross& step, float least)
{
  DisjointSets groups = JoinKept(graph);
  std::vector<std::int64_t> links;
  for (std::int32_t vertex = 0; vertex < graph.NumberOfVertices(); ++vertex)
  {
    if (graph.Degree(vertex) != 1)
    {
      continue;
    }
    const float left = OnlyLeftStep(graph, step, vertex, true);
    const auto continues = [&](const CornerStep& next)
    { return LeftStep(step, next.Link, next.IsForward) * (left < 0.0F ? -1.0F : 1.0F) >= least; };
    const auto isOfOtherGroup = [&](std::int32_t other)
    { return other >= 0 && groups.Find(other) != groups.Find(vertex); };
    for (int direction = 0; direction < NumberOfDirections; ++direction)
    {
      const CornerStep first = StepFrom(graph.Grid(), graph.Corner(vertex), direction);
      const std::int32_t middle = first.Link >= 0 ? graph.FindVertex(first.Target) : -1;
      if (isOfOtherGroup(middle))
      {
        links.push_back(first.Link);
      }
      for (int next = 0; next < NumberOfDirections && first.Link >= 0 && middle < 0 && continues(first); ++next)
      {
        const CornerStep second = StepFrom(graph.Grid(), first.Target, next);
        const std::int32_t end = second.Link >= 0 && continues(second) ? graph.FindVertex(second.Target) : -1;
        if (isOfOtherGroup(end) && graph.Degree(end) == 1 && OnlyLeftStep(graph, step, end, false) * left > 0.0F)
        {
          links.insert(links.end(), { first.Link, second.Link });
        }
      }
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

// ---- Forest ---------------------------------------------------------------------------------------------------------

void KeepTrees(CornerGraph& graph)
{
  std::vector<std::int32_t> order(graph.NumberOfEdges());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&graph](std::int32_t a, std::int32_t b) { return graph.Edge(a).Size > graph.Edge(b).Size; });
  DisjointSets trees(graph.NumberOfVertices());
  for (const std::int32_t edge : order)
  {
    if (!trees.Join(graph.Ends(edge)[0], graph.Ends(edge)[1]))
    {
      graph.Drop(edge);
    }
  }
}

void DropSmallTrees(CornerGraph& graph, const ForestLimits& limits)
{
  DisjointSets trees = JoinKept(graph);
  const auto treeOf = [&](std::int32_t edge) { return trees.Find(graph.Ends(edge)[0]); };
  std::vector<PlaneBox> boxes(graph.NumberOfVertices());
  std::vector<std::int32_t> strong(boxes.size(), 0);
  const LinkGrid& grid = graph.Grid();
  ForEachKept(graph,
    [&](std::int32_t edge)
    {
      const std::int32_t tree = treeOf(edge);
      strong[tree] += graph.Edge(edge).IsStrong ? 1 : 0;
      for (const std::int32_t end : graph.Ends(edge))
      {
        const std::int64_t corner = graph.Corner(end);
        boxes[tree].Add(PlanePoint{ std::int32_t(grid.CornerX(corner)), std::int32_t(grid.CornerY(corner)) });
      }
    });
  ForEachKept(graph,
    [&](std::int32_t edge)
    {
      const std::int32_t tree = treeOf(edge);
      const PlaneBox& box = boxes[tree];
      const std::int32_t extent = std::max(box.Greatest.X - box.Least.X, box.Greatest.Y - box.Least.Y);
      if (extent < limits.SmallestExtent || strong[tree] < limits.FewestStrong)
      {
        graph.Drop(edge);
      }
    });
}

/// Returns no edge if the next junction is more than `longest` away.
std::vector<std::int32_t> WalkBranch(const CornerGraph& graph, std::int32_t end, int longest)
{
  std::vector<std::int32_t> branch;
  std::int32_t vertex = end;
  while (int(branch.size()) < longest)
  {
    const std::int32_t came = branch.empty() ? -1 : branch.back();
    std::int32_t next = -1;
    graph.ForEachEdgeAt(vertex,
      [&](std::int32_t edge, std::int32_t opposite)
      {
        if (edge != came)
        {
          branch.push_back(edge);
          next = opposite;
        }
      });
    if (next < 0)
    {
      return {}; // The tree is a single line.
    }
    if (graph.Degree(next) > 2)
    {
      return branch;
    }
    vertex = next;
  }
  return {};
}

/// Shorter branches go first, since the rest of their junction may belong to a longer branch.
void PruneBranches(CornerGraph& graph, int smallest)
{
  std::set<std::pair<std::size_t, std::int32_t>> branches;
  for (std::int32_t vertex = 0; vertex < graph.NumberOfVertices(); ++vertex)
  {
    if (graph.Degree(vertex) == 1)
    {
      branches.emplace(0U, vertex);
    }
  }
  while (!branches.empty())
  {
    const auto [length, end] = *branches.begin();
    branches.erase(branches.begin());
    const std::vector<std::int32_t> branch = WalkBranch(graph, end, smallest - 1);
    if (branch.size() > length)
    {
      branches.emplace(branch.size(), end);
    }
    else if (branch.size() == length)
    {
      std::for_each(branch.begin(), branch.end(), [&graph](std::int32_t edge) { graph.Drop(edge); });
    }
  }
}

// ---- Lines ----------------------------------------------------------------------------------------------------------

class TreePaths
{
public:
  explicit TreePaths(const CornerGraph& graph)
    : Graph(graph)
    , EdgeBack(graph.NumberOfVertices(), -1)
    , Back(this->EdgeBack)
    , Height(this->EdgeBack.size(), 0)
    , Next(this->EdgeBack.size(), -1)
  {
  }

  bool IsVisited(std::int32_t vertex) const { return this->Back[vertex] >= 0; }

  /// The last vertex is farthest from the root.
  std::vector<std::int32_t> Visit(std::int32_t root)
  {
    std::vector<std::int32_t> order = { root };
    this->Back[root] = root;
    this->EdgeBack[root] = -1;
    for (std::size_t n = 0; n < order.size(); ++n)
    {
      const std::int32_t vertex = order[n];
      this->Graph.ForEachEdgeAt(vertex,
        [&](std::int32_t edge, std::int32_t opposite)
        {
          if (edge != this->EdgeBack[vertex])
          {
            this->Back[opposite] = vertex;
            this->EdgeBack[opposite] = edge;
            order.push_back(opposite);
          }
        });
    }
    return order;
  }

  /// Lines of the last visited tree continue along the longest path from each vertex.
  void AppendLines(const std::vector<std::int32_t>& order, std::vector<std::vector<ForestStep>>& lines)
  {
    for (auto vertex = order.rbegin(); vertex + 1 != order.rend(); ++vertex)
    {
      const std::int32_t back = this->Back[*vertex];
      const std::int32_t height = this->Height[*vertex] + 1;
      if (height > this->Height[back])
      {
        this->Height[back] = height;
        this->Next[back] = *vertex;
      }
    }
    for (const std::int32_t vertex : order)
    {
      const std::int32_t back = this->Back[vertex];
      if (vertex == order.front())
      {
        this->AppendLine(this->Next[vertex], lines);
      }
      else if (this->Next[back] != vertex)
      {
        this->AppendLine(vertex, lines);
      }
    }
  }

private:
  void AppendLine(std::int32_t vertex, std::vector<std::vector<ForestStep>>& lines) const
  {
    std::vector<ForestStep> line;
    for (; vertex >= 0; vertex = this->Next[vertex])
    {
      const std::int32_t edge = this->EdgeBack[vertex];
      line.push_back({ edge, this->Graph.Ends(edge)[1] == vertex });
    }
    lines.push_back(std::move(line));
  }

  const CornerGraph& Graph;
  std::vector<std::int32_t> EdgeBack;
  std::vector<std::int32_t> Back; // The root is its own predecessor.
  std::vector<std::int32_t> Height; // edges of the longest path away from the root
  std::vector<std::int32_t> Next; // first vertex of this path
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultCandidate> BridgeEnds(const LinkGrid& grid, std::vector<FaultCandidate> candidates,
  const std::function<float(std::int64_t)>& step, float least)
{
  const CornerGraph graph(grid, candidates);
  for (const std::int64_t link : FindBridges(graph, step, least))
  {
    const float size = std::abs(step(link));
    candidates.push_back({ link, std::isnan(size) ? 0.0F : size, false });
  }
  return candidates;
}

//----------------------------------------------------------------------------------------------------------------------
void KeepForest(CornerGraph& graph, const ForestLimits& limits)
{
  KeepTrees(graph);
  DropSmallTrees(graph, limits);
  PruneBranches(graph, limits.SmallestBranch);
  DropSmallTrees(graph, limits); // Some trees were large only through their branches.
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::vector<ForestStep>> ListLines(const CornerGraph& graph)
{
  std::vector<std::vector<ForestStep>> lines;
  TreePaths paths(graph);
  for (std::int32_t vertex = 0; vertex < graph.NumberOfVertices(); ++vertex)
  {
    if (graph.Degree(vertex) > 0 && !paths.IsVisited(vertex))
    {
      // The vertex farthest from any other is an end of the longest path.
      const std::int32_t end = paths.Visit(vertex).back();
      const std::vector<std::int32_t> order = paths.Visit(end);
      paths.AppendLines(order, lines);
    }
  }
  return lines;
}
}
