// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuideSeeds.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
// Polarity turns if this number of picks nearby, and this part of all, mean the other sign.
constexpr int FewestTurned = 2;
constexpr double LeastPartTurned = 0.1;

std::string PickText(const GuidePick& pick)
{
  std::ostringstream text;
  text << "at column " << pick.I << ", row " << pick.J << ", sample " << pick.Place;
  return text.str();
}

std::string NameText(const Guide& guide)
{
  return "guide \"" + guide.Name + "\": ";
}

std::vector<std::size_t> ListByColumn(const std::vector<GuidePick>& picks)
{
  std::vector<std::size_t> order(picks.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&picks](std::size_t a, std::size_t b) {
      return std::tie(picks[a].J, picks[a].I, picks[a].Place, a) < std::tie(picks[b].J, picks[b].I, picks[b].Place, b);
    });
  return order;
}

/// Picks of a column must be within `quarter`.
void CheckGuide(const Guide& guide, const std::vector<std::size_t>& order, const std::array<int, 2>& columns,
  int samples, double quarter)
{
  if (guide.Picks.empty())
  {
    throw InputError(NameText(guide) + "no picks, expected one or more");
  }
  const GuidePick* previous = nullptr;
  for (const std::size_t number : order)
  {
    const GuidePick& pick = guide.Picks[number];
    if (pick.I < 0 || pick.I >= columns[0] || pick.J < 0 || pick.J >= columns[1] ||
      !(pick.Place >= 0.0 && pick.Place <= samples - 1))
    {
      throw InputError(NameText(guide) + "pick " + std::to_string(number + 1) + ' ' + PickText(pick) +
        ", is outside of the cube, which has " + std::to_string(columns[0]) + " columns, " +
        std::to_string(columns[1]) + " rows and " + std::to_string(samples) + " samples");
    }
    if (previous && previous->I == pick.I && previous->J == pick.J && pick.Place - previous->Place > quarter)
    {
      std::ostringstream text;
      text << NameText(guide) << "two picks in one column, " << PickText(*previous) << " and " << pick.Place
           << ", expected one, or both within a quarter of the dominant period, " << quarter << " samples";
      throw InputError(text.str());
    }
    previous = &pick;
  }
}

struct SeedCandidate
{
  PointId Pick = NoPoint;
  double Weight = 0.0;
};

SeedCandidate FindNearest(const ReflectionPicks& picks, const GuidePick& pick, double tolerance)
{
  const std::int64_t column = picks.ColumnAt(pick.I, pick.J);
  SeedCandidate best;
  for (PointId candidate = picks.Begin(column); candidate < picks.End(column); ++candidate)
  {
    // A little weight is left at the tolerance itself.
    const double distance = std::abs(InSamples(picks.Places[candidate]) - pick.Place);
    const double weight = (1.01 - distance / tolerance) * picks.StrengthOf(candidate);
    if (distance <= tolerance && weight > best.Weight)
    {
      best = { candidate, weight };
    }
  }
  return best;
}

/// Counts picks in cells of the survey, about one in each.
class PickMap
{
public:
  PickMap(const std::array<int, 2>& columns, std::size_t picks)
    : Side(std::max(1, int(std::sqrt(double(columns[0]) * columns[1] / double(picks)))))
    , Size({ columns[0] / this->Side + 3, columns[1] / this->Side + 3 })
    , Counts(std::size_t(this->Size[0]) * std::size_t(this->Size[1]), 0)
  {
  }

  void Add(const GuidePick& pick) { ++this->Counts[this->CellOf(pick)]; }

  /// In the cell of the pick and those beside it.
  int CountAround(const GuidePick& pick) const
  {
    int count = 0;
    for (const int row : { -1, 0, 1 })
    {
      for (const int column : { -1, 0, 1 })
      {
        count += this->Counts[this->CellOf(pick) + std::size_t(row * this->Size[0] + column)];
      }
    }
    return count;
  }

private:
  std::size_t CellOf(const GuidePick& pick) const
  {
    return std::size_t(pick.J / this->Side + 1) * std::size_t(this->Size[0]) + std::size_t(pick.I / this->Side + 1);
  }

  const int Side; // columns
  const std::array<int, 2> Size; // with a rim
  std::vector<int> Counts;
};

