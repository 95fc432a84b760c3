// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DealOut.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::vector<int> DealOut(const std::vector<std::int64_t>& sizes, int numberOfPieces)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  using Load = std::pair<std::int64_t, int>;
  std::priority_queue<Load, std::vector<Load>, std::greater<Load>> pieces;
  for (int piece = 0; piece < numberOfPieces; ++piece)
  {
    pieces.push({ 0, piece });
  }
  std::vector<int> pieceOf(sizes.size());
  for (const std::size_t item : order)
  {
    const auto [load, piece] = pieces.top();
    pieces.pop();
    pieceOf[item] = piece;
    pieces.push({ load + sizes[item], piece });
  }
  return pieceOf;
}
}
