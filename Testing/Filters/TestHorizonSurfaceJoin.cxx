// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes of parts of a horizon, joined: attributes, figures, surveys that are turned or mirrored, errors.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkHorizonSurface.h"
#include "vtkHorizonSurfaceJoin.h"
#include "vtkIdList.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace HorizonFixtures;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

constexpr int Width = 60;
constexpr int Height = 48;
constexpr double Error = 0.75;
const std::vector<int> Cuts = { 11, 12, 30 };

double Wavy(int i, int j)
{
  return std::round(20.0 + 6.0 * std::sin(0.2 * i) * std::cos(0.17 * j));
}

/// With a hole, single missing points, a bay and a small patch, all of them on cuts, and holes beside a cut.
std::vector<std::string> Picture()
{
  std::vector<std::string> rows = Rectangle(Width, Height);
  for (int j = 0; j < Height; ++j)
  {
    std::string& row = rows[std::size_t(Height - 1 - j)];
    if (j > 24 && j < 36)
    {
      row.replace(20, 9, 9, '.');
    }
    if (j > 30 && j < 37)
    {
      row.replace(33, 5, 5, '.');
      row.replace(43, 6, 6, '.');
      row.replace(5, 6, 6, '.');
    }
    if (j > 5 && j < 20)
    {
      row.replace(48, 12, 12, '.');
    }
    row[std::size_t((7 * j) % 15 + 2)] = '.';
  }
  for (const int j : { 12, 13 })
  {
    rows[std::size_t(Height - 1 - j)][55] = '#';
  }
  return rows;
}

Data MakeRows(int first, int last, vtkMatrix4x4* survey)
{
  std::vector<std::string> rows = Picture();
  for (int j = 0; j < Height; ++j)
  {
    if (j < first || j > last)
    {
      rows[std::size_t(Height - 1 - j)].assign(Width, '.');
    }
  }
  return FromPicture(rows, 3, survey, Wavy);
}

/// Of parts: with these seams.
Data MakeMesh(vtkPolyData* points, int lower = -1, int upper = -1, int radius = 1, double error = Error)
{
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputData(points);
  surface->SetMaximumError(error);
  surface->AutomaticRadiusOff();
  surface->SetRadius(radius);
  surface->FitHeightsOff();
  surface->SetSeamRows(lower, upper);
  surface->Update();
  Data mesh;
  mesh = surface->GetPolyDataOutput();
  return mesh;
}

std::vector<Data> MakeParts(vtkMatrix4x4* survey)
{
  std::vector<Data> parts;
  int lower = -1;
  for (std::size_t n = 0; n <= Cuts.size(); ++n)
  {
    const int upper = n < Cuts.size() ? Cuts[n] : -1;
    parts.push_back(MakeMesh(MakeRows(std::max(lower, 0), upper < 0 ? Height : upper, survey), lower, upper));
    lower = upper;
  }
  return parts;
}

/// Empty after an error, of which `text` is a part.
Data Join(const std::vector<Data>& parts, int minimumPatchSize = 1, const std::string& text = std::string())
{
  vtkNew<vtkHorizonSurfaceJoin> join;
  Errors errors(join);
  for (const Data& part : parts)
  {
    join->AddInputData(part);
  }
  join->SetMinimumPatchSize(minimumPatchSize);
  join->Update();
  if (!CHECK(text.empty() ? errors.Count() == 0 : errors.Count() == 1 && errors.FirstContains(text)))
  {
    std::cerr << "found: " << errors.First() << ", expected: " << text << '\n';
  }
  CHECK(text.empty() || join->GetOutput()->GetNumberOfPoints() == 0);
  Data mesh;
  mesh = join->GetOutput();
  return mesh;
}

double Figure(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* const array = mesh->GetFieldData()->GetArray(name);
  return CHECK(array) ? array->GetTuple1(0) : std::nan("");
}

double Sum(vtkPolyData* mesh, const char* name)
{
  vtkDataArray* const array = mesh->GetPointData()->GetArray(name);
  double sum = 0.0;
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
  {
    sum += array->GetTuple1(n);
  }
  return sum;
}

/// The sides that one triangle alone has are those of the lines, in one of their directions; no side has three.
void CheckSides(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> sides;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType n = 0; n < 3; ++n)
    {
      ++sides[std::minmax({ ids->GetId(n), ids->GetId((n + 1) % 3) })];
    }
  }
  std::set<std::pair<vtkIdType, vtkIdType>> lines;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfLines(); ++cell)
  {
    mesh->GetLines()->GetCellAtId(cell, ids);
    for (vtkIdType n = 0; n + 1 < ids->GetNumberOfIds(); ++n)
    {
      lines.insert(std::minmax({ ids->GetId(n), ids->GetId(n + 1) }));
    }
  }
  for (const auto& [side, triangles] : sides)
  {
    CHECK(triangles == (lines.count(side) != 0 ? 1 : 2));
  }
}

