// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ModelTopology.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/PlaceText.h"
#include "Common/Text/TextPrinter.h"

#include <algorithm>
#include <map>

namespace SeismicHorizons
{
namespace
{
/// Of one triangle, from its corner Half % 3 on.
struct HalfEdge
{
  std::array<PointId, 2> Ends; // ascending
  std::size_t Half; // 3 * triangle + corner

  friend bool operator<(const HalfEdge& a, const HalfEdge& b)
  {
    return a.Ends != b.Ends ? a.Ends < b.Ends : a.Half < b.Half;
  }
};

struct TopologyEdge
{
  std::array<PointId, 2> Ends;
  std::vector<std::size_t> Faces; // ascending
  std::vector<std::size_t> Halves;
  bool IsUsed = false;
};

std::size_t NextHalf(std::size_t half)
{
  return half % 3 == 2 ? half - 2 : half + 1;
}

void CheckModelTriangles(const ClosedModel& model)
{
  std::vector<char> areThere(model.Bodies.size());
  for (std::size_t point = 0; point < model.Points.size(); ++point)
  {
    RequireFinitePoint(model.Points[point], std::int64_t(point));
  }
  for (std::size_t n = 0; n < model.Triangles.size(); ++n)
  {
    const ClosedModel::Triangle& triangle = model.Triangles[n];
    for (const PointId point : triangle.Corners)
    {
      if (point < 0 || std::size_t(point) >= model.Points.size() ||
        std::count(triangle.Corners.begin(), triangle.Corners.end(), point) > 1)
      {
        throw InputError("triangle " + std::to_string(n) + " with point id " + std::to_string(point) +
          ", expected three different ones from 0 to " + std::to_string(std::int64_t(model.Points.size()) - 1));
      }
    }
    for (const int body : triangle.Bodies)
    {
      if (body < -1 || body >= int(model.Bodies.size()))
      {
        throw InputError("body " + std::to_string(body) + " at triangle " + std::to_string(n) + ", expected -1 to " +
          std::to_string(std::int64_t(model.Bodies.size()) - 1));
      }
      if (body >= 0)
      {
        areThere[std::size_t(body)] = 1;
      }
    }
    constexpr int fault = 1;
    if (triangle.Bodies[0] == triangle.Bodies[1] &&
      (triangle.Bodies[0] < 0 || triangle.Surface >= model.Surfaces.size() ||
        model.Surfaces[triangle.Surface].Type != fault))
    {
      throw InputError("body " + std::to_string(triangle.Bodies[0]) + " on both sides of triangle " +
        std::to_string(n) + ", expected two bodies but at faults that die out");
    }
  }
  const auto missing = std::find(areThere.begin(), areThere.end(), 0);
  if (missing != areThere.end())
  {
    throw InputError(
      "body " + std::to_string(missing - areThere.begin()) + " without triangles, expected surfaces around each body");
  }
}

class TopologyFinder
{
public:
  explicit TopologyFinder(const ClosedModel& model)
    : Model(model)
  {
  }

  ModelTopology Run(const Monitor& monitor)
  {
    CheckModelTriangles(this->Model);
    monitor.Progress(0.1);
    this->FindHalves();
    monitor.Progress(0.4);
    this->FindFaces();
    monitor.Progress(0.7);
    this->FindLineEdges();
    for (const auto& [point, edges] : this->EdgesAt)
    {
      if (this->IsCorner(edges))
      {
        this->Result.Corners.push_back(point);
        this->FollowLines(point, edges);
      }
    }
    for (std::size_t n = 0; n < this->Edges.size(); ++n)
    {
      this->FollowRing(n);
    }
    monitor.Progress(1.0);
    return std::move(this->Result);
  }

private:
  /// Calls work(first, end) for the halves of each edge.
  template <typename Work>
  void ForEachEdge(Work&& work) const
  {
    for (std::size_t first = 0, end = 0; first < this->Halves.size(); first = end)
    {
      for (end = first + 1; end < this->Halves.size() && this->Halves[end].Ends == this->Halves[first].Ends;)
      {
        ++end;
      }
      work(first, end);
    }
  }

