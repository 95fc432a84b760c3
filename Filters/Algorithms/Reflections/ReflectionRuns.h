// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsReflectionRuns_h
#define SeismicHorizonsReflectionRuns_h

#include "Reflection.h"

#include <vector>

namespace SeismicHorizons
{
/// How the reflections of a trace are found.
struct ReflectionRules
{
  ReflectionPolarity Polarity = ReflectionPolarity::Both;
  ReflectionPosition Position = ReflectionPosition::Peak;
  /// With the middle: samples of smaller absolute amplitude belong to no run.
  float SampleThreshold = 0.0F;
};

/// Appends the reflections of a trace, downwards. Samples that are 0, missing (nan) or below the threshold end a run. A
/// peak of several equal samples is in their middle; one at an end of the trace, or beside a missing sample, is at its
/// sample; any other at the vertex of the parabola through its sample and the two beside it.
void FindReflections(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found);
}

#endif
