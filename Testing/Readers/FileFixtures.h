// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files for the tests of readers and writers.

#ifndef SeismicHorizonsFileFixtures_h
#define SeismicHorizonsFileFixtures_h

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkTestUtilities.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace FileFixtures
{
/// Takes over a text that VTK has allocated.
inline std::string TakeString(char* text)
{
  const std::unique_ptr<char[]> taken(text);
  return text ? text : "";
}

/// An empty folder of that name for files of a test.
inline std::string MakeFolder(int argc, char* argv[], const std::string& name)
{
  const std::string folder =
    TakeString(vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary")) + '/' +
    name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

inline std::string ReadText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

inline vtkPolyData* GetHorizon(vtkPartitionedDataSetCollection* horizons, unsigned int position)
{
  return vtkPolyData::SafeDownCast(horizons->GetPartition(position, 0));
}

inline std::string GetName(vtkPartitionedDataSetCollection* horizons, unsigned int position)
{
  const char* const name = horizons->GetMetaData(position)->Get(vtkCompositeDataSet::NAME());
  return name ? name : "";
}
}

#endif
