// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReflectionStage.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/PlaceText.h"
#include "Common/Survey/HorizonDataSet.h"
#include "Common/Survey/SurveyFields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Picks are numbered from 1.
std::string GuidePicksText(const std::vector<std::size_t>& numbers, const GuidePicks& guide)
{
  constexpr std::size_t most = 5;
  std::ostringstream text;
  text << numbers.size() << " of " << guide.Places.size() << " picks, number";
  for (std::size_t n = 0; n < numbers.size() && n < most; ++n)
  {
    text << (n > 0 ? ", " : " ") << numbers[n] + 1;
  }
  const std::array<double, 3>& first = guide.Places[numbers.front()];
  text << (numbers.size() > most ? ", ..." : "") << ", the first at "
       << PlaceText(Eigen::Map<const Eigen::Vector3d>(first.data()));
  return text.str();
}

void DescribeLimits(FoundReflections& found, std::ostream& text)
{
  const ExtractionLimits& limits = found.Limits;
  if (limits.Traces.AreNone())
  {
    return;
  }
  const auto traces = std::int64_t(limits.Traces.First.size());
  const std::string count = "limits on " + std::to_string(limits.Limited) + " of " + std::to_string(traces) + " traces";
  text << count << '\n';
  if (2 * limits.Limited < traces)
  {
    found.Warnings.push_back(count +
      ", expected them on most: nothing is found on the others; Horizon Hole Filling fills horizons with holes");
  }
}

void WarnOfGuide(
  const GuidePicks& guide, const GuideUse& use, std::size_t points, bool hasGrowth, FoundReflections& found)
{
  if (!use.Strays.empty())
  {
    found.Warnings.push_back("guide \"" + guide.Given.Name + "\": " + GuidePicksText(use.Strays, guide) +
      ", are on another event than those around them, expected one event: followed only where waveforms prefer them");
  }
  if (2 * use.NearNone.size() > guide.Places.size())
  {
    found.Warnings.push_back("guide \"" + guide.Given.Name + "\": " + GuidePicksText(use.NearNone, guide) +
      ", are near no reflection, expected most to be: see GuideTolerance");
  }
  if (!use.OnOtherSign.empty())
  {
    found.Warnings.push_back("guide \"" + guide.Given.Name + "\": " + GuidePicksText(use.OnOtherSign, guide) +
      ", are on reflections of " + (use.IsNegative ? "positive" : "negative") +
      " amplitude, expected the sign of the others: not used");
  }
  // Horizons that meet share some of their points; of one event named twice, most.
  if (2 * use.Shared > std::int64_t(points))
  {
    found.Warnings.push_back("guide \"" + guide.Given.Name + "\": " + std::to_string(use.Shared) + " of its " +
      std::to_string(points) + " points are also on guide \"" + found.Guides[use.SharedWith].Given.Name +
      "\", expected different events");
  }
  if (use.Stopped > 0 && hasGrowth)
  {
    found.Warnings.push_back("guide \"" + guide.Given.Name + "\": growth stopped at GrowthReach with " +
      std::to_string(use.Stopped) + " columns next, expected more picks or a larger GrowthReach");
  }
}

/// In percent of the points, to a tenth.
double LikelyWrong(const LatticeHorizon& surface)
{
  double sum = 0.0;
  for (const double confidence : surface.Attributes.front().second)
  {
    sum += 1.0 - confidence;
  }
  return std::round(1000.0 * sum / double(std::max<std::size_t>(1, surface.Column.size()))) / 10.0;
}

void DescribeGuides(bool hasGrowth, FoundReflections& found, std::ostream& text)
{
  for (std::size_t n = 0; n < found.Guides.size(); ++n)
  {
    const GuidePicks& guide = found.Guides[n];
    const GuideUse& use = found.Result.Guides[n];
    const LatticeHorizon& surface = found.Result.Surfaces[n];
    std::array<std::int64_t, 3> counts = { 0, 0, 0 };
    for (const int origin : surface.Labels.front().second)
    {
      ++counts[std::size_t(origin)];
    }
    text << guide.Given.Name << ": " << surface.Column.size() << " points of "
         << (use.IsNegative ? "negative" : "positive") << " reflections, "
         << (use.Turned > 0 ? "of the other sign where polarity turns, " : "") << counts[0] << " picks ("
         << use.Strays.size() << " contradicted), " << counts[1] << " on parts, " << counts[2] << " grown, "
         << LikelyWrong(surface) << " % likely wrong; " << use.Doubtful << " left out, " << use.Shared << " shared, "
         << use.Seams << " seams; unused picks: " << use.NearNone.size() << " near no reflection, "
         << use.OnOtherSign.size() << " on the other sign, " << use.Doubled.size() << " on a trace with another, "
         << guide.Outside << " outside of the cube\n";
    WarnOfGuide(guide, use, surface.Column.size(), hasGrowth, found);
  }
}

