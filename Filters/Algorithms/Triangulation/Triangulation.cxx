// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "AdvancingFront.h"
#include "Common/Errors.h"
#include "Common/FixedChunks.h"
#include "FullBlocks.h"
#include "PatchFront.h"
#include "PatchList.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct Sum
{
  std::size_t Value = 0;

  void Add(const Sum& other) { this->Value += other.Value; }
};

/// How many items fulfil a condition, by several threads.
template <typename Item, typename Condition>
std::size_t CountIf(const std::vector<Item>& items, Condition&& condition)
{
  constexpr std::int64_t grain = 1024;
  return AddUpChunks<Sum>(std::int64_t(items.size()), grain, Monitor(),
    [&](Sum& sum, std::int64_t first, std::int64_t last)
    { sum.Value += std::size_t(std::count_if(items.begin() + first, items.begin() + last, condition)); })
    .Value;
}

/// Meshes a patch from its boundary inwards, and from its full blocks outwards.
class PatchTriangulator
{
public:
  PatchTriangulator(const Patch& patch, const TriangulationOptions& options, Triangulation& result)
    : Input(patch)
    , Options(options)
    , Points(patch.Places, patch.Boundary, patch.Points)
    , Search(this->Points, options.Strategy)
    , Front(this->Points, this->Search, options.MostTriangles > 0 ? 1 : PatchFront::FindStrips(this->Points))
    , Result(result)
  {
    // The surface lies to the right of each boundary edge, so its reverse waits for a triangle. An edge that the
    // boundary has in both directions has surface on neither side.
    patch.Boundary.ForEachEdge([this](PointId from, PointId to) { this->AddSide(from, to); });
    for (const Edge& side : patch.BlockSides)
    {
      this->AddSide(side.From, side.To);
    }
    for (std::size_t loop = 0; loop < patch.Boundary.Size(); ++loop)
    {
      // A loop of one point has no edge.
      this->Front.Use(this->Points.NumberOf(*patch.Boundary.begin(loop)));
    }
  }

  void Run(const Monitor& monitor)
  {
    const std::size_t most = this->Options.MostTriangles;
    this->Front.Grow(most > 0 ? most : this->Front.MostTriangles() + 1, monitor);
    if (most == 0)
    {
      this->CheckAllUsed();
    }
    else if (this->Front.NumberOfTriangles() == most)
    {
      this->TraceLast();
    }
    this->Front.MoveTriangles(this->Result.Triangles);
  }

  /// How many edges, by the numbers of the patch, are not Delaunay among its points.
  std::size_t CountNonDelaunay(const std::vector<Edge>& edges) const
  {
    return CountIf(edges,
      [this](const Edge& edge)
      { return !this->Search.IsDelaunay(this->Points.NumberOf(edge.From), this->Points.NumberOf(edge.To)); });
  }

private:
  void AddSide(PointId from, PointId to)
  {
    this->Front.AddSide(this->Points.NumberOf(from), this->Points.NumberOf(to));
  }

  /// Searches once more for the third point of the last edge.
  void TraceLast()
  {
    const Edge edge = this->Front.LastEdge();
    std::vector<WalkedVoxel> walk;
    this->Search.Find(edge.From, edge.To, 0.0f, &walk);
    const CellGrid& voxels = this->Points.Voxels();
    const PlaneFrame& frame = this->Input.Frame;
    this->Result.Walk.clear();
    for (const WalkedVoxel& voxel : walk)
    {
      this->Result.Walk.push_back({ frame.Outward(voxels.CornerOf(voxel.X, voxel.Y)),
        frame.Outward(voxels.CornerOf(voxel.X + 1, voxel.Y + 1)), voxel.Dilatation });
    }
  }

  void CheckAllUsed() const
  {
    for (PointId point = 0; point < this->Points.NumberOfPoints(); ++point)
    {
      if (!this->Front.IsUsed(point))
      {
        throw InputError("point " + std::to_string(this->Points.NameOf(point)) +
          " lies outside the boundary of its patch, expected all points inside");
      }
    }
  }

  const Patch& Input;
  const TriangulationOptions Options;
  const SearchGrid Points;
  const ThirdPointSearch Search;
  PatchFront Front;
  Triangulation& Result;
};

/// The boundary edges of a patch that have surface on one side, turned so that it is to their left.
std::vector<Edge> FindBoundaryEdges(const Patch& patch)
{
  AdvancingFront walked(0, PointId(patch.Points.size()));
  patch.Boundary.ForEachEdge([&walked](PointId from, PointId to) { walked.AddSide({ from, to }); });
  std::vector<Edge> edges;
  for (FrontEdge edge; walked.TakeNewest(edge);)
  {
    edges.push_back({ edge.From, edge.To });
  }
  return edges;
}

