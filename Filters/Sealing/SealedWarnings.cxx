// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedWarnings.h"

#include "Filters/Common/StageReport.h"
#include "Filters/Faults/FaultWarnings.h"
#include "SealedOutput.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// Faults where no horizon has a mean throw above the error.
std::vector<std::string> ListStillFaults(const CutoffModelData& model, double error)
{
  std::vector<std::string> still;
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    bool isThere = false, moves = false;
    for (const CutHorizon& horizon : model.Horizons)
    {
      double sum = 0.0, count = 0.0;
      for (const CutoffPiece& piece : horizon.AtFault[fault].Pieces)
      {
        for (const CutoffPair& pair : piece.Pairs)
        {
          sum += std::abs(pair.Throw());
          count += 1.0;
        }
      }
      isThere = isThere || count > 0.0;
      moves = moves || sum > error * count;
    }
    if (isThere && !moves)
    {
      still.push_back(model.Faults[fault].Name());
    }
  }
  return still;
}

/// Faults without a triangle.
std::vector<std::string> ListMissingFaults(const SealedModel& model)
{
  std::vector<std::string> missing;
  for (const SealedSurface& surface : model.Surfaces)
  {
    const bool isThere = std::any_of(model.Triangles.begin(), model.Triangles.end(),
      [&](const SealedTriangle& triangle)
      { return model.Surfaces[std::size_t(triangle.Surface)].Name == surface.Name; });
    if (surface.Type == SealedSurfaceType::Fault && !isThere)
    {
      missing.push_back(surface.Name);
    }
  }
  return missing;
}

void WarnOfPicks(const SealingHorizon& horizon, const PickAccount& account, std::vector<std::string>& warnings)
{
  constexpr double mostContinued = 0.1, mostOutside = 0.1;
  std::ostringstream text = MakeReportStream();
  if (account.Moved > 0)
  {
    text << horizon.Name << " moved at " << account.Moved << " picks, by up to " << account.LargestMove
         << ", expected horizons at least 2.5 errors apart, and from the top and base of the box";
    warnings.push_back(text.str());
  }
  if (double(account.Outside) > mostOutside * double(horizon.Columns.size()))
  {
    text.str("");
    text << horizon.Name << " with " << account.Outside << " of " << horizon.Columns.size()
         << " picks outside the walls, expected horizons over one area";
    warnings.push_back(text.str());
  }
  if (double(account.Continued) > mostContinued * double(account.Columns))
  {
    text.str("");
    text << horizon.Name << " continued over " << account.Continued << " of " << account.Columns
         << " columns, expected picks in most: their heights are not bounded";
    warnings.push_back(text.str());
  }
}

std::string JoinTexts(const std::vector<std::string>& texts)
{
  return std::accumulate(texts.begin() + 1, texts.end(), texts.front(),
    [](const std::string& joined, const std::string& text) { return joined + "; " + text; });
}

void WarnOfTips(const SealedModel& model, std::vector<std::string>& warnings)
{
  if (!model.BeyondTips.empty())
  {
    std::vector<std::string> names;
    for (const std::int32_t surface : model.BeyondTips)
    {
      names.push_back(model.Surfaces[std::size_t(surface)].Name);
    }
    warnings.push_back("parts of faults beyond their tips (" + ListFaults(names) +
      "), expected no throw there: Tips Through extends faults to the walls");
  }
  if (!model.Steps.empty())
  {
    std::vector<std::string> steps;
    for (const TipStep& step : model.Steps)
    {
      std::ostringstream text = MakeReportStream();
      text << step.Fault << " by " << step.Distance;
      steps.push_back(text.str());
    }
    warnings.push_back("faults whose throw continues beyond their sticks (" + JoinTexts(steps) +
      "), expected sticks along the whole throw");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> WarnOfSealed(const SealedModel& model, const FaultNetwork& network, const SealingInput& input,
  const CutoffModelData& cutoffs, double error)
{
  std::vector<std::string> warnings;
  const std::vector<std::string> still = ListStillFaults(cutoffs, error), missing = ListMissingFaults(model);
  if (!still.empty())
  {
    warnings.push_back("faults without a throw (" + ListFaults(still) +
      "), expected some above the maximum error: picks may step beside the sticks");
  }
  if (!network.Choices.empty())
  {
    warnings.push_back("endings chosen automatically (" + JoinTexts(network.Choices) + "), expected rules in Endings");
  }
  if (!network.LeftOut.empty())
  {
    warnings.push_back("parts of faults left out (" + JoinTexts(network.LeftOut) +
      "), expected each fault on one side of the fault at which it ends by Endings");
  }
  WarnOfTips(model, warnings);
  if (!missing.empty())
  {
    warnings.push_back("faults in no surface (" + ListFaults(missing) + "), expected each to bound a body");
  }
  if (!network.Outside.empty())
  {
    warnings.push_back("faults outside the model (" + ListFaults(network.Outside) + "), expected some inside its box");
  }
  if (model.Slivers > 0)
  {
    warnings.push_back(std::to_string(model.Slivers) +
      " triangles thinner than a thousandth of a column, expected none: faults that nearly coincide, or die out, make "
      "them");
  }
  for (std::size_t n = 0; n < input.Horizons.size(); ++n)
  {
    WarnOfPicks(input.Horizons[n], model.Accounts[n], warnings);
  }
  for (const SealedGuess& guess : model.Guessed)
  {
    warnings.push_back(input.Horizons[guess.Horizon].Name + " without picks in the block " +
      NameBlock(model, guess.Sides) + ", expected some: its height follows the horizon nearest to it");
  }
  return warnings;
}
}
