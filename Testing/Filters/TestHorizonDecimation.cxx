// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The filter around the decimation: targets and their units, what comes out, errors. Meshes are checked in
// TestDecimation.

#include "Common/Horizon/MeshChecker.h"
#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonTriangulation.h"

#include <cmath>
#include <sstream>

namespace
{
using HorizonFixtures::Errors;

double Wavy(int i, int j)
{
  return std::round(20.0 + 6.0 * std::sin(0.35 * i) * std::cos(0.3 * j));
}

/// A horizon of 30 by 24 columns, straightened, then decimated.
struct Pipeline
{
  vtkNew<vtkHorizonExteriorBoundary> Boundary;
  vtkNew<vtkHorizonBoundarySimplification> Straight;
  vtkNew<vtkHorizonDecimation> Mesh;

  explicit Pipeline(vtkMatrix4x4* survey)
  {
    this->Boundary->SetInputData(HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(30, 24), 7, survey, Wavy));
    this->Straight->SetInputConnection(this->Boundary->GetOutputPort());
    this->Mesh->SetInputConnection(this->Straight->GetOutputPort());
    this->Mesh->SetMaximumError(0.75);
  }

  vtkPolyData* Update()
  {
    this->Mesh->Update();
    return this->Mesh->GetPolyDataOutput();
  }
};

double Figure(vtkPolyData* mesh, const char* name)
{
  return mesh->GetFieldData()->GetArray(name)->GetTuple1(0);
}

void TestOutput()
{
  Pipeline pipeline(HorizonFixtures::RotatedSurvey());
  vtkPolyData* const mesh = pipeline.Update();
  const vtkIdType triangles = mesh->GetNumberOfPolys();
  CHECK(triangles > 50 && triangles < 700);
  CHECK_EQUAL(mesh->GetNumberOfVerts(), 0);
  CHECK_EQUAL(mesh->GetNumberOfLines(), 1);
  CHECK_EQUAL(Figure(mesh, "TriangleCount"), double(triangles));
  CHECK(Figure(mesh, "LargestError") <= 0.75 + 1e-9);
  CHECK(Figure(mesh, "MeanError") > 0.0 && Figure(mesh, "MeanError") < Figure(mesh, "LargestError"));
  CHECK(Figure(mesh, "SmallestAngle") > 0.0);
  CHECK(std::isnan(mesh->GetCellData()->GetArray("Error")->GetTuple1(0)));
  double range[2];
  mesh->GetCellData()->GetArray("Error")->GetRange(range);
  CHECK_EQUAL(range[1], Figure(mesh, "LargestError"));
  CHECK_EQUAL(mesh->GetCellData()->GetArray("Quality")->GetNumberOfTuples(), triangles + 1);
  // Every point represents some of the input; facing up in a world with depth downwards.
  double count = 0.0;
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    count += mesh->GetPointData()->GetArray("PointCount")->GetTuple1(point);
  }
  CHECK_EQUAL(count, 30.0 * 24.0);
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  mesh->GetPolys()->GetCellAtId(0, size, corners);
  double a[3];
  double b[3];
  double c[3];
  mesh->GetPoint(corners[0], a);
  mesh->GetPoint(corners[1], b);
  mesh->GetPoint(corners[2], c);
  CHECK((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0);
}

/// The distance, which shares no code with the decimation, finds no vertex of the input farther away.
void TestBoundByDistance()
{
  Pipeline pipeline(HorizonFixtures::UnitSurvey());
  pipeline.Mesh->SetMaximumError(1.5);
  vtkPolyData* const mesh = pipeline.Update();
  vtkNew<vtkHorizonSurfaceDistance> distance;
  distance->SetInputConnection(0, pipeline.Straight->GetOutputPort());
  distance->SetInputData(1, mesh);
  distance->Update();
  double range[2];
  vtkPolyData::SafeDownCast(distance->GetOutputDataObject(0))
    ->GetPointData()
    ->GetArray("VerticalDistance")
    ->GetRange(range);
  CHECK(range[0] >= -1.5 - 1e-9 && range[1] <= 1.5 + 1e-9);
  CHECK(std::max(-range[0], range[1]) > 1.0);
}

