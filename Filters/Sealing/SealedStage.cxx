// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Survey/DerivedArrays.h"
#include "Filters/Algorithms/Sealing/FaultNetwork.h"
#include "Filters/Algorithms/Sealing/SealedComplex.h"
#include "Filters/Algorithms/Sealing/SealedModel.h"
#include "Filters/Algorithms/Sealing/SurveyOutline.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/PlacedPoints.h"
#include "Filters/Common/StageReport.h"
#include "SealedOutput.h"
#include "SealedWarnings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// The coordinates of a model: from the first column along the axes of the lattice, right-handed.
struct ModelFrame
{
  Lattice Columns;
  bool IsTurned = false; // x is along j.
  Eigen::Vector2d Step;
  Eigen::Isometry2d ToModel;
};

ModelFrame FindFrame(const std::vector<CutInput>& horizons)
{
  ModelFrame frame;
  const auto finest = std::min_element(horizons.begin(), horizons.end(),
    [](const CutInput& a, const CutInput& b)
    {
      constexpr double rounding = 1e-6;
      return a.Points.Lattice.ColumnArea() < (1.0 - rounding) * b.Points.Lattice.ColumnArea();
    });
  frame.Columns = finest->Points.Lattice;
  frame.IsTurned = !frame.Columns.KeepsOrientation();
  const Eigen::Vector3d origin = frame.Columns.ToWorld(Eigen::Vector3d::Zero());
  Eigen::Vector2d x = (frame.Columns.ToWorld(Eigen::Vector3d::UnitX()) - origin).head<2>();
  Eigen::Vector2d y = (frame.Columns.ToWorld(Eigen::Vector3d::UnitY()) - origin).head<2>();
  if (frame.IsTurned)
  {
    std::swap(x, y);
  }
  constexpr double mostSkew = 1e-4;
  const double cosine = x.dot(y) / (x.norm() * y.norm());
  if (std::abs(cosine) > mostSkew)
  {
    throw InputError("lattice whose axes meet at " + std::to_string(std::acos(cosine) * DegreesPerRadian) +
      " degrees, expected 90 for a sealed model");
  }
  frame.Step = { x.norm(), y.norm() };
  Eigen::Matrix2d axes;
  axes.row(0) = x.normalized();
  axes.row(1) << -axes(0, 1), axes(0, 0);
  frame.ToModel.linear() = axes;
  frame.ToModel.translation() = -axes * origin.head<2>();
  frame.ToModel.makeAffine();
  return frame;
}

/// From the uppermost on: numbers of horizons.
std::vector<std::size_t> OrderHorizons(const CutoffModelData& model)
{
  std::vector<double> means;
  for (const CutHorizon& horizon : model.Horizons)
  {
    double sum = 0.0;
    for (const Eigen::Vector3d& place : horizon.Picks.Places)
    {
      sum += place.z();
    }
    means.push_back(sum / double(horizon.Picks.Places.size()));
  }
  std::vector<std::size_t> order(means.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&means](std::size_t a, std::size_t b) { return means[a] > means[b]; });
  return order;
}

std::vector<std::string> SplitList(const std::string& text)
{
  std::vector<std::string> words;
  std::string lines = text;
  std::replace(lines.begin(), lines.end(), ';', '\n');
  std::istringstream stream(lines);
  for (std::string word; std::getline(stream, word);)
  {
    const std::size_t first = word.find_first_not_of(" \t\r"), last = word.find_last_not_of(" \t\r");
    if (first != std::string::npos)
    {
      words.push_back(word.substr(first, last - first + 1));
    }
  }
  return words;
}

std::vector<EndingRule> ReadEndings(const std::string& text)
{
  std::vector<EndingRule> rules;
  for (const std::string& rule : SplitList(text))
  {
    const std::size_t sign = rule.find('>');
    const std::vector<std::string> minor = SplitList(rule.substr(0, sign));
    const std::vector<std::string> main = sign == std::string::npos ? minor : SplitList(rule.substr(sign + 1));
    if (sign == std::string::npos || minor.size() != 1 || main.size() != 1)
    {
      throw InputError("ending " + rule + ", expected a fault, >, and the fault that it ends at");
    }
    rules.push_back({ minor.front(), main.front() });
  }
  return rules;
}

