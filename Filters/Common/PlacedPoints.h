// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlacedPoints_h
#define SeismicHorizonsPlacedPoints_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"
#include "Common/Survey/SurveyDescription.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Heights are in lattice units.
struct PlacedPoints
{
  std::vector<PlanePoint> Columns; // may be outside the lattice
  std::vector<double> Height;
};

/// Names for messages, such as "the other horizon" and "the first one".
struct HorizonNames
{
  std::string Placed;
  std::string First; // horizon with the lattice
};

/// Points must be visible. Throws InputError for points farther than 0.05 from a column, infinite, or beyond
/// LargestHeight.
PlacedPoints PlaceOn(const Lattice& lattice, const Horizon& points, const HorizonNames& names);

/// Returns the columns of triangles, except for triangles that close faults, and of bare points. Throws InputError as
/// PlaceOn, for hidden points, other cells than triangles, or more than 2^30 columns.
PlacedPoints SampleOn(const Lattice& lattice, const Horizon& mesh, const HorizonNames& names, const Monitor& monitor);

/// The first description takes precedence. Units are shortened, and imply the domain. Throws InputError if domains,
/// units or coordinate systems differ.
SurveyDescription JoinSurveys(const SurveyDescription& first, const Horizon& other, const HorizonNames& names);

/// Returns a warning if z of the files increases in different directions, which readers often infer from signs.
std::string WarnOfDirections(const Horizon& first, const Horizon& other, const HorizonNames& names);

/// Returns a warning if only one has a unit of z, or directions differ. Files of faults tell no unit.
std::string WarnOfHeights(const Horizon& first, const Horizon& other, const HorizonNames& names);
}

#endif
