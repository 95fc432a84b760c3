// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which plate a horizon gets, by how rough it is.

#include "HoleFixtures.h"

#include "Tools/Check.h"

using namespace HoleFixtures;

namespace
{
constexpr double Exact = 0.0;
constexpr double Little = 1.0;
constexpr double Much = 32.0;

/// A hole of 9 in the middle of a square.
Patches::Columns WithHole(int size)
{
  const int middle = size / 2;
  return Square(size, [middle](int x, int y) { return std::abs(x - middle) < 2 && std::abs(y - middle) < 2; });
}

double SmoothingOf(const Horizon& horizon, const LinkCuts* cuts = nullptr)
{
  const FilledColumns filled = Fill(horizon, HoleFillingOptions(), cuts);
  CHECK_EQUAL(filled.RimWidth, filled.RimSmoothing == Much ? 5 : 3);
  return filled.RimSmoothing;
}

double Gentle(double x, double y)
{
  return 6.0 * std::sin(0.05 * x + 0.02 * y) + 4.0 * std::cos(0.04 * y);
}

double Cubic(double x, double y)
{
  return 500.0 + 1e-3 * x * x * y - 2e-3 * y * y * y + 0.3 * x - 0.01 * x * y;
}

/// A surface without noise comes out as it is, and one that is a plane.
void TestSmooth()
{
  for (const Surface& surface : { Surface(Cubic), Surface([](double x, double y) { return 2.0 * x - 3.0 * y; }) })
  {
    const Horizon horizon = OnSurface(WithHole(60), surface);
    CHECK_EQUAL(SmoothingOf(horizon), Exact);
    CHECK(LargestError(Fill(horizon, HoleFillingOptions()), surface) < 1e-8);
  }
}

/// White noise; noise that is so across lines alone, whose squares double; and a part of a large horizon.
void TestNoise()
{
  for (const int size : { 100, 1100 })
  {
    Patches::Random random(7);
    std::vector<double> before(std::size_t(size), 0.0);
    const Surface white = [&](double x, double y) { return Gentle(x, y) + random.Fraction(); };
    const Surface along = [&](double x, double y)
    {
      const double noise = random.Fraction();
      const double rest = before[std::size_t(y)];
      before[std::size_t(y)] = noise;
      return Gentle(x, y) + noise + rest;
    };
    CHECK_EQUAL(SmoothingOf(OnSurface(WithHole(size), white)), Much);
    CHECK_EQUAL(SmoothingOf(OnSurface(WithHole(size), along)), Little);
  }
}

/// Whole heights whose twists are those of rounding are smoothed, others as they are.
void TestWhole()
{
  CHECK_EQUAL(SmoothingOf(OnSurface(WithHole(100), [](double x, double y) { return std::round(Gentle(x, y)); })), Much);
  CHECK_EQUAL(
    SmoothingOf(OnSurface(WithHole(100), [](double x, double y) { return std::round(0.01 * x * x * y); })), Exact);
}

/// Points in every other column make no squares.
void TestNoSquares()
{
  const Patches::Columns columns =
    Square(31, [](int x, int y) { return x % 2 == 1 && y % 2 == 1; }); // single holes between lines
  CHECK_EQUAL(SmoothingOf(OnSurface(columns, Cubic)), Little);
}

/// Columns that cuts part from all around do not count.
void TestCuts()
{
  const int size = 60;
  const Surface pillars = [](double x, double y)
  { return Cubic(x, y) + (int(x) % 7 == 3 && int(y) % 7 == 3 ? 1000.0 : 0.0); };
  const Horizon horizon = OnSurface(WithHole(size), pillars);
  LinkCuts cuts(PlaneBox({ { 0, 0 }, { size - 1, size - 1 } }));
  for (std::int32_t y = 3; y < size; y += 7)
  {
    for (std::int32_t x = 3; x < size; x += 7)
    {
      cuts.CutEast({ x, y });
      cuts.CutEast({ x - 1, y });
      cuts.CutNorth({ x, y });
      cuts.CutNorth({ x, y - 1 });
    }
  }
  CHECK_EQUAL(SmoothingOf(horizon), Much);
  CHECK_EQUAL(SmoothingOf(horizon, &cuts), Exact);
}

/// What is given is kept.
void TestGiven()
{
  HoleFillingOptions options = AllHoles(FillMethod::Plate, 0.25);
  options.RimWidth = 4;
  const Horizon horizon = OnSurface(WithHole(40), Cubic);
  const FilledColumns filled = Fill(horizon, options);
  CHECK_EQUAL(filled.RimSmoothing, 0.25);
  CHECK_EQUAL(filled.RimWidth, 4);
  const FilledColumns chosen = Fill(horizon, HoleFillingOptions());
  CHECK(chosen.Height == Fill(horizon, AllHoles(FillMethod::Plate, Exact)).Height);
}
}

int TestPlateChoice(int, char*[])
{
  TestSmooth();
  TestNoise();
  TestWhole();
  TestNoSquares();
  TestCuts();
  TestGiven();
  return Check::Result();
}
