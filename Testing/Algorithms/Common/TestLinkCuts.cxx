// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faulted links are those that were cut, wherever they lie.

#include "Common/Horizon/LinkCuts.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <array>
#include <set>

using namespace SeismicHorizons;

namespace
{
using Links = std::set<std::array<int, 3>>; // x, y and side

/// Cuts some links of a box, one of which twice, and compares them and those around.
void CheckBox(const PlaneBox& box, int number)
{
  Patches::Random random(7);
  const auto draw = [&random](int least, int greatest) { return least + random.Below(greatest - least + 1); };
  LinkCuts cuts(box);
  Links links;
  for (int n = 0; n < number; ++n)
  {
    const PlanePoint column{ draw(box.Least.X, box.Greatest.X), draw(box.Least.Y, box.Greatest.Y) };
    const bool isNorth = random.Below(2) == 1;
    isNorth ? cuts.CutNorth(column) : cuts.CutEast(column);
    links.insert({ column.X, column.Y, isNorth ? 1 : 0 });
  }
  const LinkCuts copy = cuts;
  for (const auto& [x, y, side] : links)
  {
    for (int shift = -8; shift <= 8; ++shift)
    {
      for (const PlanePoint& column : { PlanePoint{ x + shift, y }, { x, y + shift } })
      {
        CHECK_EQUAL(cuts.IsCutEast(column), links.count({ column.X, column.Y, 0 }) == 1);
        CHECK_EQUAL(copy.IsCutNorth(column), links.count({ column.X, column.Y, 1 }) == 1);
      }
    }
  }
}

void NothingIsCutAtFirst()
{
  const LinkCuts cuts(PlaneBox({ { -3, -3 }, { 3, 3 } }));
  for (int x = -5; x <= 5; ++x)
  {
    CHECK(!cuts.IsCutEast({ x, x }) && !cuts.IsCutNorth({ x, -x }));
  }
}
}

int TestLinkCuts(int, char*[])
{
  NothingIsCutAtFirst();
  CheckBox(PlaneBox({ { -20, -9 }, { 30, 40 } }), 2000);
  CheckBox(PlaneBox({ { 100, 5 }, { 100, 900 } }), 300);
  // So large that bits for all of it would not fit.
  constexpr int far = 1 << 29;
  CheckBox(PlaneBox({ { -far, -far }, { far - 1, far - 1 } }), 3000);
  return Check::Result();
}
