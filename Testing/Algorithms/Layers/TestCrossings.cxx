// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons that cross: small stacks with the heights they must get, and random ones beside the max-min formula of
// isotonic regression, which pools nothing.

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Layers/Crossings.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr auto Mean = CrossingPolicy::Mean;
constexpr auto Upper = CrossingPolicy::UpperWins;
constexpr auto Lower = CrossingPolicy::LowerWins;
constexpr auto Stop = CrossingPolicy::Stop;

/// One column.
std::vector<double> Repair(
  const std::vector<double>& heights, const std::vector<CrossingPolicy>& policies, bool downwards, double minimum = 0.0)
{
  HeightStack stack;
  for (const double height : heights)
  {
    stack.push_back({ height });
  }
  CrossingOptions options;
  options.Policies = policies;
  options.HeightsGrowDownwards = downwards;
  options.MinimumThickness = minimum;
  RepairCrossings(stack, options);
  std::vector<double> result;
  for (const auto& horizon : stack)
  {
    result.push_back(horizon.front());
  }
  return result;
}

using Heights = std::vector<double>;

void TestSmallStacks()
{
  CHECK((Repair({ 1, 2, 3 }, { Mean }, true) == Heights{ 1, 2, 3 }));
  CHECK((Repair({ 3, 2, 1 }, { Mean }, false) == Heights{ 3, 2, 1 }));
  CHECK((Repair({ 2, 1 }, { Mean }, true) == Heights{ 1.5, 1.5 }));
  CHECK((Repair({ 2, 1 }, { Upper }, true) == Heights{ 2, 2 }));
  CHECK((Repair({ 2, 1 }, { Lower }, true) == Heights{ 1, 1 }));
  CHECK((Repair({ 1, 2 }, { Upper }, false) == Heights{ 1, 1 }));
  // Three that cross have one mean, whatever pair would be first: 4, 6, 2 pools 6 and 2 to 4, which is where 4 is.
  CHECK((Repair({ 3, 6, 0 }, { Mean }, true) == Heights{ 3, 3, 3 }));
  CHECK((Repair({ 4, 6, 0 }, { Mean }, true) == Heights{ 10.0 / 3, 10.0 / 3, 10.0 / 3 }));
  CHECK((Repair({ 4, 2, 1 }, { Upper }, true) == Heights{ 4, 4, 4 }));
  CHECK((Repair({ 4, 2, 1 }, { Lower }, true) == Heights{ 1, 1, 1 }));
  // A basement rises through a fill of two horizons that only noise makes cross.
  CHECK((Repair({ 5, 4, 9 }, { Mean, Lower }, true) == Heights{ 4.5, 4.5, 9 }));
  CHECK((Repair({ 5, 4, 3 }, { Mean, Lower }, true) == Heights{ 3, 3, 3 }));
  // Between two that win, as both of them cross: the mean of these.
  CHECK((Repair({ 6, 0, 4 }, { Upper, Lower }, true) == Heights{ 5, 5, 5 }));
  CHECK((Repair({ 3, 0, 4 }, { Upper, Lower }, true) == Heights{ 3, 3, 4 }));
  CHECK((Repair({ 3, 9, 4 }, { Upper, Lower }, true) == Heights{ 3, 4, 4 }));
  CHECK((Repair({ 5, 3, 4 }, { Lower, Upper }, true) == Heights{ 3, 3, 4 }));
  // Thinner than it may be is as good as nothing; what just is thick enough stays.
  CHECK((Repair({ 1.0, 1.5, 4.0 }, { Upper }, true, 1.0) == Heights{ 1, 1, 4 }));
  CHECK((Repair({ 1.0, 2.0, 4.0 }, { Upper }, true, 1.0) == Heights{ 1, 2, 4 }));
}

void TestCounts()
{
  HeightStack stack = { { 1, 2, 3, 4 }, { 2, 1, 0, 4 }, { 5, 5, 5, 3 } };
  CrossingOptions options;
  options.HeightsGrowDownwards = true;
  options.Policies = { Mean, Upper };
  const CrossingRepair repair = RepairCrossings(stack, options);
  CHECK_EQUAL(repair.Interfaces[0].Columns, 2);
  CHECK_EQUAL(repair.Interfaces[0].Largest, 3.0);
  CHECK_EQUAL(repair.Interfaces[1].Columns, 1);
  CHECK_EQUAL(repair.Interfaces[1].Largest, 1.0);
  CHECK_EQUAL(repair.Horizons[0].Columns, 2);
  CHECK_EQUAL(repair.Horizons[0].Largest, 1.5);
  CHECK_EQUAL(repair.Horizons[1].Columns, 2);
  CHECK_EQUAL(repair.Horizons[2].Columns, 1);
  CHECK_EQUAL(repair.Horizons[2].Largest, 1.0);
  CHECK((stack == HeightStack{ { 1, 1.5, 1.5, 4 }, { 2, 1.5, 1.5, 4 }, { 5, 5, 5, 4 } }));
}

