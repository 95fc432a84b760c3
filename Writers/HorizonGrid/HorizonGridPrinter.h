// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonGridPrinter_h
#define SeismicHorizonsHorizonGridPrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Common/Survey/HorizonGrid.h"
#include "Writers/HorizonSampling.h"

#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
enum class GridFileKind
{
  ByExtension,
  IrapText,
  Zmap,
  IrapBinary,
  Cps3, // These have no rotation, as Zmap.
  Surfer,
  Esri // z increases upwards.
};

/// Returns the format itself, or that of the extension.
GridFileKind ChooseFormat(GridFileKind format, const std::string& path);

struct WrittenGrid
{
  HorizonGrid Grid;
  std::vector<std::string> Warnings;
};

/// Resamples a lattice that the format cannot hold. Progress ends at 0.6. Throws InputError as SampleWholeLattice and
/// MakeUpright.
WrittenGrid MakeWrittenGrid(
  const NamedHorizon& horizon, GridFileKind format, WrittenSense sense, const Monitor& monitor);

void PrintGrid(const HorizonGrid& grid, GridFileKind format, std::ostream& stream, const Monitor& monitor);
}

#endif
