// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/VerticalSampling.h"
#include "Tools/Check.h"

#include <cmath>
#include <limits>

using namespace SeismicHorizons;

namespace
{
/// 30 x 20 columns on a slope.
LatticeHorizon Slope(double first, double alongI, double alongJ)
{
  LatticeHorizon horizon;
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 30; ++i)
    {
      horizon.Column.push_back({ i, j });
      horizon.RealZ.push_back(first + alongI * i + alongJ * j);
    }
  }
  return horizon;
}

double StepOf(const LatticeHorizon& horizon)
{
  return FindVerticalSamplings({ horizon }, 0.0)[0].Step;
}

void TestStep()
{
  CHECK_EQUAL(StepOf(Slope(0.0, 4.0, 0.0)), 5.0);
  CHECK_EQUAL(StepOf(Slope(0.0, 0.0, -3.0)), 2.0); // 3 is nearer to 2 than to 5, by the ratio
  CHECK_EQUAL(StepOf(Slope(0.0, 0.75, 0.75)), 1.0);
  CHECK_EQUAL(StepOf(Slope(0.0, 0.05, 0.05)), 0.05);
  CHECK_EQUAL(StepOf(Slope(1e6, 190.0, 190.0)), 200.0);
  CHECK_EQUAL(StepOf(Slope(7.0, 0.0, 0.0)), 1.0); // flat
}

void TestNeighboursOnly()
{
  LatticeHorizon horizon; // steps over gaps do not count
  horizon.Column = { { 0, 0 }, { 1, 0 }, { 5, 0 }, { 0, 1 }, { 5, 2 } };
  horizon.RealZ = { 0.0, 2.0, 99.0, 2.0, 1000.0 };
  CHECK_EQUAL(StepOf(horizon), 2.0);
}

void TestIndices()
{
  const VerticalSampling given = FindVerticalSamplings({ Slope(-7.0, 1.0, 0.0) }, 4.0)[0];
  CHECK_EQUAL(given.First, -8.0);
  CHECK_EQUAL(given.Step, 4.0);
  CHECK_EQUAL(given.Indices, 9); // -8 to 24, over 22
  const VerticalSampling flat = FindVerticalSamplings({ Slope(8.0, 0.0, 0.0) }, 4.0)[0];
  CHECK_EQUAL(flat.First, 8.0);
  CHECK_EQUAL(flat.Indices, 1);
}

/// What suits each does not depend on the others; what is given is one for all.
void TestSeveral()
{
  const std::vector<LatticeHorizon> horizons = { Slope(-7.0, 1.0, 0.0), {}, Slope(100.0, 0.0, 20.0) };
  const std::vector<VerticalSampling> own = FindVerticalSamplings(horizons, 0.0);
  CHECK_EQUAL(own.size(), std::size_t(3));
  for (std::size_t n = 0; n < 3; ++n)
  {
    const VerticalSampling alone = FindVerticalSamplings({ horizons[n] }, 0.0)[0];
    CHECK_EQUAL(own[n].Step, alone.Step);
    CHECK_EQUAL(own[n].First, alone.First);
    CHECK_EQUAL(own[n].Indices, alone.Indices);
  }
  CHECK_EQUAL(own[0].Step, 1.0);
  CHECK_EQUAL(own[2].Step, 20.0);
  for (const VerticalSampling& given : FindVerticalSamplings(horizons, 4.0))
  {
    CHECK_EQUAL(given.Step, 4.0);
    CHECK_EQUAL(given.First, -8.0);
    CHECK_EQUAL(given.Indices, 123); // -8 to 480
  }
}

void TestRefusals()
{
  const char* const expected = ", expected a positive number, or 0";
  CHECK_THROWS_WITH(FindVerticalSamplings({}, -1.0), std::string("VerticalStep -1") + expected);
  CHECK_THROWS_WITH(
    FindVerticalSamplings({}, std::numeric_limits<double>::infinity()), std::string("VerticalStep inf") + expected);
  CHECK_THROWS_WITH(FindVerticalSamplings({}, std::nan("")), expected);
  CHECK_THROWS_WITH(FindVerticalSamplings({ Slope(0.0, 1e6, 0.0) }, 1e-6),
    "VerticalStep 1e-06 for z from 0 to 2.9e+07, expected one that makes less than 2^31 vertical indices");
}
}

int TestVerticalSampling(int, char*[])
{
  TestStep();
  TestNeighboursOnly();
  TestIndices();
  TestSeveral();
  TestRefusals();
  return Check::Result();
}
