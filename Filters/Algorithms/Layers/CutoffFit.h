// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights at the cutoffs of faults. Vertices of outlines have the heights of their columns, whose noise the throw would
// have twice.

#ifndef SeismicHorizonsCutoffFit_h
#define SeismicHorizonsCutoffFit_h

#include "Common/ColumnIndex.h"
#include "Common/LinkCuts.h"
#include "Crossings.h"
#include "Decimation/HeightMesh.h"

#include <vector>

namespace SeismicHorizons
{
/// For each horizon of a mesh the heights of its vertices beside faulted links: of planes through the columns within
/// two of them that are connected with them there. `index` and `heights` are of what the mesh lies over, by point, and
/// `known` has 1 where they count, empty where all do. Vertices around the end of a cut, and those with too few
/// columns, are left out.
std::vector<InnerHeights> FitCutoffs(const HeightMesh& mesh, const ColumnIndex& index, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const LinkCuts& cuts);
}

#endif
