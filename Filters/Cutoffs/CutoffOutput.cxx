// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Cutoffs/Juxtaposition.h"
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
/// Places and cells of an output.
class CellWriter
{
public:
  /// Returns its number.
  std::int64_t AddPoint(const Eigen::Vector3d& place)
  {
    this->Places.append(place.data(), place.data() + 3);
    return this->NextPoint() - 1;
  }
  void Add(const Eigen::Vector3d& place) { this->AddAgain(this->AddPoint(place)); }
  void AddAgain(std::int64_t point) { this->Points.push_back(point); }
  void Close() { this->Offsets.push_back(std::int64_t(this->Points.size())); }
  std::int64_t NextPoint() const { return std::int64_t(this->Places.size() / 3); }

  void Finish(Horizon& output, Cells Horizon::*kind)
  {
    output.Places = DataArray::Take(this->Places, 3);
    output.*kind = { DataArray::Take(this->Offsets), DataArray::Take(this->Points) };
  }

private:
  HeapArray<double> Places;
  HeapArray<std::int64_t> Points;
  HeapArray<std::int64_t> Offsets = { 0 };
};

constexpr double OffsetError = 0.25; // columns

std::vector<std::size_t> KeepPairs(const CutHorizon& horizon, const CutoffPiece& piece, FaultWall wall)
{
  return SimplifyCutoff(piece, wall, horizon.MaximumError, OffsetError * horizon.Picks.Column);
}

Eigen::Vector3d PlaceOf(const FaultPlate& fault, const CutoffPair& pair, FaultWall wall)
{
  return fault.ToWorld({ pair.S, pair.Wall[wall].Offset, pair.Wall[wall].Height });
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

const char* NameOf(FaultWall wall)
{
  return wall == Footwall ? "footwall" : "hanging wall";
}

std::string NameOf(const MetLayer& layer, const std::vector<const CutHorizon*>& horizons)
{
  const auto name = [&horizons](std::ptrdiff_t n) { return horizons[std::size_t(n)]->Name; };
  return layer.Top == MetLayer::Outside ? "above " + name(layer.Base)
    : layer.Base == MetLayer::Outside   ? "below " + name(layer.Top)
                                        : name(layer.Top) + " to " + name(layer.Base);
}

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
  double Gap = 0.0; // largest
  std::int64_t Places = 0;
  std::int64_t Guessed = 0;
};

CutoffFigures Measure(const FaultPlate& fault, const HorizonCutoffs& cutoffs)
{
  CutoffFigures figures;
  for (const CutoffPiece& piece : cutoffs.Pieces)
  {
    figures.Length += piece.Length(fault, Footwall);
    for (std::size_t n = 0; n < piece.Pairs.size(); ++n)
    {
      const CutoffPair& pair = piece.Pairs[n];
      const double height = pair.Throw();
      figures.Least = std::min(figures.Least, height);
      figures.Largest = std::max(figures.Largest, height);
      figures.Mean += height;
      figures.Heave += pair.Heave();
      figures.Jump = std::max(figures.Jump, n > 0 ? std::abs(height - piece.Pairs[n - 1].Throw()) : 0.0);
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        figures.Spread = std::fmax(figures.Spread, pair.Wall[wall].Spread);
        figures.Gap = std::fmax(figures.Gap, pair.Wall[wall].Gap);
      }
      figures.Guessed +=
        pair.Source[Footwall] != HeightSource::Picks || pair.Source[HangingWall] != HeightSource::Picks ? 1 : 0;
      ++figures.Places;
    }
  }
  figures.Mean /= double(std::max<std::int64_t>(1, figures.Places));
  figures.Heave /= double(std::max<std::int64_t>(1, figures.Places));
  return figures;
}

/// Lines along the fault, simplified within the maximum error of the horizon.
Horizon WriteCutoffLines(const CutoffModelData& model, const CutHorizon& horizon)
{
  CellWriter cells;
  std::vector<double> throws, heaves, spreads, along;
  std::vector<unsigned char> guessed;
  std::vector<std::string> names, walls;
  ForEachPiece(model, horizon,
    [&](const FaultPlate& fault, const CutoffPiece& piece)
    {
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        for (const std::size_t n : KeepPairs(horizon, piece, wall))
        {
          const CutoffPair& pair = piece.Pairs[n];
          cells.Add(PlaceOf(fault, pair, wall));
          throws.push_back(pair.Throw());
          heaves.push_back(pair.Heave());
          spreads.push_back(pair.Wall[wall].Spread);
          along.push_back(pair.S - fault.First());
          guessed.push_back(static_cast<unsigned char>(pair.Source[wall]));
        }
        cells.Close();
        names.push_back(fault.Name());
        walls.emplace_back(NameOf(wall));
      }
    });
  Horizon output;
  cells.Finish(output, &Horizon::Lines);
  AddArray<double>(output.PointData, PointArray::Throw, throws);
  AddArray<double>(output.PointData, PointArray::Heave, heaves);
  AddArray<double>(output.PointData, PointArray::Spread, spreads);
  AddArray<double>(output.PointData, PointArray::Along, along);
  AddArray<unsigned char>(output.PointData, PointArray::Guessed, guessed);
  output.CellData.Add({ CellArray::FaultName, std::move(names) });
  output.CellData.Add({ CellArray::FaultStick, std::move(walls) });
  return output;
}

