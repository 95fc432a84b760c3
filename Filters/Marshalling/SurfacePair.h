// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurfacePair_h
#define SeismicHorizonsSurfacePair_h

#include "Common/Base/Monitor.h"
#include "DistanceReport.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
struct HorizonPair;

/// Omits triangles that close faults. Throws InputError on polygons other than triangles.
std::vector<std::array<PointId, 3>> ReadOpenTriangles(vtkPolyData* mesh);

/// Passes a mesh. Points are meshed inside their loops, or inside a boundary with the parameters of the other mesh,
/// or with `radius` and closed holes. Throws InputError if meshing fails.
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor);

struct MeasuredPair
{
  SurfaceDistance Points; // distances of points, in the requested unit
  double Upwards = 1.0; // factor that makes a vertical distance positive upwards in the world, in that unit
  DistanceReport Report; // figures in all units
};

/// Measures the output of WriteReference; figures skip filled points unless `withFilledPoints`. Without a lattice,
/// world units are used. Throws InputError on polygons other than triangles, and as MeasureSurfaceDistance.
MeasuredPair MeasureSurfaces(const HorizonPair& pair, const SurfaceDistanceOptions& options, bool inWorldUnits,
  bool withFilledPoints, const Monitor& monitor);
}

#endif
