// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>
#include <string>

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

/// Where nothing is dropped, nothing is copied, and nothing counted.
void TestNothingIsDropped(vtkMatrix4x4* survey)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(9, 6), 2, survey, Level));
  vtkNew<vtkHorizonBoundarySimplification> straight;
  straight->SetInputConnection(boundary->GetOutputPort());
  straight->SetDistanceThreshold(0.0);
  straight->Update();
  vtkPolyData* const before = boundary->GetPolyDataOutput();
  vtkPolyData* const after = straight->GetPolyDataOutput();
  CHECK(after->GetPoints() == before->GetPoints());
  CHECK(after->GetPointData()->GetArray("Amplitude") == before->GetPointData()->GetArray("Amplitude"));
  CHECK_EQUAL(after->GetPointData()->GetNumberOfArrays(), before->GetPointData()->GetNumberOfArrays());
  CHECK(!after->GetPointData()->HasArray("PointCount"));
  CHECK_EQUAL(after->GetLines()->GetNumberOfConnectivityIds(), before->GetLines()->GetNumberOfConnectivityIds());
}

/// Vertices of horizons that are about as large share memory, whoever of them is there the longest, and those that grow
/// leave it.
void TestVerticesShareMemory()
{
  const auto after = Simplified(0.4, HorizonFixtures::UnitSurvey(), Level);
  vtkSmartPointer<vtkCellArray> vertices = after->GetVerts();
  const auto numbers = [](vtkDataArray* array) { return static_cast<const int*>(array->GetVoidPointer(0)); };
  const int* const shared = numbers(vertices->GetOffsetsArray());
  CHECK(numbers(vertices->GetConnectivityArray()) == shared);
  {
    const auto other = Simplified(0.4, HorizonFixtures::UnitSurvey(), Level);
    CHECK(numbers(other->GetVerts()->GetOffsetsArray()) == shared);
    const vtkIdType first = 0;
    other->GetVerts()->InsertNextCell(1, &first);
    CHECK(numbers(other->GetVerts()->GetOffsetsArray()) != shared);
    CHECK_EQUAL(other->GetVerts()->GetNumberOfCells(), vertices->GetNumberOfCells() + 1);
  }
  const vtkIdType size = vertices->GetNumberOfCells();
  CHECK_EQUAL(size, 7 * 4 + 4);
  for (vtkIdType n = 0; n < size; ++n)
  {
    CHECK(shared[n] == n && numbers(vertices->GetConnectivityArray())[n] == n);
  }
  CHECK_EQUAL(shared[size], size);
}

/// Counts and labels of any kind go on, those of dropped points to the points that stand for them.
void TestArraysOfAllKinds()
{
  const auto survey = HorizonFixtures::UnitSurvey();
  const auto horizon = HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(9, 6), 2, survey, Level);
  vtkNew<vtkIntArray> counts;
  counts->SetName("PointCount");
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  vtkNew<vtkBitArray> bits;
  bits->SetName("Bits");
  for (int point = 0; point < 54; ++point)
  {
    counts->InsertNextValue(point);
    names->InsertNextValue(std::to_string(point));
    bits->InsertNextValue(point % 3 == 0);
  }
  for (vtkAbstractArray* array : { static_cast<vtkAbstractArray*>(counts), static_cast<vtkAbstractArray*>(names),
         static_cast<vtkAbstractArray*>(bits) })
  {
    horizon->GetPointData()->AddArray(array);
  }
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(horizon);
  vtkNew<vtkHorizonBoundarySimplification> straight;
  straight->SetInputConnection(boundary->GetOutputPort());
  straight->Update();
  vtkPointData* const data = straight->GetPolyDataOutput()->GetPointData();
  auto* const kept = vtkStringArray::SafeDownCast(data->GetAbstractArray("Names"));
  CHECK_EQUAL(kept->GetNumberOfValues(), 7 * 4 + 4);
  int row = 0;
  for (vtkIdType point = 0; point < kept->GetNumberOfValues(); ++point)
  {
    const int before = std::stoi(kept->GetValue(point));
    row += data->GetArray("Bits")->GetTuple1(point) == double(before % 3 == 0) ? 1 : 0;
  }
  CHECK_EQUAL(row, 7 * 4 + 4);
  CHECK_EQUAL(kept->GetValue(2), std::string("10")); // after the two corners of the first row
  // Of the first row points 1 to 3 count for the first corner, of the first column 9 and 18.
  CHECK_EQUAL(data->GetArray("PointCount")->GetTuple1(0), 1.0 + 2.0 + 3.0 + 9.0 + 18.0);
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
  boundary->KeepHolesOn();
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
  TestNothingIsDropped(HorizonFixtures::RotatedSurvey());
  TestVerticesShareMemory();
  TestArraysOfAllKinds();
  TestThresholdIsInLatticeUnits();
  TestOutlineTolerance(HorizonFixtures::UnitSurvey());
  TestOutlineTolerance(HorizonFixtures::RotatedSurvey());
  TestFewestPoints(HorizonFixtures::UnitSurvey());
  TestFewestPoints(HorizonFixtures::RotatedSurvey());
  TestPrint();
  return Check::Result();
}
