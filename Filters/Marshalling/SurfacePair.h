// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a pair of datasets to two triangle surfaces in lattice and in world units, and their distances.

#ifndef SeismicHorizonsSurfacePair_h
#define SeismicHorizonsSurfacePair_h

#include "Common/Monitor.h"
#include "DistanceReport.h"
#include "SurfaceDistance/SurfaceDistance.h"

namespace SeismicHorizons
{
struct HorizonPair;

/// Gives the reference's output the reference with triangles: as it is, or meshed with all its points inside its loops,
/// or without loops inside its exterior boundary. Throws InputError when it can not be meshed.
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor);

/// Distances of points in the unit that was asked for, and the figures in all.
struct MeasuredPair
{
  SurfaceDistance Points;
  double Upwards = 1.0; // from heights on the lattice to those of the unit, positive upwards in the world
  DistanceReport Report;
};

/// Measures the output of WriteReference and the mesh. Without a lattice, lattice units are those of the world. Throws
/// InputError on other cells than triangles, and as MeasureSurfaceDistance does.
MeasuredPair MeasureSurfaces(
  const HorizonPair& pair, const SurfaceDistanceOptions& options, bool inWorldUnits, const Monitor& monitor);
}

#endif
