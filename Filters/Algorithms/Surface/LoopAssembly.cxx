// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LoopAssembly.h"

#include "Common/DisjointSets.h"
#include "Common/Errors.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using Path = std::vector<PointId>;

/// Rows first, as they are met from below.
bool IsMetBefore(const PlanePoint& a, const PlanePoint& b)
{
  return std::tie(a.Y, a.X) < std::tie(b.Y, b.X);
}

class Assembler
{
public:
  Assembler(
    const std::vector<PlanePoint>& vertices, const std::vector<Edge>& edges, const RawVector<PointId>& triangles)
    : Vertices(vertices)
    , Edges(edges)
    , IsWalked(edges.size(), false)
    , IsUsed(vertices.size(), false)
    , Connected(vertices.size())
  {
    std::sort(this->Edges.begin(), this->Edges.end(),
      [](const Edge& a, const Edge& b) { return std::tie(a.From, a.To) < std::tie(b.From, b.To); });
    for (const Edge& edge : this->Edges)
    {
      this->Connect(edge.From, edge.To);
    }
    for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
    {
      this->Connect(triangles[corner], triangles[corner + 1]);
      this->Connect(triangles[corner], triangles[corner + 2]);
    }
  }

  AssembledLoops Run()
  {
    for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
    {
      if (!this->IsWalked[edge])
      {
        this->Add(this->Walk(edge));
      }
    }
    for (std::size_t vertex = 0; vertex < this->Vertices.size(); ++vertex)
    {
      if (!this->IsUsed[vertex])
      {
        this->Outlines.push_back({ PointId(vertex) });
      }
    }
    return this->Number();
  }

private:
  const PlanePoint& At(PointId vertex) const { return this->Vertices[std::size_t(vertex)]; }

  void Connect(PointId a, PointId b)
  {
    this->Connected.Join(a, b);
    this->IsUsed[std::size_t(a)] = true;
    this->IsUsed[std::size_t(b)] = true;
  }

  /// Goes around the face to the left of an edge (Boundary/FaceWalk.h).
  Path Walk(std::size_t edge)
  {
    Path path;
    while (!this->IsWalked[edge])
    {
      this->IsWalked[edge] = true;
      path.push_back(this->Edges[edge].From);
      edge = this->Next(this->Edges[edge]);
    }
    if (this->Edges[edge].From != path.front())
    {
      throw InputError("a loop that does not come back to its vertex " + std::to_string(path.front()) +
        ", expected parts whose seams fit");
    }
    return path;
  }

  /// The first edge from the end of another one that a clockwise sweep after it meets; that back comes last.
  std::size_t Next(const Edge& edge) const
  {
    const auto first = std::lower_bound(
      this->Edges.begin(), this->Edges.end(), edge.To, [](const Edge& a, PointId vertex) { return a.From < vertex; });
    const auto last = std::find_if(first, this->Edges.end(), [&edge](const Edge& a) { return a.From != edge.To; });
    const auto next = std::min_element(
      first, last, [&](const Edge& a, const Edge& b) { return this->IsSweptBefore(edge, a.To, b.To); });
    if (next == last)
    {
      throw InputError("no edge goes on from vertex " + std::to_string(edge.To) + ", expected parts whose seams fit");
    }
    return std::size_t(next - this->Edges.begin());
  }

  /// The quarter of a clockwise sweep in which it meets the direction to a vertex: less than half a turn, half a turn,
  /// more, a whole turn.
  int QuarterOf(const Edge& edge, PointId vertex) const
  {
    const PlanePoint& here = this->At(edge.To);
    const std::int64_t side = SignedArea(here, this->At(edge.From), this->At(vertex));
    if (side == 0)
    {
      return ScalarProduct(here, this->At(edge.From), this->At(vertex)) < 0 ? 1 : 3;
    }
    return side < 0 ? 0 : 2;
  }

  bool IsSweptBefore(const Edge& edge, PointId a, PointId b) const
  {
    const int quarterA = this->QuarterOf(edge, a);
    const int quarterB = this->QuarterOf(edge, b);
    return quarterA != quarterB ? quarterA < quarterB : SignedArea(this->At(edge.To), this->At(a), this->At(b)) < 0;
  }

  void Add(Path path)
  {
    Int128 area = 0;
    for (std::size_t n = 0; n < path.size(); ++n)
    {
      area += SignedArea(this->At(path.front()), this->At(path[n]), this->At(path[(n + 1) % path.size()]));
    }
    std::rotate(path.begin(),
      std::min_element(path.begin(), path.end(), [this](PointId a, PointId b) { return this->At(a) < this->At(b); }),
      path.end());
    (area > 0 ? this->Holes : this->Outlines).push_back(std::move(path));
  }

  void SortAsMet(std::vector<Path>& paths) const
  {
    const auto firstOf = [this](const Path& path)
    {
      return this->At(*std::min_element(
        path.begin(), path.end(), [this](PointId a, PointId b) { return IsMetBefore(this->At(a), this->At(b)); }));
    };
    std::vector<std::pair<PlanePoint, std::size_t>> order;
    for (const Path& path : paths)
    {
      order.push_back({ firstOf(path), order.size() });
    }
    std::sort(order.begin(), order.end(),
      [](const auto& a, const auto& b)
      { return a.first == b.first ? a.second < b.second : IsMetBefore(a.first, b.first); });
    std::vector<Path> sorted;
    std::transform(order.begin(), order.end(), std::back_inserter(sorted),
      [&paths](const auto& entry) { return std::move(paths[entry.second]); });
    paths = std::move(sorted);
  }

  AssembledLoops Number()
  {
    AssembledLoops result;
    this->SortAsMet(this->Outlines);
    this->SortAsMet(this->Holes);
    constexpr std::int32_t none = -1;
    std::vector<std::int32_t> number(this->Vertices.size(), none);
    for (const Path& path : this->Outlines)
    {
      std::int32_t& patch = number[std::size_t(this->Connected.Find(path.front()))];
      if (patch != none)
      {
        throw InputError("two outlines of one patch, one of them at vertex " + std::to_string(path.front()) +
          ", expected parts whose seams fit");
      }
      patch = std::int32_t(result.NumberOfPatches++);
    }
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex)
    {
      result.Patch.push_back(number[std::size_t(this->Connected.Find(std::int32_t(vertex)))]);
    }
    for (const std::vector<Path>* paths : { &this->Outlines, &this->Holes })
    {
      for (const Path& path : *paths)
      {
        std::for_each(path.begin(), path.end(), [&result](PointId vertex) { result.Boundary.Append(vertex); });
        result.Boundary.Close();
      }
    }
    return result;
  }

  const std::vector<PlanePoint>& Vertices;
  std::vector<Edge> Edges; // by their first and then their second vertex
  std::vector<bool> IsWalked; // by edge
  std::vector<bool> IsUsed; // by vertex: it has an edge or a triangle
  DisjointSets Connected; // vertices
  std::vector<Path> Outlines;
  std::vector<Path> Holes;
};
}

//----------------------------------------------------------------------------------------------------------------------
AssembledLoops AssembleLoops(
  const std::vector<PlanePoint>& vertices, const std::vector<Edge>& edges, const RawVector<PointId>& triangles)
{
  return Assembler(vertices, edges, triangles).Run();
}
}
