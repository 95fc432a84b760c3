// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickPlacement.h"

#include "ColumnOrder.h"
#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Median.h"
#include "LineLattice.h"
#include "PickWarnings.h"
#include "ShortSteps.h"
#include "StrayPicks.h"
#include "SurveyMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// A dataset takes 25 kB. As many names as picks mostly come from the wrong field.
constexpr std::size_t MostHorizons = 1 << 15;
constexpr double EnoughColumns = 1 << 20;
constexpr double FewColumnsPerPick = 5.0; // In a sparser lattice some picks may be far from the rest.

class ColumnFinder
{
public:
  ColumnFinder(const PickTable& picks, const SurveyLattice& lattice)
    : Picks(picks)
    , Lattice(lattice)
    , ToColumns(lattice.Steps().inverse())
  {
  }

  Eigen::Vector2d Index(std::size_t pick) const
  {
    return (this->Lattice.Lines ? this->Line(pick) : this->Place(pick)).array().round();
  }

  /// columns, along the axis with the larger distance
  double Distance(std::size_t pick, const Eigen::Vector2d& index) const
  {
    const Eigen::Vector2d exact = this->Picks.HasPlaces() ? this->Place(pick) : this->Line(pick);
    return (exact - index).cwiseAbs().maxCoeff();
  }

private:
  Eigen::Vector2d Line(std::size_t pick) const
  {
    return LineIndex(*this->Lattice.Lines, this->Picks.Crossline[pick], this->Picks.Inline[pick]);
  }

  Eigen::Vector2d Place(std::size_t pick) const
  {
    const Eigen::Vector2d place(this->Picks.X[pick], this->Picks.Y[pick]);
    return this->ToColumns * (place - this->Lattice.Origin);
  }

  const PickTable& Picks;
  const SurveyLattice& Lattice;
  const Eigen::Matrix2d ToColumns;
};

struct ColumnRange
{
  Eigen::Vector2d First = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d Last = -First;
  double LargestDistance = 0.0;
  std::size_t Farthest = 0; // pick at LargestDistance
  std::int64_t OffLattice = 0; // picks

  void Add(const Eigen::Vector2d& index, double distance, double tolerance, std::size_t pick)
  {
    this->First = this->First.cwiseMin(index);
    this->Last = this->Last.cwiseMax(index);
    this->Farthest = distance > this->LargestDistance ? pick : this->Farthest;
    this->LargestDistance = std::max(this->LargestDistance, distance);
    this->OffLattice += distance <= tolerance ? 0 : 1;
  }

  Eigen::Vector2d Columns() const { return this->Last - this->First + Eigen::Vector2d::Ones(); }

  void Add(const ColumnRange& other)
  {
    this->First = this->First.cwiseMin(other.First);
    this->Last = this->Last.cwiseMax(other.Last);
    this->Farthest = other.LargestDistance > this->LargestDistance ? other.Farthest : this->Farthest;
    this->LargestDistance = std::max(this->LargestDistance, other.LargestDistance);
    this->OffLattice += other.OffLattice;
  }
};

ColumnRange FindRange(const ColumnFinder& columns, std::int64_t picks, double tolerance, const Monitor& monitor)
{
  return AddUpChunks<ColumnRange>(picks, ChunkSize, monitor,
    [&](ColumnRange& range, std::int64_t first, std::int64_t last)
    {
      for (auto pick = std::size_t(first); pick < std::size_t(last); ++pick)
      {
        const Eigen::Vector2d index = columns.Index(pick);
        range.Add(index, columns.Distance(pick, index), tolerance, pick);
      }
    });
}

/// The tolerance is at least half a rounding unit along both axes.
double ToleranceOf(const PickTable& picks, const SurveyLattice& lattice, double given)
{
  constexpr double most = 0.49;
  const double rounded = picks.HasPlaces() ? FindRounding(picks.X, picks.Y) : 0.0;
  const Eigen::Vector2d farthest = lattice.Steps().inverse().cwiseAbs() * Eigen::Vector2d::Constant(0.51 * rounded);
  return std::max(given, std::min(most, farthest.maxCoeff()));
}

