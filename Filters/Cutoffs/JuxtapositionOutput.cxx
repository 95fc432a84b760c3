// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "JuxtapositionOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CellWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
FaultJuxtaposition JuxtaposeAt(const CutoffModelData& model, std::size_t fault)
{
  FaultJuxtaposition result;
  std::vector<std::pair<double, const CutHorizon*>> sorted;
  for (const CutHorizon& horizon : model.Horizons)
  {
    double sum = 0.0, count = 0.0;
    for (const CutoffPiece& piece : horizon.AtFault[fault].Pieces)
    {
      for (const CutoffPair& pair : piece.Pairs)
      {
        sum += pair.Wall[Footwall].Height + pair.Wall[HangingWall].Height;
        count += 2.0;
      }
    }
    if (count > 0.0)
    {
      sorted.emplace_back(-sum / count, &horizon);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const HorizonCutoffs*> cutoffs;
  for (const auto& [height, horizon] : sorted)
  {
    result.Horizons.push_back(horizon);
    cutoffs.push_back(&horizon->AtFault[fault]);
  }
  result.Areas = FindJuxtaposition(model.Faults[fault], cutoffs);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::string NameOf(const MetLayer& layer, const std::vector<const CutHorizon*>& horizons)
{
  const auto name = [&horizons](std::ptrdiff_t n) { return horizons[std::size_t(n)]->Name; };
  return layer.Top == MetLayer::Outside ? "above " + name(layer.Base)
    : layer.Base == MetLayer::Outside   ? "below " + name(layer.Top)
                                        : name(layer.Top) + " to " + name(layer.Base);
}

//----------------------------------------------------------------------------------------------------------------------
Horizon WriteJuxtaposition(
  const std::vector<FaultPlate>& faults, const std::vector<FaultJuxtaposition>& juxtapositions, bool areDiagrams)
{
  constexpr double between = 0.1; // diagrams, of their width
  CellWriter cells;
  std::vector<double> along;
  std::vector<unsigned char> same;
  std::vector<std::string> names, both;
  std::array<std::vector<std::string>, 2> layers;
  double first = 0.0; // where the diagram begins
  for (std::size_t fault = 0; fault < faults.size(); ++fault)
  {
    const FaultPlate& plate = faults[fault];
    const double step = areDiagrams ? std::numeric_limits<double>::infinity() : plate.Height(1) - plate.Height(0);
    for (const MetArea& area : juxtapositions[fault].Areas)
    {
      const double height = std::max(area.Top[0] - area.Base[0], area.Top[1] - area.Base[1]);
      const auto parts = int(std::clamp(std::ceil(height / step), 1.0, 1000.0));
      const auto add = [&](std::size_t end, double part)
      {
        const double z = area.Base[end] + (area.Top[end] - area.Base[end]) * part / parts;
        along.push_back(area.S[end] - plate.First());
        cells.Add(
          areDiagrams ? Eigen::Vector3d(first + along.back(), z + plate.Datum(), 0.0) : plate.At(area.S[end], z));
      };
      const auto nameAt = [&](FaultWall wall) { return NameOf(area.Layer[wall], juxtapositions[fault].Horizons); };
      const std::array<std::string, 2> met = { nameAt(Footwall), nameAt(HangingWall) };
      for (int part = 0; part < parts; ++part)
      {
        add(0, part);
        add(1, part);
        add(1, part + 1.0);
        add(0, part + 1.0);
        cells.Close();
        names.push_back(plate.Name());
        same.push_back(area.Layer[Footwall] == area.Layer[HangingWall] ? 1 : 0);
        for (const FaultWall wall : { Footwall, HangingWall })
        {
          layers[wall].push_back(met[wall]);
        }
        both.push_back(met[Footwall] + " against " + met[HangingWall]);
      }
    }
    first += (1.0 + between) * (plate.Last() - plate.First());
  }
  Horizon output;
  cells.Finish(output, &Horizon::Polygons);
  AddArray<double>(output.PointData, PointArray::Along, along);
  output.CellData.Add({ CellArray::FaultName, std::move(names) });
  output.CellData.Add({ CellArray::Juxtaposition, std::move(both) });
  output.CellData.Add({ CellArray::Footwall, std::move(layers[Footwall]) });
  output.CellData.Add({ CellArray::HangingWall, std::move(layers[HangingWall]) });
  AddArray<unsigned char>(output.CellData, CellArray::IsSame, same);
  return output;
}
}
