// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNodeFit_h
#define SeismicHorizonsNodeFit_h

#include "Common/Survey/SurveyLattice.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct GridPoint
{
  Eigen::Vector2d Place = Eigen::Vector2d::Zero();
  double Z = 0.0;
  int I = 0;
  int J = 0;
  std::int64_t Line = 0;
};

/// Throws InputError if all points are on one line, or a point is far from its node.
SurveyLattice FitLattice(const std::vector<GridPoint>& points, const std::array<int, 2>& columns);
}

#endif
