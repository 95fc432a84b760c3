// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLineLattice_h
#define SeismicHorizonsLineLattice_h

#include "Common/Base/Monitor.h"
#include "PlaneFit.h"
#include "SurveyLattice.h"

#include <vector>

namespace SeismicHorizons
{
/// Returns the largest steps that fit all lines, so that every second or fourth line may be picked. Numbers may have
/// three decimals. Otherwise throws InputError with "crossline" or "inline".
LineNumbering FindLineNumbering(
  const std::vector<double>& crosslines, const std::vector<double>& inlines, const Monitor& monitor = Monitor());

/// Lines of the lattice have whole indices.
inline Eigen::Vector2d LineIndex(const LineNumbering& lines, double crossline, double inlineNumber)
{
  return { (crossline - lines.FirstCrossline) / lines.CrosslineStep,
    (inlineNumber - lines.FirstInline) / lines.InlineStep };
}
}

#endif
