// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyFrame_h
#define SeismicHorizonsSurveyFrame_h

#include "Common/Base/Monitor.h"
#include "LatticeFrame.h"
#include "SurveyHorizons.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// How horizons are placed in the world.
struct FramedSurvey
{
  LatticeFrame Frame; // Its sampling has yet to be chosen.
  std::vector<VerticalSampling> Samplings; // by horizon
  std::vector<std::string> Warnings;
  std::string Description; // in lines
};

/// A step of 0 chooses one for each horizon; without a direction the survey decides. Throws InputError for an invalid
/// step.
FramedSurvey FrameSurvey(const SurveyHorizons& survey, double verticalStep, std::optional<VerticalDirection> direction,
  const Monitor& monitor = Monitor());

/// Throws InputError, which begins with `prefix`, if no horizon has a point.
void RequireAnyPoints(const std::vector<LatticeHorizon>& horizons, const std::string& prefix);
}

#endif
