// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonCells.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/PlacedPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr double LargestHole = 1e15; // columns

// ---- The reference as a mesh ----------------------------------------------------------------------------------------

/// Uses the outlines that vtkHorizonSurface chose for the mesh.
BoundaryOptions OptionsAsOf(const Horizon& mesh, int radius)
{
  BoundaryOptions options;
  options.Radius = radius;
  const auto figure = [&mesh](const char* name)
  {
    const DataArray* const array = FindNumbers(mesh.FieldData, name);
    return array && array->Tuples() == 1 ? array->At(0) : std::nan("");
  };
  const double chosen = figure(FieldArray::ChosenRadius);
  const double smallest = figure(FieldArray::ChosenSmallestHoleSize);
  const double holes = figure(FieldArray::NumberOfHoles);
  if (chosen >= 1.0 && chosen <= LargestRadius && smallest >= 1.0 && smallest <= LargestHole && holes >= 0.0)
  {
    options.Radius = int(chosen);
    options.KeepHoles = holes > 0.0;
    options.SmallestHoleSize = std::int64_t(smallest);
  }
  return options;
}

/// Finds the boundary unless the horizon has loops.
BoundedHorizon ReadHorizon(const LatticePoints& points, BoundaryOptions options, const Monitor& monitor)
{
  if (points.Horizon.Lines.Size() > 0)
  {
    return ReadPatchesAndBoundary(points);
  }
  const std::optional<LinkCuts> cuts = FindCuts(points.Horizon, PlaneBox(points.Column));
  options.Cuts = cuts ? &*cuts : nullptr;
  ExteriorBoundary found = FindExteriorBoundary(points.Column, options, monitor);
  BoundedHorizon horizon;
  horizon.Plane.assign(points.Column.begin(), points.Column.end());
  horizon.Patch = std::move(found.Patch);
  horizon.Boundary = std::move(found.Boundary);
  return horizon;
}

Horizon MeshHorizon(const Horizon& input, const BoundaryOptions& options, const Monitor& monitor)
{
  std::vector<Horizon> outputs(1);
  Horizon& output = outputs.front();
  output.FieldData = WithoutMeshFigures(input.FieldData);
  output.FieldData.AddAll(input.FieldData); // Figures of an earlier mesh come last.
  const LatticePoints points = input.Lines.Size() > 0 ? ReadPoints(input) : ReadColumns(input);
  WriteDeviation(points, outputs);
  const BoundedHorizon horizon = ReadHorizon(points, options, monitor.Step(0.0, 0.5));
  Triangulation mesh = Triangulate(horizon, TriangulationOptions(), monitor.Step(0.5, 1.0));
  FaceUp(points.Lattice, mesh.Triangles);
  output.Places = points.Horizon.Places;
  output.PointData = points.Horizon.PointData;
  output.Lines = MakePolylines(horizon.Boundary);
  output.Polygons = MakeTriangles(mesh.Triangles);
  return std::move(output);
}

Horizon MeshReference(const Horizon& reference, const Horizon& mesh, int radius, const Monitor& monitor)
{
  if (reference.IsMesh() || reference.NumberOfPoints() == 0)
  {
    return reference;
  }
  return PrefixErrors("reference", [&]() { return MeshHorizon(reference, OptionsAsOf(mesh, radius), monitor); });
}

// ---- Surfaces -------------------------------------------------------------------------------------------------------

template <typename Work>
void ForEachPoint(TriangleSurface& surface, Work&& work)
{
  ParallelFor(std::int64_t(surface.Points.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        work(point, surface.Points[point]);
      }
    });
}

/// Empty without the array Filled.
std::vector<unsigned char> ReadFilledPoints(const Horizon& data)
{
  const DataArray* const filled = FindNumbers(data.PointData, PointArray::Filled);
  if (!filled)
  {
    return {};
  }
  std::vector<unsigned char> marks(data.NumberOfPoints());
  for (std::int64_t point = 0; point < data.NumberOfPoints(); ++point)
  {
    marks[point] = filled->At(point) != 0.0 ? 1 : 0;
  }
  return marks;
}

