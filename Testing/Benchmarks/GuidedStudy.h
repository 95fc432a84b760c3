// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of ReflectionStudy on guided horizons.

#ifndef SeismicHorizonsGuidedStudy_h
#define SeismicHorizonsGuidedStudy_h

#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Generator/CubeGenerator.h"

#include <vector>

namespace SeismicHorizons
{
Extraction ExtractFrom(
  const CubeGenerator& cube, const ExtractionOptions& options, const std::vector<Guide>& guides = {});

void PrintGuidedStudy(int cubes);
}

#endif
