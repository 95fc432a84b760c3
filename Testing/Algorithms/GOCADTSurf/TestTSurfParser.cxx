// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is read of GOCAD files.

#include "TSurfText.h"
#include "Tools/MonitorChecker.h"

#include <cmath>

using namespace SeismicHorizons;
using namespace TSurfText;

namespace
{
using Triangles = std::vector<TSurf::Triangle>;
using Places = std::vector<std::array<double, 3>>;

const std::string Small = "GOCAD TSurf 1\n"
                          "HEADER {\n"
                          "name: my fault: east\n"
                          "*solid*color:0.25 0.5 1 1\n"
                          "}\n"
                          "GOCAD_ORIGINAL_COORDINATE_SYSTEM\n"
                          "NAME UTM 31N\n"
                          "AXIS_NAME \"X\" \"Y\" \"Z\"\n"
                          "AXIS_UNIT \"m\" \"m\" \"ms\"\n"
                          "ZPOSITIVE Depth\n"
                          "END_ORIGINAL_COORDINATE_SYSTEM\n"
                          "PROPERTIES p \"my vector\"\n"
                          "PROP_LEGAL_RANGES **none** **none** **none** **none**\n"
                          "NO_DATA_VALUES -99999 -99999\n"
                          "ESIZES 1 3\n"
                          "UNITS m none\n"
                          "TFACE\n"
                          "PVRTX 1 0 0 10 5 1 2 3\n"
                          "PVRTX 2 1 0 10.5 -99999 4 5 6 CNXYZ\n"
                          "VRTX 3 0 1 10\n"
                          "TRGL 1 2 3\n"
                          "BSTONE 1\n"
                          "BORDER 4 1 3\n"
                          "END\n";

/// Two triangles in two parts over four vertices, where vertices are what `vertices` says.
std::string Square(const std::string& vertices, const std::string& triangles)
{
  return "GOCAD TSurf 1\nTFACE\n" + vertices + triangles + "END\n";
}

std::string FourVertices(const std::array<std::string, 4>& ids)
{
  return "VRTX " + ids[0] + " 0 0 0\nVRTX " + ids[1] + " 1 0 0\nVRTX " + ids[2] + " 1 1 0\nVRTX " + ids[3] + " 0 1 0\n";
}

std::string Triangle(const std::string& a, const std::string& b, const std::string& c)
{
  return "TRGL " + a + ' ' + b + ' ' + c + '\n';
}

void AllOfASurfaceIsRead()
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    const TSurf surface = Load(Small, bufferSize).at(0);
    CHECK_EQUAL(surface.Name, "my fault: east");
    CHECK((surface.Colour == std::array<double, 3>{ 0.25, 0.5, 1.0 }));
    CHECK(surface.Positive == VerticalPositive::Depth);
    CHECK_EQUAL(surface.Survey.CoordinateSystem, "UTM 31N");
    CHECK_EQUAL(surface.Survey.HorizontalUnit, "m");
    CHECK_EQUAL(surface.Survey.VerticalUnit, "ms");
    CHECK_EQUAL(surface.Survey.VerticalDomain, "time");
    CHECK((surface.Vertices == Places{ { 0, 0, 10 }, { 1, 0, 10.5 }, { 0, 1, 10 } }));
    CHECK((surface.Triangles == Triangles{ { 0, 1, 2 } }));
    CHECK(surface.Parts.empty());
    CHECK((surface.BorderStones == std::vector<PointId>{ 0 }));
    CHECK((surface.Borders == std::vector<std::array<PointId, 2>>{ { 0, 2 } }));
  }
}

/// Keywords and names of the header are read in either case, values as they are.
void SmallLettersAreRead()
{
  std::string text = Small;
  for (char& c : text)
  {
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  }
  for (const std::string& file : { text,
         "Gocad TSurf 1\nHeader {\nName: my fault: east\n*Solid*Color:0.25 0.5 1\n}\n" +
           text.substr(text.find("gocad_original")) })
  {
    const TSurf surface = LoadOne(file);
    CHECK_EQUAL(surface.Name, "my fault: east");
    CHECK((surface.Colour == std::array<double, 3>{ 0.25, 0.5, 1.0 }));
    CHECK(surface.Positive == VerticalPositive::Depth);
    CHECK_EQUAL(surface.Survey.CoordinateSystem, "utm 31n");
    CHECK_EQUAL(surface.Survey.VerticalUnit, "ms");
    CHECK((surface.Vertices == LoadOne(Small).Vertices && surface.Triangles == LoadOne(Small).Triangles));
    CHECK_EQUAL(surface.Properties.size(), 2u);
    CHECK(std::isnan(surface.Properties.at(0).Values.at(1)));
    CHECK((surface.Borders == std::vector<std::array<PointId, 2>>{ { 0, 2 } }));
  }
  CHECK_EQUAL(List(text).Names.at(0), "my fault: east");
}