/// Those that may not be Delaunay: two places that are neighbours, if only across a corner, have no other place in the
/// smallest circle around them.
std::vector<Edge> FindLong(const std::vector<Edge>& edges, const std::vector<PlanePoint>& places)
{
  std::vector<Edge> result;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(result),
    [&places](const Edge& edge)
    {
      const PlanePoint& from = places[std::size_t(edge.From)];
      const PlanePoint& to = places[std::size_t(edge.To)];
      return std::max(std::abs(from.X - to.X), std::abs(from.Y - to.Y)) > 1;
    });
  return result;
}

/// Meshes the patches of a horizon one after the other.
class HorizonTriangulator
{
public:
  HorizonTriangulator(const BoundedHorizon& horizon, const TriangulationOptions& options)
    : Horizon(horizon)
    , Options(options)
    , Frame(horizon.Plane)
    , Blocks(options.MostTriangles > 0 ? FullBlocks() : FullBlocks(horizon, this->Frame))
    , Patches(horizon, this->Frame, this->Blocks)
  {
  }

  Triangulation Run(const Monitor& monitor)
  {
    monitor.Progress(0.3);
    // By Euler's formula loose points are corners of less than two triangles each.
    this->Result.Triangles.reserve(3 * this->Blocks.NumberOfTriangles() + 6 * this->Patches.NumberOfPoints());
    this->Result.Triangles.resize(3 * this->Blocks.NumberOfTriangles());
    this->Blocks.WriteTriangles(this->Result.Triangles.data());
    std::size_t done = 0;
    for (std::int64_t number = 0; number < this->Patches.Size(); ++number)
    {
      const Patch patch = this->Patches.Get(number);
      if (!patch.Points.empty())
      {
        const double all = double(this->Patches.NumberOfPoints());
        const double before = 0.5 + 0.5 * double(done) / all;
        done += patch.Points.size();
        this->RunPatch(number, patch, monitor.Step(before, 0.5 + 0.5 * double(done) / all));
      }
    }
    this->CountDoubtful();
    return std::move(this->Result);
  }

private:
  void RunPatch(std::int64_t number, const Patch& patch, const Monitor& monitor)
  {
    PatchTriangulator triangulator(patch, this->Options, this->Result);
    triangulator.Run(monitor);
    if (this->Options.MostTriangles > 0)
    {
      return;
    }
    const std::vector<Edge> edges = FindBoundaryEdges(patch);
    this->Result.BoundaryEdges += edges.size();
    const std::vector<Edge> longEdges = FindLong(edges, patch.Places);
    if (this->Blocks.NumberOfTriangles() == 0)
    {
      this->Result.NonDelaunayEdges += triangulator.CountNonDelaunay(longEdges);
      return;
    }
    for (const Edge& edge : longEdges)
    {
      this->Doubtful.push_back({ number, patch.Points[std::size_t(edge.From)], patch.Points[std::size_t(edge.To)] });
    }
  }

  /// Counts those of the doubtful edges that are not Delaunay among all points: also those that full blocks cover may
  /// be in their circles.
  void CountDoubtful()
  {
    if (this->Doubtful.empty())
    {
      return;
    }
    PatchList whole(this->Horizon, this->Frame, FullBlocks());
    for (auto first = this->Doubtful.begin(); first != this->Doubtful.end();)
    {
      const auto last = std::find_if(
        first, this->Doubtful.end(), [first](const DoubtfulEdge& edge) { return edge.Patch != first->Patch; });
      const Patch patch = whole.Get(first->Patch);
      const SearchGrid points(patch.Places, Loops(), patch.Points);
      const ThirdPointSearch search(points, this->Options.Strategy);
      const auto number = [&](PointId point) { return points.NumberOf(whole.NumberInPatch(point)); };
      this->Result.NonDelaunayEdges += CountIf(std::vector<DoubtfulEdge>(first, last),
        [&](const DoubtfulEdge& edge) { return !search.IsDelaunay(number(edge.From), number(edge.To)); });
      first = last;
    }
  }

  /// A boundary edge that may not be Delaunay, by the numbers of the horizon.
  struct DoubtfulEdge
  {
    std::int64_t Patch;
    PointId From;
    PointId To;
  };

  const BoundedHorizon& Horizon;
  const TriangulationOptions Options;
  const PlaneFrame Frame;
  const FullBlocks Blocks;
  PatchList Patches;
  std::vector<DoubtfulEdge> Doubtful; // patch by patch
  Triangulation Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
Triangulation Triangulate(const BoundedHorizon& horizon, const TriangulationOptions& options, const Monitor& monitor)
{
  return horizon.Plane.empty() ? Triangulation() : HorizonTriangulator(horizon, options).Run(monitor);
}
}
