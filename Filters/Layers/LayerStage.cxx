// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/Text/TextFields.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "Filters/Algorithms/Layers/LayerBody.h"
#include "Filters/Algorithms/Layers/LayerCells.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "LayerFigures.h"
#include "LayerOutput.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
void RequireFullColumns(const HorizonStack& stack)
{
  for (std::size_t n = 0; n < stack.Size(); ++n)
  {
    const int radius = ChooseRadius(stack[n].Placed.Columns);
    if (radius > 1)
    {
      throw InputError(stack[n].Name + " with steps of " + std::to_string(radius) +
        " columns from point to point, expected 1 for the domain EachLayer: choose Common, or Missing Interpolate");
    }
  }
}

LayerOptions MakeLayerOptions(const LayerStageOptions& given, const HorizonStack& stack)
{
  CheckAtLeast("smallest pinch", given.SmallestPinch, 1, " column");
  CheckAtLeast("largest hole size", given.LargestHoleSize, 0, " columns");
  CheckWithin("largest gap", given.LargestGap, 0, 255, " columns");
  if (given.Contact && !std::isfinite(*given.Contact))
  {
    throw InputError("contact " + std::to_string(*given.Contact) + ", expected a finite number");
  }
  LayerOptions options;
  options.Crossings = MakeCrossings(given, stack);
  options.BoundThickness = given.BoundThickness;
  const bool isCommon = given.Domain == LayerDomain::Common || stack.Size() == 2;
  options.Domain = isCommon ? LayerDomain::Common : LayerDomain::EachLayer;
  options.Missing = { given.Missing, given.LargestHoleSize, given.LargestGap };
  if (isCommon && given.KeepOutlines)
  {
    options.OutlineTolerance = 0.0;
    options.SmallestHoleSize = 1;
  }
  options.PinchOutLines = given.PinchOutLines;
  options.SmallestPinch = given.SmallestPinch;
  static_cast<LayerQuality&>(options) = given;
  return options;
}

ErrorLimit FindErrorLimit(const LayerStageOptions& given, const HorizonStack& stack)
{
  if (given.MaximumError)
  {
    CheckAtLeast("maximum error", *given.MaximumError, 0.0, ", or -1 for automatic");
    return { IndicesOf(given, *given.MaximumError, stack), std::nullopt };
  }
  HeightNoise most;
  for (std::size_t n = 0; n < stack.Size(); ++n)
  {
    const HeightNoise noise = MeasureHeightNoise(stack[n].Placed.Columns, stack[n].Placed.Height);
    most = noise.Deviation > most.Deviation ? noise : most;
  }
  return { most.MaximumError(), most };
}

/// Then `volumes` count cells, not triangles.
LayerCellOptions MakeCellOptions(
  const LayerStageOptions& given, const HorizonStack& stack, std::vector<LayerVolume>& volumes)
{
  constexpr double most = 1000.0;
  constexpr double rounding = 1e-9;
  CheckAtLeast("largest sublayer thickness", given.LargestSublayerThickness, 0.0, ", with 0 for any");
  std::istringstream words(given.Sublayers);
  const std::vector<std::string> numbers(std::istream_iterator<std::string>(words), {});
  if (numbers.size() > 1 && numbers.size() != volumes.size())
  {
    throw InputError("sublayers of " + std::to_string(numbers.size()) + " layers, expected one number, or " +
      std::to_string(volumes.size()) + " from the uppermost on");
  }
  const double largest = IndicesOf(given, given.LargestSublayerThickness, stack);
  LayerCellOptions options;
  options.Tetrahedra = given.Tetrahedra;
  for (std::size_t layer = 0; layer < volumes.size(); ++layer)
  {
    const std::string text = numbers.empty() ? "1" : numbers[std::min(layer, numbers.size() - 1)];
    double number = 0.0;
    const bool isWhole = ReadNumber(text, number) == NumberKind::Finite && std::floor(number) == number;
    const double needed = largest > 0.0 ? std::ceil(volumes[layer].LargestThickness / largest - rounding) : 1.0;
    if (!isWhole || number < 1.0 || std::max(number, needed) > most)
    {
      const std::string found = needed > most ? "more by LargestSublayerThickness" : text;
      throw InputError(
        "sublayers of " + NamesOfLayers(stack)[layer] + ": " + found + ", expected 1 to " + std::to_string(int(most)));
    }
    options.Sublayers.push_back(int(std::max(number, needed)));
    std::array<std::int64_t, 4>& kinds = volumes[layer].Triangles;
    kinds = given.Tetrahedra ? std::array<std::int64_t, 4>{ kinds[0], kinds[1] + 2 * kinds[2] + 3 * kinds[3] } : kinds;
    std::for_each(kinds.begin() + 1, kinds.end(), [&](std::int64_t& count) { count *= options.Sublayers[layer]; });
  }
  return options;
}

