// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/LedgerFields.h"
#include "Common/Survey/DerivedArrays.h"
#include "CutTraces.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/StageReport.h"
#include "Filters/Faults/FaultWarnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void CheckCutoffOptions(const CutoffStageOptions& options)
{
  if (options.Dip != 0.0)
  {
    CheckWithin("dip", options.Dip, 5.0, 90.0, " degrees, or 0");
  }
  CheckAtLeast("drop distance", options.DropDistance, 0.0, " columns");
  CheckAtLeast("drop noise", options.DropNoise, 0.0, "");
  CheckAtLeast("largest gap", options.LargestGap, 1.0, " columns");
  CheckAtLeast("smallest length", options.SmallestLength, 2.0, " columns");
  if (options.MaximumError)
  {
    CheckAtLeast("maximum error", *options.MaximumError, 0.0, "");
  }
}

CutHorizon ReadCutHorizon(const std::string& name, const LatticePoints& points, const CutoffStageOptions& options)
{
  CutHorizon horizon;
  horizon.Name = name;
  const double index = WorldPerIndex(points.Lattice);
  const HeightNoise noise = MeasureHeightNoise(points.Column, points.Height);
  const Eigen::Vector3d origin = points.Lattice.ToWorld({ 0.0, 0.0, 0.0 });
  horizon.Picks.Steps.col(0) = (points.Lattice.ToWorld({ 1.0, 0.0, 0.0 }) - origin).head<2>();
  horizon.Picks.Steps.col(1) = (points.Lattice.ToWorld({ 0.0, 1.0, 0.0 }) - origin).head<2>();
  horizon.Picks.IsRounded = noise.IsRounding;
  horizon.Picks.Noise = index * noise.Deviation;
  horizon.MaximumError = !options.MaximumError
    ? index * noise.MaximumError()
    : *options.MaximumError * (options.ErrorUnit == HeightUnit::World ? 1.0 : index);
  const std::int64_t size = points.Horizon.NumberOfPoints();
  horizon.Picks.Places.reserve(std::size_t(size));
  for (std::int64_t point = 0; point < size; ++point)
  {
    horizon.Picks.Places.push_back(points.Horizon.Place(point));
  }
  return horizon;
}

std::vector<FaultPlate> MakePlates(const std::vector<FaultPicks>& picks, const Monitor& monitor)
{
  std::vector<FaultPlate> plates;
  for (std::size_t n = 0; n < picks.size(); ++n)
  {
    plates.emplace_back(picks[n], monitor);
    monitor.Progress(double(n + 1) / double(picks.size()));
  }
  return plates;
}

std::string RangeText(const std::array<double, 2>& range)
{
  std::ostringstream text = MakeReportStream();
  text << range[0] << " to " << range[1];
  return text.str();
}

/// Throws the InputError of a model without cutoffs, with the likely cause.
[[noreturn]] void RefuseUncut(const CutoffModelData& model)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> ofFaults = { infinity, -infinity }, ofPicks = { infinity, -infinity };
  bool areShort = false;
  for (const FaultPlate& fault : model.Faults)
  {
    ofFaults = { std::min(ofFaults[0], fault.Lowest() + fault.Datum()),
      std::max(ofFaults[1], fault.Highest() + fault.Datum()) };
  }
  for (const CutHorizon& horizon : model.Horizons)
  {
    for (const Eigen::Vector3d& place : horizon.Picks.Places)
    {
      ofPicks = { std::min(ofPicks[0], place.z()), std::max(ofPicks[1], place.z()) };
    }
    areShort = areShort ||
      std::any_of(horizon.AtFault.begin(), horizon.AtFault.end(), [](const auto& own) { return own.Short > 0; });
  }
  const std::string none = "no cutoff of " + std::to_string(model.Horizons.size()) + " horizons at " +
    std::to_string(model.Faults.size()) + " faults, ";
  if (areShort)
  {
    throw InputError(none + "expected some that are longer than SmallestLength");
  }
  if (ofFaults[1] < ofPicks[0] || ofFaults[0] > ofPicks[1])
  {
    throw InputError(none + "with z from " + RangeText(ofFaults) + ", expected faults at the heights of the picks, " +
      RangeText(ofPicks) + ": z may count the other way");
  }
  throw InputError(none +
    "expected picks on both sides of a fault, within LargestGap and beyond DropDistance, and faults in the "
    "coordinates of the horizons");
}

