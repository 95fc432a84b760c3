// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OtherFormats.h"

#include "Common/Base/Errors.h"
#include "TextFields.h"
#include "TextWords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
using namespace std::string_view_literals;

constexpr std::string_view AsText = "export x, y and z as text";
constexpr std::string_view AsVertices = "export its vertices as text, or the surface as GOCAD TSurf";
constexpr std::string_view AsPoints = "open it in ParaView, or with VTK, and use Horizon from Points";
constexpr std::string_view AsTable = "convert it to text, as with ogr2ogr -f CSV -lco GEOMETRY=AS_XYZ";

struct Format
{
  std::string_view Beginning;
  std::string_view Name;
  std::string_view Remedy;
};

/// The first signature that fits applies.
constexpr std::array<Format, 24> Formats = { {
  { "LASF"sv, "a point cloud (LAS)", "convert it to text, as with pdal translate, or open it in ParaView" },
  { "AutoCAD Binary DXF"sv, "a drawing (DXF)", AsText },
  { "\0\0\x27\x0A"sv, "a shapefile", AsTable },
  { "VBS\0"sv, "a seismic cube (ZGY)", "convert it to SEG-Y" },
  { "VCS\0"sv, "a seismic cube (ZGY)", "convert it to SEG-Y" },
  { "%PDF"sv, "a PDF document", AsText },
  { "PK\x03\x04"sv, "a ZIP archive, as of Excel or RESQML", "save the table as CSV, or unpack the archive" },
  { "\xD0\xCF\x11\xE0"sv, "an Office document", "save the table as CSV" },
  { "SQLite format 3\0"sv, "a database (SQLite), as of GeoPackage", AsTable },
  { "\x89HDF"sv, "an HDF5 file, as of netCDF", AsText },
  { "CDF\x01"sv, "a netCDF file", AsText },
  { "CDF\x02"sv, "a netCDF file", AsText },
  { "\x89PNG"sv, "a picture (PNG)", AsText },
  { "\xFF\xD8\xFF"sv, "a picture (JPEG)", AsText },
  { "ply\n"sv, "a triangle mesh (PLY)", AsVertices },
  { "ply\r"sv, "a triangle mesh (PLY)", AsVertices },
  { "$MeshFormat"sv, "a mesh of Gmsh", AsVertices },
  { "# vtk DataFile"sv, "a VTK file", AsPoints },
  { "<VTKFile"sv, "a VTK file", AsPoints },
  { "<?xml"sv, "an XML file", AsText },
  { "GOCAD TSurf"sv, "a surface of GOCAD", "open it by the reader of GOCAD TSurf" },
  { "GOCAD VSet"sv, "points of GOCAD (VSet)", "open it by the reader of horizons as text, without Columns" },
  { "GOCAD PLine"sv, "lines of GOCAD", "read them as fault lines or fault sticks" },
  { "GOCAD"sv, "an object of GOCAD", "export it as TSurf, or x, y and z as text" },
} };

std::vector<std::string_view> ListTextLines(std::string_view text, std::size_t most)
{
  std::vector<std::string_view> lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos && lines.size() < most; end = text.find('\n'))
  {
    const std::string_view line = Trim(text.substr(0, end));
    text.remove_prefix(end + 1);
    if (!line.empty())
    {
      lines.push_back(line);
    }
  }
  return lines;
}

/// DXF has pairs of lines, a code and a value; code 999 is a comment.
bool IsDrawing(const std::vector<std::string_view>& lines)
{
  std::size_t line = 0;
  while (line + 1 < lines.size() && lines[line] == "999")
  {
    line += 2;
  }
  return line + 1 < lines.size() && lines[line] == "0" && lines[line + 1] == "SECTION";
}

/// All lines must begin with words of Wavefront OBJ, and at least one must be a vertex.
bool IsWavefront(const std::vector<std::string_view>& lines)
{
  constexpr std::array<std::string_view, 11> words = { "#", "v", "vn", "vt", "f", "l", "o", "g", "s", "mtllib",
    "usemtl" };
  const auto first = [](std::string_view line)
  { return line.substr(0, line[0] == '#' ? 1 : line.find_first_of(" \t")); };
  return std::any_of(lines.begin(), lines.end(), [&](std::string_view line) { return first(line) == "v"; }) &&
    std::all_of(lines.begin(), lines.end(),
      [&](std::string_view line) { return std::find(words.begin(), words.end(), first(line)) != words.end(); });
}

/// Triangles of 50 bytes follow a header of 84: a normal of length 0 or 1, corners, and two zero bytes.
bool IsBinarySTL(std::string_view bytes)
{
  constexpr std::size_t header = 84;
  constexpr std::size_t size = 50;
  bool isSTL = bytes.size() >= header + size;
  for (std::size_t at = header; isSTL && at + size <= bytes.size(); at += size)
  {
    std::array<float, 3> normal{};
    std::memcpy(normal.data(), bytes.data() + at, sizeof(normal));
    const float length = std::hypot(normal[0], normal[1], normal[2]);
    isSTL = (length == 0.0F || std::abs(length - 1.0F) < 1e-3F) && bytes.substr(at + size - 2, 2) == "\0\0"sv;
  }
  return isSTL && bytes.find_first_not_of('\0', header) != std::string_view::npos;
}

Format FindFormat(std::string_view bytes)
{
  const auto known = std::find_if(
    Formats.begin(), Formats.end(), [&](const Format& format) { return StartsWith(bytes, format.Beginning); });
  const std::vector<std::string_view> lines = ListTextLines(bytes, 200);
  const auto log = std::find_if(lines.begin(), lines.end(), [](std::string_view line) { return line[0] != '#'; });
  const auto has = [&](std::string_view first, std::string_view word)
  { return StartsWith(Trim(bytes.substr(0, bytes.find('\n'))), first) && bytes.find(word) != std::string_view::npos; };
  return known != Formats.end()                   ? *known
    : IsDrawing(lines)                            ? Format{ {}, "a drawing (DXF)", AsText }
    : IsWavefront(lines)                          ? Format{ {}, "a triangle mesh (OBJ)", AsVertices }
    : has("solid", "facet") || IsBinarySTL(bytes) ? Format{ {}, "a triangle mesh (STL)", AsVertices }
    : has("{", "\"type\"")                        ? Format{ {}, "GeoJSON", AsTable }
    : log != lines.end() && StartsWith(ToLower(*log), "~v")
    ? Format{ {}, "a well log (LAS)", "export the picks of horizons in wells as text" }
    : Format();
}
}

//----------------------------------------------------------------------------------------------------------------------
void RefuseOtherFormats(std::string_view beginning, std::string_view expected)
{
  constexpr std::size_t lookedAt = 8192;
  const std::string_view bytes = WithoutByteOrderMark(beginning.substr(0, lookedAt));
  const Format found = FindFormat(bytes);
  if (!found.Name.empty())
  {
    throw InputError(
      std::string(found.Name) + ", expected " + std::string(expected) + ": " + std::string(found.Remedy));
  }
}
}
