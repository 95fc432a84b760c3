// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyFrame.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// Counts z below 0 and all z. A single negative value, such as -999, is no elevation and counts as none.
std::array<std::int64_t, 2> CountNegative(const std::vector<LatticeHorizon>& horizons)
{
  std::array<std::int64_t, 2> counts = { 0, 0 };
  double first = 0.0;
  bool isSingle = true;
  for (const LatticeHorizon& horizon : horizons)
  {
    counts[1] += std::int64_t(horizon.RealZ.size());
    for (const double z : horizon.RealZ)
    {
      counts[0] += z < 0.0 ? 1 : 0;
      first = first == 0.0 && z < 0.0 ? z : first;
      isSingle = isSingle && (z >= 0.0 || z == first);
    }
  }
  return { isSingle ? 0 : counts[0], counts[1] };
}

std::string DescribeFrame(const LatticeFrame& frame, const std::vector<VerticalSampling>& samplings)
{
  const SurveyLattice& lattice = frame.Lattice;
  std::ostringstream text;
  text.precision(10);
  text << lattice.Columns[0] << " x " << lattice.Columns[1] << " columns from " << ToText(lattice.Origin)
       << " in steps of " << ToText(lattice.ColumnStep) << " and " << ToText(lattice.RowStep);
  if (lattice.Lines)
  {
    text << "\ncrosslines from " << lattice.Lines->FirstCrossline << " in steps of " << lattice.Lines->CrosslineStep
         << ", inlines from " << lattice.Lines->FirstInline << " in steps of " << lattice.Lines->InlineStep;
  }
  text.precision(3);
  text << "\npoints at most " << *frame.LatticeDeviation << " of a step off their columns";
  text.precision(10);
  if (samplings.empty())
  {
    return text.str();
  }
  const auto [least, most] = std::minmax_element(samplings.begin(), samplings.end(),
    [](const VerticalSampling& one, const VerticalSampling& other) { return one.Step < other.Step; });
  text << "\nvertical indices in steps of " << least->Step;
  if (most->Step > least->Step)
  {
    text << " to " << most->Step;
  }
  text << " " << (frame.Survey.VerticalUnit.empty() ? "(unit unknown)" : frame.Survey.VerticalUnit) << " to "
       << (frame.Direction == VerticalDirection::Down ? "smaller" : "larger") << " world z"
       << (most->Step > least->Step ? ", as suits each horizon" : "");
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
void RequireAnyPoints(const std::vector<LatticeHorizon>& horizons, const std::string& prefix)
{
  std::int64_t nulls = 0;
  for (const LatticeHorizon& horizon : horizons)
  {
    nulls += horizon.DroppedNulls;
    if (!horizon.RealZ.empty())
    {
      return;
    }
  }
  throw InputError(prefix + "no points, expected those of a horizon: all " + std::to_string(nulls) + " are without z");
}

//----------------------------------------------------------------------------------------------------------------------
FramedSurvey FrameSurvey(
  const SurveyHorizons& survey, double verticalStep, std::optional<VerticalDirection> direction, const Monitor& monitor)
{
  FramedSurvey framed;
  LatticeFrame& frame = framed.Frame;
  frame.Survey = survey.Survey;
  frame.Lattice = survey.Lattice;
  frame.LatticeDeviation = survey.LargestDistance;
  framed.Samplings = FindVerticalSamplings(survey.Horizons, verticalStep, monitor);
  frame.Direction = direction.value_or(survey.Survey.IsUpright ? VerticalDirection::Up : VerticalDirection::Down);
  const bool isUp = frame.Direction == VerticalDirection::Up;
  const auto [negative, all] = CountNegative(survey.Horizons);
  if (!direction && !isUp && negative > 0)
  {
    framed.Warnings.push_back(std::to_string(negative) + " of " + std::to_string(all) +
      " z are negative, so z may be elevation or depth; it is taken to increase downwards: set VerticalDirection "
      "to Up for elevation, or to Down to confirm");
  }
  framed.Description = (survey.IsOnLattice ? DescribeFrame(frame, framed.Samplings) : "picks without a lattice") +
    "\nz increases " + (isUp ? "upwards" : "downwards") +
    (direction ? ", as VerticalDirection says"
               : ", " + survey.Sense + "; VerticalDirection " + (isUp ? "Down" : "Up") + " turns it");
  return framed;
}
}
