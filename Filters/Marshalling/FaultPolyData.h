// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault lines as polylines of VTK: those that are given, and those that are shown; fault surfaces as triangles.

#ifndef SeismicHorizonsFaultPolyData_h
#define SeismicHorizonsFaultPolyData_h

#include "Common/Lattice.h"
#include "Faults/FaultLines.h"
#include "Faults/FaultSurfaces.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace SeismicHorizons
{
/// The polylines of a vtkPolyData, or of all of them in a composite dataset, in world coordinates; polygons are closed.
/// What sticks of one fault have in common is the text in the cell array FaultName but for its last word, which is the
/// number of the stick, and the dataset. Throws InputError on datasets of another kind.
std::vector<FaultStick> ReadPolylines(vtkDataObject* lines);

/// The same on a lattice, seen from above.
std::vector<FaultPolyline> ToMap(const std::vector<FaultStick>& lines, const Lattice& lattice);

/// From world coordinates to columns and vertical indices.
void ToLattice(std::vector<FaultSheet>& sheets, const Lattice& lattice);

/// Makes `output` the triangles of sheets. Cell data: FaultName.
void WriteFaultSheets(const std::vector<FaultSheet>& sheets, vtkPolyData* output);

/// Makes `output` a polyline for each fault line: from its first corner through the middles of the links that it cuts
/// to its last corner. Point data: Throw, how much higher the left of the line is than its right; cell data: FaultLine,
/// its number. Where no height is known near a link, the next one along the line counts, or else `height`.
void WriteFaultLines(const FaultLines& lines, const Lattice& lattice, double height, vtkPolyData* output);
}

#endif