/// Marks picks that mean the other sign where most picks around do: picks that miss their reflections are among others.
std::vector<unsigned char> FindTurned(
  const Guide& guide, const std::array<int, 2>& columns, const std::vector<unsigned char>& areOfOther)
{
  PickMap all(columns, guide.Picks.size());
  PickMap others(columns, guide.Picks.size());
  for (std::size_t n = 0; n < guide.Picks.size(); ++n)
  {
    all.Add(guide.Picks[n]);
    if (areOfOther[n] != 0)
    {
      others.Add(guide.Picks[n]);
    }
  }
  std::vector<unsigned char> areTurned(guide.Picks.size(), 0);
  for (std::size_t n = 0; n < guide.Picks.size(); ++n)
  {
    const int around = others.CountAround(guide.Picks[n]);
    areTurned[n] = areOfOther[n] != 0 && around >= FewestTurned && 2 * around > all.CountAround(guide.Picks[n]);
  }
  return areTurned;
}

struct SignsOfPicks
{
  std::vector<unsigned char> AreOfOther; // nearer to strong reflections of the other sign
  std::vector<unsigned char> AreTurned; // those of them that are followed
};

/// Finds the sign of which the picks are nearest to strong reflections, and where it turns.
SignsOfPicks ChooseSign(
  const Guide& guide, const std::array<ReflectionPicks, 2>& bySign, double tolerance, GuideUse& use)
{
  std::array<double, 2> votes = { 0.0, 0.0 };
  std::array<std::vector<unsigned char>, 2> areOf;
  for (const GuidePick& pick : guide.Picks)
  {
    const double positive = FindNearest(bySign[0], pick, tolerance).Weight;
    const double negative = FindNearest(bySign[1], pick, tolerance).Weight;
    votes[0] += positive;
    votes[1] += negative;
    areOf[0].push_back(positive > negative ? 1 : 0);
    areOf[1].push_back(negative > positive ? 1 : 0);
  }
  use.IsNegative = votes[1] > votes[0];
  SignsOfPicks signs;
  signs.AreOfOther = std::move(areOf[use.IsNegative ? 0 : 1]);
  signs.AreTurned = FindTurned(guide, bySign[0].Columns, signs.AreOfOther);
  use.Turned = std::count(signs.AreTurned.begin(), signs.AreTurned.end(), 1);
  if (LeastPartTurned * double(guide.Picks.size()) > double(use.Turned))
  {
    use.Turned = 0;
    std::fill(signs.AreTurned.begin(), signs.AreTurned.end(), 0);
  }
  return signs;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::array<std::vector<GuideSeed>, 2> FindGuideSeeds(const Guide& guide, const std::array<ReflectionPicks, 2>& bySign,
  int samples, double tolerance, double quarter, GuideUse& use)
{
  const std::vector<std::size_t> order = ListByColumn(guide.Picks);
  CheckGuide(guide, order, bySign[0].Columns, samples, quarter);
  const SignsOfPicks signs = ChooseSign(guide, bySign, tolerance, use);
  std::array<std::vector<GuideSeed>, 2> seeds;
  const std::size_t main = use.IsNegative ? 1 : 0;
  std::int32_t last = -1;
  for (const std::size_t number : order)
  {
    const GuidePick& pick = guide.Picks[number];
    const std::size_t sign = signs.AreTurned[number] != 0 ? 1 - main : main;
    const SeedCandidate found = FindNearest(bySign[sign], pick, tolerance);
    const auto column = std::int32_t(bySign[0].ColumnAt(pick.I, pick.J));
    if (column == last)
    {
      use.Doubled.push_back(number);
    }
    else if (found.Pick == NoPoint)
    {
      (signs.AreOfOther[number] != 0 ? use.OnOtherSign : use.NearNone).push_back(number);
    }
    else
    {
      seeds[sign].push_back({ found.Pick, column, number });
      last = column;
    }
  }
  for (std::vector<std::size_t>* const unused : { &use.OnOtherSign, &use.NearNone, &use.Doubled })
  {
    std::sort(unused->begin(), unused->end());
  }
  if (seeds[0].empty() && seeds[1].empty())
  {
    std::ostringstream text;
    text << NameText(guide) << "none of " << guide.Picks.size() << " picks is within " << tolerance
         << " samples of a strong reflection, expected one at least: a larger GuideTolerance, or a lower threshold";
    throw InputError(text.str());
  }
  return seeds;
}
}
