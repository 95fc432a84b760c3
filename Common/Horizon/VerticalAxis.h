// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights by the name that interpreters know: depth and time count downwards.

#ifndef SeismicHorizonsVerticalAxis_h
#define SeismicHorizonsVerticalAxis_h

#include <string>

namespace SeismicHorizons
{
/// Name is such as "Depth (m)", "Time (ms)", "Elevation (m)" or "Elevation time (ms)", "Depth" or "Height" without a
/// unit, and empty if the direction of z is unknown.
struct VerticalAxis
{
  std::string Name;
  std::string Unit;
  bool IsDownwards = true; ///< The axis counts -z.
  bool IsTime = false;
  double Step = 0.0; ///< Of one vertical index; 0 if it is unknown.
};

/// Names the component of arrays of heights that stages add, as a user may have arrays of the same name.
constexpr const char* HeightComponent = "height";

/// The direction is -1 if z is counted downwards, else 1.
inline VerticalAxis NameAxis(double direction, const std::string& unit, const std::string& domain)
{
  const bool isUnitOfTime = unit == "ms" || unit == "s" || unit == "us" || unit == "seconds";
  VerticalAxis axis;
  axis.Unit = unit;
  axis.IsTime = domain == "time" || (domain.empty() && isUnitOfTime);
  axis.IsDownwards = direction < 0.0;
  // "Elevation" without unit is an array of rasters with its own colours.
  const char* const upwards = axis.IsTime ? "Elevation time" : unit.empty() ? "Height" : "Elevation";
  axis.Name = !axis.IsDownwards ? upwards : axis.IsTime ? "Time" : "Depth";
  axis.Name += unit.empty() ? "" : " (" + unit + ")";
  return axis;
}
}

#endif
