// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What takes the columns of a file from the parser.

#ifndef SeismicHorizonsSparseMatrixVisitor_h
#define SeismicHorizonsSparseMatrixVisitor_h

#include "SparseMatrixParser.h"

#include <vector>

namespace SeismicHorizons
{
class SparseMatrixVisitor
{
public:
  virtual ~SparseMatrixVisitor() = default;

  /// Takes the voxels of the column (i, j) in the order of the file, at least one, no two with the same vertical
  /// index. Columns come in the order of the file, each at most once.
  virtual void VisitColumn(int i, int j, const std::vector<SparseMatrixVoxel>& voxels) = 0;
};
}

#endif
