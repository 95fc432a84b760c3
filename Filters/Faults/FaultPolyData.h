// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultPolyData_h
#define SeismicHorizonsFaultPolyData_h

#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace SeismicHorizons
{
/// Polygons become closed polylines. Sticks of a fault have the same FaultName, apart from its last word, the number of
/// the stick, and are in the same dataset. Throws InputError on other datasets.
std::vector<FaultStick> ReadPolylines(vtkDataObject* lines);

/// Heights are dropped.
std::vector<FaultPolyline> ToMap(const std::vector<FaultStick>& lines, const Lattice& lattice);

/// Converts world coordinates to columns and vertical indices, in place.
void ToLattice(std::vector<FaultSheet>& sheets, const Lattice& lattice);

void WriteFaultSheets(const std::vector<FaultSheet>& sheets, vtkPolyData* output);

/// A polyline runs through the middles of faulted links. Throw is positive where the left side of the line is higher.
/// Links without a height take one from their line, or else `height`.
void WriteFaultLines(const FaultLines& lines, const Lattice& lattice, double height, vtkPolyData* output);
}

#endif
