// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A sparse-matrix file lists its horizons before it reads them. One class keeps all voxels from listing; the other
// keeps an overview and reads rows of chosen horizons.

#ifndef SeismicHorizonsSparseMatrixFile_h
#define SeismicHorizonsSparseMatrixFile_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Text/InputFile.h"
#include "SparseMatrixParser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// First and last i, j and k.
using VoxelExtent = std::array<int, 6>;

constexpr VoxelExtent EmptyExtent = { 0, -1, 0, -1, 0, -1 };

struct ListedHorizon
{
  int SurfaceId = 0;
  std::int64_t Size = 0; // Voxels in the ranges of the options.
  VoxelExtent Extent = EmptyExtent; // Empty with an overview.
};

class SparseMatrixFile
{
public:
  virtual ~SparseMatrixFile() = default;

  /// Reads the file only if it changed, or if the kept data do not suffice. Must be called again after an InputError.
  virtual void List(const std::string& name, const SparseMatrixOptions& options, const Monitor& monitor) = 0;

  /// By ascending surface ID, then in the order of sheets.
  const std::vector<ListedHorizon>& Horizons() const { return this->Listed; }

  const SparseMatrixSize& Size() const { return this->Cells; }
  const SparseMatrixVerticalFit& VerticalFit() const { return this->Fit; }

  /// Returns all listed horizons; only horizons at `places` are certain to have voxels.
  virtual SparseMatrix Take(const std::vector<int>& places, const Monitor& monitor) = 0;

  // The others are for files with an overview alone, whatever the range of rows.
  virtual int CountRows() const { return 0; }
  virtual std::int64_t CountVoxels(std::size_t, int, int) const { return 0; }
  virtual PlaneBox ColumnsOf(std::size_t) const { return {}; }
  /// Returns the horizon at `place` with the voxels of these rows.
  virtual SparseMatrix TakeRows(std::size_t, int, int) const { return {}; }

protected:
  FileStamp Stamp; // The file that was read; empty after an error.
  SparseMatrixOptions Options;
  std::vector<ListedHorizon> Listed;
  SparseMatrixSize Cells = {};
  SparseMatrixVerticalFit Fit;
};

/// An overview needs the least memory.
std::unique_ptr<SparseMatrixFile> MakeSparseMatrixFile(bool withOverview);
}

#endif
