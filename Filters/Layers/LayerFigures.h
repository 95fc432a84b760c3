// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLayerFigures_h
#define SeismicHorizonsLayerFigures_h

#include "Common/Horizon/DataArray.h"
#include "Filters/Algorithms/Layers/LayerCells.h"
#include "Filters/Algorithms/Layers/LayerPlan.h"
#include "HorizonStack.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Names are such as "Top to Base".
std::vector<std::string> NamesOfLayers(const HorizonStack& stack);

/// Volume of a bin with the thickness of one vertical index.
double VolumeOfUnit(const HorizonStack& stack);

/// "m3" or "m2 ms"; empty if units are unknown
std::string UnitOfVolumes(const HorizonStack& stack);

/// Each layer has a row. `contact` is world z, and adds the volume above it.
void WriteLayerTable(const Layers& layers, const std::vector<LayerVolume>& volumes, const HorizonStack& stack,
  std::optional<double> contact, ArrayTable& table);

/// Contacts are spread from the uppermost top to the lowest base.
void WriteVolumeCurve(
  const LayerPlan& plan, const HorizonStack& stack, ArrayTable& table, const Monitor& monitor = Monitor());

/// The field data must have the lattice.
void WriteLayerLedger(const LayerLedger& ledger, const HorizonStack& stack, ArrayTable& data);

/// Returns warnings of layers with heights that were not read, or parts left out; these end with the advice.
std::vector<std::string> ReportMissing(
  const LayerLedgers& ledgers, const HorizonStack& stack, const std::string& advice);

/// Lists volume and thickness of each layer, and points outside of each horizon.
std::string ReportLayers(const Layers& layers, const std::vector<LayerVolume>& volumes, const HorizonStack& stack);
}

#endif