/// Every vertex has the attributes of its column; no column has two.
void CheckVertices(vtkPolyData* mesh, vtkMatrix4x4* survey)
{
  vtkNew<vtkMatrix4x4> toLattice;
  vtkMatrix4x4::Invert(survey, toLattice);
  std::set<std::pair<int, int>> columns;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    std::array<double, 4> place = { 0.0, 0.0, 0.0, 1.0 };
    mesh->GetPoint(point, place.data());
    toLattice->MultiplyPoint(place.data(), place.data());
    const int i = int(std::lround(place[0]));
    const int j = int(std::lround(place[1]));
    CHECK(columns.insert({ i, j }).second);
    CHECK(std::abs(place[2] - Wavy(i, j)) <= Error + 1e-6); // on the line of a seam
    CHECK(mesh->GetPointData()->GetArray("Amplitude")->GetTuple1(point) == double(i) + 100.0 * double(j));
    CHECK(mesh->GetPointData()->GetArray("VerticalIndex")->GetTuple1(point) == Wavy(i, j));
  }
}

/// The z component of the normals of all triangles is positive.
void CheckFacing(vtkPolyData* mesh)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    std::array<std::array<double, 3>, 3> corners;
    for (vtkIdType n = 0; n < 3; ++n)
    {
      mesh->GetPoint(ids->GetId(n), corners[std::size_t(n)].data());
    }
    CHECK((corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
        (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]) >
      0.0);
  }
}

vtkSmartPointer<vtkMatrix4x4> MirroredSurvey()
{
  auto map = RotatedSurvey();
  map->SetElement(0, 1, -map->GetElement(0, 1));
  map->SetElement(1, 1, -map->GetElement(1, 1));
  return map;
}

/// Where the loops of holes turn on a seam, points are on its line, and not where they were.
void TestPins()
{
  const auto survey = UnitSurvey();
  const Data points = MakeRows(30, Height, survey);
  const Data part = MakeMesh(points, 30, -1);
  std::map<std::pair<double, double>, double> heights;
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    heights[{ points->GetPoint(point)[0], points->GetPoint(point)[1] }] = points->GetPoint(point)[2];
  }
  int moved = 0;
  for (vtkIdType point = 0; point < part->GetNumberOfPoints(); ++point)
  {
    const double* const place = part->GetPoint(point);
    const bool isMoved = place[2] != heights.at({ place[0], place[1] });
    CHECK(!isMoved || place[1] == 30.0);
    moved += isMoved ? 1 : 0;
  }
  CHECK(moved > 1);
}

void TestSurveys()
{
  for (const auto& survey : { UnitSurvey(), RotatedSurvey(), MirroredSurvey() })
  {
    const Data points = MakeRows(0, Height, survey);
    const Data whole = MakeMesh(points);
    const std::vector<Data> parts = MakeParts(survey);
    const Data joined = Join({ parts[2], parts[0], parts[3], parts[1] }); // in any order
    CheckSides(joined);
    CheckVertices(joined, survey);
    CheckFacing(joined);
    CHECK(Sum(joined, "PointCount") == double(points->GetNumberOfPoints()));
    CHECK(joined->GetNumberOfLines() == whole->GetNumberOfLines());
    for (const char* const name : { "NumberOfPatches", "NumberOfHoles", "DroppedSmallPatchPoints", "ChosenRadius" })
    {
      CHECK_EQUAL(Figure(joined, name), Figure(whole, name));
    }
    CHECK_EQUAL(Figure(joined, "NumberOfParts"), 4.0);
    CHECK_EQUAL(Figure(joined, "TriangleCount"), double(joined->GetNumberOfPolys()));
    CHECK(Figure(joined, "SeamPoints") > 0.0);
    CHECK(
      Figure(joined, "LargestError") <= Error + 1e-9 && Figure(joined, "MeanError") < Figure(whole, "MeanError") * 1.3);
    CHECK(!joined->GetFieldData()->HasArray("SeamRows") && !joined->GetPointData()->HasArray("SeamGap"));
    for (const char* const name : { "Error", "Quality", "Compactness" })
    {
      vtkDataArray* const array = joined->GetCellData()->GetArray(name);
      CHECK(array && array->GetNumberOfTuples() == joined->GetNumberOfCells());
      CHECK(std::isnan(array->GetTuple1(0)) && array->GetTuple1(joined->GetNumberOfCells() - 1) >= 0.0);
    }
    CHECK(joined->GetPointData()->GetScalars() == joined->GetPointData()->GetArray("VerticalIndex"));
    CHECK_EQUAL(Sum(joined, "Boundary") > 0.0, true);
  }
}

