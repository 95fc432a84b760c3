// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickWarnings.h"

#include "Common/Base/Errors.h"
#include "Common/Base/LeastSquares.h"
#include "Common/Horizon/Lattice.h"
#include "ShortSteps.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<double, 20> UsualNulls = { 0.0, -999.0, 999.0, -9999.0, 9999.0, -32768.0, 32767.0, -1.0, -99.0,
  -32767.0, 99999.0, -99999.0, 999999.0, -999999.0, -999.25, 999.25, -9999.25, -999.99, -9999.99, 9999900.0 };
constexpr double LeastFilled = 0.1;
constexpr double LeastNeighbours = 0.5;
constexpr double Freedom = 6.0; // An origin and two steps have six numbers.

double PartWithNeighbours(const std::vector<PlanePoint>& columns)
{
  const auto has = [&columns](int i, int j) {
    return std::binary_search(columns.begin(), columns.end(), PlanePoint{ i, j });
  };
  const auto number = std::count_if(columns.begin(), columns.end(),
    [&has](const PlanePoint& at)
    { return has(at.X - 1, at.Y) || has(at.X + 1, at.Y) || has(at.X, at.Y - 1) || has(at.X, at.Y + 1); });
  return double(number) / double(columns.size());
}
constexpr int ConflictReach = 4; // columns
constexpr std::size_t MostLookedAt = 10000;

/// The conflicts around a column are narrow in some direction.
bool IsOnLine(const std::vector<ColumnConflict>& conflicts, const PlanePoint& at)
{
  constexpr double fewest = 4.0;
  constexpr double widest = 0.4; // Standard deviations, relative to the length.
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  double count = 0.0;
  for (int j = at.Y - ConflictReach; j <= at.Y + ConflictReach; ++j)
  {
    const auto isBefore = [j](const ColumnConflict& conflict, int i)
    { return conflict.Column.Y < j || (conflict.Column.Y == j && conflict.Column.X < i); };
    auto near = std::lower_bound(conflicts.begin(), conflicts.end(), at.X - ConflictReach, isBefore);
    for (; near != conflicts.end() && near->Column.Y == j && near->Column.X <= at.X + ConflictReach; ++near)
    {
      const Eigen::Vector2d off(near->Column.X - at.X, j - at.Y);
      sum += off;
      squares += off * off.transpose();
      count += 1.0;
    }
  }
  const Eigen::Matrix2d spread = squares / count - sum * sum.transpose() / (count * count);
  const Eigen::Vector2d axes = FindPrincipalAxes(spread).Values;
  return count >= fewest && axes[0] <= widest * widest * axes[1];
}

using Heights = std::vector<double>::const_iterator;

bool IsNull(double null, std::ptrdiff_t count, Heights others, Heights end)
{
  const bool isUsual = std::find(UsualNulls.begin(), UsualNulls.end(), null) != UsualNulls.end();
  const auto [least, greatest] = std::minmax_element(others, end);
  const double range = *greatest - *least;
  const double gap = std::max(*least - null, null - *greatest);
  // A flat part of a horizon may be far from the rest, but not by half its distance from 0.
  const double leastGap = isUsual ? 0.0 : 0.5 * std::max(std::abs(*least), std::abs(*greatest));
  // Most z of a level horizon with a wrong pick are the same.
  const bool mayBe = count <= end - others ? count > (isUsual ? 0 : 1) : isUsual && range > 0.0;
  return mayBe && gap > range && gap > leastGap;
}
}

