// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BestFirstJoining.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// By how much the sides of windows grow from level to level.
constexpr int SideGrowth = 4;
}

//----------------------------------------------------------------------------------------------------------------------
void BestFirstJoining::Run(const ReflectionLinks& links, const JoiningRules& rules, const Monitor& monitor)
{
  const PartFit fit(this->Picks, links, rules, this->Sets);
  const int all = std::max(this->Picks.Columns[0], this->Picks.Columns[1]);
  int side = std::exchange(this->AreSingle, false) ? this->FirstSide() : all;
  std::vector<JoiningWindow> windows = this->MakeWindows(side);
  constexpr double last = 0.6; // where the window of all columns begins, of the work
  double done = 0.0;
  while (windows.size() > 1)
  {
    const double next = 0.5 * (done + last);
    ParallelFor(std::int64_t(windows.size()), 1, monitor.Step(done, next),
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          JoinWindow(fit, this->Sets, windows[std::size_t(n)], Monitor());
        }
      });
    done = next;
    side = side < all / SideGrowth ? side * SideGrowth : all;
    windows = this->MergeWindows(windows, side);
  }
  windows.front().Columns.merge(this->Columns);
  JoinWindow(fit, this->Sets, windows.front(), monitor.Step(last, 0.9));
  JoinRefused(fit, this->Sets, windows.front(), monitor.Step(0.9, 1.0));
  this->Columns = std::move(windows.front().Columns);
}

//----------------------------------------------------------------------------------------------------------------------
int BestFirstJoining::FirstSide() const
{
  const double columns = double(this->Picks.Columns[0]) * double(this->Picks.Columns[1]);
  const double perColumn = std::max(1.0, double(this->Picks.Size()) / columns);
  return std::max(1, int(std::sqrt(this->WindowPicks / perColumn)));
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<JoiningWindow> BestFirstJoining::MakeWindows(int side) const
{
  std::vector<JoiningWindow> windows;
  for (int j = 0; j < this->Picks.Columns[1]; j += side)
  {
    for (int i = 0; i < this->Picks.Columns[0]; i += side)
    {
      windows.emplace_back();
      windows.back().FirstI = i;
      windows.back().EndI = std::min(i + side, this->Picks.Columns[0]);
      windows.back().FirstJ = j;
      windows.back().EndJ = std::min(j + side, this->Picks.Columns[1]);
    }
  }
  return windows;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<JoiningWindow> BestFirstJoining::MergeWindows(std::vector<JoiningWindow>& windows, int side) const
{
  std::vector<JoiningWindow> merged = this->MakeWindows(side);
  const int perRow = (this->Picks.Columns[0] + side - 1) / side;
  for (JoiningWindow& window : windows)
  {
    JoiningWindow& target = merged[std::size_t(window.FirstJ / side * perRow + window.FirstI / side)];
    target.IsFirst = false;
    target.Left.insert(target.Left.end(), window.Left.begin(), window.Left.end());
    target.Refused.insert(target.Refused.end(), window.Refused.begin(), window.Refused.end());
    target.Refusals.merge(window.Refusals);
    target.Columns.merge(window.Columns);
    window = JoiningWindow();
  }
  return merged;
}
}
