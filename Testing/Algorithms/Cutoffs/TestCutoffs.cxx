// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cutoffs of generated horizons at faults, against their true surfaces and faults: of any dip, with noise, with picks of
// the wrong side, beside another fault, and where the fault dies out. Prints the figures of HorizonCutoffs.md.

#include "Filters/Algorithms/Cutoffs/Cutoffs.h"

#include "CutoffModels.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using namespace SeismicHorizons;

namespace
{
CutoffErrors Try(const char* name, FaultForm form, const PickErrors& errors)
{
  std::mt19937 random(7);
  const CutoffModel model = MakeCutoffModel(form, errors, random);
  const std::vector<FaultPlate> faults = { FaultPlate(model.Fault) };
  CutoffErrors worst;
  for (std::size_t horizon = 0; horizon < model.Horizons.size(); ++horizon)
  {
    const HorizonCutoffs cutoffs =
      FindCutoffs(faults[0], { &faults[0] }, model.Horizons[horizon], CutoffFitOptions(), 5.0);
    const CutoffErrors found = MeasureCutoffs(model, horizon, faults[0], cutoffs);
    const CutoffErrors plain = MeasurePlain(model, horizon, faults[0], cutoffs);
    std::printf("%s, horizon %zu: plain %.3f, rms %.3f, largest %.3f\n", name, horizon + 1, plain.Mean, found.Mean,
      found.Largest);
    CHECK(found.Mean < plain.Mean + 2.0);
    CHECK_EQUAL(cutoffs.Pieces.size(), std::size_t(1));
    CHECK(found.Places > 155);
    worst.Mean = std::max(worst.Mean, found.Mean);
    worst.OffFault = std::max(worst.OffFault, found.OffFault);
  }
  return worst;
}

void TestWithoutNoise()
{
  CHECK(Try("level", FaultForm::Flat, {}).Mean < 1e-9);
  for (const FaultForm form : { FaultForm::Straight, FaultForm::Oblique, FaultForm::Steep, FaultForm::Upright })
  {
    const CutoffErrors found = Try("folded", form, {});
    CHECK(found.Mean < 0.1);
    CHECK(found.OffFault < 1e-9);
  }
  CHECK(Try("reverse", FaultForm::Reverse, {}).Mean < 0.1);
  // The crest of the rollover is a kink, within a column of the second horizon's cutoff.
  const CutoffErrors listric = Try("listric", FaultForm::Listric, {});
  CHECK(listric.Mean < 5.5);
  CHECK(listric.OffFault < 1.5);
}

void TestWrongSide()
{
  const double noise = 2.0;
  CHECK(Try("noise", FaultForm::Straight, { noise, 0.0, 0.0 }).Mean < noise);
  for (const double columns : { 1.0, 2.0, 3.0, 4.0, 5.0 })
  {
    for (const double part : { 0.5, 1.0 })
    {
      for (const FaultForm form : { FaultForm::Straight, FaultForm::Steep, FaultForm::Oblique })
      {
        CHECK(Try("wrong side", form, { noise, columns, part }).Mean < 2.0 * noise);
      }
    }
  }
}

/// All picks of the wrong side count without agreement: that is what it is for.
void TestWithoutAgreement()
{
  std::mt19937 random(3);
  const CutoffModel model = MakeCutoffModel(FaultForm::Straight, { 2.0, 3.0, 1.0 }, random);
  const std::vector<FaultPlate> faults = { FaultPlate(model.Fault) };
  CutoffFitOptions options;
  options.DropNoise = 0.0;
  const HorizonCutoffs cutoffs = FindCutoffs(faults[0], { &faults[0] }, model.Horizons[0], options, 5.0);
  CHECK(MeasureCutoffs(model, 0, faults[0], cutoffs).Mean > 20.0);
  CHECK(cutoffs.Dropped[Footwall].empty() && cutoffs.Dropped[HangingWall].empty());
}

FaultPicks PlanePicks(const char* name, double x, double from, double to)
{
  FaultPicks picks;
  picks.Name = name;
  for (double y = from; y <= to; y += 100.0)
  {
    picks.Segments.push_back({ Eigen::Vector3d(x - 50.0, y, -900.0), Eigen::Vector3d(x + 50.0, y, -1100.0) });
  }
  picks.Spacing = 100.0;
  return picks;
}

/// Throw falls to 0 at both ends of the fault, 550 m from its middle, inside the horizon.
void TestTips(const FaultPicks& picks)
{
  HorizonPicks horizon;
  horizon.Steps *= 25.0;
  const auto throwAt = [](double y) { return 40.0 * std::max(0.0, 1.0 - std::pow((y - 1000.0) / 550.0, 2)); };
  for (int j = 0; j < 81; ++j)
  {
    for (int i = 0; i < 81; ++i)
    {
      const double x = 25.0 * i, y = 25.0 * j;
      horizon.Places.emplace_back(x, y, -1000.0 - (x > 1000.0 ? throwAt(y) : 0.0));
    }
  }
  const FaultPlate fault(picks);
  const HorizonCutoffs cutoffs = FindCutoffs(fault, { &fault }, horizon, CutoffFitOptions(), 5.0);
  CHECK_EQUAL(cutoffs.Pieces.size(), std::size_t(1));
  const CutoffPiece& piece = cutoffs.Pieces.front();
  CHECK(piece.IsTip[0] && piece.IsTip[1]);
  for (const CutoffPair& pair : piece.Pairs)
  {
    const Eigen::Vector3d place = fault.At(pair.S, pair.Wall[HangingWall].Height);
    CHECK(std::abs(pair.Throw() - throwAt(place.y())) < 1.0);
  }
  for (const CutoffPair& end : { piece.Pairs.front(), piece.Pairs.back() })
  {
    CHECK_EQUAL(end.Throw(), 0.0);
    CHECK(std::abs(std::abs(fault.At(end.S, end.Wall[0].Height).y() - 1000.0) - 550.0) < 1.0);
  }
}

/// Sticks give the tips, or a closed line where sticks are beyond them.
void TestTips()
{
  TestTips(PlanePicks("F", 1000.0, 500.0, 1500.0));
  FaultPicks bounded = PlanePicks("F", 1000.0, 0.0, 2000.0);
  std::vector<Eigen::Vector3d> loop = { { 950.0, 450.0, -900.0 }, { 950.0, 1550.0, -900.0 },
    { 1050.0, 1550.0, -1100.0 }, { 1050.0, 450.0, -1100.0 } };
  for (std::size_t n = 0; n < loop.size(); ++n)
  {
    bounded.TipLoop.push_back({ loop[n], loop[(n + 1) % loop.size()] });
  }
  TestTips(bounded);
}

/// Picks beyond a second fault, eight columns away, belong to another block.
void TestParallelFaults()
{
  HorizonPicks horizon;
  horizon.Steps *= 25.0;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  horizon.Noise = 1.0;
  for (int j = 0; j < 81; ++j)
  {
    for (int i = 0; i < 81; ++i)
    {
      const double x = 25.0 * i, y = 25.0 * j;
      horizon.Places.emplace_back(x, y, -1000.0 + noise(random) - (x > 1200.0 ? 60.0 : x > 1000.0 ? 30.0 : 0.0));
    }
  }
  const std::vector<FaultPlate> faults = { FaultPlate(PlanePicks("A", 1000.0, 0.0, 2000.0)),
    FaultPlate(PlanePicks("B", 1200.0, 0.0, 2000.0)) };
  for (const std::size_t fault : { 0, 1 })
  {
    const HorizonCutoffs cutoffs =
      FindCutoffs(faults[fault], { &faults[0], &faults[1] }, horizon, CutoffFitOptions(), 5.0);
    double squares = 0.0, places = 0.0;
    for (const CutoffPiece& piece : cutoffs.Pieces)
    {
      for (const CutoffPair& pair : piece.Pairs)
      {
        squares += std::pow(pair.Throw() - 30.0, 2);
        places += 1.0;
      }
    }
    CHECK(places > 75.0 && std::sqrt(squares / places) < 2.0);
  }
}

/// A plane that dips across the fault, without picks on the hanging wall up to a distance: it is continued as it is.
void TestGaps()
{
  for (const double dip : { 0.0, 0.1, 0.3 })
  {
    for (const double gap : { 3.0, 10.0, 20.0, 35.0 })
    {
      HorizonPicks horizon;
      horizon.Steps *= 25.0;
      const auto heightAt = [dip](double x) { return -1000.0 - dip * (x - 1000.0); };
      for (int j = 0; j < 81; ++j)
      {
        for (int i = 0; i < 101; ++i)
        {
          const double x = 25.0 * i;
          if (x <= 1000.0 || x > 1000.0 + 25.0 * gap)
          {
            horizon.Places.emplace_back(x, 25.0 * j, heightAt(x));
          }
        }
      }
      const FaultPlate fault(PlanePicks("F", 1000.0, 0.0, 2000.0));
      CutoffFitOptions options;
      options.LargestGap = 40.0;
      const HorizonCutoffs cutoffs = FindCutoffs(fault, { &fault }, horizon, options, 5.0);
      CHECK_EQUAL(cutoffs.Pieces.size(), std::size_t(1));
      for (const CutoffPiece& piece : cutoffs.Pieces)
      {
        CHECK(piece.Pairs.size() > 75);
        for (const CutoffPair& pair : piece.Pairs)
        {
          CHECK(std::abs(pair.Throw() - dip * pair.Heave()) < 0.01);
        }
      }
    }
  }
}

/// A small fault beside a tall one of few levels divides its side, too.
void TestSmallBesideTall()
{
  HorizonPicks horizon;
  horizon.Steps *= 25.0;
  for (int j = 0; j < 81; ++j)
  {
    for (int i = 0; i < 81; ++i)
    {
      const double x = 25.0 * i;
      horizon.Places.emplace_back(x, 25.0 * j, -1000.0 - (x > 1200.0 ? 60.0 : x > 1000.0 ? 40.0 : 0.0));
    }
  }
  FaultPicks tall;
  tall.Name = "Tall";
  tall.Spacing = 1000.0;
  for (const double y : { 0.0, 1000.0, 2000.0 })
  {
    tall.Segments.push_back({ Eigen::Vector3d(1010.0, y, 1100.0), Eigen::Vector3d(990.0, y, -3100.0) });
  }
  const std::vector<FaultPlate> faults = { FaultPlate(tall), FaultPlate(PlanePicks("Small", 1200.0, 0.0, 2000.0)) };
  const HorizonCutoffs cutoffs = FindCutoffs(faults[0], { &faults[0], &faults[1] }, horizon, CutoffFitOptions(), 5.0);
  CHECK_EQUAL(cutoffs.Pieces.size(), std::size_t(1));
  for (const CutoffPair& pair : cutoffs.Pieces.front().Pairs)
  {
    CHECK(std::abs(std::abs(pair.Throw()) - 40.0) < 1.0);
  }
}

void TestDropDistance()
{
  std::mt19937 random(3);
  const CutoffModel model = MakeCutoffModel(FaultForm::Straight, {}, random);
  const FaultPlate fault(model.Fault);
  CutoffFitOptions options;
  options.DropDistance = 8.0;
  for (const CutoffPiece& piece : FindCutoffs(fault, { &fault }, model.Horizons[0], options, 5.0).Pieces)
  {
    for (const CutoffPair& pair : piece.Pairs)
    {
      CHECK(!(pair.Wall[Footwall].Gap < 8.0) && !(pair.Wall[HangingWall].Gap < 8.0));
    }
  }
}

void TestSimplified()
{
  std::mt19937 random(9);
  const CutoffModel model = MakeCutoffModel(FaultForm::Listric, {}, random);
  const FaultPlate fault(model.Fault);
  const HorizonCutoffs cutoffs = FindCutoffs(fault, { &fault }, model.Horizons[0], CutoffFitOptions(), 5.0);
  const CutoffPiece& piece = cutoffs.Pieces.front();
  for (const FaultWall wall : { Footwall, HangingWall })
  {
    const std::vector<std::size_t> kept = SimplifyCutoff(piece, wall, 1.0, 5.0);
    CHECK_EQUAL(kept.front(), std::size_t(0));
    CHECK_EQUAL(kept.back(), piece.Pairs.size() - 1);
    CHECK(kept.size() < piece.Pairs.size() / 3);
    for (std::size_t part = 1; part < kept.size(); ++part)
    {
      const CutoffPair &a = piece.Pairs[kept[part - 1]], &b = piece.Pairs[kept[part]];
      for (std::size_t n = kept[part - 1]; n <= kept[part]; ++n)
      {
        const double t = (piece.Pairs[n].S - a.S) / (b.S - a.S);
        const double line = a.Wall[wall].Height + t * (b.Wall[wall].Height - a.Wall[wall].Height);
        CHECK(std::abs(line - piece.Pairs[n].Wall[wall].Height) <= 1.0 + 1e-9);
        const double offset = a.Wall[wall].Offset + t * (b.Wall[wall].Offset - a.Wall[wall].Offset);
        CHECK(std::abs(offset - piece.Pairs[n].Wall[wall].Offset) <= 5.0 + 1e-9);
      }
    }
  }
}

void TestRefused()
{
  for (const double height : { -900.0, -1234.567, 0.1 })
  {
    FaultPicks level = PlanePicks("L", 612345.6, 0.0, 500.0);
    for (auto& [from, to] : level.Segments)
    {
      from.z() = to.z() = height;
    }
    CHECK_THROWS_WITH(FaultPlate(level), "fault L with picks at one height");
  }
  FaultPicks beyond = PlanePicks("B", 0.0, 0.0, 500.0);
  beyond.TipLoop = { { Eigen::Vector3d(0.0, 0.0, 500.0), Eigen::Vector3d(0.0, 400.0, 500.0) },
    { Eigen::Vector3d(0.0, 400.0, 500.0), Eigen::Vector3d(0.0, 0.0, 500.0) } };
  CHECK_THROWS_WITH(FaultPlate(beyond), "fault B with a closed line beyond the heights of its sticks");
  FaultPicks single = PlanePicks("S", 0.0, 0.0, 0.0);
  CHECK_THROWS_WITH(FaultPlate(single), "fault S with picks on one line");
}
}

int TestCutoffs(int, char*[])
{
  TestWithoutNoise();
  TestWrongSide();
  TestWithoutAgreement();
  TestTips();
  TestParallelFaults();
  TestGaps();
  TestSmallBesideTall();
  TestDropDistance();
  TestSimplified();
  TestRefused();
  return Check::Result();
}
