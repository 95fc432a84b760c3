// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfacePair.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "CutData.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "HorizonCells.h"
#include "HorizonData.h"
#include "PlacedPoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVariantArray.h"

#include <algorithm>
#include <cassert>
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
BoundaryOptions OptionsAsOf(vtkPolyData* mesh, int radius)
{
  BoundaryOptions options;
  options.Radius = radius;
  const auto figure = [mesh](const char* name)
  {
    vtkDataArray* const array = FindNumbers(mesh->GetFieldData(), name);
    return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : std::nan("");
  };
  const double chosen = figure(FieldArray::ChosenRadius);
  const double smallest = figure(FieldArray::ChosenSmallestHoleSize);
  const double holes = figure(FieldArray::NumberOfHoles);
  if (chosen >= 1.0 && chosen <= LargestRadius && smallest >= 1.0 && smallest <= LargestHole && holes >= 0.0)
  {
    options.Radius = int(chosen);
    options.HoleBoundaries = holes > 0.0;
    options.SmallestHoleSize = std::int64_t(smallest);
  }
  return options;
}

/// Finds the boundary unless the horizon has loops.
BoundedHorizon ReadHorizon(const LatticePoints& points, BoundaryOptions options, const Monitor& monitor)
{
  if (points.Horizon->GetNumberOfLines() > 0)
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

void MeshHorizon(vtkPolyData* input, const BoundaryOptions& options, vtkPolyData* output, const Monitor& monitor)
{
  output->GetFieldData()->PassData(input->GetFieldData());
  const LatticePoints points =
    input->GetNumberOfLines() > 0 ? ReadPoints(input, { output }) : ReadColumns(input, { output });
  const BoundedHorizon horizon = ReadHorizon(points, options, monitor.Step(0.0, 0.5));
  Triangulation mesh = Triangulate(horizon, TriangulationOptions(), monitor.Step(0.5, 1.0));
  FaceUp(points.Lattice, mesh.Triangles);
  output->SetPoints(points.Horizon->GetPoints());
  output->GetPointData()->PassData(points.Horizon->GetPointData());
  output->SetLines(MakePolylines(horizon.Boundary));
  output->SetPolys(MakeTriangles(mesh.Triangles));
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
std::vector<unsigned char> ReadFilledPoints(vtkPolyData* data)
{
  vtkDataArray* const filled = FindNumbers(data->GetPointData(), PointArray::Filled);
  if (!filled)
  {
    return {};
  }
  std::vector<unsigned char> marks(data->GetNumberOfPoints());
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    marks[point] = filled->GetComponent(point, 0) != 0.0 ? 1 : 0;
  }
  return marks;
}

/// world coordinates
TriangleSurface ReadSurface(vtkPolyData* data, bool withFilledPoints)
{
  constexpr vtkIdType Most = vtkIdType(1) << 30; // Three edges per triangle must fit 32-bit indices.
  if (data->GetNumberOfPoints() >= Most || data->GetNumberOfPolys() >= Most)
  {
    throw InputError(std::to_string(data->GetNumberOfPoints()) + " points and " +
      std::to_string(data->GetNumberOfPolys()) + " triangles, expected less than 2^30 of each");
  }
  TriangleSurface surface;
  surface.Points.resize(data->GetNumberOfPoints());
  ForEachPoint(surface, [data](std::int64_t point, Eigen::Vector3d& place) { data->GetPoint(point, place.data()); });
  surface.Triangles = ReadOpenTriangles(data);
  if (!withFilledPoints)
  {
    surface.LeftOut = ReadFilledPoints(data);
  }
  return surface;
}

std::optional<Lattice> FindCommonLattice(vtkPolyData* reference, vtkPolyData* mesh)
{
  for (const auto& [name, data] : { std::make_pair("reference", reference), std::make_pair("mesh", mesh) })
  {
    vtkFieldData* const fields = data->GetFieldData();
    if (fields->HasArray(FieldArray::LatticeDimensions) || fields->HasArray(FieldArray::LatticeToWorld))
    {
      return PrefixErrors(name, [horizon = data]() { return ReadLattice(horizon); });
    }
  }
  return std::nullopt;
}

// ---- Units ----------------------------------------------------------------------------------------------------------

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
void ScaleToWorld(double scale, bool inWorldUnits, MeasuredPair& measured)
{
  std::transform(measured.Lattice.begin(), measured.Lattice.end(), measured.World.begin(),
    [scale](const DistanceFigures& figures) { return ScaledBy(figures, scale); });
  if (inWorldUnits)
  {
    for (std::vector<double>* const distances : { &measured.Points.Reference.Distance, &measured.Points.Mesh.Distance })
    {
      std::transform(distances->begin(), distances->end(), distances->begin(), [scale](double d) { return scale * d; });
    }
  }
}

void TakeWorld(SurfaceDistance& inWorld, bool inWorldUnits, MeasuredPair& measured)
{
  measured.World = FiguresOf(inWorld);
  if (inWorldUnits)
  {
    measured.Points.Reference.Distance.swap(inWorld.Reference.Distance);
    measured.Points.Mesh.Distance.swap(inWorld.Mesh.Distance);
  }
}

// ---- Figures --------------------------------------------------------------------------------------------------------

constexpr std::array<const char*, Directions> DirectionNames = { "Reference to mesh", "Mesh to reference",
  "Two-sided" };

// Field data tuples and table rows have this order of units.
constexpr std::size_t WorldUnit = 1;
constexpr std::size_t DiagonalUnit = 2;
constexpr std::array<const char*, 3> UnitNames = { "Lattice", "World", "Diagonal" };

using DistanceFigure = std::pair<std::string, double>;

/// The diagonal is in lattice units.
std::vector<DistanceFigure> ListFigures(const MeasuredPair& measured, std::size_t direction, std::size_t unit)
{
  const DistanceFigures& figures = (unit == WorldUnit ? measured.World : measured.Lattice)[direction];
  std::vector<DistanceFigure> list = { { FieldArray::LargestDistance, figures.Largest },
    { FieldArray::LargestDistanceFound, figures.LargestFound }, { FieldArray::MeanDistance, figures.Mean },
    { FieldArray::RmsDistance, figures.Rms } };
  for (std::size_t n = 0; n < Percentiles.size(); ++n)
  {
    list.emplace_back(FieldArray::DistancePercentile + std::to_string(Percentiles[n]), figures.Percentile[n]);
  }
  list.emplace_back(FieldArray::OutlineDistance, figures.Outline);
  for (DistanceFigure& figure : list)
  {
    figure.second = unit == DiagonalUnit ? figure.second / measured.Diagonal : figure.second;
  }
  return list;
}

template <typename Array>
void AddColumn(const std::string& name, vtkTable* table)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  table->AddColumn(column);
}

