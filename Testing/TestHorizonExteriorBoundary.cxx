// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Check.h"
#include "HorizonFixtures.h"

#include "vtkCellArray.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkIdList.h"

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
}

int TestHorizonExteriorBoundary(int, char*[])
{
  TestCellsAndArrays(HorizonFixtures::UnitSurvey());
  TestCellsAndArrays(HorizonFixtures::RotatedSurvey());
  TestInsideIsMarked();
  TestPointBetweenColumns();
  return Check::Result();
}
