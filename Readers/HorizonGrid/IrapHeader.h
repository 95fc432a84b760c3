// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the text and the binary form of IRAP grids share.

#ifndef SeismicHorizonsIrapHeader_h
#define SeismicHorizonsIrapHeader_h

#include "Common/Survey/SurveyLattice.h"

#include <array>

namespace SeismicHorizons
{
/// The largest coordinates of the header are left out: they are those before the rotation.
struct IrapHeader
{
  std::array<int, 2> Columns = {};
  std::array<double, 2> Steps = {};
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero();
  double Degrees = 0.0; // of the rotation, counterclockwise
  Eigen::Vector2d Centre = Eigen::Vector2d::Zero(); // of the rotation
};

/// Throws InputError when the rotation is not around the origin: programs do not agree where nodes are then.
SurveyLattice IrapLattice(const IrapHeader& header);
}

#endif
