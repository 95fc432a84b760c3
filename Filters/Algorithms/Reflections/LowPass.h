// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Removes noise of frequencies well above those of reflections.

#ifndef SeismicHorizonsLowPass_h
#define SeismicHorizonsLowPass_h

#include "TraceCube.h"

namespace SeismicHorizons
{
/// A Gaussian of .08 periods weakens higher frequencies, those of twice the dominant one by a third, and leaves the
/// dominant one as it is. Traces continue with their first and last sample. Missing samples stay missing, and count as
/// 0 for their neighbours.
TraceCube LowPass(const TraceCube& cube, double period);
}

#endif
