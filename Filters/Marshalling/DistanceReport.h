// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The figures of a measured pair of surfaces as field data and as rows of tables.

#ifndef SeismicHorizonsDistanceReport_h
#define SeismicHorizonsDistanceReport_h

#include "SurfaceDistance/SurfaceDistance.h"

#include <array>
#include <string>

class vtkPolyData;
class vtkTable;

namespace SeismicHorizons
{
/// From the reference to the mesh, from the mesh to the reference, both.
constexpr std::size_t Directions = 3;

struct DistanceReport
{
  std::array<DistanceFigures, Directions> Lattice;
  std::array<DistanceFigures, Directions> World;
  double Diagonal = 0.0; // of the reference, in lattice units
  std::array<Grading, 2> Surfaces; // reference, mesh
};

/// Adds the figures to the field data of one of the two surfaces.
void WriteFieldData(const DistanceReport& report, const Grading& grading, vtkPolyData* output);

/// Gives a table its columns.
void MakeColumns(vtkTable* table);

/// Adds the rows of a horizon.
void AppendRows(const DistanceReport& report, const std::string& horizon, vtkTable* table);

/// The same of the table of a histogram.
void MakeBinColumns(vtkTable* table);
void AppendBins(const DistanceReport& report, bool inWorldUnits, const std::string& horizon, vtkTable* table);
}

#endif
