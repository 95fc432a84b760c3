// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangulationStage.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CrackData.h"
#include "Filters/Common/HorizonCells.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LedgerOutput.h"

#include <array>
#include <utility>

namespace SeismicHorizons
{
namespace
{
BoundedHorizon MakeHull(const LatticePoints& points)
{
  BoundedHorizon horizon;
  horizon.SubVoxelsPerColumn = points.Lattice.SubVoxelsPerColumn();
  horizon.Plane = ToSubVoxels(points);
  horizon.Patch.assign(horizon.Plane.size(), 0);
  horizon.Boundary = FindConvexHull(horizon.Plane);
  return horizon;
}

/// The surface is to the right of loops, so triangles are reversed.
Loops MakeLoops(const RawVector<PointId>& triangles)
{
  Loops loops;
  for (auto corner = triangles.begin(); corner != triangles.end(); corner += 3)
  {
    loops.Append(corner[0]);
    loops.Append(corner[2]);
    loops.Append(corner[1]);
    loops.Close();
  }
  return loops;
}

/// Voxels are drawn as squares at the height of the first point.
void WriteWalk(const std::vector<TracedCell>& walk, std::int32_t subVoxelsPerColumn, const Lattice& lattice,
  double height, Horizon& output)
{
  const double perSubVoxel = 1.0 / subVoxelsPerColumn; // exact
  HeapArray<double> places;
  HeapArray<std::int64_t> corners;
  HeapArray<std::int64_t> offsets = { 0 };
  for (const TracedCell& cell : walk)
  {
    const double x0 = cell.Least.X * perSubVoxel;
    const double y0 = cell.Least.Y * perSubVoxel;
    const double x1 = cell.Greatest.X * perSubVoxel;
    const double y1 = cell.Greatest.Y * perSubVoxel;
    for (const Eigen::Vector3d& corner :
      { Eigen::Vector3d(x0, y0, height), { x1, y0, height }, { x1, y1, height }, { x0, y1, height } })
    {
      const Eigen::Vector3d world = lattice.ToWorld(corner);
      corners.push_back(std::int64_t(corners.size()));
      places.append(world.data(), world.data() + 3);
    }
    offsets.push_back(std::int64_t(corners.size()));
  }
  output.Places = DataArray::Take(places, 3);
  output.Polygons = { DataArray::Take(offsets), DataArray::Take(corners) };
  AddArray<int>(output.CellData, CellArray::Dilatation, walk, [](const TracedCell& cell) { return cell.Dilatation; });
}
}

//----------------------------------------------------------------------------------------------------------------------
void RunTriangulation(
  const Horizon& given, const TriangulationStageOptions& options, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadPoints(given, KeptHeights::None);
  WriteDeviation(points, outputs);
  const Horizon& input = points.Horizon;
  const Lattice& lattice = points.Lattice;
  BoundedHorizon horizon = options.ConvexHull ? MakeHull(points) : ReadPatchesAndBoundary(points);
  monitor.Progress(0.1);
  CheckAtLeast<std::int64_t>("maximum number of triangles", options.MostTriangles, 0, " (all)");
  Triangulation mesh =
    Triangulate(horizon, { options.Strategy, std::size_t(options.MostTriangles) }, monitor.Step(0.1, 0.8));
  if (options.ConvexHull && options.MostTriangles == 0)
  {
    RemoveOutsideTriangles(horizon, mesh, options.Limits, monitor.Step(0.8, 0.85));
  }
  monitor.Progress(0.9);

  Horizon& output = outputs.front();
  output.Places = input.Places;
  output.PointData.AddAll(input.PointData);
  ActivateHeight(output);
  output.Lines = MakePolylines(horizon.Boundary);
  if (options.ConvexHull || options.MostTriangles > 0)
  {
    WriteLedger(points, KeptPoints::All(points.Column.size()),
      CoveredColumns(horizon.Plane, MakeLoops(mesh.Triangles), horizon.SubVoxelsPerColumn), output);
  }
  else if (!input.FieldData.Has(FieldArray::LedgerColumns))
  {
    WriteLedger(points, KeptPoints::All(points.Column.size()),
      CoveredColumns(horizon.Plane, horizon.Boundary, horizon.SubVoxelsPerColumn), output);
  }
  const double smallestAngle = WriteTriangles(horizon.Plane, lattice, std::move(mesh.Triangles), output);
  ArrayTable& figures = output.FieldData;
  AddValue<std::int64_t>(figures, FieldArray::TriangleCount, output.Polygons.Size());
  AddValue<std::int64_t>(figures, FieldArray::BoundaryEdgeCount, std::int64_t(mesh.BoundaryEdges));
  AddValue<std::int64_t>(figures, FieldArray::NonDelaunayEdgeCount, std::int64_t(mesh.NonDelaunayEdges));
  AddValue<double>(figures, FieldArray::SmallestAngle, smallestAngle);
  if (options.CloseFaults && !options.ConvexHull && options.MostTriangles == 0)
  {
    CloseMesh(horizon.Plane, lattice, horizon.Boundary, output, monitor.Step(0.95, 1.0));
  }
  WriteWalk(mesh.Walk, horizon.SubVoxelsPerColumn, lattice, points.HeightAt(0), outputs[1]);
}
}
