// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parameters out of their range: nothing is silently brought into it, and one error says what was expected.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonTriangulation.h"

#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The outlines of a horizon, or for distances its mesh.
vtkSmartPointer<vtkPolyData> InputOf(vtkAlgorithm* stage)
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  vtkNew<vtkHorizonTriangulation> mesh;
  boundary->SetInputData(
    HorizonFixtures::FromPicture(HorizonFixtures::Rectangle(9, 9), 3, HorizonFixtures::UnitSurvey()));
  mesh->SetInputConnection(boundary->GetOutputPort());
  mesh->Update();
  return stage->IsA("vtkHorizonSurfaceDistance") ? mesh->GetPolyDataOutput() : boundary->GetPolyDataOutput();
}

/// Runs a stage of that class after set(stage, value).
template <typename Stage, typename Value>
void CheckRefused(void (Stage::*set)(Value), double value, const std::string& message)
{
  vtkNew<Stage> stage;
  (stage->*set)(static_cast<Value>(value));
  for (int port = 0; port < stage->GetNumberOfInputPorts(); ++port)
  {
    stage->SetInputDataObject(port, InputOf(stage));
  }
  HorizonFixtures::Errors errors(stage);
  stage->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  if (!CHECK(errors.FirstContains("Horizon 3: " + message)))
  {
    std::cerr << "expected \"" << message << "\", found: " << errors.First();
  }
  CHECK_EQUAL(stage->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
}
}

int TestHorizonParameters(int, char*[])
{
  using Boundary = vtkHorizonExteriorBoundary;
  CheckRefused(&Boundary::SetRadius, 0, "radius 0, expected 1 to 32 columns");
  CheckRefused(&Boundary::SetSmallestHoleSize, 0, "smallest hole size 0, expected at least 1 column");
  CheckRefused(&Boundary::SetSmallestHoleArea, -1, "smallest hole area -1, expected at least 0 square units");
  CheckRefused(
    &Boundary::SetSmallestHoleArea, Infinity, "smallest hole area inf, expected a finite number, at least 0");
  CheckRefused(&Boundary::SetMinimumPatchSize, -2, "minimum patch size -2, expected at least 1 point");
  using Straight = vtkHorizonBoundarySimplification;
  CheckRefused(&Straight::SetDistanceThreshold, -0.5, "distance threshold -0.5, expected at least 0 lattice units");
  CheckRefused(&Straight::SetOutlineTolerance, Infinity, "outline tolerance inf, expected a finite number, at least 0");
  using Elaborate = vtkHorizonElaborateSimplification;
  CheckRefused<vtkHorizonRoughSimplification, int>(
    &vtkHorizonRoughSimplification::SetCellSize, 0, "cell size 0, expected at least 1 column");
  CheckRefused(&Elaborate::SetFlatnessThreshold, Infinity, "flatness threshold inf, expected a finite number");
  CheckRefused(&Elaborate::SetGrowthPerRing, 0.5, "growth per ring 0.5, expected at least 1 (cells as");
  CheckRefused(&Elaborate::SetSmallestCellSize, 0.5, "smallest cell size 0.5, expected at least 1 column");
  CheckRefused(
    &Elaborate::SetSmallestCellSize, Infinity, "smallest cell size inf, expected a finite number, at least 1");
  using Triangulation = vtkHorizonTriangulation;
  CheckRefused(&Triangulation::SetMaximumNumberOfTriangles, -3, "maximum number of triangles -3, expected at least 0");
  using Distance = vtkHorizonSurfaceDistance;
  CheckRefused(&Distance::SetSamplesPerPoint, 0, "samples per point 0, expected 0.01 to 1000");
  CheckRefused(&Distance::SetSamplesPerPoint, std::nan(""), "samples per point nan, expected 0.01 to 1000");
  CheckRefused(&Distance::SetSeed, -1, "seed -1, expected at least 0");
  return Check::Result();
}
