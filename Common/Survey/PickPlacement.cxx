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

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
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

struct ColumnRange
{
  Eigen::Vector2d First = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d Last = -First;
  double LargestDistance = 0.0;
  std::size_t Farthest = 0; // pick at LargestDistance
  std::int64_t OffLattice = 0; // picks

  void Add(const Eigen::Vector2d& index, double distance, double tolerance, std::size_t pick)
  {
    this->Add({ index, index, distance, pick, distance <= tolerance ? 0 : 1 });
  }

  void Add(const ColumnRange& other)
  {
    this->First = this->First.cwiseMin(other.First);
    this->Last = this->Last.cwiseMax(other.Last);
    this->Farthest = other.LargestDistance > this->LargestDistance ? other.Farthest : this->Farthest;
    this->LargestDistance = std::max(this->LargestDistance, other.LargestDistance);
    this->OffLattice += other.OffLattice;
  }

  Eigen::Vector2d Columns() const { return this->Last - this->First + Eigen::Vector2d::Ones(); }
};

/// The lattice of picks, and how they lie on it.
struct PickFit
{
  SurveyLattice Lattice;
  Eigen::Matrix2d ToColumns;
  double Tolerance = 0.0;
  std::vector<std::size_t> BetweenLines;
  ColumnRange Range;

  Eigen::Vector2d Index(const PickPlaces& picks, std::size_t pick) const
  {
    return (this->Lattice.Lines ? this->Line(picks, pick) : this->Place(picks, pick)).array().round();
  }

  /// columns, along the axis with the larger distance
  double Distance(const PickPlaces& picks, std::size_t pick) const
  {
    const Eigen::Vector2d exact = picks.HasPlaces() ? this->Place(picks, pick) : this->Line(picks, pick);
    return (exact - this->Index(picks, pick)).cwiseAbs().maxCoeff();
  }

private:
  Eigen::Vector2d Line(const PickPlaces& picks, std::size_t pick) const
  {
    return LineIndex(*this->Lattice.Lines, picks.Crossline[pick], picks.Inline[pick]);
  }

  Eigen::Vector2d Place(const PickPlaces& picks, std::size_t pick) const
  {
    return this->ToColumns * (Eigen::Vector2d(picks.X[pick], picks.Y[pick]) - this->Lattice.Origin);
  }
};

PickFit FitPicks(const PickPlaces& picks, const PlacementOptions& options, const Monitor& monitor = Monitor())
{
  constexpr double most = 0.49;
  PickFit fit;
  fit.Lattice = FindSurveyMap(picks, options, monitor.Step(0.0, 0.8));
  fit.ToColumns = fit.Lattice.Steps().inverse();
  // Places may be half a rounding unit away along both axes.
  const double rounded = picks.HasPlaces() ? FindRounding(picks.X, picks.Y) : 0.0;
  const Eigen::Vector2d farthest = fit.ToColumns.cwiseAbs() * Eigen::Vector2d::Constant(0.51 * rounded);
  fit.Tolerance = std::max(options.Tolerance, std::min(most, farthest.maxCoeff()));
  fit.BetweenLines = FindBetweenLines(picks, fit.Lattice.Lines, monitor.Step(0.8, 0.9));
  fit.Range = AddUpChunks<ColumnRange>(std::int64_t(picks.Size()), ChunkSize, monitor.Step(0.9, 1.0),
    [&](ColumnRange& range, std::int64_t first, std::int64_t last)
    {
      for (auto pick = std::size_t(first); pick < std::size_t(last); ++pick)
      {
        range.Add(fit.Index(picks, pick), fit.Distance(picks, pick), fit.Tolerance, pick);
      }
    });
  return fit;
}

std::vector<double> IndicesAlong(int axis, const PickFit& fit, const PickPlaces& picks)
{
  std::vector<double> indices(picks.Size());
  for (std::size_t pick = 0; pick < indices.size(); ++pick)
  {
    indices[pick] = fit.Index(picks, pick)[axis];
  }
  return indices;
}

/// The box of all picks but 2 % at each end, widened by its size on all sides.
Eigen::AlignedBox2d WideBox(const PickFit& fit, const PickPlaces& picks)
{
  constexpr double fewest = 10.0; // columns
  Eigen::AlignedBox2d box;
  for (const int axis : { 0, 1 })
  {
    std::vector<double> indices = IndicesAlong(axis, fit, picks);
    const std::size_t outer = indices.size() / 50;
    std::sort(indices.begin(), indices.end());
    const double low = indices[outer];
    const double high = indices[indices.size() - 1 - outer];
    const double width = std::max(fewest, high - low);
    box.min()[axis] = low - width;
    box.max()[axis] = high + width;
  }
  return box;
}

