// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a mesh over a horizon is as the result of a decimation.

#ifndef SeismicHorizonsMeshResult_h
#define SeismicHorizonsMeshResult_h

#include "Common/Monitor.h"
#include "Decimation.h"
#include "HeightMesh.h"

namespace SeismicHorizons
{
/// Measures all triangles, and gives each dropped point to a vertex. Throws InputError when a point is in none.
Decimation MakeResult(const HeightMesh& mesh, const Monitor& monitor);
}

#endif
