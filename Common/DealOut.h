// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDealOut_h
#define SeismicHorizonsDealOut_h

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Deals items of some sizes out to a number of pieces, at least 1, so that no piece has much more than another: the
/// largest item first, each to the piece that has least so far. Of equal items the first one goes first, of equal
/// pieces the first one takes it; so items of one size are dealt out in turn. Gives the piece of each item.
///
/// The largest piece has at most 4/3 - 1 / (3 * pieces) times what the largest one has in the best way to deal (Graham,
/// Bounds on multiprocessing timing anomalies, 1969), and no less than the largest item.
std::vector<int> DealOut(const std::vector<std::int64_t>& sizes, int numberOfPieces);
}

#endif
