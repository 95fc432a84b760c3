// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultInput.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/PlacedPoints.h"
#include "Filters/Faults/FaultStage.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
bool IsSurface(const Horizon& data)
{
  for (std::int64_t cell = 0; cell < data.Polygons.Size(); ++cell)
  {
    if (data.Polygons.Length(cell) != 3)
    {
      return false;
    }
  }
  return data.Polygons.Size() > 0 && data.Lines.Size() == 0;
}

/// Triangles by FaultName, or all as one surface.
void AddSurfaces(const NamedHorizon& block, std::size_t number, std::vector<FaultPicks>& faults)
{
  const DataArray* const names = block.Data.CellData.Find(CellArray::FaultName);
  if (names && names->IsText())
  {
    RequireTuples(*names, block.Data.NumberOfCells(), "cells");
  }
  std::vector<std::pair<std::string, std::vector<SpaceTriangle>>> surfaces;
  const std::vector<std::array<PointId, 3>> triangles = ReadTriangles(block.Data);
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    const std::string given =
      names && names->IsText() ? names->Texts()[std::size_t(block.Data.Vertices.Size()) + n] : "";
    const std::string name = !given.empty() ? given
      : !block.Name.empty()                 ? block.Name
                                            : "fault " + std::to_string(number + 1);
    auto surface = std::find_if(
      surfaces.begin(), surfaces.end(), [&name](const auto& candidate) { return candidate.first == name; });
    if (surface == surfaces.end())
    {
      surfaces.push_back({ name, {} });
      surface = surfaces.end() - 1;
    }
    const auto [a, b, c] = triangles[n];
    surface->second.push_back({ block.Data.Place(a), block.Data.Place(b), block.Data.Place(c) });
    for (const Eigen::Vector3d& place : surface->second.back())
    {
      if (!place.allFinite())
      {
        throw InputError("fault " + name + " with a point that is not finite");
      }
    }
  }
  for (const auto& [name, own] : surfaces)
  {
    faults.push_back(PickSurface(name, own));
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
GivenFaultPicks ReadFaultPicks(std::vector<NamedHorizon> blocks)
{
  GivenFaultPicks given;
  given.Data = std::move(blocks);
  std::vector<FaultStick> sticks;
  std::vector<FaultPicks> surfaces;
  for (std::size_t n = 0; n < given.Data.size(); ++n)
  {
    const NamedHorizon& block = given.Data[n];
    if (IsSurface(block.Data))
    {
      AddSurfaces(block, n, surfaces);
      continue;
    }
    std::vector<FaultStick> own = ReadFaultSticks(block);
    std::move(own.begin(), own.end(), std::back_inserter(sticks));
  }
  given.Picks = PickSticks(sticks);
  std::move(surfaces.begin(), surfaces.end(), std::back_inserter(given.Picks->Faults));
  return given;
}

//----------------------------------------------------------------------------------------------------------------------
CutInputs JoinCutInputs(std::vector<CutInput> horizons, std::optional<std::vector<NamedHorizon>> faults)
{
  if (horizons.empty())
  {
    throw InputError("no horizon with points, expected at least one");
  }
  CutInputs inputs;
  inputs.Horizons = std::move(horizons);
  if (faults)
  {
    inputs.Faults = ReadFaultPicks(std::move(*faults));
  }
  const CutInput& first = inputs.Horizons.front();
  SurveyDescription survey = ReadSurveyFields(first.Points.Horizon.FieldData);
  const auto join = [&](const Horizon& other, const std::string& name, auto&& warn)
  {
    const HorizonNames names = { name, first.Name };
    survey = JoinSurveys(survey, other, names);
    const std::string doubt = warn(first.Points.Horizon, other, names);
    if (!doubt.empty())
    {
      inputs.Faults.Warnings.push_back(doubt);
    }
  };
  for (const CutInput& horizon : inputs.Horizons)
  {
    join(horizon.Points.Horizon, horizon.Name, WarnOfHeights);
  }
  for (const NamedHorizon& block : inputs.Faults.Data)
  {
    join(block.Data, "the faults", WarnOfDirections);
  }
  if (const DataArray* const direction = FindNumbers(first.Points.Horizon.FieldData, FieldArray::VerticalDirection))
  {
    inputs.Fields.Add(*direction);
  }
  AddSurveyFields(survey, inputs.Fields);
  return inputs;
}

//----------------------------------------------------------------------------------------------------------------------
CutInputs ReadCutInputs(const std::vector<NamedHorizon>& horizons, std::optional<std::vector<NamedHorizon>> faults)
{
  std::vector<CutInput> inputs;
  for (const NamedHorizon& horizon : horizons)
  {
    PrefixErrors(horizon.Name, [&]() { inputs.push_back({ horizon.Name, ReadCutPoints(horizon.Data) }); });
  }
  return JoinCutInputs(std::move(inputs), std::move(faults));
}
}
