// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads the sparse-matrix text format: a header "nX nY nZ", then one line per column of the lattice (i fastest) with
// five values per voxel. Documentation/VerneySparseMatrix.md has the grammar and all messages.
//
// A few megabytes of the file are in memory besides the result, whatever its header says; time is linear in its size.
// Numbers are read independently of the locale and rounded correctly. Errors are InputError, with the number of the
// line: "line 17: ".

#ifndef SeismicHorizonsSparseMatrixParser_h
#define SeismicHorizonsSparseMatrixParser_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/DuplicatePolicy.h"
#include "Common/Survey/LatticeHorizon.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// nX, nY and nZ: cells of the lattice along i, j and k.
using SparseMatrixSize = std::array<int, 3>;

struct SparseMatrixVoxel
{
  int VerticalIndex = 0;
  int SurfaceId = 0;
  double Thickness = 0.0;
  double Amplitude = 0.0;
  double RealZ = 0.0;
};

constexpr std::size_t SparseMatrixBufferSize = 4 * 1024 * 1024;

SparseMatrixSize ReadSparseMatrixHeader(std::istream& stream);

/// Requires a voxel in the beginning of the file. Throws InputError on an invalid header.
bool BeginsAsSparseMatrix(std::istream& stream);

/// Real z is Offset + Step * vertical index.
struct SparseMatrixVerticalFit
{
  double Offset = 0.0;
  double Step = 0.0; ///< 0 if real z or the vertical index is constant.
};

struct SparseMatrix
{
  SparseMatrixSize Size = {};
  std::vector<LatticeHorizon> Horizons; ///< By ascending surface ID, then in the order of sheets; none is empty.
  SparseMatrixVerticalFit VerticalFit; ///< By least squares, through all voxels.
};

/// Excluded data are checked, too.
struct SparseMatrixOptions
{
  DuplicatePolicy Policy = DuplicatePolicy::StrongestAmplitude;
  std::array<int, 2> ColumnRange = { 0, std::numeric_limits<int>::max() }; ///< First and last i.
  std::array<int, 2> RowRange = { 0, std::numeric_limits<int>::max() }; ///< First and last j.
  std::int64_t SmallestSize = 1; ///< In voxels within the ranges.
  std::vector<int> Surfaces = {}; ///< Ascending surface IDs; empty for all.

  bool operator==(const SparseMatrixOptions& other) const
  {
    return this->Policy == other.Policy && this->ColumnRange == other.ColumnRange && this->RowRange == other.RowRange &&
      this->SmallestSize == other.SmallestSize && this->Surfaces == other.Surfaces;
  }
};

/// Progress is by bytes, if the length of the stream is known.
SparseMatrix ReadSparseMatrix(std::istream& stream, const SparseMatrixOptions& options = SparseMatrixOptions(),
  const Monitor& monitor = Monitor(), std::size_t bufferSize = SparseMatrixBufferSize);
}

#endif