void TestTargets()
{
  // Steps of 4 world units downwards.
  Pipeline pipeline(HorizonFixtures::RotatedSurvey());
  pipeline.Mesh->SetMaximumError(1.25);
  const vtkIdType points = pipeline.Update()->GetNumberOfPoints();
  pipeline.Mesh->SetErrorUnitToWorld();
  pipeline.Mesh->SetMaximumError(5.0);
  CHECK_EQUAL(pipeline.Update()->GetNumberOfPoints(), points);
  pipeline.Mesh->SetErrorUnitToDiagonal();
  pipeline.Mesh->SetMaximumError(1.25 / std::sqrt(29.0 * 29.0 + 23.0 * 23.0 + 12.0 * 12.0));
  CHECK_EQUAL(pipeline.Update()->GetNumberOfPoints(), points);
  pipeline.Mesh->SetTargetToNumberOfPoints();
  pipeline.Mesh->SetMaximumNumberOfPoints(150);
  CHECK_EQUAL(pipeline.Update()->GetNumberOfPoints(), 150);
  pipeline.Mesh->SetTargetToReduction();
  pipeline.Mesh->SetTargetReduction(0.5);
  const vtkIdType input = pipeline.Straight->GetPolyDataOutput()->GetNumberOfPoints();
  CHECK_EQUAL(pipeline.Update()->GetNumberOfPoints(), (input + 1) / 2);
  // Loops are kept.
  pipeline.Mesh->SetTargetReduction(1.0);
  CHECK_EQUAL(
    pipeline.Update()->GetNumberOfPoints(), pipeline.Straight->GetPolyDataOutput()->GetLines()->GetCellSize(0) - 1);
}

/// The best effort takes fewer points for the error; each of its parameters has an effect.
void TestEffort()
{
  Pipeline pipeline(HorizonFixtures::UnitSurvey());
  const vtkIdType best = pipeline.Update()->GetNumberOfPoints();
  pipeline.Mesh->SetSmallestAngle(40.0);
  CHECK(pipeline.Update()->GetNumberOfPoints() > best);
  pipeline.Mesh->SetEffortToFast();
  CHECK(pipeline.Update()->GetNumberOfPoints() > best);
  pipeline.Mesh->SetTargetToNumberOfPoints();
  pipeline.Mesh->SetMaximumNumberOfPoints(140);
  for (const bool isBest : { false, true })
  {
    pipeline.Mesh->SetEffort(isBest ? vtkHorizonDecimation::Best : vtkHorizonDecimation::Fast);
    pipeline.Mesh->SetPriorityToSumOfSquares();
    const double mean = Figure(pipeline.Update(), "MeanError");
    pipeline.Mesh->SetPriorityToLargestErrors();
    CHECK(Figure(pipeline.Update(), "MeanError") != mean);
    const vtkIdType points = pipeline.Mesh->GetPolyDataOutput()->GetNumberOfPoints();
    CHECK(points <= 140 && points >= (isBest ? 137 : 140));
  }
}

