// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracePlaces.h"

#include "Common/Errors.h"
#include "Common/Lattice.h"
#include "Common/Survey/LineLattice.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/SurveyMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// The traces that have a place: x and y of 0 are none.
PickTable ListPlaces(const TraceTable& table, const LineNumbers& lines, const FieldPair& fields)
{
  PickTable picks;
  const TraceField& x = table[fields.First];
  const TraceField& y = table[fields.Second];
  const TraceField& scalar = table[TraceByte::PlaceScalar];
  for (std::int64_t trace = 0; trace < table.Traces; ++trace)
  {
    if (lines.IsUsed(trace) && (x[trace] != 0 || y[trace] != 0))
    {
      picks.Inline.push_back(lines.Inline(trace));
      picks.Crossline.push_back(lines.Crossline(trace));
      picks.X.push_back(Scaled(x[trace], scalar[trace]));
      picks.Y.push_back(Scaled(y[trace], scalar[trace]));
    }
  }
  return picks;
}

double LargestDistance(const PickTable& picks, const LineNumbering& numbering, const PlaneMap& map)
{
  const Eigen::Matrix2d toColumns = map.Steps.inverse();
  double largest = 0.0;
  for (std::size_t pick = 0; pick < picks.X.size(); ++pick)
  {
    const Eigen::Vector2d place(picks.X[pick], picks.Y[pick]);
    const Eigen::Vector2d index = LineIndex(numbering, picks.Crossline[pick], picks.Inline[pick]);
    largest = std::max(largest, (toColumns * (place - map.Origin) - index).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Throws InputError where the places of a pair of fields are on no lattice.
PlacedTraces TryFields(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const FieldPair& fields, double tolerance, const Monitor& monitor)
{
  const PickTable picks = ListPlaces(table, lines, fields);
  std::ostringstream where;
  where << "x and y of traces (bytes " << fields.First << " and " << fields.Second << ") ";
  if (picks.X.empty())
  {
    throw InputError(where.str() + "that are all 0, expected places");
  }
  PlacedTraces placed;
  placed.Fields = fields;
  placed.ToWorld = FitPlaces(picks, numbering, monitor);
  if (AreParallel(placed.ToWorld.Steps.col(0), placed.ToWorld.Steps.col(1)))
  {
    throw InputError(where.str() + "on one line, expected some that span a lattice");
  }
  placed.LargestDistance = LargestDistance(picks, numbering, placed.ToWorld);
  if (!(placed.LargestDistance <= tolerance))
  {
    where.precision(3);
    where << "up to " << placed.LargestDistance << " columns away from their columns, expected at most " << tolerance;
    throw InputError(where.str());
  }
  return placed;
}
}

//----------------------------------------------------------------------------------------------------------------------
PlacedTraces PlaceTraces(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const SEGYOptions& options, const Monitor& monitor)
{
  const FieldPair given = options.PlaceFields;
  if (given.First > 0 && given.Second > 0)
  {
    return TryFields(table, lines, numbering, given, options.Tolerance, monitor);
  }
  PlacedTraces placed;
  for (const FieldPair& fields : given.First == NoField ? std::vector<FieldPair>() : ListPlaceFields())
  {
    if (table[fields.First].IsConstant() && table[fields.Second].IsConstant())
    {
      continue;
    }
    try
    {
      return TryFields(table, lines, numbering, fields, options.Tolerance, monitor);
    }
    catch (const InputError& error)
    {
      placed.Warning += placed.Warning.empty() ? error.what() : std::string("; ") + error.what();
    }
  }
  if (!placed.Warning.empty())
  {
    placed.Warning += "; line numbers stand for x and y";
  }
  placed.Fields = { NoField, NoField };
  placed.ToWorld = LinesAsPlaces(numbering);
  return placed;
}
}
