// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the points of a horizon are on its lattice: the one place where points are put on columns. All functions throw
// InputError on a horizon that breaks the data model (Documentation/DataModel.md).

#ifndef SeismicHorizonsLatticePoints_h
#define SeismicHorizonsLatticePoints_h

#include "Common/Lattice.h"
#include "Common/Types.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// The points of a horizon on their lattice.
struct LatticePoints
{
  /// That of one point, from its coordinates, where heights are not kept.
  double HeightAt(std::size_t point) const;

  vtkSmartPointer<vtkPolyData> Horizon; // as it was given, with the array Column, and in double precision
  SeismicHorizons::Lattice Lattice;
  PlanePoints Column; // the memory of that array; NoColumn where points were merged
  std::vector<double> Height; // lattice units; empty where they are not kept
  bool AreMerged = false; // whether any were
};

/// Whether heights are kept. Stages that look at few of them, or at none, save the memory and the time to write it.
enum class KeptHeights
{
  All,
  None
};

/// Of points none of which was merged: all stand on a column, within a hundredth of it, or within the rounding of their
/// coordinates where these are in single precision. Of a horizon without the array Column, and of one whose points do
/// not stand where the array says, the column of each point is the nearest one, and LatticeDeviation in the field data
/// of `outputs` says how far off points are at most. None of the points may be hidden (HorizonPoints.h).
LatticePoints ReadColumns(
  vtkPolyData* horizon, const std::vector<vtkPolyData*>& outputs, KeptHeights heights = KeptHeights::All);

/// The same for stages that take merged points. Of a horizon without the array Column, points are seen as merged when
/// one of them stands on no column: all but those that stand on theirs to the rounding of coordinates.
LatticePoints ReadPoints(
  vtkPolyData* horizon, const std::vector<vtkPolyData*>& outputs, KeptHeights heights = KeptHeights::All);

/// The array Column of a horizon that ReadColumns or ReadPoints gave, or that a stage made of one.
PlanePoints ColumnsOf(vtkPolyData* horizon);

/// The places in sub-voxels, also of points that were merged.
std::vector<PlanePoint> ToSubVoxels(const LatticePoints& points);
}

#endif
