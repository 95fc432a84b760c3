// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVerticalFit_h
#define SeismicHorizonsVerticalFit_h

#include "SparseMatrixParser.h"

#include <vector>

namespace SeismicHorizons
{
/// The line through the voxels of all horizons, by least squares.
SparseMatrixVerticalFit FitVertically(const std::vector<HorizonVoxels>& horizons);
}

#endif
