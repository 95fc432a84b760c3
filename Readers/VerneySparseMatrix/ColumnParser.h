// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnParser_h
#define SeismicHorizonsColumnParser_h

#include "SparseMatrixParser.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Some lines of a sparse-matrix file, parsed.
struct SparseMatrixBlock
{
  std::vector<HorizonVoxels> Horizons; // in the order in which their first voxels come
  std::int64_t ErrorLine = -1; // of the first error, counted from 0 within the block; lines behind it are not parsed
  std::string Error;
};

/// Parses lines behind the header, of which the last character is a newline and the first line is that of column
/// number `firstColumn`, in the order of the file. Blocks do not depend on each other, so that several are parsed at a
/// time.
SparseMatrixBlock ParseColumns(
  std::string_view lines, const SparseMatrixSize& size, std::int64_t firstColumn, DuplicatePolicy policy);
}

#endif
