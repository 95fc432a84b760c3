// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All functions throw InputError on a horizon that breaks the data model (Documentation/DataModel.md).

#ifndef SeismicHorizonsHorizonData_h
#define SeismicHorizonsHorizonData_h

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"
#include "LatticePoints.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
Lattice ReadLattice(vtkDataObject* horizon);

/// columns along i and j, and vertical indices
std::array<int, 3> ReadLatticeDimensions(vtkDataObject* horizon);

/// Unlike ReadLattice, this does not check the matrix.
Eigen::Matrix4d ReadLatticeMap(vtkDataObject* horizon);

/// Null without the array; throws InputError on texts.
vtkDataArray* FindNumbers(vtkFieldData* data, const char* name);

/// `n` counts values through all tuples.
double FieldValue(vtkDataArray* array, int n);

/// All lines must be closed polylines, and there must be one.
Loops ReadBoundary(vtkPolyData* horizon);

/// Throws InputError on a simplified mesh, whose dropped points cannot be measured.
void RequireAllPoints(vtkPolyData* horizon);

std::vector<std::int32_t> ReadPatches(vtkPolyData* horizon);

/// Original points per point; empty if each represents one.
std::vector<std::int64_t> ReadCounts(vtkPolyData* horizon);

/// Throws InputError on polygons other than triangles.
std::vector<std::array<PointId, 3>> ReadTriangles(vtkPolyData* mesh);

/// As ReadTriangles, without triangles that close faults.
std::vector<std::array<PointId, 3>> ReadOpenTriangles(vtkPolyData* mesh);

/// Places are columns, or sub-voxels after merging. Heights and counts stay empty.
BoundedHorizon ReadPatchesAndBoundary(const LatticePoints& points);

/// Places are sub-voxels. If no point was merged, they refer to the array Column, which must outlive them.
BoundedHorizon ReadBoundedHorizon(LatticePoints points);
}

#endif
