// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the points of a horizon are on its lattice. All functions throw InputError on a horizon that breaks the data
// model (Documentation/DataModel.md).

#ifndef SeismicHorizonsLatticePoints_h
#define SeismicHorizonsLatticePoints_h

#include "Common/Lattice.h"
#include "Common/Types.h"

#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// The points of a horizon on their lattice.
struct LatticePoints
{
  Lattice Grid;
  std::vector<PlanePoint> Plane; // sub-voxels
  std::vector<double> Height; // lattice units
};

/// All points, none of which may be hidden (HorizonPoints.h).
LatticePoints ReadPoints(vtkPolyData* horizon);

/// How far from its column a point may stand.
enum class ColumnTolerance
{
  Hundredth, // of a column, which is far above the rounding of world coordinates; no other column could be meant
  None // beyond that rounding, as places are known in sub-voxels
};

/// The column of each of some places in sub-voxels, for stages before points leave their columns. Takes the memory of
/// the places.
std::vector<PlanePoint> ToColumns(
  std::vector<PlanePoint> plane, const Lattice& grid, ColumnTolerance tolerance = ColumnTolerance::Hundredth);
}

#endif
