// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Real horizons for tests: files of lines "i j z" after comments and one line of sizes, in subfolders of the folder
// that the environment variable SEISMICHORIZONS_REAL_DATA names.

#ifndef SeismicHorizonsRealHorizons_h
#define SeismicHorizonsRealHorizons_h

#include "Patches.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace RealHorizons
{
/// The files, in a fixed order; none when there is no such folder.
inline std::vector<std::filesystem::path> Files()
{
  const char* const folder = std::getenv("SEISMICHORIZONS_REAL_DATA");
  std::vector<std::filesystem::path> files;
  if (folder && std::filesystem::is_directory(folder))
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
      if (entry.path().extension() == ".ijz")
      {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Adds the heights where asked for.
inline Patches::Columns Read(const std::filesystem::path& file, std::vector<double>* heights = nullptr)
{
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line) && !line.empty() && line.front() == '#')
  {
  }
  Patches::Columns columns;
  SeismicHorizons::PlanePoint column;
  double z = 0.0;
  while (stream >> column.X >> column.Y >> z)
  {
    columns.push_back(column);
    if (heights)
    {
      heights->push_back(z);
    }
  }
  return columns;
}
}

#endif
