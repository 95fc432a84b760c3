// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PartAssembly.h"

#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Decimation/MeshFit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PartAssembly::PartAssembly(const PointRows& rows, const SurfaceOptions& options, Surface& surface)
  : Rows(rows)
  , Options(options)
  , Result(surface)
{
  surface.Boundary.Boundary.ForEachPoint([this](PointId point) { this->LoopPoints.push_back(point); });
  std::sort(this->LoopPoints.begin(), this->LoopPoints.end());
  this->LoopPoints.erase(std::unique(this->LoopPoints.begin(), this->LoopPoints.end()), this->LoopPoints.end());
  this->LoopHeights.assign(this->LoopPoints.size(), 0.0);
}

//----------------------------------------------------------------------------------------------------------------------
void PartAssembly::AddHeights(const PointWindow& window, PointId first, PointId end)
{
  const auto begin = this->LoopPoints.begin();
  const auto firstLoop = std::lower_bound(begin, this->LoopPoints.end(), first);
  const auto lastLoop = std::lower_bound(firstLoop, this->LoopPoints.end(), end);
  std::transform(firstLoop, lastLoop, this->LoopHeights.begin() + (firstLoop - begin),
    [&window](PointId point) { return window.Height[std::size_t(point - window.First)]; });
}

//----------------------------------------------------------------------------------------------------------------------
void PartAssembly::Add(const SurfacePart& mesh)
{
  Piece piece;
  std::vector<PointId> points;
  for (const PartCorners& corners : mesh.Triangles)
  {
    points.insert(points.end(), corners.begin(), corners.end());
    this->Triangles.push_back(corners);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const PointId point : points)
  {
    const std::int32_t row = this->Rows.ColumnOf(point).Y;
    piece.FirstRow = std::min(piece.FirstRow, row);
    piece.LastRow = std::max(piece.LastRow, row);
    this->Vertices.emplace_back(point, mesh.Heights.at(point));
  }
  for (const auto& [key, chain] : mesh.Chains)
  {
    this->OnOutlines.insert(this->OnOutlines.end(), { chain.front(), chain.back() });
  }
  piece.End = this->Triangles.size();
  if (!mesh.Triangles.empty())
  {
    this->Pieces.push_back(piece);
  }
  std::vector<PointId>& added = this->Result.AddedToOutlines;
  added.insert(added.end(), mesh.AddedToOutlines.begin(), mesh.AddedToOutlines.end());
}

