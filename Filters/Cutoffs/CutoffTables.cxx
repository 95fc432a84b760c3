// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffTables.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Common/StageReport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Figures of all pieces of a horizon at a fault.
struct CutoffFigures
{
  double Length = 0.0;
  double Least = std::numeric_limits<double>::infinity();
  double Largest = -std::numeric_limits<double>::infinity();
  double Mean = 0.0;
  double Jump = 0.0; // of the throw, from one place to the next
  double Heave = 0.0; // mean
  double Spread = 0.0; // largest
  double Gap = 0.0; // largest, in columns
  std::int64_t Places = 0;
  std::int64_t Guessed = 0;
  std::int64_t Tips = 0;
};

struct FigureColumn
{
  const char* Name;
  bool IsCount = false;
  std::vector<double> Values = {};
};

/// Means are along the fault. At tips there is no throw by definition.
CutoffFigures Measure(const FaultPlate& fault, const HorizonCutoffs& cutoffs)
{
  CutoffFigures figures;
  double along = 0.0;
  for (const CutoffPiece& piece : cutoffs.Pieces)
  {
    figures.Length += piece.Length(fault, Footwall);
    figures.Places += std::int64_t(piece.Pairs.size());
    figures.Tips += std::count(piece.IsTip.begin(), piece.IsTip.end(), true);
    const std::size_t first = piece.IsTip[0] ? 1 : 0, end = piece.Pairs.size() - (piece.IsTip[1] ? 1 : 0);
    for (std::size_t n = 0; n < piece.Pairs.size(); ++n)
    {
      const CutoffPair& pair = piece.Pairs[n];
      figures.Guessed += pair.IsGuessed() ? 1 : 0;
      if (n >= first && n < end)
      {
        figures.Least = std::min(figures.Least, pair.Throw());
        figures.Largest = std::max(figures.Largest, pair.Throw());
        figures.Jump = std::max(figures.Jump, n > first ? std::abs(pair.Throw() - piece.Pairs[n - 1].Throw()) : 0.0);
      }
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        figures.Spread = std::fmax(figures.Spread, pair.Wall[wall].Spread);
        figures.Gap = std::fmax(figures.Gap, pair.Wall[wall].Gap);
      }
      if (n > 0)
      {
        const CutoffPair& last = piece.Pairs[n - 1];
        const double width = pair.S - last.S;
        along += width;
        figures.Mean += 0.5 * width * (last.Throw() + pair.Throw());
        figures.Heave += 0.5 * width * (last.Heave(fault) + pair.Heave(fault));
      }
    }
  }
  figures.Mean /= along;
  figures.Heave /= along;
  return figures;
}
}

//----------------------------------------------------------------------------------------------------------------------
ArrayTable WriteCutoffTable(const CutoffModelData& model)
{
  ArrayTable table;
  std::vector<std::string> faults, horizons;
  constexpr bool isCount = true;
  std::vector<FigureColumn> columns = { { "Length" }, { "ThrowLeast" }, { "ThrowMean" }, { "ThrowLargest" },
    { "ThrowJump" }, { "HeaveMean" }, { "DroppedFootwall", isCount }, { "DroppedHangingWall", isCount },
    { "LargestGap" }, { "LargestSpread" }, { "Places", isCount }, { "Guessed", isCount }, { "Pieces", isCount },
    { "Tips", isCount } };
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    for (const CutHorizon& horizon : model.Horizons)
    {
      const HorizonCutoffs& own = horizon.AtFault[fault];
      if (own.Pieces.empty())
      {
        continue;
      }
      const CutoffFigures figures = Measure(model.Faults[fault], own);
      const std::array<double, 14> row = { figures.Length, figures.Least, figures.Mean, figures.Largest, figures.Jump,
        figures.Heave, double(own.Dropped[Footwall].size()), double(own.Dropped[HangingWall].size()), figures.Gap, figures.Spread,
        double(figures.Places), double(figures.Guessed), double(own.Pieces.size()), double(figures.Tips) };
      faults.push_back(model.Faults[fault].Name());
      horizons.push_back(horizon.Name);
      for (std::size_t n = 0; n < row.size(); ++n)
      {
        columns[n].Values.push_back(row[n]);
      }
    }
  }
  table.Add({ "Fault", std::move(faults) });
  table.Add({ "Horizon", std::move(horizons) });
  for (const FigureColumn& column : columns)
  {
    column.IsCount ? AddArray<std::int64_t>(table, column.Name, column.Values)
                   : AddArray<double>(table, column.Name, column.Values);
  }
  return table;
}

//----------------------------------------------------------------------------------------------------------------------
ArrayTable WriteAreaTable(const CutoffModelData& model, const std::vector<FaultJuxtaposition>& juxtapositions)
{
  std::vector<std::string> faults, foot, hanging;
  std::vector<double> areas;
  for (std::size_t fault = 0; fault < juxtapositions.size(); ++fault)
  {
    std::map<std::pair<MetLayer, MetLayer>, double> sums;
    for (const MetArea& area : juxtapositions[fault].Areas)
    {
      sums[{ area.Layer[Footwall], area.Layer[HangingWall] }] += area.Area;
    }
    for (const auto& [layers, sum] : sums)
    {
      faults.push_back(model.Faults[fault].Name());
      foot.push_back(NameOf(layers.first, juxtapositions[fault].Horizons));
      hanging.push_back(NameOf(layers.second, juxtapositions[fault].Horizons));
      areas.push_back(sum);
    }
  }
  ArrayTable table;
  table.Add({ "Fault", std::move(faults) });
  table.Add({ CellArray::Footwall, std::move(foot) });
  table.Add({ CellArray::HangingWall, std::move(hanging) });
  AddArray<double>(table, "Area", areas);
  return table;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ReportCutoffs(const CutoffModelData& model)
{
  std::ostringstream text = MakeReportStream();
  for (std::size_t fault = 0; fault < model.Faults.size(); ++fault)
  {
    text << model.Faults[fault].Name() << '\n';
    for (const CutHorizon& horizon : model.Horizons)
    {
      const HorizonCutoffs& own = horizon.AtFault[fault];
      if (own.Pieces.empty())
      {
        text << "  " << horizon.Name << ": not cut\n";
        continue;
      }
      const CutoffFigures figures = Measure(model.Faults[fault], own);
      text << "  " << horizon.Name << ": throw " << figures.Least << " to " << figures.Largest << "\n    mean throw "
           << figures.Mean << ", mean heave ";
      model.Faults[fault].HasDip() ? text << figures.Heave : text << "unknown";
      text << "\n    gap up to " << figures.Gap << " columns, spread up to " << figures.Spread << "\n    dropped "
           << own.Dropped[Footwall].size() + own.Dropped[HangingWall].size() << " picks, guessed " << figures.Guessed << " of "
           << figures.Places << " places\n";
    }
  }
  return text.str();
}
}
