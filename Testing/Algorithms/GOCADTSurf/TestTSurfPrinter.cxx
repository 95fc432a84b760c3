// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is printed of surfaces, and that it is read back the same.

#include "TSurfText.h"
#include "Tools/MonitorChecker.h"
#include "Tools/Patches.h"
#include "Writers/GOCADTSurf/TSurfPrinter.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace SeismicHorizons;
using namespace TSurfText;

namespace
{
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

using Borders = std::vector<std::array<PointId, 2>>;

std::string Print(const TSurf& surface, bool withBorders = true)
{
  std::ostringstream stream;
  PrintTSurf(surface, withBorders, stream);
  return stream.str();
}

/// A square of two triangles, and a vertex that none of them has.
TSurf MakeSquare()
{
  TSurf surface;
  surface.Name = "my: square";
  surface.Survey = { "ms", "time", "ft", "UTM 31N" };
  surface.Vertices = { { 0, 0, 5 }, { 9, 9, 9 }, { 1, 0, 5.25 }, { 1, 1, 5 }, { 0, 1, -1e-9 } };
  surface.Triangles = { { 0, 2, 3 }, { 0, 3, 4 } };
  return surface;
}

void LinesAreThoseOfTheFormat()
{
  TSurf surface = MakeSquare();
  surface.Colour = { 1.0, 0.5, 0.0 };
  surface.Positive = VerticalPositive::Depth;
  surface.Properties = { { "a b", "", 1, { 1, 2, Nan, 4, 5 } },
    { "v", "m/s", 2, { 0, 1, 2, 3, 4, -99999, 6, 7, 8, 0.5 } } };
  CHECK_EQUAL(Print(surface),
    "GOCAD TSurf 1\nHEADER {\nname:my: square\n*solid*color:1 0.5 0 1\n}\n"
    "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME UTM 31N\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT \"ft\" \"ft\" \"ms\"\n"
    "ZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n"
    "PROPERTIES \"a b\" v\nPROP_LEGAL_RANGES **none** **none** **none** **none**\n"
    "NO_DATA_VALUES -99999 -999999\nPROPERTY_CLASSES \"a b\" v\nPROPERTY_KINDS unknown unknown\n"
    "PROPERTY_SUBCLASSES QUANTITY Float QUANTITY Float\nESIZES 1 2\nUNITS none m/s\n"
    "TFACE\nPVRTX 1 0 0 5 1 0 1\nPVRTX 2 1 0 5.25 -99999 4 -99999\nPVRTX 3 1 1 5 4 6 7\n"
    "PVRTX 4 0 1 -1e-09 5 8 0.5\nTRGL 1 2 3\nTRGL 1 3 4\nBSTONE 1\nBORDER 5 1 4\nEND\n");
  CHECK(Print(surface, false).find("BSTONE") == std::string::npos);
  CHECK(Print(surface, false).find("BORDER") == std::string::npos);
}

bool AreSame(const std::vector<double>& a, const std::vector<double>& b)
{
  bool same = a.size() == b.size();
  for (std::size_t n = 0; same && n < a.size(); ++n)
  {
    same = (std::isnan(a[n]) && std::isnan(b[n])) || std::memcmp(&a[n], &b[n], sizeof(double)) == 0;
  }
  return same;
}

void CheckReadBack(const TSurf& surface)
{
  const TSurf read = LoadOne(Print(surface));
  CHECK_EQUAL(read.Name, surface.Name);
  CHECK(read.Colour == surface.Colour);
  CHECK(read.Positive == surface.Positive);
  CHECK_EQUAL(read.Survey.VerticalUnit, surface.Survey.VerticalUnit);
  CHECK_EQUAL(read.Survey.HorizontalUnit, surface.Survey.HorizontalUnit);
  CHECK_EQUAL(read.Survey.CoordinateSystem, surface.Survey.CoordinateSystem);
  CHECK(read.Vertices == surface.Vertices);
  CHECK(read.Triangles == surface.Triangles);
  CHECK(read.Parts == surface.Parts);
  CHECK_EQUAL(read.Properties.size(), surface.Properties.size());
  for (std::size_t n = 0; n < std::min(read.Properties.size(), surface.Properties.size()); ++n)
  {
    CHECK_EQUAL(read.Properties[n].Name, surface.Properties[n].Name);
    CHECK_EQUAL(read.Properties[n].Unit, surface.Properties[n].Unit);
    CHECK_EQUAL(read.Properties[n].Size, surface.Properties[n].Size);
    CHECK(AreSame(read.Properties[n].Values, surface.Properties[n].Values));
  }
  CHECK_EQUAL(Print(read), Print(surface));
}

/// A strip of triangles over random places, that face one side.
TSurf MakeRandomStrip(std::size_t numberOfVertices, std::size_t trianglesOfPart)
{
  Patches::Random random(11);
  TSurf surface;
  surface.Survey = { "m", "depth", "m", "Default" };
  surface.Properties = { { "one", "", 1, {} }, { "three", "km", 3, {} } };
  for (std::size_t vertex = 0; vertex < numberOfVertices; ++vertex)
  {
    surface.Vertices.push_back({ 4e5 + random.Fraction(), 5e6 + random.Fraction(), 1e-12 * random.Fraction() });
    for (TSurfProperty& property : surface.Properties)
    {
      for (std::size_t n = 0; n < property.Size; ++n)
      {
        property.Values.push_back(random.Fraction() < 0.2 ? Nan : -99999.0 * random.Fraction());
      }
    }
    if (vertex >= 2)
    {
      const std::size_t odd = vertex % 2;
      surface.Triangles.push_back({ PointId(vertex - 2 + odd), PointId(vertex - 1 - odd), PointId(vertex) });
      surface.Parts.push_back(std::int32_t((surface.Triangles.size() - 1) / trianglesOfPart));
    }
  }
  return surface;
}

void SurfacesAreReadBack()
{
  TSurf strip = MakeRandomStrip(1000, 1000);
  strip.Parts.clear();
  CheckReadBack(strip);
  strip.Positive = VerticalPositive::Depth;
  strip.Colour = { 0.1, 0.2, 1.0 / 3.0 };
  for (const char* const name : { "", "a", "\"a\"", " a ", "a:b", "}", "{", "END", "name:x", "\xC3\xA9t\xC3\xA9" })
  {
    strip.Name = name;
    CheckReadBack(strip);
  }
}

/// Vertices that parts have in common are atoms, in the place of the vertex of the first part.
void PartsAreReadBack()
{
  const TSurf strip = MakeRandomStrip(100, 10);
  const TSurf read = LoadOne(Print(strip));
  CHECK(read.Parts == strip.Parts);
  CHECK_EQUAL(read.Vertices.size(), 100u + 2u * 9u);
  for (std::size_t n = 0; n < strip.Triangles.size(); ++n)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto here = std::size_t(strip.Triangles[n][corner]);
      const auto there = std::size_t(read.Triangles[n][corner]);
      CHECK(strip.Vertices[here] == read.Vertices[there]);
      const auto value = [](const TSurf& surface, std::size_t vertex)
      { return std::vector<double>{ surface.Properties[0].Values[vertex] }; };
      CHECK(AreSame(value(strip, here), value(read, there)));
    }
  }
  CheckReadBack(read);
  CHECK_EQUAL(read.Borders.size(), 10u);
}

