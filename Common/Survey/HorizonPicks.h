// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonPicks_h
#define SeismicHorizonsHorizonPicks_h

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A number for each point of a horizon; nan where there is none.
struct HorizonAttribute
{
  std::string Name;
  std::vector<double> Values;
};

/// The points of a horizon before it is known on which columns they stand, as parallel arrays.
struct HorizonPicks
{
  std::string Name; // empty where there is none
  std::vector<double> X, Y; // in the world; empty where only line numbers are known
  std::vector<double> Inline, Crossline; // line numbers; empty where only places in the world are known
  std::vector<double> Z; // in the unit and with the sign of the file; finite
  std::vector<HorizonAttribute> Attributes;
};

/// The points of a horizon on the columns of a lattice, at most one on each, by ascending j and then i.
struct LatticeHorizon
{
  std::string Name;
  std::vector<int> I, J;
  std::vector<double> Z;
  std::vector<HorizonAttribute> Attributes;
  std::int64_t DroppedDuplicates = 0; // picks left out because another one is in their column
};
}

#endif
