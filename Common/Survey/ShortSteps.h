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
}

#endif
