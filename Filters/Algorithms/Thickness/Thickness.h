// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thickness of the layer between two horizons, column by column.
//
// The isochore is the vertical thickness. The isopach, or true thickness, is what a line across the layer measures, at
// a right angle to the surface half-way between the two horizons: the isochore times the cosine of the dip of that
// surface.
//
//            o .                     isochore
//           /|   .                   |
//      o---o |  /                    | isopach, where the dip is 45 degrees: 0.71 of that
//        . | | / .
//          o-|o    .
//            o

#ifndef SeismicHorizonsThickness_h
#define SeismicHorizonsThickness_h

#include "Common/Monitor.h"
#include "Layers/CommonColumns.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// How long steps of the lattice are in the world.
struct LatticeScale
{
  Eigen::Matrix2d Plane = Eigen::Matrix2d::Identity(); // columns of the matrix: the step along i and that along j
  double Height = 1.0; // of a vertical index, with its sign
};

struct Thickness
{
  /// Of each point of the first horizon, in the unit of z: nan in columns where the other one has no point, and
  /// negative where the two cross: where that is the upper one which elsewhere mostly is the lower one.
  std::vector<double> Isochore;
  /// The same; nan too where the dip is not known, as there is no such column beside it along i, or along j.
  std::vector<double> Isopach;

  std::int64_t Columns = 0; // with points of both
  std::int64_t LeftOut = 0; // columns with a point of one alone
  double Area = 0.0; // of one of these columns
  std::int64_t Crossings = 0; // columns of negative thickness
  double Least = 0.0; // isochore, which is negative at crossings
  double Mean = 0.0;
  double Largest = 0.0;
  double Volume = 0.0; // the sum over columns, each with its area; crossings count as 0
};

/// Heights are in lattice units. Where a horizon has points on every second line, say, a column stands for two: the
/// columns that count are those that the steps of both horizons lead to. Of two steps to neighbours along an axis the
/// flatter one gives the dip, so that a fault between two columns does not. Takes time linear in the points, and no
/// memory for what is empty. Throws InputError when no column has points of both, or one has two of a horizon.
Thickness MeasureThickness(
  const HorizonView& first, const HorizonView& other, const LatticeScale& scale, const Monitor& monitor = Monitor());
}

#endif
