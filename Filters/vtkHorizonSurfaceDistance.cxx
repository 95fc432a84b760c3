// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurfaceDistance.h"

#include "DataModel.h"
#include "DistanceReport.h"
#include "ExteriorBoundary.h"
#include "HorizonData.h"
#include "HorizonPairs.h"
#include "SurfaceDistance.h"
#include "Triangulation.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

constexpr int ReferencePort = 0;
constexpr int MeshPort = 1;
constexpr int TablePort = 2;

/// Runs `work`, and lets what it says of its input begin with the name of that input.
template <typename Work>
auto Naming(const char* input, Work&& work)
{
  try
  {
    return work();
  }
  catch (const InputError& error)
  {
    throw InputError(std::string(input) + ": " + error.what());
  }
}

bool HasTriangles(vtkPolyData* data)
{
  return data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
}

/// What the triangulation needs of a horizon; the boundary is found when the horizon has no loops.
BoundedHorizon ReadHorizon(vtkPolyData* input, int radius, const Monitor& monitor)
{
  LatticePoints points = ReadPoints(input);
  if (input->GetNumberOfLines() > 0)
  {
    return ReadBoundedHorizon(input, std::move(points));
  }
  BoundaryOptions options;
  options.Radius = radius;
  ExteriorBoundary found = FindExteriorBoundary(ToColumns(points), options, monitor);
  BoundedHorizon horizon;
  horizon.SubVoxelsPerColumn = points.Grid.SubVoxelsPerColumn();
  horizon.Plane = std::move(points.Plane);
  horizon.Patch = std::move(found.Patch);
  horizon.Boundary = std::move(found.Boundary);
  return horizon;
}

/// The horizon with all its points as a mesh.
void MeshHorizon(vtkPolyData* input, int radius, vtkPolyData* output, const Monitor& monitor)
{
  const BoundedHorizon horizon = ReadHorizon(input, radius, monitor.Step(0.0, 0.5));
  Triangulation mesh = Triangulate(horizon, TriangulationOptions(), monitor.Step(0.5, 1.0));
  FaceUp(ReadLattice(input), mesh.Triangles);
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  output->SetLines(MakePolylines(horizon.Boundary));
  output->SetPolys(MakeTriangles(mesh.Triangles));
}

/// A mesh in world coordinates.
TriangleSurface ReadSurface(vtkPolyData* data)
{
  if (data->GetNumberOfStrips() > 0)
  {
    throw InputError(
      std::to_string(data->GetNumberOfStrips()) + " triangle strips, expected triangles: apply Triangulate before");
  }
  TriangleSurface surface;
  surface.Points.resize(std::size_t(data->GetNumberOfPoints()));
  for (std::size_t point = 0; point < surface.Points.size(); ++point)
  {
    data->GetPoint(vtkIdType(point), surface.Points[point].data());
  }
  vtkCellArray* const polys = data->GetPolys();
  surface.Triangles.reserve(std::size_t(data->GetNumberOfPolys()));
  for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    polys->GetCellAtId(cell, size, corners);
    if (size != 3)
    {
      throw InputError("polygon " + std::to_string(cell) + " with " + std::to_string(size) +
        " corners, expected triangles: apply Triangulate before");
    }
    surface.Triangles.push_back({ PointId(corners[0]), PointId(corners[1]), PointId(corners[2]) });
  }
  return surface;
}

std::optional<SeismicHorizons::Lattice> FindLattice(vtkPolyData* reference, vtkPolyData* mesh)
{
  for (const auto& [name, data] : { std::make_pair("reference", reference), std::make_pair("mesh", mesh) })
  {
    vtkFieldData* const fields = data->GetFieldData();
    if (fields->HasArray(FieldArray::LatticeDimensions) || fields->HasArray(FieldArray::LatticeToWorld))
    {
      return Naming(name, [horizon = data]() { return ReadLattice(horizon); });
    }
  }
  return std::nullopt;
}

