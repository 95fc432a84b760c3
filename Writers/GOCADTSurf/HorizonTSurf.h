// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonTSurf_h
#define SeismicHorizonsHorizonTSurf_h

#include "Common/Survey/TSurf.h"

#include <string>

class vtkPolyData;

namespace SeismicHorizons
{
/// The triangles of a horizon with its colour, what its field data say of its coordinates, and for `withAttributes`
/// its point arrays of numbers, as a TSurf whose z grows as `positive` says. Throws InputError when there are no
/// triangles, or other polygons.
TSurf MakeTSurf(vtkPolyData* horizon, const std::string& name, VerticalPositive positive, bool withAttributes);
}

#endif
