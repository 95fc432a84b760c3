// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTracePlaces_h
#define SeismicHorizonsTracePlaces_h

#include "Common/Survey/PlaneFit.h"
#include "TraceColumns.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
constexpr double MostStrays = 0.1; // fraction of all places

struct PlacedTraces
{
  FieldPair Fields; // NoField if line numbers replace places.
  PlaneMap ToWorld; // Maps columns to world coordinates.
  double LargestDistance = 0.0; // In columns, without strays.
  std::int64_t Strays = 0;
  std::vector<std::string> Warnings;
};

/// Uses the first pair on a lattice, then one that follows the line numbers, never their copy, then one of irregular
/// midpoints, which least squares make a lattice; else line numbers. Up to 10 % of strays are excluded. Throws InputError
/// if fields of the user have no lattice, except for a single line.
PlacedTraces PlaceTraces(const LineNumbers& lines, const SEGYOptions& options, bool isLine, const Monitor& monitor);

/// Numbers rows and columns of the lattice of x and y, from 1, as fields of the table. Returns false if no fields, or not
/// those of the user, place all traces on one.
bool NumberByPlaces(TraceTable& table, const SEGYOptions& options, const Monitor& monitor);

/// Positions the traces of a single line, which may be curved, by their headers. Missing places, places of 0 and strays
/// are interpolated, with a warning. Places stay empty if no fields form a line.
void PlaceAlongLine(SEGYCube& cube, const LineNumbers& lines, const FieldPair& given);

/// Returns false for fillers and places of 0.
inline bool HasPlace(const LineNumbers& lines, const FieldPair& fields, std::int64_t trace)
{
  return lines.IsUsed(trace) && (lines.Table[fields.First][trace] != 0 || lines.Table[fields.Second][trace] != 0);
}

inline Eigen::Vector2d TracePlace(const TraceTable& table, const FieldPair& fields, std::int64_t trace)
{
  const int scalar = table[TraceByte::PlaceScalar][trace];
  return { Scaled(table[fields.First][trace], scalar), Scaled(table[fields.Second][trace], scalar) };
}

/// Compares in either order, with and without the scalar.
bool AreLineNumbers(const LineNumbers& lines, const FieldPair& fields);

/// Recognises IBM and IEEE floats from 1 to 1e8 by their bits; as integers both would exceed 1e9.
bool AreFloats(const LineNumbers& lines, const FieldPair& fields);
}

#endif
