// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points are sorted into cells on several threads, then the cells that faults cut are divided into sides.
//
// Sorting counts the points of each batch (a range of the input) in each band (a few rows of squares), copies points to
// their bands, and sorts each band by square: by comparing if it has far more squares than points, else by counting.
//
//    input   | batch 0 | batch 1 | ...        Each batch knows where its points begin in each band, so that threads
//    banded  | 0 1 ... | 0 1 ... | ...        need no locks and points keep their order.
//              band 0    band 1
//
// Links that are not cut connect the columns of a side. A crack that ends in the cell would leave one side around its
// tip; it is continued straight to the border of the cell or to another crack, so that its cutoffs are on different
// sides:
//
//       a a a a a a
//       a a a a a a
//       ====== - - -      a, b    sides of a cell
//       b b b b b b       =       a crack, continued by -

#include "CellLeaves.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <map>
#include <string>

namespace SeismicHorizons
{
namespace
{
// With more bands, the places that a thread writes to in turn would not fit into its cache.
constexpr std::int64_t MostBands = 256;
constexpr std::int64_t PointsPerBatch = 65536;
// With more squares, counters and an index of squares would cost more than sorting and searching.
constexpr std::int64_t MostSquaresPerPoint = 16;

constexpr std::int32_t NoSide = -1;

std::int64_t CheckedCellSize(const BoundedHorizon& horizon, int columns)
{
  CheckAtLeast("cell size", columns, 1, " column");
  return std::int64_t(columns) * horizon.SubVoxelsPerColumn;
}

CellGrid MakeGrid(const SubVoxelPlaces& places, std::int32_t subVoxelsPerColumn, std::int64_t cellSize)
{
  const PlaneBox box = places.Box();
  return CellGrid({ box.Least, box.Greatest }, subVoxelsPerColumn, cellSize);
}

//----------------------------------------------------------------------------------------------------------------------
// Sorting

class SquareFinder
{
public:
  explicit SquareFinder(const CellGrid& grid)
    : Grid(grid)
    , Size(std::uint32_t(grid.CellSize()))
    , Corner(grid.Corner(0))
  {
  }

  std::int64_t operator()(const PlanePoint& place)
  {
    if (std::uint32_t(place.X - this->Corner.X) >= this->Size || std::uint32_t(place.Y - this->Corner.Y) >= this->Size)
    {
      this->Square = this->Grid.CellOf(place);
      this->Corner = this->Grid.Corner(this->Square);
    }
    return this->Square;
  }

private:
  const CellGrid& Grid;
  const std::uint32_t Size;
  PlanePoint Corner;
  std::int64_t Square = 0;
};

class CellSorter
{
public:
  CellSorter(const CellGrid& grid, const SubVoxelPlaces& plane, const Monitor& monitor)
    : Grid(grid)
    , Plane(plane)
    , RowsPerBand(grid.SizeY() / MostBands + 1)
    , Bands((grid.SizeY() - 1) / this->RowsPerBand + 1)
    , Batches(std::int64_t(plane.size() - 1) / PointsPerBatch + 1)
    , Next(this->Batches * this->Bands, 0)
    , BandEnds(this->Bands + 1, 0)
    , Banded(new PointId[plane.size()])
  {
    this->ForEachPoint(monitor.Step(0.0, 0.5), [](std::uint32_t& next, PointId) { ++next; });
    this->AddUp();
    this->ForEachPoint(
      monitor.Step(0.5, 1.0), [this](std::uint32_t& next, PointId point) { this->Banded[next++] = point; });
  }

