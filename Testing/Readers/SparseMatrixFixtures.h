// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tests of the reader of sparse-matrix files share: a small file, and a folder for files.

#ifndef SeismicHorizonsSparseMatrixFixtures_h
#define SeismicHorizonsSparseMatrixFixtures_h

#include "ReaderFixtures.h"

#include <string>

namespace SparseMatrixFixtures
{
using namespace ReaderFixtures;

// Horizon 2 has two voxels in its first column.
constexpr const char* Small = "2 2 10\n"
                              "3 2 1.5 10 12.5 5 2 2.5 -20 20.5 8 7 1 1 32\n"
                              "4 2 1 1 16\n"
                              "\n"
                              "6 7 3 -3 24.25\n";

/// The folder for files of the test that runs.
inline std::string Folder;

inline std::string WriteFile(const std::string& name, const std::string& text)
{
  return WriteText(Folder + "/" + name, text);
}
}

#endif
