// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSealedModelFile_h
#define SeismicHorizonsSealedModelFile_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"

#include <string>

namespace SeismicHorizons
{
/// The extension selects the format. The file appears complete or not at all. Throws InputError for other extensions
/// than ml, msh and stl, and unless the surfaces enclose bodies.
void WriteSealedModel(const std::string& path, const Horizon& surfaces, const Monitor& monitor);
}

#endif