/// world coordinates
TriangleSurface ReadSurface(const Horizon& data, bool withFilledPoints)
{
  constexpr std::int64_t Most = std::int64_t(1) << 30; // Three edges per triangle must fit 32-bit indices.
  if (data.NumberOfPoints() >= Most || data.Polygons.Size() >= Most)
  {
    throw InputError(std::to_string(data.NumberOfPoints()) + " points and " + std::to_string(data.Polygons.Size()) +
      " triangles, expected less than 2^30 of each");
  }
  TriangleSurface surface;
  surface.Points.resize(data.NumberOfPoints());
  ForEachPoint(surface, [&data](std::int64_t point, Eigen::Vector3d& place) { place = data.Place(point); });
  surface.Triangles = ReadOpenTriangles(data);
  if (!withFilledPoints)
  {
    surface.LeftOut = ReadFilledPoints(data);
  }
  return surface;
}

std::optional<Lattice> FindCommonLattice(const Horizon& reference, const Horizon& mesh)
{
  for (const auto& [name, data] : { std::make_pair("reference", &reference), std::make_pair("mesh", &mesh) })
  {
    const ArrayTable& fields = data->FieldData;
    if (fields.Has(FieldArray::LatticeDimensions) || fields.Has(FieldArray::LatticeToWorld))
    {
      return PrefixErrors(name, [horizon = data]() { return ReadLattice(*horizon); });
    }
  }
  return std::nullopt;
}

// ---- Units ----------------------------------------------------------------------------------------------------------

struct PairDistances
{
  SurfaceDistance Points; // distances of points, in the requested unit
  double Upwards = 1.0; // factor that makes a vertical distance positive upwards in the world, in that unit
  FiguresOfPair Figures;
};

std::array<DistanceFigures, Directions> FiguresOf(const SurfaceDistance& distance)
{
  return { distance.ReferenceToMesh, distance.MeshToReference, distance.TwoSided };
}

DistanceFigures ScaledBy(DistanceFigures figures, double scale)
{
  for (double* figure : { &figures.Largest, &figures.LargestFound, &figures.Mean, &figures.Rms, &figures.Outline })
  {
    *figure *= scale;
  }
  for (double& percentile : figures.Percentile)
  {
    percentile *= scale;
  }
  return figures;
}

/// The world has its own metric unless lattice units are uniform.
std::vector<Metric> MakeMetrics(const Lattice& lattice, bool isUniform)
{
  std::vector<Metric> metrics = { Metric() };
  if (!isUniform)
  {
    const Eigen::Vector3d origin = lattice.ToWorld({ 0, 0, 0 });
    Eigen::Matrix2d plan;
    plan << (lattice.ToWorld({ 1, 0, 0 }) - origin).head<2>(), (lattice.ToWorld({ 0, 1, 0 }) - origin).head<2>();
    metrics.emplace_back(plan, (lattice.ToWorld({ 0, 0, 1 }) - origin).z());
  }
  return metrics;
}

/// The lattice unit has the length `scale` in all directions, so that nearest places are the same.
void ScaleToWorld(double scale, bool inWorldUnits, PairDistances& measured)
{
  std::transform(measured.Figures.Lattice.begin(), measured.Figures.Lattice.end(), measured.Figures.World.begin(),
    [scale](const DistanceFigures& figures) { return ScaledBy(figures, scale); });
  if (inWorldUnits)
  {
    for (std::vector<double>* const distances : { &measured.Points.Reference.Distance, &measured.Points.Mesh.Distance })
    {
      std::transform(distances->begin(), distances->end(), distances->begin(), [scale](double d) { return scale * d; });
    }
  }
}

void TakeWorld(SurfaceDistance& inWorld, bool inWorldUnits, PairDistances& measured)
{
  measured.Figures.World = FiguresOf(inWorld);
  if (inWorldUnits)
  {
    measured.Points.Reference.Distance.swap(inWorld.Reference.Distance);
    measured.Points.Mesh.Distance.swap(inWorld.Mesh.Distance);
  }
}

// ---- Distances ------------------------------------------------------------------------------------------------------