template <typename Map>
void MovePoints(TriangleSurface& surface, Map&& map)
{
  for (Eigen::Vector3d& point : surface.Points)
  {
    point = map(point);
  }
}

void AddArray(const char* name, std::vector<double>& values, double factor, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(vtkIdType(values.size()));
  std::transform(values.begin(), values.end(), array->GetPointer(0), [factor](double value) { return factor * value; });
  values = std::vector<double>();
  output->GetPointData()->AddArray(array);
}

std::array<DistanceFigures, Directions> FiguresOf(const SurfaceDistance& distance)
{
  return { distance.ReferenceToMesh, distance.MeshToReference, distance.TwoSided };
}

/// Gives the output the reference with triangles.
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor)
{
  if (HasTriangles(pair.Reference) || pair.Reference->GetNumberOfPoints() == 0)
  {
    pair.ReferenceOutput->ShallowCopy(pair.Reference);
    return;
  }
  Naming("reference", [&]() { MeshHorizon(pair.Reference, radius, pair.ReferenceOutput, monitor); });
}

/// Both surfaces of a pair, in world coordinates at first.
struct Surfaces
{
  TriangleSurface Reference;
  TriangleSurface Mesh;

  explicit Surfaces(const HorizonPair& pair)
    : Reference(Naming("reference", [&]() { return ReadSurface(pair.ReferenceOutput); }))
    , Mesh(Naming("mesh", [&]() { return ReadSurface(pair.Mesh); }))
  {
    CheckSurface(this->Reference, "reference");
    CheckSurface(this->Mesh, "mesh");
  }

  template <typename Map>
  void Move(Map&& map)
  {
    MovePoints(this->Reference, map);
    MovePoints(this->Mesh, map);
  }

  SurfaceDistance Measure(const SurfaceDistanceOptions& options, const Monitor& monitor) const
  {
    return MeasureSurfaceDistance(this->Reference, this->Mesh, options, monitor);
  }
};

/// Distances of points in the unit that was asked for, and the figures in all.
struct Measured
{
  SurfaceDistance Points;
  double Upwards = 1.0; // from heights on the lattice to those of the unit
  DistanceReport Report;
};

/// Without a lattice, lattice units are those of the world.
Measured Measure(Surfaces surfaces, const std::optional<SeismicHorizons::Lattice>& lattice,
  SurfaceDistanceOptions options, bool inWorldUnits, const Monitor& monitor)
{
  const Eigen::Vector3d origin = surfaces.Reference.Points.front();
  surfaces.Move([&](const Eigen::Vector3d& world)
    { return Eigen::Vector3d(lattice ? lattice->ToLattice(world) : world - origin); });
  Measured measured;
  measured.Points = surfaces.Measure(options, monitor.Step(0.0, lattice ? 0.5 : 1.0));
  DistanceReport& report = measured.Report;
  report.Lattice = FiguresOf(measured.Points);
  report.World = report.Lattice;
  report.Diagonal = MeasureDiagonal(surfaces.Reference);
  report.Surfaces = { MeasureGrading(surfaces.Reference), MeasureGrading(surfaces.Mesh) };
  if (lattice)
  {
    const double step = (lattice->ToWorld({ 0, 0, 1 }) - lattice->ToWorld({ 0, 0, 0 })).z();
    measured.Upwards = inWorldUnits ? step : step < 0.0 ? -1.0 : 1.0;
    surfaces.Move([&](const Eigen::Vector3d& place) { return Eigen::Vector3d(lattice->ToWorld(place) - origin); });
    options.Vertical = false;
    SurfaceDistance inWorld = surfaces.Measure(options, monitor.Step(0.5, 1.0));
    report.World = FiguresOf(inWorld);
    if (inWorldUnits)
    {
      measured.Points.Reference.Distance.swap(inWorld.Reference.Distance);
      measured.Points.Mesh.Distance.swap(inWorld.Mesh.Distance);
    }
  }
  return measured;
}

