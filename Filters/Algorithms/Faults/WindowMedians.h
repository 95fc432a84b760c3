// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Medians of windows of seven by seven numbers along a row.

#ifndef SeismicHorizonsWindowMedians_h
#define SeismicHorizonsWindowMedians_h

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
constexpr std::int64_t WindowReach = 3;
constexpr std::int64_t WindowSide = 2 * WindowReach + 1;

/// NaN values and values outside are ignored; of an even number the lower middle one counts. Without any value, the
/// median is undefined.
void FindWindowMedians(const std::array<const float*, WindowSide>& rows, std::int64_t width, float* medians);
}

#endif
