// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The output of what finds the boundary of a horizon.

#ifndef SeismicHorizonsBoundaryOutput_h
#define SeismicHorizonsBoundaryOutput_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/DataModel.h"
#include "Common/KeptPoints.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// Makes `output` the points of `input` that are `kept`, in their order and with all their arrays, which both share
/// where all points are, with the boundary that numbers them so: loops, PatchId, Boundary (`marks`), cracks, and the
/// figures.
void WriteBoundary(vtkPolyData* input, const KeptPoints& kept, const ExteriorBoundary& boundary,
  const std::vector<BoundaryKind>& marks, vtkPolyData* output);

/// Takes the faulted links and their cracks out of the field data of a horizon.
void RemoveCuts(vtkPolyData* output);

/// What to warn of when no patch of a horizon is large enough.
std::string NothingLeft(vtkPolyData* input, int minimumPatchSize);
}

#endif
