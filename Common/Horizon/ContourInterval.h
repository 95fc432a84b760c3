// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsContourInterval_h
#define SeismicHorizonsContourInterval_h

#include <cmath>
#include <initializer_list>

namespace SeismicHorizons
{
/// Every fifth contour, an index contour, is bold.
constexpr int IndexContours = 5;

/// Returns 1, 2, 5, 10, 20, 50 and so on, whichever gives nearest to twelve contours, by ratio. The range is positive.
inline double ChooseContourInterval(double range)
{
  const double wanted = range / 12.0;
  const double unit = std::pow(10.0, std::floor(std::log10(wanted)));
  double nearest = unit;
  for (const double digit : { 2.0, 5.0, 10.0 })
  {
    nearest =
      std::fabs(std::log(digit * unit / wanted)) < std::fabs(std::log(nearest / wanted)) ? digit * unit : nearest;
  }
  return nearest;
}
}

#endif
