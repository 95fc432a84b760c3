// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurferNull_h
#define SeismicHorizonsSurferNull_h

namespace SeismicHorizons
{
/// Surfer 6 has no value at nodes from here on.
constexpr double SurferNull = 1.70141e38;
}

#endif
