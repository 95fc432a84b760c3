// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The smoothing of plates is chosen first. Holes are found by runs of empty columns and divided where cuts cross them;
// each section is cut out (HoleRegion.h) and filled (HoleFiller.h). Sections without a link to a known column stay open.
// Threads share small holes; large holes, which take seconds, are filled one by one.

#include "HoleFilling.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/DisjointSets.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "HoleFiller.h"
#include "HoleRegion.h"
#include "SiteSolver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Smoothing ------------------------------------------------------------------------------------------------------
// Chooses the smoothing of plates by the roughness of the horizon.
struct PlateChoice
{
  double RimSmoothing = 1.0;
  int RimWidth = 3;
};

constexpr int WidestChosenRim = 5;

constexpr PlateChoice Exact = { 0.0, 3 };
constexpr PlateChoice Little = { 1.0, 3 };
constexpr PlateChoice Much = { 32.0, WidestChosenRim };

// Utilities/Studies/hole_filling.py determined these ratios of the mean squares at l = 2 and l = 1.
constexpr double SmoothRatio = 2.4;
constexpr double NoisyRatio = 1.4;
// Rounding to integers adds a variance of 1 / 12 at each of four corners.
constexpr double RoundingSquare = 4.0 / 12.0;

class TwistSums
{
public:
  TwistSums(
    const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights, const LinkCuts* cuts)
    : Index(index)
    , Frame(frame)
    , Heights(heights)
    , Cuts(cuts)
  {
  }

  void Add(std::int64_t place)
  {
    if (!this->Index.Has(place))
    {
      return;
    }
    const double height = this->Heights[this->Index[place]];
    this->AreWhole = this->AreWhole && height == std::round(height);
    for (const std::int64_t side : { 1, 2 })
    {
      const std::int64_t above = place + side * this->Index.Width();
      if (this->Index.Has(place + side) && this->Index.Has(above) && this->Index.Has(above + side) &&
        this->IsWhole(place, side))
      {
        const double twist = height - this->Heights[this->Index[place + side]] - this->Heights[this->Index[above]] +
          this->Heights[this->Index[above + side]];
        this->Sum[side - 1] += twist * twist;
        ++this->Count[side - 1];
      }
    }
  }

  PlateChoice Choose() const
  {
    if (this->Count[0] == 0 || this->Count[1] == 0)
    {
      return Little;
    }
    const double small = this->Sum[0] / double(this->Count[0]);
    const double large = this->Sum[1] / double(this->Count[1]);
    if (this->AreWhole && small > 0.0 && small <= RoundingSquare)
    {
      return Much;
    }
    return large >= SmoothRatio * small ? Exact : large <= NoisyRatio * small ? Much : Little;
  }

private:
  bool IsWhole(std::int64_t place, std::int64_t side) const
  {
    bool isWhole = true;
    for (std::int64_t n = 0; this->Cuts && isWhole && n < (side + 1) * (side + 1); ++n)
    {
      const std::int64_t x = n % (side + 1);
      const std::int64_t y = n / (side + 1);
      const PlanePoint column = this->Frame.Column(place + y * this->Index.Width() + x);
      isWhole = !(x < side && this->Cuts->IsCutEast(column)) && !(y < side && this->Cuts->IsCutNorth(column));
    }
    return isWhole;
  }

  const ColumnIndex& Index;
  const RasterFrame& Frame;
  const std::vector<double>& Heights;
  const LinkCuts* const Cuts;
  double Sum[2] = { 0.0, 0.0 }; // for l = 1 and 2
  std::int64_t Count[2] = { 0, 0 };
  bool AreWhole = true;
};

/// The twist z(i, j) - z(i + l, j) - z(i, j + l) + z(i + l, j + l) measures roughness in squares without a cut, by the
/// ratio of its mean squares at l = 2 and l = 1: 1 for white noise, 16 for a smooth surface. Large horizons are
/// sampled.
///  - Above 2.4 there is hardly any noise, and the plate interpolates.
///  - Below 1.4, and if integer heights have twists of rounding alone, it smooths strongly.
///  - Otherwise, and without such squares, it smooths slightly.
PlateChoice ChoosePlate(
  const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights, const LinkCuts* cuts)
{
  constexpr std::int64_t enough = 250000;
  // Sampled rows are spread by the golden ratio, as noise may repeat with the rows.
  constexpr double golden = 0.6180339887498949;
  const std::int64_t width = index.Width();
  const std::int64_t rows = index.Height() - 2; // A square of size 2 reaches two rows further.
  const std::int64_t step = width * index.Height() / enough + 1;
  TwistSums twists(index, frame, heights, cuts);
  double part = 0.0;
  for (std::int64_t first = 0; first < rows; first += step)
  {
    part = part + golden < 1.0 ? part + golden : part + golden - 1.0;
    const std::int64_t row = first + std::int64_t(part * double(step));
    for (std::int64_t x = 0; x < width - 2 && row < rows; ++x)
    {
      twists.Add(row * width + x);
    }
  }
  return twists.Choose();
}

