// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightMesh.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/HeapArray.h"
#include "Common/Base/LargePages.h"
#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TrianglesPerTask = 64;

/// Points without a patch keep negative numbers.
std::vector<std::int32_t> Renumber(std::vector<std::int32_t> patches, std::int32_t& count)
{
  const auto runs = CollectChunks<std::int32_t>(std::int64_t(patches.size()), ChunkSize, Monitor(),
    [&](std::vector<std::int32_t>& found, std::int64_t first, std::int64_t last)
    { std::unique_copy(patches.begin() + first, patches.begin() + last, std::back_inserter(found)); });
  std::map<std::int32_t, std::int32_t> numbers;
  bool areSame = true;
  for (const std::int32_t patch : runs)
  {
    areSame = (patch < 0 || numbers.emplace(patch, std::int32_t(numbers.size())).first->second == patch) && areSame;
  }
  count = std::int32_t(numbers.size());
  if (!areSame) // never after FindExteriorBoundary
  {
    std::transform(patches.begin(), patches.end(), patches.begin(),
      [&numbers](std::int32_t patch) { return patch < 0 ? patch : numbers.at(patch); });
  }
  return patches;
}
}

//----------------------------------------------------------------------------------------------------------------------
HeightMesh::HeightMesh(BoundedHorizon horizon, const Monitor& monitor, const double* heights)
  : Horizon(std::move(horizon))
  , Places(this->Horizon.ColumnPlaces())
  , Patches(Renumber(std::move(this->Horizon.Patch), this->PatchCount))
  , Points(std::size_t(
      std::count_if(this->Patches.begin(), this->Patches.end(), [](std::int32_t patch) { return patch >= 0; })))
{
  this->SetLoops(monitor);
  const double* const own = heights ? heights : this->Horizon.Height.data();
  this->Add(this->MakeRasters(own), own);
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::AddHorizon(const std::vector<double>& heights, const std::vector<unsigned char>* isKnown)
{
  assert(heights.size() == this->NumberOfAllPoints());
  assert(!isKnown || isKnown->size() == heights.size());
  std::vector<HeightRaster> rasters;
  for (const HeightRaster& raster : this->Horizons.front().Rasters)
  {
    rasters.emplace_back(raster, heights.data(), isKnown);
  }
  this->Add(std::move(rasters), heights.data());
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::AllowRounding(const std::vector<HeightRaster>& rasters)
{
  for (const HeightRaster& raster : rasters)
  {
    const double largest = std::max(std::abs(raster.LowestHeight()), std::abs(raster.HighestHeight()));
    this->RoundingError = std::max(this->RoundingError, UnitsOfRounding * largest);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::Add(std::vector<HeightRaster> rasters, const double* heights)
{
  this->AllowRounding(rasters);
  this->Horizons.push_back({ std::move(rasters), this->RaisedSources(heights), heights });
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::HeightOfVertex(const double* heights, PointId point) const
{
  const std::vector<LockedHeight>& locked = this->Horizon.Locked;
  const auto found = std::lower_bound(
    locked.begin(), locked.end(), point, [](const LockedHeight& one, PointId other) { return one.Point < other; });
  return found != locked.end() && found->Point == point ? found->Height : heights[point];
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<RaisedPoint> HeightMesh::RaisedSources(const double* heights) const
{
  std::vector<RaisedPoint> raised;
  raised.reserve(this->Sources.size());
  std::transform(this->Sources.begin(), this->Sources.end(), std::back_inserter(raised),
    [&](PointId source) {
      return RaisedPoint{ this->Places[source], this->HeightOfVertex(heights, source) };
    });
  return raised;
}

//----------------------------------------------------------------------------------------------------------------------
BoundedHorizon HeightMesh::TakeHorizon()
{
  this->Horizon.Patch = std::move(this->Patches);
  return std::move(this->Horizon);
}

//----------------------------------------------------------------------------------------------------------------------
// Only points of loops become vertices.
void HeightMesh::SetLoops(const Monitor& monitor)
{
  BoundedHorizon outline;
  this->Marks = this->Boundary().MarkPoints(this->Patches.size());
  for (const PointId point : this->Horizon.Beside)
  {
    this->Marks[std::size_t(point)] = 1;
  }
  this->Sources.clear();
  this->Boundary().ForEachPoint([this](PointId point) { this->Sources.push_back(point); });
  std::sort(this->Sources.begin(), this->Sources.end());
  this->Sources.erase(std::unique(this->Sources.begin(), this->Sources.end()), this->Sources.end());
  for (const PointId point : this->Sources)
  {
    outline.Plane.push_back(this->Places[point]);
    outline.Patch.push_back(this->Patches[point]);
  }
  this->OnLoops = this->Sources.size();
  this->Removed = 0;
  this->AreOnLoops.assign(this->OnLoops, 1);
  this->AreFixed = this->AreOnLoops;
  outline.Boundary = this->Boundary().RenumberedBy([this](PointId point)
    { return PointId(std::lower_bound(this->Sources.begin(), this->Sources.end(), point) - this->Sources.begin()); });
  const RawVector<PointId> triangles = Triangulate(outline, TriangulationOptions(), monitor).Triangles;
  this->Mesh = PlaneMesh(std::move(outline.Plane), triangles);
  for (RaisedHorizon& raised : this->Horizons)
  {
    raised.Vertices = this->RaisedSources(raised.Heights);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<std::vector<TriangleId>> HeightMesh::ChangeLoops(
  Loops boundary, DroppedPoints dropped, const std::vector<PointId>& others)
{
  assert(this->NumberOfHorizons() == 1);
  const std::vector<PointState> before = this->PointStates();
  for (const DroppedPoint& one : this->Horizon.Dropped)
  {
    this->Patches[one.Point] = this->Patches[one.Target];
  }
  for (const DroppedPoint& one : dropped)
  {
    this->Patches[one.Point] = NoPatch;
  }
  this->Points += this->Horizon.Dropped.size();
  this->Points -= dropped.size();
  this->Horizon.Boundary = std::move(boundary);
  this->Horizon.Dropped = std::move(dropped);
  std::vector<HeightRaster>& rasters = this->Horizons.front().Rasters;
  const std::vector<std::vector<PointId>> byPatch = this->DroppedByPatch(rasters.size());
  for (std::size_t patch = 0; patch < rasters.size(); ++patch)
  {
    rasters[patch].SetDropped(byPatch[patch], this->Places);
  }
  this->AllowRounding(rasters);
  const std::vector<PointState> now = this->PointStates();
  std::vector<PointState> changes;
  std::set_symmetric_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(changes));
  std::vector<PointId> moved;
  std::transform(
    changes.begin(), changes.end(), std::back_inserter(moved), [](const PointState& one) { return one.first; });
  std::vector<unsigned char> mayStay(this->Sources.size());
  ParallelFor(std::int64_t(mayStay.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      std::transform(this->Sources.begin() + first, this->Sources.begin() + last, mayStay.begin() + first,
        [&](PointId point) { return std::binary_search(moved.begin(), moved.end(), point) ? 0 : 1; });
    });
  const std::optional<LoopChange> change =
    SeismicHorizons::ChangeLoops(this->Mesh, this->Sources, mayStay, this->Places, this->Boundary());
  if (!change)
  {
    this->SetLoops(Monitor());
    this->Errors.assign(std::size_t(this->Mesh.Size()), HeightError());
    return {};
  }
  std::vector<TriangleId> triangles = this->Exchange(*change);
  this->Errors.assign(std::size_t(this->Mesh.Size()), HeightError());
  this->Mesh.MakeDelaunay(triangles);
  moved.insert(moved.end(), others.begin(), others.end());
  const std::vector<TriangleId> beside = this->FindBeside(moved);
  triangles.insert(triangles.end(), beside.begin(), beside.end());
  return triangles;
}

//----------------------------------------------------------------------------------------------------------------------
// Points on loops and dropped points, sorted.
std::vector<HeightMesh::PointState> HeightMesh::PointStates() const
{
  std::vector<PointState> states;
  this->Boundary().ForEachPoint([&](PointId point) { states.emplace_back(point, State::OnLoop); });
  for (const DroppedPoint& one : this->Horizon.Dropped)
  {
    states.emplace_back(one.Point, State::Dropped);
  }
  std::sort(states.begin(), states.end());
  states.erase(std::unique(states.begin(), states.end()), states.end());
  return states;
}

//----------------------------------------------------------------------------------------------------------------------
// Vertices of triangles that go remain only as corners of others, or on loops.
std::vector<TriangleId> HeightMesh::Exchange(const LoopChange& change)
{
  std::map<PointId, VertexId> vertices;
  for (VertexId vertex = 0; vertex < this->EndOfVertices(); ++vertex)
  {
    if (this->IsOnLoop(vertex))
    {
      vertices.emplace(this->Sources[vertex], vertex);
    }
  }
  for (const TriangleId triangle : change.Gone)
  {
    for (const VertexId vertex : this->Mesh.Corners(triangle))
    {
      vertices.emplace(this->Sources[vertex], vertex);
    }
  }
  std::set<PointId> points(change.Added.begin(), change.Added.end());
  this->Boundary().ForEachPoint([&points](PointId point) { points.insert(point); });
  for (const auto& [point, vertex] : vertices)
  {
    this->AreOnLoops[vertex] = 0;
    this->AreFixed[vertex] = 0;
    if (points.count(point) == 0)
    {
      this->Sources[vertex] = NoPoint;
      this->Marks[point] = 0;
      ++this->Removed;
    }
  }
  for (const PointId point : points)
  {
    if (vertices.count(point) == 0)
    {
      const VertexId vertex = this->Mesh.Add(this->Places[point]);
      this->AddVertices(1);
      this->SetVertex(vertex, point);
      vertices.emplace(point, vertex);
    }
  }
  this->Boundary().ForEachPoint(
    [&](PointId point)
    {
      const VertexId vertex = vertices.at(point);
      this->AreOnLoops[vertex] = 1;
      this->AreFixed[vertex] = 1;
      this->PutBack(vertex);
    });
  this->OnLoops = std::size_t(std::count(this->AreOnLoops.begin(), this->AreOnLoops.end(), 1));
  RawVector<VertexId> added;
  std::transform(change.Added.begin(), change.Added.end(), std::back_inserter(added),
    [&vertices](PointId point) { return vertices.at(point); });
  return this->Mesh.Exchange(change.Gone, added);
}

//----------------------------------------------------------------------------------------------------------------------
// Edges of these triangles may cross links to the points.
std::vector<TriangleId> HeightMesh::FindBeside(const std::vector<PointId>& points) const
{
  std::vector<PlanePoint> columns;
  std::transform(points.begin(), points.end(), std::back_inserter(columns),
    [this](PointId point) { return this->Places[std::size_t(point)]; });
  std::sort(columns.begin(), columns.end(), PrecedesByRow);
  const auto isBeside = [&](const PlaneBox& box)
  {
    auto column = std::lower_bound(columns.begin(), columns.end(), box.Least, PrecedesByRow);
    column = std::find_if(column, columns.end(),
      [&](const PlanePoint& one)
      { return one.Y > box.Greatest.Y || (one.X >= box.Least.X && one.X <= box.Greatest.X); });
    return column != columns.end() && column->Y <= box.Greatest.Y;
  };
  return CollectChunks<TriangleId>(this->Mesh.Size(), Grain, Monitor(),
    [&](std::vector<TriangleId>& found, std::int64_t first, std::int64_t last)
    {
      for (auto triangle = TriangleId(first); triangle < TriangleId(last); ++triangle)
      {
        PlaneBox box;
        for (const VertexId corner : this->Mesh.Corners(triangle))
        {
          box.Add(this->Mesh.Place(corner));
        }
        box.Add(PlanePoint{ box.Least.X - 1, box.Least.Y - 1 });
        box.Add(PlanePoint{ box.Greatest.X + 1, box.Greatest.Y + 1 });
        if (isBeside(box))
        {
          found.push_back(triangle);
        }
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::HeightRange() const
{
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const HeightRaster& raster : this->Horizons.front().Rasters)
  {
    lowest = std::min(lowest, raster.LowestHeight());
    highest = std::max(highest, raster.HighestHeight());
  }
  return highest > lowest ? highest - lowest : 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
// Patches can be far apart or lie in holes of each other, so each has its own raster.
std::vector<HeightRaster> HeightMesh::MakeRasters(const double* heights) const
{
  std::vector<HeightRaster> rasters;
  const std::vector<std::int32_t>& patch = this->Patches;
  const std::vector<std::vector<PointId>> dropped = this->DroppedByPatch(std::size_t(this->PatchCount));
  const auto add = [&](std::int64_t size, auto&& pointAt)
  { rasters.emplace_back(size, pointAt, this->Places, heights, this->Horizon.Cuts.get(), dropped[rasters.size()]); };
  if (this->PatchCount == 1)
  {
    add(std::int64_t(patch.size()), [&](std::int64_t n) { return patch[n] < 0 ? NoPoint : PointId(n); });
    return rasters;
  }
  const ItemLists<PointId> points(this->PatchCount,
    [&patch](auto&& list)
    {
      for (std::size_t point = 0; point < patch.size(); ++point)
      {
        if (patch[point] >= 0)
        {
          list(patch[point], PointId(point));
        }
      }
    });
  rasters.reserve(std::size_t(this->PatchCount));
  for (std::int32_t number = 0; number < this->PatchCount; ++number)
  {
    add(points.end(number) - points.begin(number), [&](std::int64_t n) { return points.begin(number)[n]; });
  }
  return rasters;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::vector<PointId>> HeightMesh::DroppedByPatch(std::size_t patches) const
{
  std::vector<std::vector<PointId>> dropped(patches);
  for (const DroppedPoint& one : this->Horizon.Dropped)
  {
    dropped[std::size_t(this->Patches[one.Target])].push_back(one.Point);
  }
  return dropped;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<VertexId> HeightMesh::VerticesByPoint() const
{
  std::vector<VertexId> vertices(this->Marks.size(), NoVertex);
  for (VertexId vertex = 0; vertex < this->EndOfVertices(); ++vertex)
  {
    if (!this->IsRemoved(vertex))
    {
      vertices[std::size_t(this->Sources[vertex])] = vertex;
    }
  }
  return vertices;
}

//----------------------------------------------------------------------------------------------------------------------
VertexId HeightMesh::CornerOf(TriangleId triangle, PointId point) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const VertexId vertex = this->Mesh.Corner(triangle, corner);
    if (this->Sources[vertex] == point)
    {
      return vertex;
    }
  }
  return NoVertex;
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::Insert(
  PointId point, TriangleId triangle, const PlaneMesh::Room& room, std::vector<TriangleId>& around)
{
  assert(!this->IsVertex(point) && this->HasPoint(point));
  this->Mesh.Insert(this->Places[point], triangle, room, around);
  if (!around.empty())
  {
    this->SetVertex(room.Vertex, point);
    this->Mesh.Legalize(around);
  }
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMesh::Room HeightMesh::AddRoom(std::size_t vertices)
{
  this->AddVertices(vertices);
  return this->Mesh.AddRoom(vertices);
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::CloseGaps(
  const PlaneMesh::Room& first, std::vector<TriangleId>& changed, const std::vector<unsigned char>& isChanged)
{
  auto next = std::size_t(first.Vertex);
  for (std::size_t vertex = next; vertex < this->Sources.size(); ++vertex)
  {
    if (this->Sources[vertex] != NoPoint)
    {
      this->Sources[next] = this->Sources[vertex];
      for (RaisedHorizon& raised : this->Horizons)
      {
        raised.Vertices[next] = raised.Vertices[vertex];
      }
      ++next;
    }
  }
  this->Sources.resize(next);
  this->AreOnLoops.resize(next);
  this->AreFixed.resize(next);
  for (RaisedHorizon& raised : this->Horizons)
  {
    raised.Vertices.resize(next);
  }
  this->Mesh.CloseGaps(first, changed, isChanged);
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::AddVertices(std::size_t vertices)
{
  const std::size_t size = this->Sources.size() + vertices;
  this->Sources.resize(size, NoPoint);
  this->AreOnLoops.resize(size, 0);
  this->AreFixed.resize(size, 0);
  for (RaisedHorizon& raised : this->Horizons)
  {
    raised.Vertices.resize(size);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::SetVertex(VertexId vertex, PointId point)
{
  this->Marks[point] = 1;
  this->Sources[vertex] = point;
  for (RaisedHorizon& raised : this->Horizons)
  {
    raised.Vertices[vertex] = { this->Places[point], this->HeightOfVertex(raised.Heights, point) };
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::PutBack(VertexId vertex)
{
  for (RaisedHorizon& raised : this->Horizons)
  {
    raised.Vertices[vertex].Height = this->HeightOfVertex(raised.Heights, this->Sources[vertex]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::Replace(
  std::vector<PointId> sources, const std::vector<std::vector<double>>& heights, const RawVector<VertexId>& triangles)
{
  assert(sources.size() == this->Sources.size() && heights.size() == this->NumberOfHorizons());
  for (std::size_t vertex = 0; vertex < sources.size(); ++vertex)
  {
    if (this->Sources[vertex] != NoPoint && this->Sources[vertex] != sources[vertex])
    {
      this->Marks[this->Sources[vertex]] = 0;
    }
  }
  this->Sources = std::move(sources);
  this->Removed = 0;
  std::vector<PlanePoint> places;
  places.reserve(this->Sources.size());
  for (std::size_t vertex = 0; vertex < this->Sources.size(); ++vertex)
  {
    const PointId source = this->Sources[vertex];
    places.push_back(source == NoPoint ? this->Raised(VertexId(vertex)).Column : this->Places[source]);
    for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
    {
      this->Horizons[horizon].Vertices[vertex] = { places.back(), heights[horizon][vertex] };
    }
    if (source == NoPoint)
    {
      ++this->Removed;
    }
    else
    {
      this->Marks[source] = 1;
    }
  }
  this->Mesh.Replace(std::move(places), triangles);
  this->SortVertices();
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::SortVertices()
{
  std::vector<VertexId> order;
  order.reserve(this->NumberOfVertices());
  for (VertexId vertex = 0; vertex < this->EndOfVertices(); ++vertex)
  {
    if (!this->IsRemoved(vertex))
    {
      order.push_back(vertex);
    }
  }
  ParallelSort(order, [this](VertexId a, VertexId b) { return this->Sources[a] < this->Sources[b]; });
  this->Mesh.ReorderVertices(order);
  this->Sources = Gather<std::vector<PointId>>(this->Sources, order);
  this->AreOnLoops = Gather<std::vector<unsigned char>>(this->AreOnLoops, order);
  this->AreFixed = Gather<std::vector<unsigned char>>(this->AreFixed, order);
  for (RaisedHorizon& raised : this->Horizons)
  {
    raised.Vertices = Gather<std::vector<RaisedPoint>>(raised.Vertices, order);
  }
  this->Removed = 0;
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::SortByPlace()
{
  this->SortVertices();
  this->Mesh.SortByPlace();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<VertexId> HeightMesh::InnerVertices() const
{
  std::vector<VertexId> vertices;
  for (VertexId vertex = 0; vertex < this->EndOfVertices(); ++vertex)
  {
    if (!this->IsOnLoop(vertex) && !this->IsRemoved(vertex))
    {
      vertices.push_back(vertex);
    }
  }
  return vertices;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<InnerHeights> HeightMesh::HeightsOf(const std::vector<VertexId>& vertices) const
{
  std::vector<InnerHeights> heights(this->NumberOfHorizons(), InnerHeights{ vertices, {} });
  for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
  {
    std::transform(vertices.begin(), vertices.end(), std::back_inserter(heights[horizon].Heights),
      [&](VertexId vertex) { return this->Height(horizon, vertex); });
  }
  return heights;
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::SetAllHeights(const std::vector<InnerHeights>& heights)
{
  assert(heights.size() == this->NumberOfHorizons());
  for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
  {
    const InnerHeights& inner = heights[horizon];
    assert(inner.Vertices.size() == inner.Heights.size());
    for (std::size_t n = 0; n < inner.Vertices.size(); ++n)
    {
      this->Horizons[horizon].Vertices[inner.Vertices[n]].Height = inner.Heights[n];
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Measuring>
void HeightMesh::MeasureEach(const std::vector<TriangleId>& triangles, const Monitor& monitor, Measuring&& measure)
{
  this->Errors.resize(std::size_t(this->Mesh.Size()));
  ParallelFor(std::int64_t(triangles.size()), TrianglesPerTask, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const TriangleId triangle = triangles[n];
        this->Errors[triangle] = measure(triangle);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::Measure(
  const std::vector<TriangleId>& triangles, const ErrorSquares& squares, double bound, const Monitor& monitor)
{
  this->MeasureEach(triangles, monitor,
    [&](TriangleId triangle)
    {
      if (squares.AreSummed)
      {
        return this->RasterOf(triangle).Measure(this->RaisedCorners(triangle), squares);
      }
      HeightError largest;
      for (std::size_t horizon = 0; horizon < this->NumberOfHorizons(); ++horizon)
      {
        const HeightError error =
          this->RasterOf(horizon, triangle).MeasureAbove(this->RaisedCorners(horizon, triangle), bound);
        largest = error.Largest > largest.Largest ? error : largest;
      }
      return largest;
    });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::FindPoints(const std::vector<TriangleId>& triangles, double bound)
{
  this->MeasureEach(triangles, Monitor(),
    [&](TriangleId triangle)
    {
      HeightError error = this->Errors[triangle];
      if (error.Point == NoPoint)
      {
        error.Point = this->RasterOf(triangle).FindPoint(this->RaisedCorners(triangle), error.Largest, bound);
      }
      return error;
    });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::MeasureEdges(
  const std::vector<TriangleId>& triangles, double bound, bool isEachOnce, const Monitor& monitor)
{
  this->MeasureEach(
    triangles, monitor, [&](TriangleId triangle) { return this->EdgesError(triangle, bound, isEachOnce); });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::MeasureMarked(const std::vector<TriangleId>& triangles, const std::vector<unsigned char>& marks)
{
  this->MeasureEach(triangles, Monitor(),
    [&](TriangleId triangle)
    {
      HeightError error;
      double most = -1.0;
      this->RasterOf(triangle).ForEachColumn(this->RaisedCorners(triangle),
        [&](PointId point, double, const std::array<double, 3>& weights)
        {
          const double least = *std::min_element(weights.begin(), weights.end());
          if (marks[point] != 0 && !this->IsVertex(point) && least > most)
          {
            most = least;
            error = { 1.0, point };
          }
        });
      return error;
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TriangleId> HeightMesh::AllTriangles() const
{
  std::vector<TriangleId> all(std::size_t(this->Mesh.Size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

//----------------------------------------------------------------------------------------------------------------------
// Errors up to the bound are ignored.
HeightError HeightMesh::EdgesError(TriangleId triangle, double bound, bool isEachOnce) const
{
  HeightError error = this->Errors[triangle];
  for (std::size_t horizon = 0; horizon < this->NumberOfHorizons(); ++horizon)
  {
    const HeightRaster& raster = this->RasterOf(horizon, triangle);
    for (int edge = 0; edge < 3; ++edge)
    {
      const TriangleId beyond = this->Mesh.Neighbour(triangle, edge);
      const RaisedPoint& from = this->Raised(horizon, this->Mesh.Corner(triangle, edge));
      const RaisedPoint& to = this->Raised(horizon, this->Mesh.Corner(triangle, NextCorner(edge)));
      if (beyond != NoTriangle && (beyond > triangle || !isEachOnce) && !raster.IsEdgeWithin(from, to, bound))
      {
        const HeightError ofEdge = raster.MeasureEdge(from, to, this->Marks);
        error = ofEdge.Largest > std::max(bound, error.Largest) ? ofEdge : error;
      }
    }
  }
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::LargestError() const
{
  const auto largest = std::max_element(this->Errors.begin(), this->Errors.end(),
    [](const HeightError& a, const HeightError& b) { return a.Largest < b.Largest; });
  return largest == this->Errors.end() ? 0.0 : largest->Largest;
}

//----------------------------------------------------------------------------------------------------------------------
EdgeColumns HeightMesh::OwnedColumns(TriangleId triangle) const
{
  EdgeColumns owned;
  owned.WithCorners = false;
  for (int corner = 0; corner < 3; ++corner)
  {
    const TriangleId beyond = this->Mesh.Neighbour(triangle, NextCorner(corner));
    owned.Opposite[corner] = beyond == NoTriangle || beyond > triangle;
  }
  return owned;
}
}