//----------------------------------------------------------------------------------------------------------------------
void PartAssembly::Finish(const TakeTargets& take, const Monitor& monitor)
{
  this->SimplifyLoops();
  std::sort(this->Vertices.begin(), this->Vertices.end());
  this->Vertices.erase(std::unique(this->Vertices.begin(), this->Vertices.end()), this->Vertices.end());
  Decimation& mesh = this->Result.Mesh;
  std::vector<RaisedPoint> raised;
  for (const auto& [point, height] : this->Vertices)
  {
    mesh.Points.Source.push_back(point);
    mesh.Points.Plane.push_back(this->Rows.ColumnOf(point));
    mesh.Points.Height.push_back(height);
    raised.push_back({ mesh.Points.Plane.back(), height });
  }
  mesh.Points.Averaged.assign(this->Vertices.size(), 0);
  mesh.Points.Boundary = this->Outlines.RenumberedBy([this](PointId point) { return this->VertexOf(point); });
  for (const PartCorners& corners : this->Triangles)
  {
    std::transform(corners.begin(), corners.end(), std::back_inserter(mesh.Triangles),
      [this](PointId point) { return this->VertexOf(point); });
  }
  if (MeshChecker::IsOn)
  {
    MeshChecker::Require(
      "MakeInParts", mesh.Points.Plane, mesh.Points.Boundary, mesh.Triangles, MeshChecker::Kind::Any);
  }
  const PlaneMesh plane(mesh.Points.Plane, mesh.Triangles);
  const double sine = SineOfDegrees(this->Options.SmallestAngle);
  for (TriangleId triangle = 0; triangle < plane.Size(); ++triangle)
  {
    mesh.NumberOfSlivers += plane.SineOf(triangle) < sine ? 1 : 0;
  }
  this->Measure(plane, raised, take, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
// Outlines of parts keep points of the boundary in their order, and so does the whole.
void PartAssembly::SimplifyLoops()
{
  const auto numberOf = [this](PointId point)
  {
    const auto found = std::lower_bound(this->LoopPoints.begin(), this->LoopPoints.end(), point);
    return PointId(found - this->LoopPoints.begin());
  };
  const auto pointOf = [this](PointId number) { return this->LoopPoints[std::size_t(number)]; };
  const Loops boundary = this->Result.Boundary.Boundary.RenumberedBy(numberOf);
  std::vector<unsigned char> isKept(this->LoopPoints.size(), 0);
  std::for_each(
    this->OnOutlines.begin(), this->OnOutlines.end(), [&](PointId point) { isKept[std::size_t(numberOf(point))] = 1; });
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    isKept[std::size_t(*boundary.begin(loop))] |= boundary.Length(loop) == 1 ? 1 : 0;
  }
  std::vector<PlanePoint> columns;
  for (std::size_t n = 0; n < isKept.size(); ++n)
  {
    columns.push_back(this->Rows.ColumnOf(this->LoopPoints[n]));
    if (isKept[n] != 0) // some have no triangle
    {
      this->Vertices.emplace_back(this->LoopPoints[n], this->LoopHeights[n]);
    }
  }
  const BoundarySimplification simplified = KeepOnly(SpacePoints(columns, this->LoopHeights, 1), boundary, isKept);
  this->Outlines = simplified.Boundary.RenumberedBy(pointOf);
  for (const DroppedPoint& dropped : simplified.Dropped)
  {
    this->Dropped.push_back({ pointOf(dropped.Point), pointOf(dropped.Target) });
  }
  this->Result.BoundaryDeviation = simplified.Deviation;
  this->Result.OutlineDeviation = simplified.OutlineDeviation;
  this->Result.OutlineHeightDeviation = simplified.HeightDeviation;
  this->Result.NumberOutside = simplified.NumberOutside;
}

//----------------------------------------------------------------------------------------------------------------------
void PartAssembly::Measure(
  const PlaneMesh& plane, const std::vector<RaisedPoint>& raised, const TakeTargets& take, const Monitor& monitor)
{
  MeshFit errors(plane, raised);
  TargetRows targets(*this, take);
  std::vector<unsigned char>& averaged = this->Result.Mesh.Points.Averaged;
  std::size_t first = 0;
  for (std::size_t n = 0; n < this->Pieces.size(); ++n)
  {
    const Piece& piece = this->Pieces[n];
    const PointWindow window = this->Rows.Read(piece.FirstRow, piece.LastRow);
    const PointId end = window.First + PointId(window.Columns.size());
    const HeightRaster raster = this->MakeRaster(window);
    targets.Add(window);
    errors.Measure(
      TriangleId(first), TriangleId(piece.End), [&raster](TriangleId) -> const HeightRaster& { return raster; },
      [&](PointId point, VertexId vertex) { targets.Set(window.First + point, PointId(vertex)); },
      monitor.Step(double(n) / double(this->Pieces.size()), double(n + 1) / double(this->Pieces.size())));
    for (PointId vertex = this->VertexOf(window.First); vertex < this->VertexOf(end); ++vertex)
    {
      const auto& [point, height] = this->Vertices[std::size_t(vertex)];
      const double own = window.Height[std::size_t(point - window.First)];
      if (averaged[std::size_t(vertex)] == 0 && height != own)
      {
        averaged[std::size_t(vertex)] = 1;
        errors.Sum += std::abs(height - own);
      }
    }
    first = piece.End;
    targets.Complete(this->Rows.FirstOf(this->FirstRowAfter(n)));
  }
  targets.Complete(this->Rows.FirstOf(this->Rows.Box().Greatest.Y + 1));
  WriteErrors(std::move(errors), this->Vertices.size(), this->Result.Mesh);
}

//----------------------------------------------------------------------------------------------------------------------
HeightRaster PartAssembly::MakeRaster(const PointWindow& window) const
{
  const PointId end = window.First + PointId(window.Columns.size());
  std::vector<PointId> dropped;
  for (auto one = this->DroppedFrom(window.First); one != this->DroppedFrom(end); ++one)
  {
    dropped.push_back(one->Point - window.First);
  }
  return RasterOfWindow(window, dropped, this->Options.Cuts, dropped);
}

//----------------------------------------------------------------------------------------------------------------------
HeightRaster RasterOfWindow(const PointWindow& window, const std::vector<PointId>& leftOut, const LinkCuts* cuts,
  const std::vector<PointId>& dropped)
{
  std::vector<unsigned char> isLeftOut(window.Columns.size(), 0);
  std::for_each(leftOut.begin(), leftOut.end(), [&](PointId point) { isLeftOut[std::size_t(point)] = 1; });
  const auto pointAt = [&](std::int64_t n)
  { return isLeftOut[std::size_t(n)] == 0 && window.HasPatch(std::size_t(n)) ? PointId(n) : NoPoint; };
  return HeightRaster(std::int64_t(isLeftOut.size()), pointAt, window.Columns, window.Height, cuts, dropped);
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t PartAssembly::FirstRowAfter(std::size_t piece) const
{
  std::int32_t first = this->Pieces[piece].LastRow + 1;
  for (std::size_t later = piece + 1; later < this->Pieces.size(); ++later)
  {
    first = std::min(first, this->Pieces[later].FirstRow);
  }
  return first;
}

//----------------------------------------------------------------------------------------------------------------------
PointId PartAssembly::VertexOf(PointId point) const
{
  const auto found = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), point,
    [](const Vertex& vertex, PointId other) { return vertex.first < other; });
  return PointId(found - this->Vertices.begin());
}

