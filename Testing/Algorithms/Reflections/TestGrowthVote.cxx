// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where two surfaces of a guide disagree, counted by hand; growth; and seams beside faults.

#include "Filters/Algorithms/Reflections/GrowthVote.h"
#include "Filters/Algorithms/Reflections/GuideLikeness.h"
#include "Filters/Algorithms/Reflections/PlainGrowth.h"
#include "PickFixtures.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace PickFixtures;

namespace
{
constexpr PickDepth Quarter = 2 * DepthsPerSample;

/// A line of columns, each with a pick at sample 10 and one at 20. Signs of a column: = both at 10, x parts at 20 and
/// growth at 10, a parts alone at 10, A alone at 20, b growth alone at 10, B alone at 20, and space for neither.
struct Line
{
  explicit Line(const std::string& signs)
    : Picks(MakePicks({ int(signs.size()), 1 }, std::vector<std::vector<double>>(signs.size(), { 10.0, 20.0 })))
  {
    for (std::size_t n = 0; n < signs.size(); ++n)
    {
      const PointId upper = this->Picks.Begin(std::int64_t(n));
      const char sign = signs[n];
      Candidates candidates;
      candidates[0].Pick = sign == 'x' || sign == 'A' ? upper + 1 : (sign == '=' || sign == 'a' ? upper : NoPoint);
      candidates[1].Pick = sign == 'B' ? upper + 1 : (sign == '=' || sign == 'x' || sign == 'b' ? upper : NoPoint);
      this->Columns.push_back(candidates);
    }
  }

  /// P, G or - for each column.
  std::string Vote() const
  {
    std::string text;
    for (const VoteSide side : VoteByRegions(this->Picks, this->Columns, Quarter))
    {
      text += side == VoteSide::Parts ? 'P' : (side == VoteSide::Growth ? 'G' : '-');
    }
    return text;
  }

  void SetParts(float likeness, float contrast, bool isPart)
  {
    for (Candidates& candidates : this->Columns)
    {
      candidates[0].Likeness = likeness;
      candidates[0].Contrast = contrast;
      candidates[0].IsPart = isPart;
    }
  }

  ReflectionPicks Picks;
  std::vector<Candidates> Columns;
};

/// A conflict goes to what continues, unless the waveforms or strengths are clearly of the other.
void TestConflicts()
{
  Line line("==xx==");
  CHECK_EQUAL(line.Vote(), "PPGGPP"); // Parts jump at both ends, growth continues.
  line.SetParts(0.5F, 0.0F, false);
  CHECK_EQUAL(line.Vote(), "PPPPPP"); // A seam of 2 pairs per 2 columns weighs less than 2.5 x 0.5.
  line.SetParts(0.5F, 3.0F, false);
  CHECK_EQUAL(line.Vote(), "PPGGPP");
  line.SetParts(0.0F, 0.0F, true);
  CHECK_EQUAL(line.Vote(), "PPPPPP"); // A part stays if little is known.
  line.SetParts(-0.5F, 0.0F, true);
  CHECK_EQUAL(line.Vote(), "PPGGPP"); // It loses beside waveforms like those of the picks.
}

/// What only one has is kept where it continues what is kept, in some sweeps; a conflict never empties a column.
void TestSingles()
{
  CHECK_EQUAL(Line("==aabb").Vote(), "PPPPGG");
  CHECK_EQUAL(Line("==A=BB").Vote(), "PP-P--");
  CHECK_EQUAL(Line("== bb=").Vote(), "PP-GGP");
  CHECK_EQUAL(Line("aa bb ").Vote(), "------"); // Nothing is agreed, so nothing is near a pick.
  CHECK_EQUAL(Line("").Vote(), "");
}

/// Growth takes whole layers, and names where its reach ends.
void TestGrowth()
{
  Traces traces = Empty({ 30, 1, 40 });
  for (int i = 0; i < 30; ++i)
  {
    std::fill_n(traces.Trace(i, 0) + 14, 3, 1.0F);
    traces.Trace(i, 0)[15] = i == 20 ? 9.0F : 2.0F;
  }
  const ReflectionPicks picks = MakePicks({ 30, 1 }, std::vector<std::vector<double>>(30, { 15.0 }));
  const GrowthLinks links(traces.View(), picks, { ColumnConnectivity::Eight, Quarter, 8 });
  std::vector<PointId> starts(30, NoPoint);
  starts[3] = 3;
  const auto count = [&](const GrowthRules& rules)
  {
    const GrownPicks grown = GrowPlainly(picks, picks.ListColumns(), links, starts, rules);
    CHECK_EQUAL(grown.Stops.size(), rules.Reach == 5 ? 1u : 0u);
    return std::count_if(grown.Picks.begin(), grown.Picks.end(), [](PointId pick) { return pick != NoPoint; });
  };
  CHECK_EQUAL(count({ 0.6, 100 }), 29);
  CHECK_EQUAL(count({ 0.6, 5 }), 8);
  CHECK_EQUAL(count({ 0.999, 100 }), 19);
}

/// A throw of all layers is no seam; a step from one layer to the next one is.
void TestSeams()
{
  constexpr int width = 20;
  const std::vector<int> layers = { 12, 22, 39, 46, 63, 70 };
  for (const int faultThrow : { 0, 9 })
  {
    Traces traces = Empty({ width, 3, 90 });
    std::vector<std::vector<double>> places;
    for (int column = 0; column < 3 * width; ++column)
    {
      const int down = column % width < width / 2 ? 0 : faultThrow;
      places.emplace_back();
      for (const int layer : layers)
      {
        traces.Trace(column % width, column / width)[layer + down] = float(layer % 5 + 1);
        places.back().push_back(layer + down);
      }
    }
    const ReflectionPicks picks = MakePicks({ width, 3 }, places);
    std::vector<PointId> surface;
    for (int column = 0; column < 3 * width; ++column)
    {
      const bool isNext = faultThrow == 0 && column % width >= width / 2;
      surface.push_back(picks.Begin(column) + (isNext ? 3 : 2));
    }
    CHECK_EQUAL(CountSeams(traces.View(), picks, surface, Quarter), faultThrow == 0 ? 3 : 0);
  }
}
}

int TestGrowthVote(int, char*[])
{
  TestConflicts();
  TestSingles();
  TestGrowth();
  TestSeams();
  return Check::Result();
}
