// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a pair of datasets to two triangle surfaces, their distances in lattice and in world units, and the figures of
// these as field data and as a table.

#ifndef SeismicHorizonsSurfacePair_h
#define SeismicHorizonsSurfacePair_h

#include "Common/Monitor.h"
#include "SurfaceDistance/SurfaceDistance.h"

#include <array>
#include <string>

class vtkPolyData;
class vtkTable;

namespace SeismicHorizons
{
struct HorizonPair;

/// Writes the reference as a mesh to its output. A reference with triangles is passed as it is. Any other is meshed
/// with all its points: inside its loops, or where it has none, inside its exterior boundary of that radius. Throws
/// InputError when it can not be meshed.
void WriteReference(const HorizonPair& pair, int radius, const Monitor& monitor);

/// From the reference to the mesh, from the mesh to the reference, both.
constexpr std::size_t Directions = 3;

struct DistanceReport
{
  std::array<DistanceFigures, Directions> Lattice;
  std::array<DistanceFigures, Directions> World;
  double Diagonal = 0.0; // of the reference, in lattice units
  std::array<Grading, 2> Surfaces; // reference, mesh
};

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

/// Adds the figures to the field data of one of the two surfaces.
void WriteFieldData(const DistanceReport& report, const Grading& grading, vtkPolyData* output);

/// Gives a table its columns.
void MakeColumns(vtkTable* table);

/// Adds the rows of a horizon.
void AppendRows(const DistanceReport& report, const std::string& horizon, vtkTable* table);
}

#endif
