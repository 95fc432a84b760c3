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
#include "Filters/Algorithms/Faults/ColumnHeights.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LatticePoints.h"
#include "Filters/Common/StageReport.h"
#include "Filters/Faults/FaultWarnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void CheckOptions(const CutoffStageOptions& options)
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

// ---- Traces ---------------------------------------------------------------------------------------------------------

/// By fault; names in the order of the first cuts.
struct HorizonTraces
{
  std::vector<std::string> Names;
  std::map<std::string, std::vector<std::vector<TraceCut>>> ByFault;
  std::map<std::string, std::vector<std::size_t>> Horizons; // by fault
};

/// Heights are those of the nearest columns with a point along the link. Cuts without one on both sides are left out.
std::map<int, std::vector<TraceCut>> ReadTraceCuts(const LatticePoints& points, const DataArray& numbers, double gap)
{
  const std::vector<LatticeLink> links = ReadFaultedLinks(points.Horizon);
  RequireTuples(numbers, std::int64_t(links.size()), "faulted links");
  const ColumnHeights heights(points.Column, points.Height);
  const LinkGrid& grid = heights.Grid();
  const auto find = [&](PlanePoint column, const PlanePoint& step) -> std::optional<Eigen::Vector3d>
  {
    for (double n = 0.0; n <= gap; ++n, column = { column.X + step.X, column.Y + step.Y })
    {
      const std::int64_t x = std::int64_t(column.X) - grid.Origin().X, y = std::int64_t(column.Y) - grid.Origin().Y;
      const bool isIn = x >= 0 && y >= 0 && x < grid.Width() && y < grid.Height();
      if (!isIn)
      {
        return std::nullopt;
      }
      const double height = heights[grid.ColumnOf(column)];
      if (!std::isnan(height))
      {
        return points.Lattice.ToWorld(Eigen::Vector3d(column.X, column.Y, height));
      }
    }
    return std::nullopt;
  };
  std::map<int, std::vector<TraceCut>> lines;
  for (std::size_t n = 0; n < links.size(); ++n)
  {
    const PlanePoint from = links[n].Column, to = links[n].Beyond();
    const PlanePoint step = { to.X - from.X, to.Y - from.Y };
    const auto before = find(from, { -step.X, -step.Y }), beyond = find(to, step);
    if (before && beyond)
    {
      const Eigen::Vector2d way = (*beyond - *before).head<2>();
      const double link = (points.Lattice.ToWorld({ double(to.X), double(to.Y), 0.0 }) -
        points.Lattice.ToWorld({ double(from.X), double(from.Y), 0.0 }))
                            .head<2>()
                            .norm();
      lines[int(numbers.Value(std::int64_t(n)))].push_back(
        { 0.5 * (*before + *beyond), (before->z() - beyond->z()) * way.normalized(), way.norm() - link });
    }
  }
  return lines;
}

void AddTraces(const CutInput& horizon, std::size_t own, double gap, HorizonTraces& traces)
{
  const LatticePoints& points = horizon.Points;
  const DataArray* const numbers = FindNumbers(points.Horizon.FieldData, FieldArray::FaultLine);
  const DataArray* const faults = points.Horizon.FieldData.Find(FieldArray::FaultNames);
  if (!numbers)
  {
    return;
  }
  for (auto& [number, cuts] : ReadTraceCuts(points, *numbers, gap))
  {
    constexpr std::size_t fewest = 3;
    if (cuts.size() < fewest)
    {
      continue;
    }
    const bool isNamed = faults && faults->IsText() && number >= 0 && number < int(faults->Texts().size());
    std::string fault = isNamed ? faults->Texts()[std::size_t(number)] : "fault " + std::to_string(number + 1);
    if (fault.rfind("fault ", 0) == 0) // Numbers of detected faults are those of one horizon.
    {
      fault = horizon.Name + " " + fault;
    }
    std::vector<std::vector<TraceCut>>& ofFault = traces.ByFault[fault];
    if (ofFault.empty())
    {
      traces.Names.push_back(fault);
    }
    ofFault.push_back(std::move(cuts));
    traces.Horizons[fault].push_back(own);
  }
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

std::vector<FaultPicks> PickCuts(const std::vector<CutInput>& horizons, const CutoffStageOptions& options)
{
  HorizonTraces traces;
  double column = 0.0, index = 0.0;
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    index = std::max(index, WorldPerIndex(horizons[n].Points.Lattice));
    AddTraces(horizons[n], n, options.LargestGap, traces);
    column = std::max(column, std::sqrt(horizons[n].Points.Lattice.ColumnArea()));
  }
  std::vector<FaultPicks> picks;
  for (const std::string& fault : traces.Names)
  {
    picks.push_back(PickTraces(fault, traces.ByFault[fault], options.Dip, column, index));
    picks.back().Horizons = traces.Horizons[fault];
  }
  return picks;
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
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    double sum = 0.0, column = 0.0;
    for (const CutHorizon& horizon : model.Horizons)
    {
      sum += SumOfThrows(horizon.AtFault[fault]);
      column = std::max(column, horizon.Picks.LargestStep());
    }
    for (CutHorizon& horizon : model.Horizons)
    {
      if (sum < 0.0 && model.Faults[fault].IsUpright(column))
      {
        SwapWalls(horizon.AtFault[fault]);
      }
    }
  }
}

/// Faults and cutoffs that are not there, or are mostly guessed.
std::vector<std::string> WarnOfCutoffs(const CutoffModelData& model)
{
  std::vector<std::string> idle, missed, far, shortOnes;
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    const FaultPlate& plate = model.Faults[fault];
    bool doesCut = false;
    double column = 0.0;
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
      column = std::max(column, horizon.Picks.LargestStep());
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
    warnings.push_back("faults that are off their picks, or turn too far along strike (" + ListFaults(missed) +
      "), expected surfaces whose strike is within 60 degrees of its mean, without stray picks");
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
  CheckOptions(options);
  CutoffModelData model;
  for (const CutInput& horizon : horizons)
  {
    model.Horizons.push_back(ReadCutHorizon(horizon.Name, horizon.Points, options));
  }
  if (given && given->NumberAlone > 0)
  {
    const std::string faults = given->Alone.empty() ? "" : " (" + ListFaults(given->Alone) + ")";
    model.Warnings.push_back(std::to_string(given->NumberAlone) + " fault sticks" + faults +
      " join no surface, expected two sticks of two points for each fault, beside each other");
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
  monitor.Progress(0.1);
  model.Faults = MakePlates(picks, monitor.Step(0.1, 0.2));
  FindAllCutoffs(picks, options, model, monitor.Step(0.2, 1.0));
  TurnUprightFaults(model);
  const std::vector<std::string> warnings = WarnOfCutoffs(model);
  model.Warnings.insert(model.Warnings.end(), warnings.begin(), warnings.end());
  return model;
}
}
