// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits a line to the voxels of all horizons by least squares. Voxels in memory and blocks of a file give bitwise equal
// results.

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
/// Sums are relative to a voxel, as differences between large sums would lose digits.
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

/// The voxel with the lowest surface ID in the first column that has voxels.
struct ReferenceVoxel
{
  double K = 0.0;
  double Z = 0.0;
};

SparseMatrixVerticalFit FitVertically(const std::vector<LatticeHorizon>& horizons);

/// Blocks must be added in the order of the file.
class VerticalFitter
{
public:
  void Add(const std::vector<HorizonSorter>& blocks, std::size_t count);

  SparseMatrixVerticalFit Fit() const;

private:
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
