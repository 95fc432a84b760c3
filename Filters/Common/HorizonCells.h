// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonCells_h
#define SeismicHorizonsHorizonCells_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Triangulation/TriangleQuality.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// Each polyline ends at its first point.
Cells MakePolylines(const Loops& loops);
Cells MakeTriangles(const RawVector<PointId>& triangles);

/// `values` has one per triangle; the polylines, which come first, get nan.
template <typename T, typename Values>
void AddTriangleArray(const char* name, const Values& values, Horizon& mesh)
{
  assert(std::int64_t(values.size()) == mesh.Polygons.Size());
  DataArray array = NewArray<T>(name, mesh.NumberOfCells());
  T* const triangles = array.As<T>() + mesh.Lines.Size();
  std::fill(array.As<T>(), triangles, std::numeric_limits<T>::quiet_NaN());
  std::copy(values.begin(), values.end(), triangles);
  mesh.CellData.Add(std::move(array));
}

/// Triangles are counter-clockwise on the lattice, and `plane` has their vertices. Returns the smallest angle in
/// degrees.
double WriteTriangles(
  const std::vector<PlanePoint>& plane, const Lattice& lattice, RawVector<PointId> triangles, Horizon& mesh);
}

#endif
