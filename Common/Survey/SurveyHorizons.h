// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyHorizons_h
#define SeismicHorizonsSurveyHorizons_h

#include "Common/LatticeHorizon.h"
#include "SurveyDescription.h"
#include "SurveyLattice.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Horizons on the columns of one lattice.
struct SurveyHorizons
{
  SurveyDescription Survey;
  SurveyLattice Lattice;
  double LargestDistance = 0.0; // of a pick to its column, in columns
  std::vector<LatticeHorizon> Horizons;
  std::vector<std::string> Doubts; // what users should know about the picks
};
}

#endif
