// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCubeGuides_h
#define SeismicHorizonsCubeGuides_h

#include "Common/Horizon/NamedHorizon.h"
#include "Filters/Algorithms/Reflections/GuidedJoining.h"
#include "Filters/Algorithms/Reflections/ReflectionFinder.h"
#include "ImageCube.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct GuidePicks
{
  Guide Given; // columns and samples of the cube
  std::vector<std::array<double, 3>> Places; // world coordinates of the picks
  std::size_t Outside = 0; // points outside the cube, which are not picks
  std::string FirstOutside; // the place of the first of these
};

/// Blocks, or values of the point array Horizon, separate guides; an unnamed guide is called Guide 1, and so on. Throws
/// InputError without points, on infinite places, and if no point of a guide is on the cube.
std::vector<GuidePicks> ReadGuides(const std::vector<NamedHorizon>& horizons, const ImageCube& cube);

enum class LimitSide
{
  Below, // at and after the limit, in the order of samples
  Above
};

struct ExtractionLimits
{
  TraceLimits Traces;
  std::int64_t Limited = 0; // traces with all limits
};

/// Two horizons may cross: limits are sorted by trace. Traces without a point of each are not searched. Throws
/// InputError on two points on a trace, on a horizon beyond all samples, and if no trace has all limits.
ExtractionLimits ReadLimits(const std::vector<NamedHorizon>& horizons, const ImageCube& cube, LimitSide side);
}

#endif