  std::vector<CellLeaves::Starts> Sort(PointId* sorted, const Monitor& monitor) const
  {
    std::vector<CellLeaves::Starts> starts(this->Bands);
    ParallelFor(this->Bands, 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t band = first; band < last; ++band)
        {
          this->SortBand(band, starts[band], sorted);
        }
      });
    return starts;
  }

private:
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
      // Points mostly come row by row, so that the counter of a band can stay in a register.
      const std::uint32_t band = std::uint32_t(this->Plane[point].Y - bottom) / height;
      const std::int64_t low = bottom + std::int64_t(band) * height;
      std::uint32_t next = this->Next[batch * this->Bands + band];
      for (; point < end && std::uint64_t(this->Plane[point].Y - low) < height; ++point)
      {
        visit(next, PointId(point));
      }
      this->Next[batch * this->Bands + band] = next;
    }
  }

  /// Counts become positions, band by band, and batch by batch within a band.
  void AddUp()
  {
    std::uint32_t sum = 0;
    for (std::int64_t band = 0; band < this->Bands; ++band)
    {
      for (std::int64_t batch = 0; batch < this->Batches; ++batch)
      {
        std::uint32_t& next = this->Next[batch * this->Bands + band];
        sum += next;
        next = sum - next;
      }
      this->BandEnds[band + 1] = sum;
    }
  }

  void SortBand(std::int64_t band, CellLeaves::Starts& starts, PointId* sorted) const
  {
    const std::int64_t firstSquare = band * this->RowsPerBand * this->Grid.SizeX();
    const std::int64_t squares = std::min(this->Grid.Size() - firstSquare, this->RowsPerBand * this->Grid.SizeX());
    const std::int64_t points = this->BandEnds[band + 1] - this->BandEnds[band];
    if (squares <= MostSquaresPerPoint * points)
    {
      this->SortByCounting(band, firstSquare, squares, starts, sorted);
    }
    else if (points > 0)
    {
      this->SortByComparing(band, starts, sorted);
    }
  }

  void SortByCounting(std::int64_t band, std::int64_t firstSquare, std::int64_t squares, CellLeaves::Starts& starts,
    PointId* sorted) const
  {
    // Points are filled in backwards, which moves the end of each square down to its begin.
    std::vector<std::uint32_t> ends(squares, 0);
    SquareFinder squareOf(this->Grid);
    const auto counter = [&](PointId point) -> std::uint32_t&
    { return ends[squareOf(this->Plane[point]) - firstSquare]; };
    const PointId* const first = this->Banded.get() + this->BandEnds[band];
    const PointId* const last = this->Banded.get() + this->BandEnds[band + 1];
    std::for_each(first, last, [&](PointId point) { ++counter(point); });
    starts.reserve(std::min<std::int64_t>(squares, last - first));
    std::uint32_t sum = this->BandEnds[band];
    for (std::int64_t square = 0; square < squares; ++square)
    {
      if (ends[square] > 0)
      {
        starts.emplace_back(firstSquare + square, sum);
      }
      sum += ends[square];
      ends[square] = sum;
    }
    for (const PointId* point = last; point != first;)
    {
      --point;
      sorted[--counter(*point)] = *point;
    }
  }

  void SortByComparing(std::int64_t band, CellLeaves::Starts& starts, PointId* sorted) const
  {
    SquareFinder squareOf(this->Grid);
    std::vector<std::pair<std::int64_t, PointId>> keyed;
    for (std::uint32_t n = this->BandEnds[band]; n < this->BandEnds[band + 1]; ++n)
    {
      keyed.emplace_back(squareOf(this->Plane[this->Banded[n]]), this->Banded[n]);
    }
    std::sort(keyed.begin(), keyed.end()); // The points of a band are in ascending order.
    std::uint32_t next = this->BandEnds[band];
    for (const auto& [square, point] : keyed)
    {
      if (starts.empty() || starts.back().first != square)
      {
        starts.emplace_back(square, next);
      }
      sorted[next++] = point;
    }
  }

  const CellGrid& Grid;
  const SubVoxelPlaces Plane;
  const std::int64_t RowsPerBand;
  const std::int64_t Bands;
  const std::int64_t Batches;
  std::vector<std::uint32_t> Next; // counts, then positions, by batch and band
  std::vector<std::uint32_t> BandEnds;
  std::unique_ptr<PointId[]> Banded;
};

//----------------------------------------------------------------------------------------------------------------------
// Sides

class CellSides
{
public:
  CellSides(const LinkCuts& cuts, std::int32_t width, std::int32_t height)
    : Cuts(cuts)
    , Width(width)
    , Height(height)
  {
  }

  bool HasCut(const PlanePoint& cell) const
  {
    for (std::int32_t y = cell.Y; y < cell.Y + this->Height; ++y)
    {
      for (std::int32_t x = cell.X; x < cell.X + this->Width; ++x)
      {
        if ((x + 1 < cell.X + this->Width && this->Cuts.IsCutEast({ x, y })) ||
          (y + 1 < cell.Y + this->Height && this->Cuts.IsCutNorth({ x, y })))
        {
          return true;
        }
      }
    }
    return false;
  }

  void Find(const PlanePoint& cell)
  {
    this->Cell = cell;
    this->ReadCuts();
    for (std::int32_t y = 0; y + 1 < this->Height; ++y)
    {
      for (std::int32_t x = 0; x + 1 < this->Width; ++x)
      {
        this->CarryOn(x, y);
      }
    }
    this->Side.assign(this->East.size(), NoSide);
    std::int32_t sides = 0;
    for (std::size_t place = 0; place < this->Side.size(); ++place)
    {
      if (this->Side[place] == NoSide)
      {
        this->NumberSide(place, sides++);
      }
    }
  }