void DescribeReflections(const GuidanceOptions& options, FoundReflections& found)
{
  const Extraction& result = found.Result;
  std::ostringstream text;
  text.precision(4);
  text << result.Samples << " samples, " << result.Picks << " picks of an amplitude of " << result.Threshold
       << " or more\n"
       << "dominant period " << result.Period << " samples, largest step " << result.LargestStep
       << (result.IsSmoothed ? "; smoothed" : "") << '\n';
  if (result.HalfBand > 0.0)
  {
    text << "searched within " << result.HalfBand << " samples of where guides lead, as the cube has more than "
         << options.LargestWhole << " samples\n";
  }
  text << "phase of the wavelet " << result.Phase.Degrees << " or " << result.Phase.Degrees + 180.0
       << " degrees, parts of the traces within " << result.Phase.Deviation << '\n';
  if (result.MedianCorrelation != 0.0)
  {
    text << "median correlation of links " << result.MedianCorrelation << '\n';
  }
  DescribeLimits(found, text);
  DescribeGuides(options.GrowthReach > 0, found, text);
  std::string description = text.str();
  if (found.Guides.empty() || options.KeepOthers)
  {
    description += std::to_string(result.NumberOfSurfaces) + " surfaces of " + std::to_string(result.SmallestSize) +
      " picks or more, " + std::to_string(result.Surfaces.size() - found.Guides.size()) + " taken\n";
  }
  description.pop_back(); // This drops the last newline.
  found.Description = std::move(description);
}

/// Converts cube samples to lattice indices and world z.
void PlaceVoxels(LatticeHorizon& voxels, const ImageCube& cube)
{
  const int sign = static_cast<int>(cube.Frame.Direction);
  for (std::size_t n = 0; n < voxels.Column.size(); ++n)
  {
    voxels.Column[n].X += cube.FirstIndex[0];
    voxels.Column[n].Y += cube.FirstIndex[1];
    voxels.K[n] += cube.FirstIndex[2];
    voxels.RealZ[n] = sign * cube.Frame.Elevation(voxels.RealZ[n] + cube.FirstIndex[2]);
  }
}

}

//----------------------------------------------------------------------------------------------------------------------
FoundReflections FindReflections(ReflectionInputs inputs, const ExtractionOptions& options, const Monitor& monitor,
  std::shared_ptr<JoinedReflections>* kept)
{
  FoundReflections found;
  found.Cube = MakeImageCube(std::move(inputs.Image));
  if (inputs.Guides)
  {
    found.Guides = ReadGuides(*inputs.Guides, found.Cube);
  }
  std::vector<Guide> guides;
  for (const GuidePicks& guide : found.Guides)
  {
    guides.push_back(guide.Given);
  }
  if (inputs.Limits)
  {
    found.Limits = ReadLimits(*inputs.Limits, found.Cube, inputs.Side);
  }
  found.Result = ExtractReflections(found.Cube.Traces, options, monitor, guides, found.Limits.Traces, kept);
  DescribeReflections(options.Guidance, found);
  if (found.Result.IsBiased)
  {
    found.Warnings.push_back(
      "amplitudes keep one sign throughout most traces, expected amplitudes about 0: reflections "
      "of the other sign are missed; remedy: subtract the mean first (Calculator)");
  }
  for (std::size_t n = 0; n < found.Result.Surfaces.size(); ++n)
  {
    found.Names.push_back(n < guides.size() ? guides[n].Name : HorizonName(std::int64_t(n - guides.size()) + 1));
  }
  return found;
}

//----------------------------------------------------------------------------------------------------------------------
Horizon TakeSurface(FoundReflections& found, std::size_t number, bool useRealZ)
{
  found.Cube.Frame.UseRealZ = useRealZ;
  LatticeHorizon voxels = std::move(found.Result.Surfaces[number]);
  PlaceVoxels(voxels, found.Cube);
  Horizon horizon = MakeHorizonPoints(std::move(voxels), found.Cube.Frame);
  const ArrayTable& fields = found.Cube.Image.FieldData;
  AddSurveyFields(ReadSurveyFields(fields), horizon.FieldData);
  const DataArray* const lines = fields.Find(FieldArray::LineNumbers);
  if (lines && !lines->IsText())
  {
    horizon.FieldData.Add(*lines);
  }
  return horizon;
}
}
