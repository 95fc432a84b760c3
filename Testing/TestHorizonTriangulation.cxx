// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Check.h"
#include "HorizonFixtures.h"

#include "vtkCell.h"
#include "vtkFeatureEdges.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonTriangulation.h"
#include "vtkMath.h"
#include "vtkTriangle.h"

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
}

int TestHorizonTriangulation(int, char*[])
{
  for (const bool simplify : { false, true })
  {
    TestMesh(HorizonFixtures::UnitSurvey(), simplify);
    TestMesh(HorizonFixtures::RotatedSurvey(), simplify);
    TestMesh(MirroredSurvey(), simplify);
  }
  return Check::Result();
}