  std::int32_t operator[](const PlanePoint& column) const
  {
    return this->Side[this->Place(column.X - this->Cell.X, column.Y - this->Cell.Y)];
  }

private:
  std::size_t Place(std::int32_t x, std::int32_t y) const
  {
    return std::size_t(y) * std::size_t(this->Width) + std::size_t(x);
  }

  void ReadCuts()
  {
    const std::size_t columns = std::size_t(this->Width) * std::size_t(this->Height);
    this->East.assign(columns, 0);
    this->North.assign(columns, 0);
    for (std::int32_t y = 0; y < this->Height; ++y)
    {
      for (std::int32_t x = 0; x < this->Width; ++x)
      {
        const PlanePoint column{ this->Cell.X + x, this->Cell.Y + y };
        this->East[this->Place(x, y)] = this->Cuts.IsCutEast(column) ? 1 : 0;
        this->North[this->Place(x, y)] = this->Cuts.IsCutNorth(column) ? 1 : 0;
      }
    }
  }

  /// A cut through one side of a block of four columns is continued through the opposite side.
  void CarryOn(std::int32_t x, std::int32_t y)
  {
    while (x >= 0 && y >= 0 && x + 1 < this->Width && y + 1 < this->Height)
    {
      // The order is below, above, left, right, so that the opposite side has the index xor 1.
      const std::array<unsigned char*, 4> sides = { &this->East[this->Place(x, y)], &this->East[this->Place(x, y + 1)],
        &this->North[this->Place(x, y)], &this->North[this->Place(x + 1, y)] };
      if (std::count_if(sides.begin(), sides.end(), [](const unsigned char* side) { return *side != 0; }) != 1)
      {
        return;
      }
      const auto cut = std::find_if(sides.begin(), sides.end(), [](const unsigned char* side) { return *side != 0; });
      const std::size_t ahead = std::size_t(cut - sides.begin()) ^ 1U;
      *sides[ahead] = 1;
      constexpr std::array<PlanePoint, 4> steps = { { { 0, -1 }, { 0, 1 }, { -1, 0 }, { 1, 0 } } };
      x += steps[ahead].X;
      y += steps[ahead].Y;
    }
  }

  void NumberSide(std::size_t first, std::int32_t number)
  {
    const std::size_t row = std::size_t(this->Width);
    this->Open.assign(1, first);
    this->Side[first] = number;
    const auto reach = [&](bool isJoined, std::size_t place)
    {
      if (isJoined && this->Side[place] == NoSide)
      {
        this->Side[place] = number;
        this->Open.push_back(place);
      }
    };
    while (!this->Open.empty())
    {
      const std::size_t place = this->Open.back();
      this->Open.pop_back();
      const std::size_t x = place % row;
      reach(x + 1 < row && this->East[place] == 0, place + 1);
      reach(place + row < this->Side.size() && this->North[place] == 0, place + row);
      reach(x > 0 && this->East[place - 1] == 0, place - 1);
      reach(place >= row && this->North[place - row] == 0, place - row);
    }
  }

  const LinkCuts& Cuts;
  const std::int32_t Width;
  const std::int32_t Height;
  PlanePoint Cell{};
  std::vector<unsigned char> East;
  std::vector<unsigned char> North;
  std::vector<std::int32_t> Side;
  std::vector<std::size_t> Open;
};
}

