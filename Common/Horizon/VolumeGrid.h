// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVolumeGrid_h
#define SeismicHorizonsVolumeGrid_h

#include "Horizon.h"

namespace SeismicHorizons
{
/// VTK's numbers of types of cells.
namespace VolumeType
{
constexpr unsigned char Tetrahedron = 10;
constexpr unsigned char Wedge = 13;
constexpr unsigned char Pyramid = 14;
}

/// Cells of volumes that share points, with corners in the order of VTK.
struct VolumeGrid
{
  DataArray Places; // x, y and z in the world
  SeismicHorizons::Cells Cells;
  DataArray Types; // VolumeType by cell
  ArrayTable PointData;
  ArrayTable CellData;
  ArrayTable FieldData;
};
}

#endif
