// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshGroups.h"

#include "Common/Base/HeapArray.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "GroupMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct Pass
{
  std::vector<GroupStep> Steps;
  int MostRounds;
  double Shift; // of the groups, as a fraction
};

const std::vector<Pass>& Passes()
{
  constexpr GroupStep c = GroupStep::Collapse;
  constexpr GroupStep m = GroupStep::Move;
  constexpr GroupStep f = GroupStep::Flip;
  static const std::vector<Pass> passes = { { { c }, 1, 0.0 }, { { c, f, m, c }, 2, 0.5 }, { { c, f, m, c }, 2, 0.25 },
    { { GroupStep::FitSquares }, 1, 0.75 } };
  return passes;
}

// Large enough that few edges lie between groups, small enough for many threads.
constexpr double TrianglesOfGroup = 1500.0;
// This number of columns takes as long as a triangle.
constexpr double ColumnsPerTriangle = 32.0;

class MeshGroups
{
public:
  MeshGroups(HeightMesh& mesh, const DecimationOptions& options, const ColumnRule& rule)
    : Mesh(mesh)
    , Rule(rule)
    , Vertices(std::size_t(mesh.EndOfVertices()))
  {
    this->Options.Error = options.MaximumError;
    this->Options.CrossingError = options.MaximumCrossingError();
    this->Options.SmallestAngle = options.SmallestAngle;
    this->Options.FitHeights = options.FitHeights;
    this->TakeMesh();
  }

  void Run(const Monitor& monitor)
  {
    const auto passes = double(Passes().size());
    for (std::size_t n = 0; n < Passes().size(); ++n)
    {
      this->RunPass(Passes()[n], monitor.Step(double(n) / passes, double(n + 1) / passes));
    }
    this->GiveBack();
  }

private:
  using Corners = std::array<VertexId, 3>;
  using Triangles = std::vector<Corners>;

