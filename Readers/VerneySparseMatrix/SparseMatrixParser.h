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
#include "Common/Monitor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <map>
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

/// Voxels per surface ID, all of them: duplicates count as well.
using SparseMatrixCounts = std::map<int, std::int64_t>;

/// The straight line real z = Offset + Step * vertical index.
struct SparseMatrixVerticalFit
{
  double Offset = 0.0;
  double Step = 0.0; ///< 0 when there is no such line: real z is the same everywhere, or vertical indices are
};

struct SparseMatrixSummary
{
  SparseMatrixSize Size = {};
  SparseMatrixCounts VoxelCounts;
  SparseMatrixVerticalFit VerticalFit; ///< by least squares, through all voxels
};

/// Checks a whole file and lists the horizons it has. Progress is by bytes, where the stream can tell its length.
SparseMatrixSummary ScanSparseMatrix(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t bufferSize = SparseMatrixBufferSize);

/// A horizon as parallel arrays, one entry per voxel in the order of the file, at most one voxel per column.
struct HorizonVoxels
{
  int SurfaceId = 0;
  std::vector<int> I;
  std::vector<int> J;
  std::vector<int> K;
  std::vector<double> Thickness;
  std::vector<double> Amplitude;
  std::vector<double> RealZ;
  std::int64_t DroppedDuplicates = 0;
};

struct SparseMatrix
{
  SparseMatrixSize Size = {};
  std::vector<HorizonVoxels> Horizons; ///< by ascending surface ID
};

/// Loads the horizons named by the keys of `horizons`; the values are the numbers of voxels to make room for. A horizon
/// that is not in the file comes out without voxels. The whole file is checked, so that a file which breaks the format
/// is refused whichever horizons are asked for.
SparseMatrix LoadSparseMatrix(std::istream& stream, const SparseMatrixCounts& horizons,
  DuplicatePolicy policy = DuplicatePolicy::StrongestAmplitude, const Monitor& monitor = Monitor(),
  std::size_t bufferSize = SparseMatrixBufferSize);
}

#endif
