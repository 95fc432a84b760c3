// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The size of a search cell is the power of two nearest to the spacing of points inside the boundary. Invalid input is
// refused, as it would give a wrong mesh. Each cell stores the distance to the nearest boundary edge: most lines of
// sight are shorter and need no test.
//
// The pyramid has boxes of squares of cells for near regions, and boxes of runs of successive points for the many
// points that one row of cells can have along an outline.

#include "SearchGrid.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

#include <cassert>
#include <cmath>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// This limits memory if points are crowded in a small part of their box.
constexpr double MostCellsPerPoint = 4.0;

// Distances are stored in bytes, saturated at this value.
constexpr unsigned char FarFromEdges = 255;

double SpacingOf(const std::vector<PlanePoint>& points, const Loops& boundary)
{
  assert(!points.empty());
  const PlanePoint size = PlaneBox(points).Greatest;
  const double box = (double(size.X) + 1.0) * (double(size.Y) + 1.0);
  std::int64_t doubledArea = 0;
  boundary.ForEachEdge(
    [&](PointId from, PointId to) {
      doubledArea += SignedArea({ 0, 0 }, points[to], points[from]);
    });
  const double inside = std::max(0.5 * double(doubledArea), box / MostCellsPerPoint);
  return std::sqrt(std::min(box, inside) / double(points.size()));
}

/// With a power of two, positions in units of cells are exact.
std::int64_t CellSizeFor(double spacing)
{
  return std::int64_t(1) << std::max(0L, std::lround(std::log2(spacing)));
}

template <typename Check>
void ForEachCell(std::int64_t cells, Check&& check)
{
  ParallelFor(cells, Grain,
    [&check](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t cell = first; cell < last; ++cell)
      {
        check(cell);
      }
    });
}

void LowerTo(const unsigned char* next, std::int64_t size, unsigned char* row)
{
  // Most rows are long, so that compilers vectorize this loop.
  for (std::int64_t x = 1; x + 1 < size; ++x)
  {
    const unsigned char nearest = std::min(std::min(next[x - 1], next[x]), next[x + 1]);
    row[x] = std::min(row[x], static_cast<unsigned char>(nearest + (nearest < FarFromEdges)));
  }
  for (const std::int64_t x : { std::int64_t(0), size - 1 })
  {
    const unsigned char nearest = std::min(next[x], next[x == 0 ? std::min<std::int64_t>(1, size - 1) : x - 1]);
    row[x] = std::min(row[x], static_cast<unsigned char>(nearest + (nearest < FarFromEdges)));
  }
}

