// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints the sparse-matrix text format (Documentation/VerneySparseMatrix.md) in its normal form: one blank between numbers, a
// newline after every column, voxels of a column by ascending vertical index, no plus signs, and the shortest numbers
// that are restored exactly.

#ifndef SeismicHorizonsSparseMatrixPrinter_h
#define SeismicHorizonsSparseMatrixPrinter_h

#include "Common/Base/Monitor.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <ostream>

namespace SeismicHorizons
{
/// Memory is 16 bytes per voxel. Throws InputError for repeated surface IDs, voxels outside the lattice or in the same
/// cell, numbers that are not finite, and if writing fails.
void PrintSparseMatrix(const SparseMatrix& matrix, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
