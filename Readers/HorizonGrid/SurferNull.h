// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurferNull_h
#define SeismicHorizonsSurferNull_h

namespace SeismicHorizons
{
/// In Surfer 6 nodes from this value upwards have no z.
constexpr double SurferNull = 1.70141e38;
}

#endif
