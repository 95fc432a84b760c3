// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkIdList.h"

#include <sstream>
#include <utility>

namespace
{
using HorizonFixtures::FromPicture;

std::vector<vtkIdType> Loop(vtkPolyData* horizon, vtkIdType number)
{
  vtkNew<vtkIdList> ids;
  horizon->GetLines()->GetCellAtId(number, ids);
  return { ids->begin(), ids->end() };
}

/// A square with a hole, a spur to the right, and a second patch; on both kinds of survey.
void TestCellsAndArrays(vtkMatrix4x4* survey)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  auto input = FromPicture({ "###...", "#.####", "###...", "......", "#....." }, 3, survey);
  boundary->SetInputDataObject(input);
  boundary->Update();
  vtkPolyData* const output = boundary->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 12);
  CHECK_EQUAL(output->GetNumberOfVerts(), 12);
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  CHECK_EQUAL(output->GetNumberOfPolys(), 0);
  CHECK(output->GetPoints() == input->GetPoints());

  // Point 0 is the single one below; then rows from below: 1 2 3, 4 5 6 7 8, 9 10 11.
  CHECK(Loop(output, 0) == std::vector<vtkIdType>({ 0, 0 }));
  CHECK(Loop(output, 1) == std::vector<vtkIdType>({ 1, 4, 9, 10, 11, 6, 7, 8, 7, 6, 3, 2, 1 }) ||
    Loop(output, 1) == std::vector<vtkIdType>({ 1, 4, 9, 10, 11, 6, 7, 8, 7, 3, 2, 1 }));

  vtkDataArray* const patch = output->GetPointData()->GetArray("PatchId");
  vtkDataArray* const kind = output->GetPointData()->GetArray("Boundary");
  CHECK(patch && patch->GetDataType() == VTK_INT);
  CHECK(kind && kind->GetDataType() == VTK_UNSIGNED_CHAR);
  CHECK_EQUAL(patch->GetComponent(0, 0), 0.0);
  CHECK_EQUAL(patch->GetComponent(8, 0), 1.0);
  CHECK_EQUAL(kind->GetComponent(0, 0), 1.0);
  CHECK_EQUAL(output->GetPointData()->GetArray("Amplitude")->GetComponent(0, 0), 0.0);
  CHECK(output->GetFieldData()->GetArray("LatticeToWorld") != nullptr);
}

void TestInsideIsMarked()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(FromPicture(HorizonFixtures::Rectangle(3, 3), 3, HorizonFixtures::UnitSurvey()));
  boundary->Update();
  vtkDataArray* const kind = boundary->GetPolyDataOutput()->GetPointData()->GetArray("Boundary");
  for (vtkIdType point = 0; point < 9; ++point)
  {
    CHECK_EQUAL(kind->GetComponent(point, 0), point == 4 ? 0.0 : 1.0);
  }
}

void TestPointBetweenColumns()
{
  auto input = FromPicture(HorizonFixtures::Rectangle(3, 3), 3, HorizonFixtures::UnitSurvey());
  input->GetPoints()->SetPoint(4, 1.25, 1.0, 0.0);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  HorizonFixtures::Errors errors(boundary);
  boundary->SetInputDataObject(input);
  boundary->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains("point 4 at (1.25"));
  CHECK(errors.FirstContains("expected whole columns"));
}

double Count(vtkPolyData* horizon, const char* name)
{
  return horizon->GetFieldData()->GetArray(name)->GetTuple1(0);
}

double Mark(vtkPolyData* horizon, vtkIdType point)
{
  return horizon->GetPointData()->GetArray("Boundary")->GetTuple1(point);
}

/// Two squares with a gap of one column between them, the left one with a hole of one column.
vtkSmartPointer<vtkPolyData> TwoSquares(vtkMatrix4x4* survey)
{
  return FromPicture({ "###.###", "#.#.###", "###.###" }, 3, survey);
}

void TestRadiusAndHoles()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(TwoSquares(HorizonFixtures::UnitSurvey()));
  boundary->KeepHolesOn();
  boundary->Update();
  vtkPolyData* const output = boundary->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfLines(), 3);
  CHECK_EQUAL(Count(output, "NumberOfPatches"), 2.0);
  CHECK_EQUAL(Count(output, "NumberOfHoles"), 1.0);
  CHECK_EQUAL(Count(output, "DroppedSmallPatchPoints"), 0.0);
  CHECK_EQUAL(Mark(output, 1), 1.0); // on both loops: the exterior one counts
  for (const int growth : { vtkHorizonExteriorBoundary::Distance, vtkHorizonExteriorBoundary::Clockwise })
  {
    boundary->SetRadius(2);
    boundary->SetGrowthStrategy(growth);
    boundary->Update();
    CHECK_EQUAL(Count(boundary->GetPolyDataOutput(), "NumberOfPatches"), 1.0);
    CHECK_EQUAL(Count(boundary->GetPolyDataOutput(), "NumberOfHoles"), growth == 0 ? 1.0 : 0.0);
  }
}

