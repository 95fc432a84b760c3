// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStackOutput_h
#define SeismicHorizonsStackOutput_h

#include "Filters/Algorithms/Layers/OrderedStack.h"
#include "HorizonStack.h"

#include <cstddef>
#include <string>

class vtkPolyData;

namespace SeismicHorizons
{
/// Repaired heights are world z.
void WriteRepaired(
  const RepairedHorizons& repaired, std::size_t horizon, const HorizonStack& stack, vtkPolyData* output);

/// Lists crossings of neighbours, and moved horizons.
std::string TellRepair(const CrossingRepair& repair, const HorizonStack& stack);
}

#endif
