// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which reflections the picks of an interpreter mean.

#ifndef SeismicHorizonsGuideSeeds_h
#define SeismicHorizonsGuideSeeds_h

#include "GuidedJoining.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
struct GuideSeeds
{
  int Sign = 0; // of the reflections that the guide means: 0 positive, 1 negative
  std::vector<GuideSeed> Seeds; // in different columns
  std::int64_t OtherSign = 0; // picks that are nearer to a reflection of the other sign
  /// Numbers of picks that are near no reflection of the sign, or less near than another one in their column.
  std::vector<std::size_t> Unused;
};

/// All picks of a guide mean reflections of one sign: that which has the stronger ones nearer to them. Throws
/// InputError on a guide without picks, with one outside of the cube, with two in a column that are further apart than
/// `quarter`, and when none of them is as near as `tolerance` to a reflection.
GuideSeeds FindGuideSeeds(
  const Guide& guide, const std::array<ReflectionPicks, 2>& bySign, int samples, double tolerance, double quarter);
}

#endif