void TestSmallPatches()
{
  const std::vector<Data> parts = MakeParts(UnitSurvey());
  const Data all = Join(parts);
  const Data without = Join(parts, 3);
  CHECK_EQUAL(Figure(all, "NumberOfPatches"), 2.0);
  CHECK_EQUAL(Figure(without, "NumberOfPatches"), 1.0);
  CHECK_EQUAL(Figure(without, "DroppedSmallPatchPoints"), 2.0);
  CHECK(Sum(without, "PointCount") == Sum(all, "PointCount") - 2.0);
  CHECK(Join(parts, std::numeric_limits<int>::max())->GetNumberOfPoints() == 0);
  // A single mesh without seams, and none.
  const Data whole = MakeMesh(MakeRows(0, Height, UnitSurvey()), -1, -1);
  Join({ whole }, 1, "a mesh without the field data array SeamRows, expected parts of a horizon");
  CHECK(Join({}, 1)->GetNumberOfPoints() == 0);
}

void TestJoinErrors()
{
  const auto survey = UnitSurvey();
  const std::vector<Data> parts = MakeParts(survey);
  Join(
    { parts[0], parts[2], parts[3] }, 1, "part 1 with its lower seam at row 12, expected that above the part before");
  Join({ parts[1], parts[2], parts[3] }, 1, "part 0 with its lower seam at row 11, expected none below");
  Join({ parts[0], parts[1] }, 1, "the last part with its upper seam at row 12, expected a part beyond it");
  Join(parts, 0, "minimum patch size 0, expected at least 1 point");
  std::vector<Data> others = parts;
  others[1] = MakeMesh(MakeRows(11, 12, survey), 11, 12, 2);
  Join(others, 1, "parts that differ in ChosenRadius (2");
  others[1] = MakeMesh(MakeRows(11, 12, survey), 11, 12, 1, 2.0);
  Join(others, 1, "parts that differ in");
  others[1] = MakeMesh(MakeRows(11, 12, RotatedSurvey()), 11, 12);
  Join(others, 1, "parts that differ in LatticeToWorld");
}

/// What horizons in parts cannot have.
void TestSurfaceErrors()
{
  const Data points = MakeRows(11, 30, UnitSurvey());
  const auto refuse = [&points](const std::string& text, void (*change)(vtkHorizonSurface*))
  {
    vtkNew<vtkHorizonSurface> surface;
    Errors errors(surface);
    surface->SetInputData(points);
    surface->SetSeamRows(11, 30);
    surface->SetMaximumError(Error);
    change(surface);
    surface->Update();
    CHECK(surface->GetPolyDataOutput()->GetNumberOfPoints() == 0);
    if (!CHECK(errors.Count() == 1 && errors.FirstContains(text)))
    {
      std::cerr << "found: " << errors.First() << ", expected: " << text << '\n';
    }
  };
  refuse("a seam and a maximum error of unit Diagonal, expected Lattice or World",
    [](vtkHorizonSurface* surface) { surface->SetErrorUnitToDiagonal(); });
  refuse("a seam and an automatic maximum error, expected one that is given",
    [](vtkHorizonSurface* surface) { surface->SetMaximumError(-1.0); });
  refuse(
    "a seam and a number of triangles", [](vtkHorizonSurface* surface) { surface->SetTargetToNumberOfTriangles(); });
  refuse("a seam and a minimum patch size of 4 points", [](vtkHorizonSurface* s) { s->SetMinimumPatchSize(4); });
  refuse("a seam without hole boundaries", [](vtkHorizonSurface* surface) { surface->KeepHolesOff(); });
  refuse("seam row -2, expected at least -1, which stands for none",
    [](vtkHorizonSurface* surface) { surface->SetSeamRows(-2, -1); });
  refuse("in row 30, expected none beyond the seams (lower: 11, upper: 29)",
    [](vtkHorizonSurface* surface) { surface->SetSeamRows(11, 29); });
}

void TestChosenForParts()
{
  vtkNew<vtkHorizonSurface> surface;
  const Data points = MakeRows(0, Height, RotatedSurvey());
  CHECK_EQUAL(surface->ChooseRadius(points), 1);
  surface->SetInputData(points);
  surface->Update();
  CHECK_EQUAL(Figure(surface->GetPolyDataOutput(), "ChosenRadius"), 1.0);
  CHECK_EQUAL(surface->ChooseMaximumError(points), Figure(surface->GetPolyDataOutput(), "ChosenMaximumError"));
  CHECK(surface->ChooseMaximumError(points) > 0.0);
  CHECK_EQUAL(surface->ChooseMaximumError(nullptr), 0.0);
  CHECK_EQUAL(surface->ChooseRadius(nullptr), 0);
  vtkNew<vtkPolyData> empty;
  CHECK_EQUAL(surface->ChooseRadius(empty), 0);
  Errors errors(surface);
  points->GetFieldData()->RemoveArray("LatticeToWorld");
  CHECK_EQUAL(surface->ChooseRadius(points), 0);
  CHECK_EQUAL(errors.Count(), 1u);
}
}

int TestHorizonSurfaceJoin(int, char*[])
{
  TestPins();
  TestSurveys();
  TestSmallPatches();
  TestJoinErrors();
  TestSurfaceErrors();
  TestChosenForParts();
  return Check::Result();
}
