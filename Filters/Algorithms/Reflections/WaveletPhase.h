// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The phase of the wavelet of a seismic cube. A wavelet of phase 0 has its peak, and so its pick, on the interface; one
// of 90 degrees has a zero crossing there, and two picks beside it.

#ifndef SeismicHorizonsWaveletPhase_h
#define SeismicHorizonsWaveletPhase_h

#include "TraceCube.h"

namespace SeismicHorizons
{
struct WaveletPhase
{
  double Degrees = 0.0; // -90 to below 90: which of the two signs it has cannot be told
  double Deviation = 0.0; // the root mean square of how far those of eighths of the traces are from it: 0 to 90 degrees
};

/// Of the phases that the wavelet may have, that by which traces are turned to those of largest kurtosis: a few strong
/// peaks among much that is weak (Levy and Oldenburg 1987). Looks at 2000 traces at most, spread over the cube, and
/// gives the same on any number of threads.
WaveletPhase EstimatePhase(const TraceCube& cube);

/// The cube with the phase of its wavelet turned by that many degrees. Missing samples stay so, and count as 0 for
/// those around them. `cube` is copied.
TraceCube TurnPhase(const TraceCube& cube, double degrees);
}

#endif
