// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps, each of them in parallel: count how many points of each batch go into each band; copy the points to their
// bands; sort each band by cell. A band is a few rows of cells, a batch a range of the input.
//
//     input   | batch 0 | batch 1 | ...        Every batch knows where its points begin in every band,
//     banded  | 0 1 ... | 0 1 ... | ...        so that no thread waits for another, and points keep their order.
//               band 0    band 1

#include "CellSorter.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace SeismicHorizons
{
namespace
{
// With more bands, the places that a thread writes to in turn would no longer fit into its cache.
constexpr std::int64_t MostBands = 256;
constexpr std::int64_t PointsPerBatch = 65536;

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

class CellSorter
{
public:
  CellSorter(const CellGrid& grid, const std::vector<PlanePoint>& plane, const Monitor& monitor)
    : Grid(grid)
    , Plane(plane)
    , RowsPerBand(grid.SizeY() / MostBands + 1)
    , Bands((grid.SizeY() - 1) / this->RowsPerBand + 1)
    , Batches(std::int64_t(plane.size() - 1) / PointsPerBatch + 1)
    , Next(std::size_t(this->Batches * this->Bands), 0)
    , BandEnds(std::size_t(this->Bands) + 1, 0)
    , Banded(new PointId[plane.size()])
  {
    this->ForEachPoint(monitor.Step(0.0, 0.5), [](std::uint32_t& next, PointId) { ++next; });
    this->AddUp();
    this->ForEachPoint(
      monitor.Step(0.5, 1.0), [this](std::uint32_t& next, PointId point) { this->Banded[next++] = point; });
  }

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
  /// Calls visit(next, point) for all points, where `next` is the counter of the point's batch and band.
  template <typename Visitor>
  void ForEachPoint(const Monitor& monitor, Visitor&& visit)
  {
    ParallelFor(this->Batches, 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t batch = first; batch < last; ++batch)
        {
          this->VisitBatch(batch, visit);
        }
      });
  }

  template <typename Visitor>
  void VisitBatch(std::int64_t batch, Visitor& visit)
  {
    const std::uint32_t height = std::uint32_t(
      std::min<std::int64_t>(this->RowsPerBand * this->Grid.CellSize(), std::numeric_limits<std::int32_t>::max()));
    const std::int64_t bottom = this->Grid.Corner(0).Y;
    const std::size_t end = std::min(this->Plane.size(), std::size_t((batch + 1) * PointsPerBatch));
    for (std::size_t point = std::size_t(batch * PointsPerBatch); point < end;)
    {
      // Points are likely to come row by row: as long as they stay in one band, its counter can stay in a register.
      const std::uint32_t band = std::uint32_t(this->Plane[point].Y - bottom) / height;
      const std::int64_t low = bottom + std::int64_t(band) * height;
      std::uint32_t next = this->Next[std::size_t(batch * this->Bands + band)];
      for (; point < end && std::uint64_t(this->Plane[point].Y - low) < height; ++point)
      {
        visit(next, PointId(point));
      }
      this->Next[std::size_t(batch * this->Bands + band)] = next;
    }
  }

  /// Makes positions out of counts: band by band, and in a band batch by batch.
  void AddUp()
  {
    std::uint32_t sum = 0;
    for (std::int64_t band = 0; band < this->Bands; ++band)
    {
      for (std::int64_t batch = 0; batch < this->Batches; ++batch)
      {
        std::uint32_t& next = this->Next[std::size_t(batch * this->Bands + band)];
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
    // First the counts, then where each cell ends. Points are filled in from the last one to the first, which takes
    // each of these ends down to where its cell begins.
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
  const std::int64_t Batches;
  std::vector<std::uint32_t> Next; // for each batch and band: how many points, then where the next one goes
  std::vector<std::uint32_t> BandEnds; // where the points of each band begin, and at the end their number
  std::unique_ptr<PointId[]> Banded; // the points, band by band
};
}

//----------------------------------------------------------------------------------------------------------------------
void SortIntoCells(const CellGrid& grid, const std::vector<PlanePoint>& plane, std::vector<std::uint32_t>& begins,
  PointId* sorted, const Monitor& monitor)
{
  const CellSorter sorter(grid, plane, monitor.Step(0.0, 0.5));
  sorter.Sort(begins, sorted, monitor.Step(0.5, 1.0));
}
}