/// The footwall forth, the hanging wall back.
Horizon WriteFaultPolygons(const CutoffModelData& model, const CutHorizon& horizon)
{
  CellWriter cells;
  std::vector<std::string> names;
  ForEachPiece(model, horizon,
    [&](const FaultPlate& fault, const CutoffPiece& piece)
    {
      const std::int64_t first = cells.NextPoint();
      for (const std::size_t n : KeepPairs(horizon, piece, Footwall))
      {
        cells.Add(PlaceOf(fault, piece.Pairs[n], Footwall));
      }
      const std::vector<std::size_t> back = KeepPairs(horizon, piece, HangingWall);
      for (std::size_t n = back.size(); n-- > 0;)
      {
        const bool isShared = (back[n] == 0 && piece.IsTip[0]) || (n + 1 == back.size() && piece.IsTip[1]);
        if (!isShared)
        {
          cells.Add(PlaceOf(fault, piece.Pairs[back[n]], HangingWall));
        }
      }
      cells.AddAgain(first);
      cells.Close();
      names.push_back(fault.Name());
    });
  Horizon output;
  cells.Finish(output, &Horizon::Lines);
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
      const std::int64_t row = cells.NextPoint();
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
          std::for_each(corners.begin(), corners.end(), [&cells](std::int64_t point) { cells.AddAgain(point); });
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

/// Areas of a fault by the layers that meet there. Horizons are those that it cuts, the uppermost first.
struct FaultJuxtaposition
{
  std::vector<const CutHorizon*> Horizons;
  std::vector<MetArea> Areas;
};

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

ArrayTable WriteCutoffTable(const CutoffModelData& model)
{
  ArrayTable table;
  std::vector<std::string> faults, horizons;
  std::vector<std::pair<const char*, std::vector<double>>> numbers = { { "Length", {} }, { "ThrowLeast", {} },
    { "ThrowMean", {} }, { "ThrowLargest", {} }, { "ThrowJump", {} }, { "HeaveMean", {} }, { "DroppedFootwall", {} },
    { "DroppedHangingWall", {} }, { "LargestGap", {} }, { "LargestSpread", {} }, { "Places", {} }, { "Guessed", {} },
    { "Pieces", {} }, { "Tips", {} } };
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
      double tips = 0.0;
      for (const CutoffPiece& piece : own.Pieces)
      {
        tips += double(piece.IsTip[0]) + double(piece.IsTip[1]);
      }
      const std::array<double, 14> row = { figures.Length, figures.Least, figures.Mean, figures.Largest, figures.Jump,
        figures.Heave, double(own.Dropped[Footwall]), double(own.Dropped[HangingWall]), figures.Gap, figures.Spread,
        double(figures.Places), double(figures.Guessed), double(own.Pieces.size()), tips };
      faults.push_back(model.Faults[fault].Name());
      horizons.push_back(horizon.Name);
      for (std::size_t n = 0; n < row.size(); ++n)
      {
        numbers[n].second.push_back(row[n]);
      }
    }
  }
  table.Add({ "Fault", std::move(faults) });
  table.Add({ "Horizon", std::move(horizons) });
  for (const auto& [name, values] : numbers)
  {
    const std::string text = name;
    const bool isCount =
      text.rfind("Dropped", 0) == 0 || text == "Places" || text == "Guessed" || text == "Pieces" || text == "Tips";
    isCount ? AddArray<std::int64_t>(table, name, values) : AddArray<double>(table, name, values);
  }
  return table;
}

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
        continue;
      }
      const CutoffFigures figures = Measure(model.Faults[fault], own);
      text << "  " << horizon.Name << ": throw " << figures.Least << " to " << figures.Largest << ", mean "
           << figures.Mean << "; mean heave " << figures.Heave << "; largest spread " << figures.Spread << ", gap "
           << figures.Gap << "; dropped " << own.Dropped[Footwall] + own.Dropped[HangingWall] << " picks; guessed "
           << figures.Guessed << " of " << figures.Places << " places\n";
    }
  }
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
CutoffStageResult WriteCutoffs(const CutoffModelData& model, const ArrayTable& fields)
{
  CutoffStageResult result;
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
    const FaultPlate& plate = model.Faults[fault];
    result.Juxtapositions.push_back(withFields(WriteJuxtaposition(plate, juxtapositions.back(), false)));
    result.Diagrams.push_back(withFields(WriteJuxtaposition(plate, juxtapositions.back(), true)));
  }
  result.Figures = WriteCutoffTable(model);
  result.Areas = WriteAreaTable(model, juxtapositions);
  result.Report = ReportCutoffs(model);
  return result;
}
}