void PropertiesHaveSizesAndNulls()
{
  const TSurf surface = LoadOne(Small);
  CHECK_EQUAL(surface.Properties.size(), 2u);
  const TSurfProperty& number = surface.Properties.at(0);
  CHECK_EQUAL(number.Name, "p");
  CHECK_EQUAL(number.Unit, "m");
  CHECK_EQUAL(number.Values.size(), 3u);
  CHECK(number.Values.at(0) == 5.0 && std::isnan(number.Values.at(1)) && std::isnan(number.Values.at(2)));
  const TSurfProperty& vector = surface.Properties.at(1);
  CHECK_EQUAL(vector.Name, "my vector");
  CHECK_EQUAL(vector.Size, 3u);
  CHECK(
    (std::vector<double>(vector.Values.begin(), vector.Values.begin() + 6) == std::vector<double>{ 1, 2, 3, 4, 5, 6 }));
  CHECK_EQUAL(vector.Values.size(), 9u);
  CHECK(std::isnan(vector.Values.at(8)));
}

/// In single precision the null of some files is another number than the one they state.
void NullsAreComparedInSinglePrecision()
{
  const std::string start = "GOCAD TSurf 1\nPROPERTIES p\nNO_DATA_VALUES 1.0000000031710769e-30\nTFACE\nPVRTX 1 0 0 0 ";
  CHECK(std::isnan(LoadOne(start + "1e-30\nEND\n").Properties.at(0).Values.at(0)));
  CHECK(std::isnan(LoadOne(start + "1.0000000031710769e-30\nEND\n").Properties.at(0).Values.at(0)));
  CHECK_EQUAL(LoadOne(start + "1.000001e-30\nEND\n").Properties.at(0).Values.at(0), 1.000001e-30);
  CHECK_EQUAL(LoadOne(start + "0\nEND\n").Properties.at(0).Values.at(0), 0.0);
  CHECK(std::isnan(LoadOne(start + "nan\nEND\n").Properties.at(0).Values.at(0)));
  const std::string none = "GOCAD TSurf 1\nPROPERTIES p\nNO_DATA_VALUES **none**\nTFACE\nPVRTX 1 0 0 0 -99999\nEND\n";
  CHECK_EQUAL(LoadOne(none).Properties.at(0).Values.at(0), -99999.0);
}

void PropertiesWithoutValuesAreLeftOut()
{
  const TSurf surface = LoadOne("GOCAD TSurf 1\nPROPERTIES p\nESIZES 1024\nTFACE\nVRTX 1 0 0 0\nEND\n");
  CHECK(surface.Properties.empty());
  CHECK_EQUAL(surface.Vertices.size(), 1u);
}

void DefaultsAreThoseOfGOCAD()
{
  const TSurf surface = LoadOne("GOCAD TSurf 1\nEND\n");
  CHECK(surface.Positive == VerticalPositive::Elevation);
  CHECK(surface.Name.empty() && !surface.Colour);
  CHECK(surface.Survey.VerticalUnit.empty() && surface.Survey.VerticalDomain.empty());
  CHECK(surface.Vertices.empty() && surface.Triangles.empty() && surface.Properties.empty());
}

void HeadersAreFree()
{
  const auto name = [](const std::string& header) { return LoadOne("GOCAD TSurf 1\n" + header + "\nEND\n").Name; };
  CHECK_EQUAL(name("HEADER {\ngname:no\nname:fault A\nfree line\nname_of:no\n}"), "fault A");
  CHECK_EQUAL(name("HEADER {\nname: \"a: {b} \"\n}"), "a: {b} ");
  CHECK_EQUAL(name("HEADER {name:one line}"), "one line");
  CHECK_EQUAL(name("HEADER{\nname:x\n}"), "x");
  CHECK_EQUAL(name("HEADER {\nname:END\nEND\nGOCAD TSurf 1\n }  "), "END");
  CHECK_EQUAL(name("PROPERTY_CLASS_HEADER Z {\nname:no\n}"), "");
  const auto colour = [](const std::string& text)
  { return LoadOne("GOCAD TSurf 1\nHEADER {\n*solid*color:" + text + "\n}\nEND\n").Colour; };
  CHECK((colour("#ff0033") == std::array<double, 3>{ 1.0, 0.0, 0.2 }));
  CHECK((colour("#FF0033") == std::array<double, 3>{ 1.0, 0.0, 0.2 }));
  CHECK((colour("1 0 0.5") == std::array<double, 3>{ 1.0, 0.0, 0.5 }));
  for (const char* const wrong : { "red", "", "1 0", "2 0 0", "#ff00zz", "#ff00" })
  {
    CHECK(!colour(wrong));
  }
}

