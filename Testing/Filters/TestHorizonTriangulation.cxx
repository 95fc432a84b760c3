// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkFeatureEdges.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonTriangulation.h"
#include "vtkMath.h"
#include "vtkTriangle.h"

#include <cmath>
#include <sstream>

namespace
{
const std::vector<std::string> Picture = {
  "..########..........",
  ".###########....###.",
  "#############..#####",
  "######.######..#####",
  "#####...#####..#####",
  "######.#######.####.",
  "#############..###..",
  "..##########........",
  "....####............",
};

vtkSmartPointer<vtkMatrix4x4> MirroredSurvey()
{
  auto map = HorizonFixtures::RotatedSurvey();
  map->SetElement(0, 0, -map->GetElement(0, 0));
  map->SetElement(1, 0, -map->GetElement(1, 0));
  return map;
}

/// All triangles face up in the world, mirrored survey or not.
void CheckFacesUp(vtkPolyData* mesh)
{
  for (vtkIdType cell = mesh->GetNumberOfLines(); cell < mesh->GetNumberOfCells(); ++cell)
  {
    double points[3][3];
    double normal[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh->GetPoint(mesh->GetCell(cell)->GetPointId(corner), points[corner]);
    }
    vtkTriangle::ComputeNormal(points[0], points[1], points[2], normal);
    CHECK(normal[2] > 0.0);
  }
}

/// By VTK's own means: no edge has more than two triangles, and the edges with one are the boundary's.
void CheckManifold(vtkPolyData* mesh, vtkIdType boundaryEdges)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOn();
  edges->Update();
  CHECK_EQUAL(edges->GetOutput()->GetNumberOfLines(), 0);
  edges->NonManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  CHECK_EQUAL(edges->GetOutput()->GetNumberOfLines(), boundaryEdges);
}

void TestMesh(vtkMatrix4x4* survey, bool simplify)
{
  auto input = HorizonFixtures::FromPicture(Picture, 1, survey);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(input);
  vtkNew<vtkHorizonBoundarySimplification> straight;
  straight->SetInputConnection(boundary->GetOutputPort());
  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetInputConnection(straight->GetOutputPort());
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputConnection(simplify ? rough->GetOutputPort() : boundary->GetOutputPort());
  mesh->Update();
  vtkPolyData* const output = mesh->GetPolyDataOutput();
  vtkIdType loopPoints = 0;
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    loopPoints += output->GetCell(line)->GetNumberOfPoints() - 1;
  }
  CHECK_EQUAL(output->GetNumberOfLines(), 2);
  CHECK_EQUAL(output->GetNumberOfVerts(), 0);
  // Euler, for two patches without spurs: 2 n - 2 - b triangles each.
  CHECK_EQUAL(output->GetNumberOfPolys(), 2 * output->GetNumberOfPoints() - 4 - loopPoints);
  CheckFacesUp(output);
  CheckManifold(output, loopPoints);
  CHECK(output->GetPointData()->GetArray("Amplitude") != nullptr);
  CHECK(output->GetFieldData()->GetArray("LatticeDimensions") != nullptr);
}

vtkSmartPointer<vtkPolyData> Boundary(vtkPolyData* horizon)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(horizon);
  boundary->Update();
  return boundary->GetPolyDataOutput();
}

/// A square of two by two blocks: eight equal right-angled triangles.
void TestFigures()
{
  auto input =
    Boundary(HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(3, 3), 1, HorizonFixtures::RotatedSurvey()));
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputDataObject(input);
  for (const int strategy : { 0, 1 })
  {
    mesh->SetSearchStrategy(strategy);
    mesh->Update();
    vtkPolyData* const output = mesh->GetPolyDataOutput();
    vtkDataArray* const compactness = output->GetCellData()->GetArray("Compactness");
    vtkDataArray* const quality = output->GetCellData()->GetArray("Quality");
    CHECK_EQUAL(compactness->GetNumberOfTuples(), 9);
    CHECK(std::isnan(compactness->GetTuple1(0)) && std::isnan(quality->GetTuple1(0)));
    for (vtkIdType cell = 1; cell < 9; ++cell)
    {
      CHECK(std::abs(compactness->GetTuple1(cell) - 0.5 * std::sqrt(3.0)) < 1e-7);
      CHECK(std::abs(quality->GetTuple1(cell) - std::sqrt(3.0) / (1.0 + std::sqrt(2.0))) < 1e-7);
    }
    vtkFieldData* const figures = output->GetFieldData();
    CHECK_EQUAL(figures->GetArray("TriangleCount")->GetTuple1(0), 8.0);
    CHECK_EQUAL(figures->GetArray("BoundaryEdgeCount")->GetTuple1(0), 8.0);
    CHECK_EQUAL(figures->GetArray("NonDelaunayEdgeCount")->GetTuple1(0), 0.0);
    CHECK(std::abs(figures->GetArray("SmallestAngle")->GetTuple1(0) - 45.0) < 1e-9);
    CHECK_EQUAL(vtkPolyData::SafeDownCast(mesh->GetOutputDataObject(1))->GetNumberOfCells(), 0);
  }
}

/// Without outlines, bays and gaps are closed.
void TestConvexHull()
{
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputDataObject(HorizonFixtures::FromPicture({ "#.#", "...", "#.#" }, 1, HorizonFixtures::RotatedSurvey()));
  mesh->ConvexHullOn();
  mesh->Update();
  vtkPolyData* const output = mesh->GetPolyDataOutput();
  CHECK_EQUAL(output->GetNumberOfPolys(), 2);
  CHECK_EQUAL(output->GetNumberOfLines(), 1);
  CheckFacesUp(output);
}

