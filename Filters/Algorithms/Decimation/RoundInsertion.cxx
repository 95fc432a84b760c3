// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RoundInsertion.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::uint32_t MostPasses = 4;

// Larger squares have fewer points that reach beyond, smaller ones employ more threads.
constexpr std::size_t LeastPerSquare = 32;
constexpr std::size_t MostPerSquare = 512;
constexpr std::size_t UsualSquares = 64;

constexpr std::int64_t ReachesPerChunk = 64;

// Ranks are larger in later passes, and for earlier points.
constexpr std::uint32_t BitsOfNumber = 28;
}

//----------------------------------------------------------------------------------------------------------------------
PlaneBox RoundInsertion::Squares::BoxAt(const PlanePoint& place) const
{
  const auto start = [this](std::int32_t origin, std::int32_t value)
  { return origin + (value - origin) / this->Side * this->Side; };
  PlaneBox box;
  box.Least = { start(this->Origin.X, place.X), start(this->Origin.Y, place.Y) };
  box.Greatest = { box.Least.X + this->Side - 1, box.Least.Y + this->Side - 1 };
  return box;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t RoundInsertion::Squares::NumberAt(const PlanePoint& place) const
{
  return (place.X - this->Origin.X) / this->Side +
    std::int64_t(this->Across) * ((place.Y - this->Origin.Y) / this->Side);
}

//----------------------------------------------------------------------------------------------------------------------
RoundInsertion::RoundInsertion(HeightMesh& mesh, const std::vector<TriangleId>& triangles, const PlaneMesh::Room& room,
  std::vector<unsigned char>& isChanged)
  : Mesh(mesh)
  , Triangles(triangles)
  , Room(room)
  , Box(this->FindBox())
  , IsChanged(isChanged)
  , Ranks(std::size_t(mesh.Triangles().Size()))
{
  assert(!mesh.Triangles().HasKept() && triangles.size() < std::size_t(1) << BitsOfNumber);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> RoundInsertion::Run(std::vector<TriangleId>& changed)
{
  std::vector<std::size_t> waiting(this->Triangles.size());
  std::iota(waiting.begin(), waiting.end(), std::size_t(0));
  while (this->Pass < MostPasses && waiting.size() >= LeastPoints)
  {
    ++this->Pass;
    this->InsertBySquares(waiting, changed);
  }
  return waiting;
}

//----------------------------------------------------------------------------------------------------------------------
PlaneBox RoundInsertion::FindBox() const
{
  return AddUpChunks<PlaneBox>(std::int64_t(this->Triangles.size()), ReachesPerChunk, Monitor(),
    [this](PlaneBox& box, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        box.Add(this->PlaceOf(std::size_t(n)));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// Squares are shifted by half their side from pass to pass, across, along and both.
RoundInsertion::Squares RoundInsertion::MakeSquares(std::size_t points) const
{
  const double width = double(this->Box.Greatest.X) - this->Box.Least.X + 1.0;
  const double height = double(this->Box.Greatest.Y) - this->Box.Least.Y + 1.0;
  const std::size_t perSquare = std::clamp(points / UsualSquares, LeastPerSquare, MostPerSquare);
  Squares squares;
  squares.Side = std::int32_t(std::ceil(std::sqrt(width * height * double(perSquare) / double(points))));
  const std::int32_t half = squares.Side / 2;
  squares.Origin = { this->Box.Least.X - (this->Pass % 2 == 0 ? half : 0),
    this->Box.Least.Y - (this->Pass == 2 || this->Pass == 3 ? half : 0) };
  squares.Across = (this->Box.Greatest.X - squares.Origin.X) / squares.Side + 1;
  squares.Down = (this->Box.Greatest.Y - squares.Origin.Y) / squares.Side + 1;
  return squares;
}

//----------------------------------------------------------------------------------------------------------------------
void RoundInsertion::InsertBySquares(std::vector<std::size_t>& waiting, std::vector<TriangleId>& changed)
{
  const Squares squares = this->MakeSquares(waiting.size());
  std::vector<std::vector<TriangleId>> reached;
  const std::vector<Point> points = this->FindPoints(waiting, squares, reached);
  const std::int64_t count = std::int64_t(squares.Across) * squares.Down;
  const ItemLists<std::size_t> bySquare(count,
    [&](auto&& list)
    {
      for (std::size_t n = 0; n < points.size(); ++n)
      {
        list(points[n].Square, n);
      }
    });
  std::vector<Square> done(static_cast<std::size_t>(count));
  ParallelFor(count, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      Scratch scratch;
      for (std::int64_t square = first; square < last; ++square)
      {
        for (const std::size_t* n = bySquare.begin(square); n != bySquare.end(square); ++n)
        {
          if (!this->Insert(points[*n], scratch, done[square]))
          {
            done[square].Waiting.push_back(points[*n].Number);
          }
        }
      }
    });
  waiting.clear();
  for (const Square& square : done)
  {
    waiting.insert(waiting.end(), square.Waiting.begin(), square.Waiting.end());
    changed.insert(changed.end(), square.Changed.begin(), square.Changed.end());
    this->HasPutBack = this->HasPutBack || square.HasPutBack;
  }
  ParallelSort(waiting, std::less<>());
}

//----------------------------------------------------------------------------------------------------------------------
// Points that reach beyond their squares wait from the start.
std::vector<RoundInsertion::Point> RoundInsertion::FindPoints(
  const std::vector<std::size_t>& numbers, const Squares& squares, std::vector<std::vector<TriangleId>>& reached)
{
  const auto size = std::int64_t(numbers.size());
  std::vector<Point> points(numbers.size());
  reached.resize(CountChunks(size, ReachesPerChunk));
  ForEachChunk(size, ReachesPerChunk, Monitor(),
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      std::vector<TriangleId>& reach = reached[chunk];
      Scratch scratch;
      std::array<std::size_t, ReachesPerChunk + 1> starts = {};
      for (std::int64_t n = first; n < last; ++n)
      {
        if (!this->IsDone(numbers[n]))
        {
          this->AddReach(numbers[n], scratch, reach);
        }
        starts[n - first + 1] = reach.size();
      }
      for (std::int64_t n = first; n < last; ++n)
      {
        const PlanePoint& place = this->PlaceOf(numbers[n]);
        const Reached own = { reach.data() + starts[n - first], reach.data() + starts[n - first + 1] };
        points[n] = { numbers[n], squares.NumberAt(place), this->Contains(squares.BoxAt(place), own), own };
        if (!points[n].IsInside)
        {
          this->Reserve(own, this->RankOf(numbers[n]));
        }
      }
    });
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
// Returns false for a point that waits.
bool RoundInsertion::Insert(const Point& point, Scratch& scratch, Square& square)
{
  if (this->IsDone(point.Number))
  {
    return true;
  }
  if (!point.IsInside)
  {
    return false;
  }
  Reached reach = point.Reach;
  if (std::any_of(reach.begin(), reach.end(), [this](TriangleId one) { return this->IsChanged[one] != 0; }))
  {
    scratch.Reach.clear();
    this->AddReach(point.Number, scratch, scratch.Reach);
    reach = { scratch.Reach.data(), scratch.Reach.data() + scratch.Reach.size() };
  }
  const std::uint32_t rank = this->RankAt(reach);
  if (rank > this->RankOf(point.Number))
  {
    this->Reserve(reach, this->RankOf(point.Number));
    return false;
  }
  std::vector<TriangleId>& around = scratch.Around;
  const TriangleId triangle = this->Triangles[point.Number];
  const PointId inserted = this->PointOf(point.Number);
  const VertexId corner = this->Mesh.CornerOf(triangle, inserted);
  around.clear();
  if (corner != NoVertex)
  {
    this->Mesh.PutBack(corner);
    this->Mesh.Triangles().FindRing(corner, triangle, around);
    square.HasPutBack = true;
  }
  else if (!this->Mesh.IsVertex(inserted))
  {
    this->Mesh.Insert(inserted, triangle, this->Room.At(point.Number), around);
  }
  if (corner == NoVertex && around.empty()) // the caller complains
  {
    this->Reserve(reach, this->RankOf(point.Number));
    return false;
  }
  std::copy_if(around.begin(), around.end(), std::back_inserter(square.Changed),
    [this](TriangleId one) { return std::exchange(this->IsChanged[one], 1) == 0; });
  if (rank >> BitsOfNumber == this->Pass)
  {
    this->Reserve(reach, rank);
    this->Reserve({ around.data(), around.data() + around.size() }, rank);
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
// Triangles that have changed are measured again before their points count.
bool RoundInsertion::IsDone(std::size_t number) const
{
  return this->IsChanged[this->Triangles[number]] != 0 &&
    this->Mesh.CornerOf(this->Triangles[number], this->PointOf(number)) == NoVertex;
}

//----------------------------------------------------------------------------------------------------------------------
void RoundInsertion::AddReach(std::size_t number, Scratch& scratch, std::vector<TriangleId>& reach) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  const TriangleId triangle = this->Triangles[number];
  const VertexId corner = this->Mesh.CornerOf(triangle, this->PointOf(number));
  reach.push_back(triangle);
  if (corner != NoVertex)
  {
    mesh.FindRing(corner, triangle, scratch.Around);
    reach.insert(reach.end(), scratch.Around.begin(), scratch.Around.end());
    return;
  }
  // Triangles whose circles hold the point join without a cycle, as all of their corners are on the rim.
  const PlanePoint& place = this->PlaceOf(number);
  scratch.InCircle = { { triangle, NoTriangle } };
  for (std::size_t n = 0; n < scratch.InCircle.size() && n <= std::size_t(mesh.Size()); ++n)
  {
    const auto [one, from] = scratch.InCircle[n];
    for (int edge = 0; edge < 3; ++edge)
    {
      const TriangleId other = mesh.Neighbour(one, edge);
      if (other != NoTriangle && other != from)
      {
        reach.push_back(other);
        const auto& [a, b, c] = mesh.Corners(other);
        if (InCircle(mesh.Place(a), mesh.Place(b), mesh.Place(c), place) > 0)
        {
          scratch.InCircle.emplace_back(other, one);
        }
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool RoundInsertion::Contains(const PlaneBox& square, const Reached& reach) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  return std::all_of(reach.begin(), reach.end(),
    [&](TriangleId triangle)
    {
      const auto& [a, b, c] = mesh.Corners(triangle);
      return square.Contains(mesh.Place(a)) && square.Contains(mesh.Place(b)) && square.Contains(mesh.Place(c));
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::uint32_t RoundInsertion::RankOf(std::size_t number) const
{
  return this->Pass << BitsOfNumber | std::uint32_t(this->Triangles.size() - number);
}

//----------------------------------------------------------------------------------------------------------------------
void RoundInsertion::Reserve(const Reached& triangles, std::uint32_t rank)
{
  for (const TriangleId triangle : triangles)
  {
    std::uint32_t before = this->Ranks[triangle].load(std::memory_order_relaxed);
    while (before < rank && !this->Ranks[triangle].compare_exchange_weak(before, rank, std::memory_order_relaxed))
    {
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::uint32_t RoundInsertion::RankAt(const Reached& triangles) const
{
  std::uint32_t first = 0;
  for (const TriangleId triangle : triangles)
  {
    first = std::max(first, this->Ranks[triangle].load(std::memory_order_relaxed));
  }
  return first;
}
}
