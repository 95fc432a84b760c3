// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapSearch.h"

#include "Common/DisjointSets.h"

namespace SeismicHorizons
{
namespace
{
/// The runs of empty columns of all rows, as sets of connected ones. The first row is the rim of the raster: its run
/// stands for the outside.
class EmptyRuns
{
public:
  explicit EmptyRuns(const ColumnRaster& raster)
    : Raster(raster)
  {
    std::size_t before = 0;
    for (std::int64_t row = 0; row < raster.Height(); ++row)
    {
      const std::size_t begin = this->Runs.size();
      this->AddRow(row);
      this->JoinRows(before, begin);
      before = begin;
    }
  }

  GapList Gaps()
  {
    GapList result;
    std::vector<std::int32_t> gap(this->Runs.size(), NoGap);
    for (std::size_t run = 0; run < this->Runs.size(); ++run)
    {
      const std::size_t root = std::size_t(this->Sets.Find(std::int32_t(run)));
      if (root == 0)
      {
        continue;
      }
      if (root == run)
      {
        gap[run] = std::int32_t(result.Size());
        result.Columns.push_back(0);
        result.Ends.push_back(0);
      }
      gap[run] = gap[root]; // the least number of a set stands for it, so that it came before
      ++result.Ends[std::size_t(gap[run])];
      result.Columns[std::size_t(gap[run])] += this->Runs[run].Last - this->Runs[run].First + 1;
    }
    this->SortRuns(gap, result);
    return result;
  }

private:
  static constexpr std::int32_t NoGap = -1;

  void AddRow(std::int64_t row)
  {
    const std::int64_t end = (row + 1) * this->Raster.Width();
    bool wasEmpty = false;
    for (std::int64_t place = row * this->Raster.Width(); place < end; ++place)
    {
      const bool isEmpty = this->Raster[place] == NoPoint;
      if (isEmpty && !wasEmpty)
      {
        this->Runs.push_back({ place, place });
        this->Sets.Add();
      }
      else if (isEmpty)
      {
        this->Runs.back().Last = place;
      }
      wasEmpty = isEmpty;
    }
  }

  /// Joins the runs from `begin` on with those of the row before, which are from `before` on.
  void JoinRows(std::size_t before, std::size_t begin)
  {
    std::size_t a = before;
    std::size_t b = begin;
    while (a < begin && b < this->Runs.size())
    {
      const GapRun below = { this->Runs[a].First + this->Raster.Width(), this->Runs[a].Last + this->Raster.Width() };
      const GapRun& run = this->Runs[b];
      if (below.First <= run.Last && run.First <= below.Last)
      {
        this->Sets.Join(std::int32_t(a), std::int32_t(b));
      }
      ++(below.Last < run.Last ? a : b);
    }
  }

  /// Puts the runs of each gap one after the other. `result.Ends` has the number of runs of each gap.
  void SortRuns(const std::vector<std::int32_t>& gap, GapList& result) const
  {
    std::size_t sum = 0;
    for (std::size_t& end : result.Ends)
    {
      const std::size_t count = end;
      end = sum;
      sum += count;
    }
    result.Runs.resize(sum);
    for (std::size_t run = 0; run < gap.size(); ++run)
    {
      if (gap[run] != NoGap)
      {
        result.Runs[result.Ends[std::size_t(gap[run])]++] = this->Runs[run];
      }
    }
  }

  const ColumnRaster& Raster;
  std::vector<GapRun> Runs;
  DisjointSets Sets;
};
}

//----------------------------------------------------------------------------------------------------------------------
GapList FindGaps(const ColumnRaster& raster)
{
  return EmptyRuns(raster).Gaps();
}
}
