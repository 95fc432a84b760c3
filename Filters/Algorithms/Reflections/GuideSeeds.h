// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the reflections that picks of an interpreter mean.

#ifndef SeismicHorizonsGuideSeeds_h
#define SeismicHorizonsGuideSeeds_h

#include "GuidedJoining.h"
#include "ReflectionFinder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct GuideUse
{
  bool IsNegative = false; // sign of most reflections
  std::int64_t Turned = 0; // picks of the other sign that are followed, where polarity turns
  // Picks that are not used:
  std::vector<std::size_t> OnOtherSign;
  std::vector<std::size_t> NearNone; // without a reflection in tolerance
  std::vector<std::size_t> Doubled; // Another pick of their column is used.
  std::vector<std::size_t> Strays; // picks that contradict others; they are kept
  std::int64_t Shared = 0; // picks that another guide has, too
  std::size_t SharedWith = 0; // the guide that shares most
  std::int64_t Doubtful = 0; // picks dropped for their confidence
  std::int64_t Seams = 0; // pairs of neighbours more than half a period apart where no fault is
  std::int64_t Stopped = 0; // empty columns just beyond the reach of growth
};

/// Returns seeds in different columns, by sign. A guide has the sign whose stronger reflections are nearer to its picks,
/// and both if a tenth of its picks mean the other one, where most picks nearby do. Throws InputError if picks are
/// missing, outside of the cube, farther apart in a column than `quarter`, or all beyond `tolerance`.
std::array<std::vector<GuideSeed>, 2> FindGuideSeeds(const Guide& guide, const std::array<ReflectionPicks, 2>& bySign,
  int samples, double tolerance, double quarter, GuideUse& use);
}

#endif
