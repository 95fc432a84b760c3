// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which layers meet across a fault (Allan, 1989, AAPG Bulletin 73, 803-811). Seen across the fault, the cutoffs of all
// horizons on both walls divide it into areas, each with one layer on the footwall and one on the hanging wall.

#ifndef SeismicHorizonsJuxtaposition_h
#define SeismicHorizonsJuxtaposition_h

#include "Cutoffs.h"
#include "FaultPlate.h"

#include <array>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// By numbers of horizons, from the uppermost on.
struct MetLayer
{
  static constexpr std::ptrdiff_t Outside = -1; // above the uppermost horizon or below the lowest one

  std::ptrdiff_t Top = Outside;
  std::ptrdiff_t Base = Outside;

  friend bool operator==(const MetLayer& a, const MetLayer& b) { return a.Top == b.Top && a.Base == b.Base; }
  friend bool operator<(const MetLayer& a, const MetLayer& b)
  {
    return a.Top != b.Top ? a.Top < b.Top : a.Base < b.Base;
  }
};

/// A trapezium of a fault between two places along it.
struct MetArea
{
  std::array<double, 2> S;
  std::array<double, 2> Base; // heights at both places
  std::array<double, 2> Top;
  std::array<MetLayer, 2> Layer; // by wall
  double Area = 0.0; // on the fault
};

/// Horizons are sorted from the uppermost on. Where one has no cutoffs, those beside it bound one layer. Cutoffs that
/// cross on one wall are put in order: the lower one follows the upper one.
std::vector<MetArea> FindJuxtaposition(const FaultPlate& fault, const std::vector<const HorizonCutoffs*>& horizons);
}

#endif
