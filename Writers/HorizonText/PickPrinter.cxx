// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickPrinter.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextPrinter.h"
#include "Writers/ColumnNames.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// Larger numbers are read as null.
constexpr double LeastNullNumber = 0.999999e30;

void PrintNumber(TextPrinter& printer, double number, const std::string& name)
{
  if (std::abs(number) >= LeastNullNumber)
  {
    throw InputError(name + " of 1e30 or more, which means no value; expected less");
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

class PickLinePrinter
{
public:
  PickLinePrinter(std::ostream& stream, const HorizonColumns& horizon, const PrintedColumns& columns)
    : Printer(stream)
    , Horizon(horizon)
    , Columns(columns)
    , Name(Quoted(horizon.Name))
    , LineX(FindAttribute(horizon, SeismicHorizons::LineX))
    , LineY(FindAttribute(horizon, SeismicHorizons::LineY))
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
      this->Printer.Print(this->Name, '\t');
    }
    const SurveyLattice& lattice = this->Horizon.Lattice;
    if (this->Columns.HasLines)
    {
      this->Printer.Print(lattice.Lines->FirstInline + j * lattice.Lines->InlineStep, '\t',
        lattice.Lines->FirstCrossline + i * lattice.Lines->CrosslineStep, '\t');
    }
    const bool isOnLine = this->LineX && this->LineY;
    const Eigen::Vector2d place = isOnLine ? Eigen::Vector2d((*this->LineX)[index], (*this->LineY)[index])
                                           : lattice.Origin + i * lattice.ColumnStep + j * lattice.RowStep;
    this->Printer.Print(place.x(), '\t', place.y(), '\t');
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
  const std::vector<double>*const LineX, *const LineY; // of lines that leave the lattice
  std::vector<const std::vector<double>*> Values;
};
}

//----------------------------------------------------------------------------------------------------------------------
void PrintPickHeader(std::ostream& stream, const PrintedColumns& columns)
{
  std::vector<std::string> names = PlaceNames(columns.Survey);
  if (columns.HasLines)
  {
    names.insert(names.begin(), { "Inline", "Crossline" });
  }
  names.insert(names.end(), columns.Attributes.begin(), columns.Attributes.end());
  TextPrinter printer(stream);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    printer.Print(n == 0 ? "# " : "\t", Quoted(names[n]));
  }
  printer.Print("\n# - - - - - - - - - -\n");
  printer.Flush();
}

//----------------------------------------------------------------------------------------------------------------------
void PrintPicks(
  std::ostream& stream, const HorizonColumns& horizon, const PrintedColumns& columns, const Monitor& monitor)
{
  PickLinePrinter(stream, horizon, columns).Print(monitor);
}
}
