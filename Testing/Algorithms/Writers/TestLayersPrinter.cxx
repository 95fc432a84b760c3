// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Layers for simulators and meshers: small ones byte by byte, and their volumes in the order of corners of each format.

#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Writers/HorizonLayers/LayersPrinter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Print = void (*)(const VolumeCells&, std::ostream&, const Monitor&);

std::string TextOf(Print print, const VolumeCells& cells)
{
  std::ostringstream stream;
  print(cells, stream, Monitor());
  return stream.str();
}

/// A wedge, a pyramid and a tetrahedron over one triangle of area 6, of the volumes 18, 12 and 12.
VolumeCells MakeThree()
{
  VolumeCells cells;
  cells.Points = { { 0, 0, 12 }, { 4, 0, 12 }, { 0, 3, 12 }, { 0, 0, 9 }, { 4, 0, 9 }, { 0, 3, 9 }, { 0, 0, 6 },
    { 4, 0, 6 }, { 0, 0, 0 } };
  cells.Corners = { 0, 1, 2, 3, 4, 5, /* */ 3, 4, 7, 6, 5, /* */ 6, 5, 7, 8 };
  cells.Ends = { 6, 11, 15 };
  cells.Layers = { 0, 1, 2 };
  cells.Sublayers = { 0, 0, 0 };
  cells.FaultFaces = { 1 << 3, 1 << 2, 0 };
  cells.Triangles = { 7, 7, 7 };
  cells.Names = { "Top to \"B\"", "B to C", "C to Base" };
  cells.Horizons = { "Top", "\"B\"", "C", "Base" };
  return cells;
}

/// Adds a wedge with level top and base over the triangle of that number.
void AddWedge(std::int64_t triangle, int layer, double top, double base, VolumeCells& cells)
{
  const auto first = std::int64_t(cells.Points.size());
  const double x = 10.0 * double(triangle);
  for (const double z : { top, base })
  {
    cells.Points.push_back({ x, 0.0, z });
    cells.Points.push_back({ x + 4.0, 0.0, z });
    cells.Points.push_back({ x, 3.0, z });
  }
  for (std::int64_t n = 0; n < 6; ++n)
  {
    cells.Corners.push_back(first + n);
  }
  cells.Ends.push_back(std::int64_t(cells.Corners.size()));
  cells.Layers.push_back(layer);
  cells.Sublayers.push_back(0);
  cells.FaultFaces.push_back(0);
  cells.Triangles.push_back(triangle);
}

std::vector<double> NumbersOf(std::string line)
{
  for (char& c : line)
  {
    c = c == ',' ? ' ' : c;
  }
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

/// The volume where corners are in the order of Gmsh and Abaqus, of three tetrahedra at most.
double VolumeOf(const VolumeCells& cells, const std::vector<double>& line)
{
  const auto at = [&](std::size_t n) { return cells.Points[std::size_t(line[n + 1]) - 1]; };
  const auto volume = [&](std::array<std::size_t, 4> corners)
  {
    std::array<std::array<double, 3>, 3> e;
    for (std::size_t n = 0; n < 3; ++n)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        e[n][axis] = at(corners[n + 1])[axis] - at(corners[0])[axis];
      }
    }
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
             e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
      6.0;
  };
  switch (line.size() - 1)
  {
    case 4:
      return volume({ 0, 1, 2, 3 });
    case 5:
      return volume({ 0, 1, 2, 4 }) + volume({ 0, 2, 3, 4 });
    default:
      return volume({ 0, 1, 2, 3 }) + volume({ 1, 2, 3, 4 }) + volume({ 2, 3, 4, 5 });
  }
}

/// Checks the volumes of cells, which are on lines that begin with one of these texts.
void CheckVolumes(const VolumeCells& cells, const std::string& text, const std::array<std::string, 3>& lines)
{
  constexpr std::array<double, 3> volumes = { 18.0, 12.0, 12.0 };
  for (std::size_t n = 0; n < lines.size(); ++n)
  {
    const std::size_t place = text.find('\n' + lines[n]);
    if (CHECK(place != std::string::npos))
    {
      const std::string line = text.substr(place + 1, text.find('\n', place + 1) - place - 1);
      CHECK_EQUAL(VolumeOf(cells, NumbersOf(line)), volumes[n]);
    }
  }
}

