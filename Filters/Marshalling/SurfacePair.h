// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a pair of datasets to two triangle surfaces, and their distances in lattice and in world units.

#ifndef SeismicHorizonsSurfacePair_h
#define SeismicHorizonsSurfacePair_h

#include "Common/Monitor.h"
#include "DistanceReport.h"
#include "SurfaceDistance/SurfaceDistance.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
struct HorizonPair;

/// The triangles of a mesh but for those that close faults, which are no part of a surface. Throws InputError on other
/// cells.
std::vector<std::array<PointId, 3>> ReadOpenTriangles(vtkPolyData* mesh);

/// Writes the reference as a mesh to its output. A reference with triangles is passed as it is. Any other is meshed
/// with all its points: inside its loops, or where it has none, inside its exterior boundary, with the radius and the
/// holes of a mesh by vtkHorizonSurface, else of that radius, with holes closed. Throws InputError when it cannot be
/// meshed.
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor);

struct MeasuredPair
{
  SurfaceDistance Points; // the distances of points, in the unit that was asked for
  double Upwards = 1.0; // times a vertical distance: the same in that unit, positive upwards in the world
  DistanceReport Report; // the figures, in all units
};

/// Measures the output of WriteReference and the mesh; figures leave out what hole filling has put in unless
/// `withFilledPoints`. Without a lattice, lattice units are those of the world. Throws InputError on other cells than
/// triangles, and as MeasureSurfaceDistance does.
MeasuredPair MeasureSurfaces(const HorizonPair& pair, const SurfaceDistanceOptions& options, bool inWorldUnits,
  bool withFilledPoints, const Monitor& monitor);
}

#endif
