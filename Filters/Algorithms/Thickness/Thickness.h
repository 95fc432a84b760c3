// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The isochore is the vertical thickness between two horizons, by column. The isopach, or true thickness, is the
// isochore times the cosine of the dip half-way between the horizons.
//
//            o .                     isochore
//           /|   .                   |
//      o---o |  /                    | isopach, where the dip is 45 degrees: 0.71 of that
//        . | | / .
//          o-|o    .
//            o

#ifndef SeismicHorizonsThickness_h
#define SeismicHorizonsThickness_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/Layers/CommonColumns.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LatticeScale
{
  Eigen::Matrix2d Plane = Eigen::Matrix2d::Identity(); // columns of the matrix: steps along i and j
  double Height = 1.0; // of a vertical index, with its sign
};

LatticeScale ScaleOf(const Lattice& lattice);

struct Thickness
{
  /// Values are in the unit of z, by point of the first horizon: NaN without a point of the other, negative at crossings.
  std::vector<double> Isochore;
  /// It is NaN, too, if the dip is unknown along i or j.
  std::vector<double> Isopach;

  std::int64_t Columns = 0; // with points of both
  std::int64_t LeftOut = 0; // columns with a point of one horizon only
  double Area = 0.0; // of one column
  std::int64_t Crossings = 0; // columns of negative isochore
  double Least = 0.0; // negative at crossings
  double Mean = 0.0;
  double Largest = 0.0;
  double Volume = 0.0; // crossings count as 0
};

/// Heights are in lattice units. The flatter step along an axis gives the dip, so that a fault beside a column does
/// not. Throws InputError if no column has both horizons, or one has two points of a horizon.
Thickness MeasureThickness(
  const HorizonView& first, const HorizonView& other, const LatticeScale& scale, const Monitor& monitor = Monitor());
}

#endif
