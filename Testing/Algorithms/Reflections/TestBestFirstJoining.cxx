// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces joined best first, beside an implementation of the same rules that keeps each part as a map.

#include "Filters/Algorithms/Reflections/SurfaceJoining.h"
#include "PickFixtures.h"
#include "Tools/Check.h"

#include <map>
#include <memory>

using namespace PickFixtures;

namespace
{
/// A part: its picks by column.
using Part = std::map<std::int32_t, PointId>;

class Oracle
{
public:
  Oracle(const ReflectionPicks& picks, const ReflectionLinks& links, const JoiningRules& rules)
    : Picks(picks)
    , Links(links)
    , Rules(rules)
    , Columns(picks.ListColumns())
  {
    for (PointId pick = 0; pick < picks.Size(); ++pick)
    {
      this->Names.push_back(pick);
      this->Parts[pick] = { { this->Columns[std::size_t(pick)], pick } };
    }
  }

  std::vector<PointId> Run(const JoiningRules& rules)
  {
    this->Rules = rules;
    this->Sizes.clear();
    return this->Run();
  }

  std::vector<PointId> Run()
  {
    std::vector<LinkId> refused = this->TryAll(SortByRank(this->Links));
    this->Sizes.clear();
    this->TryAll(refused);
    return this->Names;
  }

private:
  std::vector<LinkId> TryAll(const std::vector<LinkId>& links)
  {
    std::vector<LinkId> refused;
    for (const LinkId link : links)
    {
      const PointId from = this->Links.PickOf(link);
      PointId big = this->Names[std::size_t(from)];
      PointId small = this->Names[std::size_t(this->Links.Next(from, this->Links.DirectionOf(link)))];
      if (big == small || big == NoPoint || small == NoPoint)
      {
        continue;
      }
      if (this->Parts[big].size() < this->Parts[small].size())
      {
        std::swap(big, small);
      }
      if (!this->Join(big, small))
      {
        refused.push_back(link);
      }
    }
    return refused;
  }

  /// False where the parts do not fit.
  bool Join(PointId big, PointId small)
  {
    const double size = double(this->Parts[big].size() + this->Parts[small].size());
    double& refusedSize = this->Sizes[{ std::min(big, small), std::max(big, small) }];
    if (refusedSize > 0.0 && size < 1.3 * refusedSize)
    {
      return false;
    }
    if (!this->Fit(this->Parts[big], this->Parts[small]))
    {
      refusedSize = size;
      return false;
    }
    for (const auto& [column, pick] : this->Parts[small])
    {
      const bool isNew = this->Parts[big].insert({ column, pick }).second;
      this->Names[std::size_t(pick)] = isNew ? big : NoPoint;
    }
    this->Parts.erase(small);
    return true;
  }

  bool AreLinked(PointId a, PointId b) const
  {
    for (int direction = 0; direction < this->Links.Directions(); ++direction)
    {
      if (this->Links.Next(a, direction) == b || this->Links.Next(b, direction) == a)
      {
        return true;
      }
    }
    return false;
  }

  bool Fit(const Part& big, const Part& small) const
  {
    double shared = 0.0;
    double facing = 0.0;
    std::vector<Edge> pairs;
    for (const auto& [column, pick] : small)
    {
      shared += double(big.count(column));
      for (const auto& [otherColumn, other] : big)
      {
        if (this->AreNeighbours(column, otherColumn))
        {
          facing += 1.0;
          if (this->AreLinked(pick, other))
          {
            pairs.push_back({ pick, other });
          }
        }
      }
    }
    const double size = double(small.size());
    if (shared > std::floor(this->Rules.LargestShare * size))
    {
      return false;
    }
    if (size < this->Rules.ContactSize)
    {
      return true;
    }
    const double linked = double(pairs.size());
    const bool isWide = size >= this->Rules.LargestFilled && size > this->Rules.LargestFilledWidth * facing;
    const bool isAlike = !isWide ||
      (this->Rules.Correlate && linked >= double(this->Rules.FewestWidePairs) &&
        linked >= this->Rules.SmallestWideContact * facing &&
        this->Rules.Correlate(pairs) >= this->Rules.SmallestWideCorrelation);
    return linked >= this->Rules.SmallestContact * facing && isAlike;
  }

