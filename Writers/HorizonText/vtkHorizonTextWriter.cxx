// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTextWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"
#include "Common/Text/TextPrinter.h"
#include "Readers/HorizonText/TextLayout.h"
#include "Writers/HorizonSampling.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
struct PrintedColumns
{
  bool HasNames = false;
  bool HasLines = false;
  std::vector<std::string> Attributes;
  SurveyDescription Survey; // The names say the units and direction of z.
};

// Larger numbers are read as null.
constexpr double LeastNullNumber = 0.999999e30;

std::string Quoted(std::string text)
{
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return '"' + text + '"';
}

void PrintNumber(TextPrinter& printer, double number, const std::string& name)
{
  if (std::abs(number) >= LeastNullNumber)
  {
    throw InputError(name + " of 1e30 or more, which stands for no value; expected less");
  }
  if (std::isnan(number))
  {
    printer.Print("1e30");
    return;
  }
  printer.Print(number);
}

const std::vector<double>* FindAttribute(const HorizonColumns& horizon, const std::string& name)
{
  const auto found = std::find_if(horizon.Attributes.begin(), horizon.Attributes.end(),
    [&name](const PickAttribute& attribute) { return attribute.Name == name; });
  return found == horizon.Attributes.end() ? nullptr : &found->Values;
}

/// A line has, separated by tabs: the name in quotes, inline and crossline (both optional), x, y, z and attributes.
/// Null values are 1e30. Throws InputError for values that would be read as null.
class PickLinePrinter
{
public:
  PickLinePrinter(std::ostream& stream, const HorizonColumns& horizon, const PrintedColumns& columns)
    : Printer(stream)
    , Horizon(horizon)
    , Columns(columns)
    , Name(Quoted(horizon.Name))
  {
    for (const std::string& attribute : columns.Attributes)
    {
      this->Values.push_back(FindAttribute(horizon, attribute));
    }
  }

  void Print(const Monitor& monitor)
  {
    int row = -1;
    this->Horizon.Tiles.ForEachPlace(
      [&](int i, int j, std::size_t index)
      {
        if (std::isnan(this->Horizon.Z[index]))
        {
          return;
        }
        if (j != row)
        {
          row = j;
          monitor.Progress(double(j) / this->Horizon.Lattice.Columns[1]);
        }
        this->PrintLine(i, j, index);
      });
    this->Printer.Flush();
  }

private:
  void PrintLine(int i, int j, std::size_t index)
  {
    if (this->Columns.HasNames)
    {
      this->Printer.Print(this->Name);
      this->Printer.Print('\t');
    }
    const SurveyLattice& lattice = this->Horizon.Lattice;
    if (this->Columns.HasLines)
    {
      this->Printer.Print(lattice.Lines->FirstInline + j * lattice.Lines->InlineStep);
      this->Printer.Print('\t');
      this->Printer.Print(lattice.Lines->FirstCrossline + i * lattice.Lines->CrosslineStep);
      this->Printer.Print('\t');
    }
    const Eigen::Vector2d place = lattice.Origin + i * lattice.ColumnStep + j * lattice.RowStep;
    this->Printer.Print(place.x());
    this->Printer.Print('\t');
    this->Printer.Print(place.y());
    this->Printer.Print('\t');
    PrintNumber(this->Printer, this->Horizon.Z[index], "z");
    for (std::size_t n = 0; n < this->Values.size(); ++n)
    {
      this->Printer.Print('\t');
      const double value = this->Values[n] ? (*this->Values[n])[index] : std::nan("");
      PrintNumber(this->Printer, value, this->Columns.Attributes[n]);
    }
    this->Printer.Print('\n');
  }

  TextPrinter Printer;
  const HorizonColumns& Horizon;
  const PrintedColumns& Columns;
  const std::string Name;
  std::vector<const std::vector<double>*> Values;
};

/// OpendTect's single-line header has no name for the field of horizon names.
void PrintPickHeader(std::ostream& stream, const PrintedColumns& columns)
{
  const SurveyDescription& survey = columns.Survey;
  const auto name = [](const std::string& text, const std::string& unit)
  { return UnitOfName(text + " (" + unit + ")").empty() ? text : text + " (" + unit + ")"; };
  std::vector<std::string> names = { name("X", survey.HorizontalUnit), name("Y", survey.HorizontalUnit),
    name(survey.IsUpright ? "Elevation" : "Z", survey.VerticalUnit) };
  if (columns.HasLines)
  {
    names.insert(names.begin(), { "Inline", "Crossline" });
  }
  names.insert(names.end(), columns.Attributes.begin(), columns.Attributes.end());
  TextPrinter printer(stream);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    printer.Print(n == 0 ? "# " : "\t");
    printer.Print(Quoted(names[n]));
  }
  printer.Print("\n# - - - - - - - - - -\n");
  printer.Flush();
}

void AddNew(std::vector<std::string>& names, const std::vector<PickAttribute>& attributes)
{
  for (const PickAttribute& attribute : attributes)
  {
    if (std::find(names.begin(), names.end(), attribute.Name) == names.end())
    {
      names.push_back(attribute.Name);
    }
  }
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
vtkStandardNewMacro(vtkHorizonTextWriter);

//----------------------------------------------------------------------------------------------------------------------
/// The header names the attributes of all horizons, so that all are sampled before the first is printed.
void vtkHorizonTextWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  PrintedColumns columns;
  columns.HasNames = horizons.size() > 1;
  columns.HasLines = true;
  const auto part = [&horizons](std::size_t number, const Monitor& step)
  {
    const auto size = static_cast<double>(horizons.size());
    return step.Step(static_cast<double>(number) / size, static_cast<double>(number + 1) / size);
  };
  const int sign = this->VerticalSign(horizons.front().Data); // The header says one direction.
  bool isSameUnit = true;
  std::vector<HorizonColumns> sampled;
  for (const NamedHorizon& horizon : horizons)
  {
    const Monitor step = part(sampled.size(), monitor.Step(0.0, 0.5));
    PrefixErrors(horizon.Name, [&]() { sampled.push_back(SampleHorizon(horizon.Data, sign, step)); });
    isSameUnit = isSameUnit && sampled.back().Survey.VerticalUnit == sampled.front().Survey.VerticalUnit;
    sampled.back().Name = horizon.Name;
    columns.HasLines = columns.HasLines && sampled.back().Lattice.Lines;
    if (this->WriteAttributes)
    {
      AddNew(columns.Attributes, sampled.back().Attributes);
    }
  }
  columns.Survey = isSameUnit ? sampled.front().Survey : SurveyDescription();
  columns.Survey.IsUpright = sign > 0;
  PrintPickHeader(stream, columns);
  for (std::size_t number = 0; number < sampled.size(); ++number)
  {
    PickLinePrinter(stream, sampled[number], columns).Print(part(number, monitor.Step(0.5, 1.0)));
  }
}
