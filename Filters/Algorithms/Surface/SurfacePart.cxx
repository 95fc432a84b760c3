// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfacePart.h"

#include "BandCuts.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Horizon/CoveredColumns.h"
#include "Common/Horizon/EdgeLoops.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void SurfacePart::LetGo(const std::vector<std::uint64_t>& edges, const std::set<PointId>& stay)
{
  for (const std::uint64_t key : edges)
  {
    const auto chain = this->Chains.find(key);
    if (chain != this->Chains.end())
    {
      for (const PointId point : chain->second)
      {
        if (stay.count(point) == 0)
        {
          this->Dropped.erase(point);
        }
      }
      this->Chains.erase(chain);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SurfacePart::Add(const SurfacePart& other)
{
  this->Triangles.insert(this->Triangles.end(), other.Triangles.begin(), other.Triangles.end());
  for (const auto& [point, height] : other.Heights)
  {
    this->Heights[point] = height;
  }
  this->Chains.insert(other.Chains.begin(), other.Chains.end());
  this->Dropped.insert(other.Dropped.begin(), other.Dropped.end());
  this->AddedToOutlines.insert(this->AddedToOutlines.end(), other.AddedToOutlines.begin(), other.AddedToOutlines.end());
}

//----------------------------------------------------------------------------------------------------------------------
void SurfacePart::MoveTriangles(const std::function<bool(const PartCorners&)>& isChosen, SurfacePart& other)
{
  const auto first = std::stable_partition(
    this->Triangles.begin(), this->Triangles.end(), [&](const PartCorners& corners) { return !isChosen(corners); });
  const auto addHeights = [this](auto begin, auto end, std::unordered_map<PointId, double>& heights)
  {
    for (auto corners = begin; corners != end; ++corners)
    {
      std::for_each(
        corners->begin(), corners->end(), [&](PointId corner) { heights.emplace(corner, this->Heights.at(corner)); });
    }
  };
  std::unordered_map<PointId, double> rest;
  addHeights(this->Triangles.begin(), first, rest);
  addHeights(first, this->Triangles.end(), other.Heights);
  other.Triangles.insert(other.Triangles.end(), first, this->Triangles.end());
  this->Triangles.erase(first, this->Triangles.end());
  this->Heights = std::move(rest);
}

//----------------------------------------------------------------------------------------------------------------------
void SurfacePart::Write(ByteBuffer& bytes) const
{
  bytes.WriteAll(this->Triangles);
  bytes.Write(this->Heights.size());
  for (const auto& [point, height] : this->Heights)
  {
    bytes.Write(point);
    bytes.Write(height);
  }
  bytes.Write(this->Chains.size());
  for (const auto& [key, chain] : this->Chains)
  {
    bytes.Write(key);
    bytes.WriteAll(chain);
  }
  bytes.WriteAll(this->Dropped);
  bytes.WriteAll(this->Locked);
  bytes.WriteAll(this->AddedToOutlines);
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart SurfacePart::Read(ByteBuffer& bytes)
{
  SurfacePart part;
  part.Triangles = bytes.ReadAll<PartCorners>();
  for (auto left = bytes.Read<std::size_t>(); left > 0; --left)
  {
    const auto point = bytes.Read<PointId>();
    part.Heights.emplace(point, bytes.Read<double>());
  }
  for (auto left = bytes.Read<std::size_t>(); left > 0; --left)
  {
    const auto key = bytes.Read<std::uint64_t>();
    part.Chains.emplace(key, bytes.ReadAll<PointId>());
  }
  for (std::unordered_set<PointId>* const points : { &part.Dropped, &part.Locked })
  {
    const std::vector<PointId> all = bytes.ReadAll<PointId>();
    points->insert(all.begin(), all.end());
  }
  part.AddedToOutlines = bytes.ReadAll<PointId>();
  return part;
}

//----------------------------------------------------------------------------------------------------------------------
PartMesher::PartMesher(const PointRows& rows, const SurfaceOptions& options, const SurfaceParameters& parameters,
  const std::unordered_set<PointId>& shared)
  : Rows(rows)
  , Options(options)
  , Shared(shared)
  , Reach(std::int32_t(std::ceil(parameters.OutlineTolerance)) + 1)
{
}

//----------------------------------------------------------------------------------------------------------------------
PointWindow PartMesher::Read(std::int32_t firstRow, std::int32_t lastRow) const
{
  return this->Rows.Read(firstRow - this->Reach, lastRow + this->Reach);
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart PartMesher::Mesh(PointWindow window, PartBoundary boundary, const Monitor& monitor) const
{
  Loops loops = JoinEdges(std::move(boundary.Edges));
  for (const PointId point : boundary.LoopsOfOne)
  {
    loops.Append(point);
    loops.Close();
  }
  if (loops.Size() == 0)
  {
    return {};
  }
  loops.ForEachPoint(
    [&](PointId point)
    {
      if (this->Shared.count(point) > 0)
      {
        boundary.Fixed.insert(point);
      }
    });
  PartPoints points = this->Select(window, loops, boundary.Dropped);
  window = PointWindow();
  KnownBoundary known;
  known.Boundary = loops.RenumberedBy([&points](PointId point) { return points.NumberOf(point); });
  known.Dropped = std::move(points.Beside);
  std::transform(boundary.Fixed.begin(), boundary.Fixed.end(), std::back_inserter(known.Fixed),
    [&points](PointId point) { return points.NumberOf(point); });
  for (const auto& [point, height] : boundary.Locked)
  {
    known.Locked.push_back({ points.NumberOf(point), height });
  }
  const Loops exact = known.Boundary;
  const Surface made = MakePart({ points.Columns, std::move(points.Height) }, this->Options, std::move(known), monitor);
  return ToPart(points, exact, made);
}

//----------------------------------------------------------------------------------------------------------------------
PartMesher::PartPoints PartMesher::Select(
  const PointWindow& window, const Loops& loops, const std::set<PointId>& dropped) const
{
  const PointId first = window.First;
  const std::vector<State> states =
    this->FindStates(window, loops.RenumberedBy([first](PointId point) { return point - first; }), dropped);
  PartPoints points;
  points.Own = CollectChunks<PointId>(std::int64_t(states.size()), ChunkSize, Monitor(),
    [&](std::vector<PointId>& some, std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        if (states[std::size_t(n)] != State::Away)
        {
          some.push_back(first + PointId(n));
        }
      }
    });
  const std::size_t size = points.Own.size();
  points.IsInside.resize(size);
  points.Columns.resize(size);
  points.Height.resize(size);
  points.Beside = CollectChunks<DroppedPoint>(std::int64_t(size), ChunkSize, Monitor(),
    [&](DroppedPoints& beside, std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t point = begin; point < end; ++point)
      {
        const auto n = std::size_t(points.Own[std::size_t(point)] - first);
        points.IsInside[std::size_t(point)] = states[n] == State::Inside ? 1 : 0;
        points.Columns[std::size_t(point)] = window.Columns[n];
        points.Height[std::size_t(point)] = window.Height[n];
        if (states[n] == State::Beside)
        {
          beside.push_back({ PointId(point), NoPoint });
        }
      }
    });
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
SurfacePart PartMesher::ToPart(const PartPoints& points, const Loops& exact, const Surface& made)
{
  SurfacePart part;
  const std::vector<PointId>& sources = made.Mesh.Points.Source;
  const auto ownAt = [&](PointId point) { return points.Own[std::size_t(point)]; };
  const auto sourceOf = [&](PointId vertex) { return sources[std::size_t(vertex)]; };
  for (std::size_t corner = 0; corner < made.Mesh.Triangles.size(); corner += 3)
  {
    const PointId* const corners = made.Mesh.Triangles.data() + corner;
    part.Triangles.push_back({ ownAt(sourceOf(corners[0])), ownAt(sourceOf(corners[1])), ownAt(sourceOf(corners[2])) });
  }
  for (std::size_t vertex = 0; vertex < sources.size(); ++vertex)
  {
    part.Heights.emplace(ownAt(sources[vertex]), made.Mesh.Points.Height[vertex]);
  }
  ForEachChain(exact, made.Mesh.Points.Boundary.RenumberedBy(sourceOf), points.Own.size(),
    [&](std::vector<PointId> chain)
    {
      std::transform(chain.begin(), chain.end(), chain.begin(), ownAt);
      const std::uint64_t key = EdgeKeyOf(chain.front(), chain.back());
      part.Chains.emplace(key, std::move(chain));
    });
  for (const DroppedPoint& dropped : made.Dropped)
  {
    if (points.IsInside[std::size_t(dropped.Point)] != 0)
    {
      part.Dropped.insert(ownAt(dropped.Point));
    }
  }
  std::transform(
    made.AddedToOutlines.begin(), made.AddedToOutlines.end(), std::back_inserter(part.AddedToOutlines), ownAt);
  return part;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PartMesher::State> PartMesher::FindStates(
  const PointWindow& window, const Loops& loops, const std::set<PointId>& dropped) const
{
  const auto at = [&window](PointId point) { return window.Columns[std::size_t(point)]; };
  std::vector<State> states(window.Columns.size(), State::Away);
  loops.ForEachEdge([&](PointId from, PointId to) { this->AddBeside(window, at(from), at(to), states); });
  const std::vector<unsigned char> isCovered = CoveredColumns(window.Columns, loops, 1).Mark(window.Columns);
  std::transform(isCovered.begin(), isCovered.end(), states.begin(), states.begin(),
    [](unsigned char covered, State state) { return covered != 0 ? State::Inside : state; });
  for (const PointId point : dropped)
  {
    states[std::size_t(point - window.First)] = State::Beside;
  }
  loops.ForEachEdge(
    [&](PointId from, PointId to)
    {
      ForEachColumnBetween(at(from), at(to),
        [&](const PlanePoint& between, double)
        {
          const auto column = std::lower_bound(window.Columns.begin(), window.Columns.end(), between, PrecedesByRow);
          if (column != window.Columns.end() && *column == between)
          {
            states[std::size_t(column - window.Columns.begin())] = State::Beside;
          }
        });
    });
  loops.ForEachPoint([&](PointId point) { states[std::size_t(point)] = State::Inside; });
  return states;
}

//----------------------------------------------------------------------------------------------------------------------
// Takes points within reach of an edge, and some more.
void PartMesher::AddBeside(
  const PointWindow& window, const PlanePoint& from, const PlanePoint& to, std::vector<State>& states) const
{
  PlaneBox box;
  box.Add(from);
  box.Add(to);
  const double perRow = from.Y == to.Y ? 0.0 : (double(to.X) - from.X) / (double(to.Y) - from.Y);
  for (std::int32_t row = box.Least.Y - this->Reach; row <= box.Greatest.Y + this->Reach; ++row)
  {
    const auto xAt = [&](std::int32_t y)
    { return from.X + perRow * (double(std::clamp(y, box.Least.Y, box.Greatest.Y)) - from.Y); };
    const double x = xAt(row - this->Reach);
    const double otherX = from.Y == to.Y ? to.X : xAt(row + this->Reach);
    const PlanePoint first{ std::int32_t(std::floor(std::min(x, otherX))) - this->Reach, row };
    const double last = std::max(x, otherX) + this->Reach;
    for (auto column = std::lower_bound(window.Columns.begin(), window.Columns.end(), first, PrecedesByRow);
         column != window.Columns.end() && column->Y == row && column->X <= last; ++column)
    {
      const auto n = std::size_t(column - window.Columns.begin());
      states[n] = window.HasPatch(n) ? State::Beside : State::Away;
    }
  }
}
}
