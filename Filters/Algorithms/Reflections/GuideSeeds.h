// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the reflections that picks of an interpreter mean.

#ifndef SeismicHorizonsGuideSeeds_h
#define SeismicHorizonsGuideSeeds_h

#include "GuidedJoining.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
struct GuideSeeds
{
  int Sign = 0; // 0 positive, 1 negative
  std::vector<GuideSeed> Seeds; // in different columns
  std::int64_t OtherSign = 0;
  /// These picks are near no reflection of the sign, or another pick of their column is nearer.
  std::vector<std::size_t> Unused;
};

/// A guide has the sign whose stronger reflections are nearer to its picks. Throws InputError if picks are missing,
/// outside of the cube, farther apart in a column than `quarter`, or all beyond `tolerance`.
GuideSeeds FindGuideSeeds(
  const Guide& guide, const std::array<ReflectionPicks, 2>& bySign, int samples, double tolerance, double quarter);
}

#endif
