// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerFigures.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/LedgerFields.h"
#include "Filters/Common/HeightUnit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int ContactsOfCurve = 101;

/// The table has a column, and so a number of rows.
template <typename T>
void SetValue(ArrayTable& table, const std::string& name, std::size_t row, double value)
{
  const std::int64_t rows = table[0].Tuples();
  assert(std::int64_t(row) < rows);
  if (!table.Has(name))
  {
    table.Add(NewArray<T>(name.c_str(), rows));
  }
  table.Find(name)->As<T>()[row] = T(value);
}
}

//----------------------------------------------------------------------------------------------------------------------
double VolumeOfUnit(const HorizonStack& stack)
{
  return stack.CommonLattice().ColumnArea() * WorldPerIndex(stack.CommonLattice());
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> NamesOfLayers(const HorizonStack& stack)
{
  std::vector<std::string> names;
  for (std::size_t layer = 0; layer + 1 < stack.Size(); ++layer)
  {
    names.push_back(stack[layer].Name + " to " + stack[layer + 1].Name);
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerTable(const Layers& layers, const std::vector<LayerVolume>& volumes, const HorizonStack& stack,
  std::optional<double> contact, ArrayTable& table)
{
  const double height = WorldPerIndex(stack.CommonLattice());
  const double area = stack.CommonLattice().ColumnArea();
  const double volume = VolumeOfUnit(stack);
  table.Add({ "Name", NamesOfLayers(stack) });
  for (std::size_t layer = 0; layer + 1 < stack.Size(); ++layer)
  {
    const auto number = [&](const std::string& name, double value) { SetValue<double>(table, name, layer, value); };
    const auto count = [&](const std::string& name, std::int64_t value)
    { SetValue<std::int64_t>(table, name, layer, double(value)); };
    const LayerVolume& own = volumes[layer];
    const CrossingRepair& repair = layers.Stack.Repair;
    number("Volume", volume * own.Volume);
    number("Area", area * own.Area);
    number("ThicknessLeast", height * own.LeastThickness);
    number("ThicknessMean", height * own.MeanThickness);
    number("ThicknessLargest", height * own.LargestThickness);
    if (contact)
    {
      const double level = stack.CommonLattice().ToLattice({ 0.0, 0.0, *contact }).z();
      number("VolumeAboveContact", volume * VolumeAbove(layers.Plan, layer, level));
    }
    count("Crossings", std::int64_t(repair.Interfaces[layer].Columns));
    number("DeepestCrossing", height * repair.Interfaces[layer].Largest);
    count("TopMoved", std::int64_t(repair.Horizons[layer].Columns));
    count("BaseMoved", std::int64_t(repair.Horizons[layer + 1].Columns));
    number("FarthestMove", height * std::max(repair.Horizons[layer].Largest, repair.Horizons[layer + 1].Largest));
    const char* const kinds[] = { "PinchedTriangles", "Tetrahedra", "Pyramids", "Wedges" };
    for (std::size_t kind = own.Triangles.size(); kind-- > 0;)
    {
      count(kinds[kind], std::int64_t(own.Triangles[kind]));
    }
    number("AreaAtFaults", area * own.FaultArea);
    number("VolumeAtFaults", volume * own.FaultVolume);
    const LayerLedger& ledger = layers.Ledgers.OfLayers[layer];
    number("AreaWithout", area * ledger.AreaWithout);
    number("VolumeWithout", volume * ledger.VolumeWithout);
    for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
    {
      const std::string name = LedgerNames[entry];
      number("Area" + name, area * double(ledger.Columns.Columns[entry]));
      number("Volume" + name, volume * ledger.Volumes[entry]);
    }
  }
  table.Add({ "VolumeUnit", std::vector<std::string>(layers.Plan.NumberOfLayers(), UnitOfVolumes(stack)) });
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayerLedger(const LayerLedger& ledger, const HorizonStack& stack, ArrayTable& data)
{
  WriteLedger(ledger.Columns, data);
  std::array<double, LedgerEntries> volumes;
  std::transform(ledger.Volumes.begin(), ledger.Volumes.end(), volumes.begin(),
    [&stack](double volume) { return volume * VolumeOfUnit(stack); });
  AddTuple<double>(data, FieldArray::LedgerVolume, volumes)
    .ComponentNames.assign(LedgerNames.begin(), LedgerNames.end());
}

//----------------------------------------------------------------------------------------------------------------------
void WriteVolumeCurve(const LayerPlan& plan, const HorizonStack& stack, ArrayTable& table, const Monitor& monitor)
{
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (const std::vector<double>& heights : plan.Heights)
  {
    for (const double height : heights)
    {
      least = std::min(least, height);
      largest = std::max(largest, height);
    }
  }
  if (!(least <= largest))
  {
    return;
  }
  const double top = plan.HeightsGrowDownwards ? least : largest;
  const double base = plan.HeightsGrowDownwards ? largest : least;
  const double volume = VolumeOfUnit(stack);
  DataArray contacts = NewArray<double>("Contact", ContactsOfCurve);
  std::vector<double> levels;
  for (int n = 0; n < ContactsOfCurve; ++n)
  {
    levels.push_back(n + 1 == ContactsOfCurve ? base : top + (base - top) * n / (ContactsOfCurve - 1));
    contacts.As<double>()[n] = stack.CommonLattice().ToWorld({ 0.0, 0.0, levels.back() }).z();
  }
  table.Add(std::move(contacts));
  const std::vector<std::string> names = NamesOfLayers(stack);
  for (std::size_t layer = 0; layer < names.size(); ++layer)
  {
    DataArray volumes = NewArray<double>(names[layer].c_str(), ContactsOfCurve);
    const auto part = [&](std::size_t n) { return double(n) / double(names.size()); };
    ParallelFor(ContactsOfCurve, 1, monitor.Step(part(layer), part(layer + 1)),
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          volumes.As<double>()[n] = volume * VolumeAbove(plan, layer, levels[std::size_t(n)]);
        }
      });
    table.Add(std::move(volumes));
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string UnitOfVolumes(const HorizonStack& stack)
{
  const SurveyDescription& survey = stack.GetSurvey();
  if (survey.HorizontalUnit.empty() || survey.VerticalUnit.empty())
  {
    return "";
  }
  return survey.HorizontalUnit == survey.VerticalUnit ? survey.HorizontalUnit + "3"
                                                      : survey.HorizontalUnit + "2 " + survey.VerticalUnit;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> ReportMissing(
  const LayerLedgers& ledgers, const HorizonStack& stack, const std::string& advice)
{
  const std::vector<std::string> names = NamesOfLayers(stack);
  std::vector<std::string> lines;
  for (std::size_t layer = 0; layer < names.size(); ++layer)
  {
    const LayerLedger& ledger = ledgers.OfLayers[layer];
    std::string notRead;
    std::ostringstream leftOut;
    for (const LedgerWarning& warning : FindWarnings(ledger.Columns))
    {
      if (warning.Entry != LedgerEntry::LeftOut)
      {
        notRead += (notRead.empty() ? "" : ", ") + warning.Text;
        continue;
      }
      const auto columns = double(ledger.Columns[LedgerEntry::LeftOut]);
      leftOut << names[layer] << " without " << std::setprecision(3)
              << 100.0 * columns / (columns + double(ledger.Columns.Covered())) << " % of its area (volume "
              << std::setprecision(6) << ledger.VolumeWithout * VolumeOfUnit(stack)
              << "), expected all between its horizons" << advice;
    }
    if (!notRead.empty())
    {
      lines.push_back(names[layer] + " with interpolated heights over part of its area (" + notRead +
        "), expected points of both horizons");
    }
    if (!leftOut.str().empty())
    {
      lines.push_back(leftOut.str());
    }
  }
  return lines;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ReportLayers(const Layers& layers, const std::vector<LayerVolume>& volumes, const HorizonStack& stack)
{
  std::ostringstream text;
  const double height = WorldPerIndex(stack.CommonLattice());
  const std::vector<std::string> names = NamesOfLayers(stack);
  const std::string unit = UnitOfVolumes(stack);
  text << names.size() << (names.size() == 1 ? " layer" : " layers") << " over " << layers.Plan.NumberOfTriangles()
       << " triangles\n";
  for (std::size_t layer = 0; layer < names.size(); ++layer)
  {
    const LayerVolume& own = volumes[layer];
    text << names[layer] << "\n  volume " << own.Volume * VolumeOfUnit(stack) << (unit.empty() ? "" : " ") << unit
         << "\n  thickness " << height * own.LeastThickness << " to " << height * own.LargestThickness << ", mean "
         << height * own.MeanThickness << '\n';
    const RepairFigures& crossed = layers.Stack.Repair.Interfaces[layer];
    if (crossed.Columns > 0)
    {
      text << "  crossed in " << crossed.Columns << " columns, by up to " << height * crossed.Largest << '\n';
    }
    if (own.FaultArea > 0.0)
    {
      text << "  left out at faults: volume " << own.FaultVolume * VolumeOfUnit(stack) << '\n';
    }
  }
  for (const std::string& line : ReportMissing(layers.Ledgers, stack, ""))
  {
    text << line << '\n';
  }
  for (std::size_t horizon = 0; horizon < stack.Size(); ++horizon)
  {
    text << stack[horizon].Name << ": " << layers.Ledgers.PointsOutside[horizon] << " of "
         << stack[horizon].Placed.Columns.size() << " points outside\n";
  }
  return text.str();
}
}