std::vector<std::size_t> ReadUnconformities(const std::string& text, const SealingInput& input)
{
  std::vector<std::size_t> numbers;
  for (const std::string& name : SplitList(text))
  {
    const auto found = std::find_if(input.Horizons.begin(), input.Horizons.end(),
      [&name](const SealingHorizon& horizon) { return horizon.Name == name; });
    if (found == input.Horizons.end())
    {
      throw InputError("unconformity " + name + ", expected the name of a horizon");
    }
    numbers.push_back(std::size_t(found - input.Horizons.begin()));
  }
  return numbers;
}

/// Horizons and the box, without faults. Horizons below an unconformity may be eroded, and do not limit the box.
SealingInput MakeInput(const std::vector<CutInput>& horizons, const CutoffModelData& model, const ModelFrame& frame,
  double error, const std::vector<std::string>& unconformities)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SealingInput input;
  input.Step = frame.Step;
  std::array<double, 2> heights = { infinity, -infinity };
  PlaneBox common;
  for (const std::size_t number : OrderHorizons(model))
  {
    const HorizonNames names = { horizons[number].Name, "the horizon with the smallest columns" };
    SealingHorizon horizon;
    horizon.Name = horizons[number].Name;
    horizon.Columns = PlaceOn(frame.Columns, horizons[number].Points.Horizon, names).Columns;
    PlaneBox box;
    for (PlanePoint& column : horizon.Columns)
    {
      column = frame.IsTurned ? PlanePoint{ column.Y, column.X } : column;
      box.Add(column);
    }
    const bool isBelow = std::any_of(input.Horizons.begin(), input.Horizons.end(),
      [&](const SealingHorizon& above)
      { return std::find(unconformities.begin(), unconformities.end(), above.Name) != unconformities.end(); });
    if (isBelow)
    {
      box = common;
    }
    else if (!input.Horizons.empty())
    {
      box.Least = { std::max(common.Least.X, box.Least.X), std::max(common.Least.Y, box.Least.Y) };
      box.Greatest = { std::min(common.Greatest.X, box.Greatest.X), std::min(common.Greatest.Y, box.Greatest.Y) };
    }
    common = box;
    for (const Eigen::Vector3d& place : model.Horizons[number].Picks.Places)
    {
      horizon.Heights.push_back(place.z());
      heights = { std::min(heights[0], place.z()), std::max(heights[1], place.z()) };
    }
    horizon.AtFault = model.Horizons[number].AtFault;
    input.Horizons.push_back(std::move(horizon));
  }
  constexpr std::int32_t leastWidth = 3;
  if (common.Greatest.X - common.Least.X < leastWidth || common.Greatest.Y - common.Least.Y < leastWidth)
  {
    throw InputError("horizons without a common area, expected columns where all have points");
  }
  input.Least = common.Least;
  input.Greatest = common.Greatest;
  constexpr double beyond = 0.1, errors = 4.0;
  const double apart = errors * error * double(horizons.size());
  const double margin = std::max(beyond * (heights[1] - heights[0]) + frame.Step.maxCoeff(), apart);
  input.Top = heights[1] + margin;
  input.Base = heights[0] - margin;
  return input;
}

std::vector<FaultPlate> PlaceFaults(const CutoffModelData& cutoffs, const ModelFrame& frame)
{
  std::vector<FaultPlate> plates;
  for (std::size_t fault = 0; fault < cutoffs.Faults.size(); ++fault)
  {
    const FaultPlate& plate = cutoffs.Faults[fault];
    plates.push_back((cutoffs.AreTurned[fault] != 0 ? plate.Reversed() : plate).Moved(frame.ToModel));
  }
  return plates;
}

