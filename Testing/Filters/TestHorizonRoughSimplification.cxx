// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkFloatArray.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>

namespace
{
double Slope(int i, int j)
{
  return i + 2 * j;
}

/// Nine by nine columns in cells of three: 32 boundary points and the middle of the middle cell, the column (4, 4).
void TestAttributes(vtkMatrix4x4* survey)
{
  auto input = HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(9, 9), 5, survey, Slope);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(2);
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  for (int n = 0; n < 81; ++n)
  {
    vectors->InsertNextTuple2(n, -n);
    label->InsertNextValue(n);
    names->InsertNextValue("point " + std::to_string(n));
  }
  input->GetPointData()->AddArray(vectors);
  input->GetPointData()->AddArray(label);
  input->GetPointData()->AddArray(names);

  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(input);
  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputConnection(boundary->GetOutputPort());
  rough->Update();
  vtkPolyData* const output = rough->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 33);
  CHECK_EQUAL(output->GetNumberOfVerts(), 33);
  CHECK_EQUAL(output->GetNumberOfLines(), 1);
  vtkPointData* const data = output->GetPointData();

  // Averaged: floating point arrays, and vertical indices, which are not whole any more.
  CHECK_EQUAL(data->GetArray("VerticalIndex")->GetDataType(), VTK_DOUBLE);
  CHECK_EQUAL(data->GetArray("VerticalIndex")->GetTuple1(32), 12.0);
  CHECK_EQUAL(data->GetArray("Amplitude")->GetTuple1(32), 404.0);
  CHECK_EQUAL(data->GetArray("Vectors")->GetDataType(), VTK_FLOAT);
  CHECK_EQUAL(data->GetArray("Vectors")->GetComponent(32, 1), -40.0);
  // Labels: from the nearest point.
  CHECK_EQUAL(data->GetArray("SurfaceId")->GetDataType(), VTK_INT);
  CHECK_EQUAL(data->GetArray("SurfaceId")->GetTuple1(32), 5.0);
  CHECK_EQUAL(data->GetArray("PatchId")->GetTuple1(32), 0.0);
  CHECK_EQUAL(data->GetArray("Boundary")->GetTuple1(32), 0.0);
  CHECK_EQUAL(data->GetArray("Label")->GetTuple1(32), 40.0);
  CHECK_EQUAL(vtkStringArray::SafeDownCast(data->GetAbstractArray("Names"))->GetValue(32), "point 40");
  CHECK_EQUAL(data->GetArray("PointCount")->GetTuple1(32), 9.0);

  const double place[4] = { 4, 4, 12, 1 };
  double world[4];
  survey->MultiplyPoint(place, world);
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(std::abs(output->GetPoint(32)[axis] - world[axis]) < 1e-6);
  }
}

void TestPrint()
{
  vtkNew<vtkHorizonRoughSimplification> rough;
  CHECK_EQUAL(rough->GetCellSize(), 3);
  rough->SetCellSize(17);
  std::ostringstream text;
  rough->Print(text);
  CHECK(text.str().find("CellSize: 17") != std::string::npos);
}
}

int TestHorizonRoughSimplification(int, char*[])
{
  TestAttributes(HorizonFixtures::UnitSurvey());
  TestAttributes(HorizonFixtures::RotatedSurvey());
  TestPrint();
  return Check::Result();
}
