// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files, when it makes a volume: where its voxels lie, what they hold, and what is refused.

#include "ReaderFixtures.h"
#include "Tools/Check.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVerneySparseMatrixReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using namespace ReaderFixtures;

namespace
{
// 4 x 3 x 100 cells. Horizon 2 has two voxels in column (1, 0).
constexpr const char* Small = "4 3 100\n"
                              "30 2 1.5 10 112.5\n"
                              "35 2 2 -20 117.5 31 2 2.5 5 113.5 8 7 1 1 84\n"
                              "\n"
                              "\n"
                              "\n"
                              "32 2 4 16.25 114\n"
                              "9 7 1 -8 87\n"
                              "\n"
                              "\n"
                              "\n"
                              "12 7 3 0.5 90\n"
                              "\n";

/// The folder for files of this test.
std::string Folder;

std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}

using Extent = std::array<int, 6>;

vtkImageData* GetVolume(Reader* reader)
{
  return vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
}

Extent ExtentOf(Reader* reader)
{
  Extent extent;
  GetVolume(reader)->GetExtent(extent.data());
  return extent;
}

vtkIntArray* GetIds(Reader* reader)
{
  vtkImageData* const volume = GetVolume(reader);
  return GetArray<vtkIntArray>(volume->GetPointData(), "SurfaceId", volume->GetNumberOfPoints(), 1);
}

/// How many points have that surface ID.
vtkIdType Count(Reader* reader, int id)
{
  vtkIntArray* const ids = GetIds(reader);
  return std::count(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples(), id);
}

/// A reader of the small file whose output is a volume.
vtkSmartPointer<vtkVerneySparseMatrixReader> MakeReader()
{
  auto reader = vtkSmartPointer<vtkVerneySparseMatrixReader>::New();
  reader->SetFileName(WriteFile("small.vsm", Small).c_str());
  reader->SetOutputTypeToVolume();
  return reader;
}

// ---- Where voxels lie --------------------------------------------------------------------------------------------
/// A voxel: x, y and z, surface ID, and amplitude.
using Voxel = std::array<double, 5>;

std::vector<Voxel> ListPoints(vtkVerneySparseMatrixReader* reader)
{
  std::vector<Voxel> voxels;
  reader->SetOutputTypeToPoints();
  reader->Update();
  for (unsigned int position = 0; position < reader->GetOutput()->GetNumberOfPartitionedDataSets(); ++position)
  {
    vtkPolyData* const horizon = GetHorizon(reader, position);
    for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
    {
      double place[3];
      horizon->GetPoint(point, place);
      voxels.push_back(
        { place[0], place[1], place[2], horizon->GetPointData()->GetArray("SurfaceId")->GetComponent(point, 0),
          horizon->GetPointData()->GetArray("Amplitude")->GetComponent(point, 0) });
    }
  }
  return voxels;
}

std::vector<Voxel> ListVoxels(vtkVerneySparseMatrixReader* reader)
{
  std::vector<Voxel> voxels;
  reader->SetOutputTypeToVolume();
  reader->SetVolumeArrayToAmplitude();
  reader->Update();
  vtkImageData* const volume = GetVolume(reader);
  for (vtkIdType point = 0; point < volume->GetNumberOfPoints(); ++point)
  {
    const double id = GetIds(reader)->GetComponent(point, 0);
    const double amplitude = volume->GetPointData()->GetArray("Amplitude")->GetComponent(point, 0);
    if (id != 0.0)
    {
      double place[3];
      volume->GetPoint(point, place);
      voxels.push_back({ place[0], place[1], place[2], id, amplitude });
    }
    CHECK(id != 0.0 || amplitude == 0.0);
  }
  return voxels;
}

/// Whether each point has a voxel of the same ID and amplitude at the same place, and no others are there.
bool AreSame(const std::vector<Voxel>& points, const std::vector<Voxel>& voxels)
{
  const auto isAt = [](const Voxel& point)
  {
    return [&point](const Voxel& voxel)
    {
      const double distance =
        std::max({ std::abs(voxel[0] - point[0]), std::abs(voxel[1] - point[1]), std::abs(voxel[2] - point[2]) });
      return distance < 1e-9 && voxel[3] == point[3] && voxel[4] == point[4];
    };
  };
  return points.size() == voxels.size() &&
    std::all_of(points.begin(), points.end(),
      [&](const Voxel& point) { return std::count_if(voxels.begin(), voxels.end(), isAt(point)) == 1; });
}

