// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Medians of the numbers in windows of seven rows and files, from place to place along a row.

#ifndef SeismicHorizonsWindowMedians_h
#define SeismicHorizonsWindowMedians_h

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
constexpr std::int64_t WindowReach = 3; // from the middle of a window
constexpr std::int64_t WindowSide = 2 * WindowReach + 1;

/// Writes the median of the window around each of `width` places of the middle one of seven rows. Numbers that are nan
/// are left out, as are those at places before 0 and from `width` on; of an even number it is the lower one of the two
/// in the middle. Where a window has none, the median is any number.
void FindWindowMedians(const std::array<const float*, WindowSide>& rows, std::int64_t width, float* medians);
}

#endif
