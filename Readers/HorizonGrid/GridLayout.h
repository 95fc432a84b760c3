// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Node positions, storage order and null values, shared by the readers of all formats.

#ifndef SeismicHorizonsGridLayout_h
#define SeismicHorizonsGridLayout_h

#include "Common/Survey/SurveyLattice.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// A node has no value if its number is nan, is within Tolerance of Value, or is at least Least.
struct NullRule
{
  double Value = std::numeric_limits<double>::quiet_NaN();
  double Tolerance = 0.0;
  double Least = std::numeric_limits<double>::quiet_NaN();

  bool operator()(double z) const
  {
    return z >= this->Least || std::fabs(z - this->Value) <= this->Tolerance || std::isnan(z);
  }
};

/// The tolerance covers rounding to float.
NullRule NullAt(double value);

NullRule NullFrom(double least);

NullRule OrFrom(NullRule rule, double least);

std::int64_t CountNodes(const std::array<int, 2>& columns);

/// A single node along an axis gets a step of 1. Throws InputError unless the first coordinate is below the last.
SurveyLattice AxisLattice(
  const std::array<int, 2>& columns, const std::array<double, 2>& xRange, const std::array<double, 2>& yRange);

/// The angle is in degrees, counterclockwise. A negative step makes the lattice left-handed. Throws InputError for a
/// step of 0 and for nodes that are not finite.
SurveyLattice TurnedLattice(
  const std::array<int, 2>& columns, const Eigen::Vector2d& origin, const std::array<double, 2>& steps, double degrees);

/// Throws InputError if a header claims far more nodes than the file has points: no horizon is that sparse, and memory
/// stays in proportion to the file.
void RequirePoints(std::int64_t nodes, std::int64_t points);

struct StorageOrder
{
  bool AlongY = false; ///< Column by column instead of row by row.
  bool FromRight = false; ///< The largest i comes first.
  bool FromTop = false; ///< The largest j comes first.
};

/// The order of ZMAP+ and CPS-3.
constexpr StorageOrder ColumnsFromTop = { true, false, true };

/// Returns the values in the order of HorizonGrid: i fastest.
std::vector<double> Arrange(std::vector<double> values, const std::array<int, 2>& columns, const StorageOrder& order);
}

#endif
