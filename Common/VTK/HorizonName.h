// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonName_h
#define SeismicHorizonsHorizonName_h

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace SeismicHorizons
{
std::string HorizonName(std::int64_t surfaceId);

/// Uses the first point; empty without points or IDs.
std::string NameBySurfaceId(vtkPolyData* horizon);

/// Repeated names get " (2)", " (3)" and so on.
std::vector<std::string> MakeDistinct(std::vector<std::string> names);
}

#endif
