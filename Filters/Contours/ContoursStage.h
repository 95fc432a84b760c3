// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsContoursStage_h
#define SeismicHorizonsContoursStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"

#include <vector>

namespace SeismicHorizons
{
/// The interval is in units of z; 0 chooses it. The output has the field data.
void RunContours(const Horizon& horizon, double interval, std::vector<Horizon>& outputs, const Monitor& monitor);
}

#endif