/// Of the hull of an L the notch is taken off, on any survey; polylines and figures are those of the mesh that is left.
void TestOutsideTriangles(vtkMatrix4x4* survey)
{
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputDataObject(HorizonFixtures::FromPicture({ "##..", "##..", "####", "####" }, 1, survey));
  mesh->ConvexHullOn();
  const auto check = [&mesh](vtkIdType triangles, vtkIdType boundaryEdges)
  {
    mesh->Update();
    vtkPolyData* const output = mesh->GetPolyDataOutput();
    CHECK_EQUAL(output->GetNumberOfPoints(), 12);
    CHECK_EQUAL(output->GetNumberOfLines(), 1);
    CHECK_EQUAL(output->GetCell(0)->GetNumberOfPoints(), boundaryEdges + 1);
    CHECK_EQUAL(output->GetNumberOfPolys(), triangles);
    CheckFacesUp(output);
    CheckManifold(output, boundaryEdges);
    vtkFieldData* const figures = output->GetFieldData();
    CHECK_EQUAL(vtkIdType(figures->GetArray("TriangleCount")->GetTuple1(0)), triangles);
    CHECK_EQUAL(vtkIdType(figures->GetArray("BoundaryEdgeCount")->GetTuple1(0)), boundaryEdges);
    CHECK_EQUAL(figures->GetArray("NonDelaunayEdgeCount")->GetTuple1(0), 0.0);
    CHECK_EQUAL(output->GetCellData()->GetArray("Compactness")->GetNumberOfTuples(), triangles + 1);
  };
  // Twelve points; nine of them on the hull, and eleven on the outline.
  check(13, 9);
  mesh->SetMaximumBoundaryAngle(100.0);
  check(11, 11);
  mesh->SetMaximumBoundaryAngle(180.0);
  mesh->SetMaximumBoundaryEdgeLength(1.5);
  check(11, 11);
  // To look inside, triangles are left as they are found.
  mesh->SetMaximumNumberOfTriangles(1000);
  mesh->Update();
  CHECK_EQUAL(mesh->GetPolyDataOutput()->GetNumberOfPolys(), 13);
}

void TestLimitsAreChecked()
{
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputDataObject(HorizonFixtures::FromPicture({ "#.", "##" }, 7, HorizonFixtures::UnitSurvey()));
  mesh->ConvexHullOn();
  const auto check = [&mesh](const std::string& message)
  {
    const HorizonFixtures::Errors errors(mesh);
    mesh->Update();
    CHECK_EQUAL(errors.Count(), 1u);
    CHECK(errors.FirstContains("Horizon 7: " + message));
    CHECK_EQUAL(mesh->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  };
  mesh->SetMaximumBoundaryAngle(200.0);
  check("boundary angle 200, expected 0 to 180 degrees");
  mesh->SetMaximumBoundaryAngle(90.0);
  mesh->SetMaximumBoundaryEdgeLength(-1.0);
  check("boundary edge length -1, expected at least 0 lattice units");
}

void TestSearchIsShown()
{
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetInputDataObject(
    Boundary(HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(6, 5), 1, HorizonFixtures::RotatedSurvey())));
  mesh->SetMaximumNumberOfTriangles(7);
  mesh->Update();
  CHECK_EQUAL(mesh->GetPolyDataOutput()->GetNumberOfPolys(), 7);
  auto* const walk = vtkPolyData::SafeDownCast(mesh->GetOutputDataObject(1));
  CHECK(walk->GetNumberOfPolys() > 0);
  CHECK_EQUAL(walk->GetCellData()->GetArray("Dilatation")->GetTuple1(0), 0.0);
  double bounds[6];
  double all[6];
  walk->GetBounds(bounds);
  mesh->GetPolyDataOutput()->GetBounds(all);
  CHECK(bounds[0] >= all[0] - 100.0 && bounds[1] <= all[1] + 100.0);
}

void TestPrint()
{
  vtkNew<vtkHorizonTriangulation> mesh;
  mesh->SetSearchStrategyToCompactness();
  mesh->ConvexHullOn();
  mesh->SetMaximumBoundaryAngle(95.5);
  mesh->SetMaximumBoundaryEdgeLength(2.5);
  mesh->SetMaximumNumberOfTriangles(12);
  std::ostringstream text;
  mesh->Print(text);
  for (const char* line : { "SearchStrategy: Compactness", "ConvexHull: on", "MaximumBoundaryAngle: 95.5",
         "MaximumBoundaryEdgeLength: 2.5", "MaximumNumberOfTriangles: 12" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}
}

int TestHorizonTriangulation(int, char*[])
{
  for (const bool simplify : { false, true })
  {
    TestMesh(HorizonFixtures::UnitSurvey(), simplify);
    TestMesh(HorizonFixtures::RotatedSurvey(), simplify);
    TestMesh(MirroredSurvey(), simplify);
  }
  TestFigures();
  TestConvexHull();
  TestOutsideTriangles(HorizonFixtures::UnitSurvey());
  TestOutsideTriangles(HorizonFixtures::RotatedSurvey());
  TestOutsideTriangles(MirroredSurvey());
  TestLimitsAreChecked();
  TestSearchIsShown();
  TestPrint();
  return Check::Result();
}
