// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "JuxtapositionOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CellWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
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
Horizon WriteJuxtaposition(const FaultPlate& fault, const FaultJuxtaposition& juxtaposition, bool isDiagram)
{
  const double step = isDiagram ? std::numeric_limits<double>::infinity() : fault.Height(1) - fault.Height(0);
  std::map<std::pair<MetLayer, MetLayer>, int> pairs;
  for (const MetArea& area : juxtaposition.Areas)
  {
    pairs.emplace(std::make_pair(area.Layer[Footwall], area.Layer[HangingWall]), 0);
  }
  int next = 0;
  for (auto& [layers, number] : pairs)
  {
    number = next++;
  }
  CellWriter cells;
  std::vector<int> numbers;
  std::vector<unsigned char> same;
  std::array<std::vector<std::string>, 2> names;
  for (const MetArea& area : juxtaposition.Areas)
  {
    const double height = std::max(area.Top[0] - area.Base[0], area.Top[1] - area.Base[1]);
    const auto parts = int(std::clamp(std::ceil(height / step), 1.0, 1000.0));
    for (int part = 0; part < parts; ++part)
    {
      const auto add = [&](std::size_t end, double level)
      {
        const double z = area.Base[end] + (area.Top[end] - area.Base[end]) * level / parts;
        cells.Add(
          isDiagram ? Eigen::Vector3d(area.S[end] - fault.First(), z + fault.Datum(), 0.0) : fault.At(area.S[end], z));
      };
      add(0, part);
      add(1, part);
      add(1, part + 1.0);
      add(0, part + 1.0);
      cells.Close();
      numbers.push_back(pairs.at({ area.Layer[Footwall], area.Layer[HangingWall] }));
      same.push_back(area.Layer[Footwall] == area.Layer[HangingWall] ? 1 : 0);
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        names[wall].push_back(NameOf(area.Layer[wall], juxtaposition.Horizons));
      }
    }
  }
  Horizon output;
  cells.Finish(output, &Horizon::Polygons);
  std::vector<std::string> both(numbers.size());
  std::transform(names[0].begin(), names[0].end(), names[1].begin(), both.begin(),
    [](const std::string& foot, const std::string& hanging) { return foot + " | " + hanging; });
  output.CellData.Add({ CellArray::Juxtaposition, std::move(both) });
  AddArray<int>(output.CellData, "Pair", numbers);
  AddArray<unsigned char>(output.CellData, CellArray::IsSame, same);
  output.CellData.Add({ CellArray::Footwall, std::move(names[Footwall]) });
  output.CellData.Add({ CellArray::HangingWall, std::move(names[HangingWall]) });
  return output;
}
}
