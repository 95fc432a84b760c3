// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lattice of points whose line numbers are known: crosslines along i and inlines along j.

#ifndef SeismicHorizonsLineLattice_h
#define SeismicHorizonsLineLattice_h

#include "Common/Monitor.h"
#include "PlaneFit.h"
#include "SurveyLattice.h"

#include <vector>

namespace SeismicHorizons
{
/// The first crossline and inline, and the largest steps of which all lines are multiples away from them: lines that
/// are picked at every second or fourth only have such a step. Numbers may have up to three decimals. Throws
/// InputError, with "crossline" or "inline", on others.
LineNumbering FindLineNumbering(
  const std::vector<double>& crosslines, const std::vector<double>& inlines, const Monitor& monitor = Monitor());

/// The index, along i and j, of a crossline and an inline. Whole for lines of the lattice.
inline Eigen::Vector2d LineIndex(const LineNumbering& lines, double crossline, double inlineNumber)
{
  return { (crossline - lines.FirstCrossline) / lines.CrosslineStep,
    (inlineNumber - lines.FirstInline) / lines.InlineStep };
}
}

#endif
