// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DespikingStage.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"

#include <algorithm>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t SpikesPort = 1;
constexpr double FewPercent = 2.0; // percent of points; picks of a tracker have fewer spikes
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> RunDespiking(
  const Horizon& horizon, DespikingStageOptions options, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon));
  WriteDeviation(points, outputs);
  const Horizon& input = points.Horizon;
  monitor.Progress(0.2);
  CheckAtLeast("threshold", options.Threshold, 0.0, "");
  options.Threshold *= IndicesPerUnit(options.ThresholdUnit, points.Column, points.Height, points.Lattice);
  const Spikes found = FindSpikes(points.Column, points.Height, options, monitor.Step(0.2, 0.9));
  const std::vector<SpikeKind>& kinds = found.Kind;
  Horizon& output = outputs.front();
  const auto isOther = [&kinds](std::size_t point) { return kinds[point] == SpikeKind::None; };
  CopyPoints(input, options.Remove ? KeptPoints::If(kinds.size(), isOther) : KeptPoints::All(kinds.size()), output);
  const auto addKinds = [](const std::vector<SpikeKind>& of, Horizon& to)
  {
    AddArray<unsigned char>(
      to.PointData, PointArray::Spike, of, [](SpikeKind kind) { return static_cast<unsigned char>(kind); });
  };
  if (!options.Remove)
  {
    addKinds(kinds, output);
  }
  if (outputs.size() > SpikesPort)
  {
    const auto spikes = KeptPoints::If(kinds.size(), [&isOther](std::size_t point) { return !isOther(point); });
    CopyPoints(input, spikes, outputs[SpikesPort]);
    addKinds(spikes.Select(kinds), outputs[SpikesPort]);
  }
  for (Horizon& made : outputs)
  {
    made.PointData.Remove(PointArray::PatchId);
    made.PointData.Remove(PointArray::Boundary);
  }
  const std::int64_t spikes = std::count(kinds.begin(), kinds.end(), SpikeKind::Spike);
  const std::int64_t spurs = std::count(kinds.begin(), kinds.end(), SpikeKind::Spur);
  AddValue<std::int64_t>(output.FieldData, FieldArray::NumberOfSpikes, spikes);
  AddValue<std::int64_t>(output.FieldData, FieldArray::NumberOfSpurPoints, spurs);
  AddValue<double>(output.FieldData, FieldArray::SpikeThreshold, found.Threshold);
  std::vector<std::string> warnings;
  if (100.0 * double(spikes) / double(kinds.size()) > FewPercent)
  {
    const std::string unit = ReadSurveyFields(input.FieldData).VerticalUnit;
    std::ostringstream text;
    text << spikes << " of " << kinds.size() << " points are spikes, expected at most " << FewPercent
         << " %: threshold " << found.Threshold << " vertical indices, "
         << found.Threshold * WorldPerIndex(points.Lattice) << ' ' << (unit.empty() ? "in z" : unit)
         << "; terrain and faults may be mistaken for spikes";
    warnings.push_back(text.str());
  }
  if (2 * spurs > std::int64_t(kinds.size()))
  {
    warnings.push_back(std::to_string(spurs) + " of " + std::to_string(kinds.size()) +
      " points are on spurs, expected less than half: picks of every second line, or with many holes, look like spurs");
  }
  return warnings;
}
}