void TrianglesComePartByPart()
{
  TSurf surface = MakeSquare();
  surface.Parts = { 7, -3 };
  const PartMesh mesh = MakePartMesh(surface);
  CHECK((mesh.Sources == std::vector<PointId>{ 0, 3, 4, 0, 2, 3 }));
  CHECK((mesh.Places == std::vector<PointId>{ NoPoint, NoPoint, NoPoint, 0, NoPoint, 1 }));
  CHECK((mesh.Triangles == std::vector<TSurf::Triangle>{ { 0, 1, 2 }, { 3, 4, 5 } }));
  CHECK((LoadOne(Print(surface)).Parts == std::vector<std::int32_t>{ 0, 1 }));
}

void BordersAreLoops()
{
  CHECK((FindBorders({ { 0, 1, 2 } }, 3) == Borders{ { 0, 2 } }));
  CHECK((FindBorders({ { 1, 2, 3 }, { 0, 4, 5 } }, 6) == Borders{ { 0, 5 }, { 1, 3 } }));
  CHECK((FindBorders({ { 0, 1, 2 }, { 0, 2, 3 } }, 4) == Borders{ { 0, 3 } }));
  const std::vector<TSurf::Triangle> tetrahedron = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  CHECK(FindBorders(tetrahedron, 4).empty());
  CHECK(FindBorders({}, 0).empty());
}

/// Two triangles that meet in a vertex, two that face different sides, three at an edge, and one without an area.
void BordersOfOddMeshesEnd()
{
  CHECK((FindBorders({ { 0, 1, 2 }, { 0, 3, 4 } }, 5) == Borders{ { 0, 2 }, { 0, 4 } }));
  CHECK_EQUAL(FindBorders({ { 0, 1, 2 }, { 0, 1, 3 } }, 4).size(), 2u);
  CHECK_EQUAL(FindBorders({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, 5).size(), 2u);
  CHECK((FindBorders({ { 0, 0, 0 } }, 1).size() <= 1u));
}

void WhatTheFormatCanNotHoldIsRefused()
{
  const auto check = [](auto&& change, const std::string& message)
  {
    TSurf surface = MakeSquare();
    surface.Properties = { { "p", "", 1, std::vector<double>(5, 0.0) } };
    change(surface);
    CHECK_THROWS_WITH(Print(surface), message);
  };
  check([](TSurf& surface) { surface.Name = "a\nb"; }, "name \"a?b\", expected one line of text");
  check([](TSurf& surface) { surface.Survey.CoordinateSystem = "a\rb"; }, "coordinate system \"a?b\", expected one");
  check([](TSurf& surface) { surface.Survey.VerticalUnit = "\""; }, "unit \"\"\", expected text without quotation");
  check([](TSurf& surface) { surface.Properties[0].Name = "a\"b"; },
    "name of an attribute \"a\"b\", expected text without quotation marks");
  check([](TSurf& surface) { surface.Properties[0].Unit = "a\nb"; }, "unit \"a?b\", expected one line of text");
  check([](TSurf& surface) { surface.Vertices[2][1] = Nan; }, "coordinate nan of point 2, expected a finite number");
  check([](TSurf& surface) { surface.Vertices[4][2] = -HUGE_VAL; }, "coordinate -inf of point 4, expected a finite");
}

void WorkIsMonitored()
{
  const TSurf strip = MakeRandomStrip(200000, 1000000);
  CHECK_EQUAL(MonitorChecker::Check(4,
                [&strip](const Monitor& monitor)
                {
                  std::ostringstream stream;
                  PrintTSurf(strip, true, stream, monitor);
                }),
    "");
}
}

int TestTSurfPrinter(int, char*[])
{
  LinesAreThoseOfTheFormat();
  SurfacesAreReadBack();
  PartsAreReadBack();
  TrianglesComePartByPart();
  BordersAreLoops();
  BordersOfOddMeshesEnd();
  WhatTheFormatCanNotHoldIsRefused();
  WorkIsMonitored();
  return Check::Result();
}
