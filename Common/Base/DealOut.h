// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDealOut_h
#define SeismicHorizonsDealOut_h

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Distributes items to pieces (at least 1): the largest item first, each to the piece with the least load. Ties go to
/// the first item and the first piece. The largest piece has at most 4/3 of the least possible load (Graham, 1969).
std::vector<int> DealOut(const std::vector<std::int64_t>& sizes, int numberOfPieces);
}

#endif
