// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoxPlaces.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr auto IsRunBefore = [](const BoxRun& a, const BoxRun& b)
{ return a.Row != b.Row ? a.Row < b.Row : a.First < b.First; };

std::vector<BoxRun> Widened(const std::vector<BoxRun>& runs, int reach)
{
  const std::vector<BoxRun> narrow = Merged(runs);
  std::vector<BoxRun> wide;
  wide.reserve(narrow.size() * std::size_t(2 * reach + 1));
  for (const BoxRun& run : narrow)
  {
    for (int dy = -reach; dy <= reach; ++dy)
    {
      wide.push_back({ run.Row + dy, run.First - reach, run.Last + reach });
    }
  }
  return Merged(std::move(wide));
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<BoxRun> Merged(std::vector<BoxRun> runs)
{
  if (!std::is_sorted(runs.begin(), runs.end(), IsRunBefore))
  {
    std::sort(runs.begin(), runs.end(), IsRunBefore);
  }
  std::size_t kept = 0;
  for (const BoxRun& run : runs)
  {
    if (kept > 0 && runs[kept - 1].Row == run.Row && run.First <= runs[kept - 1].Last + 1)
    {
      runs[kept - 1].Last = std::max(runs[kept - 1].Last, run.Last);
    }
    else
    {
      runs[kept++] = run;
    }
  }
  runs.resize(kept);
  return runs;
}

//----------------------------------------------------------------------------------------------------------------------
BoxPlaces::BoxPlaces(const std::vector<BoxRun>& runs, int reach)
  : Runs(Widened(runs, reach))
{
  assert(reach >= 2);
  std::int64_t size = 0;
  for (const BoxRun& run : this->Runs)
  {
    this->Begins.push_back(size);
    size += std::int64_t(run.Last) - run.First + 1;
  }
  this->Places.reserve(std::size_t(size));
  std::size_t below = 0;
  for (std::size_t n = 0; n < this->Runs.size(); ++n)
  {
    const BoxRun& run = this->Runs[n];
    for (std::int32_t x = run.First; x <= run.Last; ++x)
    {
      const std::int64_t place = this->Size();
      this->Places.push_back({ { x, run.Row } });
      while (
        this->Runs[below].Row < run.Row - 1 || (this->Runs[below].Row == run.Row - 1 && this->Runs[below].Last < x))
      {
        ++below;
      }
      if (this->Runs[below].Row == run.Row - 1 && this->Runs[below].First <= x)
      {
        const std::int64_t other = this->Begins[below] + (x - this->Runs[below].First);
        this->Places.back().ToBelow = std::int32_t(place - other);
        this->Places[std::size_t(other)].ToAbove = std::int32_t(place - other);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t BoxPlaces::Find(const PlanePoint& column) const
{
  const BoxRun wanted = { column.Y, column.X, column.X };
  const auto after = std::upper_bound(this->Runs.begin(), this->Runs.end(), wanted, IsRunBefore);
  assert(after != this->Runs.begin());
  const std::size_t run = std::size_t(after - this->Runs.begin()) - 1;
  assert(this->Runs[run].Row == column.Y && column.X <= this->Runs[run].Last);
  return this->Begins[run] + (column.X - this->Runs[run].First);
}
}
