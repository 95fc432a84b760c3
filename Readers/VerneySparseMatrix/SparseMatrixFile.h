// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A sparse-matrix file whose horizons are listed first and read then. One kind reads the whole file for the list and
// keeps the voxels until they are asked for; the other keeps an overview, and reads rows of chosen horizons.

#ifndef SeismicHorizonsSparseMatrixFile_h
#define SeismicHorizonsSparseMatrixFile_h

#include "Common/InputFile.h"
#include "Common/Monitor.h"
#include "SparseMatrixParser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The first and last i, j and k of a box of voxels. One without voxels has a last index below its first.
using VoxelExtent = std::array<int, 6>;

constexpr VoxelExtent EmptyExtent = { 0, -1, 0, -1, 0, -1 };

/// A horizon in the list of a file.
struct ListedHorizon
{
  int SurfaceId = 0;
  std::int64_t Size = 0; // voxels in the ranges of the options
  VoxelExtent Extent = EmptyExtent; // theirs; empty where only an overview is kept
};

class SparseMatrixFile
{
public:
  virtual ~SparseMatrixFile() = default;

  /// Lists the horizons that the options leave. The file is read unless it is the one that was read last, and what is
  /// kept of it does for these options. Throws InputError, and is to be asked again then.
  virtual void List(const std::string& name, const SparseMatrixOptions& options, const Monitor& monitor) = 0;

  /// By ascending surface ID, sheets of one in their order.
  const std::vector<ListedHorizon>& Horizons() const { return this->Listed; }

  const SparseMatrixSize& Size() const { return this->Cells; }
  const SparseMatrixVerticalFit& VerticalFit() const { return this->Fit; }

  /// A horizon for each of the list, with the voxels of at least those at the chosen places in it.
  virtual SparseMatrix Take(const std::vector<int>& places, const Monitor& monitor) = 0;

  /// Where an overview is kept: how many rows the lattice has, and how many voxels a horizon of the list has in some of
  /// them; else 0.
  virtual int CountRows() const { return 0; }
  virtual std::int64_t CountVoxels(std::size_t place, int firstRow, int lastRow) const;

protected:
  FileStamp Stamp; // of the file that was read; of none after an error
  SparseMatrixOptions Options; // those of the list
  std::vector<ListedHorizon> Listed;
  SparseMatrixSize Cells = {};
  SparseMatrixVerticalFit Fit;
};

/// A file to be read as a whole, or with an overview, which takes the least memory.
std::unique_ptr<SparseMatrixFile> MakeSparseMatrixFile(bool withOverview);
}

#endif
