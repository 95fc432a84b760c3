// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What stages tell of the horizons that they have worked on.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCompositeDataSet.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonTriangulation.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <string>

namespace
{
using namespace HorizonFixtures;

vtkSmartPointer<vtkPartitionedDataSetCollection> TwoHorizons()
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetPartition(0, 0, FromPicture(Rectangle(12, 10), 4, UnitSurvey()));
  collection->SetPartition(1, 0, FromPicture({ "##.....", "#######", "##.....", "......#" }, 9, UnitSurvey()));
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Top");
  collection->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "Base");
  return collection;
}

void TestTwoStages()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  vtkNew<vtkHorizonTriangulation> mesh;
  boundary->SetInputDataObject(TwoHorizons());
  mesh->SetInputConnection(boundary->GetOutputPort());
  CHECK_EQUAL(std::string(boundary->GetResults()), "");
  mesh->Update();
  CHECK_EQUAL(std::string(boundary->GetResults()),
    "2 horizons: 132 points in, 132 out\n"
    "Top: 120 points in, 120 out\n"
    "  patches 1\n"
    "  columns known 120, area 120\n"
    "Base: 12 points in, 12 out\n"
    "  patches 2\n"
    "  columns known 7, area 7\n"
    "  columns left out 5, area 5\n"
    "  warning: 41.67 % of the points left out\n");
  // Figures of the stage before are not told again; those that are 0 are not either.
  const std::string results = mesh->GetResults();
  CHECK(
    results.find("\nTop: 120 points in, 120 out\n  triangles 198\n  smallest angle 45 degrees\n") != std::string::npos);
  CHECK(results.find("patches") == std::string::npos);
}

void TestHorizonAlone()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(FromPicture(Rectangle(3, 2), 4, UnitSurvey()));
  boundary->Update();
  CHECK_EQUAL(
    std::string(boundary->GetResults()), "Horizon 4: 6 points in, 6 out\n  patches 1\n  columns known 6, area 6\n");
  boundary->SetRadius(0);
  const Errors errors(boundary);
  boundary->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK_EQUAL(std::string(boundary->GetResults()), "");
}

void TestManyHorizons()
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned int n = 0; n < 53; ++n)
  {
    collection->SetPartition(n, 0, FromPicture(Rectangle(3, 2), 4, UnitSurvey()));
  }
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(collection);
  boundary->Update();
  const std::string results = boundary->GetResults();
  CHECK_EQUAL(results.substr(0, results.find('\n')), "53 horizons: 318 points in, 318 out");
  CHECK(results.find("\nand 3 more\n") != std::string::npos);
}
}

int TestHorizonResults(int, char*[])
{
  TestTwoStages();
  TestHorizonAlone();
  TestManyHorizons();
  return Check::Result();
}
