// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search grid is divided into strips of rows. Triangles across the line between two strips form a wall, which
// separates fronts so that they can grow in parallel. The wall on the middle line comes first, then walls in both
// halves, and so on (Cignoni, Montani, Scopigno, "DeWall: A fast divide and conquer Delaunay triangulation algorithm in
// E^d", 1998):
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
// A wall grows from boundary edges across its line; other edges of its triangles go to one of the halves. Triangles
// are the same as with a single front, as each third point depends on its edge alone. Their order does not depend on
// the number of threads.

#include "PatchFront.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"

#include <algorithm>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// In thinner strips walls would be most of the work.
constexpr std::int64_t LeastPointsPerStrip = 2048;
constexpr std::int64_t LeastRowsPerStrip = 8;

// With many points per search cell, as along an outline without points inside, triangles cross many strips, and their
// search costs more than threads save.
constexpr std::int64_t MostPointsPerCell = 4;

constexpr std::size_t TrianglesPerCall = 4096;
constexpr std::size_t RegionsPerCall = 16;

std::int64_t CountCells(const SearchGrid& points)
{
  const PointId* const starts = points.CellStarts();
  std::int64_t count = 0;
  for (std::int64_t cell = 0; cell < points.Cells().Size(); ++cell)
  {
    count += starts[cell] < starts[cell + 1] ? 1 : 0;
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
    std::min(points.NumberOfPoints() / LeastPointsPerStrip, points.Cells().SizeY() / LeastRowsPerStrip);
  return strips < 2 || points.NumberOfPoints() > MostPointsPerCell * CountCells(points) ? 1 : strips;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::MakeStrips(std::int64_t strips)
{
  const CellGrid& cells = this->Points.Cells();
  const std::int64_t points = this->Points.NumberOfPoints();
  this->StripStarts = { 0 };
  for (std::int64_t row = 1; row < cells.SizeY(); ++row)
  {
    const PointId start = this->Points.FirstIn(cells.Index(0, row));
    if (start * strips >= points * std::int64_t(this->StripStarts.size()) && start < points)
    {
      this->StripStarts.push_back(start);
    }
  }
  this->StripStarts.push_back(PointId(points));
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::AddEdge(PointId from, PointId to)
{
  this->Use(from);
  this->Use(to);
  this->Edges.push_back({ from, to, 0.0f });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::Grow(std::size_t most, const Monitor& monitor)
{
  std::vector<Region> regions(1);
  regions[0].EndStrip = this->StripStarts.size() - 1;
  regions[0].Edges.swap(this->Edges);
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
  const auto addEdge = [&](const FrontEdge& edge)
  {
    if ((edge.From < line) != (edge.To < line))
    {
      front.AddEdge(edge);
    }
    else
    {
      (edge.From < line ? growth.Below : growth.Above).Edges.push_back(edge);
    }
  };
  this->GrowTriangles(front, region, this->MostTriangles() + 1, Monitor(), growth.Triangles, addEdge);
  return growth;
}

//----------------------------------------------------------------------------------------------------------------------
void PatchFront::GrowStrip(
  const Region& region, std::size_t most, const Monitor& monitor, RawVector<PointId>& triangles)
{
  AdvancingFront front(this->FirstPointOf(region), this->EndPointOf(region));
  triangles.reserve(6 * std::size_t(this->EndPointOf(region) - this->FirstPointOf(region)));
  this->GrowTriangles(
    front, region, most, monitor, triangles, [&front](const FrontEdge& edge) { front.AddEdge(edge); });
}

//----------------------------------------------------------------------------------------------------------------------
// A third point outside the region indicates an invalid boundary.
template <typename EdgeAdder>
void PatchFront::GrowTriangles(AdvancingFront& front, const Region& region, std::size_t most, const Monitor& monitor,
  RawVector<PointId>& triangles, EdgeAdder&& addEdge)
{
  for (const FrontEdge& edge : region.Edges)
  {
    addEdge(edge);
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
    addEdge({ edge.To, third.Point, third.Diameter });
    addEdge({ third.Point, edge.From, third.Diameter });
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
