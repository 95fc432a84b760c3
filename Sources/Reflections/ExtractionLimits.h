// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsExtractionLimits_h
#define SeismicHorizonsExtractionLimits_h

#include "Filters/Algorithms/Reflections/ReflectionFinder.h"
#include "ImageCube.h"

#include <cstdint>
#include <vector>

class vtkDataObject;

namespace SeismicHorizons
{
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
ExtractionLimits ReadLimits(const std::vector<vtkDataObject*>& horizons, const ImageCube& cube, LimitSide side);
}

#endif
