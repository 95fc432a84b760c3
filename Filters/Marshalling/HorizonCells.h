// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonCells_h
#define SeismicHorizonsHorizonCells_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/Triangulation/TriangleQuality.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

class vtkCellArray;

namespace SeismicHorizons
{
/// Each polyline ends at its first point.
vtkSmartPointer<vtkCellArray> MakePolylines(const Loops& loops);
vtkSmartPointer<vtkCellArray> MakeTriangles(const RawVector<PointId>& triangles);

/// `values` has one per triangle; the polylines, which come first, get nan.
template <typename Array, typename Values>
void AddTriangleArray(const char* name, const Values& values, vtkPolyData* mesh)
{
  assert(vtkIdType(values.size()) == mesh->GetNumberOfPolys());
  auto array = NewArray<Array>(name, mesh->GetNumberOfCells());
  auto* const triangles = array->GetPointer(mesh->GetNumberOfLines());
  std::fill(array->GetPointer(0), triangles, std::numeric_limits<typename Array::ValueType>::quiet_NaN());
  std::copy(values.begin(), values.end(), triangles);
  mesh->GetCellData()->AddArray(array);
}

/// Triangles are counter-clockwise on the lattice, and `plane` has their vertices. Returns the smallest angle in
/// degrees.
double WriteTriangles(
  const std::vector<PlanePoint>& plane, const Lattice& lattice, RawVector<PointId> triangles, vtkPolyData* mesh);
}

#endif
