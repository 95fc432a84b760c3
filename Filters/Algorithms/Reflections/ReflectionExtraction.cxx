// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Positive and negative reflections have nothing to do with each other: each sign is worked on by itself.

#include "ReflectionExtraction.h"

#include "BestFirstJoining.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "ConnectedPicks.h"
#include "ContactWaveforms.h"
#include "ContinuousJoining.h"
#include "SurfaceSets.h"
#include "SurfaceWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Widths of waveforms to each side, in dominant periods. Long ones tell layers apart; short ones fill gaps where only
// one layer is left to choose from.
constexpr double LongWaveform = 3.5;
constexpr double ShortWaveform = 1.0;

// Parts that are filled in by links of short waveforms: of fewer picks, or no wider than that, as strips along faults
// are, where long waveforms reach over the fault.
constexpr PointId LargestFilled = 100;
constexpr double LargestFilledWidth = 6.0;

// What the correlation of these links is at least: a part of their median, no more than a fixed one.
constexpr double FillPart = 0.8;
constexpr double LargestFillCorrelation = 0.7;

// What the mean waveforms of wider parts correlate at least, by the long waveforms: a part of their median, no less
// than a fixed one. Means of noisy waveforms are alike even where they themselves are not.
constexpr double WidePart = 0.95;
constexpr double SmallestWideCorrelation = 0.9;

// The largest step that is chosen: a part of the dominant period, and at least so many samples.
constexpr double StepPerPeriod = 0.3;
constexpr double LeastStep = 2.0;

int HalfWidth(double periods, double period)
{
  return std::max(1, int(std::lround(periods * period)));
}

class Joiner
{
public:
  Joiner(const TraceCube& cube, const ExtractionOptions& options, const Extraction& figures)
    : Cube(cube)
    , Options(options)
    , Period(figures.Period)
  {
    this->Link.Connectivity = options.Connectivity;
    this->Link.LargestStep = Depth(std::lround(figures.LargestStep * DepthsPerSample));
  }

  /// Gives the surface of each pick, and the median correlation of its links.
  RawVector<PointId> Join(const ReflectionPicks& picks, double& medianCorrelation, const Monitor& monitor)
  {
    if (this->Options.Joining == SurfaceJoining::Components)
    {
      return FindConnectedPicks(picks, this->Link.Connectivity, this->Link.LargestStep, monitor);
    }
    this->Link.HalfWidth = HalfWidth(LongWaveform, this->Period);
    std::optional<ReflectionLinks> links(std::in_place, this->Cube, picks, this->Link, monitor.Step(0.0, 0.3));
    medianCorrelation = links->MedianCorrelation();
    links->Drop(this->Options.SmallestCorrelation * medianCorrelation);
    if (this->Options.Joining == SurfaceJoining::Continuous)
    {
      return JoinContinuously(picks, *links, monitor.Step(0.3, 1.0));
    }
    SurfaceSets sets(picks);
    JoiningRules rules;
    rules.SmallestContact = this->Options.SmallestContact;
    BestFirstJoining joining(picks, sets);
    joining.Run(*links, rules, monitor.Step(0.3, 0.7));
    links.reset();
    rules.SmallestWideCorrelation = std::max(SmallestWideCorrelation, WidePart * medianCorrelation);
    rules.Correlate = [contact = ContactWaveforms(this->Cube, picks, sets, this->Link.HalfWidth)](
                        std::vector<Edge> pairs) mutable { return contact.Correlate(std::move(pairs)); };
    this->Fill(picks, rules, joining, monitor.Step(0.7, 1.0));
    return sets.TakeLabels();
  }

private:
  void Fill(const ReflectionPicks& picks, JoiningRules rules, BestFirstJoining& joining, const Monitor& monitor)
  {
    this->Link.HalfWidth = HalfWidth(ShortWaveform, this->Period);
    ReflectionLinks links(this->Cube, picks, this->Link, monitor.Step(0.0, 0.4));
    links.Drop(std::min(LargestFillCorrelation, FillPart * links.MedianCorrelation()));
    rules.ContactSize = 1;
    rules.LargestFilled = LargestFilled;
    rules.LargestFilledWidth = LargestFilledWidth;
    joining.Run(links, rules, monitor.Step(0.4, 1.0));
  }

  const TraceCube& Cube;
  const ExtractionOptions& Options;
  const double Period;
  LinkOptions Link;
};
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const ExtractionOptions& options)
{
  CheckOptions(options.Reflections);
  CheckWithin("LargestStep", options.LargestStep, 0.0, double(MostSamples), " samples");
  CheckWithin("SmallestCorrelation", options.SmallestCorrelation, 0.0, 1.0, "");
  CheckWithin("SmallestContact", options.SmallestContact, 0.0, 1.0, "");
  CheckAtLeast<std::int64_t>("SmallestSize", options.SmallestSize, 1, " pick");
  CheckAtLeast<std::int64_t>("LargestNumber", options.LargestNumber, 1, " surface");
}

//----------------------------------------------------------------------------------------------------------------------
Extraction ExtractReflections(const TraceCube& cube, const ExtractionOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  CubeReflections reflections = FindReflections(cube, options.Reflections, monitor.Step(0.0, 0.3));
  Extraction result;
  result.Samples = reflections.Samples;
  result.Picks = reflections.CountPicks();
  result.Threshold = reflections.Threshold;
  result.Period = reflections.Period;
  result.LargestStep =
    options.LargestStep > 0.0 ? options.LargestStep : std::max(LeastStep, StepPerPeriod * result.Period);
  std::array<double, 2> medians = { 0.0, 0.0 };
  std::array<RawVector<PointId>, 2> surfaces;
  for (const std::size_t sign : { 0, 1 })
  {
    const double begin = sign == 0 ? 0.3 : 0.6;
    surfaces[sign] =
      Joiner(cube, options, result).Join(reflections.BySign[sign], medians[sign], monitor.Step(begin, begin + 0.3));
    reflections.BySign[sign].FreePicks();
  }
  result.MedianCorrelation = std::max(medians[0], medians[1]);
  WriteSurfaces(
    cube, reflections, surfaces, options.SmallestSize, options.LargestNumber, result, monitor.Step(0.9, 1.0));
  return result;
}
}
