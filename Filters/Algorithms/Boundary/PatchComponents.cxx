// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A row is cut into runs whose points follow each other by hops. Every column from k before the first point of a run to
// k after its last is at most k away from some point of the run. So two runs in rows at most k apart are connected when
// one, extended in this way, overlaps the other, whatever gaps they have.

#include "PatchComponents.h"

#include "Common/DisjointSets.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
/// Points in a row of the raster that follow each other by hops.
struct Run
{
  std::int32_t First; // column of the raster
  std::int32_t Last;
  std::int32_t Set;
};

/// The runs of all rows, as sets of connected ones.
class RunList
{
public:
  RunList(const ColumnRaster& raster, int radius)
    : Raster(raster)
    , Radius(radius)
    , RowEnds(1, 0)
  {
  }

  void AddRow(std::int64_t row)
  {
    const std::int64_t width = this->Raster.Width();
    const std::size_t begin = this->Runs.size();
    for (std::int64_t x = 0; x < width; ++x)
    {
      if (this->Raster[row * width + x] == NoPoint)
      {
        continue;
      }
      if (this->Runs.size() > begin && x - this->Runs.back().Last <= this->Radius)
      {
        this->Runs.back().Last = std::int32_t(x);
      }
      else
      {
        this->Runs.push_back({ std::int32_t(x), std::int32_t(x), this->Sets.Add() });
      }
    }
    this->RowEnds.push_back(this->Runs.size());
    for (std::int64_t below = std::max<std::int64_t>(0, row - this->Radius); below < row; ++below)
    {
      this->JoinRows(std::size_t(below), std::size_t(row));
    }
  }

  /// Numbers the components and their points.
  void Number(PatchComponents& result)
  {
    std::vector<std::int32_t> number(this->Runs.size(), -1);
    for (std::size_t row = 0; row + 1 < this->RowEnds.size(); ++row)
    {
      for (std::size_t n = this->RowEnds[row]; n < this->RowEnds[row + 1]; ++n)
      {
        this->NumberRun(std::int64_t(row) * this->Raster.Width(), this->Runs[n], number, result);
      }
    }
  }

private:
  void JoinRows(std::size_t rowA, std::size_t rowB)
  {
    std::size_t a = this->RowEnds[rowA];
    std::size_t b = this->RowEnds[rowB];
    while (a < this->RowEnds[rowA + 1] && b < this->RowEnds[rowB + 1])
    {
      const Run& runA = this->Runs[a];
      const Run& runB = this->Runs[b];
      if (runA.First <= runB.Last + this->Radius && runB.First <= runA.Last + this->Radius)
      {
        this->Sets.Join(runA.Set, runB.Set);
      }
      // The run that ends first is done: the next one of the other row begins more than k columns further on.
      ++(runA.Last < runB.Last ? a : b);
    }
  }

  void NumberRun(std::int64_t rowPlace, const Run& run, std::vector<std::int32_t>& number, PatchComponents& result)
  {
    std::int32_t& component = number[std::size_t(this->Sets.Find(run.Set))];
    if (component < 0)
    {
      component = std::int32_t(result.First.size());
      result.First.push_back(rowPlace + run.First);
    }
    for (std::int64_t place = rowPlace + run.First; place <= rowPlace + run.Last; ++place)
    {
      if (this->Raster[place] != NoPoint)
      {
        result.Component[std::size_t(this->Raster[place])] = component;
      }
    }
  }

  const ColumnRaster& Raster;
  const int Radius;
  std::vector<Run> Runs;
  std::vector<std::size_t> RowEnds;
  DisjointSets Sets;
};
}

//----------------------------------------------------------------------------------------------------------------------
PatchComponents FindPatchComponents(const ColumnRaster& raster, std::size_t points, int radius)
{
  RunList runs(raster, radius);
  for (std::int64_t row = 0; row < raster.Height(); ++row)
  {
    runs.AddRow(row);
  }
  PatchComponents result;
  result.Component.resize(points, -1);
  runs.Number(result);
  return result;
}
}
