// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which horizons the ranks of a program have.

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
  vtkIdType Points; // how many it has
  int Rank; // that has it
  std::size_t Leaf; // its number in the list of that rank
};

/// The horizons of a dataset on all ranks, of which each has its own `leaves`, in the order of the dataset. A horizon
/// that has points on one rank does not count on those where it is empty. Throws InputError when one has points on
/// several. Collective.
std::vector<RankedHorizon> ListOnRanks(const std::vector<HorizonLeaf>& leaves, const Ranks& ranks);

/// Some of them, `shared`, on every rank: its own `leaves`, and copies of those of others. Collective.
std::vector<vtkSmartPointer<vtkPolyData>> ShareOnRanks(
  const std::vector<RankedHorizon>& shared, const std::vector<HorizonLeaf>& leaves, const Ranks& ranks);
}

#endif
