// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonMesh_h
#define SeismicHorizonsHorizonMesh_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"

#include <ostream>
#include <string>

namespace SeismicHorizons
{
/// Throws InputError for a format other than "stl", "ply" and "obj", and for other polygons than triangles.
void PrintMesh(const NamedHorizon& horizon, const std::string& format, std::ostream& stream, const Monitor& monitor);
}

#endif
