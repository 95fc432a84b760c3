// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles between the lips of cracks, so that the mesh of a faulted horizon is closed there.
//
// The loops and the mouths of cracks (Common/Cracks.h) are a plane graph. The walk that begins with a mouth, and always
// goes on by the first loop or mouth that a clockwise sweep meets, goes round the crack to its left; loops that are
// lips all along bound cracks on their own. What these walks enclose is triangulated: its vertices are those of the
// loops, and so it fits the mesh on the other side of each lip.
//
//     o---o-------o---o        o    vertices of the mesh
//         : \     |            -    lips
//         :   \   |            :    the mouth
//     o---o-------o---o        \    inside the crack

#ifndef SeismicHorizonsFaultClosing_h
#define SeismicHorizonsFaultClosing_h

#include "Common/Cracks.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The constrained Delaunay triangles, in plan, that close cracks: three points each, counter-clockwise seen from +z on
/// the lattice. `plane` holds the places of the points of the loops, and of others. Where loops are simplified the ends
/// of mouths stay, and loops keep their order. Throws InputError on mouths between points of no loop, on numbers of
/// loops that are not there, and where cracks are not closed. Takes time and memory for the points of cracks, and looks
/// at each point of the loops.
RawVector<PointId> CloseFaults(const std::vector<PlanePoint>& plane, const Loops& boundary, const Cracks& cracks,
  const Monitor& monitor = Monitor());
}

#endif
