// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What all stages have in common: the kinds of input, composite structure, errors, progress and abort.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataSet.h"
#include "vtkHorizonBoundarySimplification.h"
#include "vtkHorizonElaborateSimplification.h"
#include "vtkHorizonExteriorBoundary.h"
#include "vtkHorizonRoughSimplification.h"
#include "vtkHorizonTriangulation.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnstructuredGrid.h"

namespace
{
using HorizonFixtures::Errors;
using HorizonFixtures::FromPicture;
using HorizonFixtures::Rectangle;
using HorizonFixtures::UnitSurvey;

/// The stages from the boundary to the mesh, one after the other.
struct Pipeline
{
  vtkNew<vtkHorizonExteriorBoundary> Boundary;
  vtkNew<vtkHorizonBoundarySimplification> Straight;
  vtkNew<vtkHorizonRoughSimplification> Rough;
  vtkNew<vtkHorizonElaborateSimplification> Elaborate;
  vtkNew<vtkHorizonTriangulation> Mesh;

  explicit Pipeline(vtkDataObject* input)
  {
    this->Boundary->SetInputDataObject(input);
    this->Straight->SetInputConnection(this->Boundary->GetOutputPort());
    this->Rough->SetInputConnection(this->Straight->GetOutputPort());
    this->Elaborate->SetInputConnection(this->Rough->GetOutputPort());
    this->Mesh->SetInputConnection(this->Elaborate->GetOutputPort());
  }

  std::vector<vtkHorizonAlgorithm*> Stages() const
  {
    return { this->Boundary, this->Straight, this->Rough, this->Elaborate, this->Mesh };
  }
};

vtkSmartPointer<vtkPartitionedDataSetCollection> TwoHorizons()
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetPartition(0, 0, FromPicture(Rectangle(12, 10), 4, UnitSurvey()));
  collection->SetPartition(1, 0, FromPicture({ "##.....", "#######", "##.....", "......#" }, 9, UnitSurvey()));
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Horizon 4");
  collection->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "Horizon 9");
  return collection;
}

void TestCompositeKeepsStructureAndNames()
{
  Pipeline pipeline(TwoHorizons());
  pipeline.Mesh->Update();
  auto* const output = vtkPartitionedDataSetCollection::SafeDownCast(pipeline.Mesh->GetOutputDataObject(0));
  if (!CHECK(output != nullptr) || !CHECK_EQUAL(output->GetNumberOfPartitionedDataSets(), 2u))
  {
    return;
  }
  CHECK_EQUAL(std::string(output->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME())), "Horizon 9");
  CHECK(pipeline.Mesh->GetPolyDataOutput() == nullptr);
  // The same as each on its own.
  auto* const first = vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(0, 0));
  Pipeline alone(FromPicture(Rectangle(12, 10), 4, UnitSurvey()));
  alone.Mesh->Update();
  CHECK_EQUAL(first->GetNumberOfPolys(), alone.Mesh->GetPolyDataOutput()->GetNumberOfPolys());
  CHECK(first->GetNumberOfPolys() > 0);
}

void TestMultiBlock()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, FromPicture(Rectangle(5, 5), 1, UnitSurvey()));
  blocks->SetBlock(2, FromPicture(Rectangle(6, 5), 2, UnitSurvey()));
  Pipeline pipeline(blocks);
  pipeline.Mesh->Update();
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(pipeline.Mesh->GetOutputDataObject(0));
  if (CHECK(output != nullptr) && CHECK_EQUAL(output->GetNumberOfBlocks(), 3u))
  {
    CHECK(output->GetBlock(1) == nullptr);
    CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetBlock(2))->GetNumberOfLines(), 1);
  }
}