constexpr std::int64_t HolesPerTask = 16;

void CheckFillingOptions(const HoleFillingOptions& options)
{
  CheckAtLeast<std::int64_t>("largest hole size", options.LargestHoleSize, 0, " columns");
  CheckWithin("rim smoothing", options.RimSmoothing, 0.0, LargestRimSmoothing, "");
  CheckWithin("rim width", options.RimWidth, 1, LargestRimWidth, " columns");
  CheckWithin("extrapolation distance", options.ExtrapolationDistance, 0, LargestExtrapolationDistance, " columns");
}

std::vector<std::int32_t> Continued(std::vector<std::int32_t> numbers, const std::vector<bool>& isKnown)
{
  const std::size_t first = std::size_t(std::find(isKnown.begin(), isKnown.end(), true) - isKnown.begin());
  for (std::size_t n = first; n-- > 0;)
  {
    numbers[n] = numbers[n + 1] - 1;
  }
  for (std::size_t n = first + 1; n < numbers.size(); ++n)
  {
    numbers[n] = isKnown[n] ? numbers[n] : numbers[n - 1] + 1;
  }
  return numbers;
}

/// Every row and column of the index with a hole has a point.
RasterFrame FindFrame(PlanePoints columns, const ColumnIndex& index)
{
  const PlanePoints near = index.Columns();
  std::vector<std::int32_t> columnOf(std::size_t(index.Width()), 0);
  std::vector<std::int32_t> rowOf(std::size_t(index.Height()), 0);
  std::vector<bool> isColumnKnown(columnOf.size());
  std::vector<bool> isRowKnown(rowOf.size());
  const std::int64_t first = columns.empty() ? 0 : index.Place(near.front());
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    const std::size_t x = std::size_t(first % index.Width() + near[point].X - near.front().X);
    const std::size_t y = std::size_t(first / index.Width() + near[point].Y - near.front().Y);
    columnOf[x] = columns[point].X;
    rowOf[y] = columns[point].Y;
    isColumnKnown[x] = true;
    isRowKnown[y] = true;
  }
  return RasterFrame(index, Continued(std::move(columnOf), isColumnKnown), Continued(std::move(rowOf), isRowKnown));
}

// ---- Holes ----------------------------------------------------------------------------------------------------------
// Holes are groups of empty columns, connected by edges, that patches enclose, as with a radius of 1.

struct HoleRun
{
  std::int64_t First;
  std::int64_t Last;
};

/// Holes are numbered row by row from the least y.
struct HoleList
{
  ItemLists<HoleRun> Runs;
  std::vector<std::int64_t> Columns;
};

/// Without `some`, the run of the first row, the rim of the index, belongs to the outside.
class EmptyRuns
{
public:
  explicit EmptyRuns(const ColumnIndex& index, const std::vector<bool>* some = nullptr)
    : Index(index)
    , Some(some)
  {
    std::size_t before = 0;
    for (std::int64_t row = 0; row < index.Height(); ++row)
    {
      const std::size_t begin = this->Runs.size();
      this->AddRow(row);
      this->JoinRows(before, begin);
      before = begin;
    }
  }

  HoleList FoundHoles()
  {
    HoleList result;
    std::vector<std::int32_t> hole(this->Runs.size(), NoHole);
    for (std::size_t run = 0; run < this->Runs.size(); ++run)
    {
      const std::size_t root = std::size_t(this->Sets.Find(std::int32_t(run)));
      if (root == 0 && !this->Some)
      {
        continue;
      }
      if (root == run)
      {
        hole[run] = std::int32_t(result.Columns.size());
        result.Columns.push_back(0);
      }
      hole[run] = hole[root]; // The root has the least number of its set, and therefore came before.
      result.Columns[hole[run]] += this->Runs[run].Last - this->Runs[run].First + 1;
    }
    result.Runs = ItemLists<HoleRun>(std::int64_t(result.Columns.size()),
      [&](auto&& add)
      {
        for (std::size_t run = 0; run < hole.size(); ++run)
        {
          if (hole[run] != NoHole)
          {
            add(hole[run], this->Runs[run]);
          }
        }
      });
    return result;
  }

