// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What layers and their horizons are made of, column by column: nothing is left out that is not counted.

#ifndef SeismicHorizonsLayerLedger_h
#define SeismicHorizonsLayerLedger_h

#include "Common/Ledger.h"
#include "Common/Monitor.h"
#include "OrderedStack.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LayerPlan;

/// A column counts as known where both horizons are, as extrapolated where one of them follows another one, and as left
/// out where it has no cell, but would have one if holes and gaps were closed and horizons followed others.
struct LayerLedger
{
  Ledger Columns;
  std::array<double, LedgerEntries> Volumes = {}; // thickness in these columns; columns times lattice units
  /// What cells leave out, up to the columns around, where they end.
  double AreaWithout = 0.0; // columns
  double VolumeWithout = 0.0; // columns times lattice units
};

struct LayerLedgers
{
  std::vector<LayerLedger> OfLayers;
  std::vector<Ledger> OfHorizons; // points that are in no layer are left out
};

/// `horizons` are those that were read.
LayerLedgers MakeLayerLedgers(const LayerPlan& plan, const OrderedStack& stack,
  const std::vector<HorizonView>& horizons, const Monitor& monitor = Monitor());
}

#endif
