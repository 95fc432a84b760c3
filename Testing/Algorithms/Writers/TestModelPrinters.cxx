// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sealed models: the faces, lines and corners of a box that a fault and a horizon cut, files byte by byte, and what is not
// closed.

#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Writers/SealedModel/ModelPrinters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Print = void (*)(const ClosedModel&, const ModelTopology&, std::ostream&, const Monitor&);

std::string TextOf(Print print, const ClosedModel& model)
{
  std::ostringstream stream;
  print(model, FindTopology(model), stream, Monitor());
  return stream.str();
}

/// Two tetrahedra with a common base: its three edges are one line without corners.
ClosedModel MakeTwo()
{
  ClosedModel model;
  model.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  model.Surfaces = { { "Sand \"1\"", 0 }, { "Box", 2 }, { "Box", 3 } };
  model.Bodies = { { "Top - Sand", 0, 3 }, { "", 1, 3 } };
  model.Triangles = { { { 0, 1, 2 }, 0, { 0, 1 } }, { { 0, 1, 3 }, 1, { -1, 0 } }, { { 1, 2, 3 }, 1, { -1, 0 } },
    { { 2, 0, 3 }, 1, { -1, 0 } }, { { 1, 0, 4 }, 2, { -1, 1 } }, { { 2, 1, 4 }, 2, { -1, 1 } },
    { { 2, 0, 4 }, 2, { 1, -1 } } }; // the last one the other way round
  return model;
}

using Section = std::array<double, 2>; // x and z

class BoxMaker
{
public:
  /// Horizon at 1 left of the fault, and 0.5 right of it. Bodies: left above 0 and below 1, right above 2 and below 3.
  ClosedModel Make()
  {
    this->Model.Surfaces = { { "Top", 3 }, { "Base", 3 }, { "Sand", 0 }, { "F", 1 }, { "West", 2 }, { "East", 2 },
      { "South", 2 }, { "North", 2 } };
    this->Model.Bodies = { { "above", 0, 0 }, { "below", 1, 0 }, { "above", 0, 1 }, { "below", 1, 1 } };
    this->AddStrip({ 0, 2 }, { 1, 2 }, 0, -1, 0);
    this->AddStrip({ 1, 2 }, { 2, 2 }, 0, -1, 2);
    this->AddStrip({ 0, 0 }, { 1, 0 }, 1, 1, -1);
    this->AddStrip({ 1, 0 }, { 2, 0 }, 1, 3, -1);
    this->AddStrip({ 0, 1 }, { 1, 1 }, 2, 0, 1);
    this->AddStrip({ 1, 0.5 }, { 2, 0.5 }, 2, 2, 3);
    this->AddStrip({ 1, 0 }, { 1, 0.5 }, 3, 1, 3);
    this->AddStrip({ 1, 0.5 }, { 1, 1 }, 3, 1, 2);
    this->AddStrip({ 1, 1 }, { 1, 2 }, 3, 0, 2);
    this->AddStrip({ 0, 0 }, { 0, 1 }, 4, -1, 1);
    this->AddStrip({ 0, 1 }, { 0, 2 }, 4, -1, 0);
    this->AddStrip({ 2, 0 }, { 2, 0.5 }, 5, 3, -1);
    this->AddStrip({ 2, 0.5 }, { 2, 2 }, 5, 2, -1);
    this->AddEnds({ { 0, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } }, 0);
    this->AddEnds({ { 0, 1 }, { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 1, 1 } }, 1);
    this->AddEnds({ { 2, 2 }, { 1, 2 }, { 1, 1 }, { 1, 0.5 }, { 2, 0.5 } }, 2);
    this->AddEnds({ { 1, 0 }, { 2, 0 }, { 2, 0.5 }, { 1, 0.5 } }, 3);
    return this->Model;
  }

private:
  PointId PointAt(const Section& place, double y)
  {
    const auto [found, isNew] =
      this->Numbers.try_emplace({ place[0], y, place[1] }, PointId(this->Model.Points.size()));
    if (isNew)
    {
      this->Model.Points.push_back(found->first);
    }
    return found->second;
  }

