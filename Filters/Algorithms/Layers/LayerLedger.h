// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ledgers of layers and their horizons, which account for all columns.

#ifndef SeismicHorizonsLayerLedger_h
#define SeismicHorizonsLayerLedger_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Ledger.h"
#include "OrderedStack.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LayerPlan;

/// A column is extrapolated where a horizon follows another one, and left out if it has no cell, but would have one if
/// holes and gaps were closed and horizons followed others.
struct LayerLedger
{
  Ledger Columns;
  std::array<double, LedgerEntries> Volumes = {}; // columns times lattice units
  /// Up to the columns at which the cells around end.
  double AreaWithout = 0.0; // columns
  double VolumeWithout = 0.0; // columns times lattice units
};

struct LayerLedgers
{
  std::vector<LayerLedger> OfLayers;
  std::vector<Ledger> OfHorizons;
  std::vector<std::int64_t> PointsOutside; // by horizon: all points in no layer that were read
};

/// `indices` of the horizons are needed if the plan has triangles.
LayerLedgers MakeLayerLedgers(const LayerPlan& plan, const OrderedStack& stack,
  const std::vector<HorizonView>& horizons, const std::vector<ColumnIndex>& indices,
  const Monitor& monitor = Monitor());
}

#endif