void GmshHasThem()
{
  const VolumeCells cells = MakeThree();
  const std::string text = TextOf(PrintGmsh, cells);
  CHECK_EQUAL(text,
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n9\n2 1 \"Top\"\n2 2 \"Base\"\n2 3 \"Sides\"\n2 4 \"Faults\"\n2 5 \"_B_\"\n2 6 \"C\"\n"
    "3 1 \"Top to _B_\"\n3 2 \"B to C\"\n3 3 \"C to Base\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 9 3\n1 0 0 0 4 3 12 1 1 0\n2 0 0 0 4 3 12 1 2 0\n3 0 0 0 4 3 12 1 3 0\n4 0 0 0 4 3 12 1 3 0\n"
    "5 0 0 0 4 3 12 1 3 0\n6 0 0 0 4 3 12 1 4 0\n7 0 0 0 4 3 12 1 4 0\n8 0 0 0 4 3 12 1 5 0\n9 0 0 0 4 3 12 1 6 0\n"
    "1 0 0 0 4 3 12 1 1 4 1 3 6 8\n2 0 0 0 4 3 12 1 2 4 4 7 -8 9\n3 0 0 0 4 3 12 1 3 3 2 5 -9\n$EndEntities\n"
    "$Nodes\n1 9 1 9\n3 1 0 9\n1\n2\n3\n4\n5\n6\n7\n8\n9\n"
    "0 0 12\n4 0 12\n0 3 12\n0 0 9\n4 0 9\n0 3 9\n0 0 6\n4 0 6\n0 0 0\n$EndNodes\n"
    "$Elements\n13 15 1 15\n3 1 6 1\n1 4 5 6 1 2 3\n3 2 7 1\n2 4 5 8 7 6\n3 3 4 1\n3 7 6 8 9\n"
    "2 1 2 1\n4 1 2 3\n2 2 2 1\n5 6 8 9\n2 3 3 2\n6 1 4 5 2\n7 3 6 4 1\n2 4 2 1\n8 7 4 6\n2 4 3 1\n9 4 7 8 5\n"
    "2 5 2 2\n10 7 6 9\n11 8 7 9\n2 6 3 1\n12 2 5 6 3\n2 7 2 1\n13 5 8 6\n2 8 2 1\n14 4 6 5\n2 9 2 1\n15 8 7 6\n"
    "$EndElements\n");
  CheckVolumes(cells, text, { "1 4 5", "2 4 5 8", "3 7 6" });
}

void AbaqusHasThem()
{
  const VolumeCells cells = MakeThree();
  const std::string text = TextOf(PrintAbaqus, cells);
  CHECK_EQUAL(text,
    "*HEADING\nLayers between seismic horizons\n"
    "*NODE\n1, 0, 0, 12\n2, 4, 0, 12\n3, 0, 3, 12\n4, 0, 0, 9\n5, 4, 0, 9\n6, 0, 3, 9\n7, 0, 0, 6\n8, 4, 0, 6\n"
    "9, 0, 0, 0\n"
    "*ELEMENT, TYPE=C3D6, ELSET=L1_Top_to__B_\n1, 4, 5, 6, 1, 2, 3\n"
    "*ELEMENT, TYPE=C3D6, ELSET=L2_B_to_C\n2, 6, 5, 4, 6, 8, 7\n"
    "*ELEMENT, TYPE=C3D4, ELSET=L3_C_to_Base\n3, 7, 6, 8, 9\n"
    "*SURFACE, NAME=Top, TYPE=ELEMENT\n1, S2\n*SURFACE, NAME=Base, TYPE=ELEMENT\n3, S3\n"
    "*SURFACE, NAME=Sides, TYPE=ELEMENT\n1, S3\n1, S5\n2, S4\n2, S5\n3, S2\n3, S4\n"
    "*SURFACE, NAME=Faults, TYPE=ELEMENT\n1, S4\n2, S3\n*SURFACE, NAME=H2__B_, TYPE=ELEMENT\n1, S1\n"
    "*SURFACE, NAME=H3_C, TYPE=ELEMENT\n2, S2\n");
  CheckVolumes(cells, text, { "1, 4, 5", "2, 6, 5", "3, 7, 6" });
}

