// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns the voxels of a horizon into the points that the stages work on (Documentation/DataModel.md), and adds the
// field data that datasets of any kind have.

#ifndef SeismicHorizonsHorizonDataSet_h
#define SeismicHorizonsHorizonDataSet_h

#include "Common/LatticePlacement.h"
#include "SparseMatrixParser.h"

#include "vtkSmartPointer.h"

class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
/// The world z of a voxel: its real z, or where the map puts its vertical index.
inline double ElevationOf(const HorizonVoxels& voxels, std::size_t voxel, const LatticeMatrix& toWorld, bool useRealZ)
{
  return useRealZ ? voxels.RealZ[voxel] : toWorld[10] * voxels.K[voxel] + toWorld[11];
}

/// Adds the lattice of the file, and how many voxels of the horizon were left out.
void AddHorizonFields(
  vtkFieldData* data, const SparseMatrixSize& size, const LatticeMatrix& toWorld, std::int64_t droppedDuplicates);

/// Makes a point and a vertex cell of each voxel. Each array of the voxels is freed as soon as it was copied.
vtkSmartPointer<vtkPolyData> MakeHorizonPoints(
  HorizonVoxels voxels, const SparseMatrixSize& size, const LatticeMatrix& toWorld, bool useRealZ);
}

#endif
