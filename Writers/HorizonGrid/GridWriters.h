// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Documentation/HorizonGrid.md describes the formats. Numbers have the digits that restore them exactly.
// Functions throw InputError if writing fails and, before writing, if the format cannot hold the grid.

#ifndef SeismicHorizonsGridWriters_h
#define SeismicHorizonsGridWriters_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <ostream>

namespace SeismicHorizons
{
/// Steps must be perpendicular. Null values are 9999900; larger values are null as well, and refused. There is no name,
/// unit or coordinate system.
void WriteIrapText(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// Coordinates and values are rounded to single precision. Null values are 1e30; values from just below it and out of
/// range are refused.
void WriteIrapBinary(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

double RoundingOf(const SurveyLattice& lattice);

/// Steps must be along the axes. Nodes are stored from the north-west. Null values are -99999 or a smaller number that
/// no value is near; values from 9.9e29 on are refused. The name loses commas and line ends; there is no unit.
void WriteZmap(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// Columns from the west, each from the north, at least five to a line. Null values are 1e30; values from 9.9e29 on are
/// refused.
void WriteCps3(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// Surfer 6 text: rows from the south. Null values are 1.70141e38; values from about it on are refused.
void WriteSurfer(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// Rows from the north. Null values are -9999 or a smaller number that no value is near.
void WriteEsri(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

bool IsAlongAxes(const SurveyLattice& lattice);

/// Resamples bilinearly from the south-western corner of the lattice, so that all its grids share nodes. Line numbers
/// are lost. Throws InputError for a lattice that is nearly empty, and for a result without values.
HorizonGrid MakeUpright(const HorizonGrid& grid, const Monitor& monitor = Monitor());
}

#endif
