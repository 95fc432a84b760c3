// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuideSeeds.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
std::string PlaceText(const GuidePick& pick)
{
  std::ostringstream text;
  text << "at column " << pick.I << ", row " << pick.J << ", sample " << pick.Place;
  return text.str();
}

class SeedFinder
{
public:
  SeedFinder(const Guide& guide, const std::array<ReflectionPicks, 2>& bySign, double tolerance)
    : Given(guide)
    , BySign(bySign)
    , Tolerance(tolerance)
    , Order(guide.Picks.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    std::sort(this->Order.begin(), this->Order.end(),
      [&picks = guide.Picks](std::size_t a, std::size_t b) {
        return std::tie(picks[a].J, picks[a].I, picks[a].Place, a) <
          std::tie(picks[b].J, picks[b].I, picks[b].Place, b);
      });
  }

  void Check(int samples, double quarter) const
  {
    if (this->Given.Picks.empty())
    {
      throw InputError(this->Name() + "no picks, expected one or more");
    }
    const GuidePick* previous = nullptr;
    for (const std::size_t number : this->Order)
    {
      const GuidePick& pick = this->Given.Picks[number];
      const std::array<int, 2>& columns = this->BySign[0].Columns;
      if (pick.I < 0 || pick.I >= columns[0] || pick.J < 0 || pick.J >= columns[1] ||
        !(pick.Place >= 0.0 && pick.Place <= samples - 1))
      {
        throw InputError(this->Name() + "pick " + std::to_string(number + 1) + ' ' + PlaceText(pick) +
          ", is outside of the cube, which has " + std::to_string(columns[0]) + " columns, " +
          std::to_string(columns[1]) + " rows and " + std::to_string(samples) + " samples");
      }
      if (previous && previous->I == pick.I && previous->J == pick.J && pick.Place - previous->Place > quarter)
      {
        std::ostringstream text;
        text << this->Name() << "two picks in one column, " << PlaceText(*previous) << " and " << pick.Place
             << ", expected one, or both within a quarter of the dominant period, " << quarter << " samples";
        throw InputError(text.str());
      }
      previous = &pick;
    }
  }

  GuideSeeds Find() const
  {
    std::array<double, 2> votes = { 0.0, 0.0 };
    for (const GuidePick& pick : this->Given.Picks)
    {
      for (const int sign : { 0, 1 })
      {
        votes[sign] += this->NearestTo(pick, sign).Weight;
      }
    }
    GuideSeeds result;
    result.Sign = votes[1] > votes[0] ? 1 : 0;
    for (const std::size_t number : this->Order)
    {
      this->AddSeed(number, result);
    }
    std::sort(result.Unused.begin(), result.Unused.end());
    if (result.Seeds.empty())
    {
      std::ostringstream text;
      text << this->Name() << "none of " << this->Given.Picks.size() << " picks is within " << this->Tolerance
           << " samples of a strong reflection, expected one at least: a larger GuideTolerance, or a lower threshold";
      throw InputError(text.str());
    }
    return result;
  }

private:
  struct Candidate
  {
    PointId Pick = NoPoint;
    double Weight = 0.0;
  };

  std::string Name() const { return "guide \"" + this->Given.Name + "\": "; }

  Candidate NearestTo(const GuidePick& pick, int sign) const
  {
    const ReflectionPicks& picks = this->BySign[sign];
    const std::int64_t column = picks.ColumnAt(pick.I, pick.J);
    Candidate best;
    for (PointId candidate = picks.Begin(column); candidate < picks.End(column); ++candidate)
    {
      // A little weight is left at the tolerance itself.
      const double distance = std::abs(InSamples(picks.PlaceOf(candidate)) - pick.Place);
      const double weight = (1.01 - distance / this->Tolerance) * StrengthOf(picks.CoarseStrengthOf(candidate));
      if (distance <= this->Tolerance && weight > best.Weight)
      {
        best = { candidate, weight };
      }
    }
    return best;
  }

  void AddSeed(std::size_t number, GuideSeeds& result) const
  {
    const GuidePick& pick = this->Given.Picks[number];
    const Candidate found = this->NearestTo(pick, result.Sign);
    const Candidate other = this->NearestTo(pick, 1 - result.Sign);
    result.OtherSign += other.Weight > found.Weight ? 1 : 0;
    const auto column = std::int32_t(this->BySign[result.Sign].ColumnAt(pick.I, pick.J));
    if (found.Pick == NoPoint || (!result.Seeds.empty() && result.Seeds.back().Column == column))
    {
      result.Unused.push_back(number);
      return;
    }
    result.Seeds.push_back({ found.Pick, column, number });
  }

  const Guide& Given;
  const std::array<ReflectionPicks, 2>& BySign;
  const double Tolerance;
  std::vector<std::size_t> Order;
};
}

//----------------------------------------------------------------------------------------------------------------------
GuideSeeds FindGuideSeeds(
  const Guide& guide, const std::array<ReflectionPicks, 2>& bySign, int samples, double tolerance, double quarter)
{
  const SeedFinder finder(guide, bySign, tolerance);
  finder.Check(samples, quarter);
  return finder.Find();
}
}
