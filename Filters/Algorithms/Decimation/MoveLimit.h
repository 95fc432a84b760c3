// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of vertices that were moved, moved back as far as it takes to keep an error.

#ifndef SeismicHorizonsMoveLimit_h
#define SeismicHorizonsMoveLimit_h

#include "HeightMesh.h"
#include "InnerHeights.h"

namespace SeismicHorizons
{
/// Gives the mesh new heights, for which no triangle and no inner side has an error above the one given, but where all
/// its corners have the heights they had: a vertex moves all the way, a half, a quarter, or stays.
void MoveHeightsWithin(HeightMesh& mesh, double error, const InnerHeights& heights);
}

#endif