void AppendRow(const std::vector<vtkVariant>& values, vtkTable* table)
{
  vtkNew<vtkVariantArray> row;
  std::for_each(values.begin(), values.end(), [&row](const vtkVariant& value) { row->InsertNextValue(value); });
  assert(row->GetNumberOfValues() == table->GetNumberOfColumns());
  table->InsertNextRow(row);
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor)
{
  if (IsMesh(pair.Reference) || pair.Reference->GetNumberOfPoints() == 0)
  {
    pair.ReferenceOutput->ShallowCopy(pair.Reference);
    return;
  }
  PrefixErrors(
    "reference", [&]() { MeshHorizon(pair.Reference, OptionsAsOf(pair.Mesh, radius), pair.ReferenceOutput, monitor); });
}

//----------------------------------------------------------------------------------------------------------------------
MeasuredPair MeasureSurfaces(const HorizonPair& pair, const SurfaceDistanceOptions& options, bool inWorldUnits,
  bool withFilledPoints, const Monitor& monitor)
{
  TriangleSurface reference =
    PrefixErrors("reference", [&]() { return ReadSurface(pair.ReferenceOutput, withFilledPoints); });
  TriangleSurface mesh = PrefixErrors("mesh", [&]() { return ReadSurface(pair.Mesh, withFilledPoints); });
  CheckSurface(reference, "reference");
  CheckSurface(mesh, "mesh");
  const std::optional<Lattice> lattice = FindCommonLattice(pair.Reference, pair.Mesh);
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
  std::vector<SurfaceDistance> distances = MeasureSurfaceDistances(reference, mesh, metrics, options, monitor);
  MeasuredPair measured;
  measured.Points = std::move(distances.front());
  measured.Lattice = FiguresOf(measured.Points);
  measured.World = measured.Lattice;
  measured.Diagonal = MeasureDiagonal(reference);
  measured.Surfaces = { MeasureGrading(reference), MeasureGrading(mesh) };
  if (lattice)
  {
    const double step = (lattice->ToWorld({ 0, 0, 1 }) - lattice->ToWorld({ 0, 0, 0 })).z();
    measured.Upwards = inWorldUnits ? step : step < 0.0 ? -1.0 : 1.0;
    isUniform ? ScaleToWorld(scale, inWorldUnits, measured) : TakeWorld(distances.back(), inWorldUnits, measured);
  }
  return measured;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFigures(const MeasuredPair& measured, std::size_t surface, vtkPolyData* output)
{
  assert(surface < measured.Surfaces.size());
  const std::vector<DistanceFigure> names = ListFigures(measured, 0, 0);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    auto array = NewArray<vtkDoubleArray>(names[n].first.c_str(), vtkIdType(Directions), int(UnitNames.size()));
    for (std::size_t unit = 0; unit < UnitNames.size(); ++unit)
    {
      array->SetComponentName(vtkIdType(unit), UnitNames[unit]);
      for (std::size_t direction = 0; direction < Directions; ++direction)
      {
        array->SetComponent(vtkIdType(direction), int(unit), ListFigures(measured, direction, unit)[n].second);
      }
    }
    output->GetFieldData()->AddArray(array);
  }
  auto array = NewArray<vtkDoubleArray>(FieldArray::Grading, 1, 2);
  array->SetComponentName(0, "Median");
  array->SetComponentName(1, "Percentile95");
  array->SetTuple2(0, measured.Surfaces[surface].Median, measured.Surfaces[surface].Percentile95);
  output->GetFieldData()->AddArray(array);
}

