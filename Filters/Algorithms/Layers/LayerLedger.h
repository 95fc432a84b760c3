// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ledgers of layers and their horizons, which account for all columns.

#ifndef SeismicHorizonsLayerLedger_h
#define SeismicHorizonsLayerLedger_h

#include "Common/ColumnIndex.h"
#include "Common/Ledger.h"
#include "Common/Monitor.h"
#include "OrderedStack.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LayerPlan;

/// A column is known where both horizons are, extrapolated where one of them follows another one, and left out where it
/// has no cell, but would have one if holes and gaps were closed and horizons followed others.
struct LayerLedger
{
  Ledger Columns;
  std::array<double, LedgerEntries> Volumes = {}; // the sum of the thickness in columns; columns times lattice units
  /// The area and volume without cells, up to the columns at which the cells around end.
  double AreaWithout = 0.0; // columns
  double VolumeWithout = 0.0; // columns times lattice units
};

struct LayerLedgers
{
  std::vector<LayerLedger> OfLayers;
  std::vector<Ledger> OfHorizons; // points that are in no layer are left out
  std::vector<std::int64_t> PointsOutside; // by horizon: all points that were read and are in no layer
};

/// `indices` are those of the columns of `horizons`; they are needed where the plan has triangles.
LayerLedgers MakeLayerLedgers(const LayerPlan& plan, const OrderedStack& stack,
  const std::vector<HorizonView>& horizons, const std::vector<ColumnIndex>& indices,
  const Monitor& monitor = Monitor());
}

#endif
