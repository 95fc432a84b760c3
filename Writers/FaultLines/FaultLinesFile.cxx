// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLinesFile.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/TextPrinter.h"
#include "Writers/ColumnNames.h"
#include "Writers/FaultParts.h"
#include "Writers/GOCADTSurf/TSurfPrinter.h"
#include "Writers/HorizonFiles.h"

#include <algorithm>
#include <array>
#include <functional>

namespace SeismicHorizons
{
namespace
{
using WrittenPlace = std::array<double, 3>;

/// Calls take(cell, places) for each line and polygon, which becomes closed, with z times `sign`.
void ForEachLine(
  const Horizon& lines, int sign, const std::function<void(std::int64_t, const std::vector<WrittenPlace>&)>& take)
{
  std::int64_t first = lines.Vertices.Size();
  for (const Cells* const cells : { &lines.Lines, &lines.Polygons })
  {
    for (std::int64_t cell = 0; cell < cells->Size(); ++cell)
    {
      std::vector<WrittenPlace> places;
      for (std::int64_t n = 0; n < cells->Length(cell); ++n)
      {
        const std::int64_t point = cells->At(cell, n);
        const Eigen::Vector3d place = lines.Place(point);
        places.push_back({ place.x(), place.y(), sign * place.z() });
        RequireFinitePoint(places.back(), point);
      }
      if (cells == &lines.Polygons && !places.empty())
      {
        places.push_back(places.front());
      }
      take(first + cell, places);
    }
    first += cells->Size();
  }
}

/// The name of a part of SplitByFault; empty if unknown.
std::string FaultOf(const NamedHorizon& part)
{
  return TextOfCell(part.Data, CellArray::FaultName, part.Data.Vertices.Size());
}

// ---- Formats --------------------------------------------------------------------------------------------------------

void PrintTable(const std::vector<NamedHorizon>& faults, char between, int sign, TextPrinter& out)
{
  SurveyDescription survey = ReadSurveyFields(faults.front().Data.FieldData);
  survey.IsUpright = sign > 0;
  const bool haveNames =
    std::any_of(faults.begin(), faults.end(), [](const NamedHorizon& one) { return !FaultOf(one).empty(); });
  std::vector<std::string> names = PlaceNames(survey);
  names.insert(names.begin(), haveNames ? 1 : 0, "Fault");
  names.insert(names.end(), { "Stick", "Node" });
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    out.Print(n > 0 ? std::string(1, between) : between == ',' ? "" : "# ", Quoted(names[n]));
  }
  out.Print('\n');
  std::int64_t line = 0;
  for (const NamedHorizon& one : faults)
  {
    const std::string name = haveNames ? Quoted(FaultOf(one)) + between : std::string();
    ForEachLine(one.Data, sign,
      [&](std::int64_t cell, const std::vector<WrittenPlace>& places)
      {
        const std::string given = TextOfCell(one.Data, CellArray::FaultStick, cell);
        const std::string stick = given.empty() ? std::to_string(line) : given;
        for (std::size_t node = 0; node < places.size(); ++node)
        {
          const auto [x, y, z] = places[node];
          out.Print(name, x, between, y, between, z, between, stick, between, node, '\n');
        }
        ++line;
      });
  }
}

void PrintPLines(const std::vector<NamedHorizon>& faults, int sign, TextPrinter& out)
{
  for (const NamedHorizon& fault : faults)
  {
    out.Print("GOCAD PLine 1\nHEADER {\n");
    const std::string name = FaultOf(fault);
    if (!name.empty())
    {
      out.Print("name:", RequireLine("name", name), '\n');
    }
    out.Print("}\n");
    PrintCoordinateSystem(ReadSurveyFields(fault.Data.FieldData), sign < 0, out);
    std::int64_t id = 0;
    ForEachLine(fault.Data, sign,
      [&](std::int64_t, const std::vector<WrittenPlace>& places)
      {
        out.Print("ILINE\n");
        const std::int64_t first = id + 1;
        for (const auto [x, y, z] : places)
        {
          out.Print("VRTX ", ++id, ' ', x, ' ', y, ' ', z, '\n');
        }
        for (std::int64_t vertex = first; vertex < id; ++vertex)
        {
          out.Print("SEG ", vertex, ' ', vertex + 1, '\n');
        }
      });
    out.Print("END\n");
  }
}

void PrintPolygons(const NamedHorizon& fault, int sign, TextPrinter& out)
{
  ForEachLine(fault.Data, sign,
    [&out](std::int64_t, const std::vector<WrittenPlace>& places)
    {
      for (const auto [x, y, z] : places)
      {
        out.Print(x, ' ', y, ' ', z, '\n');
      }
      out.Print("999.0 999.0 999.0\n");
    });
}
}

//----------------------------------------------------------------------------------------------------------------------
bool AreFaultLines(const Horizon& lines)
{
  const DataArray* const names = lines.CellData.Find(NamesOfLines(lines));
  return names && names->IsText() && lines.Lines.Size() > 0;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFaultLines(const std::string& path, const std::vector<NamedHorizon>& lines, WrittenSense sense,
  const Monitor& monitor, std::string& subject)
{
  std::vector<NamedHorizon> faults = SplitByFault(lines);
  faults.erase(std::remove_if(faults.begin(), faults.end(),
                 [](const NamedHorizon& one) { return one.Data.Lines.Size() + one.Data.Polygons.Size() == 0; }),
    faults.end());
  if (faults.empty())
  {
    throw InputError("no lines, expected polylines or polygons");
  }
  const std::string form = ExtensionOf(path);
  const bool isTable = form != "pl" && form != "pol";
  const int sign = isTable ? SignOfTable(faults.front().Data, sense) : VerticalSign(faults.front().Data, sense);
  WriteHorizonFiles(
    path, faults, form == "pol",
    [&](const std::vector<NamedHorizon>& some, std::ostream& stream, const Monitor&)
    {
      TextPrinter out(stream);
      form == "pl"      ? PrintPLines(some, sign, out)
        : form == "pol" ? PrintPolygons(some.front(), sign, out)
                        : PrintTable(some, form == "csv" ? ',' : '\t', sign, out);
      out.Flush();
    },
    monitor, subject);
}
}
