// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnParser_h
#define SeismicHorizonsColumnParser_h

#include "Common/LineBuffer.h"
#include "SparseMatrixVisitor.h"

namespace SeismicHorizons
{
/// Parses the lines of a sparse-matrix file that follow the header, one for each column, and hands each column that has
/// voxels to a visitor. Progress is by bytes, where the stream can tell its length. Throws InputError on what breaks
/// the format; the visitor may have seen some columns then.
void ParseColumns(
  LineBuffer& lines, const SparseMatrixSize& size, SparseMatrixVisitor& visitor, const Monitor& monitor);
}

#endif
