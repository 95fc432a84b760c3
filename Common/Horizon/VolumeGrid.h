// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVolumeGrid_h
#define SeismicHorizonsVolumeGrid_h

#include "Horizon.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// VTK's numbers of types of cells.
namespace VolumeType
{
constexpr unsigned char Triangle = 5;
constexpr unsigned char Quad = 9;
constexpr unsigned char Tetrahedron = 10;
constexpr unsigned char Wedge = 13;
constexpr unsigned char Pyramid = 14;
}

/// The faces of a wedge, a pyramid or a tetrahedron, by its number of corners, outwards in the order of VTK.
inline const std::vector<std::vector<std::size_t>>& FacesOfCell(std::size_t corners)
{
  static const std::vector<std::vector<std::size_t>> wedge = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 },
    { 2, 5, 3, 0 } };
  static const std::vector<std::vector<std::size_t>> pyramid = { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 },
    { 3, 0, 4 } };
  static const std::vector<std::vector<std::size_t>> tetrahedron = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 },
    { 0, 2, 1 } };
  return corners == 6 ? wedge : corners == 5 ? pyramid : tetrahedron;
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
