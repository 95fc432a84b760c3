// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DXFPrinter.h"

#include "Common/Text/TextWords.h"

#include <array>
#include <set>

namespace SeismicHorizons
{
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
  out.Print(std::int64_t(code), '\n', value, '\n');
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
}

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
void PrintDXFEnd(TextPrinter& out)
{
  PrintText(0, "ENDSEC", out);
  PrintText(0, "EOF", out);
  out.Flush();
}
}