void IdsMayHaveGaps()
{
  const Triangles expected = { { 0, 1, 2 }, { 0, 2, 3 } };
  for (const std::array<std::string, 4>& ids :
    { std::array<std::string, 4>{ "1", "2", "3", "4" }, { "0", "1", "2", "3" }, { "4", "5", "7", "9" },
      { "9", "3", "10", "11" }, { "9223372036854775807", "0", "1", "2" } })
  {
    const std::string triangles = Triangle(ids[0], ids[1], ids[2]) + Triangle(ids[0], ids[2], ids[3]);
    const TSurf surface = LoadOne(Square(FourVertices(ids), triangles));
    CHECK((surface.Triangles == expected));
    CHECK((surface.Vertices.at(2) == std::array<double, 3>{ 1, 1, 0 }));
  }
}

void PartsAreNumbered()
{
  const TSurf surface = LoadOne("GOCAD TSurf 1\nTFACE\n" + FourVertices({ "1", "2", "3", "4" }) +
    Triangle("1", "2", "3") + Triangle("1", "3", "4") + "TFACE\n" + FourVertices({ "5", "6", "7", "8" }) +
    Triangle("5", "6", "7") + "3DFace\nTFACE\nTFACE\n" + Triangle("5", "7", "8") + "END\n");
  CHECK((surface.Parts == std::vector<std::int32_t>{ 0, 0, 1, 3 }));
}

/// Atoms may name vertices of other parts, vertices that come later, and other atoms.
void AtomsStandAtOtherVertices()
{
  const TSurf surface = LoadOne("GOCAD TSurf 1\nPROPERTIES p q\nESIZES 1 2\nTFACE\nATOM 10 3\nPATOM 11 10 7 8 9\n"
                                "PVRTX 1 0 0 0 1 2 3\nTFACE\nPVRTX 3 5 6 7 4 5 6\nATOM 12 11 CNXYZ\nVRTX 4 1 1 1\n"
                                "TRGL 10 11 1\nTRGL 12 4 3\nEND\n");
  CHECK((surface.Vertices == Places{ { 5, 6, 7 }, { 5, 6, 7 }, { 0, 0, 0 }, { 5, 6, 7 }, { 5, 6, 7 }, { 1, 1, 1 } }));
  const std::vector<double>& p = surface.Properties.at(0).Values;
  CHECK((std::vector<double>(p.begin(), p.begin() + 5) == std::vector<double>{ 4, 7, 1, 4, 7 }));
  CHECK(std::isnan(p.at(5)));
  const std::vector<double>& q = surface.Properties.at(1).Values;
  CHECK((std::vector<double>(q.begin(), q.begin() + 10) == std::vector<double>{ 5, 6, 8, 9, 2, 3, 5, 6, 8, 9 }));
  CHECK((surface.Triangles == Triangles{ { 0, 1, 2 }, { 4, 5, 3 } }));
}

void LayoutIsFree()
{
  std::string dos = "\xEF\xBB\xBF# made by hand\n\n" + Small;
  for (std::size_t end = dos.find('\n'); end != std::string::npos; end = dos.find('\n', end + 4))
  {
    dos.replace(end, 1, " \t\r\n");
  }
  for (const std::string& text : { dos, Small.substr(0, Small.size() - 1), Small + "\n \n# the end" })
  {
    const TSurf surface = LoadOne(text);
    CHECK_EQUAL(surface.Name, "my fault: east");
    CHECK(surface.Positive == VerticalPositive::Depth);
    CHECK((surface.Triangles == Triangles{ { 0, 1, 2 } }));
    CHECK_EQUAL(surface.Survey.VerticalUnit, "ms");
  }
}

