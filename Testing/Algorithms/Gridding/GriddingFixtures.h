// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks on no lattice, and lattices for them.

#ifndef GriddingFixtures_h
#define GriddingFixtures_h

#include "Common/Survey/PickWarnings.h"
#include "Filters/Algorithms/Gridding/Gridding.h"

#include <algorithm>
#include <random>
#include <string>
#include <utility>

namespace GriddingFixtures
{
using namespace SeismicHorizons;

constexpr double OriginX = 431000.0;
constexpr double OriginY = 6348000.0;

/// Picks anywhere in a square of 2 km, with a z by their place.
template <typename Height>
PickTable Scatter(int count, Height&& height)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 2000.0);
  PickTable picks;
  picks.Names = { "Top" };
  for (int n = 0; n < count; ++n)
  {
    picks.X.push_back(OriginX + place(random));
    picks.Y.push_back(OriginY + place(random));
    picks.Z.push_back(height(picks.X.back() - OriginX, picks.Y.back() - OriginY));
  }
  return picks;
}

inline double Plane(double x, double y)
{
  return 1500.0 + 0.3 * x - 0.11 * y;
}

inline GriddingOptions Turned(GriddingMethod method, double radius = 0.0)
{
  GriddingOptions options;
  options.Method = method;
  options.Radius = radius;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.Origin = { OriginX + 3.0, OriginY - 7.0 };
  options.Placement.ColumnStep = { 40.0, 17.0 };
  options.Placement.RowStep = { -12.0, 25.0 };
  return options;
}

inline Eigen::Vector2d PlaceOf(const SurveyLattice& lattice, const PlanePoint& column)
{
  return lattice.Origin + lattice.Steps() * Eigen::Vector2d(column.X, column.Y);
}

inline const HeapArray<double>& AttributeOf(const LatticeHorizon& horizon, const std::string& name)
{
  return std::find_if(horizon.Attributes.begin(), horizon.Attributes.end(),
    [&](const auto& attribute) { return attribute.first == name; })
    ->second;
}

/// Least and greatest z, also of what is not finite.
inline std::pair<double, double> RangeOf(const LatticeHorizon& horizon)
{
  std::pair<double, double> range(horizon.RealZ[0], horizon.RealZ[0]);
  for (const double z : horizon.RealZ)
  {
    range = { z >= range.first ? range.first : z, z <= range.second ? range.second : z };
  }
  return range;
}
}

#endif
