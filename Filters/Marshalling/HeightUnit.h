// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The units in which errors, throws and other thresholds of height are given.

#ifndef SeismicHorizonsHeightUnit_h
#define SeismicHorizonsHeightUnit_h

#include "Common/Lattice.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
enum class HeightUnit
{
  Lattice = 0, // 1 is one vertical index
  World = 1, // that of z
  Diagonal = 2 // 1 is the diagonal of the bounding box of all points, in lattice units
};

/// How much z changes from one vertical index to the next, without its sign.
double WorldPerIndex(const Lattice& lattice);

/// How many vertical indices a unit has. `columns` and `height` are the places of all points.
double IndicesPerUnit(HeightUnit unit, PlanePoints columns, const std::vector<double>& height, const Lattice& lattice);
}

#endif