  /// From the south to the north. The left hand side of the direction in the section is above.
  void AddStrip(const Section& from, const Section& to, std::size_t surface, int above, int below)
  {
    const std::array<PointId, 4> corners = { this->PointAt(from, 0), this->PointAt(to, 0), this->PointAt(to, 1),
      this->PointAt(from, 1) };
    this->Model.Triangles.push_back({ { corners[0], corners[1], corners[2] }, surface, { above, below } });
    this->Model.Triangles.push_back({ { corners[0], corners[2], corners[3] }, surface, { above, below } });
  }

  /// A fan. Counter-clockwise in the section is seen from the south.
  void AddEnds(const std::vector<Section>& ring, int body)
  {
    for (std::size_t n = 1; n + 1 < ring.size(); ++n)
    {
      for (const int y : { 0, 1 })
      {
        const TSurf::Triangle corners = { this->PointAt(ring[0], y), this->PointAt(ring[n], y),
          this->PointAt(ring[n + 1], y) };
        this->Model.Triangles.push_back({ corners, std::size_t(6 + y), { y == 0 ? -1 : body, y == 0 ? body : -1 } });
      }
    }
  }

  ClosedModel Model;
  std::map<std::array<double, 3>, PointId> Numbers;
};

/// Turns every third triangle.
ClosedModel TurnSome(ClosedModel model)
{
  for (std::size_t n = 0; n < model.Triangles.size(); n += 3)
  {
    std::swap(model.Triangles[n].Corners[0], model.Triangles[n].Corners[1]);
    std::swap(model.Triangles[n].Bodies[0], model.Triangles[n].Bodies[1]);
  }
  return model;
}

std::size_t CountLines(const std::string& text, const std::string& word)
{
  std::size_t count = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    count += line == word || line.substr(0, word.size() + 1) == word + ' ';
  }
  return count;
}

void BoxHasFacesLinesAndCorners()
{
  for (const ClosedModel& model : { BoxMaker().Make(), TurnSome(BoxMaker().Make()) })
  {
    const ModelTopology topology = FindTopology(model);
    CHECK_EQUAL(model.Points.size(), 20U);
    CHECK_EQUAL(model.Triangles.size(), 46U);
    CHECK_EQUAL(topology.Faces.size(), 21U);
    CHECK_EQUAL(topology.Lines.size(), 36U);
    CHECK_EQUAL(topology.Corners.size(), 20U);
    CHECK_EQUAL(std::count(topology.AreLines.begin(), topology.AreLines.end(), 1), 88);
    std::size_t sides = 0;
    for (const ModelTopology::Line& line : topology.Lines)
    {
      CHECK_EQUAL(line.Points.size(), 2U);
      CHECK(line.Faces.size() == 2 || line.Faces.size() == 3);
      sides += line.Faces.size();
    }
    CHECK_EQUAL(sides, 88U);
    const std::set<std::int32_t> vertices(topology.Vertices.begin(), topology.Vertices.end());
    CHECK_EQUAL(vertices.size(), 88U); // 17 faces with four corners and 4 with five
    const std::string text = TextOf(PrintModel3d, model);
    const std::vector<std::pair<std::string, std::size_t>> counts = { { "TSURF", 8 }, { "TFACE", 42 }, { "REGION", 5 },
      { "LAYER", 2 }, { "FAULT_BLOCK", 2 }, { "GOCAD", 9 }, { "VRTX", 88 }, { "TRGL", 46 }, { "BSTONE", 88 },
      { "BORDER", 88 }, { "END", 9 } };
    for (const auto& [word, count] : counts)
    {
      CHECK_EQUAL(word + ' ' + std::to_string(CountLines(text, word)), word + ' ' + std::to_string(count));
    }
    CHECK(text.find("TFACE 7 fault F\n") != std::string::npos);
    CHECK(text.find("LAYER layer_1\n  24  26  0\nFAULT_BLOCK block_0\n  23  24  0\n") != std::string::npos);
  }
  const std::string text = TextOf(PrintModel3d, BoxMaker().Make());
  CHECK(text.find("REGION 25 above_2\n  -2  +6  -8  -9  +13\n  -16  +20  0\n") != std::string::npos);
}

