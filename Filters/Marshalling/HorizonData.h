// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From vtkPolyData to the plain data of the algorithms. All functions throw InputError on a horizon that breaks the
// data model (Documentation/DataModel.md).

#ifndef SeismicHorizonsHorizonData_h
#define SeismicHorizonsHorizonData_h

#include "Common/BoundedHorizon.h"
#include "Common/Lattice.h"
#include "Common/Types.h"
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
/// The lattice of a horizon or of an image.
Lattice ReadLattice(vtkDataObject* horizon);

/// Its numbers of columns along i and j, and of vertical indices.
std::array<int, 3> ReadLatticeDimensions(vtkDataObject* horizon);

/// Its map to the world, as it stands there.
Eigen::Matrix4d ReadLatticeMap(vtkDataObject* horizon);

/// An array of numbers by its name; null when there is none of that name.
vtkDataArray* FindNumbers(vtkFieldData* data, const char* name);

/// A number of a field data array, counted through all tuples.
double FieldValue(vtkDataArray* array, int n);

/// The boundary loops: all lines of the horizon, which must be closed polylines, at least one.
Loops ReadBoundary(vtkPolyData* horizon);

/// Throws InputError on a mesh whose points stand for more points than there are: how far those are from another mesh
/// could not be known.
void RequireAllPoints(vtkPolyData* horizon);

/// The patch number of each point.
std::vector<std::int32_t> ReadPatches(vtkPolyData* horizon);

/// How many points of the original horizon each point represents; empty when the horizon does not say, as each is one.
std::vector<std::int64_t> ReadCounts(vtkPolyData* horizon);

/// The corners of all polygons of a mesh, which must be triangles.
std::vector<std::array<PointId, 3>> ReadTriangles(vtkPolyData* mesh);

/// In columns, or in sub-voxels where points were merged; without heights and counts, which no mesh needs.
BoundedHorizon ReadPatchesAndBoundary(const LatticePoints& points);

/// In sub-voxels, for stages that merge points. Where none was merged before, keeps a reference to the array Column.
BoundedHorizon ReadBoundedHorizon(LatticePoints points);
}

#endif
