// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurfacePair_h
#define SeismicHorizonsSurfacePair_h

#include "Common/Base/Monitor.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <string>

class vtkPolyData;
class vtkTable;

namespace SeismicHorizons
{
struct HorizonPair
{
  std::string Name; // empty if unnamed
  vtkSmartPointer<vtkPolyData> Reference;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> ReferenceOutput;
  vtkSmartPointer<vtkPolyData> MeshOutput;
  std::array<vtkSmartPointer<vtkTable>, 2> Rows; // rows of the pair for each table
};

/// Directions are reference to mesh, mesh to reference, and both.
constexpr std::size_t Directions = 3;

struct MeasuredPair
{
  SurfaceDistance Points; // distances of points, in the requested unit
  double Upwards = 1.0; // factor that makes a vertical distance positive upwards in the world, in that unit
  std::array<DistanceFigures, Directions> Lattice;
  std::array<DistanceFigures, Directions> World;
  double Diagonal = 0.0; // of the reference, in lattice units
  std::array<Grading, 2> Surfaces; // reference, mesh
};

/// Passes a mesh. Points are meshed inside their loops, or inside a boundary with the parameters of the other mesh,
/// or with `radius` and closed holes. Throws InputError if meshing fails.
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor);

/// Measures the output of WriteReference; figures skip filled points unless `withFilledPoints`. Without a lattice,
/// world units are used. Throws InputError on polygons other than triangles, and as MeasureSurfaceDistance.
MeasuredPair MeasureSurfaces(const HorizonPair& pair, const SurfaceDistanceOptions& options, bool inWorldUnits,
  bool withFilledPoints, const Monitor& monitor);

/// Writes figures in all units; `surface` is 0 for the reference and 1 for the mesh.
void WriteFigures(const MeasuredPair& measured, std::size_t surface, vtkPolyData* output);

void MakeColumns(vtkTable* figures, vtkTable* bins);

/// The tables have the columns of MakeColumns.
void AppendRows(
  const MeasuredPair& measured, bool inWorldUnits, const std::string& horizon, vtkTable* figures, vtkTable* bins);
}

#endif
