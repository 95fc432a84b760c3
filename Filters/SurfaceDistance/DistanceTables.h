// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDistanceTables_h
#define SeismicHorizonsDistanceTables_h

#include "Common/Horizon/DataArray.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"

#include <array>
#include <cstddef>
#include <string>

namespace SeismicHorizons
{
/// Directions are reference to mesh, mesh to reference, and both.
constexpr std::size_t Directions = 3;
constexpr std::array<const char*, Directions> DirectionNames = { "Reference to mesh", "Mesh to reference",
  "Two-sided" };

// Field data tuples and table rows have this order of units.
constexpr std::size_t WorldUnit = 1;
constexpr std::array<const char*, 3> UnitNames = { "Steps", "World", "Diagonal" };

struct FiguresOfPair
{
  std::array<DistanceFigures, Directions> Lattice;
  std::array<DistanceFigures, Directions> World;
  double Diagonal = 0.0; // of the reference, in lattice units
  std::array<Grading, 2> Surfaces; // reference, mesh
};

struct DistanceTables
{
  ArrayTable Figures;
  ArrayTable Histogram;
};

/// Writes figures in all units; `surface` is 0 for the reference and 1 for the mesh.
void WriteFigures(const FiguresOfPair& figures, std::size_t surface, ArrayTable& data);

/// All columns without rows.
DistanceTables MakeEmptyTables();

DistanceTables MakeTables(const FiguresOfPair& figures, bool inWorldUnits, const std::string& horizon);
}

#endif
