// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells out of the plain data of the algorithms.

#ifndef SeismicHorizonsHorizonCells_h
#define SeismicHorizonsHorizonCells_h

#include "Common/Lattice.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "Common/VTK/DataArrays.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <vector>

class vtkCellArray;

namespace SeismicHorizons
{
/// One closed polyline for each loop: its last point is its first one again.
vtkSmartPointer<vtkCellArray> MakePolylines(const Loops& loops);
vtkSmartPointer<vtkCellArray> MakeTriangles(const RawVector<PointId>& triangles);

/// Adds an array with a value for each triangle of a mesh, whose polylines come first and have nan.
template <typename Array, typename Values>
void AddTriangleArray(const char* name, const Values& values, vtkPolyData* mesh)
{
  auto array = NewArray<Array>(name, mesh->GetNumberOfCells());
  auto* const triangles = array->GetPointer(mesh->GetNumberOfLines());
  std::fill(array->GetPointer(0), triangles, std::numeric_limits<typename Array::ValueType>::quiet_NaN());
  std::copy(values.begin(), values.end(), triangles);
  mesh->GetCellData()->AddArray(array);
}

/// Turns triangles that are counter-clockwise on a lattice so that they are in the world.
void FaceUp(const Lattice& lattice, RawVector<PointId>& triangles);

/// Adds triangles that are counter-clockwise on the lattice to a mesh that has its loops: facing up in the world, with
/// Compactness and Quality as cell data. `plane` holds the places of the vertices. Gives the smallest angle in degrees.
double WriteTriangles(
  const std::vector<PlanePoint>& plane, const Lattice& lattice, RawVector<PointId> triangles, vtkPolyData* mesh);
}

#endif
