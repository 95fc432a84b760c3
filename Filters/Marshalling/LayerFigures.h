// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How large layers are, in the world.

#ifndef SeismicHorizonsLayerFigures_h
#define SeismicHorizonsLayerFigures_h

#include "HorizonStack.h"
#include "Layers/LayerCells.h"
#include "Layers/LayerPlan.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkFieldData;
class vtkStringArray;
class vtkTable;

namespace SeismicHorizons
{
/// "Top to Base", for each layer.
std::vector<std::string> NamesOfLayers(const HorizonStack& stack);

/// How much volume a bin has that is one vertical index thick.
double VolumeOfUnit(const HorizonStack& stack);

/// The unit of volumes, "m3" or "m2 ms"; empty where units are not known.
std::string UnitOfVolumes(const HorizonStack& stack);

vtkSmartPointer<vtkStringArray> MakeTexts(const char* name, const std::vector<std::string>& texts);

/// A row for each layer, whose size `volumes` has. With a contact, a world z, also how much of them lies above it.
void WriteLayerTable(const Layers& layers, const std::vector<LayerVolume>& volumes, const HorizonStack& stack,
  std::optional<double> contact, vtkTable* table);

/// The volume of each layer above contacts from the top of all to the base.
void WriteVolumeCurve(
  const LayerPlan& plan, const HorizonStack& stack, vtkTable* table, const Monitor& monitor = Monitor());

/// As field data, beside the lattice.
void WriteLayerLedger(const LayerLedger& ledger, const HorizonStack& stack, vtkFieldData* data);

/// What layers have of heights that were not read, and what they leave out, as far as it is worth a warning.
std::vector<std::string> TellMissing(const LayerLedgers& ledgers, const HorizonStack& stack);

/// The same as lines of text: of each layer volume and thickness, and of each horizon the points outside.
std::string TellLayers(const Layers& layers, const std::vector<LayerVolume>& volumes, const HorizonStack& stack);
}

#endif