/// Adds the faults of the network, in its order, with the cutoffs of each.
void AddFaults(const FaultNetwork& network, SealingInput& input)
{
  input.Faults = network.Faults;
  for (SealingHorizon& horizon : input.Horizons)
  {
    std::vector<HorizonCutoffs> cutoffs;
    for (const std::size_t plate : network.Plates)
    {
      cutoffs.push_back(horizon.AtFault[plate]);
    }
    horizon.AtFault = std::move(cutoffs);
  }
}

/// Throws InputError for faults that were found in one horizon each: which of them are one is not known.
void RequireCommonFaults(const CutoffModelData& model)
{
  std::optional<std::size_t> first;
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    const std::vector<std::size_t>& only = model.OnlyHorizons[fault];
    if (only.size() != 1)
    {
      continue;
    }
    first = first.value_or(fault);
    if (model.OnlyHorizons[*first] != only)
    {
      throw InputError(model.Faults[*first].Name() + " and " + model.Faults[fault].Name() +
        ", each detected in a single horizon, expected sticks, or lines of the same name in all horizons that a "
        "fault cuts");
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
SealedStageResult RunSealed(const CutInputs& inputs, const SealedStageOptions& options, const Monitor& monitor)
{
  const std::vector<CutInput>& horizons = inputs.Horizons;
  if (ReadVerticalAxis(horizons.front().Points.Horizon.FieldData).IsTime)
  {
    throw InputError("horizons in time, expected depth for a sealed model");
  }
  CheckAtLeast("end distance", options.EndDistance, 0.0, " columns");
  const CutoffModelData cutoffs = RunCutoffs(horizons, inputs.Faults.Picks, options.Cutoffs, monitor.Step(0.0, 0.4));
  RequireCommonFaults(cutoffs);
  const ModelFrame frame = FindFrame(horizons);
  SealingOptions sealing;
  sealing.DropDistance = options.Cutoffs.DropDistance;
  sealing.MaximumError = 0.0;
  for (const CutHorizon& horizon : cutoffs.Horizons)
  {
    sealing.MaximumError = std::max(sealing.MaximumError, horizon.MaximumError);
  }
  if (!(sealing.MaximumError > 0.0))
  {
    throw InputError("maximum error 0, expected more for a sealed model");
  }
  SealingInput input = MakeInput(horizons, cutoffs, frame, sealing.MaximumError, SplitList(options.Unconformities));
  const Eigen::AlignedBox3d box = input.Box();
  FaultNetwork network = MakeNetwork(
    PlaceFaults(cutoffs, frame), box, frame.Step.minCoeff(), options.EndDistance, ReadEndings(options.Endings));
  const std::vector<std::size_t> unconformities = ReadUnconformities(options.Unconformities, input);
  if (EndAtHorizons(unconformities, input, box, network) == 0 && !unconformities.empty())
  {
    throw InputError(
      "unconformities at which no fault ends, expected faults with at most a tenth above the unconformity");
  }
  if (options.FollowsOutline)
  {
    input.Outline = FindSurveyOutline(input, monitor.Step(0.4, 0.42));
  }
  if (!options.GoesThrough)
  {
    EndAtTips(input, options.EndDistance, network);
  }
  AddFaults(network, input);
  constexpr double partOfColumn = 0.25;
  sealing.FaultError = std::max(sealing.MaximumError, partOfColumn * frame.Step.minCoeff());
  SealedModel model = SealModel(input, sealing, monitor.Step(0.42, 0.95));
  const Eigen::Isometry2d toWorld = frame.ToModel.inverse();
  for (Eigen::Vector3d& vertex : model.Vertices)
  {
    vertex.head<2>() = toWorld * Eigen::Vector2d(vertex.head<2>());
  }
  SealedStageResult result;
  WriteSealed(model, inputs.Fields, result);
  for (const std::vector<std::string>& warnings :
    { inputs.Faults.Warnings, cutoffs.Warnings, WarnOfSealed(model, network, input, cutoffs, sealing.MaximumError) })
  {
    result.Warnings.insert(result.Warnings.end(), warnings.begin(), warnings.end());
  }
  monitor.Progress(1.0);
  return result;
}
}
