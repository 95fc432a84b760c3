// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What makes generated cubes hard leaves the truth exact.

#include "Check.h"
#include "Generator/CubeGenerator.h"

#include <algorithm>
#include <cmath>

using namespace SeismicHorizons;

namespace
{
/// Whatever the trouble, reflectors are where the truth has them, with its sign, and the cube is another one.
void TestTroubles()
{
  CubeGeneratorOptions options;
  options.Size = { 40, 32, 220 };
  options.Spacing = 36.0;
  options.SmallestStrength = 0.7;
  const std::vector<float> plain = CubeGenerator(options).MakeTraces();
  CHECK_EQUAL(TroubleNames().size(), 13u);
  for (const auto& [name, trouble] : TroubleNames())
  {
    options.Troubles = { trouble };
    const CubeGenerator cube(options);
    const std::vector<float> traces = cube.MakeTraces();
    CHECK(traces != plain);
    int places = 0;
    int agree = 0;
    for (int n = 0; n < cube.Truth().Size(); ++n)
    {
      for (int column = 0; column < options.Size[0] * options.Size[1]; ++column)
      {
        const int i = column % options.Size[0];
        const int j = column / options.Size[0];
        const double place = cube.Truth().Place(n, i, j);
        const double strength = cube.Truth().Strength(n, i, j);
        if (!std::isnan(place) && std::abs(strength) > 0.1 && !cube.Truth().IsDead(i, j))
        {
          ++places;
          agree += traces[std::size_t(column * options.Size[2] + std::lround(place))] * strength > 0.0 ? 1 : 0;
        }
      }
    }
    CHECK(places > 2000);
    CHECK(agree > 0.93 * places);
  }
}

/// Statics shift all that a trace meets alike. A growth fault throws nothing up, and below the first layer that it throws
/// each by no less than the one above. Foresets are between two surfaces, and each ends inside the cube. In all of them
/// reflectors keep their order.
void TestStructures()
{
  CubeGeneratorOptions options = WildCube(5);
  options.ShortFaults = 0;
  options.Channels = 0;
  options.FaultThrow = 0.0;
  const CubeReflectors plain(options);
  for (const Trouble trouble : { Trouble::Statics, Trouble::GrowthFault, Trouble::Clinoforms })
  {
    options.Troubles = { trouble };
    const CubeReflectors truth(options);
    std::vector<int> places(std::size_t(truth.Size()), 0);
    double most = 0.0;
    for (int column = 0; column < options.Size[0] * options.Size[1]; ++column)
    {
      const int i = column % options.Size[0];
      const int j = column / options.Size[0];
      double last = -1.0;
      double moved = trouble == Trouble::Statics ? std::nan("") : 0.0;
      for (int n = 0; n < truth.Size(); ++n)
      {
        const double place = truth.Place(n, i, j);
        if (std::isnan(place))
        {
          continue;
        }
        CHECK(place > last);
        last = place;
        ++places[std::size_t(n)];
        const double thrown = place - plain.Place(n, i, j);
        if (trouble == Trouble::Statics && !std::isnan(thrown))
        {
          moved = std::isnan(moved) ? thrown : moved;
          CHECK(std::abs(thrown - moved) < 1e-9);
          most = std::max(most, std::abs(moved));
        }
        else if (trouble == Trouble::GrowthFault && truth.FaultDistance(i, j, place) > 0.0)
        {
          CHECK(thrown >= 0.0 && (truth.FaultDistance(i, j, place) < 25.0 || thrown >= moved));
          moved = thrown;
          most = std::max(most, thrown);
        }
      }
    }
    const double period = 1000.0 / (options.Frequency * options.SampleInterval);
    CHECK(trouble == Trouble::Statics ? most > 0.3 * period && most < 1.5 * period
                                      : trouble == Trouble::Clinoforms || most > 1.5 * period);
    const auto columns = options.Size[0] * options.Size[1];
    const auto foresets = std::count_if(places.begin(), places.end(), [columns](int n) { return n < 0.7 * columns; });
    CHECK(trouble != Trouble::Clinoforms || (foresets > 6 && truth.Size() > plain.Size() + 4));
  }
}
}

int TestCubeTroubles(int, char*[])
{
  TestTroubles();
  TestStructures();
  return Check::Result();
}
