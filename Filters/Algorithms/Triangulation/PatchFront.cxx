// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. The voxels are cut into strips of rows.
// 2. Triangles that reach across the line between two strips make a wall; the walls part the rest, so that fronts can
//    grow in each strip without regard to the others. The wall on the middle line is made first, then in either half
//    the one on its middle line, and so on (Cignoni, Montani, Scopigno, "DeWall: A fast divide and conquer Delaunay
//    triangulation algorithm in E^d", 1998):
//
//     +-----------------+
//     |  front          |
//     |-/\/\/\/\/\/\/\/-|  wall, made second
//     |  front          |
//     |=/\/\/\/\/\/\/\/=|  wall, made first
//     |  front          |
//     |-/\/\/\/\/\/\/\/-|  wall, made second
//     |  front          |
//     +-----------------+
//
//    A wall is made by a front, too: of the edges that cross the line. It begins at those of the boundary, where the
//    line enters the patch, and ends where it leaves it. Sides of its triangles that do not cross the line go to one of
//    the halves.
// 3. In each strip a front grows until no edge waits.
//
// A region is a range of strips with the sides that wait in it: first the whole patch, in the end single strips. It may
// surprise that the triangles are those of a single front: each third point follows from the edge alone. And as strips
// depend on the points alone, triangles are in the same order for any number of threads.

#include "PatchFront.h"

#include "Common/Errors.h"
#include "Common/Parallel.h"

#include <algorithm>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// A strip has at least so many points, and on average so many rows of voxels: in thinner ones walls are most of it.
constexpr std::int64_t LeastPointsPerStrip = 2048;
constexpr std::int64_t LeastRowsPerStrip = 8;

// Where points are crowded in few voxels, as along an outline without points inside, triangles reach across many
// strips, and to find them from sides as long takes more time than threads save.
constexpr std::int64_t MostPointsPerVoxel = 4;

// Between so many triangles of a front, and between so many regions, the monitor is called.
constexpr std::size_t TrianglesPerCall = 4096;
constexpr std::size_t RegionsPerCall = 16;

/// How many voxels have points.
std::int64_t CountVoxels(const SearchGrid& points)
{
  const PointId* const starts = points.VoxelStarts();
  std::int64_t count = 0;
  for (std::int64_t voxel = 0; voxel < points.Voxels().Size(); ++voxel)
  {
    count += starts[voxel] < starts[voxel + 1] ? 1 : 0;
  }
  return count;
}
}

