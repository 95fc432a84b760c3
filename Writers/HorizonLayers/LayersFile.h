// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLayersFile_h
#define SeismicHorizonsLayersFile_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/VolumeGrid.h"
#include "LayerBoundary.h"

#include <string>

namespace SeismicHorizons
{
/// Throws InputError for other cells than those of layers.
LayerBoundary FindBoundary(const VolumeGrid& grid);

/// The extension selects the format. The file appears complete or not at all. Throws InputError for other extensions
/// than msh, inp and disv, and for other cells than those of layers.
void WriteLayersFile(const std::string& path, const VolumeGrid& grid, const Monitor& monitor);
}

#endif
