// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Areas by the layers that meet on a fault, against those counted by hand: level horizons on a plane, and random cutoffs
// against sums over a fine grid.

#include "Filters/Algorithms/Cutoffs/Juxtaposition.h"

#include "CutoffModels.h"
#include "Tools/Check.h"

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>

using namespace SeismicHorizons;

namespace
{
using LayerPair = std::pair<std::array<std::ptrdiff_t, 2>, std::array<std::ptrdiff_t, 2>>;

LayerPair PairOf(const MetArea& area)
{
  return { { area.Layer[0].Top, area.Layer[0].Base }, { area.Layer[1].Top, area.Layer[1].Base } };
}

void TestLevel()
{
  std::mt19937 random(1);
  const CutoffModel model = MakeCutoffModel(FaultForm::Flat, {}, random);
  const FaultPlate fault(model.Fault);
  std::vector<HorizonCutoffs> cutoffs;
  for (const HorizonPicks& horizon : model.Horizons)
  {
    cutoffs.push_back(FindCutoffs(fault, { &fault }, horizon, CutoffFitOptions(), 5.0));
  }
  std::map<LayerPair, double> areas;
  for (const MetArea& area : FindJuxtaposition(fault, { &cutoffs[0], &cutoffs[1], &cutoffs[2] }))
  {
    areas[PairOf(area)] += area.Area;
  }
  const std::vector<CutoffPair>& pairs = cutoffs[0].Pieces[0].Pairs;
  const double length = pairs.back().S - pairs.front().S, slope = 2.0 / std::sqrt(3.0);
  // Depths of 1000, 1200 and 1450 on the footwall, 90 more on the hanging wall.
  const std::map<LayerPair, double> expected = { { { { 0, 1 }, { -1, 0 } }, 90.0 }, { { { 0, 1 }, { 0, 1 } }, 110.0 },
    { { { 1, 2 }, { 0, 1 } }, 90.0 }, { { { 1, 2 }, { 1, 2 } }, 160.0 }, { { { 2, -1 }, { 1, 2 } }, 90.0 } };
  CHECK_EQUAL(areas.size(), expected.size());
  for (const auto& [layers, height] : expected)
  {
    CHECK(std::abs(areas[layers] / (height * length * slope) - 1.0) < 1e-9);
  }
}

double HeightOf(const HorizonCutoffs& cutoffs, std::size_t wall, double s)
{
  for (const CutoffPiece& piece : cutoffs.Pieces)
  {
    for (std::size_t n = 1; n < piece.Pairs.size(); ++n)
    {
      const CutoffPair &a = piece.Pairs[n - 1], &b = piece.Pairs[n];
      if (s >= a.S && s <= b.S)
      {
        return a.Wall[wall].Height + (s - a.S) / (b.S - a.S) * (b.Wall[wall].Height - a.Wall[wall].Height);
      }
    }
  }
  return NoValue;
}

/// Pieces begin and end anywhere, and lines of both walls cross.
std::vector<HorizonCutoffs> MakeRandomCutoffs(std::mt19937& random)
{
  std::uniform_real_distribution<double> height(-30.0, 30.0), begin(0.0, 40.0), end(60.0, 100.0);
  std::vector<HorizonCutoffs> horizons(3);
  for (std::size_t horizon = 0; horizon < horizons.size(); ++horizon)
  {
    CutoffPiece piece;
    const double first = begin(random), last = end(random);
    for (int n = 0; n <= 5; ++n)
    {
      CutoffPair pair;
      pair.S = first + (last - first) * n / 5.0;
      for (CutoffPlace& place : pair.Wall)
      {
        place.Height = -100.0 * double(horizon) + height(random);
      }
      piece.Pairs.push_back(pair);
    }
    horizons[horizon].Pieces.push_back(piece);
  }
  return horizons;
}

/// The areas by pairs of layers, from places on a fine grid.
std::map<LayerPair, double> Count(const std::vector<HorizonCutoffs>& horizons)
{
  std::map<LayerPair, double> counted;
  constexpr double step = 0.2;
  for (double s = 0.5 * step; s < 100.0; s += step)
  {
    for (double z = -300.0 + 0.5 * step; z < 100.0; z += step)
    {
      std::array<std::array<std::ptrdiff_t, 2>, 2> layers = { { { -1, -1 }, { -1, -1 } } };
      bool isAbove = false, isBelow = false;
      for (const std::size_t wall : { 0, 1 })
      {
        for (std::size_t horizon = 0; horizon < 3; ++horizon)
        {
          const double own = HeightOf(horizons[horizon], wall, s);
          if (std::isnan(own))
          {
            continue;
          }
          isAbove = isAbove || own > z;
          isBelow = isBelow || own <= z;
          if (own > z)
          {
            layers[wall][0] = std::ptrdiff_t(horizon);
          }
          else if (layers[wall][1] < 0)
          {
            layers[wall][1] = std::ptrdiff_t(horizon);
          }
        }
      }
      if (isAbove && isBelow)
      {
        counted[{ layers[0], layers[1] }] += step * step;
      }
    }
  }
  return counted;
}

void TestRandom()
{
  std::mt19937 random(11);
  FaultPicks upright;
  upright.Name = "F";
  upright.Spacing = 50.0;
  for (const double y : { 0.0, 50.0, 100.0 })
  {
    upright.Segments.push_back({ Eigen::Vector3d(0.0, y, -300.0), Eigen::Vector3d(0.0, y, 100.0) });
  }
  const FaultPlate fault(upright);
  for (int run = 0; run < 20; ++run)
  {
    const std::vector<HorizonCutoffs> horizons = MakeRandomCutoffs(random);
    std::map<LayerPair, double> areas, counted = Count(horizons);
    for (const MetArea& area : FindJuxtaposition(fault, { &horizons[0], &horizons[1], &horizons[2] }))
    {
      areas[PairOf(area)] += area.Area;
    }
    // A line of places may be counted on either side of where a horizon begins.
    for (const auto& [layers, area] : areas)
    {
      CHECK(std::abs(area - counted[layers]) < 50.0);
    }
    for (const auto& [layers, area] : counted)
    {
      CHECK(std::abs(area - areas[layers]) < 50.0);
    }
  }
}
}

int TestJuxtaposition(int, char*[])
{
  TestLevel();
  TestRandom();
  return Check::Result();
}
