// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsIrapHeader_h
#define SeismicHorizonsIrapHeader_h

#include "Common/Survey/SurveyLattice.h"

#include <array>

namespace SeismicHorizons
{
/// The largest coordinates of the header are ignored, since they hold before the rotation.
struct IrapHeader
{
  std::array<int, 2> Columns = {};
  std::array<double, 2> Steps = {};
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero();
  double Degrees = 0.0; // counterclockwise
  Eigen::Vector2d Centre = Eigen::Vector2d::Zero(); // of the rotation
};

/// Throws InputError if the rotation is not around the origin, because programs disagree on its meaning.
SurveyLattice IrapLattice(const IrapHeader& header);
}

#endif
