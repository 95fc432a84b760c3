// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsShortSteps_h
#define SeismicHorizonsShortSteps_h

#include <Eigen/Core>

#include <vector>

namespace SeismicHorizons
{
/// The two shortest steps of the lattice that different points stand on, as columns: the one that most points take to
/// their nearest neighbour, and the one to the nearest neighbour off that line. Throws InputError when all points are
/// on one line.
Eigen::Matrix2d FindShortSteps(const std::vector<Eigen::Vector2d>& points);

/// The unit that places are rounded to: the largest power of ten that some of them are all multiples of, from 0.001 to
/// 10; 0 where they have more digits.
double FindRounding(const std::vector<double>& x, const std::vector<double>& y);

/// The same for points of which so much is lost by rounding to a unit that the nearest ones tell nothing. All steps
/// between neighbours count: those of the lattice are where most of them are, and means of these have lost next to
/// nothing.
Eigen::Matrix2d FindRoundedSteps(const std::vector<Eigen::Vector2d>& points, double unit);
}

#endif
