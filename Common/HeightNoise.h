// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The error within which a mesh passes over the noise of a horizon, where none is given.

#ifndef SeismicHorizonsHeightNoise_h
#define SeismicHorizonsHeightNoise_h

#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The value of a maximum error that stands for one that is chosen.
constexpr double AutomaticError = -1.0;

/// Six times the noise of heights, in their unit: few points of normal noise are farther off than three deviations, on
/// both sides of the mesh.
///
/// The noise is that of second differences, along rows or along columns, whichever is rougher: heights that were
/// interpolated between lines are smooth one way. A mesh can follow what neighbours have in common, which these
/// differences leave out. It is at least what rounding does: the least difference of neighbours,
/// at most 1, over the root of 12. Where no three neighbours follow each other, columns farther apart are compared. Of
/// many points a part is looked at.
double ChooseMaximumError(PlanePoints columns, const std::vector<double>& heights);
}

#endif
