// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonMatrix_h
#define SeismicHorizonsHorizonMatrix_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct WrittenMatrix
{
  SparseMatrix Matrix;
  std::vector<std::string> Warnings;
};

/// vtkVerneySparseMatrixWriter documents the defaults of missing arrays. Throws InputError if lattices differ, and if
/// points are not on columns.
WrittenMatrix MakeSparseMatrix(const std::vector<NamedHorizon>& horizons, const Monitor& monitor);
}

#endif