//----------------------------------------------------------------------------------------------------------------------
DroppedPoints::const_iterator PartAssembly::DroppedFrom(PointId point) const
{
  return std::lower_bound(this->Dropped.begin(), this->Dropped.end(), point,
    [](const DroppedPoint& one, PointId other) { return one.Point < other; });
}

//----------------------------------------------------------------------------------------------------------------------
void PartAssembly::TargetRows::Add(const PointWindow& window)
{
  const std::ptrdiff_t end = window.First - this->First + std::ptrdiff_t(window.Columns.size());
  this->Targets.resize(std::max(this->Targets.size(), std::size_t(std::max<std::ptrdiff_t>(0, end))), NoPoint);
}

//----------------------------------------------------------------------------------------------------------------------
void PartAssembly::TargetRows::Complete(PointId end)
{
  if (end <= this->First)
  {
    return;
  }
  const auto size = std::size_t(end - this->First);
  std::vector<PointId> rest(
    this->Targets.begin() + std::ptrdiff_t(std::min(size, this->Targets.size())), this->Targets.end());
  this->Targets.resize(size, NoPoint);
  for (PointId vertex = this->Whole.VertexOf(this->First); vertex < this->Whole.VertexOf(end); ++vertex)
  {
    this->Targets[std::size_t(this->Whole.Vertices[std::size_t(vertex)].first - this->First)] = vertex;
  }
  for (auto one = this->Whole.DroppedFrom(this->First); one != this->Whole.DroppedFrom(end); ++one)
  {
    this->Targets[std::size_t(one->Point - this->First)] = this->Whole.VertexOf(one->Target);
  }
  this->Take(this->First, this->Targets);
  this->Targets = std::move(rest);
  this->First = end;
}
}
