// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cracks of a horizon with faulted links, in its field data (Documentation/DataModel.md), and meshes that are
// closed there.

#ifndef SeismicHorizonsCrackData_h
#define SeismicHorizonsCrackData_h

#include "Common/Cracks.h"
#include "Common/Lattice.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// Writes cracks between the loops of a horizon as CrackOpenEnds and CrackLoops. A horizon without faulted links gets
/// neither, and loses those that it has.
void WriteCracks(const Cracks& cracks, vtkPolyData* horizon);

/// The points of loops at open ends of cracks, to be kept: those that are there. Throws InputError on an array
/// of another form.
std::vector<PointId> ReadPointsOfOpenEnds(vtkPolyData* horizon, PlanePoints columns, const Loops& boundary);

/// Adds the triangles that close its cracks to a mesh that has all else: points, whose places in plan are `plane`,
/// loops, triangles with their cell data, and field data. They have Compactness and Quality, nan in other arrays, and 1
/// in the new one, Fault, where all other cells have 0. Their number is the figure FaultTriangleCount. Throws
/// InputError on arrays of another form, and where they do not fit the loops, as when some are gone.
void CloseMesh(const std::vector<PlanePoint>& plane, const Lattice& lattice, const Loops& boundary, vtkPolyData* mesh,
  const Monitor& monitor);
}

#endif