/// A column of the rotated survey has 10.8 x 21.6 + 12.5 x 6.25 = 311.405 square metres.
void TestSmallestHoleArea()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(FromPicture({ "######", "#.#..#", "######" }, 3, HorizonFixtures::RotatedSurvey()));
  boundary->KeepHolesOn();
  for (const auto& [area, holes] : { std::pair<double, double>(0.0, 2.0), { 311.405, 2.0 }, { 312.0, 1.0 },
         { 622.81, 1.0 }, { 623.0, 0.0 }, { 1e300, 0.0 } })
  {
    boundary->SetSmallestHoleArea(area);
    boundary->Update();
    CHECK_EQUAL(Count(boundary->GetPolyDataOutput(), "NumberOfHoles"), holes);
  }
  boundary->SetSmallestHoleArea(0.0);
  boundary->SetSmallestHoleSize(2);
  boundary->Update();
  CHECK_EQUAL(Count(boundary->GetPolyDataOutput(), "NumberOfHoles"), 1.0);
}

/// Points and arrays are those of the input; each point gets a vertex, whatever vertices were there.
void TestSharing()
{
  const auto input = FromPicture({ "###", "###" }, 3, HorizonFixtures::UnitSurvey());
  const auto run = [&input]()
  {
    vtkNew<vtkHorizonExteriorBoundary> boundary;
    boundary->SetInputDataObject(input);
    boundary->Update();
    vtkPolyData* const output = boundary->GetPolyDataOutput();
    CHECK(output->GetPoints() == input->GetPoints());
    CHECK(output->GetPointData()->GetArray("Amplitude") == input->GetPointData()->GetArray("Amplitude"));
    CHECK(!input->GetPointData()->HasArray("PatchId"));
    CHECK_EQUAL(output->GetNumberOfVerts(), 6);
    for (vtkIdType cell = 0; cell < 6; ++cell)
    {
      CHECK_EQUAL(output->GetVerts()->GetCellSize(cell), 1);
      CHECK_EQUAL(output->GetVerts()->GetConnectivityArray()->GetComponent(cell, 0), double(cell));
    }
  };
  run();
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType point = 0; point < 6; ++point)
  {
    vertices->InsertNextCell({ 5 - point });
  }
  input->SetVerts(vertices);
  run();
}

/// The points of small patches go with all they have; the others keep theirs.
void TestSmallPatches()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(FromPicture({ "#.##", "..##", "#..." }, 3, HorizonFixtures::UnitSurvey()));
  boundary->SetMinimumPatchSize(2);
  boundary->Update();
  vtkPolyData* const output = boundary->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 4);
  CHECK_EQUAL(output->GetNumberOfVerts(), 4);
  CHECK_EQUAL(output->GetPoint(0)[0], 2.0);
  CHECK_EQUAL(output->GetPointData()->GetArray("Amplitude")->GetTuple1(0), 102.0); // i + 100 j
  CHECK_EQUAL(Count(output, "DroppedSmallPatchPoints"), 2.0);
  CHECK(Loop(output, 0) == std::vector<vtkIdType>({ 0, 2, 3, 1, 0 }));
  boundary->SetMinimumPatchSize(5);
  boundary->Update();
  CHECK_EQUAL(output->GetNumberOfPoints(), 0);
  CHECK_EQUAL(output->GetNumberOfLines(), 0);
}

/// A square of five with a hole in the middle: the corners of the ring around the hole have no empty side.
void TestTopologicalBoundary()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(
    FromPicture({ "#####", "#####", "##.##", "#####", "#####" }, 3, HorizonFixtures::UnitSurvey()));
  boundary->SetBoundaryTypeToTopological4();
  boundary->SetRadius(3); // does not matter
  boundary->Update();
  vtkPolyData* const output = boundary->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  CHECK_EQUAL(Mark(output, 0), 1.0);
  CHECK_EQUAL(Mark(output, 6), 0.0);
  CHECK_EQUAL(Mark(output, 7), 2.0);
  boundary->SetBoundaryTypeToTopological8();
  boundary->Update();
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  CHECK_EQUAL(Mark(output, 0), 1.0);
  CHECK_EQUAL(Mark(output, 6), 2.0);
  CHECK_EQUAL(Mark(output, 7), 2.0);
}

void TestWrongRadius()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  HorizonFixtures::Errors errors(boundary);
  boundary->SetInputDataObject(TwoSquares(HorizonFixtures::UnitSurvey()));
  boundary->SetRadius(0);
  boundary->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains("radius 0, expected 1 to 32 columns"));
  CHECK_EQUAL(boundary->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}

void TestPrint()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetBoundaryTypeToTopological8();
  boundary->SetRadius(7);
  boundary->SetGrowthStrategyToDistance();
  boundary->KeepHolesOn();
  boundary->SetSmallestHoleSize(12);
  boundary->SetSmallestHoleArea(2.5);
  boundary->SetMinimumPatchSize(34);
  std::ostringstream text;
  boundary->Print(text);
  for (const char* line : { "BoundaryType: Topological8", "Radius: 7", "GrowthStrategy: Distance", "KeepHoles: on",
         "SmallestHoleSize: 12", "SmallestHoleArea: 2.5", "MinimumPatchSize: 34" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonExteriorBoundary(int, char*[])
{
  TestRadiusAndHoles();
  TestSmallestHoleArea();
  TestSharing();
  TestSmallPatches();
  TestTopologicalBoundary();
  TestWrongRadius();
  TestPrint();
  TestCellsAndArrays(HorizonFixtures::UnitSurvey());
  TestCellsAndArrays(HorizonFixtures::RotatedSurvey());
  TestInsideIsMarked();
  TestPointBetweenColumns();
  return Check::Result();
}
