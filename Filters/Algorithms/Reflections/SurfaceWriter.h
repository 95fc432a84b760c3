// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurfaceWriter_h
#define SeismicHorizonsSurfaceWriter_h

#include "Common/RawVector.h"
#include "Reflection.h"
#include "ReflectionExtraction.h"
#include "ReflectionFinder.h"
#include "TraceCube.h"

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
/// Writes the largest surfaces, and their number, to the result. `surfaces` has for each pick of a sign the number of a
/// pick that its surface is named by, or NoPoint; it is used up. Of the picks of a surface in one column that of the
/// largest mean amplitude stays, of equal ones the upper. Thicknesses and amplitudes are found once more in the cube.
void WriteSurfaces(const TraceCube& cube, const CubeReflections& reflections,
  std::array<RawVector<PointId>, 2>& surfaces, std::int64_t smallestSize, std::int64_t largestNumber,
  Extraction& result, const Monitor& monitor);
}

#endif
