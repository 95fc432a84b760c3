// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonExteriorBoundary.h"

#include <cmath>
#include <sstream>

namespace
{
double Level(int, int)
{
  return 7.0;
}

vtkSmartPointer<vtkPolyData> Simplified(double threshold, vtkMatrix4x4* survey, double (*height)(int, int))
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(9, 6), 2, survey, height));
  vtkNew<vtkHorizonBoundarySimplification> straight;
  straight->SetInputConnection(boundary->GetOutputPort());
  straight->SetDistanceThreshold(threshold);
  straight->Update();
  return straight->GetPolyDataOutput();
}

/// Of a level rectangle's outline the corners stay; the inside is untouched; the counts of dropped points go on.
void TestLevelRectangle(vtkMatrix4x4* survey)
{
  auto output = Simplified(0.4, survey, Level);
  const vtkIdType inside = 7 * 4;
  CHECK_EQUAL(output->GetNumberOfPoints(), inside + 4);
  CHECK_EQUAL(output->GetNumberOfVerts(), inside + 4);
  CHECK_EQUAL(output->GetNumberOfLines(), 1);
  CHECK_EQUAL(output->GetCell(output->GetNumberOfVerts())->GetNumberOfPoints(), 5);
  CHECK_EQUAL(output->GetFieldData()->GetArray("BoundaryDeviation")->GetTuple1(0), 0.0);
  vtkDataArray* const count = output->GetPointData()->GetArray("PointCount");
  CHECK_EQUAL(count->GetDataType(), VTK_ID_TYPE);
  double sum = 0.0;
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    sum += count->GetTuple1(point);
  }
  CHECK_EQUAL(sum, 54.0);
  // Nothing is averaged here: types stay, places stay to the last bit.
  CHECK_EQUAL(output->GetPointData()->GetArray("VerticalIndex")->GetDataType(), VTK_INT);
  CHECK_EQUAL(output->GetPointData()->GetArray("Amplitude")->GetTuple1(0), 0.0);
  CHECK_EQUAL(output->GetPoint(0)[0], survey->GetElement(0, 3));
  CHECK_EQUAL(output->GetPoints()->GetDataType(), VTK_DOUBLE);
}

/// Thresholds are in lattice units: the same points go whatever the steps of the survey are.
void TestThresholdIsInLatticeUnits()
{
  for (const double threshold : { 0.0, 0.3, 0.6, 2.0 })
  {
    CHECK_EQUAL(
      Simplified(threshold, HorizonFixtures::UnitSurvey(), HorizonFixtures::FoldedHeight)->GetNumberOfPoints(),
      Simplified(threshold, HorizonFixtures::RotatedSurvey(), HorizonFixtures::FoldedHeight)->GetNumberOfPoints());
  }
  CHECK_EQUAL(Simplified(0.0, HorizonFixtures::UnitSurvey(), HorizonFixtures::FoldedHeight)->GetNumberOfPoints(), 54);
}

/// A slope of one in two, whatever the steps of the survey are, and a hole that gets its corners cut as well.
void TestOutlineTolerance(vtkMatrix4x4* survey)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(HorizonFixtures::FromPicture(
    { "##........", "####......", "######....", "########..", "##########", "##..######", "##....####", "##########" },
    2, survey, Level));
  boundary->HoleBoundariesOn();
  vtkNew<vtkHorizonBoundarySimplification> straight;
  straight->SetInputConnection(boundary->GetOutputPort());
  straight->Update();
  const vtkIdType before = straight->GetPolyDataOutput()->GetNumberOfPoints();
  CHECK_EQUAL(straight->GetPolyDataOutput()->GetFieldData()->GetArray("OutlineDeviation")->GetTuple1(0), 0.0);
  straight->SetOutlineTolerance(0.5);
  straight->BoundDeviationOn();
  straight->Update();
  vtkPolyData* const output = straight->GetPolyDataOutput();
  CHECK(output->GetNumberOfPoints() < before);
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  const double deviation = output->GetFieldData()->GetArray("OutlineDeviation")->GetTuple1(0);
  CHECK(deviation > 0.4 && deviation <= 0.5);
}

/// As few points as the tolerances allow: three of a right triangle of 7 by 4 columns, whatever the steps of the survey
/// are.
void TestFewestPoints(vtkMatrix4x4* survey)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(HorizonFixtures::FromPicture(
    { "#........", "###......", "#####....", "#######..", "########." }, 2, survey, Level));
  vtkNew<vtkHorizonBoundarySimplification> straight;
  straight->SetInputConnection(boundary->GetOutputPort());
  straight->SetOutlineTolerance(0.5);
  straight->SetMethodToFewestPoints();
  straight->Update();
  vtkPolyData* const output = straight->GetPolyDataOutput();
  CHECK_EQUAL(output->GetCell(output->GetNumberOfVerts())->GetNumberOfPoints(), 4);
  const double deviation = output->GetFieldData()->GetArray("OutlineDeviation")->GetTuple1(0);
  CHECK(std::abs(deviation - 3.0 / std::hypot(7.0, 4.0)) < 1e-12);
}

void TestPrint()
{
  vtkNew<vtkHorizonBoundarySimplification> straight;
  CHECK_EQUAL(straight->GetDistanceThreshold(), 0.4);
  CHECK_EQUAL(straight->GetBoundDeviation(), false);
  CHECK_EQUAL(straight->GetOutlineTolerance(), 0.0);
  CHECK_EQUAL(straight->GetMethod(), vtkHorizonBoundarySimplification::Threshold);
  straight->SetMethodToFewestPoints();
  straight->SetDistanceThreshold(1.75);
  straight->BoundDeviationOn();
  straight->SetOutlineTolerance(0.625);
  std::ostringstream text;
  straight->Print(text);
  CHECK(text.str().find("DistanceThreshold: 1.75") != std::string::npos);
  CHECK(text.str().find("BoundDeviation: on") != std::string::npos);
  CHECK(text.str().find("OutlineTolerance: 0.625") != std::string::npos);
  CHECK(text.str().find("Method: FewestPoints") != std::string::npos);
}
}

int TestHorizonBoundarySimplification(int, char*[])
{
  TestLevelRectangle(HorizonFixtures::UnitSurvey());
  TestLevelRectangle(HorizonFixtures::RotatedSurvey());
  TestThresholdIsInLatticeUnits();
  TestOutlineTolerance(HorizonFixtures::UnitSurvey());
  TestOutlineTolerance(HorizonFixtures::RotatedSurvey());
  TestFewestPoints(HorizonFixtures::UnitSurvey());
  TestFewestPoints(HorizonFixtures::RotatedSurvey());
  TestPrint();
  return Check::Result();
}
