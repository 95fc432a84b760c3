// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridAxes_h
#define SeismicHorizonsGridAxes_h

#include "Common/Survey/HorizonGrid.h"
#include "GridOutput.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace SeismicHorizons
{
struct Axis
{
  int Count = 0;
  double First = 0.0;
  double Last = 0.0;
  std::int64_t FirstIndex = 0; // Index in HorizonGrid::Z.
  std::int64_t IndexStep = 0;
};

struct Axes
{
  Axis X;
  Axis Y;

  /// The index of a node, from the south-west.
  std::int64_t At(int column, int row) const
  {
    return this->X.FirstIndex + column * this->X.IndexStep + this->Y.FirstIndex + row * this->Y.IndexStep;
  }
};

/// Throws InputError for a rotated or sheared lattice, which `format` cannot hold.
Axes RequireAxes(const SurveyLattice& lattice, const std::string& format);

/// Columns from the west, each from north to south. A column ends a line.
void PrintColumns(const HorizonGrid& grid, const Axes& axes, int valuesInLine, std::size_t width,
  const std::string& null, GridOutput& output);
}

#endif