  /// Vertices without a triangle have no group and stay.
  void TakeMesh()
  {
    const PlaneMesh& plane = this->Mesh.Triangles();
    for (VertexId vertex = 0; vertex < this->Mesh.EndOfVertices(); ++vertex)
    {
      this->Places.push_back(this->Mesh.Raised(vertex).Column);
      this->Vertices[vertex].IsFixed = this->Mesh.IsFixed(vertex);
      this->Vertices[vertex].IsGone = this->Mesh.IsRemoved(vertex);
    }
    this->Heights.resize(this->Mesh.NumberOfHorizons());
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      for (VertexId vertex = 0; vertex < this->Mesh.EndOfVertices(); ++vertex)
      {
        this->Heights[horizon].push_back(this->Mesh.Height(horizon, vertex));
      }
    }
    this->Patches.resize(this->Mesh.NumberOfPatches());
    for (TriangleId triangle = 0; triangle < plane.Size(); ++triangle)
    {
      this->Patches[this->Mesh.PatchOf(plane.Corner(triangle, 0))].push_back(plane.Corners(triangle));
      for (int edge = 0; edge < 3; ++edge)
      {
        if (plane.IsKeptEdge(triangle, edge)) // its ends may lie on a longer kept line
        {
          this->Vertices[plane.Corner(triangle, edge)].IsFixed = true;
          this->Vertices[plane.Corner(triangle, NextCorner(edge))].IsFixed = true;
        }
      }
    }
  }

  void RunPass(const Pass& pass, const Monitor& monitor)
  {
    std::vector<Triangles> groups;
    std::vector<std::size_t> patchOf;
    for (std::size_t patch = 0; patch < this->Patches.size(); ++patch)
    {
      std::vector<Triangles> own = this->MakeGroups(this->Patches[patch], pass.Shift);
      std::move(own.begin(), own.end(), std::back_inserter(groups));
      patchOf.resize(groups.size(), patch);
      this->Patches[patch].clear();
    }
    std::vector<std::vector<VertexId>> between(groups.size());
    ParallelFor(std::int64_t(groups.size()), 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          this->Improve(groups[std::size_t(n)], pass, between[std::size_t(n)]);
        }
      });
    for (std::size_t n = 0; n < groups.size(); ++n)
    {
      Triangles& patch = this->Patches[patchOf[n]];
      patch.insert(patch.end(), groups[n].begin(), groups[n].end());
    }
    for (const std::vector<VertexId>& vertices : between)
    {
      std::for_each(
        vertices.begin(), vertices.end(), [this](VertexId vertex) { this->Vertices[vertex].Marks = TryAll; });
    }
  }

  // ---- Groups ------------------------------------------------------------------------------------------------------
  /// Strips of equal work along x, which are cut along y.
  std::vector<Triangles> MakeGroups(const Triangles& triangles, double shift) const
  {
    PlaneBox box;
    double work = 0.0;
    for (const Corners& corners : triangles)
    {
      box.Add(this->Places[corners[0]]);
      work += this->WorkOf(corners);
    }
    const double number = work / TrianglesOfGroup;
    if (number < 1.5)
    {
      return triangles.empty() ? std::vector<Triangles>() : std::vector<Triangles>{ triangles };
    }
    const double width = double(box.Greatest.X) - box.Least.X + 1.0;
    const double height = double(box.Greatest.Y) - box.Least.Y + 1.0;
    const double strips = std::max(1.0, std::round(std::sqrt(number * width / height)));
    std::vector<Triangles> groups;
    for (const Triangles& strip : this->Cut(triangles, strips, shift, [](const PlanePoint& place) { return place.X; }))
    {
      std::vector<Triangles> some = this->Cut(
        strip, std::max(1.0, std::round(number / strips)), shift, [](const PlanePoint& place) { return place.Y; });
      std::move(some.begin(), some.end(), std::back_inserter(groups));
    }
    return groups;
  }

  double WorkOf(const Corners& corners) const
  {
    const double columns =
      0.5 * double(SignedArea(this->Places[corners[0]], this->Places[corners[1]], this->Places[corners[2]]));
    return 1.0 + columns / ColumnsPerTriangle;
  }

  template <typename Coordinate>
  std::vector<Triangles> Cut(const Triangles& triangles, double parts, double shift, Coordinate&& coordinate) const
  {
    std::vector<std::pair<std::int64_t, std::int32_t>> order;
    order.reserve(triangles.size());
    double work = 0.0;
    for (std::size_t n = 0; n < triangles.size(); ++n)
    {
      std::int64_t sum = 0;
      for (const VertexId corner : triangles[n])
      {
        sum += coordinate(this->Places[corner]);
      }
      order.emplace_back(sum, std::int32_t(n));
      work += this->WorkOf(triangles[n]);
    }
    std::sort(order.begin(), order.end());
    std::vector<Triangles> cut(std::size_t(parts) + 1);
    double before = 0.0;
    for (const auto& [sum, n] : order)
    {
      cut[std::size_t(std::min(before / work * parts + shift, parts))].push_back(triangles[std::size_t(n)]);
      before += this->WorkOf(triangles[std::size_t(n)]);
    }
    cut.erase(std::remove_if(cut.begin(), cut.end(), [](const Triangles& one) { return one.empty(); }), cut.end());
    return cut;
  }

  /// Vertices between groups are in several, and remain as they are; each of the others is in one alone.
  void Improve(Triangles& triangles, const Pass& pass, std::vector<VertexId>& between)
  {
    Group group;
    std::vector<VertexId> vertices;
    vertices.reserve(3 * triangles.size());
    std::for_each(triangles.begin(), triangles.end(),
      [&](const Corners& corners) { vertices.insert(vertices.end(), corners.begin(), corners.end()); });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto numberOf = [&](VertexId vertex)
    { return VertexId(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin()); };
    RawVector<VertexId> corners;
    corners.reserve(3 * triangles.size());
    for (const Corners& own : triangles)
    {
      std::for_each(own.begin(), own.end(), [&](VertexId vertex) { corners.push_back(numberOf(vertex)); });
    }
    this->Fill(group, vertices, corners);
    ImproveGroup(group, this->Options, pass.Steps, pass.MostRounds);
    this->Take(group, vertices, between);
    triangles.clear();
    for (TriangleId triangle = 0; triangle < group.Mesh.Size(); ++triangle)
    {
      const Corners& own = group.Mesh.Corners(triangle);
      triangles.push_back({ vertices[own[0]], vertices[own[1]], vertices[own[2]] });
    }
  }

  void Fill(Group& group, const std::vector<VertexId>& vertices, const RawVector<VertexId>& corners) const
  {
    PlaneBox box;
    std::for_each(vertices.begin(), vertices.end(), [&](VertexId vertex) { box.Add(this->Places[vertex]); });
    group.Box = box;
    std::vector<PlanePoint> places;
    for (const VertexId vertex : vertices)
    {
      const PlanePoint& place = this->Places[vertex];
      places.push_back({ place.X - box.Least.X, place.Y - box.Least.Y });
      group.Vertices.push_back(this->Vertices[vertex]);
    }
    group.Mesh = PlaneMesh(std::move(places), corners);
    for (TriangleId triangle = 0; triangle < group.Mesh.Size(); ++triangle)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const VertexId from = group.Mesh.Corner(triangle, edge);
        const VertexId to = group.Mesh.Corner(triangle, NextCorner(edge));
        if (this->Mesh.Triangles().IsKept(vertices[from], vertices[to]))
        {
          group.Mesh.Keep(from, to);
        }
      }
    }
    group.Cuts = this->Mesh.Cuts();
    group.Rule = this->Rule;
    group.Horizons.resize(this->Heights.size());
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      Group::Horizon& own = group.Horizons[horizon];
      own.Heights = Gather<std::vector<double>>(this->Heights[horizon], vertices);
      own.Raster = &this->Mesh.RasterAt(horizon, vertices.front());
    }
  }

  void Take(const Group& group, const std::vector<VertexId>& vertices, std::vector<VertexId>& between)
  {
    for (std::size_t n = 0; n < vertices.size(); ++n)
    {
      const VertexId vertex = vertices[n];
      if (group.Vertices[n].IsFixed)
      {
        between.push_back(vertex);
        continue;
      }
      for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
      {
        this->Heights[horizon][vertex] = group.Horizons[horizon].Heights[n];
      }
      const PlanePoint& place = group.Mesh.Place(VertexId(n));
      this->Places[vertex] = { place.X + group.Box.Least.X, place.Y + group.Box.Least.Y };
      this->Vertices[vertex] = group.Vertices[n];
    }
  }

  void GiveBack()
  {
    RawVector<VertexId> triangles;
    for (const Triangles& patch : this->Patches)
    {
      for (const Corners& corners : patch)
      {
        triangles.insert(triangles.end(), corners.begin(), corners.end());
      }
    }
    std::vector<PointId> sources(this->Vertices.size(), NoPoint);
    for (std::size_t vertex = 0; vertex < sources.size(); ++vertex)
    {
      const GroupVertex& own = this->Vertices[vertex];
      sources[vertex] = own.IsGone ? NoPoint : this->Mesh.RasterAt(0, VertexId(vertex)).PointAt(this->Places[vertex]);
    }
    this->Mesh.Replace(std::move(sources), this->Heights, triangles);
  }

  HeightMesh& Mesh;
  const ColumnRule& Rule;
  GroupOptions Options;
  std::vector<PlanePoint> Places;
  std::vector<GroupVertex> Vertices;
  std::vector<std::vector<double>> Heights; // by horizon, then by vertex
  std::vector<Triangles> Patches;
};
}

//----------------------------------------------------------------------------------------------------------------------
void ImproveInGroups(HeightMesh& mesh, const DecimationOptions& options, const ColumnRule& rule, const Monitor& monitor)
{
  MeshGroups(mesh, options, rule).Run(monitor);
}
}