/// The quadrangle of a pyramid begins at any of its corners, and has one or the other edge upright.
void PyramidsMayBeginAnywhere()
{
  VolumeCells cells = MakeThree();
  for (int turn = 0; turn < 4; ++turn)
  {
    CheckVolumes(cells, TextOf(PrintAbaqus, cells), { "1, 4, 5", "2, 6, ", "3, 7, 6" });
    const auto first = cells.Corners.begin() + 6;
    std::rotate(first, first + 1, first + 4);
  }
}

void ModflowHasThem()
{
  VolumeCells cells = MakeThree();
  cells.LengthUnit = "METERS";
  const std::string text = TextOf(PrintDISV, cells);
  CHECK_EQUAL(text,
    "# layer 1: Top to _B_\n# layer 2: B to C\n# layer 3: C to Base\n"
    "BEGIN OPTIONS\n  LENGTH_UNITS METERS\nEND OPTIONS\n\n"
    "BEGIN DIMENSIONS\n  NLAY 3\n  NCPL 1\n  NVERT 3\nEND DIMENSIONS\n\n"
    "BEGIN GRIDDATA\n  TOP\n    INTERNAL FACTOR 1\n      12\n"
    "  BOTM LAYERED\n    INTERNAL FACTOR 1\n      9\n    INTERNAL FACTOR 1\n      7\n    INTERNAL FACTOR 1\n      5\n"
    "  IDOMAIN LAYERED\n    INTERNAL FACTOR 1\n      1\n    INTERNAL FACTOR 1\n      1\n    INTERNAL FACTOR 1\n      "
    "1\n"
    "END GRIDDATA\n\n"
    "BEGIN VERTICES\n  1 0 0\n  2 0 3\n  3 4 0\nEND VERTICES\n\n"
    "BEGIN CELL2D\n  1 1.3333333333333333 1 3 1 2 3\nEND CELL2D\n");
  cells.LengthUnit.clear();
  CHECK(TextOf(PrintDISV, cells).find("BEGIN OPTIONS\nEND OPTIONS\n") != std::string::npos);
}

/// Rows are layers: where cells are in a column of level ones, and what MODFLOW gets of them.
struct Column
{
  std::array<std::pair<double, double>, 4> Cells; // top and base; equal where there is none
  double Top;
  std::array<double, 4> Bases;
  std::array<double, 4> Domain;
};

const std::vector<Column> Columns = {
  { { { { 9, 8 }, { 8, 6 }, { 6, 5 }, { 5, 1 } } }, 9, { 8, 6, 5, 1 }, { 1, 1, 1, 1 } },
  { { { { 9, 8 }, {}, { 8, 5 }, { 5, 1 } } }, 9, { 8, 8, 5, 1 }, { 1, -1, 1, 1 } },
  { { { { 9, 8 }, {}, {}, { 8, 1 } } }, 9, { 8, 8, 8, 1 }, { 1, -1, -1, 1 } },
  { { { { 9, 8 }, {}, { 6, 5 }, { 5, 1 } } }, 9, { 8, 6, 5, 1 }, { 1, 0, 1, 1 } }, // not there: a gap
  { { { { 9, 8 }, {}, {}, { 5, 1 } } }, 9, { 8, 8, 5, 1 }, { 1, 0, 0, 1 } },
  { { { {}, { 8, 6 }, { 6, 5 }, { 5, 1 } } }, 8, { 8, 6, 5, 1 }, { 0, 1, 1, 1 } }, // no thickness on top
  { { { {}, {}, { 6, 5 }, { 5, 1 } } }, 6, { 6, 6, 5, 1 }, { 0, 0, 1, 1 } },
  { { { { 9, 8 }, { 8, 6 }, {}, {} } }, 9, { 8, 6, 6, 6 }, { 1, 1, 0, 0 } }, // nor below the last one
  { { { {}, { 8, 6 }, {}, { 6, 1 } } }, 8, { 8, 6, 6, 1 }, { 0, 1, -1, 1 } },
  { { { { 9, 8 }, {}, { 8, 5 }, {} } }, 9, { 8, 8, 5, 5 }, { 1, -1, 1, 0 } },
  { { { {}, {}, {}, { 5, 1 } } }, 5, { 5, 5, 5, 1 }, { 0, 0, 0, 1 } },
};