/// Throws InputError if there is none.
void FindAllCutoffs(const std::vector<FaultPicks>& picks, const CutoffStageOptions& options, CutoffModelData& model,
  const Monitor& monitor)
{
  CutoffFitOptions fit;
  fit.DropDistance = options.DropDistance;
  fit.DropNoise = options.DropNoise;
  fit.LargestGap = options.LargestGap;
  const double step = 1.0 / double(model.Horizons.size() * model.Faults.size());
  bool areThere = false;
  double done = 0.0;
  for (std::size_t n = 0; n < model.Horizons.size(); ++n)
  {
    CutHorizon& horizon = model.Horizons[n];
    std::vector<const FaultPlate*> cutting;
    for (std::size_t fault = 0; fault < picks.size(); ++fault)
    {
      const std::vector<std::size_t>& only = picks[fault].Horizons;
      if (only.empty() || std::find(only.begin(), only.end(), n) != only.end())
      {
        cutting.push_back(&model.Faults[fault]);
      }
    }
    for (const FaultPlate& fault : model.Faults)
    {
      const bool doesCut = std::find(cutting.begin(), cutting.end(), &fault) != cutting.end();
      horizon.AtFault.push_back(!doesCut
          ? HorizonCutoffs()
          : FindCutoffs(fault, cutting, horizon.Picks, fit, options.SmallestLength, monitor.Step(done, done + step)));
      areThere = areThere || !horizon.AtFault.back().Pieces.empty();
      done += step;
    }
  }
  if (!areThere)
  {
    RefuseUncut(model);
  }
}

/// Where no horizon tells the hanging wall of an upright fault, it stays as it is.
void TurnUprightFaults(CutoffModelData& model)
{
  const double column = model.LargestStep();
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    double sum = 0.0;
    for (const CutHorizon& horizon : model.Horizons)
    {
      sum += SumOfThrows(horizon.AtFault[fault]);
    }
    model.AreTurned.push_back(sum < 0.0 && model.Faults[fault].IsUpright(column) ? 1 : 0);
    for (CutHorizon& horizon : model.Horizons)
    {
      if (model.AreTurned.back() != 0)
      {
        SwapWalls(horizon.AtFault[fault]);
      }
    }
  }
}

/// Faults and cutoffs that are not there, or are mostly guessed.
std::vector<std::string> WarnOfCutoffs(const CutoffModelData& model)
{
  const double column = model.LargestStep();
  std::vector<std::string> idle, missed, far, shortOnes;
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    const FaultPlate& plate = model.Faults[fault];
    bool doesCut = false;
    for (const CutHorizon& horizon : model.Horizons)
    {
      const HorizonCutoffs& own = horizon.AtFault[fault];
      const std::string name = horizon.Name + " at " + plate.Name();
      std::size_t guessed = 0, places = 0;
      for (const CutoffPiece& piece : own.Pieces)
      {
        places += piece.Pairs.size();
        guessed += std::size_t(std::count_if(
          piece.Pairs.begin(), piece.Pairs.end(), [](const CutoffPair& pair) { return pair.IsGuessed(); }));
      }
      doesCut = doesCut || places > 0 || own.Short > 0;
      if (2 * guessed > places)
      {
        far.push_back(name);
      }
      if (own.Short > 0)
      {
        shortOnes.push_back(name);
      }
    }
    constexpr double mostMiss = 1.5, mostTurn = 2.0; // columns; the tangent of 63 degrees
    if (plate.LargestMiss() > mostMiss * column || plate.LargestTurn() > mostTurn)
    {
      missed.push_back(plate.Name());
    }
    if (!doesCut)
    {
      idle.push_back(plate.Name());
    }
  }
  std::vector<std::string> warnings;
  if (!idle.empty())
  {
    warnings.push_back(std::to_string(idle.size()) + " of " + std::to_string(model.Faults.size()) + " faults (" +
      ListFaults(idle) + ") cut no horizon, expected picks on both sides within LargestGap, at heights of the fault");
  }
  if (!missed.empty())
  {
    warnings.push_back("fault surfaces that miss their picks or turn too far along strike (" + ListFaults(missed) +
      "), expected a strike within 60 degrees of its mean, and no stray picks");
  }
  if (!far.empty())
  {
    warnings.push_back("cutoffs that are guessed over more than half of their length (" + ListFaults(far) +
      "), expected picks that agree within two columns");
  }
  if (!shortOnes.empty())
  {
    warnings.push_back("cutoffs left out (" + ListFaults(shortOnes) + "), expected at least SmallestLength");
  }
  return warnings;
}
}

