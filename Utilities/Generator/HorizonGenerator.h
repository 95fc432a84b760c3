// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes synthetic horizons of any size for tests, benchmarks and demonstrations.
//
// All horizons of one cube share folds and lie above each other with a varying distance; none touches another. Each has
// an outline of its own, lobed and ragged, with two bays; holes, the first of them large; islands, the first of them in
// the large hole; single missing voxels; and on request patches of noise (HorizonShape.h, NoisePatches.h). Thickness,
// amplitude and its polarity vary slowly over the horizon.
//
// The result depends on the options alone: every voxel is computed from its place with IEEE additions, multiplications,
// divisions and square roots, whose result the standard prescribes, and with random numbers of its own. (A compiler
// that fuses multiplications and additions has to be told not to.)

#ifndef SeismicHorizonsHorizonGenerator_h
#define SeismicHorizonsHorizonGenerator_h

#include "Common/Base/Monitor.h"
#include "HorizonGeneratorOptions.h"
#include "HorizonShape.h"
#include "RandomFields.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <cstdint>
#include <map>
#include <ostream>
#include <vector>

namespace SeismicHorizons
{
class HorizonGenerator
{
public:
  /// Throws InputError when an option is out of range or the lattice has no room for all holes and islands.
  explicit HorizonGenerator(const HorizonGeneratorOptions& options);

  /// The size, in the proportions of options.Size and with its nZ, at which the file has about `numberOfVoxels` voxels,
  /// all horizons together.
  static SparseMatrixSize FindSize(const HorizonGeneratorOptions& options, std::int64_t numberOfVoxels);

  const HorizonGeneratorOptions& Options() const { return this->Given; }

  /// The horizon of a position, 0 to NumberOfHorizons - 1, in memory.
  LatticeHorizon MakeHorizon(int position) const;

  /// Writes the file row by row and returns the voxels of each horizon. Throws std::runtime_error when the stream
  /// does not take it.
  std::map<int, std::int64_t> Write(std::ostream& stream, const Monitor& monitor = Monitor()) const;

private:
  struct RowVoxel
  {
    int I = 0;
    SparseMatrixVoxel Voxel;
  };

  double Fold(const FramePlace& place) const;
  double Elevation(int position, const FramePlace& place, int i, int j) const;
  SparseMatrixVoxel MakeVoxel(int position, int i, int j) const;
  void MakeRow(int position, int j, std::vector<RowVoxel>& row) const;

  HorizonGeneratorOptions Given;
  std::vector<HorizonShape> Shapes; // of the horizons by position
};
}

#endif
