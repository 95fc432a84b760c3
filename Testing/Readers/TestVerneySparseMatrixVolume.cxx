// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files, when it makes a volume: what it holds, and what is refused.

#include "Tools/Check.h"
#include "VolumeFixtures.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVerneySparseMatrixReader.h"

#include <filesystem>
#include <string>

using namespace VolumeFixtures;

namespace
{
/// The folder for files of this test.
std::string Folder;

std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}

// ---- What a volume holds -----------------------------------------------------------------------------------------
void ArraysAreComplete()
{
  const auto reader = MakeReader(Folder);
  reader->Update();
  CHECK(!reader->GetOutput());
  vtkPointData* data = GetVolume(reader)->GetPointData();
  CHECK(data->GetNumberOfArrays() == 1 && data->GetScalars() == data->GetArray("SurfaceId"));
  CHECK(Count(reader, 2) == 3 && Count(reader, 7) == 3 && Count(reader, 0) == 1200 - 6);
  vtkFieldData* const fields = GetVolume(reader)->GetFieldData();
  CHECK(GetArray<vtkIntArray>(fields, "LatticeDimensions", 1, 3)->GetValue(2) == 100);
  CHECK(GetArray<vtkIntArray>(fields, "VerticalDirection", 1, 1)->GetValue(0) == -1);
  CHECK(GetArray<vtkIdTypeArray>(fields, "DroppedDuplicates", 1, 1)->GetValue(0) == 1);
  for (const char* name : { "Amplitude", "Thickness" })
  {
    reader->SetVolumeArray(
      name[0] == 'A' ? vtkVerneySparseMatrixReader::Amplitude : vtkVerneySparseMatrixReader::Thickness);
    reader->Update();
    data = GetVolume(reader)->GetPointData();
    CHECK(data->GetNumberOfArrays() == 2 && data->GetScalars() == data->GetArray(name));
    int indices[3] = { 1, 1, -32 };
    const vtkIdType point = GetVolume(reader)->ComputePointId(indices);
    CHECK(GetArray<vtkFloatArray>(data, name, 1200, 1)->GetValue(point) == (name[0] == 'A' ? 16.25f : 4.0f));
    CHECK(GetArray<vtkFloatArray>(data, name, 1200, 1)->GetValue(0) == 0.0f);
    CHECK(GetIds(reader)->GetValue(point) == 2);
  }
}

void BackgroundCanBeChosen()
{
  const auto reader = MakeReader(Folder);
  Messages errors(reader);
  reader->SetBackgroundValue(-5);
  reader->Update();
  CHECK(Count(reader, -5) == 1200 - 6 && Count(reader, 2) == 3);
  reader->SetBackgroundValue(7);
  reader->Update();
  CHECK(errors.WasOne("): BackgroundValue 7, which is the ID of a horizon that is loaded, expected another number"));
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
  reader->SetHorizonStatus("Horizon 7", 0); // then it is not loaded
  reader->Update();
  CHECK(errors.Number() == 0 && Count(reader, 7) == 1200 - 3);
}

void ChoicesAreObeyed()
{
  const auto reader = MakeReader(Folder);
  reader->SetColumnRange(1, 1);
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 0, 3, 0, 2, -99, 0 }));
  CHECK(Count(reader, 2) == 2 && Count(reader, 7) == 1);
  reader->SetVolumeExtentToBoundingBox();
  reader->SetRowRange(0, 0);
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 1, 1, 0, 0, -35, -8 }));
  CHECK(Count(reader, 2) == 1 && Count(reader, 7) == 1 && Count(reader, 0) == 26);
  reader->SetDuplicatePolicyToTopmost();
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 1, 1, 0, 0, -31, -8 }));
  Messages errors(reader);
  reader->SetSmallestHorizonSize(2);
  reader->Update();
  CHECK(errors.WasOne("small.vsm: no points, expected those of a horizon"));
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
}

void PiecesMakeUpTheVolume()
{
  const auto reader = MakeReader(Folder);
  vtkIdType points = 0;
  vtkIdType voxels = 0;
  for (int piece = 0; piece < 4; ++piece)
  {
    reader->UpdatePiece(piece, 4, 0);
    points += GetVolume(reader)->GetNumberOfPoints();
    voxels += Count(reader, 2) + Count(reader, 7);
  }
  CHECK(points > 1200 && points < 2 * 1200); // they share what lies between them
  CHECK(voxels >= 6);
  reader->UpdatePiece(0, 1, 0);
  CHECK(Count(reader, 0) == 1200 - 6);
  reader->Modified();
  const Extent part = { 1, 1, 0, 2, -40, -30 };
  reader->UpdateExtent(part.data());
  CHECK(ExtentOf(reader) == part && Count(reader, 2) == 2 && Count(reader, 7) == 0);
}

