// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonText_h
#define SeismicHorizonsHorizonText_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Writers/HorizonSampling.h"

#include <ostream>
#include <vector>

namespace SeismicHorizons
{
struct HorizonTextOptions
{
  WrittenSense Sense = WrittenSense::AsRead; // of the first horizon for all
  bool WithAttributes = true;
};

/// Horizons need a lattice. The header names the attributes of all horizons, so that all are sampled before the first
/// is printed.
void PrintHorizonText(const std::vector<NamedHorizon>& horizons, const HorizonTextOptions& options,
  std::ostream& stream, const Monitor& monitor);
}

#endif
