// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons of a stack in order, as datasets.

#ifndef SeismicHorizonsStackOutput_h
#define SeismicHorizonsStackOutput_h

#include "HorizonStack.h"
#include "Layers/OrderedStack.h"

#include <cstddef>
#include <string>

class vtkPolyData;

namespace SeismicHorizons
{
/// The points of a horizon where its repaired heights are, which are z of the world.
void WriteRepaired(
  const RepairedHorizons& repaired, std::size_t horizon, const HorizonStack& stack, vtkPolyData* output);

/// Lines of text: how neighbours crossed, and which horizons were moved.
std::string TellRepair(const CrossingRepair& repair, const HorizonStack& stack);
}

#endif
