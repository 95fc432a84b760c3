// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDXFWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Text/TextPrinter.h"
#include "Common/Text/TextWords.h"
#include "Writers/GOCADTSurf/HorizonTSurf.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace SeismicHorizons;

// AutoCAD R12 (AC1009) is read by all DXF programs (Documentation/HorizonDXFWriter.md). Coordinates have the digits that
// restore them exactly.
namespace
{
constexpr std::size_t LongestName = 31; // Limit of AC1009.
constexpr std::size_t TrianglesBetweenReports = 1 << 14;
constexpr int NumberOfColours = 6; // Colours 1 to 6 are red, yellow, green, cyan, blue and magenta.

bool IsContinued(char c)
{
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80; // A continuation byte of UTF-8.
}

bool IsAllowed(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string ToLayerName(const std::string& name)
{
  std::string layer;
  for (const char c : name)
  {
    if (!IsContinued(c) && layer.size() < LongestName)
    {
      layer += IsAllowed(c) ? c : '_';
    }
  }
  return layer.empty() ? "_" : layer;
}

/// A group of the format is a code and, on the next line, a value.
template <typename Value>
void PrintGroup(int code, const Value& value, TextPrinter& out)
{
  out.Print(std::int64_t(code));
  out.Print('\n');
  out.Print(value);
  out.Print('\n');
}

void PrintText(int code, std::string_view text, TextPrinter& out)
{
  PrintGroup(code, text, out);
}

void PrintSection(std::string_view name, TextPrinter& out)
{
  PrintText(0, "SECTION", out);
  PrintText(2, name, out);
}

/// Names have at most 31 ASCII letters, digits, "-" and "_"; "_" replaces other characters. Layers ignore case, so that
/// repeated names get "_2", "_3" and so on.
std::vector<std::string> MakeLayerNames(const std::vector<std::string>& names)
{
  std::vector<std::string> layers;
  std::set<std::string> taken;
  for (const std::string& name : names)
  {
    const std::string first = ToLayerName(name);
    std::string layer = first;
    for (int number = 2; !taken.insert(ToLower(layer)).second; ++number)
    {
      const std::string end = '_' + std::to_string(number);
      layer = first.substr(0, LongestName - end.size()) + end;
    }
    layers.push_back(layer);
  }
  return layers;
}

void PrintDXFBegin(const std::vector<std::string>& layers, TextPrinter& out)
{
  PrintSection("HEADER", out);
  PrintText(9, "$ACADVER", out);
  PrintText(1, "AC1009", out);
  PrintText(0, "ENDSEC", out);
  PrintSection("TABLES", out);
  PrintText(0, "TABLE", out);
  PrintText(2, "LAYER", out);
  PrintGroup(70, std::int64_t(layers.size()), out);
  std::int64_t number = 0;
  for (const std::string& layer : layers)
  {
    PrintText(0, "LAYER", out);
    PrintText(2, layer, out);
    PrintGroup(70, std::int64_t(0), out);
    PrintGroup(62, number++ % NumberOfColours + 1, out);
    PrintText(6, "CONTINUOUS", out);
  }
  PrintText(0, "ENDTAB", out);
  PrintText(0, "ENDSEC", out);
  PrintSection("ENTITIES", out);
}

/// Each triangle is a 3DFACE. Throws InputError for coordinates that are not finite.
void PrintDXFFaces(const TSurf& surface, const std::string& layer, TextPrinter& out, const Monitor& monitor)
{
  std::size_t number = 0;
  for (const TSurf::Triangle& triangle : surface.Triangles)
  {
    if (number++ % TrianglesBetweenReports == 0)
    {
      monitor.Progress(double(number) / double(surface.Triangles.size()));
    }
    PrintText(0, "3DFACE", out);
    PrintText(8, layer, out);
    for (int corner = 0; corner < 4; ++corner) // Faces have four corners; the fourth repeats the third.
    {
      const PointId point = triangle[std::size_t(corner < 3 ? corner : 2)];
      const std::array<double, 3>& vertex = surface.Vertices[std::size_t(point)];
      RequireFinitePoint(vertex, point);
      for (int axis = 0; axis < 3; ++axis)
      {
        PrintGroup(10 * (axis + 1) + corner, vertex[std::size_t(axis)], out);
      }
    }
  }
}

void PrintDXFEnd(TextPrinter& out)
{
  PrintText(0, "ENDSEC", out);
  PrintText(0, "EOF", out);
  out.Flush();
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
vtkStandardNewMacro(vtkHorizonDXFWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonDXFWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  std::vector<std::string> names(horizons.size());
  std::transform(
    horizons.begin(), horizons.end(), names.begin(), [](const NamedHorizon& horizon) { return horizon.Name; });
  const std::vector<std::string> layers = MakeLayerNames(names);
  TextPrinter out(stream);
  PrintDXFBegin(layers, out);
  const auto size = static_cast<double>(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    PrefixErrors(names[n],
      [&]()
      {
        const TSurf surface = MakeTSurf(horizons[n].Data, names[n], VerticalPositive::Elevation);
        const Monitor step = monitor.Step(static_cast<double>(n) / size, static_cast<double>(n + 1) / size);
        PrintDXFFaces(surface, layers[n], out, step);
      });
  }
  PrintDXFEnd(out);
}
