// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Estimates the phase of the wavelet of a cube, and rotates it.

#ifndef SeismicHorizonsWaveletPhase_h
#define SeismicHorizonsWaveletPhase_h

#include "TraceCube.h"

namespace SeismicHorizons
{
struct WaveletPhase
{
  double Degrees = 0.0; // -90 to below 90, as the sign is unknown
  double Deviation = 0.0; // root mean square over eighths of the traces, 0 to 90 degrees
};

/// Returns the phase whose removal gives the largest kurtosis, a few strong peaks among weak samples (Levy and
/// Oldenburg 1987). At most 2000 traces are read.
WaveletPhase EstimatePhase(const TraceCube& cube);

/// Missing samples stay missing, and count as 0 for their neighbours.
TraceCube TurnPhase(const TraceCube& cube, double degrees);
}

#endif
