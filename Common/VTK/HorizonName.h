// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a horizon is called in datasets, lists and messages.

#ifndef SeismicHorizonsHorizonName_h
#define SeismicHorizonsHorizonName_h

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
/// "Horizon <ID>".
std::string HorizonName(std::int64_t surfaceId);

/// The name by the surface ID of the first point. Empty when points have no surface IDs, or when there is no point.
std::string NameBySurfaceId(vtkPolyData* horizon);

/// The names with " (2)", " (3)" and so on behind those that came before, so that each is there once.
std::vector<std::string> MakeDistinct(std::vector<std::string> names);
}

#endif
