// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What others make of horizons between the stages: arrays of the wrong length or type, ids of points that are not
// there, hidden points, partitions, a stage applied twice, attributes with gaps. Each is done right, or refused.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonSurfaceDistance.h"
#include "vtkHorizonTriangulation.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkLongLongArray.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace HorizonFixtures;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

Data Square(int size)
{
  return FromPicture(Rectangle(size, size), 1, UnitSurvey());
}

template <typename Stage>
Data Apply(vtkDataObject* input)
{
  vtkNew<Stage> stage;
  stage->SetInputDataObject(input);
  stage->Update();
  Data result = Data::New();
  result->ShallowCopy(stage->GetPolyDataOutput());
  return result;
}

Data Bounded(int size)
{
  return Apply<vtkHorizonExteriorBoundary>(Square(size));
}

double Figure(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

template <typename Array, typename Value>
void SetPointArray(vtkPolyData* horizon, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Value& value : values)
  {
    array->InsertNextValue(value);
  }
  horizon->GetPointData()->RemoveArray(name);
  horizon->GetPointData()->AddArray(array);
}

/// Each stage that works inside a boundary gives one error that has the text, and an empty output.
void CheckAllRefuse(const std::function<void(vtkPolyData*)>& spoil, const std::string& message)
{
  vtkNew<vtkHorizonRoughSimplification> rough;
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  vtkNew<vtkHorizonTriangulation> triangulation;
  for (vtkHorizonAlgorithm* stage : std::vector<vtkHorizonAlgorithm*>{ rough, elaborate, triangulation })
  {
    const Data horizon = Bounded(9);
    spoil(horizon);
    Errors errors(stage);
    stage->SetInputDataObject(horizon);
    stage->Update();
    CHECK_EQUAL(errors.Count(), 1u);
    if (!CHECK(errors.FirstContains(message)))
    {
      std::cerr << "expected \"" << message << "\", found: " << errors.First();
    }
    CHECK_EQUAL(stage->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  }
}

void TestWrongIdsInLines()
{
  for (const vtkIdType id : { vtkIdType(100000000), vtkIdType(-7), (vtkIdType(1) << 33) + 3 })
  {
    CheckAllRefuse(
      [id](vtkPolyData* horizon)
      {
        vtkNew<vtkCellArray> lines;
        const vtkIdType ids[4] = { 0, id, 10, 0 };
        lines->InsertNextCell(4, ids);
        horizon->SetLines(lines);
      },
      "point id " + std::to_string(id) + " in line 0, expected 0 to 80");
  }
}

void TestWrongPointArrays()
{
  CheckAllRefuse([](vtkPolyData* horizon) { SetPointArray<vtkIntArray>(horizon, "PatchId", std::vector<int>(3, 0)); },
    "array PatchId of 3 tuples, expected one for each of the 81 points");
  CheckAllRefuse([](vtkPolyData* horizon)
    { SetPointArray<vtkStringArray>(horizon, "PatchId", std::vector<std::string>(81, "0")); },
    "an array PatchId of type string, expected numbers");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CheckAllRefuse([nan](vtkPolyData* horizon)
    { SetPointArray<vtkDoubleArray>(horizon, "PatchId", std::vector<double>(81, nan)); },
    "PatchId nan at point 0, expected a whole number of 32 bits");
  CheckAllRefuse([](vtkPolyData* horizon)
    { SetPointArray<vtkLongLongArray>(horizon, "PatchId", std::vector<long long>(81, 1LL << 32)); },
    "PatchId 4294967296 at point 0, expected a whole number of 32 bits");
}

void TestWrongCounts()
{
  const auto refuse = [](const std::vector<long long>& counts, const std::string& message)
  {
    const Data horizon = Bounded(9);
    SetPointArray<vtkLongLongArray>(horizon, "PointCount", counts);
    vtkNew<vtkHorizonRoughSimplification> rough;
    Errors errors(rough);
    rough->SetInputDataObject(horizon);
    rough->Update();
    CHECK(errors.FirstContains(message));
  };
  refuse({ 1, 1, 1 }, "array PointCount of 3 tuples, expected one for each of the 81 points");
  refuse(std::vector<long long>(81, -3), "PointCount -3 at point 0, expected no negative numbers");
  refuse(std::vector<long long>(81, 1LL << 40),
    "PointCount 1099511627776 at point 0, expected no negative numbers, and "
    "at most 2^32 in all");
}

void TestWrongDimensions()
{
  const auto refuse = [](vtkAbstractArray* dimensions, const std::string& message)
  {
    const Data horizon = Square(3);
    dimensions->SetName("LatticeDimensions");
    horizon->GetFieldData()->RemoveArray("LatticeDimensions");
    horizon->GetFieldData()->AddArray(dimensions);
    vtkNew<vtkHorizonExteriorBoundary> boundary;
    Errors errors(boundary);
    boundary->SetInputDataObject(horizon);
    boundary->Update();
    CHECK_EQUAL(errors.Count(), 1u);
    CHECK(errors.FirstContains(message));
  };
  for (const double wrong : { std::numeric_limits<double>::quiet_NaN(), 1e30, 3.5 })
  {
    vtkNew<vtkDoubleArray> dimensions;
    for (const double value : { wrong, 3.0, 64.0 })
    {
      dimensions->InsertNextValue(value);
    }
    refuse(dimensions, "cells along an axis, expected a whole number of 32 bits");
  }
  vtkNew<vtkIntArray> largest;
  for (const int value : { std::numeric_limits<int>::max(), 3, 64 })
  {
    largest->InsertNextValue(value);
  }
  refuse(largest, "expected at least 1 and less than 2^28 columns a side");
  vtkNew<vtkStringArray> texts;
  texts->InsertNextValue("3");
  refuse(texts, "an array LatticeDimensions of type string, expected numbers");
}

/// Figures of a stage before must not win over those of the stage.
void TestStageTwice()
{
  const Data plain = FromPicture({ "#####", "#...#", "#...#", "#####" }, 1, UnitSurvey());
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(Apply<vtkHorizonExteriorBoundary>(plain));
  boundary->KeepHolesOn();
  boundary->Update();
  CHECK_EQUAL(Figure(boundary->GetOutputDataObject(0), "NumberOfHoles"), 1.0);
  const Data fine = Apply<vtkHorizonTriangulation>(Bounded(9));
  const Data coarse = Apply<vtkHorizonTriangulation>(Apply<vtkHorizonRoughSimplification>(Bounded(9)));
  vtkNew<vtkPolyData> points; // of the mesh, with its figures
  points->ShallowCopy(fine);
  points->SetPolys(nullptr);
  points->GetCellData()->Initialize(); // which has figures of the triangles
  const Data coarseOfFine = Apply<vtkHorizonTriangulation>(Apply<vtkHorizonRoughSimplification>(points));
  CHECK(Figure(fine, "TriangleCount") > Figure(coarse, "TriangleCount"));
  CHECK_EQUAL(Figure(coarseOfFine, "TriangleCount"), Figure(coarse, "TriangleCount"));
}

/// The horizon without the middle column, once with the point left out and once with it hidden.
void TestHiddenPoints()
{
  const Data hidden = Square(3);
  std::vector<unsigned char> ghosts(9, 0);
  ghosts[4] = vtkDataSetAttributes::HIDDENPOINT;
  SetPointArray<vtkUnsignedCharArray>(hidden, vtkDataSetAttributes::GhostArrayName(), ghosts);
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(hidden);
  boundary->KeepHolesOn();
  boundary->Update();
  const Data found = boundary->GetPolyDataOutput();
  CHECK_EQUAL(found->GetNumberOfPoints(), 8);
  CHECK_EQUAL(Figure(found, "NumberOfHoles"), 1.0);
  CHECK(!found->GetPointData()->HasArray(vtkDataSetAttributes::GhostArrayName()));
  CHECK_EQUAL(found->GetPointData()->GetArray("Amplitude")->GetComponent(4, 0), 102.0);

  CheckAllRefuse(
    [](vtkPolyData* horizon)
    {
      std::vector<unsigned char> marks(81, 0);
      marks[40] = vtkDataSetAttributes::HIDDENPOINT;
      SetPointArray<vtkUnsignedCharArray>(horizon, vtkDataSetAttributes::GhostArrayName(), marks);
    },
    "1 points hidden by the array vtkGhostType");
}

/// The points of a horizon in two partitions, as Redistribute Data Set deals them out.
vtkSmartPointer<vtkPartitionedDataSetCollection> Dealt(vtkPolyData* first, vtkPolyData* second)
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(1, first);
  partitions->SetPartition(2, second);
  collection->SetPartitionedDataSet(0, partitions);
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Horizon 1");
  return collection;
}

