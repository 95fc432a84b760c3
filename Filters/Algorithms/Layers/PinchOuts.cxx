// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PinchOuts.h"

#include "Common/Base/LeastSquares.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Decimation/MeshRefiner.h"
#include "Filters/Algorithms/Decimation/PlaneMesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace SeismicHorizons
{
namespace
{
// ---- Lines ----------------------------------------------------------------------------------------------------------
class LineFinder
{
public:
  LineFinder(PlanePoints columns, const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options,
    PinchOutLines& lines)
    : Columns(columns)
    , IsOnLoop(isOnLoop)
    , Options(options)
    , Lines(lines)
  {
  }

  void Run(const std::vector<double>& upper, const std::vector<double>& lower, const Monitor& monitor)
  {
    for (std::size_t point = 0; point < this->Columns.size(); ++point)
    {
      if (upper[point] == lower[point])
      {
        this->Pinched.push_back(PointId(point));
        this->Places.push_back(this->Columns[point]);
        this->Heights.push_back(upper[point]);
      }
    }
    if (this->Pinched.empty())
    {
      return;
    }
    const Loops loops = this->FindLoops(monitor.Step(0.0, 0.5));
    const Loops simplified = this->Simplify(loops, monitor.Step(0.5, 1.0));
    this->AddLines(loops, simplified.MarkPoints(this->Pinched.size()));
  }

private:
  // Points of loops are numbered among the pinched ones.
  bool IsOnOutline(PointId point) const { return this->IsOnLoop[std::size_t(this->Pinched[std::size_t(point)])] != 0; }

  Loops FindLoops(const Monitor& monitor) const
  {
    BoundaryOptions options;
    options.KeepHoles = true;
    options.SmallestHoleSize = this->Options.SmallestPinch;
    options.MinimumPatchSize = this->Options.SmallestPinch;
    return FindExteriorBoundary(this->Places, options, monitor).Boundary;
  }

  Loops Simplify(const Loops& loops, const Monitor& monitor)
  {
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.OutlineTolerance = this->Options.Tolerance;
    options.DistanceThreshold = this->Options.MaximumError;
    options.LongestEdge = this->Options.LongestEdge;
    loops.ForEachEdge(
      [&](PointId from, PointId to)
      {
        if (this->IsOnOutline(from) != this->IsOnOutline(to))
        {
          options.Fixed.push_back(this->IsOnOutline(from) ? from : to);
          this->Lines.OnOutline.push_back(this->Pinched[std::size_t(options.Fixed.back())]);
        }
      });
    return SimplifyBoundary(SpacePoints(this->Places, this->Heights, 1), loops, options, monitor).Boundary;
  }

  /// Adds lines from each kept point to the next one, except along the outline.
  void AddLines(const Loops& loops, const std::vector<unsigned char>& isKept)
  {
    for (std::size_t loop = 0; loop < loops.Size(); ++loop)
    {
      std::vector<PointId> line; // since the last kept point
      bool isAlongOutline = true;
      const std::size_t length = loops.Length(loop);
      for (std::size_t n = 0; n < 2 * length; ++n) // the second round begins at the first kept point
      {
        const PointId point = loops.begin(loop)[n % length];
        isAlongOutline = isAlongOutline && this->IsOnOutline(point);
        line.push_back(this->Pinched[std::size_t(point)]);
        if (isKept[std::size_t(point)] == 0)
        {
          continue;
        }
        if (line.front() != line.back() && !isAlongOutline && n >= length)
        {
          this->Lines.Lines.push_back(line);
        }
        line = { line.back() };
        isAlongOutline = this->IsOnOutline(point);
      }
    }
  }

  PlanePoints Columns;
  const std::vector<unsigned char>& IsOnLoop;
  const PinchOutOptions& Options;
  PinchOutLines& Lines;
  std::vector<PointId> Pinched; // points without thickness
  std::vector<PlanePoint> Places;
  std::vector<double> Heights;
};
}

//----------------------------------------------------------------------------------------------------------------------
PinchOutLines FindPinchOutLines(PlanePoints columns, const HeightStack& heights,
  const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options, const Monitor& monitor)
{
  assert(isOnLoop.size() == columns.size() && HaveAll(heights, columns.size()));
  CheckAtLeast<std::int64_t>("smallest pinch-out", options.SmallestPinch, 1, " column");
  PinchOutLines lines;
  const auto layers = double(heights.size() - 1);
  for (std::size_t layer = 0; layer + 1 < heights.size(); ++layer)
  {
    LineFinder(columns, isOnLoop, options, lines)
      .Run(heights[layer], heights[layer + 1], monitor.Step(double(layer) / layers, double(layer + 1) / layers));
  }
  return lines;
}

// ---- Lines as edges of a plan ---------------------------------------------------------------------------------------
// Whether the line between endsOf(horizon), in the patch of a vertex, is too far from any horizon.
template <typename EndsOf>
bool KeptLines::IsAnyFar(VertexId vertex, EndsOf&& endsOf) const
{
  for (std::size_t horizon = 0; horizon < this->Mesh.NumberOfHorizons(); ++horizon)
  {
    const auto [from, to] = endsOf(horizon);
    if (!this->Mesh.RasterAt(horizon, vertex).IsEdgeWithin(from, to, this->MaximumError + this->Mesh.Rounding()))
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
void KeptLines::Keep(const PinchOutLines& lines)
{
  if (lines.Lines.empty())
  {
    return;
  }
  std::vector<Edge> edges;
  std::transform(lines.Lines.begin(), lines.Lines.end(), std::back_inserter(edges),
    [](const std::vector<PointId>& line) {
      return Edge{ line.front(), line.back() };
    });
  this->InsertEnds(edges);
  edges = this->SplitFar(lines);
  this->InsertEnds(edges);
  for (VertexId vertex = 0; vertex < this->Mesh.EndOfVertices(); ++vertex)
  {
    if (this->IsOnLine[std::size_t(this->Mesh.SourceOf(vertex))] != 0)
    {
      this->Mesh.Fix(vertex);
    }
  }
  const std::vector<VertexId> vertices = this->Mesh.VerticesByPoint();
  KeptEdges sides(this->Mesh.Triangles(), std::size_t(this->Mesh.EndOfVertices()));
  for (const Edge& edge : edges)
  {
    const VertexId from = vertices[std::size_t(edge.From)];
    const VertexId to = vertices[std::size_t(edge.To)];
    const bool isKept = from != NoVertex && to != NoVertex && sides.Keep(from, to);
    this->Lost += isKept ? 0 : 1;
  }
  this->Pieces = edges.size();
  this->Mesh.Triangles().MakeDelaunay();
  this->MarkAlong(edges);
}

//----------------------------------------------------------------------------------------------------------------------
bool KeptLines::DropFar()
{
  PlaneMesh& triangles = this->Mesh.Triangles();
  std::size_t dropped = 0;
  for (TriangleId triangle = 0; triangle < triangles.Size(); ++triangle)
  {
    for (int side = 0; side < 3; ++side)
    {
      if (triangles.IsKeptEdge(triangle, side) && this->IsFar(triangle, side))
      {
        triangles.LetGo(triangles.Corner(triangle, side), triangles.Corner(triangle, NextCorner(side)));
        ++dropped;
      }
    }
  }
  if (dropped > 0)
  {
    triangles.MakeDelaunay();
  }
  this->Lost += dropped;
  return dropped > 0;
}

//----------------------------------------------------------------------------------------------------------------------
void KeptLines::InsertEnds(const std::vector<Edge>& edges)
{
  for (const Edge& edge : edges)
  {
    this->IsOnLine[std::size_t(edge.From)] = 1;
    this->IsOnLine[std::size_t(edge.To)] = 1;
  }
  MeshRefiner(this->Mesh, 0, DecimationPriority::LargestError).InsertMarked(this->IsOnLine);
}

//----------------------------------------------------------------------------------------------------------------------
// Splits lines at points of the border if they are too far from a horizon where they cross lines between columns.
std::vector<Edge> KeptLines::SplitFar(const PinchOutLines& lines) const
{
  const std::vector<VertexId> vertices = this->Mesh.VerticesByPoint();
  std::vector<Edge> edges;
  for (const std::vector<PointId>& line : lines.Lines)
  {
    const VertexId vertex = vertices[std::size_t(line.front())];
    std::vector<std::size_t> ends = { line.size() - 1 }; // the next one last
    for (std::size_t from = 0; !ends.empty();)
    {
      const std::size_t to = ends.back();
      if (vertex != NoVertex && to > from + 1 && this->IsFar(vertex, line[from], line[to]))
      {
        ends.push_back(from + (to - from) / 2);
        continue;
      }
      edges.push_back({ line[from], line[to] });
      from = to;
      ends.pop_back();
    }
  }
  return edges;
}

//----------------------------------------------------------------------------------------------------------------------
bool KeptLines::IsFar(VertexId vertex, PointId from, PointId to) const
{
  return this->IsAnyFar(vertex,
    [&](std::size_t horizon)
    {
      const std::vector<double>& heights = this->Heights[horizon];
      return std::pair(RaisedPoint{ this->Columns[std::size_t(from)], heights[std::size_t(from)] },
        RaisedPoint{ this->Columns[std::size_t(to)], heights[std::size_t(to)] });
    });
}

//----------------------------------------------------------------------------------------------------------------------
bool KeptLines::IsFar(TriangleId triangle, int side) const
{
  assert(side >= 0 && side < 3);
  const VertexId from = this->Mesh.Triangles().Corner(triangle, side);
  const VertexId to = this->Mesh.Triangles().Corner(triangle, NextCorner(side));
  return this->IsAnyFar(from,
    [&](std::size_t horizon) { return std::pair(this->Mesh.Raised(horizon, from), this->Mesh.Raised(horizon, to)); });
}

//----------------------------------------------------------------------------------------------------------------------
void KeptLines::MarkAlong(const std::vector<Edge>& edges)
{
  for (const Edge& edge : edges)
  {
    ForEachColumnBetween(this->Columns[std::size_t(edge.From)], this->Columns[std::size_t(edge.To)],
      [&](const PlanePoint& column, double)
      {
        const PointId point = this->Index.PointAt(column);
        if (point != NoPoint)
        {
          this->IsOnLine[std::size_t(point)] = 1;
        }
      });
  }
}

namespace
{
// ---- Cutoffs --------------------------------------------------------------------------------------------------------
// Heights at the cutoffs of faults, as a throw between two columns has the noise of both.
constexpr std::int32_t CutoffReach = 2; // columns
constexpr std::size_t FewestColumns = 6; // for a plane

constexpr std::array<PlanePoint, 4> StepsAround = { PlanePoint{ 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };

class CutoffSurroundings
{
public:
  CutoffSurroundings(const ColumnIndex& index, const LinkCuts& cuts)
    : Columns(index.Columns())
    , Index(index)
    , Cuts(cuts)
  {
  }

  bool IsBesideCut(PointId point) const
  {
    return std::any_of(StepsAround.begin(), StepsAround.end(),
      [&](const PlanePoint& step) { return this->Cuts.IsCutBeside(this->Columns[std::size_t(point)], step); });
  }

  /// The points around a point on its side of all cuts. Empty around the end of a cut.
  std::vector<PointId> Find(PointId start) const
  {
    const PlanePoint& middle = this->Columns[std::size_t(start)];
    std::vector<PointId> found = { start };
    bool isAtEnd = false;
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      const PlanePoint& column = this->Columns[std::size_t(found[n])];
      for (const PlanePoint& step : StepsAround)
      {
        const PlanePoint next = { column.X + step.X, column.Y + step.Y };
        const PointId point = this->Index.PointAt(next);
        const bool isNear = std::max(std::abs(next.X - middle.X), std::abs(next.Y - middle.Y)) <= CutoffReach;
        if (isNear && point != NoPoint && !this->Cuts.IsCutBeside(column, step) &&
          std::find(found.begin(), found.end(), point) == found.end())
        {
          found.push_back(point);
        }
      }
    }
    for (const PointId point : found)
    {
      const PlanePoint& column = this->Columns[std::size_t(point)];
      for (const PlanePoint& step : StepsAround)
      {
        const PointId other = this->Index.PointAt({ column.X + step.X, column.Y + step.Y });
        isAtEnd = isAtEnd ||
          (this->Cuts.IsCutBeside(column, step) && std::find(found.begin(), found.end(), other) != found.end());
      }
    }
    return isAtEnd ? std::vector<PointId>() : found;
  }

private:
  PlanePoints Columns;
  const ColumnIndex& Index;
  const LinkCuts& Cuts;
};

/// The height at the first point of a plane through the points.
std::optional<double> PlaneHeight(
  PlanePoints columns, const std::vector<double>& heights, const std::vector<PointId>& points)
{
  Eigen::MatrixX3d places(points.size(), 3);
  Eigen::VectorXd given(points.size());
  const PlanePoint& first = columns[std::size_t(points.front())];
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const PlanePoint& column = columns[std::size_t(points[n])];
    places.row(Eigen::Index(n)) << 1.0, double(column.X - first.X), double(column.Y - first.Y);
    given[Eigen::Index(n)] = heights[std::size_t(points[n])];
  }
  const LeastSquares plane = SolveLeastSquares(places, given);
  return points.size() < FewestColumns || plane.Rank < 3 ? std::nullopt : std::optional<double>(plane.Unknowns[0]);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<InnerHeights> FitCutoffs(const HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const LinkCuts& cuts)
{
  assert(known.empty() || known.size() == heights.size());
  const PlanePoints columns = index.Columns();
  const CutoffSurroundings surroundings(index, cuts);
  std::vector<InnerHeights> fitted(heights.size());
  for (VertexId vertex = 0; vertex < mesh.EndOfVertices(); ++vertex)
  {
    const PointId source = mesh.SourceOf(vertex);
    if (!mesh.IsOnLoop(vertex) || !surroundings.IsBesideCut(source))
    {
      continue;
    }
    const std::vector<PointId> around = surroundings.Find(source);
    if (around.size() < FewestColumns)
    {
      continue;
    }
    for (std::size_t horizon = 0; horizon < heights.size(); ++horizon)
    {
      std::vector<PointId> own = around;
      if (!known.empty())
      {
        own.erase(std::remove_if(
                    own.begin(), own.end(), [&](PointId point) { return known[horizon][std::size_t(point)] == 0; }),
          own.end());
      }
      const bool isKnown = !own.empty() && own.front() == source;
      const std::optional<double> height = isKnown ? PlaneHeight(columns, heights[horizon], own) : std::nullopt;
      fitted[horizon].Vertices.push_back(vertex);
      fitted[horizon].Heights.push_back(height.value_or(mesh.Height(horizon, vertex)));
    }
  }
  return fitted;
}
}
