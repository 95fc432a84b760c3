// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TSurfPrinter.h"

#include "Common/Base/Errors.h"
#include "Common/Survey/NullValue.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextPrinter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t LinesBetweenReports = 1 << 16;

std::string ToWord(const char* what, const std::string& text)
{
  RequireLine(what, text);
  if (text.find('"') != std::string::npos)
  {
    throw InputError(std::string(what) + ' ' + Quote(text) + ", expected text without quotation marks");
  }
  return text.empty() || text.find_first_of(" \t{}") != std::string::npos ? '"' + text + '"' : text;
}

/// Readers trim names.
bool NeedsQuotes(const std::string& name)
{
  constexpr std::string_view blanks = " \t";
  const bool hasBlanks = !name.empty() &&
    (blanks.find(name.front()) != std::string_view::npos || blanks.find(name.back()) != std::string_view::npos);
  return hasBlanks || (name.size() >= 2 && name.front() == '"' && name.back() == '"');
}

double ChooseTSurfNull(const std::vector<double>& values)
{
  double null = -99999.0; // Nearly all files use it.
  while (std::any_of(values.begin(), values.end(), [null](double value) { return IsNullValue(value, null); }))
  {
    null = 10.0 * null - 9.0;
  }
  return null;
}

class SurfacePrinter
{
public:
  SurfacePrinter(const TSurf& surface, std::ostream& stream)
    : Surface(surface)
    , Mesh(MakePartMesh(surface))
    , Out(stream)
  {
    for (const TSurfProperty& property : surface.Properties)
    {
      this->Nulls.push_back(ChooseTSurfNull(property.Values));
    }
  }

  void PrintHeader()
  {
    const std::string& name = this->Surface.Name;
    this->Out.Print("GOCAD TSurf 1\nHEADER {\nname:", RequireLine("name", NeedsQuotes(name) ? '"' + name + '"' : name));
    if (this->Surface.Colour)
    {
      this->Out.Print("\n*solid*color:");
      for (const double part : *this->Surface.Colour)
      {
        this->Out.Print(part, ' ');
      }
      this->Out.Print('1');
    }
    this->Out.Print("\n}\n");
  }

  void PrintSurvey()
  {
    PrintCoordinateSystem(this->Surface.Survey, this->Surface.Positive == VerticalPositive::Depth, this->Out);
  }

  void PrintProperties()
  {
    if (this->Surface.Properties.empty())
    {
      return;
    }
    const auto name = [](const TSurfProperty& property) { return ToWord("name of an attribute", property.Name); };
    const auto always = [](const char* text) { return [text](const TSurfProperty&) { return std::string(text); }; };
    this->PrintForEach("PROPERTIES", name);
    this->PrintForEach("PROP_LEGAL_RANGES", always("**none** **none**"));
    this->Out.Print("NO_DATA_VALUES");
    for (const double null : this->Nulls)
    {
      this->Out.Print(' ', null);
    }
    this->Out.Print('\n');
    this->PrintForEach("PROPERTY_CLASSES", name);
    this->PrintForEach("PROPERTY_KINDS", always("unknown"));
    this->PrintForEach("PROPERTY_SUBCLASSES", always("QUANTITY Float"));
    this->PrintForEach("ESIZES", [](const TSurfProperty& property) { return std::to_string(property.Size); });
    this->PrintForEach("UNITS",
      [](const TSurfProperty& property) { return property.Unit.empty() ? "none" : ToWord("unit", property.Unit); });
  }

  void PrintParts(const Monitor& monitor)
  {
    std::size_t vertex = 0;
    std::size_t triangle = 0;
    for (const PartMesh::Part& part : this->Mesh.Parts)
    {
      this->Out.Print("TFACE\n");
      for (; vertex < part.LastVertex; ++vertex)
      {
        this->Report(vertex + triangle, monitor);
        this->PrintVertex(vertex);
      }
      for (; triangle < part.LastTriangle; ++triangle)
      {
        this->Report(vertex + triangle, monitor);
        this->Out.Print("TRGL");
        this->PrintIds(this->Mesh.Triangles[triangle]);
      }
    }
  }

