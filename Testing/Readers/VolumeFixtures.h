// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tests of volumes share: a file, its reader, and the volume that it makes.

#ifndef SeismicHorizonsVolumeFixtures_h
#define SeismicHorizonsVolumeFixtures_h

#include "ReaderFixtures.h"

#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkVerneySparseMatrixReader.h"

#include <algorithm>
#include <array>
#include <string>

namespace VolumeFixtures
{
using namespace ReaderFixtures;

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

using Extent = std::array<int, 6>;

inline vtkImageData* GetVolume(Reader* reader)
{
  return vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
}

inline Extent ExtentOf(Reader* reader)
{
  Extent extent;
  GetVolume(reader)->GetExtent(extent.data());
  return extent;
}

inline vtkIntArray* GetIds(Reader* reader)
{
  vtkImageData* const volume = GetVolume(reader);
  return GetArray<vtkIntArray>(volume->GetPointData(), "SurfaceId", volume->GetNumberOfPoints(), 1);
}

/// How many points have that surface ID.
inline vtkIdType Count(Reader* reader, int id)
{
  vtkIntArray* const ids = GetIds(reader);
  return std::count(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples(), id);
}

/// A reader of the small file whose output is a volume.
inline vtkSmartPointer<vtkVerneySparseMatrixReader> MakeReader(const std::string& folder)
{
  auto reader = vtkSmartPointer<vtkVerneySparseMatrixReader>::New();
  reader->SetFileName(WriteText(folder + "/small.vsm", Small).c_str());
  reader->SetOutputTypeToVolume();
  return reader;
}
}

#endif
