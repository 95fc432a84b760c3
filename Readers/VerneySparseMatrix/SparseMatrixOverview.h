// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Summarises files larger than memory, from which rows are read in parts.

#ifndef SeismicHorizonsSparseMatrixOverview_h
#define SeismicHorizonsSparseMatrixOverview_h

#include "Common/Horizon/PlaneGeometry.h"

#include "HorizonSorter.h"
#include "SparseMatrixParser.h"
#include "VerticalFit.h"

#include <cstdint>
#include <istream>
#include <map>
#include <vector>

namespace SeismicHorizons
{
struct HorizonOverview
{
  int FirstRow = 0;
  std::vector<std::int32_t> RowSizes; // Voxels per row, at most one per column.
  PlaneBox Box; // of the columns with voxels

  std::int64_t CountVoxels(int firstRow, int lastRow) const;
};

struct SparseMatrixOverview
{
  SparseMatrixSize Size = {};
  std::map<int, HorizonOverview> Horizons; // by surface ID
  SparseMatrixVerticalFit VerticalFit; // Ignores the range of rows.

  struct Line
  {
    std::int64_t Byte;
    std::int64_t Column;
  };
  std::vector<Line> Lines; // A sorted selection with the first line.
};

/// Reads the file and keeps about 4 bytes per row of each horizon. Row range, smallest size and surfaces of the options
/// are ignored.
SparseMatrixOverview ReadSparseMatrixOverview(std::istream& stream, const SparseMatrixOptions& options,
  const Monitor& monitor = Monitor(), std::size_t bufferSize = SparseMatrixBufferSize);

SparseMatrixOptions ForAllRows(SparseMatrixOptions options);

/// Smaller than that of whole files, as parts of a buffer beyond the rows are read in vain.
constexpr std::size_t RowsBufferSize = 1024 * 1024;

/// Equals ReadSparseMatrix() except for the vertical fit, which is the overview's. Reads at most a few megabytes beyond
/// the rows. `stream` must be at the start of the file.
SparseMatrix ReadSparseMatrixRows(std::istream& stream, const SparseMatrixOverview& overview,
  const SparseMatrixOptions& options, const Monitor& monitor = Monitor(), std::size_t bufferSize = RowsBufferSize);
}

#endif