void SolidsHaveTheirVolumes()
{
  const std::string text = TextOf(PrintModelSTL, TurnSome(BoxMaker().Make()));
  std::vector<double> volumes;
  std::vector<double> numbers; // of the triangle
  std::istringstream stream(text);
  for (std::string word; stream >> word;)
  {
    if (word == "solid")
    {
      volumes.push_back(0.0);
    }
    else if (word == "vertex")
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        stream >> numbers.emplace_back();
      }
    }
    else if (word == "endloop")
    {
      const std::vector<double>& p = numbers;
      volumes.back() +=
        (p[0] * (p[4] * p[8] - p[5] * p[7]) + p[1] * (p[5] * p[6] - p[3] * p[8]) + p[2] * (p[3] * p[7] - p[4] * p[6])) /
        6.0;
      numbers.clear();
    }
  }
  const std::vector<double> expected = { 1.0, 1.0, 1.5, 0.5 };
  CHECK_EQUAL(volumes.size(), expected.size());
  for (std::size_t n = 0; n < std::min(volumes.size(), expected.size()); ++n)
  {
    CHECK(std::abs(volumes[n] - expected[n]) < 1e-12);
  }
  CHECK_EQUAL(CountLines(text, "solid above"), 2U);
}

void FilesAreAsTheyWere()
{
  const std::string system =
    "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\n"
    "AXIS_UNIT \"none\" \"none\" \"none\"\nZPOSITIVE Elevation\nEND_ORIGINAL_COORDINATE_SYSTEM\n";
  CHECK_EQUAL(TextOf(PrintModel3d, MakeTwo()),
    "GOCAD Model3d 1\nHEADER {\nname:SealedModel\n}\n" + system +
      "TSURF Sand__1_\nTSURF Box\nTSURF Box_2\nTFACE 1 top Sand__1_\n  0 0 0\n  1 0 0\n  0 1 0\n"
      "TFACE 2 boundary Box\n  0 0 0\n  1 0 0\n  0 0 1\nTFACE 3 boundary Box_2\n  1 0 0\n  0 0 0\n  0 0 -1\n"
      "REGION 4 Universe\n  +2  +3  0\nREGION 5 Top_-_Sand\n  +1  -2  0\nREGION 6 _\n  -1  -3  0\nLAYER layer_0\n"
      "  5  0\nLAYER layer_1\n  6  0\nFAULT_BLOCK block_3\n  5  6  0\nEND\nGOCAD TSurf 1\nHEADER {\nname:Sand__1_\n"
      "}\n" +
      system +
      "GEOLOGICAL_FEATURE Sand__1_\nGEOLOGICAL_TYPE top\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\n"
      "TRGL 1 2 3\nBSTONE 1\nBSTONE 2\nBSTONE 3\nBORDER 4 1 2\nBORDER 5 2 3\nBORDER 6 3 1\nEND\nGOCAD TSurf 1\n"
      "HEADER {\nname:Box\n}\n" +
      system +
      "GEOLOGICAL_FEATURE Box\nGEOLOGICAL_TYPE boundary\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 0 1\n"
      "VRTX 4 0 1 0\nTRGL 1 2 3\nTRGL 2 4 3\nTRGL 4 1 3\nBSTONE 1\nBSTONE 2\nBSTONE 4\nBORDER 5 1 2\nBORDER 6 2 4\n"
      "BORDER 7 4 1\nEND\nGOCAD TSurf 1\nHEADER {\nname:Box_2\n}\n" +
      system +
      "GEOLOGICAL_FEATURE Box_2\nGEOLOGICAL_TYPE boundary\nTFACE\nVRTX 1 1 0 0\nVRTX 2 0 0 0\nVRTX 3 0 0 -1\n"
      "VRTX 4 0 1 0\nTRGL 1 2 3\nTRGL 4 1 3\nTRGL 4 3 2\nBSTONE 1\nBSTONE 2\nBSTONE 4\nBORDER 5 1 2\nBORDER 6 4 1\n"
      "BORDER 7 2 4\nEND\n");
  CHECK_EQUAL(TextOf(PrintModelGmsh, MakeTwo()),
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n2 1 \"Sand _1_\"\n2 2 \"Box\"\n2 3 \"Box_2\"\n"
    "3 1 \"Top - Sand\"\n3 2 \"_\"\n$EndPhysicalNames\n$Entities\n3 3 3 2\n1 0 0 0 0\n2 1 0 0 0\n3 0 1 0 0\n"
    "1 0 0 -1 1 1 1 0 2 1 -2\n2 0 0 -1 1 1 1 0 2 2 -3\n3 0 0 -1 1 1 1 0 2 3 -1\n1 0 0 -1 1 1 1 1 1 3 1 2 3\n"
    "2 0 0 -1 1 1 1 1 2 3 1 2 3\n3 0 0 -1 1 1 1 1 3 3 -1 -2 -3\n1 0 0 -1 1 1 1 1 1 2 -1 2\n"
    "2 0 0 -1 1 1 1 1 2 2 1 3\n$EndEntities\n$Nodes\n5 5 1 5\n0 1 0 1\n1\n0 0 0\n0 2 0 1\n2\n1 0 0\n0 3 0 1\n3\n"
    "0 1 0\n2 2 0 1\n4\n0 0 1\n2 3 0 1\n5\n0 0 -1\n$EndNodes\n$Elements\n"
    "6 10 1 10\n1 1 1 1\n1 1 2\n1 2 1 1\n2 2 3\n1 3 1 1\n3 3 1\n2 1 2 1\n4 1 2 3\n2 2 2 3\n5 1 2 4\n6 2 3 4\n"
    "7 3 1 4\n2 3 2 3\n8 2 1 5\n9 3 2 5\n10 3 5 1\n$EndElements\n");
}