/// Whichever way the survey is turned, also as a mirror image, and vertical indices count.
void VoxelsAreWhereThePointsAre()
{
  const auto reader = MakeReader();
  reader->SetOrigin(7000.5, 4000.25, -100.5);
  for (const double angle : { 0.0, 0.3, 2.5, 4.0 })
  {
    for (const double mirror : { 1.0, -1.0 })
    {
      for (const double step : { 4.25, -4.25 })
      {
        for (const int direction : { vtkVerneySparseMatrixReader::Down, vtkVerneySparseMatrixReader::Up })
        {
          reader->SetColumnStep(25.0 * std::cos(angle), 25.0 * std::sin(angle));
          reader->SetRowStep(-mirror * 12.5 * std::sin(angle), mirror * 12.5 * std::cos(angle));
          reader->SetVerticalStep(step);
          reader->SetVerticalDirection(direction);
          const std::vector<Voxel> points = ListPoints(reader);
          CHECK(points.size() == 6);
          CHECK(AreSame(points, ListVoxels(reader)));
          CHECK(std::abs(GetVolume(reader)->GetDirectionMatrix()->Determinant() - 1.0) < 1e-12);
        }
      }
    }
  }
}

/// With the real z of the file in place of the vertical index, points are where it says; voxels stay in their cells, of
/// which the line through all real z says where they are.
void VoxelsStayInTheirCellsWithRealZ()
{
  const auto reader = MakeReader();
  reader->SetElevationToRealZ();
  reader->Update();
  vtkImageData* const volume = GetVolume(reader);
  const double* const toWorld =
    GetArray<vtkDoubleArray>(volume->GetFieldData(), "LatticeToWorld", 1, 16)->GetPointer(0);
  CHECK(toWorld[10] < -0.9 && toWorld[10] > -1.5);
  int indices[3] = { 0, 1, -32 };
  double place[3];
  volume->GetPoint(volume->ComputePointId(indices), place);
  CHECK(std::abs(place[2] - (toWorld[11] + 32 * toWorld[10])) < 1e-9);
  CHECK(GetIds(reader)->GetValue(0) == 0);
  indices[0] = 1;
  CHECK(GetIds(reader)->GetValue(volume->ComputePointId(indices)) == 2);
}

void ExtentIsThatOfTheLattice()
{
  const auto reader = MakeReader();
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 0, 3, 0, 2, -99, 0 }));
  reader->SetVerticalDirectionToUp();
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 0, 3, 0, 2, 0, 99 }));
  reader->SetVolumeExtentToBoundingBox();
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 0, 2, 0, 2, 8, 35 }));
  reader->SetHorizonStatus("Horizon 7", 0);
  reader->SetVerticalDirectionToDown();
  reader->Update();
  CHECK((ExtentOf(reader) == Extent{ 0, 1, 0, 1, -35, -30 }));
  // It is known before the volume is made.
  reader->EnableAllHorizons();
  reader->UpdateInformation();
  vtkInformation* const info = reader->GetOutputInformation(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  CHECK(whole[1] == 2 && whole[4] == -35 && whole[5] == -8);
  CHECK(info->Get(vtkDataObject::SPACING())[0] == 1.0 && info->Get(vtkDataObject::DIRECTION())[8] == 1.0);
}

// ---- What a volume holds -----------------------------------------------------------------------------------------
void ArraysAreComplete()
{
  const auto reader = MakeReader();
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
  const auto reader = MakeReader();
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
  const auto reader = MakeReader();
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
  reader->SetSmallestHorizonSize(2);
  reader->Update();
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
  reader->SetVolumeExtentToWhole();
  reader->Update();
  CHECK(Count(reader, 0) == 1200);
}

void PiecesMakeUpTheVolume()
{
  const auto reader = MakeReader();
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
  const auto reader = MakeReader();
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
  const auto reader = MakeReader();
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
  CHECK(errors.WasOne("missing.vsm: nothing there, expected a file"));
  CHECK(GetVolume(reader)->GetNumberOfPoints() == 0);
}

void AbortLeavesTheOutputEmpty()
{
  const auto reader = MakeReader();
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
  VoxelsAreWhereThePointsAre();
  VoxelsStayInTheirCellsWithRealZ();
  ExtentIsThatOfTheLattice();
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
