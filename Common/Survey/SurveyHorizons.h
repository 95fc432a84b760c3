// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyHorizons_h
#define SeismicHorizonsSurveyHorizons_h

#include "LatticeHorizon.h"
#include "SurveyDescription.h"
#include "SurveyLattice.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Columns whose picks of a horizon differ in z.
struct ConflictCount
{
  std::int64_t Repeats = 0; // Dropped picks with the z of another pick.
  std::int64_t Columns = 0;
  std::int64_t InLines = 0; // Columns in conflict on lines.
  double Largest = 0.0; // largest difference of z
};

struct SurveyHorizons
{
  SurveyDescription Survey;
  SurveyLattice Lattice;
  bool IsOnLattice = true; // Otherwise columns are finer than picks.
  double LargestDistance = 0.0; // Largest distance of a pick from its column, in columns.
  std::vector<LatticeHorizon> Horizons;
  std::string Sense; // Reason for the direction of z.
  std::vector<ConflictCount> Conflicts;
  std::vector<std::string> Warnings;
};
}

#endif