  std::vector<bool> Outside()
  {
    std::vector<bool> result(std::size_t(this->Index.NumberOfPlaces()), false);
    for (std::size_t run = 0; run < this->Runs.size(); ++run)
    {
      if (this->Sets.Find(std::int32_t(run)) == 0)
      {
        std::fill(result.begin() + this->Runs[run].First, result.begin() + this->Runs[run].Last + 1, true);
      }
    }
    return result;
  }

private:
  static constexpr std::int32_t NoHole = -1;

  void AddRow(std::int64_t row)
  {
    const std::int64_t end = (row + 1) * this->Index.Width();
    bool wasEmpty = false;
    for (std::int64_t place = row * this->Index.Width(); place < end; ++place)
    {
      const bool isEmpty = this->Some ? (*this->Some)[std::size_t(place)] : !this->Index.Has(place);
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

  void JoinRows(std::size_t before, std::size_t begin)
  {
    std::size_t a = before;
    std::size_t b = begin;
    while (a < begin && b < this->Runs.size())
    {
      const HoleRun below = { this->Runs[a].First + this->Index.Width(), this->Runs[a].Last + this->Index.Width() };
      const HoleRun& run = this->Runs[b];
      if (below.First <= run.Last && run.First <= below.Last)
      {
        this->Sets.Join(std::int32_t(a), std::int32_t(b));
      }
      ++(below.Last < run.Last ? a : b);
    }
  }

  const ColumnIndex& Index;
  const std::vector<bool>* const Some;
  std::vector<HoleRun> Runs;
  DisjointSets Sets;
};

std::vector<bool> FindNearOutside(const ColumnIndex& index, const RasterFrame& frame, std::vector<bool> outside,
  int distance, const std::optional<PlaneBox>& box)
{
  std::vector<bool> near(outside.size(), false);
  std::vector<std::int64_t> front;
  index.ForEachPoint(0, index.NumberOfPlaces(), [&](std::int64_t place, PointId) { front.push_back(place); });
  std::vector<std::int64_t> next;
  for (int step = 0; step < distance && !front.empty(); ++step)
  {
    for (const std::int64_t place : front)
    {
      for (int n = 0; n < 9; ++n)
      {
        const std::int64_t neighbour = place + (n / 3 - 1) * index.Width() + n % 3 - 1;
        if (outside[std::size_t(neighbour)])
        {
          const PlanePoint column = frame.Column(neighbour);
          outside[std::size_t(neighbour)] = false;
          if (!box ||
            (column.X >= box->Least.X && column.Y >= box->Least.Y && column.X <= box->Greatest.X &&
              column.Y <= box->Greatest.Y))
          {
            near[std::size_t(neighbour)] = true;
            next.push_back(neighbour);
          }
        }
      }
    }
    front.swap(next);
    next.clear();
  }
  return near;
}

struct AllHoles
{
  HoleList Enclosed;
  HoleList Outside;
};

AllHoles FindHoles(const ColumnIndex& index, const RasterFrame& frame, const HoleFillingOptions& options)
{
  EmptyRuns all(index);
  AllHoles holes;
  holes.Enclosed = all.FoundHoles();
  if (options.ExtrapolationDistance > 0 && index.NumberOfPlaces() > 0)
  {
    const std::vector<bool> near =
      FindNearOutside(index, frame, all.Outside(), options.ExtrapolationDistance, options.Survey);
    holes.Outside = EmptyRuns(index, &near).FoundHoles();
  }
  return holes;
}

/// Sections are in the order of their first places.
std::vector<std::vector<std::int64_t>> SplitHole(
  const ColumnIndex& index, const RasterFrame& frame, const LinkCuts& cuts, const std::vector<std::int64_t>& hole)
{
  DisjointSets sets(hole.size());
  for (std::size_t n = 0; n < hole.size(); ++n)
  {
    const auto join = [&](std::int64_t place)
    {
      const auto found = std::lower_bound(hole.begin(), hole.begin() + std::ptrdiff_t(n), place);
      if (found != hole.begin() + std::ptrdiff_t(n) && *found == place)
      {
        sets.Join(std::int32_t(found - hole.begin()), std::int32_t(n));
      }
    };
    const std::int64_t west = hole[n] - 1;
    const std::int64_t south = hole[n] - index.Width();
    if (!cuts.IsCutEast(frame.Column(west)))
    {
      join(west);
    }
    if (!cuts.IsCutNorth(frame.Column(south)))
    {
      join(south);
    }
  }
  std::vector<std::vector<std::int64_t>> parts;
  std::vector<std::size_t> number(hole.size());
  for (std::size_t n = 0; n < hole.size(); ++n)
  {
    const std::size_t root = std::size_t(sets.Find(std::int32_t(n)));
    if (root == n)
    {
      number[n] = parts.size();
      parts.emplace_back();
    }
    parts[number[root]].push_back(hole[n]);
  }
  return parts;
}

//----------------------------------------------------------------------------------------------------------------------

class HoleFiller
{
public:
  HoleFiller(const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights,
    const std::vector<PointValue>& attributes, const HoleFillingOptions& options, const LinkCuts* cuts)
    : Index(index)
    , Frame(frame)
    , Heights(heights)
    , Attributes(attributes)
    , Options(options)
    , Cuts(cuts)
    , Holes(FindHoles(index, frame, options))
  {
  }

  FilledColumns Run(const Monitor& monitor)
  {
    this->Allocate();
    // Large holes report their own progress.
    const auto small = std::partition(this->Closed.begin(), this->Closed.end(),
      [this](std::size_t hole) { return this->SizeOf(hole) >= std::int64_t(MultigridSize); });
    const std::size_t large = std::size_t(small - this->Closed.begin());
    const double share = large == 0 ? 0.0 : large == this->Closed.size() ? 1.0 : 0.8;
    for (std::size_t n = 0; n < large; ++n)
    {
      this->Fill(
        this->Closed[n], monitor.Step(share * double(n) / double(large), share * double(n + 1) / double(large)));
    }
    ParallelFor(std::int64_t(this->Closed.size() - large), HolesPerTask, monitor.Step(share, 1.0),
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          this->Fill(this->Closed[large + std::size_t(n)], Monitor());
        }
      });
    return this->WithoutOpenHoles();
  }

private:
  // Holes are numbered first, then areas outside.
  std::size_t NumberOfHoles() const { return this->Holes.Enclosed.Columns.size(); }
  bool IsOutside(std::size_t hole) const { return hole >= this->NumberOfHoles(); }
  std::int64_t SizeOf(std::size_t hole) const
  {
    return this->IsOutside(hole) ? this->Holes.Outside.Columns[hole - this->NumberOfHoles()]
                                 : this->Holes.Enclosed.Columns[hole];
  }