void TestPartitions()
{
  const Data left = FromPicture({ "##..", "##.." }, 1, UnitSurvey());
  const Data right = FromPicture({ "..##", "..##" }, 1, UnitSurvey());
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(Dealt(left, right));
  boundary->Update();
  auto* const output = vtkPartitionedDataSetCollection::SafeDownCast(boundary->GetOutputDataObject(0));
  CHECK_EQUAL(output->GetNumberOfPartitionedDataSets(), 1u);
  auto* const whole = vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(0, 1));
  CHECK_EQUAL(whole->GetNumberOfPoints(), 8);
  CHECK_EQUAL(whole->GetNumberOfLines(), 1);
  CHECK_EQUAL(Figure(whole, "NumberOfPatches"), 1.0);
  CHECK(output->GetPartitionAsDataObject(0, 2) == nullptr);

  vtkNew<vtkHorizonTriangulation> triangulation;
  Errors errors(triangulation);
  triangulation->SetInputDataObject(Dealt(Bounded(3), Bounded(3)));
  triangulation->Update();
  CHECK(errors.FirstContains("Horizon 1 with outlines or triangles in 2 partitions, expected one partition"));
}

/// One value that is missing must not spread over its cell; names of components and kinds of attributes stay.
void TestAttributes()
{
  const Data horizon = Bounded(7);
  vtkDataArray* const amplitude = horizon->GetPointData()->GetArray("Amplitude");
  const vtkIdType middle = 24;
  amplitude->SetComponent(middle, 0, std::numeric_limits<double>::quiet_NaN());
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Slope");
  vectors->SetNumberOfComponents(2);
  vectors->SetComponentName(0, "Inline");
  vectors->SetComponentName(1, "Crossline");
  vectors->SetNumberOfTuples(49);
  vectors->Fill(1.0);
  horizon->GetPointData()->AddArray(vectors);
  horizon->GetPointData()->SetActiveScalars("Amplitude");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfTuples(49);
  ids->FillValue(0);
  horizon->GetPointData()->SetGlobalIds(ids);

  vtkNew<vtkHorizonRoughSimplification> rough;
  rough->SetCellSize(3);
  rough->SetInputDataObject(horizon);
  rough->Update();
  vtkPointData* const data = rough->GetPolyDataOutput()->GetPointData();
  for (vtkIdType point = 0; point < data->GetNumberOfTuples(); ++point)
  {
    CHECK(std::isfinite(data->GetArray("Amplitude")->GetComponent(point, 0)));
  }
  CHECK_EQUAL(std::string(data->GetArray("Slope")->GetComponentName(1)), "Crossline");
  CHECK_EQUAL(std::string(data->GetArray("CellOrigin")->GetComponentName(2)), "Kind");
  CHECK(data->GetGlobalIds() == data->GetAbstractArray("Ids"));
  const Data again = Apply<vtkHorizonElaborateSimplification>(rough->GetPolyDataOutput());
  CHECK_EQUAL(std::string(again->GetPointData()->GetArray("CellOrigin")->GetComponentName(2)), "Kind");
}