//----------------------------------------------------------------------------------------------------------------------
void MakeColumns(vtkTable* figures, vtkTable* bins)
{
  for (const char* const name : { "Horizon", "Direction", "Unit" })
  {
    AddColumn<vtkStringArray>(name, figures);
  }
  for (const DistanceFigure& figure : ListFigures(MeasuredPair(), 0, 0))
  {
    AddColumn<vtkDoubleArray>(figure.first, figures);
  }
  AddColumn<vtkDoubleArray>("GradingMedian", figures);
  AddColumn<vtkDoubleArray>("Grading95", figures);
  AddColumn<vtkIdTypeArray>("Samples", figures);
  AddColumn<vtkStringArray>("Horizon", bins);
  AddColumn<vtkStringArray>("Unit", bins);
  AddColumn<vtkDoubleArray>("bin_extents", bins); // ParaView's charts expect this name for their x axis.
  AddColumn<vtkDoubleArray>("Area (%)", bins);
}

//----------------------------------------------------------------------------------------------------------------------
void AppendRows(
  const MeasuredPair& measured, bool inWorldUnits, const std::string& horizon, vtkTable* figures, vtkTable* bins)
{
  for (std::size_t unit = 0; unit < UnitNames.size(); ++unit)
  {
    for (std::size_t direction = 0; direction < Directions; ++direction)
    {
      std::vector<vtkVariant> row = { horizon.c_str(), DirectionNames[direction], UnitNames[unit] };
      for (const DistanceFigure& figure : ListFigures(measured, direction, unit))
      {
        row.emplace_back(figure.second);
      }
      const bool ofOne = direction < measured.Surfaces.size();
      row.emplace_back(ofOne ? measured.Surfaces[direction].Median : NoValue);
      row.emplace_back(ofOne ? measured.Surfaces[direction].Percentile95 : NoValue);
      row.emplace_back(vtkIdType(measured.Lattice[direction].Samples)); // All units have the same samples.
      AppendRow(row, figures);
    }
  }
  const DistanceFigures& both = (inWorldUnits ? measured.World : measured.Lattice).back();
  const double width = both.Percentile.back() / double(DistanceBins - 1);
  for (std::size_t bin = 0; bin < DistanceBins; ++bin)
  {
    AppendRow(
      { horizon.c_str(), UnitNames[inWorldUnits ? WorldUnit : 0], width * double(bin), 100.0 * both.Share[bin] }, bins);
  }
}
}
