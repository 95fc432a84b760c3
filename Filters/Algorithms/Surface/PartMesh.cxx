// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PartMesh.h"

#include "BandCuts.h"
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
void PartMesh::LetGo(const std::vector<std::uint64_t>& edges, const std::set<PointId>& stay)
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
void PartMesh::Add(const PartMesh& other)
{
  this->Triangles.insert(this->Triangles.end(), other.Triangles.begin(), other.Triangles.end());
  for (const auto& [point, height] : other.Heights)
  {
    this->Heights[point] = height;
  }
  this->Chains.insert(other.Chains.begin(), other.Chains.end());
  this->Dropped.insert(other.Dropped.begin(), other.Dropped.end());
  this->AddedToOutlines.insert(
    this->AddedToOutlines.end(), other.AddedToOutlines.begin(), other.AddedToOutlines.end());
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
PartMesh PartMesher::Mesh(PointWindow window, PartBoundary boundary, const Monitor& monitor) const
{
  PartMesh mesh;
  Loops loops = JoinEdges(std::move(boundary.Edges));
  for (const PointId point : boundary.LoopsOfOne)
  {
    loops.Append(point);
    loops.Close();
  }
  if (loops.Size() == 0)
  {
    return mesh;
  }
  const PointId first = window.First;
  const std::vector<State> states =
    this->FindStates(window, loops.RenumberedBy([first](PointId point) { return point - first; }), boundary.Dropped);
  std::vector<PointId> own; // points of the horizon
  std::vector<PointId> number(states.size(), NoPoint);
  std::vector<PlanePoint> columns;
  SurfacePoints points;
  PartOfSurface part;
  for (std::size_t n = 0; n < states.size(); ++n)
  {
    if (states[n] != State::Away)
    {
      number[n] = PointId(own.size());
      own.push_back(first + PointId(n));
      columns.push_back(window.Columns[n]);
      points.Height.push_back(window.Height[n]);
    }
    if (states[n] == State::Beside)
    {
      part.Dropped.push_back({ number[n], NoPoint });
    }
  }
  window = PointWindow();
  points.Columns = columns;
  const auto inPart = [&](PointId point) { return number[std::size_t(point - first)]; };
  loops.ForEachPoint(
    [&](PointId point)
    {
      if (this->Shared.count(point) > 0)
      {
        boundary.Fixed.insert(point);
      }
    });
  std::transform(boundary.Fixed.begin(), boundary.Fixed.end(), std::back_inserter(part.Fixed), inPart);
  for (const auto& [point, height] : boundary.Locked)
  {
    part.Locked.push_back({ inPart(point), height });
  }
  const Loops exact = loops.RenumberedBy(inPart);
  part.Boundary = exact;
  const Surface made = MakePart(std::move(points), this->Options, std::move(part), monitor);

  const std::vector<PointId>& sources = made.Mesh.Points.Source;
  const auto ownAt = [&](PointId vertex) { return own[std::size_t(sources[std::size_t(vertex)])]; };
  for (std::size_t corner = 0; corner < made.Mesh.Triangles.size(); corner += 3)
  {
    const PointId* const corners = made.Mesh.Triangles.data() + corner;
    mesh.Triangles.push_back({ ownAt(corners[0]), ownAt(corners[1]), ownAt(corners[2]) });
  }
  for (std::size_t vertex = 0; vertex < sources.size(); ++vertex)
  {
    mesh.Heights.emplace(ownAt(PointId(vertex)), made.Mesh.Points.Height[vertex]);
  }
  const Loops simplified =
    made.Mesh.Points.Boundary.RenumberedBy([&](PointId vertex) { return sources[std::size_t(vertex)]; });
  ForEachChain(exact, simplified, own.size(),
    [&](std::vector<PointId> chain)
    {
      std::transform(chain.begin(), chain.end(), chain.begin(), [&](PointId point) { return own[std::size_t(point)]; });
      const std::uint64_t key = EdgeKeyOf(chain.front(), chain.back());
      mesh.Chains.emplace(key, std::move(chain));
    });
  for (const DroppedPoint& dropped : made.Dropped)
  {
    const PointId point = own[std::size_t(dropped.Point)];
    if (states[std::size_t(point - first)] == State::Inside)
    {
      mesh.Dropped.insert(point);
    }
  }
  std::transform(made.AddedToOutlines.begin(), made.AddedToOutlines.end(), std::back_inserter(mesh.AddedToOutlines),
    [&](PointId point) { return own[std::size_t(point)]; });
  return mesh;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PartMesher::State> PartMesher::FindStates(
  const PointWindow& window, const Loops& loops, const std::set<PointId>& dropped) const
{
  const auto at = [&window](PointId point) { return window.Columns[std::size_t(point)]; };
  std::vector<State> states(window.Columns.size(), State::Away);
  loops.ForEachEdge([&](PointId from, PointId to) { this->AddBeside(window, at(from), at(to), states); });
  const std::vector<unsigned char> isCovered = CoveredColumns(window.Columns, loops, 1).Mark(window.Columns);
  for (std::size_t n = 0; n < states.size(); ++n)
  {
    states[n] = isCovered[n] != 0 ? State::Inside : states[n];
  }
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
          const auto column =
            std::lower_bound(window.Columns.begin(), window.Columns.end(), between, PrecedesByRow);
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