//----------------------------------------------------------------------------------------------------------------------
CellLeaves::CellLeaves(const BoundedHorizon& horizon, int columns, const Monitor& monitor)
  : Input(horizon)
  , Given(horizon.Places())
  , Scale(1.0 / horizon.SubVoxelsPerColumn)
  , Side(CheckedCellSize(horizon, columns))
  , Cells(MakeGrid(this->Given, horizon.SubVoxelsPerColumn, this->Side))
  , OnBoundary(horizon.Boundary.MarkPoints(this->Given.size()))
  , Marks(this->Given.size(), 0)
{
  assert(horizon.Height.size() == this->Given.size() && horizon.Patch.size() == this->Given.size());
  monitor.Progress(0.0);
  this->Points.reset(new PointId[this->Given.size()]); // A vector would write to all of its memory on one thread.
  const CellSorter sorter(this->Cells, this->Given, monitor.Step(0.0, 0.5));
  this->MakeCells(sorter.Sort(this->Points.get(), monitor.Step(0.5, 1.0)));
  this->IndexSquares();
  if (horizon.Cuts)
  {
    this->FindSides();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CellLeaves::MakeCells(const std::vector<Starts>& bands)
{
  std::vector<std::size_t> firsts;
  std::size_t size = 0;
  for (const Starts& starts : bands)
  {
    firsts.push_back(size);
    size += starts.size();
  }
  this->Squares.resize(size);
  this->CellBegins.assign(size + 1, std::uint32_t(this->Given.size()));
  ParallelFor(std::int64_t(bands.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t band = first; band < last; ++band)
      {
        std::size_t cell = firsts[band];
        for (const auto& [square, begin] : bands[band])
        {
          this->Squares[cell] = square;
          this->CellBegins[cell] = begin;
          ++cell;
        }
      }
    });
  assert(std::is_sorted(this->Squares.begin(), this->Squares.end()));
}

//----------------------------------------------------------------------------------------------------------------------
void CellLeaves::IndexSquares()
{
  if (this->Cells.Size() > MostSquaresPerPoint * this->NumberOfCells())
  {
    return;
  }
  this->FirstCells.resize(this->Cells.Size() + 1, std::uint32_t(this->NumberOfCells()));
  std::int64_t next = 0;
  for (std::int64_t cell = 0; cell < this->NumberOfCells(); ++cell)
  {
    for (; next <= this->Squares[cell]; ++next)
    {
      this->FirstCells[next] = std::uint32_t(cell);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The first side of a patch in a cell keeps the number of the patch, further sides get new numbers.
void CellLeaves::FindSides()
{
  this->Sides = this->Input.Patch;
  std::int64_t next = std::int64_t(*std::max_element(this->Sides.begin(), this->Sides.end())) + 1;
  // A cell may be far larger than the horizon.
  const PlaneBox box = this->Given.Box();
  const std::int64_t column = this->Input.SubVoxelsPerColumn;
  const auto columns = [&](std::int64_t least, std::int64_t greatest)
  { return std::int32_t(std::min(this->Side / column, (greatest - least) / column + 2)); };
  CellSides sides(*this->Input.Cuts, columns(box.Least.X, box.Greatest.X), columns(box.Least.Y, box.Greatest.Y));
  for (std::int64_t cell = 0; cell < this->NumberOfCells(); ++cell)
  {
    const PlanePoint corner = this->Cells.Corner(this->Squares[cell]);
    const PlanePoint least{ std::int32_t(corner.X / column), std::int32_t(corner.Y / column) };
    if (!sides.HasCut(least))
    {
      continue;
    }
    sides.Find(least);
    std::map<std::int32_t, std::map<std::int32_t, std::int32_t>> numbers;
    for (const PointId* point = this->Begin(cell); point != this->Begin(cell + 1); ++point)
    {
      const std::int32_t patch = this->Patch(*point);
      std::map<std::int32_t, std::int32_t>& ofPatch = numbers[patch];
      const auto side = ofPatch.emplace(sides[this->ColumnOf(*point)], patch);
      if (side.second && ofPatch.size() > 1)
      {
        side.first->second = std::int32_t(next++);
      }
      this->Sides[*point] = side.first->second;
    }
  }
  if (next > std::numeric_limits<std::int32_t>::max())
  {
    throw InputError("patch numbers up to " +
      std::to_string(*std::max_element(this->Input.Patch.begin(), this->Input.Patch.end())) +
      ", expected lower ones: with the sides of cut cells there are too many");
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Only columns of the cell that contains the point are candidates.
PlanePoint CellLeaves::ColumnOf(PointId point) const
{
  const std::int64_t column = this->Input.SubVoxelsPerColumn;
  const PlanePoint place = this->Plane(point);
  const PlanePoint corner = this->Cells.Corner(this->Cells.CellOf(place));
  const auto nearest = [&](std::int64_t at, std::int64_t least)
  {
    const std::int64_t columns = std::min((at - least + column / 2) / column, this->Side / column - 1);
    return std::int32_t(least / column + columns);
  };
  return { nearest(place.X, corner.X), nearest(place.Y, corner.Y) };
}

//----------------------------------------------------------------------------------------------------------------------
std::uint32_t CellLeaves::CountMerging(std::int64_t cell) const
{
  const auto begin = this->Marks.begin() + this->CellBegins[cell];
  const auto end = this->Marks.begin() + this->CellBegins[cell + 1];
  return std::uint32_t(std::count_if(begin, end, [](unsigned mark) { return MergesInner(mark); }));
}
}
