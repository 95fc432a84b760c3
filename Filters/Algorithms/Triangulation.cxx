// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "AdvancingFront.h"
#include "Errors.h"
#include "FullBlocks.h"
#include "PatchList.h"

#include <algorithm>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// The points of a patch that a search has to know: those which full blocks do not cover. What is left to mesh is
/// bounded by the boundary and by sides of full blocks, and these end in such points.
struct LoosePoints
{
  LoosePoints(const Patch& patch, const FullBlocks& blocks)
    : Numbers(patch.Points.size(), NoPoint)
  {
    for (std::size_t point = 0; point < patch.Points.size(); ++point)
    {
      if (!blocks.Covers(patch.Places[point]))
      {
        this->Numbers[point] = PointId(this->Places.size());
        this->Places.push_back(patch.Places[point]);
        this->Names.push_back(patch.Points[point]);
      }
    }
  }

  std::vector<PointId> Numbers; // by the number in the patch
  std::vector<PlanePoint> Places;
  std::vector<PointId> Names; // their numbers in the horizon
};

/// Meshes a patch from its boundary inwards, around its full blocks.
class PatchTriangulator
{
public:
  PatchTriangulator(const Patch& patch, const TriangulationOptions& options, Triangulation& result)
    : Input(patch)
    , Options(options)
    , Blocks(options.MostTriangles > 0 ? FullBlocks() : FullBlocks(patch.Places, patch.Boundary))
    , Loose(patch, this->Blocks)
    , Points(this->Loose.Places, patch.Boundary.Renumbered(this->Loose.Numbers), this->Loose.Names)
    , Search(this->Points, options.Strategy)
    , Front(this->Loose.Places.size())
    , Used(this->Loose.Places.size(), false)
    , Result(result)
    , Triangles(result.Triangles)
  {
    this->AddBlocks();
    this->AddBoundary();
  }

  void Run(const Monitor& monitor)
  {
    monitor.Progress(0.5);
    // By Euler's formula a plane mesh has less than two triangles per point.
    const std::size_t most = 2 * this->Used.size();
    const std::size_t wanted = this->Options.MostTriangles > 0 ? this->Options.MostTriangles : most + 1;
    std::size_t made = 0;
    for (Hop edge; made < wanted && this->Front.TakeNewest(edge); ++made)
    {
      if (made % 4096 == 0)
      {
        monitor.Progress(std::min(1.0, 0.5 + 0.5 * double(made) / double(most)));
      }
      const PointId third = this->FindThird(edge, made + 1 == this->Options.MostTriangles);
      if (third == NoPoint || made >= most)
      {
        throw InputError("no surface to the left of the edge from point " + this->Name(edge.From) + " to point " +
          this->Name(edge.To) + ", expected closed boundary loops with the surface to their right");
      }
      this->AddTriangle(edge.From, edge.To, third);
    }
    if (this->Options.MostTriangles == 0)
    {
      this->CheckAllUsed();
      this->CountEdges();
    }
  }

private:
  std::string Name(PointId point) const { return std::to_string(this->Points.NameOf(point)); }

  /// The number in the search of a point of the patch that is loose.
  PointId Number(PointId point) const { return this->Points.NumberOf(this->Loose.Numbers[std::size_t(point)]); }

  PointId FindThird(const Hop& edge, bool traced)
  {
    if (!traced)
    {
      return this->Search.Find(edge.From, edge.To);
    }
    std::vector<WalkedVoxel> walk;
    const PointId third = this->Search.Find(edge.From, edge.To, &walk);
    const CellGrid& voxels = this->Points.Voxels();
    const auto before = [this](const PlanePoint& place)
    {
      const Frame& frame = this->Input.PlacesFrame;
      return PlanePoint{ (place.X << frame.Shift) + frame.Origin.X, (place.Y << frame.Shift) + frame.Origin.Y };
    };
    this->Result.Walk.clear();
    for (const WalkedVoxel& voxel : walk)
    {
      this->Result.Walk.push_back({ before(voxels.CornerOf(voxel.X, voxel.Y)),
        before(voxels.CornerOf(voxel.X + 1, voxel.Y + 1)), voxel.Dilatation });
    }
    return third;
  }

  void AddBlocks()
  {
    const Patch& patch = this->Input;
    const std::size_t before = this->Triangles.size();
    // By Euler's formula loose points are corners of less than two triangles each.
    this->Triangles.reserve(before + 3 * this->Blocks.NumberOfTriangles() + 6 * this->Used.size());
    this->Triangles.resize(before + 3 * this->Blocks.NumberOfTriangles());
    PointId* corner = this->Triangles.data() + before;
    this->Blocks.Visit(
      [&](PointId a, PointId b, PointId c)
      {
        *corner++ = patch.Points[std::size_t(a)];
        *corner++ = patch.Points[std::size_t(b)];
        *corner++ = patch.Points[std::size_t(c)];
      },
      [&](PointId from, PointId to) { this->AddSide(this->Number(from), this->Number(to)); });
    for (std::size_t point = 0; point < patch.Points.size(); ++point)
    {
      if (this->Loose.Numbers[point] != NoPoint && this->Blocks.Touches(patch.Places[point]))
      {
        this->Used[std::size_t(this->Number(PointId(point)))] = true;
      }
    }
  }

