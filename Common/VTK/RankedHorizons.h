// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsRankedHorizons_h
#define SeismicHorizonsRankedHorizons_h

#include "HorizonTree.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class Ranks;

struct RankedHorizon
{
  std::string Name; // as in HorizonLeaf
  int Position; // as in HorizonLeaf
  vtkIdType Points;
  int Rank;
  std::size_t Leaf; // index in the list of that rank
};

/// The result is in the order of the dataset. Ranks where a horizon is empty are skipped if another has its points.
/// Throws InputError if several ranks have points of a horizon. Collective.
std::vector<RankedHorizon> ListOnRanks(const std::vector<HorizonLeaf>& leaves, const Ranks& ranks);

/// Copies horizons of other ranks to every rank. Collective.
std::vector<vtkSmartPointer<vtkPolyData>> ShareOnRanks(
  const std::vector<RankedHorizon>& shared, const std::vector<HorizonLeaf>& leaves, const Ranks& ranks);
}

#endif
