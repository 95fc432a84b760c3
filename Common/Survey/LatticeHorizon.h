// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLatticeHorizon_h
#define SeismicHorizonsLatticeHorizon_h

#include "Common/Types.h"
#include "PickTable.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The points of a horizon on the columns of a lattice, at most one on each, by ascending j and then i.
struct LatticeHorizon
{
  std::string Name;
  int Number = 0; // from 0, in the order of names; sheets of one horizon have the same
  std::vector<PlanePoint> Column;
  std::vector<double> Z; // in the unit and with the sign of the file; finite
  std::vector<PickAttribute> Attributes;
  std::int64_t DroppedDuplicates = 0; // left out because another one is in their column
  std::int64_t DroppedNulls = 0; // left out because they have no z
};
}

#endif