void AddArrays(PointDistances& points, double upwards, vtkPolyData* output)
{
  AddArray(PointArray::Distance, points.Distance, 1.0, output);
  AddArray(PointArray::VerticalDistance, points.Vertical, upwards, output);
}
}

vtkStandardNewMacro(vtkHorizonSurfaceDistance);

//------------------------------------------------------------------------------
vtkHorizonSurfaceDistance::vtkHorizonSurfaceDistance()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
void vtkHorizonSurfaceDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistanceUnit: " << (this->DistanceUnit == Lattice ? "Lattice" : "World") << "\n";
  os << indent << "SamplesPerPoint: " << this->SamplesPerPoint << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == TablePort ? "vtkTable" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (const int port : { ReferencePort, MeshPort, TablePort })
  {
    vtkDataObject* const input = port == TablePort ? nullptr : vtkDataObject::GetData(inputVector[port], 0);
    vtkDataObject* const output = vtkDataObject::GetData(outputVector, port);
    const char* const type = port == TablePort ? "vtkTable" : input ? input->GetClassName() : nullptr;
    if (type && (!output || !output->IsA(type)))
    {
      auto fresh = vtkSmartPointer<vtkDataObject>::Take(input ? input->NewInstance() : vtkTable::New());
      outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), fresh);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const reference = vtkDataObject::GetData(inputVector[ReferencePort], 0);
  vtkDataObject* const mesh = vtkDataObject::GetData(inputVector[MeshPort], 0);
  const std::vector<vtkDataObject*> outputs = { vtkDataObject::GetData(outputVector, ReferencePort),
    vtkDataObject::GetData(outputVector, MeshPort), vtkDataObject::GetData(outputVector, TablePort) };
  return this->Run(outputs,
    [&](std::string& name, const Monitor& monitor)
    {
      auto* const table = vtkTable::SafeDownCast(outputs[TablePort]);
      MakeColumns(table);
      const std::vector<HorizonPair> pairs = MatchHorizons(reference, mesh, outputs[ReferencePort], outputs[MeshPort]);
      for (std::size_t n = 0; n < pairs.size(); ++n)
      {
        name = pairs[n].Name.empty() ? std::string() : pairs[n].Name + ": ";
        if (pairs[n].Reference->GetNumberOfPoints() + pairs[n].Mesh->GetNumberOfPoints() > 0)
        {
          const double size = double(pairs.size());
          this->MeasurePair(pairs[n], table, monitor.Step(double(n) / size, double(n + 1) / size));
        }
      }
      outputs[ReferencePort]->GetFieldData()->PassData(reference->GetFieldData());
      outputs[MeshPort]->GetFieldData()->PassData(mesh->GetFieldData());
    });
}

//------------------------------------------------------------------------------
void vtkHorizonSurfaceDistance::MeasurePair(const HorizonPair& pair, vtkTable* table, const Monitor& monitor) const
{
  WriteReference(pair, this->Radius, monitor.Step(0.0, 0.1));
  pair.MeshOutput->ShallowCopy(pair.Mesh);
  SurfaceDistanceOptions options;
  options.SamplesPerPoint = this->SamplesPerPoint;
  options.Seed = std::uint64_t(this->Seed);
  Measured measured = Measure(Surfaces(pair), FindLattice(pair.Reference, pair.Mesh), options,
    this->DistanceUnit == World, monitor.Step(0.1, 0.95));
  AddArrays(measured.Points.Reference, measured.Upwards, pair.ReferenceOutput);
  AddArrays(measured.Points.Mesh, measured.Upwards, pair.MeshOutput);
  WriteFieldData(measured.Report, measured.Report.Surfaces[0], pair.ReferenceOutput);
  WriteFieldData(measured.Report, measured.Report.Surfaces[1], pair.MeshOutput);
  AppendRows(measured.Report, pair.Name, table);
}