//----------------------------------------------------------------------------------------------------------------------
void WarnOfNulls(std::vector<double> z, std::vector<std::string>& warnings)
{
  const std::size_t all = z.size();
  std::ostringstream nulls;
  nulls.precision(12);
  for (bool isFound = true; std::exchange(isFound, false) && !z.empty();)
  {
    const auto ends = std::minmax_element(z.begin(), z.end());
    for (const double null : { *ends.first, *ends.second })
    {
      const auto others = std::partition(z.begin(), z.end(), [null](double value) { return value == null; });
      if (!isFound && others != z.end() && IsNull(null, others - z.begin(), others, z.end()))
      {
        nulls << (z.size() == all ? "" : " or ") << null;
        z.erase(z.begin(), others);
        isFound = true;
      }
    }
  }
  if (z.size() < all)
  {
    const auto ends = std::minmax_element(z.begin(), z.end());
    const std::string found = nulls.str();
    nulls << ", far from all others, " << *ends.first << " to " << *ends.second << ": add " << found
          << " to NullValues if it means that there is no z";
    warnings.push_back(std::to_string(all - z.size()) + " of " + std::to_string(all) + " points with z " + nulls.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WarnOfNulls(const std::vector<double>& nulls, const std::vector<double>& z, std::vector<std::string>& warnings)
{
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const double value : nulls.empty() ? nulls : z)
  {
    least = std::fmin(least, value);
    greatest = std::fmax(greatest, value);
  }
  const double margin = 0.1 * (greatest - least);
  const auto isNear = [&](double null) { return null >= least - margin && null <= greatest + margin; };
  const auto null = std::find_if(nulls.begin(), nulls.end(), isNear);
  if (null != nulls.end())
  {
    std::ostringstream text;
    text << *null << " at " << std::count_if(null, nulls.end(), isNear) << " of " << z.size()
         << " points is read as missing z, as is usual, but others have z from " << least << " to " << greatest
         << ": remove it from NullValues to keep it";
    warnings.push_back(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WarnOfMoves(const PickTable& picks, const std::vector<PlanePoint>& columns, SurveyHorizons& placed)
{
  constexpr double fewColumns = 0.02;
  double farthest = 0.0;
  for (std::size_t pick = 0; picks.HasPlaces() && placed.LargestDistance > fewColumns && pick < columns.size(); ++pick)
  {
    const Eigen::Vector2d column = placed.Lattice.Steps() * Eigen::Vector2d(columns[pick].X, columns[pick].Y);
    farthest =
      std::max(farthest, (placed.Lattice.Origin + column - Eigen::Vector2d(picks.X[pick], picks.Y[pick])).norm());
  }
  if (farthest > std::min(FindRounding(picks.X, picks.Y), 1.0))
  {
    std::ostringstream text;
    text.precision(4);
    text << "picks are moved by up to " << farthest << ", in the unit of x and y, onto the lattice with the steps "
         << ToText(placed.Lattice.ColumnStep) << " and " << ToText(placed.Lattice.RowStep)
         << ": LatticeSource OriginAndSteps sets another lattice, Gridding needs none";
    placed.Warnings.push_back(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> FindWarnings(const SurveyHorizons& horizons, DuplicatePolicy policy)
{
  constexpr std::int64_t least = 1000; // columns per column in conflict
  std::vector<std::string> warnings = horizons.Warnings;
  std::int64_t columns = 0;
  for (const LatticeHorizon& horizon : horizons.Horizons)
  {
    columns += std::int64_t(horizon.RealZ.size());
  }
  ConflictCount conflicts;
  for (const ConflictCount& own : horizons.Conflicts)
  {
    conflicts.Columns += own.Columns;
    conflicts.InLines += own.InLines;
    conflicts.Largest = std::max(conflicts.Largest, own.Largest);
  }
  const bool areLines = 2 * conflicts.InLines > conflicts.Columns;
  const bool isChosen = policy != DuplicatePolicy::StrongestAmplitude && !(policy == DuplicatePolicy::Mean && areLines);
  if (least * conflicts.Columns <= columns || isChosen)
  {
    return warnings;
  }
  std::ostringstream text;
  text << conflicts.Columns << " of " << columns << " columns have several z, up to " << conflicts.Largest << " apart";
  if (areLines)
  {
    text
      << ", " << conflicts.InLines
      << " of them in lines, as along faults where a node has the z of both sides: DuplicatePolicy Topmost keeps the "
         "upper side, Lowest the lower one, Sheets both as separate horizons, and Mean averages them";
  }
  else
  {
    text
      << ": DuplicatePolicy chooses which is kept, such as Mean for overlapping surveys, or Sheets for a horizon that "
         "overlies itself; for several horizons in one file, name the column that distinguishes them";
  }
  warnings.push_back(text.str());
  return warnings;
}

//----------------------------------------------------------------------------------------------------------------------
ConflictCount CountConflicts(const ColumnOrder& order)
{
  const std::vector<ColumnConflict>& conflicts = order.Conflicts;
  const std::size_t stride = conflicts.size() / MostLookedAt + 1;
  std::size_t found = 0;
  ConflictCount count;
  for (std::size_t n = 0; n < conflicts.size(); ++n)
  {
    count.Largest = std::max(count.Largest, conflicts[n].Difference);
    found += n % stride == 0 && IsOnLine(conflicts, conflicts[n].Column) ? stride : 0;
  }
  count.Repeats = order.Repeats;
  count.Columns = std::int64_t(conflicts.size());
  count.InLines = std::int64_t(std::min(found, conflicts.size()));
  return count;
}

//----------------------------------------------------------------------------------------------------------------------
void RequireEvidence(std::vector<PlanePoint> columns, const SurveyLattice& lattice, const PickTable& picks)
{
  const bool areLines = picks.HasLines();
  if (areLines && (picks.HasPlaces() || !picks.AreLinesGuessed))
  {
    return;
  }
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  const double all = double(lattice.Columns[0]) * double(lattice.Columns[1]);
  const auto filled = double(columns.size());
  if (filled < LeastFilled * all && PartWithNeighbours(columns) < LeastNeighbours)
  {
    throw InputError("picks in " + std::to_string(columns.size()) + " of " + std::to_string(lattice.Columns[0]) +
      " x " + std::to_string(lattice.Columns[1]) +
      " columns of the lattice, expected a tenth of these, or picks next to each other" +
      (areLines ? ", as with line numbers: if columns without names are X and Y, set Columns"
                : ": Gridding makes a horizon of wells, 2D lines and scattered picks, LatticeSource OriginAndSteps "
                  "gives the lattice of a survey, NoLattice is for picks that guide an extraction"));
  }
  if (!areLines && filled < Freedom && filled < all)
  {
    throw InputError("picks at " + std::to_string(int(filled)) +
      " positions, expected at least 6, or a full lattice, to find it: Gridding makes a horizon of few picks, "
      "LatticeSource OriginAndSteps gives the lattice, NoLattice is for picks that guide an extraction");
  }
}
}