  bool AreNeighbours(std::int32_t a, std::int32_t b) const
  {
    const int di = std::abs(a % this->Picks.Columns[0] - b % this->Picks.Columns[0]);
    const int dj = std::abs(a / this->Picks.Columns[0] - b / this->Picks.Columns[0]);
    return di + dj == 1 || (this->Links.Directions() == 4 && di == 1 && dj == 1);
  }

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;
  JoiningRules Rules;
  const RawVector<std::int32_t> Columns;
  std::vector<PointId> Names; // of the parts of picks
  std::map<PointId, Part> Parts;
  std::map<std::pair<PointId, PointId>, double> Sizes; // when they were refused
};

struct Case
{
  Traces Cube;
  ReflectionPicks Picks;
  std::unique_ptr<ReflectionLinks> Links;
};

Case MakeCase(unsigned seed, ColumnConnectivity connectivity, const std::array<int, 3>& size = { 14, 12, 48 })
{
  Case test;
  test.Cube = Rough(size, seed);
  test.Picks = FindReflections(test.Cube.View()).BySign[seed % 2];
  LinkOptions options;
  options.Connectivity = connectivity;
  options.LargestStep = 3 * DepthsPerSample;
  options.HalfWidth = 6;
  test.Links = std::make_unique<ReflectionLinks>(test.Cube.View(), test.Picks, options);
  return test;
}

RawVector<PointId> Join(const Case& test, const JoiningRules& rules, double windowPicks = 1e9)
{
  BestFirstJoining joining(test.Picks, windowPicks);
  joining.Run(*test.Links, rules, Monitor());
  return joining.TakeSurfaces();
}

bool HasColumnTwice(const ReflectionPicks& picks, const RawVector<PointId>& surfaces)
{
  const RawVector<std::int32_t> columns = picks.ListColumns();
  std::map<std::pair<PointId, std::int32_t>, int> counts;
  for (PointId pick = 0; pick < picks.Size(); ++pick)
  {
    const PointId surface = surfaces[std::size_t(pick)];
    if (surface != NoPoint && ++counts[{ surface, columns[std::size_t(pick)] }] > 1)
    {
      return true;
    }
  }
  return false;
}

/// Each rule has a say somewhere: with it, the result is another one for one of the cubes.
void TestOracle()
{
  JoiningRules columns;
  columns.SmallestContact = 0.0;
  columns.LargestShare = 0.0;
  JoiningRules trim = columns;
  trim.LargestShare = 0.1;
  JoiningRules contact = trim;
  contact.ContactSize = 5;
  contact.SmallestContact = 0.5;
  JoiningRules fill = contact;
  fill.LargestFilled = 8;
  fill.LargestFilledWidth = 1.5;
  JoiningRules wide = fill;
  wide.FewestWidePairs = 2;
  wide.SmallestWideContact = 0.6;
  wide.Correlate = [](const std::vector<Edge>& pairs)
  {
    PointId sum = 0;
    for (const Edge& pair : pairs)
    {
      sum += pair.From + 3 * pair.To;
    }
    return sum % 3 == 0 ? 0.8 : 0.95;
  };
  std::vector<std::vector<PointId>> results; // by rules, then by cube
  constexpr std::size_t cubes = 4;
  for (const JoiningRules& rules : { columns, trim, contact, fill, wide })
  {
    for (unsigned seed = 1; seed <= cubes; ++seed)
    {
      const Case test = MakeCase(seed, seed % 3 == 0 ? ColumnConnectivity::Eight : ColumnConnectivity::Four);
      const RawVector<PointId> found = Join(test, rules);
      const std::vector<PointId> expected = Oracle(test.Picks, *test.Links, rules).Run();
      CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
      CHECK(!HasColumnTwice(test.Picks, found));
      results.push_back(expected);
    }
  }
  for (std::size_t rules = 1; rules < results.size() / cubes; ++rules)
  {
    const auto first = results.begin() + std::ptrdiff_t(rules * cubes);
    CHECK(!std::equal(first, first + cubes, first - cubes));
  }
}

/// Parts that spread over hundreds of columns, along i and along j.
void TestLongParts()
{
  JoiningRules rules;
  rules.LargestShare = 0.1;
  rules.SmallestContact = 0.3;
  std::size_t longest = 0;
  for (const std::array<int, 3>& size : { std::array<int, 3>{ 210, 2, 20 }, std::array<int, 3>{ 3, 140, 20 } })
  {
    const Case test = MakeCase(8, ColumnConnectivity::Eight, size);
    const RawVector<PointId> found = Join(test, rules);
    const std::vector<PointId> expected = Oracle(test.Picks, *test.Links, rules).Run();
    CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
    for (const PointId part : expected)
    {
      longest = std::max(longest, std::size_t(std::count(expected.begin(), expected.end(), part)));
    }
  }
  CHECK(longest > 300);
}

/// Windows of one column, of some, and of all give the same, on any number of threads.
void TestWindows()
{
  JoiningRules rules;
  rules.LargestShare = 0.1;
  rules.ContactSize = 8;
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const Case test = MakeCase(seed, seed % 2 == 0 ? ColumnConnectivity::Eight : ColumnConnectivity::Four);
    const RawVector<PointId> expected = Join(test, rules);
    for (const double windowPicks : { 1.0, 100.0, 400.0 })
    {
      const auto [one, three] = OnThreads([&]() { return Join(test, rules, windowPicks); });
      CHECK(one == expected);
      CHECK(three == expected);
    }
  }
}

/// Parts that are joined already grow on by other links and rules, as if each had been given to the oracle.
void TestSecondRun()
{
  const Case test = MakeCase(4, ColumnConnectivity::Four);
  JoiningRules rules;
  rules.ContactSize = 5;
  rules.LargestShare = 0.1;
  JoiningRules looser = rules;
  looser.SmallestContact = 0.2;
  Oracle oracle(test.Picks, *test.Links, rules);
  const std::vector<PointId> before = oracle.Run();
  const std::vector<PointId> expected = oracle.Run(looser);
  CHECK(before != expected);
  BestFirstJoining joining(test.Picks, 100.0);
  joining.Run(*test.Links, rules, Monitor());
  joining.Run(*test.Links, looser, Monitor());
  const RawVector<PointId> found = joining.TakeSurfaces();
  CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
}
}

int TestBestFirstJoining(int, char*[])
{
  TestOracle();
  TestLongParts();
  TestWindows();
  TestSecondRun();
  return Check::Result();
}
