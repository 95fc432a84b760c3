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
struct PlacedTraces
{
  FieldPair Fields; // NoField if line numbers replace places.
  PlaceFit Fit;
  std::vector<std::string> Warnings;
};

/// Uses the first pair on a lattice, last a pair that follows the line numbers, never their copy, else line numbers.
/// Throws InputError if fields of the user have no lattice, except for a single line.
PlacedTraces PlaceTraces(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const SEGYOptions& options, bool isLine, const Monitor& monitor);

bool HasPlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace);

Eigen::Vector2d TracePlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace);

bool AreSame(const TraceTable& table, const FieldPair& fields);

/// Compares in either order, with and without the scalar.
bool AreLineNumbers(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields);

/// Recognises IBM and IEEE floats from 1 to 1e8 by their bits; as integers both would exceed 1e9.
bool AreFloats(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields);
}

#endif