/// Returns picks between the lines of nearly all others or, without these, far from the rest or, without these, off
/// their columns. Strays distort the lattice, so that only picks at least half as far off as the farthest count.
std::vector<std::size_t> FindStrays(const PickFit& fit, const PickPlaces& picks)
{
  if (!fit.BetweenLines.empty())
  {
    return fit.BetweenLines;
  }
  const Eigen::AlignedBox2d box = WideBox(fit, picks);
  const double largest = std::max(fit.Tolerance, 0.5 * fit.Range.LargestDistance);
  std::vector<std::size_t> far;
  std::vector<std::size_t> off;
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    if (!box.contains(fit.Index(picks, pick)))
    {
      far.push_back(pick);
    }
    else if (!(fit.Distance(picks, pick) <= largest))
    {
      off.push_back(pick);
    }
  }
  return far.empty() ? off : far;
}

/// The remaining picks give a better lattice in each round. Too many strays stay.
std::vector<std::size_t> FindAllStrays(const PickPlaces& picks, const PlacementOptions& options, const Monitor& monitor)
{
  constexpr int mostRounds = 20;
  PickPlaces others;
  std::vector<std::size_t> strays;
  for (int round = 0; round < mostRounds; ++round)
  {
    monitor.Progress(double(round) / mostRounds);
    const PickPlaces& left = strays.empty() ? picks : others;
    const std::vector<std::size_t> found = FindStrays(FitPicks(left, options), left);
    if (found.empty() || strays.size() + found.size() > picks.Size() / 10)
    {
      break;
    }
    const std::vector<std::size_t> numbers = OriginalNumbers(found, strays);
    const auto old = strays.insert(strays.end(), numbers.begin(), numbers.end());
    std::inplace_merge(strays.begin(), old, strays.end());
    others = WithoutPicks(picks, strays);
  }
  return strays;
}

std::string CountText(std::size_t picks)
{
  return std::to_string(picks) + (picks == 1 ? " pick" : " picks");
}

void CheckNumber(std::size_t horizons, std::size_t picks, const char* text)
{
  if (horizons > MostHorizons)
  {
    throw InputError(
      std::to_string(picks) + " picks of " + std::to_string(horizons) + text + std::to_string(MostHorizons));
  }
}

std::size_t FindFarthest(const PickFit& fit, const PickPlaces& picks)
{
  Eigen::Vector2d middle;
  for (const int axis : { 0, 1 })
  {
    std::vector<double> indices = IndicesAlong(axis, fit, picks);
    middle[axis] = UpperMedian(indices);
  }
  std::size_t farthest = 0;
  double largest = 0.0;
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    const double distance = (fit.Index(picks, pick) - middle).cwiseAbs().maxCoeff();
    farthest = distance > largest ? pick : farthest;
    largest = std::max(largest, distance);
  }
  return farthest;
}

/// Throws InputError if picks are between lines, off the lattice, or so far away that it would not fit into memory.
void CheckFit(const PickFit& fit, const PickTable& picks)
{
  const ColumnRange& range = fit.Range;
  const Eigen::Vector2d columns = range.Columns();
  const std::string steps = " with the steps " + ToText(fit.Lattice.ColumnStep) + " and " + ToText(fit.Lattice.RowStep);
  if (!fit.BetweenLines.empty())
  {
    throw InputError(std::to_string(fit.BetweenLines.size()) + " of " + std::to_string(picks.Size()) +
      " picks between the lines of the others, " + PicksText(picks, fit.BetweenLines) +
      "; expected line numbers in equal steps, or StrayPicks LeaveOut");
  }
  if (range.OffLattice > 0)
  {
    std::ostringstream text;
    text << range.OffLattice << " of " << picks.Size() << " picks off the lattice" << steps << ", the farthest, "
         << PicksText(picks, { range.Farthest }) << ", by " << range.LargestDistance
         << " columns; expected at most LatticeTolerance, " << fit.Tolerance
         << ", or StrayPicks LeaveOut, or Gridding, or NoLattice for an extraction";
    throw InputError(text.str());
  }
  if (!(columns.maxCoeff() <= MostColumnsPerSide))
  {
    std::ostringstream text;
    text.precision(15);
    text << "lattice of " << columns.x() << " x " << columns.y() << " columns" << steps
         << ", expected less than 2^28 along a side; is there a pick far away from all others?";
    throw InputError(text.str());
  }
  if (columns.prod() > std::max(EnoughColumns, MostColumnsPerPick * double(picks.Size())))
  {
    const std::size_t farthest = FindFarthest(fit, picks);
    std::ostringstream text;
    text.precision(15);
    text << "lattice of " << columns.x() << " x " << columns.y() << " columns for " << picks.Size()
         << " picks, expected at most " << MostColumnsPerPick << " columns a pick; " << PicksText(picks, { farthest })
         << ", in column " << ToText(fit.Index(picks, farthest) - range.First) << ", is the farthest from the others";
    throw InputError(text.str());
  }
}