  void PrintBorders()
  {
    const std::size_t numberOfVertices = this->Mesh.Sources.size();
    const std::vector<std::array<PointId, 2>> borders = FindBorders(this->Mesh.Triangles, numberOfVertices);
    for (const std::array<PointId, 2>& border : borders)
    {
      this->Out.Print("BSTONE");
      this->PrintIds(std::array<PointId, 1>{ border[0] });
    }
    std::int64_t id = std::int64_t(numberOfVertices);
    for (const std::array<PointId, 2>& border : borders)
    {
      this->Out.Print("BORDER ", ++id);
      this->PrintIds(border);
    }
  }

  void PrintEnd()
  {
    this->Out.Print("END\n");
    this->Out.Flush();
  }

private:
  template <typename Text>
  void PrintForEach(const char* keyword, Text&& text)
  {
    this->Out.Print(keyword);
    for (const TSurfProperty& property : this->Surface.Properties)
    {
      this->Out.Print(' ', text(property));
    }
    this->Out.Print('\n');
  }

  template <typename Vertices>
  void PrintIds(const Vertices& vertices)
  {
    for (const PointId vertex : vertices)
    {
      this->Out.Print(' ', std::int64_t(vertex) + 1);
    }
    this->Out.Print('\n');
  }

  void PrintVertex(std::size_t vertex)
  {
    if (this->Mesh.Places[vertex] != NoPoint)
    {
      this->Out.Print("ATOM");
      this->PrintIds(std::array<PointId, 2>{ PointId(vertex), this->Mesh.Places[vertex] });
      return;
    }
    const auto source = std::size_t(this->Mesh.Sources[vertex]);
    this->Out.Print(this->Surface.Properties.empty() ? "VRTX " : "PVRTX ", std::int64_t(vertex) + 1);
    RequireFinitePoint(this->Surface.Vertices[source], std::int64_t(source));
    for (const double coordinate : this->Surface.Vertices[source])
    {
      this->Out.Print(' ', coordinate);
    }
    this->PrintValues(source);
    this->Out.Print(this->Surface.Properties.empty() ? " CNXYZ\n" : "\n"); // Some readers accept no other ending.
  }

  void PrintValues(std::size_t source)
  {
    for (std::size_t n = 0; n < this->Nulls.size(); ++n)
    {
      const TSurfProperty& property = this->Surface.Properties[n];
      for (std::size_t place = source * property.Size; place < (source + 1) * property.Size; ++place)
      {
        const double value = property.Values[place];
        this->Out.Print(' ', std::isfinite(value) ? value : this->Nulls[n]);
      }
    }
  }

  void Report(std::size_t line, const Monitor& monitor) const
  {
    if (line % LinesBetweenReports == 0)
    {
      monitor.Progress(double(line) / double(this->Mesh.Sources.size() + this->Mesh.Triangles.size()));
    }
  }

  const TSurf& Surface;
  const PartMesh Mesh;
  std::vector<double> Nulls;
  TextPrinter Out;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::string_view RequireLine(const char* what, std::string_view text)
{
  if (std::any_of(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\0'; }))
  {
    throw InputError(std::string(what) + ' ' + Quote(text) + ", expected one line of text");
  }
  return text;
}

//----------------------------------------------------------------------------------------------------------------------
void PrintCoordinateSystem(const SurveyDescription& survey, bool isDepth, TextPrinter& out)
{
  const std::string& system = survey.CoordinateSystem;
  out.Print("GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME ",
    RequireLine("coordinate system", system.empty() ? "Default" : system), "\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT");
  for (const std::string* const unit : { &survey.HorizontalUnit, &survey.HorizontalUnit, &survey.VerticalUnit })
  {
    ToWord("unit", *unit); // Refuses quotes within the unit.
    out.Print(" \"", unit->empty() ? "none" : *unit, '"');
  }
  out.Print("\nZPOSITIVE ", isDepth ? "Depth" : "Elevation", "\nEND_ORIGINAL_COORDINATE_SYSTEM\n");
}

//----------------------------------------------------------------------------------------------------------------------
void PrintTSurf(const TSurf& surface, bool withBorders, std::ostream& stream, const Monitor& monitor)
{
  SurfacePrinter printer(surface, stream);
  printer.PrintHeader();
  printer.PrintSurvey();
  printer.PrintProperties();
  printer.PrintParts(monitor);
  if (withBorders)
  {
    printer.PrintBorders();
  }
  printer.PrintEnd();
  monitor.Progress(1.0);
}
}