//----------------------------------------------------------------------------------------------------------------------
double CutoffModelData::LargestStep() const
{
  double largest = 0.0;
  for (const CutHorizon& horizon : this->Horizons)
  {
    largest = std::max(largest, horizon.Picks.LargestStep());
  }
  return largest;
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadCutPoints(const Horizon& horizon)
{
  CheckArraySizes(horizon);
  const Horizon visible = WithoutHiddenPoints(horizon);
  RequireAllPoints(visible);
  const std::vector<unsigned char> isFilled = ReadFilled(visible);
  if (isFilled.empty())
  {
    return ReadColumns(visible);
  }
  Horizon picked;
  const auto isPick = [&isFilled](std::size_t point) { return isFilled[point] == 0; };
  CopyPoints(visible, KeptPoints::If(isFilled.size(), isPick), picked);
  picked.FieldData = visible.FieldData;
  return ReadColumns(picked);
}

//----------------------------------------------------------------------------------------------------------------------
CutoffModelData RunCutoffs(const std::vector<CutInput>& horizons, const std::optional<PickedSticks>& given,
  const CutoffStageOptions& options, const Monitor& monitor)
{
  CheckCutoffOptions(options);
  CutoffModelData model;
  for (const CutInput& horizon : horizons)
  {
    model.Horizons.push_back(ReadCutHorizon(horizon.Name, horizon.Points, options));
  }
  if (given && given->NumberAlone > 0)
  {
    const std::string faults = given->Alone.empty() ? "" : " (" + ListFaults(given->Alone) + ")";
    model.Warnings.push_back(std::to_string(given->NumberAlone) + " fault sticks" + faults +
      " form no surface, expected at least two adjacent sticks of two points for each fault");
  }
  const VerticalAxis axis = ReadVerticalAxis(horizons.front().Points.Horizon.FieldData);
  if (options.Dip > 0.0 && axis.IsTime)
  {
    throw InputError("dip of faults in time, expected 0, or horizons in depth");
  }
  const std::vector<FaultPicks> picks = given ? given->Faults : PickCuts(horizons, options);
  if (picks.empty())
  {
    throw InputError(given ? "no fault among the fault lines, expected two sticks of each fault, or its surface"
                           : "horizons without faults, expected sticks or surfaces of faults as second input, or "
                             "horizons that Horizon Faults has cut");
  }
  std::transform(picks.begin(), picks.end(), std::back_inserter(model.OnlyHorizons),
    [](const FaultPicks& own) { return own.Horizons; });
  monitor.Progress(0.1);
  model.Faults = MakePlates(picks, monitor.Step(0.1, 0.2));
  FindAllCutoffs(picks, options, model, monitor.Step(0.2, 1.0));
  TurnUprightFaults(model);
  const std::vector<std::string> warnings = WarnOfCutoffs(model);
  model.Warnings.insert(model.Warnings.end(), warnings.begin(), warnings.end());
  return model;
}
}