/// Throws InputError on polygons other than triangles, and as MeasureSurfaceDistance. Without a lattice, world units are
/// used.
PairDistances MeasureMeshes(
  const Horizon& referenceMesh, const Horizon& otherMesh, const DistanceStageOptions& options, const Monitor& monitor)
{
  const auto read = [&options](const char* name, const Horizon& mesh)
  { return PrefixErrors(name, [&]() { return ReadSurface(mesh, options.IncludeFilledPoints); }); };
  TriangleSurface reference = read("reference", referenceMesh);
  TriangleSurface mesh = read("mesh", otherMesh);
  CheckSurface(reference, "reference");
  CheckSurface(mesh, "mesh");
  const std::optional<Lattice> lattice = FindCommonLattice(referenceMesh, otherMesh);
  const Eigen::Vector3d origin = reference.Points.front(); // This keeps world coordinates small.
  for (TriangleSurface* const surface : { &reference, &mesh })
  {
    ForEachPoint(*surface,
      [&](std::int64_t, Eigen::Vector3d& place)
      { place = lattice ? lattice->ToLattice(place) : Eigen::Vector3d(place - origin); });
  }
  const double scale = lattice ? lattice->UniformScale() : 1.0;
  const bool isUniform = scale > 0.0;
  const std::vector<Metric> metrics = lattice ? MakeMetrics(*lattice, isUniform) : std::vector<Metric>{ Metric() };
  SurfaceDistanceOptions sampling;
  sampling.SamplesPerPoint = options.SamplesPerPoint;
  sampling.Seed = std::uint64_t(options.Seed);
  std::vector<SurfaceDistance> distances = MeasureSurfaceDistances(reference, mesh, metrics, sampling, monitor);
  PairDistances measured;
  measured.Points = std::move(distances.front());
  measured.Figures.Lattice = FiguresOf(measured.Points);
  measured.Figures.World = measured.Figures.Lattice;
  measured.Figures.Diagonal = MeasureDiagonal(reference);
  measured.Figures.Surfaces = { MeasureGrading(reference), MeasureGrading(mesh) };
  if (lattice)
  {
    const bool inWorldUnits = options.InWorldUnits;
    const double step = (lattice->ToWorld({ 0, 0, 1 }) - lattice->ToWorld({ 0, 0, 0 })).z();
    measured.Upwards = inWorldUnits ? step : step < 0.0 ? -1.0 : 1.0;
    isUniform ? ScaleToWorld(scale, inWorldUnits, measured) : TakeWorld(distances.back(), inWorldUnits, measured);
  }
  return measured;
}

void AddDistances(PointDistances& points, double upwards, Horizon& output)
{
  std::transform(points.Vertical.begin(), points.Vertical.end(), points.Vertical.begin(),
    [upwards](double distance) { return upwards * distance; });
  MoveToArray<double>(output.PointData, PointArray::Distance, points.Distance);
  MoveToArray<double>(output.PointData, PointArray::VerticalDistance, points.Vertical);
  output.PointData.SetActiveScalars(PointArray::Distance);
}
}

//----------------------------------------------------------------------------------------------------------------------
MeasuredPair RunSurfaceDistance(const Horizon& reference, const Horizon& mesh, const std::string& name,
  const DistanceStageOptions& options, const Monitor& monitor)
{
  CheckWithin("samples per point", options.SamplesPerPoint, 0.01, 1000.0, "");
  CheckAtLeast("seed", options.Seed, 0, "");
  PrefixErrors("reference", [&]() { CheckArraySizes(reference); });
  PrefixErrors("mesh", [&]() { CheckArraySizes(mesh); });
  MeasuredPair result;
  JoinSurveys(ReadSurveyFields(reference.FieldData), mesh, { "the mesh", "the reference" }); // Meshes often have no units.
  result.Reference = MeshReference(reference, mesh, options.Radius, monitor.Step(0.0, 0.1));
  result.Mesh = mesh;
  PairDistances measured = MeasureMeshes(result.Reference, mesh, options, monitor.Step(0.1, 0.95));
  AddDistances(measured.Points.Reference, measured.Upwards, result.Reference);
  AddDistances(measured.Points.Mesh, measured.Upwards, result.Mesh);
  WriteFigures(measured.Figures, 0, result.Reference.FieldData);
  WriteFigures(measured.Figures, 1, result.Mesh.FieldData);
  result.Rows = MakeTables(measured.Figures, options.InWorldUnits, name);
  return result;
}
}
