// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The smoothing of plates is chosen first. Holes are found by runs of empty columns and divided where cuts cross them;
// each section is cut out and filled (HoleRegion.h). Sections without a link to a known column stay open. Threads share
// small holes; large holes, which take seconds, are filled one by one.

#include "HoleFilling.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/DisjointSets.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ColumnIndex.h"
#include "HoleRegion.h"
#include "SiteSolver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Smoothing of plates --------------------------------------------------------------------------------------------

using PlateChoice = std::pair<double, int>; // RimSmoothing and RimWidth

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
  TwistSums(const ColumnIndex& index, const std::vector<double>& heights, const LinkCuts* cuts)
    : Index(index)
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
      const PlanePoint column = this->Index.GivenColumn(place + y * this->Index.Width() + x);
      isWhole = !(x < side && this->Cuts->IsCutEast(column)) && !(y < side && this->Cuts->IsCutNorth(column));
    }
    return isWhole;
  }

  const ColumnIndex& Index;
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
PlateChoice ChoosePlate(const ColumnIndex& index, const std::vector<double>& heights, const LinkCuts* cuts)
{
  constexpr std::int64_t enough = 250000;
  // Sampled rows are spread by the golden ratio, as noise may repeat with the rows.
  constexpr double golden = 0.6180339887498949;
  const std::int64_t width = index.Width();
  const std::int64_t rows = index.Height() - 2; // A square of size 2 reaches two rows further.
  const std::int64_t step = width * index.Height() / enough + 1;
  TwistSums twists(index, heights, cuts);
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

// ---- Holes ----------------------------------------------------------------------------------------------------------

// Holes are groups of empty columns, connected by edges, that patches enclose, as with a radius of 1.

struct HoleRun
{
  std::int64_t First;
  std::int64_t Last;
};

struct EmptyRuns
{
  std::vector<HoleRun> Runs;
  DisjointSets Sets; // of runs that touch
};

template <typename IsEmpty>
EmptyRuns FindEmptyRuns(const ColumnIndex& index, IsEmpty&& isEmpty)
{
  EmptyRuns empty;
  std::vector<HoleRun>& runs = empty.Runs;
  std::size_t below = 0; // the next run of the row before
  for (std::int64_t row = 0; row < index.Height(); ++row)
  {
    const std::size_t begin = runs.size();
    const std::int64_t end = (row + 1) * index.Width();
    bool wasEmpty = false;
    for (std::int64_t place = row * index.Width(); place < end; ++place)
    {
      const bool isNow = isEmpty(place);
      if (isNow && !wasEmpty)
      {
        runs.push_back({ place, place });
        empty.Sets.Add();
      }
      else if (isNow)
      {
        runs.back().Last = place;
      }
      wasEmpty = isNow;
    }
    for (std::size_t run = begin; below < begin && run < runs.size();)
    {
      const std::int64_t belowLast = runs[below].Last + index.Width();
      if (runs[below].First + index.Width() <= runs[run].Last && runs[run].First <= belowLast)
      {
        empty.Sets.Join(std::int32_t(below), std::int32_t(run));
      }
      ++(belowLast < runs[run].Last ? below : run);
    }
    below = begin;
  }
  return empty;
}

/// Returns the places of the area of the first run that extrapolation reaches.
std::vector<bool> FindNearOutside(const ColumnIndex& index, EmptyRuns& empty, const HoleFillingOptions& options)
{
  std::vector<bool> outside(std::size_t(index.NumberOfPlaces()), false);
  for (std::size_t run = 0; run < empty.Runs.size(); ++run)
  {
    if (empty.Sets.Find(std::int32_t(run)) == 0)
    {
      std::fill(outside.begin() + empty.Runs[run].First, outside.begin() + empty.Runs[run].Last + 1, true);
    }
  }
  std::vector<bool> near(outside.size(), false);
  std::vector<std::int64_t> front;
  index.ForEachPoint(0, index.NumberOfPlaces(), [&](std::int64_t place, PointId) { front.push_back(place); });
  std::vector<std::int64_t> next;
  for (int step = 0; step < options.ExtrapolationDistance && !front.empty(); ++step)
  {
    for (const std::int64_t place : front)
    {
      for (int n = 0; n < 9; ++n)
      {
        const std::int64_t neighbour = place + (n / 3 - 1) * index.Width() + n % 3 - 1;
        if (outside[std::size_t(neighbour)])
        {
          outside[std::size_t(neighbour)] = false;
          if (!options.Survey || options.Survey->Contains(index.GivenColumn(neighbour)))
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

/// Holes come first, row by row from the least y, then areas outside.
struct HoleList
{
  std::size_t Enclosed = 0;
  std::vector<std::int64_t> Columns; // number by hole
  ItemLists<HoleRun> Runs;
};

HoleList FindHoles(const ColumnIndex& index, const HoleFillingOptions& options)
{
  constexpr std::int32_t none = -1;
  HoleList holes;
  std::vector<HoleRun> runs;
  std::vector<std::int32_t> holeOf; // by run
  const auto append = [&](EmptyRuns& empty, bool isFirstOutside)
  {
    const std::size_t begin = runs.size();
    runs.insert(runs.end(), empty.Runs.begin(), empty.Runs.end());
    for (std::size_t run = 0; run < empty.Runs.size(); ++run)
    {
      const auto root = std::size_t(empty.Sets.Find(std::int32_t(run)));
      if (root == run && !(run == 0 && isFirstOutside))
      {
        holeOf.push_back(std::int32_t(holes.Columns.size()));
        holes.Columns.push_back(0);
      }
      else // The root has the least number of its set, and therefore came before.
      {
        holeOf.push_back(root == run ? none : holeOf[begin + root]);
      }
      if (holeOf.back() != none)
      {
        holes.Columns[std::size_t(holeOf.back())] += empty.Runs[run].Last - empty.Runs[run].First + 1;
      }
    }
  };
  // The first row is the rim of the index, outside.
  EmptyRuns empty = FindEmptyRuns(index, [&](std::int64_t place) { return !index.Has(place); });
  append(empty, true);
  holes.Enclosed = holes.Columns.size();
  if (options.ExtrapolationDistance > 0 && index.NumberOfPlaces() > 0)
  {
    const std::vector<bool> near = FindNearOutside(index, empty, options);
    empty = FindEmptyRuns(index, [&](std::int64_t place) { return near[std::size_t(place)]; });
    append(empty, false);
  }
  holes.Runs = ItemLists<HoleRun>(std::int64_t(holes.Columns.size()),
    [&](auto&& add)
    {
      for (std::size_t run = 0; run < runs.size(); ++run)
      {
        if (holeOf[run] != none)
        {
          add(holeOf[run], runs[run]);
        }
      }
    });
  return holes;
}

/// Sections are in the order of their first places.
std::vector<std::vector<std::int64_t>> SplitHole(
  const ColumnIndex& index, const LinkCuts& cuts, const std::vector<std::int64_t>& hole)
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
    if (!cuts.IsCutEast(index.GivenColumn(west)))
    {
      join(west);
    }
    if (!cuts.IsCutNorth(index.GivenColumn(south)))
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

// ---- Filling --------------------------------------------------------------------------------------------------------

constexpr std::int64_t HolesPerTask = 16;

class HoleFiller
{
public:
  HoleFiller(const ColumnIndex& index, const std::vector<double>& heights, const std::vector<PointValue>& attributes,
    const HoleFillingOptions& options, const LinkCuts* cuts)
    : Index(index)
    , Heights(heights)
    , Attributes(attributes)
    , Options(options)
    , Cuts(cuts)
    , Holes(FindHoles(index, options))
  {
  }

  FilledColumns Run(const Monitor& monitor)
  {
    this->Allocate();
    // Large holes report their own progress.
    const auto small = std::partition(this->Closed.begin(), this->Closed.end(),
      [this](std::size_t hole) { return this->Holes.Columns[hole] >= std::int64_t(MultigridSize); });
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
    this->CountHoles();
    if (std::find(this->Result.Nearest.begin(), this->Result.Nearest.end(), NoPoint) != this->Result.Nearest.end())
    {
      this->DropCutOff();
    }
    return std::move(this->Result);
  }

private:
  void Allocate()
  {
    std::size_t size = 0;
    for (std::size_t hole = 0; hole < this->Holes.Columns.size(); ++hole)
    {
      this->Begin.push_back(size);
      const bool isEnclosed = hole < this->Holes.Enclosed;
      if (!isEnclosed || this->Holes.Columns[hole] <= this->Options.LargestHoleSize)
      {
        this->Closed.push_back(hole);
        size += std::size_t(this->Holes.Columns[hole]);
        this->Result.FirstOutside = isEnclosed ? size : this->Result.FirstOutside;
      }
    }
    this->Result.Column.resize(size);
    this->Result.Height.resize(size);
    this->Result.Nearest.resize(size, NoPoint);
    this->Result.Attribute.assign(this->Attributes.size(), std::vector<double>(size));
  }

  void Fill(std::size_t hole, const Monitor& monitor)
  {
    std::vector<std::int64_t> places;
    places.reserve(std::size_t(this->Holes.Columns[hole]));
    for (const HoleRun* run = this->Holes.Runs.begin(hole); run != this->Holes.Runs.end(hole); ++run)
    {
      for (std::int64_t place = run->First; place <= run->Last; ++place)
      {
        places.push_back(place);
      }
    }
    std::size_t begin = this->Begin[hole];
    if (!this->Cuts)
    {
      this->FillPart(places, begin, monitor);
      return;
    }
    for (const std::vector<std::int64_t>& part : SplitHole(this->Index, *this->Cuts, places))
    {
      this->FillPart(part, begin, monitor);
      begin += part.size();
    }
  }

  void FillPart(const std::vector<std::int64_t>& places, std::size_t begin, const Monitor& monitor)
  {
    const HoleRegion region(this->Index, this->Cuts, places, this->Options.RimWidth);
    std::transform(places.begin(), places.end(), this->Result.Column.begin() + std::ptrdiff_t(begin),
      [this](std::int64_t place) { return this->Index.GivenColumn(place); });
    FillHole(region, this->Heights, this->Attributes, this->Options, this->Plates, begin, this->Result, monitor);
  }

  void CountHoles()
  {
    for (const std::size_t hole : this->Closed)
    {
      const auto begin = this->Result.Nearest.begin() + std::ptrdiff_t(this->Begin[hole]);
      const bool isCutOff = std::count(begin, begin + this->Holes.Columns[hole], NoPoint) > 0;
      this->Result.FilledHoles += isCutOff || hole >= this->Holes.Enclosed ? 0 : 1;
    }
    this->Result.OpenHoles = std::int64_t(this->Holes.Enclosed) - this->Result.FilledHoles;
  }

  /// Columns of sections without a link to a known column go.
  void DropCutOff()
  {
    const std::vector<PointId> nearest = this->Result.Nearest;
    const auto keep = [&nearest](auto& values)
    {
      std::size_t kept = 0;
      for (std::size_t n = 0; n < nearest.size(); ++n)
      {
        if (nearest[n] != NoPoint)
        {
          values[kept++] = values[n];
        }
      }
      values.resize(kept);
    };
    const auto outside = nearest.begin() + std::ptrdiff_t(this->Result.FirstOutside);
    this->Result.FirstOutside -= std::size_t(std::count(nearest.begin(), outside, NoPoint));
    keep(this->Result.Column);
    keep(this->Result.Height);
    keep(this->Result.Nearest);
    std::for_each(this->Result.Attribute.begin(), this->Result.Attribute.end(), keep);
  }

  const ColumnIndex& Index;
  const std::vector<double>& Heights;
  const std::vector<PointValue>& Attributes;
  const HoleFillingOptions& Options;
  const LinkCuts* const Cuts;
  const HoleList Holes;
  HolePlates Plates;
  std::vector<std::size_t> Closed; // holes that are filled
  std::vector<std::size_t> Begin; // of a hole in the result
  FilledColumns Result;
};

void CheckFillingOptions(const HoleFillingOptions& options)
{
  CheckAtLeast<std::int64_t>("largest hole size", options.LargestHoleSize, 0, " columns");
  CheckWithin("rim smoothing", options.RimSmoothing, 0.0, LargestRimSmoothing, "");
  CheckWithin("rim width", options.RimWidth, 1, LargestRimWidth, " columns");
  CheckWithin("extrapolation distance", options.ExtrapolationDistance, 0, LargestExtrapolationDistance, " columns");
}
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
  HoleFillingOptions chosen = options;
  if (isChosen)
  {
    chosen.Method = FillMethod::Plate;
    std::tie(chosen.RimSmoothing, chosen.RimWidth) = ChoosePlate(index, heights, cuts);
  }
  monitor.Progress(0.1);
  FilledColumns filled = HoleFiller(index, heights, attributes, chosen, cuts).Run(monitor.Step(0.1, 1.0));
  filled.RimSmoothing = chosen.RimSmoothing;
  filled.RimWidth = chosen.RimWidth;
  return filled;
}
}