// ---- Warnings -------------------------------------------------------------------------------------------------------

void WarnOfEmpty(const std::vector<LayerVolume>& volumes, const HorizonStack& stack, std::vector<std::string>& warnings)
{
  std::vector<std::string> empty;
  for (std::size_t layer = 0; layer < volumes.size(); ++layer)
  {
    if (volumes[layer].Volume == 0.0)
    {
      empty.push_back(NamesOfLayers(stack)[layer]);
    }
  }
  if (!empty.empty())
  {
    warnings.push_back(empty.front() +
      (empty.size() > 1 ? ", and " + std::to_string(empty.size() - 1) + " more," : "") +
      " without a cell, expected horizons that are apart by more than the error over an area that both have");
  }
}

void WarnOfContact(const std::optional<double>& contact, const ArrayTable& curve, std::vector<std::string>& warnings)
{
  const DataArray* const contacts = curve.Find("Contact");
  if (!contact || !contacts)
  {
    return;
  }
  const auto* const values = contacts->As<double>();
  const auto [least, most] = std::minmax_element(values, values + contacts->Tuples());
  if (*contact < *least || *contact > *most)
  {
    std::ostringstream text;
    text << "contact " << *contact << (*contact > *most ? " above" : " below") << " all layers, expected a z from "
         << *least << " to " << *most << ": depths and times are negative";
    warnings.push_back(text.str());
  }
}

void WarnOfCrossings(const CrossingRepair& repair, const std::vector<CrossingPolicy>& policies,
  const HorizonStack& stack, std::vector<std::string>& warnings)
{
  constexpr double MostOfNoise = 6.0; // that noise makes horizons cross by
  std::vector<std::optional<double>> noise(stack.Size());
  const auto noiseOf = [&](std::size_t horizon)
  {
    if (!noise[horizon])
    {
      noise[horizon] = MeasureNoise(stack[horizon].Placed.Columns, stack[horizon].Placed.Height);
    }
    return *noise[horizon];
  };
  const auto depthOf = [&](std::size_t layer) { return repair.Interfaces[layer].Largest; };
  std::size_t deep = 0; // crossings
  std::size_t deepest = 0; // the layer of the deepest of these
  for (std::size_t layer = 0; layer < repair.Interfaces.size(); ++layer)
  {
    const bool isMean = policies[std::min(layer, policies.size() - 1)] == CrossingPolicy::Mean;
    if (isMean && depthOf(layer) > 1.0 &&
      depthOf(layer) > 1.0 + MostOfNoise * std::hypot(noiseOf(layer), noiseOf(layer + 1)))
    {
      deepest = deep == 0 || depthOf(layer) > depthOf(deepest) ? layer : deepest;
      ++deep;
    }
  }
  if (deep > 0)
  {
    const std::string unit = stack.GetSurvey().VerticalUnit;
    std::ostringstream text;
    text << stack[deepest].Name << " and " << stack[deepest + 1].Name
         << (deep > 1 ? ", and " + std::to_string(deep - 1) + " other pairs," : "") << " cross by up to "
         << depthOf(deepest) * WorldPerIndex(stack.CommonLattice()) << (unit.empty() ? "" : " ") << unit
         << ", expected no more than their noise makes: at an unconformity choose UpperWins or LowerWins";
    warnings.push_back(text.str());
  }
}

// ---- Output ---------------------------------------------------------------------------------------------------------

