// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnParser_h
#define SeismicHorizonsColumnParser_h

#include "HorizonSorter.h"
#include "SparseMatrixParser.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// What is wrong with a line.
struct ColumnError
{
  std::int64_t Line = 0; // counted from 0 within the lines that were parsed
  std::string Text;
};

/// Parses lines behind the header, of which the last character is a newline and the first line is that of column
/// number `firstColumn`, in the order of the file, and gives their voxels to `horizons`. Ends at the first error.
/// Blocks of lines do not depend on each other, so that several are parsed at a time.
std::optional<ColumnError> ParseColumns(
  std::string_view lines, const SparseMatrixSize& size, std::int64_t firstColumn, HorizonSorter& horizons);
}

#endif
