// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From horizons in the world to the limits between which a seismic cube is searched.

#ifndef SeismicHorizonsExtractionLimits_h
#define SeismicHorizonsExtractionLimits_h

#include "ImageCube.h"
#include "Reflections/ReflectionFinder.h"

#include <cstdint>
#include <vector>

class vtkDataObject;

namespace SeismicHorizons
{
/// Which side of a single limit is searched.
enum class LimitSide
{
  Below, // samples at the limit and those after it
  Above
};

struct ExtractionLimits
{
  TraceLimits Traces;
  std::int64_t Limited = 0; // traces with all limits
};

/// Between two horizons, whichever is the upper one on a trace, or on one side of one: datasets of points, or composite
/// ones whose blocks are horizons. Nothing is searched on traces where a horizon has no point. Throws InputError
/// on no horizon or more than two, on two points of one on the same trace, on a place that is not finite, on a horizon
/// beyond all samples, and when no trace has all limits.
ExtractionLimits ReadLimits(const std::vector<vtkDataObject*>& horizons, const ImageCube& cube, LimitSide side);
}

#endif
