// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps become horizons: points or cells, turned, blanked, with null values.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonFromImage.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace HorizonFixtures;

namespace
{
using Image = vtkSmartPointer<vtkImageData>;

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// 3 x 2 points from (7, 9) on, 10 and 20 apart, turned by a quarter to the left: rows run to smaller x.
Image TurnedMap()
{
  auto image = Image::New();
  image->SetExtent(1, 3, 0, 1, 0, 0);
  image->SetOrigin(7.0, 9.0, 0.0);
  image->SetSpacing(10.0, 20.0, 1.0);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  image->GetPointData()->AddArray(MakeArray("depth", { 100, 101, -999, 103, std::nan(""), 105 }));
  image->GetPointData()->AddArray(MakeArray("amplitude", { 0, 1, 2, 3, 4, 5 }));
  return image;
}

vtkPolyData* Horizon(vtkHorizonFromImage* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput()->GetPartition(0, 0));
}

bool IsAt(vtkPolyData* horizon, vtkIdType point, double x, double y, double z)
{
  const double* const place = horizon->GetPoint(point);
  return std::hypot(place[0] - x, place[1] - y, place[2] - z) < 1e-9;
}

void TestPoints()
{
  vtkNew<vtkHorizonFromImage> filter;
  filter->SetInputDataObject(TurnedMap());
  filter->SetNullValues("-999");
  filter->Update();
  vtkPolyData* const horizon = Horizon(filter);
  CHECK_EQUAL(horizon->GetNumberOfPoints(), 4);
  CHECK(IsAt(horizon, 0, 7.0, 19.0, -100.0)); // the extent begins at 1
  CHECK(IsAt(horizon, 1, 7.0, 29.0, -101.0));
  CHECK(IsAt(horizon, 2, -13.0, 19.0, -103.0));
  CHECK_EQUAL(horizon->GetPointData()->GetArray("amplitude")->GetTuple1(3), 5.0);
  CHECK_EQUAL(horizon->GetFieldData()->GetArray("DroppedNulls")->GetTuple1(0), 2.0);
}

void TestBlanked()
{
  Image image = TurnedMap();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int n = 0; n < 6; ++n)
  {
    ghosts->InsertNextValue(n == 0 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  image->GetPointData()->AddArray(ghosts);
  vtkNew<vtkHorizonFromImage> filter;
  filter->SetInputDataObject(image);
  filter->SetZArray("amplitude");
  filter->SetVerticalDirectionToUp();
  filter->Update();
  CHECK_EQUAL(Horizon(filter)->GetNumberOfPoints(), 5);
  CHECK(IsAt(Horizon(filter), 0, 7.0, 29.0, 1.0));
  CHECK(Horizon(filter)->GetPointData()->GetArray("depth") != nullptr);
}

/// As rasters are read: a value for each cell, whose centre is the column.
void TestCells()
{
  auto image = Image::New();
  image->SetDimensions(4, 3, 1);
  image->SetOrigin(100.0, 200.0, 0.0);
  image->SetSpacing(30.0, 30.0, 1.0);
  image->GetCellData()->SetScalars(MakeArray("Elevation", { 1, 2, 3, 4, 5, 6 }));
  vtkNew<vtkHorizonFromImage> filter;
  filter->SetInputDataObject(image);
  filter->Update();
  CHECK_EQUAL(Horizon(filter)->GetNumberOfPoints(), 6);
  CHECK(IsAt(Horizon(filter), 0, 115.0, 215.0, 1.0)); // elevations by the name of the array
  CHECK(IsAt(Horizon(filter), 5, 175.0, 245.0, 6.0));
  CHECK(std::string(filter->GetDescription()).find("larger world z") != std::string::npos);
  filter->SetVerticalDirectionToDown();
  filter->Update();
  CHECK(IsAt(Horizon(filter), 5, 175.0, 245.0, -6.0));
  filter->SetVerticalDirectionToAutomatic();
  image->GetCellData()->GetScalars()->SetName("TWT");
  image->Modified();
  filter->Update();
  CHECK(IsAt(Horizon(filter), 5, 175.0, 245.0, -6.0));
}

void CheckRefused(vtkImageData* image, const char* zArray, const std::string& message)
{
  vtkNew<vtkHorizonFromImage> filter;
  const Errors errors(filter);
  filter->SetInputDataObject(image);
  filter->SetZArray(zArray);
  filter->Update();
  CHECK_EQUAL(errors.Count(), std::size_t(1));
  CHECK(errors.FirstContains(": " + message));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPartitionedDataSets(), 0u);
}

void TestRefusals()
{
  CheckRefused(TurnedMap(), "none", "no array none, expected one with z");
  auto bare = Image::New();
  bare->SetDimensions(2, 2, 1);
  CheckRefused(bare, nullptr, "an image without an array of one component, expected one with z");
  Image tilted = TurnedMap();
  tilted->SetDirectionMatrix(1, 0, 0, 0, 0, -1, 0, 1, 0);
  CheckRefused(tilted, nullptr, "an image that is not level, expected one whose rows and columns are level");
  auto cube = Image::New();
  cube->SetDimensions(2, 2, 2);
  cube->GetPointData()->SetScalars(MakeArray("v", std::vector<double>(8, 1.0)));
  CheckRefused(cube, nullptr, "an image of 2 layers, expected a map of one layer");
  Image short2 = TurnedMap();
  short2->GetPointData()->AddArray(MakeArray("depth", { 1, 2 }));
  CheckRefused(short2, "amplitude", "array depth of 2 tuples, expected one for each of the 6 points");
  Image ghosts = TurnedMap();
  vtkNew<vtkUnsignedCharArray> few;
  few->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->GetPointData()->AddArray(few);
  CheckRefused(ghosts, "depth", "array vtkGhostType of 0 tuples, expected one for each of the 6 points");
  auto row = Image::New();
  row->SetDimensions(4, 1, 1);
  row->GetCellData()->SetScalars(MakeArray("v", { 1, 2, 3 }));
  CheckRefused(row, nullptr, "an image of 3 x 0 cells, expected at least one each way");
}

/// Columns have to be at places, and apart.
void TestPlaces()
{
  for (const double spacing : { 0.0, std::nan(""), std::numeric_limits<double>::max() })
  {
    Image image = TurnedMap();
    image->SetSpacing(10.0, spacing, 1.0);
    CheckRefused(image, "depth", "nodes from (");
  }
  Image nowhere = TurnedMap();
  nowhere->SetOrigin(std::nan(""), 0.0, 0.0);
  CheckRefused(nowhere, "depth", "nodes from (nan, 10) in steps of");
}
}

int TestHorizonFromImage(int, char*[])
{
  TestPoints();
  TestBlanked();
  TestCells();
  TestRefusals();
  TestPlaces();
  return Check::Result();
}
