// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints the sparse-matrix text format (Documentation/FileFormat.md) in its normal form: one blank between numbers, a
// newline behind every column, also the last one; the voxels of a column by ascending vertical index; no sign but
// minus; and numbers with the fewest digits that give the same number when they are read.

#ifndef SeismicHorizonsSparseMatrixPrinter_h
#define SeismicHorizonsSparseMatrixPrinter_h

#include "Common/Monitor.h"
#include "VerneySparseMatrix/SparseMatrixParser.h"

#include <ostream>

namespace SeismicHorizons
{
/// Prints the voxels of all horizons, which may come in any order. Time grows as n log n in the voxels and linear in
/// the columns; memory is 16 bytes for each voxel. Throws InputError when two horizons have one surface ID, when a
/// voxel is outside the lattice, in the cell of another one, or has a number that is not finite, and when the stream
/// takes no more.
void PrintSparseMatrix(const SparseMatrix& matrix, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
