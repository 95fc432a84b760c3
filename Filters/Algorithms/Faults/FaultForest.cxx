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
    assert(this->EndsOfEdge.back()[0] >= 0 && this->EndsOfEdge.back()[1] > this->EndsOfEdge.back()[0]);
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
    ++this->Degrees[ends[0]];
    ++this->Degrees[ends[1]];
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

//----------------------------------------------------------------------------------------------------------------------
// Bridges

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
  const std::int64_t shift = isForward ? 1 : -1;
  const std::int64_t x = grid.CornerX(corner) + (isAcrossNorth ? shift : 0);
  const std::int64_t y = grid.CornerY(corner) + (isAcrossNorth ? 0 : shift);
  // The column of the link is below and left of the end of a forward step.
  const std::int64_t columnX = isAcrossNorth && !isForward ? x + 1 : x;
  const std::int64_t columnY = !isAcrossNorth && !isForward ? y + 1 : y;
  if (columnX < 0 || columnY < 0 || columnX >= grid.Width() || columnY >= grid.Height())
  {
    return {};
  }
  const std::int64_t link = grid.LinkOf(columnX, columnY, isAcrossNorth ? LinkSide::North : LinkSide::East);
  return grid.IsInside(link) ? CornerStep{ link, grid.CornerOf(x, y), isForward } : CornerStep{};
}

class EndBridges
{
public:
  EndBridges(const CornerGraph& graph, const std::function<float(std::int64_t)>& step, float least)
    : Graph(graph)
    , Groups(JoinKept(graph))
    , StepAcross(step)
    , Least(least)
  {
  }

  std::vector<std::int64_t> Find()
  {
    for (std::int32_t vertex = 0; vertex < this->Graph.NumberOfVertices(); ++vertex)
    {
      if (this->Graph.Degree(vertex) == 1)
      {
        const std::int32_t edge = this->OnlyEdge(vertex);
        const bool isForward = this->Graph.Ends(edge)[1] == vertex;
        this->FindFrom(vertex, this->LeftStep(this->Graph.Edge(edge).Link, isForward));
      }
    }
    std::sort(this->Links.begin(), this->Links.end());
    this->Links.erase(std::unique(this->Links.begin(), this->Links.end()), this->Links.end());
    return std::move(this->Links);
  }

private:
  std::int32_t OnlyEdge(std::int32_t vertex) const
  {
    std::int32_t only = -1;
    this->Graph.ForEachEdgeAt(vertex, [&only](std::int32_t edge, std::int32_t) { only = edge; });
    return only;
  }

  float LeftStep(std::int64_t link, bool isForward) const
  {
    const float step = this->StepAcross(link);
    return IsLeftBeyond(LinkGrid::SideOf(link), isForward) ? step : -step;
  }

  bool Continues(const CornerStep& step, float left) const
  {
    return this->LeftStep(step.Link, step.IsForward) * (left < 0.0F ? -1.0F : 1.0F) >= this->Least;
  }

  bool IsOfOtherGroup(std::int32_t vertex, std::int32_t other)
  {
    return other >= 0 && this->Groups.Find(other) != this->Groups.Find(vertex);
  }

  /// A single candidate must start at the vertex, with its left on the same side.
  bool StartsAlike(std::int32_t vertex, float left) const
  {
    if (this->Graph.Degree(vertex) != 1)
    {
      return false;
    }
    const std::int32_t edge = this->OnlyEdge(vertex);
    const bool isForward = this->Graph.Ends(edge)[0] == vertex;
    return this->LeftStep(this->Graph.Edge(edge).Link, isForward) * left > 0.0F;
  }

  void FindFrom(std::int32_t vertex, float left)
  {
    const LinkGrid& grid = this->Graph.Grid();
    for (int direction = 0; direction < NumberOfDirections; ++direction)
    {
      const CornerStep first = StepFrom(grid, this->Graph.Corner(vertex), direction);
      const std::int32_t middle = first.Link >= 0 ? this->Graph.FindVertex(first.Target) : -1;
      if (this->IsOfOtherGroup(vertex, middle))
      {
        this->Links.push_back(first.Link);
      }
      if (first.Link < 0 || middle >= 0 || !this->Continues(first, left))
      {
        continue;
      }
      for (int next = 0; next < NumberOfDirections; ++next)
      {
        const CornerStep second = StepFrom(grid, first.Target, next);
        if (second.Link < 0 || !this->Continues(second, left))
        {
          continue;
        }
        const std::int32_t end = this->Graph.FindVertex(second.Target);
        if (this->IsOfOtherGroup(vertex, end) && this->StartsAlike(end, left))
        {
          this->Links.push_back(first.Link);
          this->Links.push_back(second.Link);
        }
      }
    }
  }

  const CornerGraph& Graph;
  DisjointSets Groups;
  const std::function<float(std::int64_t)>& StepAcross;
  const float Least;
  std::vector<std::int64_t> Links;
};

//----------------------------------------------------------------------------------------------------------------------
// Forest

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

//----------------------------------------------------------------------------------------------------------------------
// Lines

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
            assert(!this->IsVisited(opposite));
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
  for (const std::int64_t link : EndBridges(graph, step, least).Find())
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
  TreePaths probe(graph);
  TreePaths paths(graph);
  for (std::int32_t vertex = 0; vertex < graph.NumberOfVertices(); ++vertex)
  {
    if (graph.Degree(vertex) > 0 && !probe.IsVisited(vertex))
    {
      // The vertex farthest from any other is an end of the longest path.
      const std::int32_t end = probe.Visit(vertex).back();
      const std::vector<std::int32_t> order = paths.Visit(end);
      paths.AppendLines(order, lines);
    }
  }
  return lines;
}
}
