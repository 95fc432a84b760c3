// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What later stages make of points that hole filling has put in.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonHoleFilling.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurface.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonTriangulation.h"
#include "vtkIdList.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace
{
using HorizonFixtures::FromPicture;
using Data = vtkSmartPointer<vtkPolyData>;

/// Three holes, of 7 columns in all, in a tilted plane of 65 points.
Data WithHoles()
{
  return FromPicture(
    { "#########", "#########", "##.##..##", "#####..##", "#########", "###..####", "#########", "#########" }, 3,
    HorizonFixtures::UnitSurvey(), [](int i, int j) { return 20.0 + 2 * i + j; });
}

double FieldNumber(vtkPolyData* horizon, const char* name, int tuple = 0)
{
  vtkDataArray* const array = horizon->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(tuple, 0) : std::nan("");
}

double Value(vtkPolyData* horizon, const char* name, vtkIdType point)
{
  vtkDataArray* const array = horizon->GetPointData()->GetArray(name);
  return array ? array->GetComponent(point, 0) : std::nan("");
}

double SumOfCounts(vtkPolyData* data)
{
  double sum = 0.0;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    sum += Value(data, "PointCount", point);
  }
  return sum;
}

/// The area of a mesh in plan.
double Area(vtkPolyData* mesh)
{
  double area = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (mesh->GetCellType(cell) == VTK_TRIANGLE)
    {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(cell, ids);
      double p[3][3];
      for (int n = 0; n < 3; ++n)
      {
        mesh->GetPoint(ids->GetId(n), p[n]);
      }
      area += 0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
    }
  }
  return area;
}

/// The stages that follow cover what was filled, and count no more than there was; means leave new points out.
void TestFollowingStages()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  vtkNew<vtkHorizonExteriorBoundary> outline;
  vtkNew<vtkHorizonBoundarySimplification> straight;
  vtkNew<vtkHorizonRoughSimplification> rough;
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  vtkNew<vtkHorizonTriangulation> mesh;
  vtkNew<vtkHorizonDecimation> decimation;
  vtkNew<vtkHorizonSurface> surface;
  filling->SetInputDataObject(WithHoles());
  decimation->SetMaximumError(0.75);
  surface->SetMaximumError(0.75);
  outline->SetInputConnection(filling->GetOutputPort());
  outline->KeepHolesOn();
  straight->SetInputConnection(outline->GetOutputPort());
  rough->SetInputConnection(straight->GetOutputPort());
  rough->SetCellSize(2);
  elaborate->SetInputConnection(straight->GetOutputPort());
  mesh->SetInputConnection(rough->GetOutputPort());
  decimation->SetInputConnection(straight->GetOutputPort());
  surface->SetInputConnection(filling->GetOutputPort());
  for (vtkHorizonAlgorithm* stage : { static_cast<vtkHorizonAlgorithm*>(outline),
         static_cast<vtkHorizonAlgorithm*>(straight), static_cast<vtkHorizonAlgorithm*>(rough),
         static_cast<vtkHorizonAlgorithm*>(elaborate), static_cast<vtkHorizonAlgorithm*>(mesh),
         static_cast<vtkHorizonAlgorithm*>(decimation), static_cast<vtkHorizonAlgorithm*>(surface) })
  {
    HorizonFixtures::Errors errors(stage);
    stage->Update();
    CHECK_EQUAL(errors.First(), std::string());
    CHECK_EQUAL(SumOfCounts(stage->GetPolyDataOutput()), 65.0);
  }
  CHECK_EQUAL(FieldNumber(outline->GetPolyDataOutput(), "NumberOfHoles"), 0.0);
  for (vtkHorizonAlgorithm* stage : { static_cast<vtkHorizonAlgorithm*>(mesh),
         static_cast<vtkHorizonAlgorithm*>(decimation), static_cast<vtkHorizonAlgorithm*>(surface) })
  {
    CHECK(std::abs(Area(stage->GetPolyDataOutput()) - 8.0 * 7.0) < 1e-9);
  }
}