void LowerAlong(std::int64_t size, unsigned char* row)
{
  int distance = FarFromEdges;
  for (std::int64_t x = 0; x < size; ++x)
  {
    distance = std::min<int>(row[x], std::min<int>(distance + 1, FarFromEdges));
    row[x] = static_cast<unsigned char>(distance);
  }
  distance = FarFromEdges;
  for (std::int64_t x = size; x-- > 0;)
  {
    distance = std::min<int>(row[x], std::min<int>(distance + 1, FarFromEdges));
    row[x] = static_cast<unsigned char>(distance);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SearchGrid(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names)
  : PointSpacing(SpacingOf(points, boundary))
  , Grid(points, 1, CellSizeFor(this->PointSpacing))
  , Shift(std::ilogb(double(this->Grid.CellSize())))
  , Origin(this->Grid.Corner(0))
  , Last({ std::int32_t(this->Grid.SizeX() - 1), std::int32_t(this->Grid.SizeY() - 1) })
  , Sorted(this->Grid, points, names)
  , EdgesInCell(SortByCell(this->Grid, this->Sorted.Places, boundary.Renumbered(this->Sorted.Numbers)))
{
  assert(this->Grid.CellSize() == std::int64_t(1) << this->Shift);
  ForEachCell(this->Grid.Size(), [this](std::int64_t cell) { this->CheckPlaces(cell); });
  ForEachCell(this->Grid.Size(), [this](std::int64_t cell) { this->CheckEdges(cell); });
  this->MeasureEdgeDistances();
}

//----------------------------------------------------------------------------------------------------------------------
SearchGrid::SortedPoints::SortedPoints(
  const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names)
  : Cells(grid.Size())
  , Places(points.size() + Padding)
  , Names(points.size())
  , Numbers(points.size())
{
  for (const PlanePoint& point : points)
  {
    this->Cells.Count(grid.CellOf(point));
  }
  this->Cells.EndCounting();
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const PointId number = this->Cells.NextPosition(grid.CellOf(points[point]));
    this->Numbers[point] = number;
    this->Places[number] = points[point];
    this->Names[number] = names[point];
  }
  // A search that reads beyond the last point finds copies of it, which are not better.
  std::fill_n(this->Places.end() - Padding, Padding, this->Places[points.size() - 1]);
}

//----------------------------------------------------------------------------------------------------------------------
bool SearchGrid::AreFewAndApart(std::int64_t cell) const
{
  constexpr PointId few = 8;
  const PlanePoint* const first = this->Sorted.Places.data() + this->FirstIn(cell);
  const PlanePoint* const end = this->Sorted.Places.data() + this->EndOf(cell);
  bool apart = end - first <= few;
  for (const PlanePoint* place = first; apart && place < end; ++place)
  {
    apart = std::find(first, place, *place) == place;
  }
  return apart;
}

//----------------------------------------------------------------------------------------------------------------------
void SearchGrid::CheckPlaces(std::int64_t cell) const
{
  if (this->AreFewAndApart(cell))
  {
    return;
  }
  std::vector<PointId> numbers(this->EndOf(cell) - this->FirstIn(cell));
  std::iota(numbers.begin(), numbers.end(), this->FirstIn(cell));
  std::sort(numbers.begin(), numbers.end(), [this](PointId a, PointId b) { return this->At(a) < this->At(b); });
  const auto twin = std::adjacent_find(
    numbers.begin(), numbers.end(), [this](PointId a, PointId b) { return this->At(a) == this->At(b); });
  if (twin != numbers.end())
  {
    const auto names = std::minmax({ this->NameOf(*twin), this->NameOf(*(twin + 1)) });
    throw InputError("points " + std::to_string(names.first) + " and " + std::to_string(names.second) +
      " in one place in plan, expected at most one point of a horizon above each place");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SearchGrid::CheckEdges(std::int64_t cell) const
{
  for (const Edge* edge = this->EdgesInCell.begin(cell); edge != this->EdgesInCell.end(cell); ++edge)
  {
    this->CheckEdge(edge, cell);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SearchGrid::CheckEdge(const Edge* edge, std::int64_t cell) const
{
  const PlanePoint& from = this->At(edge->From);
  const PlanePoint& to = this->At(edge->To);
  const Edge* const crossing = std::find_if(this->EdgesInCell.begin(cell), edge,
    [&](const Edge& other) { return ProperlyCross(from, to, this->At(other.From), this->At(other.To)); });
  if (crossing != edge)
  {
    throw InputError(this->Describe(*edge) + " crosses " + this->Describe(*crossing) +
      ", expected edges that meet only at their ends");
  }
  for (PointId point = this->FirstIn(cell); point < this->EndOf(cell); ++point)
  {
    if (OnOpenSegment(from, to, this->At(point)))
    {
      throw InputError("point " + std::to_string(this->NameOf(point)) + " lies on " + this->Describe(*edge) +
        ", expected no point between the ends of a boundary edge");
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string SearchGrid::Describe(const Edge& edge) const
{
  return "boundary edge " + std::to_string(this->NameOf(edge.From)) + " - " + std::to_string(this->NameOf(edge.To));
}

//----------------------------------------------------------------------------------------------------------------------
// A shortest path from an edge follows its row first, then crosses rows. Hence one pass along rows and two passes
// across them, upwards and downwards.
void SearchGrid::MeasureEdgeDistances()
{
  this->EdgeDistances.assign(this->Grid.Size(), FarFromEdges);
  if (this->EdgesInCell.Size() == 0)
  {
    return;
  }
  const std::int64_t size = this->Grid.SizeX();
  unsigned char* const distances = this->EdgeDistances.data();
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    distances[cell] = this->EdgesInCell.IsEmpty(cell) ? FarFromEdges : 0;
  }
  for (std::int64_t y = 0; y < this->Grid.SizeY(); ++y)
  {
    LowerAlong(size, distances + y * size);
  }
  for (std::int64_t y = 1; y < this->Grid.SizeY(); ++y)
  {
    LowerTo(distances + (y - 1) * size, size, distances + y * size);
  }
  for (std::int64_t y = this->Grid.SizeY() - 1; y-- > 0;)
  {
    LowerTo(distances + (y + 1) * size, size, distances + y * size);
  }
}

//----------------------------------------------------------------------------------------------------------------------
PointPyramid::PointPyramid(const SearchGrid& points)
  : Points(points)
{
  this->MakeRuns();
  this->MakeLowest();
  while (this->Levels.back().Boxes.size() > 1)
  {
    this->MakeNext();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PointPyramid::MakeRuns()
{
  const PointId count = this->Points.EndOf(this->Points.Cells().Size() - 1);
  this->Runs.emplace_back((count - 1) / RunSize + 1);
  PlaneBox* run = this->Runs.back().data();
  for (PointId first = 0; first < count; first += RunSize, ++run)
  {
    for (PointId point = first; point < std::min(first + RunSize, count); ++point)
    {
      run->Add(this->Points.At(point));
    }
  }
  while (this->Runs.back().size() > 1)
  {
    const std::vector<PlaneBox>& below = this->Runs.back();
    std::vector<PlaneBox> runs(((below.size() - 1) >> RunShift) + 1);
    for (std::size_t n = 0; n < below.size(); ++n)
    {
      runs[n >> RunShift].Add(below[n]);
    }
    this->Runs.push_back(std::move(runs));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PointPyramid::MakeLowest()
{
  const CellGrid& cells = this->Points.Cells();
  Level level{ (cells.SizeX() - 1) / BaseSize + 1, (cells.SizeY() - 1) / BaseSize + 1, {} };
  level.Boxes.resize(level.SizeX * level.SizeY);
  for (std::int64_t y = 0; y < cells.SizeY(); ++y)
  {
    PlaneBox* box = level.Boxes.data() + y / BaseSize * level.SizeX;
    for (std::int64_t x = 0; x < cells.SizeX(); x += BaseSize, ++box)
    {
      const std::int64_t last = std::min(x + BaseSize, cells.SizeX()) - 1;
      const PointId end = this->Points.EndOf(cells.Index(last, y));
      for (PointId point = this->Points.FirstIn(cells.Index(x, y)); point < end; ++point)
      {
        box->Add(this->Points.At(point));
      }
    }
  }
  this->Levels.push_back(std::move(level));
}

//----------------------------------------------------------------------------------------------------------------------
void PointPyramid::MakeNext()
{
  const Level& below = this->Levels.back();
  Level level{ (below.SizeX + 1) / 2, (below.SizeY + 1) / 2, {} };
  level.Boxes.resize(level.SizeX * level.SizeY);
  for (std::int64_t y = 0; y < below.SizeY; ++y)
  {
    for (std::int64_t x = 0; x < below.SizeX; ++x)
    {
      const PlaneBox& box = below.Boxes[y * below.SizeX + x];
      level.Boxes[y / 2 * level.SizeX + x / 2].Add(box);
    }
  }
  this->Levels.push_back(std::move(level));
}

// ---- PlaneFrame -----------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
PlaneFrame::PlaneFrame(const std::vector<PlanePoint>& places)
{
  assert(!places.empty());
  // The lowest bit set in any distance from the first place is the largest power of two that divides them all, and
  // all distances from the least coordinates.
  const PlanePoint first = places.front();
  PlaneBox box;
  std::int32_t bits = 0;
  for (const PlanePoint& place : places)
  {
    box.Add(place);
    bits |= (place.X - first.X) | (place.Y - first.Y);
  }
  this->Least = box.Least;
  this->Greatest = box.Greatest;
  while (bits != 0 && ((bits >> this->Shift) & 1) == 0)
  {
    ++this->Shift;
  }
}
}