/// The first bytes, which are looked at before the rest, may end within a word.
void CommentsMayComeFirst()
{
  for (const std::size_t length : { 4000, 4092, 4093, 4094, 4095, 4096, 9000 })
  {
    CHECK_EQUAL(LoadOne('#' + std::string(length - 2, '-') + '\n' + Small).Triangles.size(), 1u);
  }
}

void UnknownLinesAndBlocksAreSkipped()
{
  const TSurf surface = LoadOne("GOCAD TSurf 1\nGEOLOGICAL_TYPE top\nPROPERTY_CLASS_HEADER Z {\nis_z:on\nVRTX x\n}\n"
                                "TFACE\n" +
    FourVertices({ "1", "2", "3", "4" }) +
    "BEGIN_ATOM_REGION_INDICATORS r\nARI 1 0\nEND\nVRTX no\nEND_ATOM_REGION_INDICATORS\n# TRGL 1 1 1\n" +
    "PROPERTY_CN p\nCNP 1\nEND_PROPERTY_CN\nREGION name 1\n" + Triangle("1", "2", "3") + "NAME outside\nEND\n");
  CHECK_EQUAL(surface.Vertices.size(), 4u);
  CHECK((surface.Triangles == Triangles{ { 0, 1, 2 } }));
  CHECK(surface.Survey.CoordinateSystem.empty());
}

const std::string Several = "GOCAD PLine 1\nHEADER {\nname:line\n}\nILINE\nVRTX 1 0 0 0\nSEG 1 1\nEND\n" + Small +
  "GOCAD VSet 1\nVRTX 1 0 0 0\nEND\nGOCAD TSurf 1\nHEADER {name:second}\nTFACE\nVRTX 1 7 8 9\nEND\n";

void ObjectsAreParted()
{
  for (const std::size_t bufferSize : BufferSizes)
  {
    const TSurfList list = List(Several, bufferSize);
    CHECK((list.Names == std::vector<std::string>{ "my fault: east", "second" }));
    CHECK_EQUAL(list.OtherObjects, 2);
    const std::vector<TSurf> surfaces = Load(Several, bufferSize);
    CHECK_EQUAL(surfaces.size(), 2u);
    CHECK((surfaces.at(1).Vertices == Places{ { 7, 8, 9 } }));
    CHECK(surfaces.at(1).Positive == VerticalPositive::Elevation);
  }
}

void SurfacesAreChosen()
{
  std::istringstream stream(Several);
  const std::vector<TSurf> surfaces = LoadTSurfs(stream, [](std::size_t number) { return number == 1; });
  CHECK_EQUAL(surfaces.size(), 1u);
  CHECK_EQUAL(surfaces.at(0).Name, "second");
}

void NumbersKeepAllDigits()
{
  const TSurf surface = LoadOne(Square("VRTX 1 459621.05127000005 5934843.0114750005 -1.6855908203125e+3\n", ""));
  CHECK((surface.Vertices.at(0) == std::array<double, 3>{ 459621.05127000005, 5934843.0114750005, -1685.5908203125 }));
}

void FilesAreRecognisedByTheirFirstLine()
{
  const auto typeOf = [](const std::string& text)
  {
    std::istringstream stream(text);
    const std::optional<std::string> type = FirstTypeOfGOCAD(stream);
    CHECK_EQUAL(stream.tellg(), std::istream::pos_type(0));
    return type;
  };
  CHECK(typeOf(Small) == "tsurf" && typeOf("\xEF\xBB\xBF \n#\n\tGOCAD\tVSet 1\r\n") == "vset" && typeOf("GOCAD") == "");
  CHECK(!typeOf("") && !typeOf("GOCADX\n") && !typeOf("G\x47\n") && !typeOf("import x from 'y'\nGOCAD TSurf 1\n"));
  CHECK(!typeOf(std::string(5000, '\n') + Small));
}

