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
/// The first line, and the largest step of which all lines are multiples away from it: lines that are picked at every
/// second or fourth only have such a step. Numbers may have up to three decimals. Throws InputError, with `name`, on
/// others.
struct LineSteps
{
  double First = 0.0;
  double Step = 1.0; // 1 where there is only one line
};
LineSteps FindLineSteps(const char* name, const std::vector<double>& lines, const Monitor& monitor = Monitor());

/// Of crosslines and inlines.
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
