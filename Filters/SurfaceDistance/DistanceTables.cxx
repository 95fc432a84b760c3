// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceTables.h"

#include "Common/Horizon/DataModel.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t DiagonalUnit = 2;

using DistanceFigure = std::pair<std::string, double>;

/// The diagonal is in lattice units.
std::vector<DistanceFigure> ListFigures(const FiguresOfPair& measured, std::size_t direction, std::size_t unit)
{
  const DistanceFigures& figures = (unit == WorldUnit ? measured.World : measured.Lattice)[direction];
  std::vector<DistanceFigure> list = { { FieldArray::LargestDistance, figures.Largest },
    { FieldArray::LargestDistanceFound, figures.LargestFound }, { FieldArray::MeanDistance, figures.Mean },
    { FieldArray::RmsDistance, figures.Rms } };
  for (std::size_t n = 0; n < Percentiles.size(); ++n)
  {
    list.emplace_back(FieldArray::DistancePercentile + std::to_string(Percentiles[n]), figures.Percentile[n]);
  }
  list.emplace_back(FieldArray::OutlineDistance, figures.Outline);
  for (DistanceFigure& figure : list)
  {
    figure.second = unit == DiagonalUnit ? figure.second / measured.Diagonal : figure.second;
  }
  return list;
}

std::vector<std::size_t> CountUp(std::size_t rows)
{
  std::vector<std::size_t> numbers(rows);
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  return numbers;
}

template <typename Text>
void AddTexts(const char* name, const std::vector<std::size_t>& rows, Text&& text, ArrayTable& table)
{
  std::vector<std::string> texts;
  std::transform(rows.begin(), rows.end(), std::back_inserter(texts), text);
  table.Add(DataArray(name, std::move(texts)));
}

/// Without rows, or with one for each unit and direction.
ArrayTable MakeFigureTable(
  const FiguresOfPair& measured, const std::string& horizon, const std::vector<std::size_t>& rows)
{
  ArrayTable table;
  AddTexts(
    "Horizon", rows, [&](std::size_t) { return horizon; }, table);
  AddTexts(
    "Direction", rows, [](std::size_t row) { return DirectionNames[row % Directions]; }, table);
  AddTexts(
    "Unit", rows, [](std::size_t row) { return UnitNames[row / Directions]; }, table);
  const std::vector<DistanceFigure> names = ListFigures(measured, 0, 0);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    AddArray<double>(table, names[n].first.c_str(), rows,
      [&](std::size_t row) { return ListFigures(measured, row % Directions, row / Directions)[n].second; });
  }
  const auto grading = [&](std::size_t row, double Grading::*figure)
  {
    const std::size_t surface = row % Directions;
    return surface < measured.Surfaces.size() ? measured.Surfaces[surface].*figure : NoValue;
  };
  AddArray<double>(table, "GradingMedian", rows, [&](std::size_t row) { return grading(row, &Grading::Median); });
  AddArray<double>(table, "Grading95", rows, [&](std::size_t row) { return grading(row, &Grading::Percentile95); });
  AddArray<std::int64_t>(table, "Samples", rows, // All units have the same samples.
    [&](std::size_t row) { return measured.Lattice[row % Directions].Samples; });
  return table;
}

/// Without rows, or with one for each bin.
ArrayTable MakeHistogram(
  const FiguresOfPair& measured, bool inWorldUnits, const std::string& horizon, const std::vector<std::size_t>& rows)
{
  const DistanceFigures& both = (inWorldUnits ? measured.World : measured.Lattice).back();
  const double width = both.Percentile.back() / double(DistanceBins - 1);
  ArrayTable table;
  AddTexts(
    "Horizon", rows, [&](std::size_t) { return horizon; }, table);
  AddTexts(
    "Unit", rows, [&](std::size_t) { return UnitNames[inWorldUnits ? WorldUnit : 0]; }, table);
  // ParaView's charts expect this name for their x axis.
  AddArray<double>(table, "bin_extents", rows, [&](std::size_t bin) { return width * double(bin); });
  AddArray<double>(table, "Area (%)", rows, [&](std::size_t bin) { return 100.0 * both.Share[bin]; });
  return table;
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFigures(const FiguresOfPair& figures, std::size_t surface, ArrayTable& data)
{
  assert(surface < figures.Surfaces.size());
  const std::vector<DistanceFigure> names = ListFigures(figures, 0, 0);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    DataArray array = NewArray<double>(names[n].first.c_str(), std::int64_t(Directions), int(UnitNames.size()));
    array.ComponentNames.assign(UnitNames.begin(), UnitNames.end());
    for (std::size_t unit = 0; unit < UnitNames.size(); ++unit)
    {
      for (std::size_t direction = 0; direction < Directions; ++direction)
      {
        array.Set(std::int64_t(direction), int(unit), ListFigures(figures, direction, unit)[n].second);
      }
    }
    data.Add(std::move(array));
  }
  const Grading& grading = figures.Surfaces[surface];
  AddTuple<double>(data, FieldArray::Grading, std::array<double, 2>{ grading.Median, grading.Percentile95 })
    .ComponentNames = { "Median", "Percentile95" };
}

//----------------------------------------------------------------------------------------------------------------------
DistanceTables MakeEmptyTables()
{
  const FiguresOfPair none;
  return { MakeFigureTable(none, "", {}), MakeHistogram(none, false, "", {}) };
}

//----------------------------------------------------------------------------------------------------------------------
DistanceTables MakeTables(const FiguresOfPair& figures, bool inWorldUnits, const std::string& horizon)
{
  return { MakeFigureTable(figures, horizon, CountUp(UnitNames.size() * Directions)),
    MakeHistogram(figures, inWorldUnits, horizon, CountUp(DistanceBins)) };
}
}