void CheckRefused(Pipeline& pipeline, const std::string& message)
{
  Errors errors(pipeline.Mesh);
  pipeline.Mesh->Modified();
  CHECK_EQUAL(pipeline.Update()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(errors.Count(), 1u);
  if (!CHECK(errors.FirstContains("Horizon 7: " + message)))
  {
    std::cerr << "expected \"" << message << "\", found: " << errors.First();
  }
}

void TestErrors()
{
  Pipeline pipeline(HorizonFixtures::UnitSurvey());
  pipeline.Mesh->SetMaximumError(-2.0);
  CheckRefused(pipeline, "maximum error -2, expected at least 0, or -1 for automatic");
  pipeline.Mesh->SetTargetToNumberOfPoints();
  pipeline.Mesh->SetMaximumNumberOfPoints(0);
  CheckRefused(pipeline, "maximum number of points 0, expected at least 1");
  pipeline.Mesh->SetMaximumNumberOfPoints(5);
  CheckRefused(pipeline, "maximum number of points 5, expected at least the ");
  pipeline.Mesh->SetTargetToReduction();
  pipeline.Mesh->SetTargetReduction(1.5);
  CheckRefused(pipeline, "target reduction 1.5, expected 0 to 1 of the points");
  pipeline.Mesh->SetTargetReduction(0.5);
  pipeline.Mesh->SetSmallestAngle(61.0);
  CheckRefused(pipeline, "smallest angle 61, expected 0 to 60 degrees");
  pipeline.Mesh->SetSmallestAngle(2.0);
  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputConnection(pipeline.Straight->GetOutputPort());
  pipeline.Mesh->SetInputConnection(rough->GetOutputPort());
  CheckRefused(pipeline, "point ");
}

/// The same loop twice, and one inside another that is no hole: surface that is there twice.
void TestDoubledLoops()
{
  Pipeline pipeline(HorizonFixtures::UnitSurvey());
  pipeline.Boundary->Update();
  const auto refuse = [&pipeline](const std::vector<vtkIdType>& loop, int target, const std::string& message)
  {
    vtkNew<vtkPolyData> horizon;
    horizon->DeepCopy(pipeline.Boundary->GetPolyDataOutput());
    horizon->GetLines()->InsertNextCell(vtkIdType(loop.size()), loop.data());
    vtkNew<vtkHorizonDecimation> decimation;
    decimation->SetTarget(target);
    decimation->SetTargetReduction(0.1);
    decimation->SetMaximumError(0.01);
    Errors errors(decimation);
    decimation->SetInputDataObject(horizon);
    decimation->Update();
    CHECK_EQUAL(errors.Count(), 1u);
    CHECK(errors.FirstContains(message));
  };
  vtkNew<vtkIdList> outline;
  pipeline.Boundary->GetPolyDataOutput()->GetLines()->GetCellAtId(0, outline);
  for (const int target : { vtkHorizonDecimation::LargestError, vtkHorizonDecimation::Reduction })
  {
    refuse({ outline->begin(), outline->end() }, target,
      "repeats an edge, expected each edge of a loop once, with the surface to its right");
    refuse({ 40, 41, 40, 41, 40 }, target, "line 1 from point 41 to point 40 repeats an edge");
    // Clockwise. Builds that check meshes stop at the first one.
    refuse({ 155, 455, 465, 165, 155 }, target,
      SeismicHorizons::MeshChecker::IsOn ? "made a wrong mesh"
                                         : "in several triangles, expected loops that enclose it once");
  }
}

/// Points where the mesh is far off that lie outside the loop, where none can be inserted.
void TestPointsOutside()
{
  Pipeline pipeline(HorizonFixtures::UnitSurvey());
  pipeline.Boundary->Update();
  vtkNew<vtkPolyData> horizon;
  horizon->ShallowCopy(pipeline.Boundary->GetPolyDataOutput());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 200, 235, 67, 200 });
  horizon->SetLines(lines);
  vtkNew<vtkHorizonDecimation> decimation;
  decimation->SetMaximumError(0.5);
  Errors errors(decimation);
  decimation->SetInputDataObject(horizon);
  decimation->Update();
  CHECK(errors.FirstContains("point 0 lies outside the boundary of its patch, expected loops around all points"));
}

/// Whole heights: six times what rounding leaves, or somewhat more, as the surface says, too.
void TestAutomaticError()
{
  Pipeline pipeline(HorizonFixtures::RotatedSurvey());
  CHECK(!pipeline.Update()->GetFieldData()->HasArray("ChosenMaximumError"));
  pipeline.Mesh->SetMaximumError(-1.0);
  pipeline.Mesh->SetErrorUnitToWorld(); // counts for nothing
  const double error = Figure(pipeline.Update(), "ChosenMaximumError");
  CHECK(error > 1.73 && error < 4.0);
  const bool isRounding = pipeline.Update()->GetFieldData()->HasArray("HeightRounding");
  CHECK(pipeline.Update()->GetFieldData()->HasArray("HeightNoise") != isRounding);
  CHECK(std::abs(6.0 * Figure(pipeline.Update(), isRounding ? "HeightRounding" : "HeightNoise") - error) < 1e-12);
  CHECK(Figure(pipeline.Update(), "LargestError") <= error + 1e-9);
  CHECK(Figure(pipeline.Update(), "LargestError") > 0.75);
  pipeline.Mesh->SetTargetToNumberOfPoints();
  for (const char* const name : { "ChosenMaximumError", "HeightNoise", "HeightRounding" })
  {
    CHECK(!pipeline.Update()->GetFieldData()->HasArray(name));
  }
}

void TestPrint()
{
  vtkNew<vtkHorizonDecimation> mesh;
  std::ostringstream text;
  mesh->Print(text);
  for (const char* const line : { "Target: LargestError", "MaximumError: -1", "ErrorUnit: Steps",
         "MaximumNumberOfPoints: 10000", "TargetReduction: 0.95", "FitHeights: on", "Effort: Best",
         "Priority: SumOfSquares", "SmallestAngle: 2", "InvalidHorizons: Stop" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonDecimation(int, char*[])
{
  TestOutput();
  TestBoundByDistance();
  TestTargets();
  TestEffort();
  TestErrors();
  TestDoubledLoops();
  TestPointsOutside();
  TestAutomaticError();
  TestPrint();
  return Check::Result();
}
