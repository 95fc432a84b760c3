// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <array>
#include <cmath>
#include <string>

namespace
{
bool IsNear(double a, double b, double tolerance)
{
  return std::abs(a - b) <= tolerance;
}

/// A square, its far side lifted.
vtkSmartPointer<vtkPolyData> Slope(double height)
{
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> triangles;
  for (int n = 0; n < 4; ++n)
  {
    corners->InsertNextPoint(100.0 * (n % 2), 100.0 * (n / 2), height * (n % 2));
  }
  for (const auto& triangle : { std::array<vtkIdType, 3>{ 0, 1, 2 }, std::array<vtkIdType, 3>{ 1, 3, 2 } })
  {
    triangles->InsertNextCell(3, triangle.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(corners);
  mesh->SetPolys(triangles);
  return mesh;
}

/// The distance from a plane to a slope grows evenly: each bin has as much of the area.
void TestSlope()
{
  vtkNew<vtkHorizonSurfaceDistance> meter;
  meter->SetInputDataObject(0, Slope(0.0));
  meter->SetInputDataObject(1, Slope(3.0));
  meter->Update();
  auto* const table = vtkTable::SafeDownCast(meter->GetOutputDataObject(3));
  CHECK_EQUAL(table->GetNumberOfRows(), 31);
  double sum = 0.0;
  for (vtkIdType row = 0; row < 31; ++row)
  {
    const double share = table->GetValueByName(row, "Area (%)").ToDouble();
    CHECK(row == 30 ? IsNear(share, 1.0, 0.05) : IsNear(share, 3.3, 0.1));
    CHECK(IsNear(table->GetValueByName(row, "bin_extents").ToDouble(), 0.099 * double(row), 0.01));
    CHECK_EQUAL(table->GetValueByName(row, "Unit").ToString(), std::string("Steps"));
    sum += share;
  }
  CHECK(IsNear(sum, 100.0, 1e-9));
  // Of one surface nothing is far, up to rounding.
  meter->SetInputDataObject(1, Slope(0.0));
  meter->Update();
  CHECK(IsNear(table->GetValueByName(0, "Area (%)").ToDouble(), 100.0, 0.1));
}
}

int TestDistanceHistogram(int, char*[])
{
  TestSlope();
  return Check::Result();
}