void TestMessages()
{
  const auto repair = [](HeightStack stack, std::vector<CrossingPolicy> policies, double minimum = 0.0)
  {
    CrossingOptions options;
    options.Policies = std::move(policies);
    options.MinimumThickness = minimum;
    return RepairCrossings(stack, options);
  };
  CHECK_THROWS_WITH(repair({}, { Mean }), "no horizon, expected at least 2");
  CHECK_THROWS_WITH(repair({ { 1 } }, { Mean }), "one horizon, expected at least 2");
  CHECK_THROWS_WITH(repair({ { 1 }, { 1 } }, { Mean, Mean }), "2 policies of crossings, expected one, or 1 for 2");
  CHECK_THROWS_WITH(repair({ { 1 }, { 1 } }, { Mean }, -1.0), "minimum thickness -1, expected at least 0");
  CHECK_THROWS_WITH(repair({ { 9, 1, 1 }, { 5, 3, 3.5 }, { 1, 1, 1 } }, { Stop, Mean }),
    "horizon 1 and horizon 2 cross in 2 columns, by up to 2.5 lattice units, expected none: choose Mean, UpperWins or "
    "LowerWins");
  CHECK_THROWS_WITH(
    repair({ { 5 }, { 3 }, { 4 } }, { Mean, Stop }), "horizon 2 and horizon 3 cross in 1 column, by up to 1 lattice");
  CHECK_EQUAL(repair({ { 1, 2 }, { 1, 1 } }, { Stop }).Horizons[0].Columns, 0); // touching is not crossing
}

// The depth of horizon n is the largest of the least means of runs that hold it, in which only those count that weigh
// most.
double MaxMin(const std::vector<double>& depths, const std::vector<int>& weights, std::size_t n)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first <= n; ++first)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t last = n; last < depths.size(); ++last)
    {
      const int most = *std::max_element(weights.begin() + long(first), weights.begin() + long(last) + 1);
      double sum = 0.0;
      int count = 0;
      for (std::size_t m = first; m <= last; ++m)
      {
        sum += weights[m] == most ? depths[m] : 0.0;
        count += weights[m] == most ? 1 : 0;
      }
      least = std::min(least, sum / count);
    }
    largest = std::max(largest, least);
  }
  return largest;
}

void TestRandomStacks()
{
  std::mt19937 random(7);
  for (int run = 0; run < 5000; ++run)
  {
    const std::size_t size = 2 + random() % 4;
    std::vector<double> depths(size);
    std::vector<CrossingPolicy> policies;
    std::vector<int> weights = { 0 };
    for (std::size_t n = 0; n < size; ++n)
    {
      depths[n] = run % 2 == 0 ? double(random() % 5) : double(random() % 1000) / 300.0;
      if (n > 0)
      {
        const int step = int(random() % 3) - 1;
        policies.push_back(step == 0 ? Mean : step < 0 ? Upper : Lower);
        weights.push_back(weights.back() + step);
      }
    }
    const std::vector<double> repaired = Repair(depths, policies, true);
    bool isRight = std::is_sorted(repaired.begin(), repaired.end());
    for (std::size_t n = 0; n < size; ++n)
    {
      isRight = isRight && std::abs(repaired[n] - MaxMin(depths, weights, n)) < 1e-12;
    }
    CHECK(isRight);
    CHECK(Repair(repaired, policies, true) == repaired);
  }
}

void TestThreads()
{
  HeightStack stack(3, std::vector<double>(100000));
  std::mt19937 random(1);
  for (auto& horizon : stack)
  {
    std::generate(horizon.begin(), horizon.end(), [&]() { return double(random() % 1000) / 7.0; });
  }
  const auto repair = [&stack](int threads)
  {
    Detail::NumberOfThreads() = threads;
    HeightStack copy = stack;
    const CrossingRepair result = RepairCrossings(copy);
    CHECK(result.Horizons[1].Columns > 1000);
    return copy;
  };
  CHECK(repair(1) == repair(3));
}
}

int TestCrossings(int, char*[])
{
  TestSmallStacks();
  TestCounts();
  TestMessages();
  TestRandomStacks();
  TestThreads();
  return Check::Result();
}
