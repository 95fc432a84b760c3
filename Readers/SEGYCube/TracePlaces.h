// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTracePlaces_h
#define SeismicHorizonsTracePlaces_h

#include "PlaceFit.h"
#include "TraceColumns.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Where the columns of traces are in the world.
struct PlacedTraces
{
  FieldPair Fields; // of x and y; NoField where line numbers stand for places
  PlaceFit Fit;
  std::vector<std::string> Warnings; // of places that are on no lattice, or doubtful
};

/// The places of the first pair of fields that has them on a lattice, by least squares without up to a tenth of strays.
/// A pair that follows the line numbers counts only where no other does, and one that repeats them not at all; line
/// numbers where there is none. Throws InputError where the user names the fields, and they have none, but for a line:
/// its traces may be on no lattice.
PlacedTraces PlaceTraces(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const SEGYOptions& options, bool isLine, const Monitor& monitor);

/// Whether a trace has a place: x and y of 0 are none.
bool HasPlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace);

/// The place of a trace, by the scalar.
Eigen::Vector2d TracePlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace);

/// Whether all traces have the same x and y.
bool AreSame(const TraceTable& table, const FieldPair& fields);

/// Whether x and y of all traces are their line numbers, in either order, with the scalar or without it.
bool AreLineNumbers(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields);

/// Whether x and y are floats of IBM or IEEE by their bits, from 1 to 1e8: as integers both would be above 1e9.
bool AreFloats(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields);
}

#endif
