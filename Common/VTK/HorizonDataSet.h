// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns the voxels of a horizon into the points that the stages work on (Documentation/DataModel.md), and adds the
// field data that datasets of any kind have.

#ifndef SeismicHorizonsHorizonDataSet_h
#define SeismicHorizonsHorizonDataSet_h

#include "Common/HorizonVoxels.h"
#include "Common/LatticePlacement.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>

class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
/// Where the voxels of a lattice lie in the world.
struct HorizonPlacement
{
  std::array<int, 3> Size = {}; // of the lattice, along i, j and k
  LatticeMatrix ToWorld = {};
  VerticalDirection Direction = VerticalDirection::Down;
  bool UseRealZ = false;

  /// The world z of a voxel: its real z with the sign of the direction, or where the map puts its vertical index.
  double Elevation(const HorizonVoxels& voxels, std::size_t voxel) const
  {
    return this->UseRealZ ? static_cast<int>(this->Direction) * voxels.RealZ[voxel]
                          : this->ToWorld[10] * voxels.K[voxel] + this->ToWorld[11];
  }
};

/// Adds the lattice, and how many voxels of the horizon were left out.
void AddHorizonFields(vtkFieldData* data, const HorizonPlacement& placement, std::int64_t droppedDuplicates);

/// Makes a point and a vertex cell of each voxel. Each array of the voxels is freed as soon as it was copied.
vtkSmartPointer<vtkPolyData> MakeHorizonPoints(HorizonVoxels voxels, const HorizonPlacement& placement);
}

#endif