void CheckNumber(std::size_t horizons, std::int64_t picks, const char* text)
{
  if (horizons > MostHorizons)
  {
    throw InputError(
      std::to_string(picks) + " picks of " + std::to_string(horizons) + text + std::to_string(MostHorizons));
  }
}

void CheckRange(const ColumnRange& range, const PickTable& picks, const SurveyLattice& lattice, double tolerance)
{
  if (range.OffLattice > 0)
  {
    std::ostringstream text;
    text << range.OffLattice << " of " << picks.Size() << " picks off the lattice with the steps "
         << ToText(lattice.ColumnStep) << " and " << ToText(lattice.RowStep) << ", the farthest, "
         << PicksText(picks, { range.Farthest }) << ", by " << range.LargestDistance
         << " columns; expected at most LatticeTolerance, " << tolerance << ", or StrayPicks LeaveOut, or Gridding";
    throw InputError(text.str());
  }
  const Eigen::Vector2d columns = range.Columns();
  if (!(columns.maxCoeff() <= MostColumnsPerSide))
  {
    std::ostringstream text;
    text.precision(15);
    text << "lattice of " << columns.x() << " x " << columns.y() << " columns with the steps "
         << ToText(lattice.ColumnStep) << " and " << ToText(lattice.RowStep)
         << ", expected less than 2^28 along a side; is there a pick far away from all others?";
    throw InputError(text.str());
  }
}

