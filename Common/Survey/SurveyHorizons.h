// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyHorizons_h
#define SeismicHorizonsSurveyHorizons_h

#include "Common/LatticeHorizon.h"
#include "SurveyDescription.h"
#include "SurveyLattice.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Columns with several picks of one horizon, of which one is kept: those whose z differ.
struct ConflictCount
{
  std::int64_t Repeats = 0; // picks left out with the same z as another one
  std::int64_t Columns = 0;
  std::int64_t InLines = 0; // of these
  double Largest = 0.0; // the largest difference
};

/// Horizons on the columns of one lattice.
struct SurveyHorizons
{
  SurveyDescription Survey;
  SurveyLattice Lattice;
  double LargestDistance = 0.0; // of a pick to its column, in columns
  std::vector<LatticeHorizon> Horizons;
  std::string Sense; // why z counts upwards or downwards, for people
  std::vector<ConflictCount> Conflicts; // of each horizon
  std::vector<std::string> Doubts; // what users should know about the picks
};
}

#endif
