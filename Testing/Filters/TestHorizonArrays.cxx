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
#include "vtkHorizonTriangulation.h"

#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

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
  vtkNew<vtkPolyData> lines;
  lines->ShallowCopy(Bounded());
  lines->GetCellData()->AddArray(MakeArray<vtkStringArray>("FaultName", 0));
  vtkNew<vtkHorizonFaults> faults;
  faults->SetInputDataObject(0, FromPicture(Rectangle(Size, Size), 1, UnitSurvey()));
  faults->SetInputDataObject(1, lines);
  CheckRefused(faults, "array FaultName of 0 tuples, expected one for each of the");
}

/// Ranges that come with large arrays are those that VTK finds in a copy, whatever the values are.
void TestRanges()
{
  const auto horizon = FromPicture(Rectangle(400, 300), 1, HorizonFixtures::RotatedSurvey());
  const auto add = [&](const char* name, double strange)
  {
    const auto array = MakeArray<vtkDoubleArray>(name, 400 * 300);
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
    {
      array->SetValue(n, n % 7001 == 5 ? strange : double(n % 913) - 400.25);
    }
    horizon->GetPointData()->AddArray(array);
  };
  add("Finite", 1e200);
  add("Missing", std::nan(""));
  add("Infinite", -std::numeric_limits<double>::infinity());
  const auto integers = MakeArray<vtkIntArray>("Whole", 400 * 300);
  std::iota(integers->GetPointer(0), integers->GetPointer(0) + 400 * 300, -77);
  horizon->GetPointData()->AddArray(integers);
  vtkNew<vtkHorizonDespiking> despiking;
  despiking->SetInputDataObject(horizon);
  despiking->SetActionToFlag();
  despiking->Update();
  vtkPolyData* const output = despiking->GetPolyDataOutput();
  std::vector<vtkDataArray*> arrays = { output->GetPoints()->GetData() };
  for (int n = 0; n < output->GetPointData()->GetNumberOfArrays(); ++n)
  {
    arrays.push_back(output->GetPointData()->GetArray(n));
  }
  CHECK(arrays.size() >= 9);
  for (vtkDataArray* const array : arrays)
  {
    const auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->SetNumberOfTuples(array->GetNumberOfTuples());
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
    {
      copy->SetTuple(n, n, array);
    }
    for (int component = -1; component < array->GetNumberOfComponents(); ++component)
    {
      double found[4], expected[4];
      array->GetRange(found, component);
      array->GetFiniteRange(found + 2, component);
      copy->GetRange(expected, component);
      copy->GetFiniteRange(expected + 2, component);
      CHECK(std::equal(found, found + 4, expected));
    }
  }
  double before[2], after[2];
  integers->GetRange(before, 0);
  integers->SetValue(0, -9000);
  integers->Modified();
  integers->GetRange(after, 0);
  CHECK(before[0] == -77.0 && after[0] == -9000.0);
}
}

int TestHorizonArrays(int, char*[])
{
  TestRanges();
  TestStages();
  TestSurfaceDistance();
  TestOneOfSeveral();
  TestGhostsOfTwoNumbers();
  TestPartitions();
  TestCells();
  return Check::Result();
}