void WriteLayers(const Layers& layers, const HorizonStack& stack, const LayerStageOptions& given,
  LayerStageResult& result, const Monitor& monitor)
{
  const LayerPlan& plan = layers.Plan;
  const auto numberOf = double(plan.NumberOfHorizons());
  const auto part = [numberOf](std::size_t n) { return double(n) / numberOf; };
  std::vector<LayerVolume> volumes;
  for (std::size_t layer = 0; layer < plan.NumberOfLayers(); ++layer)
  {
    volumes.push_back(MeasureLayer(plan, layer));
  }
  const LayerCells cells = MakeLayerCells(plan, MakeCellOptions(given, stack, volumes), monitor.Step(0.0, 0.15));
  WriteLayerCells(cells, plan, stack, result.Layers);
  for (std::size_t layer = 0; layer < plan.NumberOfLayers(); ++layer)
  {
    const Monitor step = monitor.Step(0.2, 0.6).Step(part(layer), part(layer + 1));
    Horizon& body = result.Bodies.emplace_back();
    WriteLayerBody(MakeLayerBody(plan, layer, step.Step(0.0, 0.9)), plan, layer, stack, body);
    WriteLayerLedger(layers.Ledgers.OfLayers[layer], stack, body.FieldData);
    step.Progress(1.0);
  }
  for (std::size_t horizon = 0; horizon < plan.NumberOfHorizons(); ++horizon)
  {
    WriteLayerHorizon(layers, cells, horizon, stack, result.Horizons.emplace_back());
    monitor.Step(0.6, 0.85).Progress(part(horizon + 1));
  }
  WriteLayerTable(layers, volumes, stack, given.Contact, result.Figures);
  WriteVolumeCurve(plan, stack, result.Volumes, monitor.Step(0.85, 1.0));
  WarnOfContact(given.Contact, result.Volumes, result.Warnings);
  result.Report = ReportLayers(layers, volumes, stack);
  WarnOfEmpty(volumes, stack, result.Warnings);
  const bool isOneLayer = stack.Size() == 2;
  const char* const ofDomain = isOneLayer || given.Domain == LayerDomain::EachLayer ? "" : ": Domain EachLayer leaves out less";
  const char* const advice = given.Missing == MissingPolicy::Follow ? ofDomain : ": Missing Follow leaves out less";
  const std::vector<std::string> missing = ReportMissing(layers.Ledgers, stack, advice);
  result.Warnings.insert(result.Warnings.end(), missing.begin(), missing.end());
}

void WriteChosenError(const ErrorLimit& limit, const HorizonStack& stack, LayerStageResult& result)
{
  AddValue<double>(result.Layers.FieldData, FieldArray::ChosenMaximumError, limit.Indices);
  WriteHeightNoise(*limit.Noise, result.Layers.FieldData);
  std::ostringstream text;
  const std::string unit = stack.GetSurvey().VerticalUnit;
  text << "maximum error " << limit.Indices * WorldPerIndex(stack.CommonLattice()) << ' '
       << (unit.empty() ? "in z" : unit) << ", six times the " << (limit.Noise->IsRounding ? "rounding" : "noise")
       << "\n";
  result.Report += text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string WarnOfTime(const HorizonStack& stack)
{
  return stack.GetSurvey().VerticalDomain == "time" ? "z is time, so that volumes are areas times time, expected "
                                                      "depths for volumes: convert the horizons to depth before"
                                                    : "";
}

//----------------------------------------------------------------------------------------------------------------------
LayerStageResult RunLayers(const HorizonStack& stack, const LayerStageOptions& given, const Monitor& monitor)
{
  LayerOptions options = MakeLayerOptions(given, stack);
  const ErrorLimit limit = FindErrorLimit(given, stack);
  options.MaximumError = limit.Indices;
  if (options.Domain == LayerDomain::EachLayer && given.Missing == MissingPolicy::Void)
  {
    RequireFullColumns(stack);
  }
  const std::optional<LinkCuts> cuts = given.TearAtFaults ? stack.FindCuts() : std::nullopt;
  options.Cuts = cuts ? &*cuts : nullptr;
  const Layers layers = MakeLayers(stack.Views(), options, monitor.Step(0.1, 0.7));
  LayerStageResult result;
  WriteLayers(layers, stack, given, result, monitor.Step(0.7, 1.0));
  if (limit.Noise)
  {
    WriteChosenError(limit, stack, result);
  }
  WarnOfCrossings(layers.Stack.Repair, options.Crossings.Policies, stack, result.Warnings);
  return result;
}
}