std::string ActiveScalars(vtkPolyData* horizon)
{
  vtkDataArray* const scalars = horizon->GetPointData()->GetScalars();
  return scalars ? scalars->GetName() : "none";
}

/// What windows colour by at first sight: patches on outlines, heights on points and meshes.
void TestActiveScalars()
{
  const Data bounded = Bounded(9);
  CHECK_EQUAL(ActiveScalars(bounded), "PatchId");
  const Data straight = Apply<vtkHorizonBoundarySimplification>(bounded);
  CHECK_EQUAL(ActiveScalars(straight), "PatchId");
  CHECK_EQUAL(ActiveScalars(Apply<vtkHorizonRoughSimplification>(straight)), "VerticalIndex");
  CHECK_EQUAL(ActiveScalars(Apply<vtkHorizonElaborateSimplification>(straight)), "VerticalIndex");
  const Data mesh = Apply<vtkHorizonTriangulation>(straight);
  CHECK_EQUAL(ActiveScalars(mesh), "VerticalIndex");
  vtkNew<vtkHorizonSurfaceDistance> distance;
  distance->SetInputDataObject(0, mesh);
  distance->SetInputDataObject(1, mesh);
  distance->Update();
  CHECK_EQUAL(ActiveScalars(vtkPolyData::SafeDownCast(distance->GetOutputDataObject(1))), "Distance");
  bounded->GetPointData()->RemoveArray("VerticalIndex");
  CHECK_EQUAL(ActiveScalars(Apply<vtkHorizonTriangulation>(bounded)), "PatchId");
}