  /// The surface lies to the right of each boundary hop, so its reverse waits for a triangle. Of a hop that the
  /// boundary walks in both directions neither side has surface.
  void AddBoundary()
  {
    const Loops& boundary = this->Input.Boundary;
    boundary.ForEachHop([this](PointId from, PointId to) { this->AddSide(this->Number(from), this->Number(to)); });
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      std::for_each(boundary.begin(loop), boundary.end(loop),
        [this](PointId point) { this->Used[std::size_t(this->Number(point))] = true; });
    }
  }

  void AddTriangle(PointId a, PointId b, PointId c)
  {
    for (const PointId point : { a, b, c })
    {
      this->Used[std::size_t(point)] = true;
      this->Triangles.push_back(this->Points.NameOf(point));
    }
    this->AddSide(b, c);
    this->AddSide(c, a);
  }

  /// A side of something to its left: either it waited for that, or its reverse waits for something now.
  void AddSide(PointId from, PointId to)
  {
    if (!this->Front.Remove(from, to))
    {
      this->Front.Add(to, from);
    }
  }

  void CheckAllUsed() const
  {
    const auto unused = std::find(this->Used.begin(), this->Used.end(), false);
    if (unused != this->Used.end())
    {
      throw InputError("point " + this->Name(PointId(unused - this->Used.begin())) +
        " lies outside the boundary of its patch, expected all points inside");
    }
  }

  /// Which hops have surface on one side, and which of them are not Delaunay. Two points no further apart than the
  /// diagonal of a sub-voxel, which on whole columns is that of a block, have no point in the circle around them.
  void CountEdges()
  {
    std::vector<Hop> longHops;
    AdvancingFront walked(this->Input.Points.size());
    this->Input.Boundary.ForEachHop(
      [&](PointId from, PointId to)
      {
        if (!walked.Remove(to, from))
        {
          walked.Add(from, to);
        }
      });
    for (Hop hop; walked.TakeNewest(hop); ++this->Result.BoundaryEdges)
    {
      const PlanePoint& from = this->Input.Places[std::size_t(hop.From)];
      const PlanePoint& to = this->Input.Places[std::size_t(hop.To)];
      if (std::max(std::abs(from.X - to.X), std::abs(from.Y - to.Y)) > 1)
      {
        longHops.push_back({ hop.To, hop.From });
      }
    }
    this->CountNonDelaunay(longHops);
  }

  /// All points may be in the way here, also those which full blocks cover.
  void CountNonDelaunay(const std::vector<Hop>& hops)
  {
    if (hops.empty())
    {
      return;
    }
    const auto isNot = [&hops](const ThirdPointSearch& search, auto&& number)
    {
      return std::size_t(std::count_if(hops.begin(), hops.end(),
        [&](const Hop& hop) { return !search.IsDelaunay(number(hop.From), number(hop.To)); }));
    };
    if (this->Blocks.NumberOfTriangles() == 0)
    {
      this->Result.NonDelaunayEdges += isNot(this->Search, [this](PointId point) { return this->Number(point); });
      return;
    }
    const SearchGrid all(this->Input.Places, Loops(), this->Input.Points);
    this->Result.NonDelaunayEdges +=
      isNot(ThirdPointSearch(all, this->Options.Strategy), [&all](PointId point) { return all.NumberOf(point); });
  }

  const Patch& Input;
  const TriangulationOptions Options;
  const FullBlocks Blocks;
  const LoosePoints Loose;
  const SearchGrid Points;
  const ThirdPointSearch Search;
  AdvancingFront Front;
  std::vector<bool> Used; // loose points, by the numbers of the search, as in the front
  Triangulation& Result;
  std::vector<PointId>& Triangles;
};
}

//----------------------------------------------------------------------------------------------------------------------
Triangulation Triangulate(const BoundedHorizon& horizon, const TriangulationOptions& options, const Monitor& monitor)
{
  Triangulation result;
  PatchList patches(horizon);
  std::size_t pointsDone = 0;
  for (std::int64_t number = 0; number < patches.Size(); ++number)
  {
    const Patch patch = patches.Get(number);
    if (patch.Points.empty())
    {
      continue;
    }
    const double first = double(pointsDone) / double(horizon.Plane.size());
    pointsDone += patch.Points.size();
    const double last = double(pointsDone) / double(horizon.Plane.size());
    PatchTriangulator(patch, options, result).Run(monitor.Step(first, last));
  }
  return result;
}
}
