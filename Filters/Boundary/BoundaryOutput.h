// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsBoundaryOutput_h
#define SeismicHorizonsBoundaryOutput_h

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// Output points keep their order and arrays, which are shared if all points are kept. `boundary` numbers the kept
/// points.
void WriteBoundary(vtkPolyData* input, const KeptPoints& kept, const ExteriorBoundary& boundary,
  const std::vector<BoundaryKind>& marks, vtkPolyData* output);

/// Also removes the cracks along faulted links.
void RemoveCuts(vtkPolyData* output);

/// Returns the warning for a horizon without a patch of `minimumPatchSize` points.
std::string NothingLeft(vtkPolyData* input, int minimumPatchSize);
}

#endif
