// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sets of columns, beside std::set.

#include "Reflections/ColumnSet.h"
#include "Tools/Check.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace SeismicHorizons;

namespace
{
/// Whether a set of columns has what it was given, and nothing around it.
void Compare(const ColumnSet& columns, const std::set<std::pair<int, int>>& expected, int side)
{
  int wrong = 0;
  for (int j = -2; j < side + 2; ++j)
  {
    for (int i = -2; i < side + 2; ++i)
    {
      wrong += columns.Has(i, j) == (expected.count({ i, j }) != 0) ? 0 : 1;
    }
  }
  CHECK_EQUAL(wrong, 0);
}

/// From a column on, at first around it, and then farther and farther away to all sides.
void TestGrowth(unsigned seed)
{
  constexpr int side = 300;
  std::mt19937 random(seed);
  ColumnSet columns;
  std::set<std::pair<int, int>> expected;
  Compare(columns, expected, 3);
  const int middle = int(random() % side);
  for (int n = 0; n < 200; ++n)
  {
    const auto near = [&]() { return std::min(side - 1, std::max(0, middle + int(random() % (2 * n + 1)) - n)); };
    const std::pair<int, int> column(near(), near());
    columns.Add(column.first, column.second);
    expected.insert(column);
    if (n % 20 == 0)
    {
      Compare(columns, expected, side);
    }
  }
  Compare(columns, expected, side);
}
}

int TestColumnSet(int, char*[])
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    TestGrowth(seed);
  }
  return Check::Result();
}
