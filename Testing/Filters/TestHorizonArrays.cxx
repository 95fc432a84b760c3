// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Point arrays, whichever they are, of fewer or more tuples than there are points: every stage names the array, and
// none reads behind its end.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonDecimation.h"
#include "vtkHorizonDespiking.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonFaults.h"
#include "vtkHorizonHoleFilling.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurface.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonSurfaceJoin.h"
#include "vtkHorizonTriangulation.h"

#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <string>

using namespace HorizonFixtures;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

constexpr int Size = 20;

Data Bounded()
{
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(FromPicture(Rectangle(Size, Size), 1, UnitSurvey()));
  boundary->Update();
  return boundary->GetPolyDataOutput();
}

template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, vtkIdType size)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(size);
  for (vtkIdType n = 0; n < size; ++n)
  {
    array->SetVariantValue(n, 0);
  }
  return array;
}

Data With(vtkPolyData* horizon, vtkAbstractArray* array)
{
  Data spoiled = Data::New();
  spoiled->ShallowCopy(horizon);
  spoiled->GetPointData()->AddArray(array);
  return spoiled;
}

void CheckRefused(vtkAlgorithm* stage, const std::string& message)
{
  Errors errors(stage);
  stage->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  if (!CHECK(errors.FirstContains(message)))
  {
    std::cerr << stage->GetClassName() << ": expected \"" << message << "\", found: " << errors.First() << '\n';
  }
  auto* const output = vtkPolyData::SafeDownCast(stage->GetOutputDataObject(0));
  CHECK(!output || output->GetNumberOfPoints() == 0);
}

template <typename Stage>
void CheckStage()
{
  const Data horizon = Bounded();
  const auto check = [&](vtkAbstractArray* array)
  {
    vtkNew<Stage> stage;
    stage->SetInputDataObject(With(horizon, array));
    CheckRefused(stage,
      "array " + std::string(array->GetName()) + " of " + std::to_string(array->GetNumberOfTuples()) +
        " tuples, expected one for each of the 400 points");
  };
  for (const vtkIdType size : { 0, 1, 399, 401 })
  {
    check(MakeArray<vtkDoubleArray>("Mine", size));
    check(MakeArray<vtkStringArray>("Text", size));
    check(MakeArray<vtkUnsignedCharArray>("vtkGhostType", size));
  }
}

void TestStages()
{
  CheckStage<vtkHorizonDespiking>();
  CheckStage<vtkHorizonFaults>();
  CheckStage<vtkHorizonHoleFilling>();
  CheckStage<vtkHorizonExteriorBoundary>();
  CheckStage<vtkHorizonBoundarySimplification>();
  CheckStage<vtkHorizonRoughSimplification>();
  CheckStage<vtkHorizonElaborateSimplification>();
  CheckStage<vtkHorizonDecimation>();
  CheckStage<vtkHorizonTriangulation>();
  CheckStage<vtkHorizonSurface>();
}

void TestSurfaceDistance()
{
  const Data horizon = Bounded();
  const Data spoiled = With(horizon, MakeArray<vtkUnsignedCharArray>("vtkGhostType", 0));
  for (const bool isMesh : { false, true })
  {
    vtkNew<vtkHorizonSurfaceDistance> distance;
    distance->SetInputDataObject(0, isMesh ? horizon : spoiled);
    distance->SetInputDataObject(1, isMesh ? spoiled : horizon);
    CheckRefused(distance, std::string(isMesh ? "mesh" : "reference") + ": array vtkGhostType of 0 tuples");
  }
}

/// Only the horizon whose array does not fit is left out, where that is wanted.
void TestOneOfSeveral()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, With(Bounded(), MakeArray<vtkDoubleArray>("Mine", 1)));
  blocks->SetBlock(1, Bounded());
  vtkNew<vtkHorizonTriangulation> triangulation;
  triangulation->SetInputDataObject(blocks);
  triangulation->SetInvalidHorizonsToLeaveOut();
  Errors warnings(triangulation, vtkCommand::WarningEvent);
  triangulation->Update();
  CHECK(warnings.FirstContains("array Mine of 1 tuples"));
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(triangulation->GetOutputDataObject(0));
  CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetBlock(0))->GetNumberOfPoints(), 0);
  CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetBlock(1))->GetNumberOfPoints(), 400);
}

/// Which points are hidden is one number for each.
void TestGhostsOfTwoNumbers()
{
  const auto ghosts = MakeArray<vtkUnsignedCharArray>("vtkGhostType", 800);
  ghosts->SetNumberOfComponents(2);
  ghosts->SetNumberOfTuples(400);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(With(Bounded(), ghosts));
  CheckRefused(boundary, "point array vtkGhostType with 2 components, expected 1");
}

/// VTK puts partitions together by their arrays.
void TestPartitions()
{
  const auto horizon = FromPicture(Rectangle(Size, Size), 1, UnitSurvey());
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, horizon);
  partitions->SetPartition(1, With(horizon, MakeArray<vtkDoubleArray>("Amplitude", 0)));
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(partitions);
  CheckRefused(boundary, "array Amplitude of 0 tuples, expected one for each of the 400 points");
}

/// Of cells, those arrays that are read.
void TestCells()
{
  vtkNew<vtkHorizonSurface> surface;
  surface->SetInputDataObject(FromPicture(Rectangle(Size, Size), 1, UnitSurvey()));
  surface->SetSeamRows(-1, -1);
  surface->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(surface->GetPolyDataOutput());
  const auto seams = MakeArray<vtkIntArray>("SeamRows", 2);
  seams->FillValue(-1); // none
  mesh->GetFieldData()->AddArray(seams);
  mesh->GetCellData()->AddArray(MakeArray<vtkDoubleArray>("Error", 0));
  vtkNew<vtkHorizonSurfaceJoin> join;
  join->SetInputDataObject(mesh);
  CheckRefused(join,
    "array Error of 0 tuples, expected one for each of the " + std::to_string(mesh->GetNumberOfCells()) + " cells");
  mesh->GetPointData()->AddArray(MakeArray<vtkUnsignedCharArray>("SeamGap", 0));
  vtkNew<vtkHorizonSurfaceJoin> again;
  again->SetInputDataObject(mesh);
  CheckRefused(again, "array SeamGap of 0 tuples, expected one for each of the");
  mesh->GetFieldData()->AddArray(MakeArray<vtkIntArray>("SeamRows", 0));
  vtkNew<vtkHorizonSurfaceJoin> none;
  none->SetInputDataObject(mesh);
  CheckRefused(none, "a mesh without the field data array SeamRows");

  vtkNew<vtkPolyData> lines;
  lines->ShallowCopy(Bounded());
  lines->GetCellData()->AddArray(MakeArray<vtkStringArray>("FaultName", 0));
  vtkNew<vtkHorizonFaults> faults;
  faults->SetInputDataObject(0, FromPicture(Rectangle(Size, Size), 1, UnitSurvey()));
  faults->SetInputDataObject(1, lines);
  CheckRefused(faults, "array FaultName of 0 tuples, expected one for each of the");
}
}

int TestHorizonArrays(int, char*[])
{
  TestStages();
  TestSurfaceDistance();
  TestOneOfSeveral();
  TestGhostsOfTwoNumbers();
  TestPartitions();
  TestCells();
  return Check::Result();
}
