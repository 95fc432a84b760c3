// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The line through the voxels of all horizons of a file, by least squares: of voxels in memory, or block by block, with
// the same result to the bit.

#ifndef SeismicHorizonsVerticalFit_h
#define SeismicHorizonsVerticalFit_h

#include "HorizonSorter.h"
#include "SparseMatrixParser.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// Sums over voxels, relative to one of them: the differences between sums of large, nearly equal numbers would be
/// mostly rounding.
struct VerticalSums
{
  double Count = 0.0;
  double K = 0.0;
  double Z = 0.0;
  double KK = 0.0;
  double KZ = 0.0;

  void Add(double k, double z)
  {
    this->Count += 1.0;
    this->K += k;
    this->Z += z;
    this->KK += k * k;
    this->KZ += k * z;
  }

  void Add(const VerticalSums& other)
  {
    this->Count += other.Count;
    this->K += other.K;
    this->Z += other.Z;
    this->KK += other.KK;
    this->KZ += other.KZ;
  }
};

/// The voxel that sums are relative to: of the first column that has one, that of the least surface ID.
struct ReferenceVoxel
{
  double K = 0.0;
  double Z = 0.0;
};

SparseMatrixVerticalFit FitVertically(const std::vector<LatticeHorizon>& horizons);

/// For the blocks of a file in their order.
class VerticalFitter
{
public:
  /// Adds the horizons of the first `count` blocks.
  void Add(const std::vector<HorizonSorter>& blocks, std::size_t count);

  SparseMatrixVerticalFit Fit() const;

private:
  /// Those of a horizon: added up, and of the chunk at hand.
  struct Sums
  {
    VerticalSums All;
    VerticalSums Chunk;
    std::int64_t InChunk = 0;
  };

  void Add(const LatticeHorizon& voxels, Sums& sums) const;

  std::optional<ReferenceVoxel> Reference;
  std::map<int, Sums> Horizons; // by surface ID
};
}

#endif