  void Allocate()
  {
    const std::size_t holes = this->NumberOfHoles() + this->Holes.Outside.Columns.size();
    this->Begin.assign(holes, 0);
    std::size_t size = 0;
    for (std::size_t hole = 0; hole < holes; ++hole)
    {
      this->Begin[hole] = size;
      if (hole == this->NumberOfHoles())
      {
        this->Result.FirstOutside = size;
      }
      if (this->IsOutside(hole) || this->SizeOf(hole) <= this->Options.LargestHoleSize)
      {
        this->Closed.push_back(hole);
        size += std::size_t(this->SizeOf(hole));
      }
    }
    this->Result.FirstOutside = this->Holes.Outside.Columns.empty() ? size : this->Result.FirstOutside;
    this->Result.Column.resize(size);
    this->Result.Height.resize(size);
    this->Result.Nearest.resize(size, NoPoint);
    this->Result.Attribute.assign(this->Attributes.size(), std::vector<double>(size));
  }

  std::vector<std::int64_t> Places(std::size_t hole) const
  {
    std::vector<std::int64_t> places;
    places.reserve(std::size_t(this->SizeOf(hole)));
    const ItemLists<HoleRun>& runs = this->IsOutside(hole) ? this->Holes.Outside.Runs : this->Holes.Enclosed.Runs;
    const std::size_t own = this->IsOutside(hole) ? hole - this->NumberOfHoles() : hole;
    for (const HoleRun* run = runs.begin(own); run != runs.end(own); ++run)
    {
      for (std::int64_t place = run->First; place <= run->Last; ++place)
      {
        places.push_back(place);
      }
    }
    return places;
  }

  void Fill(std::size_t hole, const Monitor& monitor)
  {
    const std::vector<std::int64_t> places = this->Places(hole);
    if (!this->Cuts)
    {
      this->FillPart(places, this->Begin[hole], monitor);
      return;
    }
    std::size_t begin = this->Begin[hole];
    for (const std::vector<std::int64_t>& part : SplitHole(this->Index, this->Frame, *this->Cuts, places))
    {
      this->FillPart(part, begin, monitor);
      begin += part.size();
    }
  }