//----------------------------------------------------------------------------------------------------------------------
PatchFront::PatchFront(const SearchGrid& points, const ThirdPointSearch& search, std::int64_t strips)
  : Points(points)
  , Search(search)
  , Used(points.NumberOfPoints(), 0)
{
  this->MakeStrips(strips);
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t PatchFront::FindStrips(const SearchGrid& points)
{
  const std::int64_t strips =
    std::min(points.NumberOfPoints() / LeastPointsPerStrip, points.Voxels().SizeY() / LeastRowsPerStrip);
  return strips < 2 || points.NumberOfPoints() > MostPointsPerVoxel * CountVoxels(points) ? 1 : strips;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::MakeStrips(std::int64_t strips)
{
  const CellGrid& voxels = this->Points.Voxels();
  const std::int64_t points = this->Points.NumberOfPoints();
  this->StripStarts = { 0 };
  for (std::int64_t row = 1; row < voxels.SizeY(); ++row)
  {
    const PointId start = this->Points.FirstIn(voxels.Index(0, row));
    if (start * strips >= points * std::int64_t(this->StripStarts.size()) && start < points)
    {
      this->StripStarts.push_back(start);
    }
  }
  this->StripStarts.push_back(PointId(points));
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::AddSide(PointId from, PointId to)
{
  this->Use(from);
  this->Use(to);
  this->Sides.push_back({ from, to, 0.0f });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::Grow(std::size_t most, const Monitor& monitor)
{
  std::vector<Region> regions(1);
  regions[0].EndStrip = this->StripStarts.size() - 1;
  regions[0].Sides.swap(this->Sides);
  if (regions[0].EndStrip == 1)
  {
    this->Parts.emplace_back();
    this->GrowStrip(regions[0], most, monitor, this->Parts.back());
    return;
  }
  while (!regions.empty())
  {
    regions = this->GrowRegions(regions, monitor);
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Gives the halves of those that are more than a strip.
std::vector<PatchFront::Region> PatchFront::GrowRegions(const std::vector<Region>& regions, const Monitor& monitor)
{
  std::vector<Growth> grown(regions.size());
  for (std::size_t done = 0; done < regions.size(); done += RegionsPerCall)
  {
    monitor.Progress(std::min(1.0, double(this->NumberOfTriangles()) / double(this->MostTriangles())));
    ParallelFor(std::int64_t(std::min(RegionsPerCall, regions.size() - done)), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          grown[done + n] = this->GrowWall(regions[done + n]);
        }
      });
    for (std::size_t n = done; n < std::min(done + RegionsPerCall, regions.size()); ++n)
    {
      this->Parts.push_back(std::move(grown[n].Triangles));
    }
  }
  std::vector<Region> halves;
  for (Growth& growth : grown)
  {
    for (Region* half : { &growth.Below, &growth.Above })
    {
      if (half->FirstStrip < half->EndStrip)
      {
        halves.push_back(std::move(*half));
      }
    }
  }
  return halves;
}

//----------------------------------------------------------------------------------------------------------------------
PatchFront::Growth PatchFront::GrowWall(const Region& region)
{
  Growth growth;
  if (region.EndStrip - region.FirstStrip == 1)
  {
    this->GrowStrip(region, this->MostTriangles() + 1, Monitor(), growth.Triangles);
    return growth;
  }
  const std::size_t middle = (region.FirstStrip + region.EndStrip) / 2;
  const PointId line = this->StripStarts[middle];
  growth.Below.FirstStrip = region.FirstStrip;
  growth.Below.EndStrip = middle;
  growth.Above.FirstStrip = middle;
  growth.Above.EndStrip = region.EndStrip;
  AdvancingFront front(this->FirstPointOf(region), this->EndPointOf(region));
  const auto addSide = [&](const FrontEdge& side)
  {
    if ((side.From < line) != (side.To < line))
    {
      front.AddSide(side);
    }
    else
    {
      (side.From < line ? growth.Below : growth.Above).Sides.push_back(side);
    }
  };
  this->GrowTriangles(front, region, this->MostTriangles() + 1, Monitor(), growth.Triangles, addSide);
  return growth;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::GrowStrip(
  const Region& region, std::size_t most, const Monitor& monitor, RawVector<PointId>& triangles)
{
  AdvancingFront front(this->FirstPointOf(region), this->EndPointOf(region));
  triangles.reserve(6 * std::size_t(this->EndPointOf(region) - this->FirstPointOf(region)));
  this->GrowTriangles(
    front, region, most, monitor, triangles, [&front](const FrontEdge& side) { front.AddSide(side); });
}

//----------------------------------------------------------------------------------------------------------------------
// Until no edge waits. No third point is outside the region, unless the boundary is not one.
template <typename SideAdder>
void PatchFront::GrowTriangles(AdvancingFront& front, const Region& region, std::size_t most, const Monitor& monitor,
  RawVector<PointId>& triangles, SideAdder&& addSide)
{
  for (const FrontEdge& side : region.Sides)
  {
    addSide(side);
  }
  FrontEdge edge;
  for (std::size_t made = 0; made < most && front.TakeNewest(edge); ++made)
  {
    if (made % TrianglesPerCall == 0)
    {
      monitor.Progress(std::min(1.0, double(made) / double(this->MostTriangles())));
    }
    const ThirdPoint third = this->Search.Find(edge.From, edge.To, edge.Diameter);
    if (third.Point < this->FirstPointOf(region) || third.Point >= this->EndPointOf(region) ||
      made >= this->MostTriangles())
    {
      this->ThrowNoThird(edge);
    }
    this->Use(third.Point);
    triangles.push_back(edge.From);
    triangles.push_back(edge.To);
    triangles.push_back(third.Point);
    addSide({ edge.To, third.Point, third.Diameter });
    addSide({ third.Point, edge.From, third.Diameter });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::ThrowNoThird(const FrontEdge& edge) const
{
  throw InputError("no surface to the left of the edge from point " + std::to_string(this->Points.NameOf(edge.From)) +
    " to point " + std::to_string(this->Points.NameOf(edge.To)) +
    ", expected closed boundary loops with the surface to their right");
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t PatchFront::NumberOfTriangles() const
{
  std::size_t corners = 0;
  for (const RawVector<PointId>& part : this->Parts)
  {
    corners += part.size();
  }
  return corners / 3;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::MoveTriangles(RawVector<PointId>& corners)
{
  std::vector<std::size_t> starts;
  std::size_t end = corners.size();
  for (const RawVector<PointId>& part : this->Parts)
  {
    starts.push_back(end);
    end += part.size();
  }
  corners.resize(end);
  ParallelFor(std::int64_t(this->Parts.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        std::transform(this->Parts[n].begin(), this->Parts[n].end(), corners.begin() + starts[n],
          [this](PointId point) { return this->Points.NameOf(point); });
        RawVector<PointId>().swap(this->Parts[n]);
      }
    });
  this->Parts.clear();
}
}
