// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonTSurf_h
#define SeismicHorizonsHorizonTSurf_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Common/Survey/TSurf.h"

#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Converts triangles, colour and coordinate system; z increases in the direction of `positive`. Throws InputError
/// unless all polygons are triangles.
TSurf MakeTSurf(const Horizon& horizon, const std::string& name, VerticalPositive positive);

/// Arrays of readers and stages are included only for `withOwn`.
std::vector<TSurfProperty> ReadProperties(const Horizon& horizon, bool withOwn);

enum class WrittenArrays
{
  None,
  Picks, // without arrays of readers and stages
  All
};

struct TSurfOptions
{
  VerticalPositive Positive = VerticalPositive::Elevation;
  SurveyDescription Survey; // Empty texts are those of the horizon.
  WrittenArrays Arrays = WrittenArrays::Picks;
  bool WithBorders = false;
};

/// Repeated names get numbers.
void PrintTSurfs(
  const std::vector<NamedHorizon>& horizons, const TSurfOptions& options, std::ostream& stream, const Monitor& monitor);
}

#endif