/// Nothing is left of a horizon all of whose points are hidden, in whatever stage.
void TestAllPointsHidden()
{
  const Data hidden = Square(3);
  SetPointArray<vtkUnsignedCharArray>(
    hidden, vtkDataSetAttributes::GhostArrayName(), std::vector<unsigned char>(9, vtkDataSetAttributes::HIDDENPOINT));
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  vtkNew<vtkHorizonTriangulation> triangulation;
  for (vtkHorizonAlgorithm* stage : std::vector<vtkHorizonAlgorithm*>{ boundary, triangulation })
  {
    const Errors warnings(stage, vtkCommand::WarningEvent);
    stage->SetInputDataObject(hidden);
    stage->Update();
    CHECK_EQUAL(warnings.Count(), 1u);
    CHECK(
      warnings.FirstContains("Horizon 1: all 9 points are hidden by the array vtkGhostType, so that nothing is left"));
    CHECK_EQUAL(stage->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  }
}

void TestNoPatchIsLargeEnough()
{
  const Data square = Square(3);
  vtkNew<vtkPartitionedDataSetCollection> named;
  named->SetPartition(0, 0, square);
  named->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Top");
  for (vtkDataObject* const input : { static_cast<vtkDataObject*>(square), static_cast<vtkDataObject*>(named) })
  {
    vtkNew<vtkHorizonExteriorBoundary> boundary;
    const Errors warnings(boundary, vtkCommand::WarningEvent);
    boundary->SetInputDataObject(input);
    boundary->SetMinimumPatchSize(10);
    boundary->Update();
    CHECK(warnings.FirstContains(std::string(input == square ? "Horizon 1" : "Top") +
      ": none of the 9 points is in a patch of MinimumPatchSize, 10 points, or more"));
  }
}

/// Points that were filled in count for no voxel. Among themselves their attributes are averaged all the same.
void TestCountsOfZero()
{
  const Data horizon = Bounded(9);
  SetPointArray<vtkLongLongArray>(horizon, "PointCount", std::vector<long long>(81, 0));
  const Data rough = Apply<vtkHorizonRoughSimplification>(horizon);
  for (vtkIdType point = 0; point < rough->GetNumberOfPoints(); ++point)
  {
    CHECK(std::isfinite(rough->GetPointData()->GetArray("Amplitude")->GetComponent(point, 0)));
    CHECK_EQUAL(rough->GetPointData()->GetArray("PointCount")->GetComponent(point, 0), 0.0);
  }
}
}

int TestHorizonInputs(int, char*[])
{
  TestWrongIdsInLines();
  TestWrongPointArrays();
  TestWrongCounts();
  TestWrongDimensions();
  TestStageTwice();
  TestHiddenPoints();
  TestPartitions();
  TestAttributes();
  TestCountsOfZero();
  TestActiveScalars();
  TestAllPointsHidden();
  TestNoPatchIsLargeEnough();
  return Check::Result();
}
