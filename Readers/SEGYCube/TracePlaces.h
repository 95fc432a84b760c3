// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTracePlaces_h
#define SeismicHorizonsTracePlaces_h

#include "Common/Survey/PlaneFit.h"
#include "TraceColumns.h"

#include <string>

namespace SeismicHorizons
{
/// Where the columns of traces are in the world.
struct PlacedTraces
{
  FieldPair Fields; // of x and y; NoField where line numbers stand for places
  PlaneMap ToWorld; // from columns
  double LargestDistance = 0.0; // of a trace to its column, in columns
  std::string Warning; // where there are places that are on no lattice
};

/// The places of the first pair of fields that has them on a lattice, by least squares; line numbers where there is
/// none. Throws InputError where the user names the fields, and they have none.
PlacedTraces PlaceTraces(const TraceTable& table, const LineNumbers& lines, const LineNumbering& numbering,
  const SEGYOptions& options, const Monitor& monitor);
}

#endif
