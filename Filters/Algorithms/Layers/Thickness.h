// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thickness of a layer, column by column: between two horizons of one lattice, where both have points.

#ifndef SeismicHorizonsThickness_h
#define SeismicHorizonsThickness_h

#include "Common/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A horizon whose points others own: the column of each, no two the same, and its height.
struct HorizonView
{
  PlanePoints Columns;
  const double* Heights = nullptr;
};

/// Columns that several horizons have, row by row from the least y, in each of them by x.
struct CommonColumns
{
  std::vector<PlanePoint> Columns;
  std::vector<std::vector<PointId>> Points; // for each horizon its points there
};

/// Throws InputError when two points of a horizon stand in one column.
CommonColumns FindCommonColumns(const std::vector<HorizonView>& horizons);

/// What steps on the lattice are in the world: along x and along y, in plan, and upwards. Thickness has its unit.
struct LatticeSteps
{
  std::array<double, 2> X = { 1.0, 0.0 };
  std::array<double, 2> Y = { 0.0, 1.0 };
  double Height = 1.0; // negative where heights grow downwards
};

struct Thickness
{
  std::vector<PlanePoint> Columns; // row by row
  std::array<std::vector<PointId>, 2> Points; // of the upper and of the lower horizon
  /// Upwards from the lower horizon to the upper one: negative where they cross.
  std::vector<double> Vertical;
  /// Along the normal of the mean of both surfaces: the vertical thickness times the cosine of its dip. This is the
  /// distance of the two where they are parallel planes. The slope is that of central differences, at rims of one-sided
  /// ones; nan where a column has no neighbour along one of the axes.
  std::vector<double> Normal;
  /// 1 where the horizons cross, else 0.
  std::vector<unsigned char> Crosses;
  std::int64_t NumberOfCrossings = 0;
};

/// Throws InputError when two points of a horizon stand in one column, when the horizons have none in common, and when
/// the steps are parallel or 0.
Thickness MeasureThickness(
  const HorizonView& upper, const HorizonView& lower, const LatticeSteps& steps = LatticeSteps());
}

#endif