std::size_t FindFarthest(const ColumnFinder& columns, std::size_t picks)
{
  std::vector<Eigen::Vector2d> indices;
  for (std::size_t pick = 0; pick < picks; ++pick)
  {
    indices.push_back(columns.Index(pick));
  }
  Eigen::Vector2d middle;
  for (const int axis : { 0, 1 })
  {
    std::vector<double> along;
    std::transform(indices.begin(), indices.end(), std::back_inserter(along),
      [axis](const Eigen::Vector2d& index) { return index[axis]; });
    middle[axis] = UpperMedian(along);
  }
  const auto distance = [&middle](const Eigen::Vector2d& index) { return (index - middle).cwiseAbs().maxCoeff(); };
  return std::size_t(std::max_element(indices.begin(), indices.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
    indices.begin());
}

/// A stray pick can extend the lattice beyond memory.
void CheckSpread(const ColumnFinder& finder, const ColumnRange& range, const PickTable& picks)
{
  const Eigen::Vector2d columns = range.Columns();
  if (columns.prod() > std::max(EnoughColumns, MostColumnsPerPick * double(picks.Size())))
  {
    const std::size_t farthest = FindFarthest(finder, picks.Size());
    std::ostringstream text;
    text.precision(15);
    text << "lattice of " << columns.x() << " x " << columns.y() << " columns for " << picks.Size()
         << " picks, expected at most " << MostColumnsPerPick << " columns a pick; " << PicksText(picks, { farthest })
         << ", in column " << ToText(finder.Index(farthest) - range.First) << ", is the farthest from the others";
    throw InputError(text.str());
  }
}

void CheckLines(const PickTable& picks, const SurveyLattice& lattice, const Monitor& monitor)
{
  const std::vector<std::size_t> between = FindBetweenLines(picks, lattice.Lines, monitor.Step(0.5, 0.5));
  if (!between.empty())
  {
    throw InputError(std::to_string(between.size()) + " of " + std::to_string(picks.Size()) +
      " picks between the lines of the others, " + PicksText(picks, between) +
      "; expected line numbers in equal steps, or StrayPicks LeaveOut");
  }
}

/// The remaining picks give a better lattice in each round.
std::vector<std::size_t> LeaveOutStrays(PickTable& picks, const PlacementOptions& options, const Monitor& monitor)
{
  constexpr int mostRounds = 20;
  const std::size_t mostStrays = picks.Size() / 10;
  std::vector<std::size_t> numbers(picks.Size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  std::vector<std::size_t> all;
  for (int round = 0; round < mostRounds; ++round)
  {
    monitor.Progress(double(round) / mostRounds);
    const SurveyLattice lattice = FindSurveyMap(picks, options, Monitor());
    const ColumnFinder finder(picks, lattice);
    std::vector<PickPlace> places;
    for (std::size_t pick = 0; pick < picks.Size(); ++pick)
    {
      const Eigen::Vector2d index = finder.Index(pick);
      places.push_back({ index, finder.Distance(pick, index) });
    }
    std::vector<std::size_t> strays = FindBetweenLines(picks, lattice.Lines);
    if (strays.empty())
    {
      strays = FindStrays(places, ToleranceOf(picks, lattice, options.Tolerance));
    }
    if (strays.empty() || all.size() + strays.size() > mostStrays)
    {
      break; // Too many strays are not removed.
    }
    std::vector<std::size_t> left;
    auto next = strays.begin();
    for (std::size_t n = 0; n < numbers.size(); ++n)
    {
      const bool isStray = next != strays.end() && *next == n;
      next += isStray ? 1 : 0;
      (isStray ? all : left).push_back(numbers[n]);
    }
    numbers.swap(left);
    picks = WithoutPicks(std::move(picks), strays);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Distant picks can rotate the fitted lattice onto themselves. If they are off the lattice of the other picks, throws
/// InputError; otherwise adds a warning. Returns true if there are any.
bool CheckFarPicks(
  const PickTable& picks, const ColumnRange& range, const PlacementOptions& options, std::vector<std::string>& warnings)
{
  if (range.Columns().prod() <= FewColumnsPerPick * double(picks.Size()))
  {
    return false;
  }
  PickTable others = picks;
  const std::vector<std::size_t> strays = LeaveOutStrays(others, options, Monitor());
  if (strays.empty())
  {
    return false;
  }
  const SurveyLattice lattice = FindSurveyMap(others, options, Monitor());
  const ColumnFinder finder(picks, lattice);
  const double tolerance = ToleranceOf(others, lattice, options.Tolerance);
  std::vector<std::size_t> off;
  std::copy_if(strays.begin(), strays.end(), std::back_inserter(off),
    [&](std::size_t pick) { return !(finder.Distance(pick, finder.Index(pick)) <= tolerance); });
  if (!off.empty())
  {
    std::ostringstream text;
    text << off.size() << " of " << picks.Size() << " picks off the lattice of the others, far from these, "
         << PicksText(picks, off) << "; expected at most LatticeTolerance, " << tolerance << ", or StrayPicks LeaveOut";
    throw InputError(text.str());
  }
  warnings.push_back(std::to_string(strays.size()) + (strays.size() == 1 ? " pick" : " picks") +
    " far from all others, " + PicksText(picks, strays) + ": StrayPicks leaves them out");
  return true;
}

SurveyLattice MakeLattice(SurveyLattice lattice, const ColumnRange& range)
{
  lattice.Columns = { int(range.Columns().x()), int(range.Columns().y()) };
  lattice.Origin += lattice.Steps() * range.First; // Line numbers and the range start at the first lines.
  return lattice;
}

std::vector<PlanePoint> ListColumns(
  const ColumnFinder& columns, std::int64_t picks, const Eigen::Vector2d& first, const Monitor& monitor)
{
  std::vector<PlanePoint> list(picks);
  ForEachChunk(picks, ChunkSize, monitor,
    [&](std::size_t, std::int64_t begin, std::int64_t end)
    {
      for (auto pick = std::size_t(begin); pick < std::size_t(end); ++pick)
      {
        const Eigen::Vector2d index = columns.Index(pick) - first;
        list[pick] = { int(index.x()), int(index.y()) };
      }
    });
  return list;
}

LatticeHorizon MakeHorizon(const PickTable& picks, const std::vector<PlanePoint>& columns, const ColumnOrder& order)
{
  const std::vector<std::int32_t>& kept = order.Picks;
  LatticeHorizon horizon;
  horizon.DroppedDuplicates = order.Duplicates;
  horizon.DroppedNulls = order.Nulls;
  horizon.Column = Gather<HeapArray<PlanePoint>>(columns, kept);
  horizon.RealZ = Gather<HeapArray<double>>(picks.Z, kept);
  for (const PickAttribute& attribute : picks.Attributes)
  {
    horizon.Attributes.emplace_back(attribute.Name, Gather<HeapArray<double>>(attribute.Values, kept));
  }
  return horizon;
}

template <typename... Vectors>
void Free(Vectors&... vectors)
{
  ((vectors = Vectors()), ...);
}
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons PlacePicks(PickTable picks, const PlacementOptions& options, const Monitor& monitor)
{
  CheckPlacement(options);
  auto size = std::int64_t(picks.Size());
  if (size == 0 || size > std::numeric_limits<std::int32_t>::max())
  {
    throw InputError(std::to_string(size) + " picks, expected at least 1 and less than 2^31");
  }
  CheckNumber(picks.Names.size(), size, " horizons, expected at most ");
  SurveyHorizons placed;
  placed.Warnings = std::move(picks.Warnings);
  if (options.LeaveOutStrays)
  {
    const std::vector<std::size_t> strays = LeaveOutStrays(picks, options, monitor.Step(0.0, 0.4));
    size = std::int64_t(picks.Size());
    if (!strays.empty())
    {
      placed.Warnings.push_back(std::to_string(strays.size()) + (strays.size() == 1 ? " pick" : " picks") +
        " left out as strays: " + PicksText(picks, strays));
    }
  }
  const SurveyLattice lattice = FindSurveyMap(picks, options, monitor.Step(0.0, 0.5));
  CheckLines(picks, lattice, monitor);
  const ColumnFinder finder(picks, lattice);
  const double tolerance = ToleranceOf(picks, lattice, options.Tolerance);
  const ColumnRange range = FindRange(finder, size, tolerance, monitor.Step(0.5, 0.6));
  CheckRange(range, picks, lattice, tolerance);
  CheckSpread(finder, range, picks);
  const bool hasFarPicks = !options.LeaveOutStrays && CheckFarPicks(picks, range, options, placed.Warnings);
  placed.Survey = picks.Survey;
  placed.Lattice = MakeLattice(lattice, range);
  placed.LargestDistance = range.LargestDistance;
  const std::vector<PlanePoint> columns = ListColumns(finder, size, range.First, monitor.Step(0.6, 0.7));
  WarnOfMoves(picks, columns, placed);
  if (options.Source == LatticeSource::Picks && !hasFarPicks)
  {
    RequireEvidence(columns, placed.Lattice, picks);
  }
  Free(picks.X, picks.Y, picks.Inline, picks.Crossline);
  std::vector<ColumnOrder> orders = ListPicks(picks);
  for (std::size_t number = 0; number < picks.Names.size(); ++number)
  {
    monitor.Progress(0.7 + 0.3 * double(number) / double(picks.Names.size()));
    ColumnOrder order = std::exchange(orders[number], ColumnOrder());
    WarnOfNulls(Gather<std::vector<double>>(picks.Z, order.Picks), placed.Warnings);
    OrderPicks(order, picks, columns, options);
    ConflictCount conflicts = CountConflicts(order);
    const bool isSplit = options.Policy == DuplicatePolicy::Sheets;
    for (const ColumnOrder& sheet : isSplit ? SplitIntoSheets(order, picks, columns) : std::vector{ std::move(order) })
    {
      placed.Horizons.push_back(MakeHorizon(picks, columns, sheet));
      placed.Horizons.back().SurfaceId = int(number) + 1;
      placed.Conflicts.push_back(std::exchange(conflicts, ConflictCount()));
    }
    CheckNumber(placed.Horizons.size(), size, " sheets, expected at most ");
  }
  return placed;
}
}
