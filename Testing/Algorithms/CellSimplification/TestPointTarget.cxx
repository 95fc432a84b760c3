// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/Check.h"
#include "Tools/ReductionChecker.h"

#include <cmath>
#include <string>

using namespace ReductionChecker;

namespace
{
/// Waves on a square, which are smaller towards one corner.
BoundedHorizon Waves(int size)
{
  Patches::Columns columns;
  std::vector<double> heights;
  for (int n = 0; n < size * size; ++n)
  {
    columns.push_back({ n % size, n / size });
    const double x = columns.back().X;
    const double y = columns.back().Y;
    heights.push_back(5.0 * std::sin(0.0015 * x * x) + 3.0 * std::cos(0.002 * y * y));
  }
  return MakeHorizon(columns, heights);
}

/// The smallest cell size with which so few are left: that before it leaves more.
void TestRough()
{
  const BoundedHorizon horizon = Waves(90);
  for (const std::size_t most : { 8100u, 3000u, 1000u, 500u, 400u })
  {
    CellOptions options(3);
    const Reduction reduction = SimplifyRoughTo(most, horizon, options);
    CHECK(reduction.Source.size() <= most);
    CHECK(reduction.Plane.size() == SimplifyRough(horizon, options).Plane.size());
    CHECK(options.CellSize == 1 || SimplifyRough(horizon, options.CellSize - 1).Source.size() > most);
  }
  CellOptions options(3);
  CHECK_EQUAL(SimplifyRoughTo(8100, horizon, options).Source.size(), 8100u);
  CHECK_EQUAL(options.CellSize, 1);
  CHECK_THROWS_WITH(SimplifyRoughTo(355, horizon, options),
    "maximum number of points 355, expected at least the 356 that are left with the largest cells: outlines are kept");
  CHECK_EQUAL(SimplifyRoughTo(356, horizon, options).Source.size(), 356u);
}

/// Near to the number where flatness alone can reach it, and otherwise with larger cells.
void TestElaborate()
{
  const BoundedHorizon horizon = Waves(90);
  for (const std::size_t most : { 3000u, 1000u, 500u })
  {
    ElaborateOptions options(16);
    const Reduction reduction = SimplifyElaborateTo(most, horizon, options);
    CHECK(reduction.Source.size() <= most && reduction.Source.size() > 0.97 * double(most));
    CHECK(reduction.Plane.size() == SimplifyElaborate(horizon, options).Plane.size());
    CHECK(most == 3000 ? options.CellSize < 16 : options.CellSize == 16);
  }
  ElaborateOptions options(1);
  CHECK_EQUAL(SimplifyElaborateTo(8100, horizon, options).Source.size(), 8100u);
  CHECK(SimplifyElaborateTo(600, horizon, options).Source.size() <= 600);
  CHECK(options.CellSize > 1);
  CHECK_THROWS_WITH(SimplifyElaborateTo(300, horizon, options),
    "maximum number of points 300, expected at least the 357 that are left with the largest cells: outlines are kept");
}

void TestNothing()
{
  CellOptions options(3);
  CHECK(SimplifyRoughTo(1, BoundedHorizon(), options).Source.empty());
}
}

int TestPointTarget(int, char*[])
{
  TestRough();
  TestElaborate();
  TestNothing();
  return Check::Result();
}