  const ClosedModel::Triangle& TriangleAt(std::size_t half) const
  {
    return this->Model.Triangles[this->Halves[half].Half / 3];
  }

  PointId StartOf(std::size_t half) const { return this->Result.Triangles[half / 3][half % 3]; }

  void FindHalves()
  {
    for (std::size_t n = 0; n < this->Model.Triangles.size(); ++n)
    {
      const TSurf::Triangle& corners = this->Model.Triangles[n].Corners;
      this->Result.Triangles.push_back(corners);
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        const auto [least, greatest] = std::minmax({ corners[corner], corners[(corner + 1) % 3] });
        this->Halves.push_back({ { least, greatest }, 3 * n + corner });
      }
    }
    std::sort(this->Halves.begin(), this->Halves.end());
    this->ForEachEdge([this](std::size_t first, std::size_t end) { this->CheckEdge(first, end); });
  }

  /// Around a closed body, triangles have each edge as often in one direction as in the other.
  void CheckEdge(std::size_t first, std::size_t end) const
  {
    std::map<int, int> sums; // by body
    for (std::size_t n = first; n < end; ++n)
    {
      const int way = this->StartOf(this->Halves[n].Half) == this->Halves[n].Ends[0] ? 1 : -1;
      sums[this->TriangleAt(n).Bodies[0]] += way;
      sums[this->TriangleAt(n).Bodies[1]] -= way;
    }
    const auto open = std::find_if(sums.rbegin(), sums.rend(), [](const auto& sum) { return sum.second != 0; });
    if (open != sums.rend())
    {
      const std::array<double, 3>& at = this->Model.Points[std::size_t(this->Halves[first].Ends[0])];
      throw InputError("body " + std::to_string(open->first) + " open at an edge with number of triangles " +
        std::to_string(end - first) + " at " + PlaceText(Eigen::Vector3d(at[0], at[1], at[2])) +
        ", expected closed bodies");
    }
  }

  bool IsLine(std::size_t first, std::size_t end) const
  {
    return end - first != 2 || this->TriangleAt(first).Surface != this->TriangleAt(first + 1).Surface;
  }

  void FindFaces()
  {
    const std::vector<ClosedModel::Triangle>& triangles = this->Model.Triangles;
    DisjointSets sets(triangles.size());
    this->ForEachEdge(
      [&](std::size_t first, std::size_t end)
      {
        if (!this->IsLine(first, end))
        {
          sets.Join(std::int32_t(this->Halves[first].Half / 3), std::int32_t(this->Halves[first + 1].Half / 3));
        }
      });
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> faces; // by surface and first triangle
    for (std::size_t n = 0; n < triangles.size(); ++n)
    {
      faces[{ triangles[n].Surface, std::size_t(sets.Find(std::int32_t(n))) }].push_back(n);
    }
    this->FaceOf.resize(triangles.size());
    for (auto& [place, own] : faces)
    {
      const std::array<int, 2>& bodies = triangles[own.front()].Bodies;
      for (const std::size_t n : own)
      {
        this->FaceOf[n] = this->Result.Faces.size();
        if (triangles[n].Bodies != bodies)
        {
          std::swap(this->Result.Triangles[n][1], this->Result.Triangles[n][2]);
        }
      }
      this->Result.Faces.push_back({ place.first, bodies, std::move(own) });
    }
    for (HalfEdge& edge : this->Halves) // Of a turned triangle the edges are in the other order.
    {
      const std::size_t n = edge.Half / 3;
      edge.Half = this->Result.Triangles[n] == triangles[n].Corners ? edge.Half : 6 * n + 2 - edge.Half;
    }
  }