void MissingCellsArePassedOrInactive()
{
  VolumeCells cells;
  cells.Names = { "A", "B", "C", "D" };
  for (std::size_t layer = 4; layer-- > 0;) // in any order
  {
    for (std::size_t column = 0; column < Columns.size(); ++column)
    {
      const auto [top, base] = Columns[column].Cells[layer];
      if (top > base)
      {
        AddWedge(std::int64_t(column), int(layer), top, base, cells);
      }
    }
  }
  std::vector<std::vector<double>> arrays; // top, bases, domain
  std::istringstream stream(TextOf(PrintDISV, cells));
  for (std::string line; std::getline(stream, line);)
  {
    if (line == "    INTERNAL FACTOR 1")
    {
      arrays.emplace_back();
    }
    else if (line.substr(0, 6) == "      ")
    {
      const std::vector<double> more = NumbersOf(line);
      CHECK(more.size() <= 10);
      arrays.back().insert(arrays.back().end(), more.begin(), more.end());
    }
  }
  if (!CHECK_EQUAL(arrays.size(), 9U))
  {
    return;
  }
  for (std::size_t column = 0; column < Columns.size(); ++column)
  {
    // A mean of three equal heights is not rounded back to them.
    const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-14; };
    CHECK(isNear(arrays[0][column], Columns[column].Top));
    for (std::size_t layer = 0; layer < 4; ++layer)
    {
      CHECK(isNear(arrays[1 + layer][column], Columns[column].Bases[layer]));
      CHECK_EQUAL(arrays[5 + layer][column], Columns[column].Domain[layer]);
    }
  }
}

void WrongCellsAreRefused()
{
  const auto check = [](auto&& change, const std::string& message)
  {
    VolumeCells cells = MakeThree();
    change(cells);
    CHECK_THROWS_WITH(CheckCells(cells), message);
  };
  CheckCells(MakeThree());
  check([](VolumeCells& cells) { cells = {}; }, "no cells, expected layers as Horizon Layers makes them");
  check([](VolumeCells& cells) { cells.Points[4][1] = std::nan(""); }, "coordinate nan of point 4, expected a finite");
  check([](VolumeCells& cells) { cells.Points[8][2] = HUGE_VAL; }, "coordinate inf of point 8, expected a finite");
  check([](VolumeCells& cells) { cells.Layers[1] = 3; }, "layer 3 of cell 1, expected 0 to 2");
  check([](VolumeCells& cells) { cells.Layers[2] = -1; }, "layer -1 of cell 2, expected 0 to 2");
  check([](VolumeCells& cells) { cells.Corners[7] = 9; }, "point id 9 in cell 1, expected 0 to 8");
  check([](VolumeCells& cells) { cells.Corners[0] = -1; }, "point id -1 in cell 0, expected 0 to 8");
}

void WrongColumnsAreRefused()
{
  const auto check = [](auto&& change, const std::string& message)
  {
    VolumeCells cells = MakeThree();
    change(cells);
    CHECK_THROWS_WITH(TextOf(PrintDISV, cells), message);
  };
  check([](VolumeCells& cells) { cells.Points[0][0] = 0.5; }, "cell 0, whose sides are not vertical, expected layers");
  check(
    [](VolumeCells& cells)
    {
      cells.Corners[6] = 0;
      cells.Corners[14] = 0;
      cells.Corners[11] = 3;
      cells.Layers[2] = 1;
    },
    "cells of triangle 7 that are not above each other, expected layers");
  check(
    [](VolumeCells& cells) { AddWedge(7, 1, 2.0, 1.0, cells); }, "cells of triangle 7 that are not above each other");
}

void WorkIsMonitored()
{
  VolumeCells cells;
  cells.Names = { "A" };
  for (std::int64_t triangle = 0; triangle < 20000; ++triangle)
  {
    AddWedge(triangle, 0, 3.0, 0.0, cells);
  }
  for (const Print print : { PrintGmsh, PrintAbaqus, PrintDISV })
  {
    CHECK_EQUAL(MonitorChecker::Check(10,
                  [&](const Monitor& monitor)
                  {
                    std::ostringstream stream;
                    print(cells, stream, monitor);
                  }),
      "");
  }
}
}

int TestLayersPrinter(int, char*[])
{
  GmshHasThem();
  AbaqusHasThem();
  PyramidsMayBeginAnywhere();
  ModflowHasThem();
  MissingCellsArePassedOrInactive();
  WrongCellsAreRefused();
  WrongColumnsAreRefused();
  WorkIsMonitored();
  return Check::Result();
}