/// Distant picks can rotate the fitted lattice onto themselves. If they are off the lattice of the other picks, throws
/// InputError; otherwise adds a warning. Returns true if there are any.
bool CheckFarPicks(
  const PickFit& fit, const PickTable& picks, const PlacementOptions& options, std::vector<std::string>& warnings)
{
  const bool isSparse = fit.Range.Columns().prod() > FewColumnsPerPick * double(picks.Size());
  const std::vector<std::size_t> strays =
    isSparse ? FindAllStrays(picks, options, Monitor()) : std::vector<std::size_t>();
  if (strays.empty())
  {
    return false;
  }
  const PickFit ofOthers = FitPicks(WithoutPicks(PickPlaces(picks), strays), options);
  std::vector<std::size_t> off;
  std::copy_if(strays.begin(), strays.end(), std::back_inserter(off),
    [&](std::size_t pick) { return !(ofOthers.Distance(picks, pick) <= ofOthers.Tolerance); });
  if (!off.empty())
  {
    std::ostringstream text;
    text << off.size() << " of " << picks.Size() << " picks off the lattice of the others, far from these, "
         << PicksText(picks, off) << "; expected at most LatticeTolerance, " << ofOthers.Tolerance
         << ", or StrayPicks LeaveOut";
    throw InputError(text.str());
  }
  warnings.push_back(
    CountText(strays.size()) + " far from all others, " + PicksText(picks, strays) + ": StrayPicks leaves them out");
  return true;
}

SurveyLattice MakeLattice(SurveyLattice lattice, const ColumnRange& range)
{
  lattice.Columns = { int(range.Columns().x()), int(range.Columns().y()) };
  lattice.Origin += lattice.Steps() * range.First; // Line numbers and the range start at the first lines.
  return lattice;
}

std::vector<PlanePoint> ListColumns(const PickFit& fit, const PickPlaces& picks, const Monitor& monitor)
{
  std::vector<PlanePoint> list(picks.Size());
  ForEachChunk(std::int64_t(list.size()), ChunkSize, monitor,
    [&](std::size_t, std::int64_t begin, std::int64_t end)
    {
      for (auto pick = std::size_t(begin); pick < std::size_t(end); ++pick)
      {
        const Eigen::Vector2d index = fit.Index(picks, pick) - fit.Range.First;
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
  PlaceRows(picks, options);
  if (picks.Size() == 0 || picks.Size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
  {
    throw InputError(std::to_string(picks.Size()) + " picks, expected at least 1 and less than 2^31");
  }
  CheckNumber(picks.Names.size(), picks.Size(), " horizons, expected at most ");
  SurveyHorizons placed;
  placed.Warnings = std::move(picks.Warnings);
  if (options.LeaveOutStrays)
  {
    const std::vector<std::size_t> strays = FindAllStrays(picks, options, monitor.Step(0.0, 0.4));
    if (!strays.empty())
    {
      placed.Warnings.push_back(CountText(strays.size()) + " left out as strays: " + PicksText(picks, strays));
      picks = WithoutPicks(std::move(picks), strays);
    }
  }
  const PickFit fit = FitPicks(picks, options, monitor.Step(options.LeaveOutStrays ? 0.4 : 0.0, 0.6));
  CheckFit(fit, picks);
  const bool hasFarPicks = !options.LeaveOutStrays && CheckFarPicks(fit, picks, options, placed.Warnings);
  placed.Survey = picks.Survey;
  placed.Lattice = MakeLattice(fit.Lattice, fit.Range);
  placed.LargestDistance = fit.Range.LargestDistance;
  const std::vector<PlanePoint> columns = ListColumns(fit, picks, monitor.Step(0.6, 0.7));
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
    CheckNumber(placed.Horizons.size(), picks.Size(), " sheets, expected at most ");
  }
  return placed;
}
}