  void FillPart(const std::vector<std::int64_t>& places, std::size_t begin, const Monitor& monitor)
  {
    const HoleRegion region(this->Index, this->Frame, this->Cuts, places, this->Options.RimWidth);
    const HoleFill fill = FillHole(region, this->Heights, this->Attributes, this->Options, this->Plates, monitor);
    if (fill.Nearest.empty())
    {
      return;
    }
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      this->Result.Column[begin + n] = this->Frame.Column(places[n]);
    }
    std::copy(fill.Height.begin(), fill.Height.end(), this->Result.Height.begin() + std::ptrdiff_t(begin));
    std::copy(fill.Nearest.begin(), fill.Nearest.end(), this->Result.Nearest.begin() + std::ptrdiff_t(begin));
    for (std::size_t a = 0; a < fill.Attribute.size(); ++a)
    {
      std::copy(
        fill.Attribute[a].begin(), fill.Attribute[a].end(), this->Result.Attribute[a].begin() + std::ptrdiff_t(begin));
    }
  }

  FilledColumns WithoutOpenHoles()
  {
    bool isAnyCutOff = false;
    for (const std::size_t hole : this->Closed)
    {
      const auto begin = this->Result.Nearest.begin() + std::ptrdiff_t(this->Begin[hole]);
      const bool isCutOff = std::count(begin, begin + this->SizeOf(hole), NoPoint) > 0;
      this->Result.FilledHoles += isCutOff || this->IsOutside(hole) ? 0 : 1;
      isAnyCutOff = isAnyCutOff || isCutOff;
    }
    this->Result.OpenHoles = std::int64_t(this->NumberOfHoles()) - this->Result.FilledHoles;
    if (isAnyCutOff)
    {
      this->DropCutOff();
    }
    return std::move(this->Result);
  }

  void DropCutOff()
  {
    std::size_t kept = 0;
    const std::size_t firstOutside = this->Result.FirstOutside;
    for (std::size_t n = 0; n < this->Result.Nearest.size(); ++n)
    {
      this->Result.FirstOutside = n == firstOutside ? kept : this->Result.FirstOutside;
      if (this->Result.Nearest[n] != NoPoint)
      {
        this->Result.Column[kept] = this->Result.Column[n];
        this->Result.Height[kept] = this->Result.Height[n];
        this->Result.Nearest[kept] = this->Result.Nearest[n];
        for (std::vector<double>& values : this->Result.Attribute)
        {
          values[kept] = values[n];
        }
        ++kept;
      }
    }
    this->Result.FirstOutside = std::min(this->Result.FirstOutside, kept);
    this->Result.Column.resize(kept);
    this->Result.Height.resize(kept);
    this->Result.Nearest.resize(kept);
    for (std::vector<double>& values : this->Result.Attribute)
    {
      values.resize(kept);
    }
  }

  const ColumnIndex& Index;
  const RasterFrame& Frame;
  const std::vector<double>& Heights;
  const std::vector<PointValue>& Attributes;
  const HoleFillingOptions& Options;
  const LinkCuts* const Cuts;
  const AllHoles Holes;
  HolePlates Plates;
  std::vector<std::size_t> Closed;
  std::vector<std::size_t> Begin;
  FilledColumns Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
FilledColumns FillHoles(PlanePoints columns, const std::vector<double>& heights,
  const std::vector<PointValue>& attributes, const HoleFillingOptions& options, const LinkCuts* cuts,
  const Monitor& monitor)
{
  assert(heights.size() == columns.size());
  CheckFillingOptions(options);
  // The index has room for rings and stencils.
  const bool isChosen = options.Method == FillMethod::Automatic;
  const int rimWidth = isChosen ? WidestChosenRim : options.RimWidth;
  // Extrapolated columns are close to known columns, so no empty band is narrowed.
  const int outside = options.ExtrapolationDistance;
  const ColumnIndex index(
    columns, rimWidth + SiteBox::Margin + outside, outside > 0 ? ColumnIndex::AllBands : rimWidth);
  const RasterFrame frame = FindFrame(columns, index);
  HoleFillingOptions chosen = options;
  if (isChosen)
  {
    const PlateChoice choice = ChoosePlate(index, frame, heights, cuts);
    chosen.Method = FillMethod::Plate;
    chosen.RimSmoothing = choice.RimSmoothing;
    chosen.RimWidth = choice.RimWidth;
  }
  monitor.Progress(0.1);
  FilledColumns filled = HoleFiller(index, frame, heights, attributes, chosen, cuts).Run(monitor.Step(0.1, 1.0));
  filled.RimSmoothing = chosen.RimSmoothing;
  filled.RimWidth = chosen.RimWidth;
  return filled;
}
}
