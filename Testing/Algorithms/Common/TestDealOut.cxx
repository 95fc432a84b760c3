// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/DealOut.h"
#include "Tools/Check.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace SeismicHorizons;

namespace
{
using Sizes = std::vector<std::int64_t>;
using Pieces = std::vector<int>;

void TestSmallCases()
{
  CHECK(DealOut({}, 3) == Pieces({}));
  CHECK(DealOut({ 5, 1, 4 }, 1) == Pieces({ 0, 0, 0 }));
  // 9 to the first, 8 to the second, 5 to the second (8 < 9), 4 to the first (9 < 13), 3 to the first (13 = 13).
  CHECK(DealOut({ 3, 9, 5, 8, 4 }, 2) == Pieces({ 0, 0, 1, 1, 0 }));
  CHECK(DealOut({ 1, 2, 3 }, 5) == Pieces({ 2, 1, 0 })); // two pieces without any
}

/// As when nothing is known of the sizes.
void TestEqualItemsGoInTurn()
{
  CHECK(DealOut(Sizes(7, 1), 3) == Pieces({ 0, 1, 2, 0, 1, 2, 0 }));
  CHECK(DealOut(Sizes(5, 1000), 2) == Pieces({ 0, 1, 0, 1, 0 }));
}

void TestOneHugeItem()
{
  Sizes sizes(20, 10);
  sizes[13] = 1000;
  const Pieces pieces = DealOut(sizes, 2);
  CHECK_EQUAL(pieces[13], 0);
  CHECK_EQUAL(std::count(pieces.begin(), pieces.end(), 0), 1);
}

/// No piece has more than the mean and the largest item: else that item would have gone elsewhere.
void TestRandomSizes()
{
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round)
  {
    const int numberOfPieces = 1 + int(random() % 9);
    Sizes sizes(random() % 60);
    std::generate(sizes.begin(), sizes.end(), [&random]() { return std::int64_t(random() % 1000); });
    const Pieces pieces = DealOut(sizes, numberOfPieces);
    Sizes loads(std::size_t(numberOfPieces), 0);
    for (std::size_t item = 0; item < sizes.size(); ++item)
    {
      CHECK(pieces[item] >= 0 && pieces[item] < numberOfPieces);
      loads[std::size_t(pieces[item])] += sizes[item];
    }
    const std::int64_t sum = std::accumulate(sizes.begin(), sizes.end(), std::int64_t(0));
    const std::int64_t largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
    CHECK(*std::max_element(loads.begin(), loads.end()) <= sum / numberOfPieces + largest);
  }
}
}

int TestDealOut(int, char*[])
{
  TestSmallCases();
  TestEqualItemsGoInTurn();
  TestOneHugeItem();
  TestRandomSizes();
  return Check::Result();
}
