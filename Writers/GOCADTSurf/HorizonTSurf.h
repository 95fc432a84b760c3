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
/// Converts triangles, colour and coordinate system; z increases in the direction of `positive`. Throws InputError
/// unless all polygons are triangles.
TSurf MakeTSurf(vtkPolyData* horizon, const std::string& name, VerticalPositive positive);

/// Arrays of readers and stages are included only for `withOwn`.
std::vector<TSurfProperty> ReadProperties(vtkPolyData* horizon, bool withOwn);
}

#endif