/// As Threshold, Clip and Merge Blocks make them: grids that are turned back.
void TestUnstructuredGrids()
{
  auto horizon = FromPicture(Rectangle(5, 5), 1, UnitSurvey());
  vtkNew<vtkAppendFilter> toGrid;
  toGrid->SetInputData(horizon);
  toGrid->Update();
  vtkUnstructuredGrid* const grid = toGrid->GetOutput();
  grid->GetFieldData()->PassData(horizon->GetFieldData());
  Pipeline alone(grid);
  alone.Mesh->Update();
  CHECK(alone.Mesh->GetPolyDataOutput() && alone.Mesh->GetPolyDataOutput()->GetNumberOfLines() == 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  Pipeline among(blocks);
  among.Mesh->Update();
  auto* const output = vtkMultiBlockDataSet::SafeDownCast(among.Mesh->GetOutputDataObject(0));
  CHECK(output && vtkPolyData::SafeDownCast(output->GetBlock(0))->GetNumberOfLines() == 1);

  const vtkIdType corners[4] = { 0, 1, 9, 2 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  Pipeline wrong(grid);
  Errors errors(wrong.Boundary);
  wrong.Boundary->Update();
  CHECK(errors.FirstContains("of an unstructured grid is a vtkTetra, expected vertices, lines and polygons"));
  CHECK_EQUAL(wrong.Boundary->GetPolyDataOutput()->GetNumberOfPoints(), 0);
}

void TestEmptyInputGivesEmptyOutput()
{
  vtkNew<vtkPolyData> empty;
  Pipeline pipeline(empty);
  pipeline.Mesh->Update();
  CHECK_EQUAL(pipeline.Mesh->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPartitionedDataSetCollection> nothing;
  Pipeline none(nothing);
  none.Mesh->Update();
  CHECK(none.Mesh->GetOutputDataObject(0)->IsA("vtkPartitionedDataSetCollection"));
}

/// The kind of output follows the input when that changes.
void TestInputMayChangeItsKind()
{
  Pipeline pipeline(TwoHorizons());
  pipeline.Mesh->Update();
  pipeline.Boundary->SetInputDataObject(FromPicture(Rectangle(5, 5), 1, UnitSurvey()));
  pipeline.Mesh->Update();
  CHECK(pipeline.Mesh->GetPolyDataOutput() != nullptr);
}

void TestOneBadHorizonLeavesNoHalfResult()
{
  auto horizons = TwoHorizons();
  auto* const second = vtkPolyData::SafeDownCast(horizons->GetPartitionAsDataObject(1, 0));
  second->GetPoints()->SetPoint(3, second->GetPoint(2));
  Pipeline pipeline(horizons);
  Errors errors(pipeline.Boundary);
  pipeline.Boundary->Update();
  CHECK_EQUAL(errors.Count(), 1u);
  CHECK(errors.FirstContains("Horizon 9: points 2 and 3 both in column"));
  CHECK_EQUAL(pipeline.Boundary->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
}

void TestOneBadHorizonLeftOut()
{
  auto horizons = TwoHorizons();
  auto* const second = vtkPolyData::SafeDownCast(horizons->GetPartitionAsDataObject(1, 0));
  second->GetPoints()->SetPoint(3, second->GetPoint(2));
  Pipeline pipeline(horizons);
  for (vtkHorizonAlgorithm* stage : pipeline.Stages())
  {
    stage->SetInvalidHorizonsToLeaveOut();
  }
  const Errors warnings(pipeline.Boundary, vtkCommand::WarningEvent);
  const Errors errors(pipeline.Mesh);
  pipeline.Mesh->Update();
  CHECK_EQUAL(errors.Count(), 0u);
  CHECK_EQUAL(warnings.Count(), 1u);
  CHECK(warnings.FirstContains("Horizon 9 is left out: points 2 and 3 both in column"));
  auto* const output = vtkPartitionedDataSetCollection::SafeDownCast(pipeline.Mesh->GetOutputDataObject(0));
  CHECK(vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(0, 0))->GetNumberOfPolys() > 0);
  CHECK_EQUAL(vtkPolyData::SafeDownCast(output->GetPartitionAsDataObject(1, 0))->GetNumberOfPoints(), 0);
}

/// Scaled and mirrored as by Transform: the lattice in the field data does not fit any more.
void TestMovedPoints()
{
  for (const double scale : { 10.0, 0.1, -1.0, 1.0 })
  {
    auto horizon =
      FromPicture(Rectangle(12, 10), 4, UnitSurvey(), [](int i, int j) { return double((i * i + j) % 40); });
    for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
    {
      const double* const place = horizon->GetPoint(point);
      horizon->GetPoints()->SetPoint(point, place[0], place[1], scale * place[2]);
    }
    Pipeline pipeline(horizon);
    Errors errors(pipeline.Boundary);
    pipeline.Boundary->Update();
    CHECK_EQUAL(errors.Count(), scale == 1.0 ? 0u : 1u);
    CHECK(scale == 1.0 || errors.FirstContains("lattice units for each vertical index, expected 1: where points were"));
  }
}

/// Runs a stage on an input and checks its one error and that its output is empty.
void CheckRefused(vtkHorizonAlgorithm* stage, vtkDataObject* input, const std::string& message)
{
  Errors errors(stage);
  stage->SetInputDataObject(input);
  stage->Update();
  if (CHECK_EQUAL(errors.Count(), 1u) && !CHECK(errors.FirstContains(message)))
  {
    std::cerr << "expected \"" << message << "\", found: " << errors.First();
  }
  CHECK_EQUAL(stage->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
}

void TestWrongInput()
{
  const Pipeline pipeline(nullptr);
  for (vtkHorizonAlgorithm* stage : pipeline.Stages())
  {
    auto noLattice = FromPicture(Rectangle(3, 3), 1, UnitSurvey());
    noLattice->GetFieldData()->RemoveArray("LatticeToWorld");
    CheckRefused(stage, noLattice, "Horizon 1: no field data array LatticeToWorld, expected 16 values");

    auto shortSize = FromPicture(Rectangle(3, 3), 1, UnitSurvey());
    shortSize->GetFieldData()->GetArray("LatticeDimensions")->SetNumberOfTuples(0);
    CheckRefused(stage, shortSize, "0 values in the field data array LatticeDimensions, expected 3");

    auto offLattice = FromPicture(Rectangle(3, 3), 1, UnitSurvey());
    offLattice->GetPoints()->SetPoint(4, 7.0, 1.0, 20.0);
    CheckRefused(stage, offLattice, "point 4 at column (7, 1), height 20, expected a place on the lattice of 3 x 3");

    vtkNew<vtkMultiBlockDataSet> images;
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 1);
    images->SetBlock(0, image);
    CheckRefused(stage, images, "a vtkImageData in the composite dataset, expected only vtkPolyData");
  }
}

/// Points far apart along a diagonal: whatever is done about empty bands, they span more columns than any memory has.
/// Not under the address sanitizer, which ends a program that asks for so much.
void TestNotEnoughMemory()
{
#ifndef __SANITIZE_ADDRESS__
  const int count = 400000;
  const int dimensions[3] = { 600 * count, 600 * count, 1 };
  auto input = FromPicture({ "#" }, 1, UnitSurvey());
  HorizonFixtures::AddLattice(input, dimensions, UnitSurvey());
  input->GetPointData()->Initialize();
  input->GetPoints()->SetNumberOfPoints(count);
  for (vtkIdType n = 0; n < count; ++n)
  {
    input->GetPoints()->SetPoint(n, double(600 * n), double(600 * n), 0);
  }
  vtkNew<vtkHorizonExteriorBoundary> boundary;
  CheckRefused(boundary, input, "not enough memory, expected a horizon whose bounding box has fewer columns");
#endif
}

void TestMissingBoundary()
{
  vtkNew<vtkHorizonBoundarySimplification> straight;
  vtkNew<vtkHorizonRoughSimplification> rough;
  vtkNew<vtkHorizonTriangulation> mesh;
  auto bare = FromPicture(Rectangle(3, 3), 1, UnitSurvey());
  CheckRefused(straight, bare, "no boundary loops, expected a closed polyline around each patch");
  CheckRefused(rough, bare, "no point array PatchId");
  vtkNew<vtkHorizonElaborateSimplification> elaborate;
  CheckRefused(elaborate, bare, "no point array PatchId");
  CheckRefused(mesh, bare, "no point array PatchId");

  vtkNew<vtkHorizonExteriorBoundary> boundary;
  boundary->SetInputDataObject(bare);
  boundary->Update();
  auto open = vtkSmartPointer<vtkPolyData>::New();
  open->DeepCopy(boundary->GetPolyDataOutput());
  const vtkIdType line[3] = { 0, 1, 2 };
  open->GetLines()->InsertNextCell(3, line);
  CheckRefused(mesh, open, "line 1 with 3 points that is not closed, expected only boundary loops");

  auto pairs = vtkSmartPointer<vtkPolyData>::New();
  pairs->DeepCopy(boundary->GetPolyDataOutput());
  vtkDataArray* const patches = pairs->GetPointData()->GetArray("PatchId");
  patches->SetNumberOfComponents(3);
  patches->SetNumberOfTuples(pairs->GetNumberOfPoints());
  CheckRefused(mesh, pairs, "point array PatchId with 3 components, expected 1");
}

void TestInputIsNotChanged()
{
  auto input = FromPicture(Rectangle(9, 9), 1, UnitSurvey());
  const vtkMTimeType before = input->GetMTime();
  Pipeline pipeline(input);
  pipeline.Mesh->Update();
  CHECK_EQUAL(input->GetMTime(), before);
  CHECK_EQUAL(input->GetPointData()->GetNumberOfArrays(), 3);
  CHECK_EQUAL(pipeline.Boundary->GetPolyDataOutput()->GetNumberOfPoints(), 81);
}

/// Watches the progress of a stage, which must never go back, and stops it at a chosen part. The pipeline itself
/// reports 1 at the end.
struct Watcher
{
  double Last = 0.0;
  int Reports = 0;
  bool Back = false;
  double StopAt = 2.0;
  int ReportsAfterStop = 0;

  static void OnProgress(vtkObject* caller, unsigned long, void* data, void*)
  {
    auto* const self = static_cast<Watcher*>(data);
    auto* const stage = static_cast<vtkAlgorithm*>(caller);
    self->Back = self->Back || stage->GetProgress() < self->Last;
    self->Last = stage->GetProgress();
    ++self->Reports;
    self->ReportsAfterStop += stage->GetAbortExecute() && self->Last < 1.0 ? 1 : 0;
    if (self->Last >= self->StopAt)
    {
      stage->SetAbortExecute(1);
    }
  }

  void Watch(vtkAlgorithm* stage)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(OnProgress);
    command->SetClientData(this);
    stage->AddObserver(vtkCommand::ProgressEvent, command);
  }
};

void TestProgressAndAbort()
{
  Pipeline pipeline(TwoHorizons());
  for (vtkHorizonAlgorithm* stage : pipeline.Stages())
  {
    Watcher watcher;
    watcher.Watch(stage);
    stage->Update();
    CHECK(watcher.Reports >= 3);
    CHECK(!watcher.Back);
    CHECK(stage->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) > 0);
    stage->RemoveAllObservers();

    Watcher stopper;
    stopper.StopAt = 0.3;
    stopper.Watch(stage);
    stage->Modified();
    stage->Update();
    CHECK(stage->GetAbortExecute() != 0);
    CHECK_EQUAL(stopper.ReportsAfterStop, 0);
    CHECK_EQUAL(stage->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
    stage->RemoveAllObservers();

    // And it runs again when asked to.
    stage->SetAbortExecute(0);
    stage->Modified();
    stage->Update();
    CHECK(stage->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) > 0);
  }
}
}

int TestHorizonAlgorithm(int, char*[])
{
  TestCompositeKeepsStructureAndNames();
  TestMultiBlock();
  TestUnstructuredGrids();
  TestEmptyInputGivesEmptyOutput();
  TestInputMayChangeItsKind();
  TestOneBadHorizonLeavesNoHalfResult();
  TestOneBadHorizonLeftOut();
  TestMovedPoints();
  TestWrongInput();
  TestNotEnoughMemory();
  TestMissingBoundary();
  TestInputIsNotChanged();
  TestProgressAndAbort();
  return Check::Result();
}
