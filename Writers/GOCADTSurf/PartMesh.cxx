// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TSurfPrinter.h"

#include "Common/Base/CountingSort.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
using TriangleLists = ItemLists<std::int32_t, std::uint32_t>;

TriangleLists SortByPart(const TSurf& surface, std::size_t& numberOfParts)
{
  std::vector<std::int32_t> numbers = surface.Parts;
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  numberOfParts = std::max<std::size_t>(numbers.size(), 1);
  const auto partOf = [&](std::size_t triangle)
  {
    return surface.Parts.empty()
      ? 0
      : std::lower_bound(numbers.begin(), numbers.end(), surface.Parts[triangle]) - numbers.begin();
  };
  return TriangleLists(std::int64_t(numberOfParts),
    [&](auto&& add)
    {
      for (std::size_t triangle = 0; triangle < surface.Triangles.size(); ++triangle)
      {
        add(partOf(triangle), std::int32_t(triangle));
      }
    });
}

class PartLister
{
public:
  PartMesh Mesh;

  explicit PartLister(const TSurf& surface)
    : Surface(surface)
    , First(surface.Vertices.size(), NoPoint)
    , Listed(surface.Vertices.size(), NoPoint)
  {
    this->Mesh.Triangles.reserve(surface.Triangles.size());
  }

  void Add(const std::int32_t* firstTriangle, const std::int32_t* lastTriangle)
  {
    std::for_each(firstTriangle, lastTriangle, [this](std::int32_t triangle) { this->CollectVertices(triangle); });
    const auto start = std::ptrdiff_t(this->Mesh.Places.size());
    std::sort(this->Mesh.Sources.begin() + start, this->Mesh.Sources.end());
    for (std::size_t vertex = this->Mesh.Places.size(); vertex < this->Mesh.Sources.size(); ++vertex)
    {
      const auto source = std::size_t(this->Mesh.Sources[vertex]);
      this->Mesh.Places.push_back(this->First[source]);
      this->Listed[source] = PointId(vertex);
      this->First[source] = this->First[source] == NoPoint ? PointId(vertex) : this->First[source];
    }
    std::for_each(firstTriangle, lastTriangle,
      [this](std::int32_t triangle)
      {
        const auto& [a, b, c] = this->Surface.Triangles[std::size_t(triangle)];
        this->Mesh.Triangles.push_back(
          { this->Listed[std::size_t(a)], this->Listed[std::size_t(b)], this->Listed[std::size_t(c)] });
      });
    this->Mesh.Parts.push_back({ this->Mesh.Sources.size(), this->Mesh.Triangles.size() });
  }

private:
  void CollectVertices(std::int32_t triangle)
  {
    for (const PointId vertex : this->Surface.Triangles[std::size_t(triangle)])
    {
      // Entries of earlier parts are before this part, and count as not listed.
      PointId& listed = this->Listed[std::size_t(vertex)];
      if (listed < PointId(this->Mesh.Places.size()))
      {
        listed = PointId(this->Mesh.Sources.size());
        this->Mesh.Sources.push_back(vertex);
      }
    }
  }

  const TSurf& Surface;
  std::vector<PointId> First; // first entry of each vertex, or NoPoint
  std::vector<PointId> Listed; // last entry of each vertex, or NoPoint
};

/// An edge of a triangle, stored at its end of lower number.
struct TriangleEdge
{
  PointId High;
  bool IsForward; // The triangle goes from the lower end to High.
};

using TriangleEdges = ItemLists<TriangleEdge, std::uint32_t>;
using Ends = ItemLists<PointId, std::uint32_t>;

TriangleEdges FindEdges(const std::vector<TSurf::Triangle>& triangles, std::size_t numberOfVertices)
{
  TriangleEdges sides(std::int64_t(numberOfVertices),
    [&triangles](auto&& add)
    {
      for (const TSurf::Triangle& triangle : triangles)
      {
        for (std::size_t n = 0; n < 3; ++n)
        {
          const PointId from = triangle[n];
          const PointId to = triangle[(n + 1) % 3];
          add(std::min(from, to), TriangleEdge{ std::max(from, to), from < to });
        }
      }
    });
  for (std::int64_t low = 0; low < std::int64_t(numberOfVertices); ++low)
  {
    std::sort(
      sides.begin(low), sides.end(low), [](const TriangleEdge& a, const TriangleEdge& b) { return a.High < b.High; });
  }
  return sides;
}

/// Border edges belong to a single triangle, and are reversed.
Ends FindBorderEdges(const TriangleEdges& sides, std::size_t numberOfVertices)
{
  return Ends(std::int64_t(numberOfVertices),
    [&](auto&& add)
    {
      for (PointId low = 0; low < PointId(numberOfVertices); ++low)
      {
        const TriangleEdge* const end = sides.end(low);
        for (const TriangleEdge* side = sides.begin(low); side != end;)
        {
          const TriangleEdge* const next =
            std::find_if(side, end, [side](const TriangleEdge& s) { return s.High != side->High; });
          if (next - side == 1)
          {
            add(side->IsForward ? side->High : low, side->IsForward ? low : side->High);
          }
          side = next;
        }
      }
    });
}
}

//----------------------------------------------------------------------------------------------------------------------
PartMesh MakePartMesh(const TSurf& surface)
{
  std::size_t numberOfParts = 0;
  const TriangleLists triangles = SortByPart(surface, numberOfParts);
  PartLister lister(surface);
  for (std::int64_t part = 0; part < std::int64_t(numberOfParts); ++part)
  {
    lister.Add(triangles.begin(part), triangles.end(part));
  }
  return std::move(lister.Mesh);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<PointId, 2>> FindBorders(
  const std::vector<TSurf::Triangle>& triangles, std::size_t numberOfVertices)
{
  const Ends edges = FindBorderEdges(FindEdges(triangles, numberOfVertices), numberOfVertices);
  std::vector<const PointId*> next(numberOfVertices); // first edge from each vertex that is in no loop yet
  for (std::size_t vertex = 0; vertex < numberOfVertices; ++vertex)
  {
    next[vertex] = edges.begin(std::int64_t(vertex));
  }
  const auto hasEdge = [&](PointId vertex) { return next[std::size_t(vertex)] != edges.end(vertex); };
  std::vector<std::array<PointId, 2>> borders;
  for (PointId first = 0; first < PointId(numberOfVertices); ++first)
  {
    while (hasEdge(first))
    {
      borders.push_back({ first, *next[std::size_t(first)] });
      for (PointId vertex = first; hasEdge(vertex);)
      {
        vertex = *next[std::size_t(vertex)]++;
        if (vertex == first)
        {
          break;
        }
      }
    }
  }
  return borders;
}
}