/// Amplitudes of 1 at known points, of 1000 at new ones: means of both are 1.
void TestMeans()
{
  vtkNew<vtkHorizonHoleFilling> filling;
  filling->SetInputDataObject(WithHoles());
  filling->Update();
  vtkNew<vtkPolyData> changed;
  changed->DeepCopy(filling->GetPolyDataOutput());
  vtkDataArray* const amplitude = changed->GetPointData()->GetArray("Amplitude");
  for (vtkIdType point = 0; point < changed->GetNumberOfPoints(); ++point)
  {
    amplitude->SetTuple1(point, Value(changed, "Filled", point) > 0.0 ? 1000.0 : 1.0);
  }
  vtkNew<vtkHorizonExteriorBoundary> outline;
  vtkNew<vtkHorizonRoughSimplification> rough;
  outline->SetInputDataObject(changed);
  rough->SetInputConnection(outline->GetOutputPort());
  rough->SetCellSize(3);
  rough->Update();
  vtkPolyData* const output = rough->GetPolyDataOutput();
  CHECK(output->GetNumberOfPoints() < 72);
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    CHECK_EQUAL(Value(output, "Amplitude", point), 1.0);
  }
}

/// A copy whose point is 9 higher, and marked as one of a filled hole.
Data WithFilledPeak(vtkPolyData* data, vtkIdType point)
{
  Data copy = Data::New();
  copy->DeepCopy(data);
  vtkNew<vtkUnsignedCharArray> filled;
  filled->SetName("Filled");
  filled->SetNumberOfTuples(copy->GetNumberOfPoints());
  filled->FillValue(0);
  filled->SetValue(point, 1);
  copy->GetPointData()->AddArray(filled);
  const double* const place = copy->GetPoint(point);
  copy->GetPoints()->SetPoint(point, place[0], place[1], place[2] + 9.0);
  return copy;
}

Data MeshOf(vtkPolyData* horizon)
{
  vtkNew<vtkHorizonExteriorBoundary> outline;
  vtkNew<vtkHorizonTriangulation> mesh;
  outline->SetInputDataObject(horizon);
  mesh->SetInputConnection(outline->GetOutputPort());
  mesh->Update();
  return mesh->GetPolyDataOutput();
}

/// Filled points of either surface count in figures on request only; their own distances are measured in any case.
void TestDistances()
{
  Data flat =
    FromPicture(HorizonFixtures::Rectangle(24, 18), 1, HorizonFixtures::UnitSurvey(), [](int, int) { return 20.0; });
  Data mesh = MeshOf(flat);
  const vtkIdType middle = 9 * 24 + 12;
  for (const auto& [reference, other, from] :
    { std::tuple<Data, Data, int>(WithFilledPeak(flat, middle), mesh, 0), { flat, WithFilledPeak(mesh, middle), 1 } })
  {
    vtkNew<vtkHorizonSurfaceDistance> meter;
    const auto measure = [&, port = from]()
    {
      meter->Update();
      return vtkPolyData::SafeDownCast(meter->GetOutputDataObject(port));
    };
    meter->SetInputDataObject(0, reference);
    meter->SetInputDataObject(1, other);
    vtkPolyData* output = measure();
    CHECK(std::abs(Value(output, "Distance", middle) - 9.0) < 1e-9);
    for (const char* name : { "LargestDistance", "MeanDistance", "RmsDistance", "DistancePercentile99" })
    {
      CHECK(FieldNumber(output, name, from) < 1e-9);
    }
    // The point below the peak is far from it, and known.
    CHECK(FieldNumber(output, "LargestDistance", 1 - from) > 0.5);
    meter->IncludeFilledPointsOn();
    output = measure();
    CHECK(std::abs(FieldNumber(output, "LargestDistance", from) - 9.0) < 1e-9);
    CHECK(FieldNumber(output, "MeanDistance", from) > 0.01);
  }
}

void TestNothingToMeasure()
{
  Data horizon = FromPicture(HorizonFixtures::Rectangle(6, 5), 1, HorizonFixtures::UnitSurvey());
  Data mesh = MeshOf(WithFilledPeak(horizon, 0));
  mesh->GetPointData()->GetArray("Filled")->Fill(1.0);
  vtkNew<vtkHorizonSurfaceDistance> meter;
  HorizonFixtures::Errors errors(meter);
  meter->SetInputDataObject(0, horizon);
  meter->SetInputDataObject(1, mesh);
  meter->Update();
  CHECK(
    errors.FirstContains("mesh: 40 triangles without any area away from points that are left out, expected a surface"));
}
}

int TestHorizonFilledPoints(int, char*[])
{
  TestFollowingStages();
  TestMeans();
  TestDistances();
  TestNothingToMeasure();
  return Check::Result();
}
