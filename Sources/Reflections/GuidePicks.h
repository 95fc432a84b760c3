// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGuidePicks_h
#define SeismicHorizonsGuidePicks_h

#include "Filters/Algorithms/Reflections/GuidedJoining.h"
#include "ImageCube.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;

namespace SeismicHorizons
{
struct GuidePicks
{
  Guide Given; // columns and samples of the cube
  std::vector<std::array<double, 3>> Places; // world coordinates of the picks
  std::size_t Outside = 0; // points outside the cube, which are not picks
  std::string FirstOutside; // world coordinates of the first of these
};

/// Blocks, or values of the point array Horizon, separate guides; an unnamed guide is called Guide 1, and so on. Throws
/// InputError without points, on infinite places, and if no point of a guide is on the cube.
std::vector<GuidePicks> ReadGuides(vtkDataObject* points, const ImageCube& cube);
}

#endif
