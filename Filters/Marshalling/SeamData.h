// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes of parts of horizons as datasets, and their mesh when they are joined.

#ifndef SeismicHorizonsSeamData_h
#define SeismicHorizonsSeamData_h

#include "Common/Lattice.h"
#include "Surface/Surface.h"
#include "Surface/SurfaceJoin.h"

#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// Gives the mesh of a part what is joined by: the arrays SeamRows and SeamGap, the heights of points that were put
/// onto the lines of seams, and counts without the points on the lower seam, which belong to the part below. `points`
/// are those of the part, all of which the surface has kept, `onLowerSeam` some of them.
void WriteSeams(vtkPolyData* points, const Lattice& lattice, const Surface& surface, const SeamRows& seams,
  const std::vector<PointId>& onLowerSeam, vtkPolyData* mesh);

/// The part that a mesh has become. Throws InputError when it is none.
SurfacePart ReadSurfacePart(vtkPolyData* mesh);

/// Makes `output` the mesh that parts were joined to. `meshes` are these parts.
void WriteJoinedSurface(
  const std::vector<vtkPolyData*>& meshes, const Lattice& lattice, const JoinedSurface& joined, vtkPolyData* output);
}

#endif
