// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonTSurf_h
#define SeismicHorizonsHorizonTSurf_h

#include "Common/Survey/TSurf.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// The triangles of a horizon with its colour and what its field data say of its coordinates, as a TSurf without
/// properties whose z grows as `positive` says. Throws InputError when there are no triangles, or other polygons.
TSurf MakeTSurf(vtkPolyData* horizon, const std::string& name, VerticalPositive positive);

/// Its point arrays of numbers; those of readers and stages only for `withOwn`.
std::vector<TSurfProperty> ReadProperties(vtkPolyData* horizon, bool withOwn);
}

#endif
