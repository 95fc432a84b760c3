// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of sparse-matrix files, when it makes a volume: where its voxels lie in the world and on the lattice.

#include "Tools/Check.h"
#include "VolumeFixtures.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace VolumeFixtures;

namespace
{
/// The folder for files of this test.
std::string Folder;

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
  const auto reader = MakeReader(Folder);
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
  const auto reader = MakeReader(Folder);
  reader->SetZFromToRealZ();
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
  const auto reader = MakeReader(Folder);
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
}

int TestVerneySparseMatrixVolumePlace(int argc, char* argv[])
{
  Folder = MakeFolder(argc, argv, "TestVerneySparseMatrixVolumePlace");
  VoxelsAreWhereThePointsAre();
  VoxelsStayInTheirCellsWithRealZ();
  ExtentIsThatOfTheLattice();
  std::filesystem::remove_all(Folder);
  return Check::Result();
}
