// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a horizon as grid files of other programs. Documentation/HorizonGridFormats.md describes the formats.
//
// Values and coordinates have all the digits they need, so that what is written is read as the same grid again. Throws
// InputError when the format cannot hold the grid, before anything is written, and when writing fails.

#ifndef SeismicHorizonsGridWriters_h
#define SeismicHorizonsGridWriters_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <ostream>

namespace SeismicHorizons
{
/// IRAP classic ASCII: any lattice whose steps are at right angles. Nodes without value get 9999900; the format takes
/// every value from there on for one, so that such values are refused. It has no name, unit or coordinate system.
void WriteIrapText(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// IRAP classic binary: the same in single precision, which rounds coordinates and values. Nodes without value get
/// 1e30; values from just below there on, and others that single precision does not hold, are refused.
void WriteIrapBinary(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// How far single precision moves the first node of a lattice, along x or y.
double RoundingOf(const SurveyLattice& lattice);

/// ZMAP+: any lattice whose steps are along the axes, as the format has no rotation; nodes come from the north-west, so
/// that a grid that begins elsewhere is read as one from the south-west. Nodes without value get -99999, or another
/// number that no value is near; values from 9.9e29 on are refused. It has a name, in which commas, line ends and the
/// like become blanks, and no unit or coordinate system.
void WriteZmap(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor = Monitor());

/// Whether ZMAP+ can hold the lattice, so that nothing need be resampled.
bool IsAlongAxes(const SurveyLattice& lattice);
}

#endif
