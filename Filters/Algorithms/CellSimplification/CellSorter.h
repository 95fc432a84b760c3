// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorts the points of a horizon into cells, on several threads.

#ifndef SeismicHorizonsCellSorter_h
#define SeismicHorizonsCellSorter_h

#include "Common/CellGrid.h"
#include "Common/Monitor.h"
#include "Common/Parallel.h"
#include "Common/Types.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// Finds the cells of places one after the other. Neighbours are likely to share theirs, which saves the divisions.
class CellFinder
{
public:
  explicit CellFinder(const CellGrid& grid)
    : Grid(grid)
    , Size(std::uint32_t(grid.CellSize()))
    , Corner(grid.Corner(0))
  {
  }

  std::int64_t operator()(const PlanePoint& place)
  {
    if (std::uint32_t(place.X - this->Corner.X) >= this->Size || std::uint32_t(place.Y - this->Corner.Y) >= this->Size)
    {
      this->Cell = this->Grid.CellOf(place);
      this->Corner = this->Grid.Corner(this->Cell);
    }
    return this->Cell;
  }

private:
  const CellGrid& Grid;
  const std::uint32_t Size;
  PlanePoint Corner;
  std::int64_t Cell = 0;
};

/// Sorts points by cell in two steps, both of them in parallel: into bands of a few rows of cells, then by cell in each
/// band. Points come in many runs, each of which knows where in every band its points go.
class CellSorter
{
public:
  CellSorter(const CellGrid& grid, const std::vector<PlanePoint>& plane, const Monitor& monitor)
    : Grid(grid)
    , Plane(plane)
    , RowsPerBand(grid.SizeY() / MostBands + 1)
    , Bands((grid.SizeY() - 1) / this->RowsPerBand + 1)
    , Runs(std::int64_t(plane.size() - 1) / RunLength + 1)
    , Next(std::size_t(this->Runs * this->Bands), 0)
    , BandEnds(std::size_t(this->Bands) + 1, 0)
    , Banded(new PointId[plane.size()])
  {
    this->ForEachRun(monitor.Step(0.0, 0.5), [](std::uint32_t& next, PointId) { ++next; });
    this->AddUp();
    this->ForEachRun(
      monitor.Step(0.5, 1.0), [this](std::uint32_t& next, PointId point) { this->Banded[next++] = point; });
  }

  /// Writes the points, and for each cell where its points begin.
  void Sort(std::vector<std::uint32_t>& begins, PointId* sorted, const Monitor& monitor) const
  {
    ParallelFor(this->Bands, 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t band = first; band < last; ++band)
        {
          this->SortBand(band, begins, sorted);
        }
      });
  }

private:
  static constexpr std::int64_t MostBands = 256;
  static constexpr std::int64_t RunLength = 65536;

  /// Calls visit(next, point) for all points, where `next` is the counter of the point's run and band.
  template <typename Visitor>
  void ForEachRun(const Monitor& monitor, Visitor&& visit)
  {
    ParallelFor(this->Runs, 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t run = first; run < last; ++run)
        {
          this->VisitRun(run, visit);
        }
      });
  }

  template <typename Visitor>
  void VisitRun(std::int64_t run, Visitor& visit)
  {
    const std::uint32_t height = std::uint32_t(
      std::min<std::int64_t>(this->RowsPerBand * this->Grid.CellSize(), std::numeric_limits<std::int32_t>::max()));
    const std::int64_t bottom = this->Grid.Corner(0).Y;
    const std::size_t end = std::min(this->Plane.size(), std::size_t((run + 1) * RunLength));
    for (std::size_t point = std::size_t(run * RunLength); point < end;)
    {
      // Points are likely to come row by row: as long as they stay in one band, its counter can stay in a register.
      const std::uint32_t band = std::uint32_t(this->Plane[point].Y - bottom) / height;
      const std::int64_t low = bottom + std::int64_t(band) * height;
      std::uint32_t next = this->Next[std::size_t(run * this->Bands + band)];
      for (; point < end && std::uint64_t(this->Plane[point].Y - low) < height; ++point)
      {
        visit(next, PointId(point));
      }
      this->Next[std::size_t(run * this->Bands + band)] = next;
    }
  }

  /// Makes places out of counts: band by band, and in a band run by run.
  void AddUp()
  {
    std::uint32_t sum = 0;
    for (std::int64_t band = 0; band < this->Bands; ++band)
    {
      for (std::int64_t run = 0; run < this->Runs; ++run)
      {
        std::uint32_t& next = this->Next[std::size_t(run * this->Bands + band)];
        sum += next;
        next = sum - next;
      }
      this->BandEnds[std::size_t(band) + 1] = sum;
    }
  }

  void SortBand(std::int64_t band, std::vector<std::uint32_t>& begins, PointId* sorted) const
  {
    const PointId* const first = this->Banded.get() + this->BandEnds[std::size_t(band)];
    const PointId* const last = this->Banded.get() + this->BandEnds[std::size_t(band) + 1];
    const std::int64_t firstCell = band * this->RowsPerBand * this->Grid.SizeX();
    const std::int64_t lastCell = std::min(this->Grid.Size(), firstCell + this->RowsPerBand * this->Grid.SizeX());
    // Counts, then ends, from which the points are filled in backwards; so they come to be where the cells begin.
    std::uint32_t* const ends = begins.data();
    CellFinder cellOf(this->Grid);
    const auto counter = [&](PointId point) -> std::uint32_t& { return ends[cellOf(this->Plane[std::size_t(point)])]; };
    std::for_each(first, last, [&](PointId point) { ++counter(point); });
    std::uint32_t sum = this->BandEnds[std::size_t(band)];
    for (std::int64_t cell = firstCell; cell < lastCell; ++cell)
    {
      sum += ends[cell];
      ends[cell] = sum;
    }
    for (const PointId* point = last; point != first;)
    {
      --point;
      sorted[--counter(*point)] = *point;
    }
  }

  const CellGrid& Grid;
  const std::vector<PlanePoint>& Plane;
  const std::int64_t RowsPerBand;
  const std::int64_t Bands;
  const std::int64_t Runs;
  std::vector<std::uint32_t> Next;
  std::vector<std::uint32_t> BandEnds;
  std::unique_ptr<PointId[]> Banded;
};
}

#endif
