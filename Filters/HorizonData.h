// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Between vtkPolyData and the plain data of the algorithms. All readers of input throw InputError when it breaks the
// data model (Documentation/DataModel.md).

#ifndef SeismicHorizonsHorizonData_h
#define SeismicHorizonsHorizonData_h

#include "BoundedHorizon.h"
#include "Lattice.h"
#include "RawVector.h"
#include "Types.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkCellArray;
class vtkIntArray;
class vtkPolyData;

namespace SeismicHorizons
{
/// The lattice of a horizon.
Lattice ReadLattice(vtkPolyData* horizon);

/// The points of a horizon on their lattice.
struct LatticePoints
{
  Lattice Grid;
  std::vector<PlanePoint> Plane; // sub-voxels
  std::vector<double> Height; // lattice units
};

LatticePoints ReadPoints(vtkPolyData* horizon);

/// The column of each point, for stages before points leave their columns.
std::vector<PlanePoint> ToColumns(const LatticePoints& points);

/// The boundary loops: all lines of the horizon, which must be closed polylines, at least one.
Loops ReadBoundary(vtkPolyData* horizon);

/// The patch number of each point.
std::vector<std::int32_t> ReadPatches(vtkPolyData* horizon);

/// How many points of the original horizon each point stands for: 1 when the horizon does not say.
std::vector<std::int64_t> ReadCounts(vtkPolyData* horizon);

BoundedHorizon ReadBoundedHorizon(vtkPolyData* horizon, LatticePoints points);

vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType points);
vtkSmartPointer<vtkCellArray> MakePolylines(const Loops& loops);
vtkSmartPointer<vtkCellArray> MakeTriangles(const RawVector<PointId>& triangles);

/// Turns triangles that are counter-clockwise on a lattice so that they are in the world.
void FaceUp(const Lattice& grid, RawVector<PointId>& triangles);

/// The array CellOrigin.
vtkSmartPointer<vtkIntArray> NewOriginArray(vtkIdType size);
void SetOrigin(vtkIntArray* array, vtkIdType n, const PointOrigin& origin);

/// Whether a reduction may make new points out of several old ones.
enum class Merging
{
  DropsPoints,
  AveragesPoints
};

/// Makes `output` the reduced `input`: points, vertices, loops, and all point data. PointCount is summed. At averaged
/// points floating point arrays and VerticalIndex (which is then of type double) are averaged, weighted by
/// PointCount; all other arrays, being labels, are taken from the nearest point that was merged. CellOrigin is added
/// when the reduction says where points come from.
void WriteReduction(
  vtkPolyData* input, const Lattice& grid, const Reduction& reduction, Merging merging, vtkPolyData* output);
}

#endif
