// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsShortSteps_h
#define SeismicHorizonsShortSteps_h

#include <Eigen/Core>

#include <vector>

namespace SeismicHorizons
{
/// Columns are the step that most points take to their nearest neighbour, and the step to the nearest neighbour off
/// that line. Throws InputError if all points are on a line.
Eigen::Matrix2d FindShortSteps(const std::vector<Eigen::Vector2d>& points);

/// Returns the largest power of ten from 0.001 to 10 that divides all of some places, or 0.
double FindRounding(const std::vector<double>& x, const std::vector<double>& y);

/// With coarse rounding nearest neighbours are unreliable: of all steps between neighbours the most frequent are
/// lattice steps, and their means are accurate.
Eigen::Matrix2d FindRoundedSteps(const std::vector<Eigen::Vector2d>& points, double unit);
}

#endif
