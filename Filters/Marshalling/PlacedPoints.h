// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a horizon on the lattice of another one.

#ifndef SeismicHorizonsPlacedPoints_h
#define SeismicHorizonsPlacedPoints_h

#include "Common/Lattice.h"
#include "Common/Monitor.h"
#include "Common/Survey/SurveyDescription.h"
#include "Common/Types.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// Heights in lattice units, by column.
struct PlacedPoints
{
  std::vector<PlanePoint> Columns; // may lie outside the lattice
  std::vector<double> Height;
};

/// What horizons are called in messages: "the other horizon" and "the first one".
struct HorizonNames
{
  std::string Placed;
  std::string First; // whose lattice it is
};

/// Of points none of which is hidden. Throws InputError on points that are not within
/// a twentieth of a column or not finite, and on heights beyond LargestHeight.
PlacedPoints PlaceOn(const Lattice& lattice, vtkPolyData* points, const HorizonNames& names);

/// Whether a horizon has triangles: then it is known between its points, too.
bool IsMesh(vtkPolyData* horizon);

/// Of a mesh: the columns that its triangles cover, but for those that close faults, and its points on other columns.
/// Throws InputError as PlaceOn does, on hidden points, on other cells than triangles, and on more columns than memory
/// is made for.
PlacedPoints SampleOn(const Lattice& lattice, vtkPolyData* mesh, const HorizonNames& names, const Monitor& monitor);

/// What the survey of several horizons is: what the first says, and the other one where that does not. A unit of time,
/// or of length, says the domain, too, and "metres" are "m". Throws InputError where both say what z is, the unit of x
/// and y, or the coordinate system, and it is not the same.
SurveyDescription JoinSurveys(const SurveyDescription& first, vtkPolyData* other, const HorizonNames& names);
}

#endif