  void FindLineEdges()
  {
    const std::size_t size = this->Halves.size();
    DisjointSets sets(size);
    this->Result.AreLines.resize(size);
    this->ForEachEdge(
      [&](std::size_t first, std::size_t end)
      {
        if (!this->IsLine(first, end)) // Neighbours in a face have the edge in opposite directions.
        {
          const std::size_t a = this->Halves[first].Half;
          const std::size_t b = this->Halves[first + 1].Half;
          sets.Join(std::int32_t(a), std::int32_t(NextHalf(b)));
          sets.Join(std::int32_t(b), std::int32_t(NextHalf(a)));
          return;
        }
        TopologyEdge edge = { this->Halves[first].Ends, {}, {} };
        for (std::size_t n = first; n < end; ++n)
        {
          edge.Halves.push_back(this->Halves[n].Half);
          edge.Faces.push_back(this->FaceOf[this->Halves[n].Half / 3]);
          this->Result.AreLines[this->Halves[n].Half] = 1;
        }
        std::sort(edge.Faces.begin(), edge.Faces.end());
        for (const PointId point : edge.Ends)
        {
          this->EdgesAt[point].push_back(this->Edges.size());
        }
        this->Edges.push_back(std::move(edge));
      });
    for (std::size_t n = 0; n < size; ++n)
    {
      this->Result.Vertices.push_back(sets.Find(std::int32_t(n)));
    }
  }

  bool IsCorner(const std::vector<std::size_t>& edges) const
  {
    return edges.size() != 2 || this->Edges[edges[0]].Faces != this->Edges[edges[1]].Faces;
  }

  void FollowLines(PointId corner, const std::vector<std::size_t>& edges)
  {
    for (const std::size_t edge : edges)
    {
      if (!this->Edges[edge].IsUsed)
      {
        const std::vector<PointId> points = this->Follow(corner, edge);
        this->AddLine(points.begin(), points.end());
      }
    }
  }

  void FollowRing(std::size_t edge)
  {
    if (this->Edges[edge].IsUsed)
    {
      return;
    }
    const std::vector<PointId> points = this->Follow(this->Edges[edge].Ends[0], edge);
    const auto count = std::ptrdiff_t(points.size()) - 1;
    for (std::ptrdiff_t part = 0; part < 3; ++part)
    {
      const auto first = points.begin() + part * count / 3;
      this->Result.Corners.push_back(*first);
      this->AddLine(first, points.begin() + (part + 1) * count / 3 + 1);
    }
  }

  /// To the next corner, or round to the first point.
  std::vector<PointId> Follow(PointId from, std::size_t edge)
  {
    std::vector<PointId> points = { from };
    while (true)
    {
      TopologyEdge& next = this->Edges[edge];
      next.IsUsed = true;
      points.push_back(next.Ends[next.Ends[0] == points.back() ? 1 : 0]);
      const std::vector<std::size_t>& edges = this->EdgesAt.at(points.back());
      if (points.back() == from || this->IsCorner(edges))
      {
        return points;
      }
      edge = edges[edges[0] == edge ? 1 : 0];
    }
  }

  template <typename Place>
  void AddLine(Place first, Place end)
  {
    ModelTopology::Line line = { { first, end }, {} };
    for (const std::size_t edge : this->EdgesAt.at(line.Points[0]))
    {
      const std::array<PointId, 2>& ends = this->Edges[edge].Ends;
      if (ends[0] == line.Points[1] || ends[1] == line.Points[1])
      {
        for (const std::size_t half : this->Edges[edge].Halves)
        {
          line.Faces.emplace_back(this->FaceOf[half / 3], this->StartOf(half) == line.Points[0]);
        }
      }
    }
    this->Result.Lines.push_back(std::move(line));
  }

  const ClosedModel& Model;
  std::vector<HalfEdge> Halves; // by edge
  std::vector<std::size_t> FaceOf; // by triangle
  std::vector<TopologyEdge> Edges;
  std::map<PointId, std::vector<std::size_t>> EdgesAt;
  ModelTopology Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
ModelTopology FindTopology(const ClosedModel& model, const Monitor& monitor)
{
  return TopologyFinder(model).Run(monitor);
}
}