/// Two tetrahedra as those of MakeTwo, and a third one on their common base, which it touches along two edges.
ClosedModel MakeKeel()
{
  ClosedModel model;
  model.Points = { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 0, 0, 9 }, { 0, 0, -9 }, { 2, 2, 0 }, { 3, 2, 0 },
    { 2, 3, 1 }, { 2, 1.5, 1 }, { 2.5, 2, 0 } };
  model.Surfaces = { { "Sand", 0 }, { "Up", 2 }, { "Low", 2 }, { "Keel", 1 } };
  model.Bodies = { { "A", 0, 0 }, { "B", 1, 0 }, { "C", 0, 1 } };
  const auto add = [&](std::size_t surface, std::array<int, 2> bodies, const std::vector<TSurf::Triangle>& triangles)
  {
    for (const TSurf::Triangle& triangle : triangles)
    {
      model.Triangles.push_back({ triangle, surface, bodies });
    }
  };
  add(0, { 0, 1 }, { { 0, 1, 6 }, { 0, 6, 9 }, { 0, 9, 5 }, { 0, 5, 2 }, { 1, 2, 6 }, { 2, 5, 9 }, { 2, 9, 6 } });
  add(1, { -1, 0 }, { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  add(2, { -1, 1 }, { { 1, 0, 4 }, { 2, 1, 4 }, { 0, 2, 4 } });
  add(3, { 0, 2 }, { { 5, 7, 9 }, { 9, 7, 6 }, { 5, 9, 8 }, { 9, 6, 8 }, { 5, 8, 7 }, { 6, 7, 8 } });
  return model;
}

/// Faces at both sides of a line have two vertices at each of its points but the ends.
void FacesArePartedAtLines()
{
  const ModelTopology topology = FindTopology(MakeKeel());
  CHECK_EQUAL(topology.Faces.size(), 4U);
  CHECK_EQUAL(topology.Lines.size(), 4U);
  CHECK_EQUAL(topology.Corners.size(), 5U);
  CHECK(topology.Lines[0].Points == (std::vector<PointId>{ 5, 9, 6 }));
  std::map<std::pair<std::size_t, bool>, int> sides;
  for (const auto& side : topology.Lines[0].Faces)
  {
    ++sides[side];
  }
  CHECK(sides ==
    (std::map<std::pair<std::size_t, bool>, int>{
      { { 0, false }, 1 }, { { 0, true }, 1 }, { { 3, false }, 1 }, { { 3, true }, 1 } }));
  const std::set<std::int32_t> vertices(topology.Vertices.begin(), topology.Vertices.end());
  CHECK_EQUAL(vertices.size(), 7U + 4U + 4U + 6U);
}

void OpenModelsAreRefused()
{
  const auto check = [](auto&& change, const std::string& message)
  {
    ClosedModel model = MakeTwo();
    change(model);
    CHECK_THROWS_WITH(FindTopology(model), message);
  };
  check([](ClosedModel& model) { model.Points[4][2] = HUGE_VAL; }, "coordinate inf of point 4, expected a finite");
  check([](ClosedModel& model) { model.Triangles[2].Corners[1] = 5; },
    "triangle 2 with point id 5, expected three different ones from 0 to 4");
  check([](ClosedModel& model) { model.Triangles[2].Corners[1] = 1; }, "triangle 2 with point id 1, expected three");
  check([](ClosedModel& model) { model.Triangles[6].Bodies[0] = 2; }, "body 2 at triangle 6, expected -1 to 1");
  check([](ClosedModel& model) { model.Triangles[6].Bodies[1] = -2; }, "body -2 at triangle 6, expected -1 to 1");
  check([](ClosedModel& model) { model.Triangles[0].Bodies[1] = 0; }, "body 0 on both sides of triangle 0, expected");
  check([](ClosedModel& model) { model.Bodies.push_back({}); }, "body 2 without triangles, expected surfaces around");
  check([](ClosedModel& model) { model.Triangles.pop_back(); },
    "body 1 open at an edge with number of triangles 2 at (0, 0) and 0, expected closed bodies");
  check(
    [](ClosedModel& model)
    {
      model.Points.push_back({ 0, 0, 1 });
      model.Triangles[1].Corners[2] = 5;
    },
    "body 0 open at an edge with number of triangles 1 at (0, 0) and 0, expected closed");
  check([](ClosedModel& model) { std::swap(model.Triangles[0].Bodies[0], model.Triangles[0].Bodies[1]); },
    "body 1 open at an edge with number of triangles 3 at");
}

void WorkIsMonitored()
{
  const ClosedModel model = BoxMaker().Make();
  for (const Print print : { PrintModel3d, PrintModelGmsh, PrintModelSTL })
  {
    CHECK_EQUAL(MonitorChecker::Check(8,
                  [&](const Monitor& monitor)
                  {
                    std::ostringstream stream;
                    print(model, FindTopology(model, monitor.Step(0.0, 0.5)), stream, monitor.Step(0.5, 1.0));
                  }),
      "");
  }
}
}

int TestModelPrinters(int, char*[])
{
  BoxHasFacesLinesAndCorners();
  SolidsHaveTheirVolumes();
  FilesAreAsTheyWere();
  FacesArePartedAtLines();
  OpenModelsAreRefused();
  WorkIsMonitored();
  return Check::Result();
}
