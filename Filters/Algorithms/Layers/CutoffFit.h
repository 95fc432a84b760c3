// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights at the cutoffs of faults, as a throw between two columns has the noise of both.

#ifndef SeismicHorizonsCutoffFit_h
#define SeismicHorizonsCutoffFit_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Crossings.h"
#include "Filters/Algorithms/Decimation/HeightMesh.h"

#include <vector>

namespace SeismicHorizons
{
/// Fits heights of vertices beside faulted links by planes through connected columns at most two away. `known` has 1
/// where heights count, or is empty. Vertices around the end of a cut, or with too few columns, are left out.
std::vector<InnerHeights> FitCutoffs(const HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const LinkCuts& cuts);
}

#endif