void TypeOfTheOutputFollows()
{
  const auto reader = MakeReader(Folder);
  for (int round = 0; round < 2; ++round)
  {
    reader->SetOutputTypeToVolume();
    reader->Update();
    CHECK(GetVolume(reader) && GetVolume(reader)->GetNumberOfPoints() == 1200);
    reader->SetOutputTypeToImages();
    reader->Update();
    CHECK(reader->GetOutput() && vtkImageData::SafeDownCast(reader->GetOutput()->GetPartitionAsDataObject(1, 0)));
    reader->SetOutputTypeToPoints();
    reader->Update();
    CHECK(reader->GetOutput() && GetHorizon(reader, 1)->GetNumberOfPoints() == 3);
    CHECK(!reader->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  }
}

// ---- What is refused ---------------------------------------------------------------------------------------------
void LargeVolumesAreRefused()
{
  vtkNew<vtkVerneySparseMatrixReader> reader;
  Messages errors(reader);
  reader->SetFileName(WriteFile("cube.vsm", "1 1 1048576\n5 3 1 1 1 1048575 3 1 1 1\n").c_str());
  reader->SetOutputTypeToVolume();
  reader->SetVolumeMemoryLimit(4);
  reader->Update();
  CHECK(errors.Number() == 0 && GetVolume(reader)->GetNumberOfPoints() == 1048576);
  reader->SetVolumeArrayToThickness();
  reader->Update();
  CHECK(
    errors.WasOne("): a volume of 1 x 1 x 1048576 points that takes 8 MB, expected at most VolumeMemoryLimit, 4 MB"));
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
  reader->SetVolumeExtentToBoundingBox();
  reader->Update();
  CHECK(errors.Number() == 0 && GetVolume(reader)->GetNumberOfPoints() == 1);
  // More than the numbers of points that there are.
  reader->SetVolumeExtentToWhole();
  reader->SetFileName(WriteFile("endless.vsm", "2 1 2147483647\n5 3 1 1 1\n\n").c_str());
  reader->Update();
  CHECK(errors.WasOne("a volume of 2 x 1 x 2147483647 points that takes 32768 MB, expected at most"));
}

void WrongParametersAreRefused()
{
  const auto reader = MakeReader(Folder);
  Messages errors(reader);
  reader->SetRowStep(0.5, 1.0);
  reader->Update();
  CHECK(errors.WasOne("ColumnStep and RowStep that are not perpendicular, expected perpendicular ones for volumes"));
  reader->SetRowStep(1.0, 0.0);
  reader->Update();
  CHECK(errors.WasOne("ColumnStep (1, 0) and RowStep (1, 0), expected finite vectors that are not parallel"));
  reader->SetRowStep(0.0, 1.0);
  reader->SetVolumeMemoryLimit(0);
  reader->Update();
  CHECK(errors.WasOne("VolumeMemoryLimit 0, expected at least 1 MB"));
  reader->SetVolumeMemoryLimit(1);
  reader->SetFileName(WriteFile("huge.vsm", "1 2 9\n\n4 3 1 1e39 1\n").c_str());
  reader->Update();
  CHECK(errors.Number() == 0 && Count(reader, 3) == 1); // nobody asked for it
  reader->SetVolumeArrayToAmplitude();
  reader->Update();
  CHECK(errors.WasOne("): Amplitude 1e+39 at (0, 1, 4), expected at most 3.40282e+38 for volumes"));
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
  reader->SetFileName((Folder + "/missing.vsm").c_str());
  reader->Update();
  CHECK(errors.WasOne("missing.vsm: no such file"));
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
}

void AbortLeavesTheOutputEmpty()
{
  const auto reader = MakeReader(Folder);
  Messages errors(reader);
  reader->UpdateInformation(); // so that the volume alone is left to be made
  vtkNew<vtkCallbackCommand> aborter;
  aborter->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkVerneySparseMatrixReader::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, aborter);
  reader->Update();
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0 && errors.Number() == 0);
  reader->RemoveObserver(tag);
  reader->SetAbortExecute(0);
  reader->Modified();
  reader->Update();
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 1200);
}
}

int TestVerneySparseMatrixVolume(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixVolume");
  ArraysAreComplete();
  BackgroundCanBeChosen();
  ChoicesAreObeyed();
  PiecesMakeUpTheVolume();
  TypeOfTheOutputFollows();
  LargeVolumesAreRefused();
  WrongParametersAreRefused();
  AbortLeavesTheOutputEmpty();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
