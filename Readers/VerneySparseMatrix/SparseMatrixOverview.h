// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a sparse-matrix file has, without its voxels: for files larger than memory, of which some rows are read at a
// time.

#ifndef SeismicHorizonsSparseMatrixOverview_h
#define SeismicHorizonsSparseMatrixOverview_h

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
  std::vector<std::int32_t> RowSizes; // voxels, one at most in a column, row by row

  /// Voxels of some rows.
  std::int64_t CountVoxels(int firstRow, int lastRow) const;
};

struct SparseMatrixOverview
{
  SparseMatrixSize Size = {};
  std::map<int, HorizonOverview> Horizons; // by surface ID
  SparseMatrixVerticalFit VerticalFit; // through the voxels of all horizons in the range of columns

  /// Where a line of the file begins.
  struct Line
  {
    std::int64_t Byte;
    std::int64_t Column; // in the order of the file
  };
  std::vector<Line> Lines; // some of them, in their order, the first one included
};

/// Reads a whole file, and keeps about 4 bytes for each row of each horizon, from its first to its last one. Rows,
/// sizes and surfaces of the options are not looked at: what is told is that of all.
SparseMatrixOverview ReadSparseMatrixOverview(std::istream& stream, const SparseMatrixOptions& options,
  const Monitor& monitor = Monitor(), std::size_t bufferSize = SparseMatrixBufferSize);

/// The options of an overview: those without what it does not depend on.
SparseMatrixOptions ForAllRows(SparseMatrixOptions options);

/// Gives what ReadSparseMatrix() gives, but for the vertical fit, which is that of the overview, and reads no more of
/// the file than the rows of the options, or a few megabytes beyond. `stream` is at the begin of the file that the
/// overview was made of.
SparseMatrix ReadSparseMatrixRows(std::istream& stream, const SparseMatrixOverview& overview,
  const SparseMatrixOptions& options, const Monitor& monitor = Monitor(),
  std::size_t bufferSize = SparseMatrixBufferSize);
}

#endif