/// As programs write them that know the format by hearsay.
void LinesOfOtherProgramsAreRead()
{
  const std::string body = "TFACE\r\nVRTX 1 0 0 1 0.5 -999 CNXYZ\r\nPVRTX 2 1 0 2 7 8\r\nVRTX 3 0 1 3\r\n"
                           "TRGL 1 2 3\r\nEND \r\n";
  for (const char* const first : { "GOCAD TSurf 1 ", "GOCAD Tsurf 1", "GOCAD TSURF 1", "gocad tsurf 1", "Gocad tSurf" })
  {
    const TSurf surface = LoadOne(std::string(first) +
      "\r\nHEADER{name:\"a b\"}\r\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\r\nAXIS_UNIT m m MS\r\nZPOSITIVE DEPTH\r\n"
      "END_ORIGINAL_COORDINATE_SYSTEM\r\nPROPERTIES p q\r\nNO_DATA_VALUES -999\r\n" +
      body);
    CHECK_EQUAL(surface.Name, "a b");
    CHECK(surface.Positive == VerticalPositive::Depth);
    CHECK_EQUAL(surface.Survey.VerticalUnit, "MS");
    CHECK_EQUAL(surface.Survey.VerticalDomain, "time");
    CHECK_EQUAL(surface.Triangles.size(), 1u);
    CHECK_EQUAL(surface.Properties.size(), 2u);
    CHECK_EQUAL(surface.Properties[0].Values[0], 0.5);
    CHECK(std::isnan(surface.Properties[1].Values[0]) && std::isnan(surface.Properties[1].Values[2]));
    CHECK_EQUAL(surface.Properties[1].Values[1], 8.0);
  }
}

void BracesOfHeadersStandAnywhere()
{
  const auto name = [](const std::string& header) { return LoadOne("GOCAD TSurf 1\n" + header + "\nEND\n").Name; };
  for (const char* const header : { "HEADER {\nname:x\n}", "HEADER {name:x}", "HEADER { name: x }", "HEADER{name:x}",
         "HEADER {name:x\n}", "HEADER {name:x\nmesh:on}", "HEADER {mesh:on\nname: \"x\" }", "HEADER\n{\nname:x\n}" })
  {
    CHECK_EQUAL(name(header), "x");
  }
  CHECK_EQUAL(name("HEADER {\nname:{x}\n}"), "{x}");
}

/// Surfaces within groups, which may be within others, are those of the file.
void GroupsAreOpened()
{
  const auto surface = [](const std::string& name)
  { return "GOCAD TSurf 1\nHEADER {\nname:" + name + "\n}\nVRTX 1 0 0 0\nTRGL 1 1 1\nEND\n"; };
  const std::string text = surface("a") + "GOCAD HomogeneousGroup 1\nHEADER {\nname:g\n}\nTYPE TSurf\nBEGIN_MEMBERS\n" +
    surface("b") + "GOCAD Group 1\nBEGIN_MEMBERS\n" + surface("c") + "END_MEMBERS\nEND\nEND_MEMBERS\nEND\n" +
    surface("d");
  const std::vector<std::string> names = { "a", "b", "c", "d" };
  for (const std::size_t bufferSize : BufferSizes)
  {
    CHECK(List(text, bufferSize).Names == names);
    CHECK_EQUAL(Load(text, bufferSize).size(), 4u);
  }
  CHECK_EQUAL(Load(text)[2].Name, "c");
  CHECK_EQUAL(LoadOne("GOCAD TSurf 1\nBEGIN_MEMBERS\nGOCAD x\nEND_MEMBERS\nEND\n").Triangles.size(), 0u);
}

void WorkIsMonitored()
{
  std::string vertices;
  for (int vertex = 0; vertex < 1000; ++vertex)
  {
    vertices += "VRTX " + std::to_string(vertex) + " 0 0 0\n";
  }
  const std::string text = Square(vertices, "");
  CHECK_EQUAL(MonitorChecker::Check(10,
                [&text](const Monitor& monitor)
                {
                  std::istringstream stream(text);
                  LoadTSurfs(
                    stream, [](std::size_t) { return true; }, monitor, 1024);
                }),
    "");
}
}

int TestTSurfParser(int, char*[])
{
  AllOfASurfaceIsRead();
  SmallLettersAreRead();
  PropertiesHaveSizesAndNulls();
  NullsAreComparedInSinglePrecision();
  PropertiesWithoutValuesAreLeftOut();
  DefaultsAreThoseOfGOCAD();
  HeadersAreFree();
  IdsMayHaveGaps();
  PartsAreNumbered();
  AtomsStandAtOtherVertices();
  LayoutIsFree();
  CommentsMayComeFirst();
  UnknownLinesAndBlocksAreSkipped();
  ObjectsAreParted();
  SurfacesAreChosen();
  NumbersKeepAllDigits();
  FilesAreRecognisedByTheirFirstLine();
  LinesOfOtherProgramsAreRead();
  BracesOfHeadersStandAnywhere();
  GroupsAreOpened();
  WorkIsMonitored();
  return Check::Result();
}
