// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDistanceReport_h
#define SeismicHorizonsDistanceReport_h

#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"

#include <array>
#include <string>

class vtkPolyData;
class vtkTable;

namespace SeismicHorizons
{
/// Directions are reference to mesh, mesh to reference, and both.
constexpr std::size_t Directions = 3;

struct DistanceReport
{
  std::array<DistanceFigures, Directions> Lattice;
  std::array<DistanceFigures, Directions> World;
  double Diagonal = 0.0; // of the reference, in lattice units
  std::array<Grading, 2> Surfaces; // reference, mesh
};

void WriteFieldData(const DistanceReport& report, const Grading& grading, vtkPolyData* output);

void MakeColumns(vtkTable* table);

void AppendRows(const DistanceReport& report, const std::string& horizon, vtkTable* table);

void MakeBinColumns(vtkTable* table);
void AppendBins(const DistanceReport& report, bool inWorldUnits, const std::string& horizon, vtkTable* table);
}

#endif
