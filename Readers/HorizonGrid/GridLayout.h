// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the readers of all formats share about nodes: where they are, in which order files have them, and which have no
// value.

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
/// Which numbers stand for a node without value. Not a number always does.
struct NullRule
{
  double Value = std::numeric_limits<double>::quiet_NaN(); ///< this one
  double Tolerance = 0.0; ///< and what is no farther from it
  double Least = std::numeric_limits<double>::quiet_NaN(); ///< and all from here on

  bool operator()(double z) const
  {
    return z >= this->Least || std::fabs(z - this->Value) <= this->Tolerance || std::isnan(z);
  }
};

/// This number, also when it was rounded to a float on its way into the file.
NullRule NullAt(double value);

/// All numbers from this one on.
NullRule NullFrom(double least);

/// Adds that all numbers from this one on have no value.
NullRule OrFrom(NullRule rule, double least);

std::int64_t CountNodes(const std::array<int, 2>& columns);

/// Nodes along the axes between the first and the last one of each. One node alone along an axis gets a step of 1.
/// Throws InputError when the first is not below the last.
SurveyLattice AxisLattice(
  const std::array<int, 2>& columns, const std::array<double, 2>& xRange, const std::array<double, 2>& yRange);

/// Nodes from an origin by steps that are turned counterclockwise by an angle in degrees. A negative step makes a
/// lattice that is seen in a mirror. Throws InputError when a step is 0, or a node at no finite place.
SurveyLattice TurnedLattice(
  const std::array<int, 2>& columns, const Eigen::Vector2d& origin, const std::array<double, 2>& steps, double degrees);

/// Throws InputError when the header of a file claims far more nodes than it gives points for: no horizon is as sparse.
/// So memory follows what is in the file.
void RequirePoints(std::int64_t nodes, std::int64_t points);

/// The order of the values in a file.
struct StorageOrder
{
  bool AlongY = false; ///< column by column instead of row by row
  bool FromRight = false; ///< each row, or the columns, begin at the largest i
  bool FromTop = false; ///< each column, or the rows, begin at the largest j
};

/// Values in the order of HorizonGrid: by rows from the smallest j, each from the smallest i.
std::vector<double> Arrange(std::vector<double> values, const std::array<int, 2>& columns, const StorageOrder& order);
}

#endif
