// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads the sparse-matrix text format: a header "nX nY nZ", then one line per column of the lattice (i runs fastest)
// with five values per voxel. Documentation/FileFormat.md has the grammar and all messages.
//
// A file is parsed piece by piece: some megabytes of it are in memory at a time, beside the result. So memory follows
// what is in the file, and not what its header says. Time is linear in the bytes. Numbers are read independently of the
// locale and rounded correctly.
//
// A file that breaks the format gives an InputError whose text starts with the number of the line, as "line 17: ".

#ifndef SeismicHorizonsSparseMatrixParser_h
#define SeismicHorizonsSparseMatrixParser_h

#include "Common/DuplicatePolicy.h"
#include "Common/LatticeHorizon.h"
#include "Common/Monitor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// nX, nY and nZ: the cells of the lattice along i, j and k.
using SparseMatrixSize = std::array<int, 3>;

struct SparseMatrixVoxel
{
  int VerticalIndex = 0;
  int SurfaceId = 0;
  double Thickness = 0.0;
  double Amplitude = 0.0;
  double RealZ = 0.0;
};

/// How many bytes of a file are held at a time. A longer line makes the buffer grow.
constexpr std::size_t SparseMatrixBufferSize = 4 * 1024 * 1024;

/// Reads the first line and leaves the stream behind it.
SparseMatrixSize ReadSparseMatrixHeader(std::istream& stream);

/// The straight line real z = Offset + Step * vertical index.
struct SparseMatrixVerticalFit
{
  double Offset = 0.0;
  double Step = 0.0; ///< 0 when there is no such line: real z is the same everywhere, or vertical indices are
};

struct SparseMatrix
{
  SparseMatrixSize Size = {};
  std::vector<LatticeHorizon> Horizons; ///< by ascending surface ID, sheets of one in their order; none is empty
  SparseMatrixVerticalFit VerticalFit; ///< by least squares, through the voxels of all horizons
};

/// What is taken of a file. All of it is checked.
struct SparseMatrixOptions
{
  DuplicatePolicy Policy = DuplicatePolicy::StrongestAmplitude;
  std::array<int, 2> ColumnRange = { 0, std::numeric_limits<int>::max() }; ///< first and last i
  std::array<int, 2> RowRange = { 0, std::numeric_limits<int>::max() }; ///< first and last j
  std::int64_t SmallestSize = 1; ///< horizons of fewer voxels, those in the ranges, are left out
  std::vector<int> Surfaces = {}; ///< only these are kept, by their IDs, ascending; empty for all

  bool operator==(const SparseMatrixOptions& other) const
  {
    return this->Policy == other.Policy && this->ColumnRange == other.ColumnRange && this->RowRange == other.RowRange &&
      this->SmallestSize == other.SmallestSize && this->Surfaces == other.Surfaces;
  }
};

/// Reads a whole file, on all threads. Progress is by bytes, where the stream can tell its length.
SparseMatrix ReadSparseMatrix(std::istream& stream, const SparseMatrixOptions& options = SparseMatrixOptions(),
  const Monitor& monitor = Monitor(), std::size_t bufferSize = SparseMatrixBufferSize);
}

#endif
