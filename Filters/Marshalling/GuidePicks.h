// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From points in the world to the picks that guide the extraction of a seismic cube.

#ifndef SeismicHorizonsGuidePicks_h
#define SeismicHorizonsGuidePicks_h

#include "ImageCube.h"
#include "Reflections/GuidedJoining.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;

namespace SeismicHorizons
{
struct GuidePicks
{
  Guide Given; // on the cube
  std::vector<std::array<double, 3>> Places; // of the picks of the guide, in the world
  std::size_t Outside = 0; // points that are not on the cube; they are no picks
  std::string FirstOutside; // where the first of these is
};

/// A guide for each horizon of `points`: a dataset of points, or a composite one, whose blocks are horizons. The point
/// array Horizon, of numbers or texts, parts the points of a dataset among horizons of these names. A horizon without a
/// name is Guide 1, and so on. Throws InputError on no points, on a place that is not finite, and on a horizon none of
/// whose points is on the cube.
std::vector<GuidePicks> ReadGuides(vtkDataObject* points, const ImageCube& cube);
}

#endif
