// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffOutput.h"

#include "Common/Horizon/DataModel.h"
#include "CutoffTables.h"
#include "Filters/Common/CellWriter.h"
#include "JuxtapositionOutput.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double OffsetError = 0.25; // columns

std::vector<std::size_t> KeepPairs(const CutHorizon& horizon, const CutoffPiece& piece, FaultWall wall)
{
  return SimplifyCutoff(piece, wall, horizon.MaximumError, OffsetError * horizon.Picks.LargestStep());
}

/// Calls visit(fault, cutoffs, piece) for each piece of a horizon.
template <typename Visitor>
void ForEachPiece(const CutoffModelData& model, const CutHorizon& horizon, Visitor&& visit)
{
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    for (const CutoffPiece& piece : horizon.AtFault[fault].Pieces)
    {
      visit(model.Faults[fault], piece);
    }
  }
}

const char* NameOfWall(FaultWall wall)
{
  return wall == Footwall ? "footwall" : "hanging wall";
}

/// Lines along the fault, simplified within the maximum error of the horizon.
Horizon WriteCutoffLines(const CutoffModelData& model, const CutHorizon& horizon)
{
  CellWriter cells;
  std::vector<double> throws, heaves, spreads, along;
  std::vector<unsigned char> guessed;
  std::vector<int> numbers;
  std::vector<std::string> names, walls;
  ForEachPiece(model, horizon,
    [&](const FaultPlate& fault, const CutoffPiece& piece)
    {
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        numbers.push_back(int(&fault - model.Faults.data()));
        for (const std::size_t n : KeepPairs(horizon, piece, wall))
        {
          const CutoffPair& pair = piece.Pairs[n];
          cells.Add(pair.Place(fault, wall));
          throws.push_back(pair.Throw());
          heaves.push_back(pair.Heave(fault));
          spreads.push_back(pair.Wall[wall].Spread);
          along.push_back(pair.S - fault.First());
          guessed.push_back(static_cast<unsigned char>(pair.Source[wall]));
        }
        cells.Close();
        names.push_back(fault.Name());
        walls.emplace_back(NameOfWall(wall));
      }
    });
  Horizon output;
  cells.Finish(output, &Horizon::Lines);
  AddArray<double>(output.PointData, PointArray::Throw, throws);
  AddArray<double>(output.PointData, PointArray::Heave, heaves);
  AddArray<double>(output.PointData, PointArray::Spread, spreads);
  AddArray<double>(output.PointData, PointArray::Along, along);
  AddArray<unsigned char>(output.PointData, PointArray::Guessed, guessed);
  AddArray<int>(output.CellData, CellArray::FaultLine, numbers);
  output.CellData.Add({ CellArray::FaultName, std::move(names) });
  output.CellData.Add({ CellArray::FaultStick, std::move(walls) });
  return output;
}

/// The footwall forth, the hanging wall back.
Horizon WriteFaultPolygons(const CutoffModelData& model, const CutHorizon& horizon)
{
  CellWriter cells;
  std::vector<double> throws, heaves;
  std::vector<std::string> names;
  ForEachPiece(model, horizon,
    [&](const FaultPlate& fault, const CutoffPiece& piece)
    {
      const auto add = [&](std::size_t n, FaultWall wall)
      {
        cells.Add(piece.Pairs[n].Place(fault, wall));
        throws.push_back(piece.Pairs[n].Throw());
        heaves.push_back(piece.Pairs[n].Heave(fault));
      };
      const std::int64_t first = cells.NumberOfPoints();
      for (const std::size_t n : KeepPairs(horizon, piece, Footwall))
      {
        add(n, Footwall);
      }
      const std::vector<std::size_t> back = KeepPairs(horizon, piece, HangingWall);
      for (std::size_t n = back.size(); n-- > 0;)
      {
        const bool isShared = (back[n] == 0 && piece.IsTip[0]) || (n + 1 == back.size() && piece.IsTip[1]);
        if (!isShared)
        {
          add(back[n], HangingWall);
        }
      }
      cells.Use(first);
      cells.Close();
      names.push_back(fault.Name());
    });
  Horizon output;
  cells.Finish(output, &Horizon::Lines);
  AddArray<double>(output.PointData, PointArray::Throw, throws);
  AddArray<double>(output.PointData, PointArray::Heave, heaves);
  output.CellData.Add({ CellArray::FaultStick, std::vector<std::string>(names.size()) });
  output.CellData.Add({ CellArray::FaultName, std::move(names) });
  return output;
}

/// Rows at the levels of the plate, each with as many places between its ends.
Horizon WriteFaultPlates(const std::vector<FaultPlate>& faults)
{
  CellWriter cells;
  std::vector<std::string> names;
  for (const FaultPlate& fault : faults)
  {
    const auto across =
      std::int64_t(std::clamp(std::ceil((fault.Last() - fault.First()) / fault.StepAlong()), 2.0, 200.0));
    std::int64_t above = -1; // the first point of the row above
    for (std::size_t level = 0; level < fault.Levels(); ++level)
    {
      const std::array<double, 2> ends = fault.EndsAt(level);
      if (!(ends[0] <= ends[1]))
      {
        above = -1;
        continue;
      }
      const std::int64_t row = cells.NumberOfPoints();
      for (std::int64_t n = 0; n <= across; ++n)
      {
        const double s = ends[0] + (ends[1] - ends[0]) * double(n) / double(across);
        cells.AddPoint(fault.At(s, fault.Height(level)));
      }
      for (std::int64_t n = 0; above >= 0 && n < across; ++n)
      {
        for (const std::array<std::int64_t, 3>& corners :
          { std::array<std::int64_t, 3>{ above + n, above + n + 1, row + n + 1 },
            std::array<std::int64_t, 3>{ above + n, row + n + 1, row + n } })
        {
          std::for_each(corners.begin(), corners.end(), [&cells](std::int64_t point) { cells.Use(point); });
          cells.Close();
          names.push_back(fault.Name());
        }
      }
      above = row;
    }
  }
  Horizon output;
  cells.Finish(output, &Horizon::Polygons);
  output.CellData.Add({ CellArray::FaultName, std::move(names) });
  return output;
}
}

//----------------------------------------------------------------------------------------------------------------------
CutoffStageResult WriteCutoffs(const CutoffModelData& model, const ArrayTable& fields)
{
  CutoffStageResult result;
  std::transform(model.Faults.begin(), model.Faults.end(), std::back_inserter(result.FaultNames),
    [](const FaultPlate& fault) { return fault.Name(); });
  const auto withFields = [&fields](Horizon data)
  {
    data.FieldData.AddAll(fields);
    return data;
  };
  for (const CutHorizon& horizon : model.Horizons)
  {
    result.Cutoffs.push_back(withFields(WriteCutoffLines(model, horizon)));
    result.Polygons.push_back(withFields(WriteFaultPolygons(model, horizon)));
  }
  result.Faults = withFields(WriteFaultPlates(model.Faults));
  std::vector<FaultJuxtaposition> juxtapositions;
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    juxtapositions.push_back(JuxtaposeAt(model, fault));
  }
  result.Juxtaposition = withFields(WriteJuxtaposition(model.Faults, juxtapositions, false));
  result.Diagrams = withFields(WriteJuxtaposition(model.Faults, juxtapositions, true));
  result.Figures = WriteCutoffTable(model);
  result.Areas = WriteAreaTable(model, juxtapositions);
  result.Report = ReportCutoffs(model);
  return result;
}
}
