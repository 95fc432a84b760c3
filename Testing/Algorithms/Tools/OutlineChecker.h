// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of the outlines of a radius of 1, checked with none of the code that makes them.

#ifndef SeismicHorizonsOutlineChecker_h
#define SeismicHorizonsOutlineChecker_h

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <string>
#include <vector>

namespace OutlineChecker
{
/// Outlines lead from column to neighbouring column, do not cross themselves, run clockwise from their least point, and
/// visit just those points of a patch that have the empty outside beside them; patches are connected components once
/// enclosed holes are filled. Empty when all is well, else what is wrong first.
std::string CheckOutlines(
  const std::vector<SeismicHorizons::PlanePoint>& columns, const SeismicHorizons::ExteriorBoundary& boundary);
}

#endif
