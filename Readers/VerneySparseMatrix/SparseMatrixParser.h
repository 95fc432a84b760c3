// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads the sparse-matrix text format: a header "nX nY nZ", then one line per column of the lattice (i runs fastest)
// with five values per voxel. Documentation/FileFormat.md has the grammar and all messages.
//
// The parser streams: it holds one block of the file at a time and hands each column that has voxels to a visitor. So
// one parser serves to scan a file and to load a part of it, and memory follows what is in the file, never what its
// header claims. Time is linear in the bytes. Numbers are read independently of the locale and rounded correctly.
//
// A file that breaks the format gives an InputError whose text starts with the number of the line, as "line 17: ".

#ifndef SeismicHorizonsSparseMatrixParser_h
#define SeismicHorizonsSparseMatrixParser_h

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

class SparseMatrixVisitor
{
public:
  virtual ~SparseMatrixVisitor() = default;

  /// Takes the voxels of the column (i, j) in the order of the file, at least one, no two with the same vertical
  /// index. Columns come in the order of the file, each at most once.
  virtual void VisitColumn(int i, int j, const std::vector<SparseMatrixVoxel>& voxels) = 0;
};

/// How many bytes of a file are held at a time. A longer line makes the block grow.
constexpr std::size_t SparseMatrixBlockSize = 4 * 1024 * 1024;

/// Reads the first line and leaves the stream behind it.
SparseMatrixSize ReadSparseMatrixHeader(std::istream& stream);

/// Reads a whole file. Progress is by bytes, where the stream can tell its length. The visitor may have seen a part of
/// the file when an error is thrown.
SparseMatrixSize ParseSparseMatrix(std::istream& stream, SparseMatrixVisitor& visitor,
  const Monitor& monitor = Monitor(), std::size_t blockSize = SparseMatrixBlockSize);

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

/// Checks a whole file and tells which horizons it has.
SparseMatrixSummary ScanSparseMatrix(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t blockSize = SparseMatrixBlockSize);

/// Which voxel stays when a horizon has several in one column.
enum class DuplicatePolicy
{
  StrongestAmplitude, ///< the largest absolute amplitude; of equal ones the smallest vertical index
  Topmost, ///< the smallest vertical index
  Lowest ///< the largest vertical index
};

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

/// Loads the horizons named by the keys of `horizons`; its values only size the arrays beforehand. A horizon that is
/// not in the file comes out without voxels. The other horizons are checked all the same, so an error in the file does
/// not depend on what is asked for.
SparseMatrix LoadSparseMatrix(std::istream& stream, const SparseMatrixCounts& horizons,
  DuplicatePolicy policy = DuplicatePolicy::StrongestAmplitude, const Monitor& monitor = Monitor(),
  std::size_t blockSize = SparseMatrixBlockSize);
}

#endif
