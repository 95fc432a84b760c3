// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search for an error, on numbers of triangles that are formulas.

#include "Filters/Algorithms/Surface/Surface.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace SeismicHorizons;

namespace
{
struct Found
{
  double Error;
  std::size_t Triangles;
  int Runs;
};

Found Find(std::size_t most, double largest, const TriangleCounter& count)
{
  int runs = 0;
  const double error = FindErrorForTriangles(most, 0.75, largest,
    [&](double tried)
    {
      ++runs;
      CHECK(tried >= SmallestSearchedError * (1.0 - 1e-12) &&
        tried <= std::max(largest, SmallestSearchedError) * (1.0 + 1e-12));
      return count(tried);
    });
  return { error, count(error), runs };
}

/// Of powers like those of horizons, the search finds the error in a few runs.
void TestPowers()
{
  for (const double power : { 0.8, 1.2, 1.5, 2.0, 2.5 })
  {
    for (const std::size_t most : { 500, 20000, 1000000 })
    {
      const auto count = [power](double error) { return std::size_t(20.0 + 40000.0 * std::pow(error, -power)); };
      const Found found = Find(most, 1000.0, count);
      CHECK(found.Triangles <= most && double(found.Triangles) >= 0.9 * double(most));
      CHECK(found.Runs <= 5);
    }
  }
}

/// Errors of rounded heights change much from one error to the next, and noise is not even monotonous: the number is
/// kept all the same.
void TestSteps()
{
  const auto steps = [](double error) { return std::size_t(error < 0.5 ? 100000 : (error < 1.5 ? 9000 : 200)); };
  for (const std::size_t most : { 200, 5000, 9000, 99999, 100000, 1000000 })
  {
    const Found found = Find(most, 50.0, steps);
    CHECK(found.Triangles <= most && found.Runs <= MostSearchRuns);
  }
  const auto noise = [](double error) { return std::size_t(5000.0 / error * (1.5 + std::sin(1000.0 * error))); };
  for (std::size_t most = 1000; most < 100000; most += 7777)
  {
    const Found found = Find(most, 100.0, noise);
    CHECK(found.Triangles <= most && found.Runs <= MostSearchRuns);
  }
}

/// Errors on one side lead on to the other one: the search does not try the extremes, which take longest.
void TestOneSide()
{
  for (const double first : { 0.01, 300.0 })
  {
    double least = first;
    double largest = first;
    const auto steep = [&](double error)
    {
      least = std::min(least, error);
      largest = std::max(largest, error);
      return std::size_t(20.0 + 40000.0 * std::pow(error, error < 3.0 ? -0.8 : -2.5));
    };
    const double found = FindErrorForTriangles(20000, first, 1e5, steep);
    CHECK(steep(found) <= 20000);
    CHECK(least > 0.005 && largest < 1000.0);
  }
}

/// Where no error makes a difference the search ends at once: with the smallest one, or an error.
void TestPlane()
{
  const auto plane = [](double) { return std::size_t(2); };
  CHECK_EQUAL(Find(20000, 300.0, plane).Error, SmallestSearchedError);
  CHECK(Find(20000, 300.0, plane).Runs <= 3);
  CHECK(Find(2, 0.0, [](double) { return std::size_t(0); }).Runs <= 3);
  CHECK_THROWS_WITH(FindErrorForTriangles(1, 0.75, 300.0, plane),
    "maximum number of triangles 1, expected at least the 2 that the outlines");
  int runs = 0;
  const auto many = [&runs](double error) { return ++runs, std::size_t(error < 299.0 ? 1000 : 600); };
  CHECK_THROWS_WITH(FindErrorForTriangles(500, 0.75, 300.0, many), "expected at least the 600 that");
  CHECK(runs <= 3);
}
}

int TestErrorSearch(int, char*[])
{
  TestPowers();
  TestSteps();
  TestOneSide();
  TestPlane();
  return Check::Result();
}
