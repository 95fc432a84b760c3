// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From candidates to lines: trees, branches, bridges.

#include "FaultPictures.h"
#include "Filters/Algorithms/Faults/FaultForest.h"
#include "Tools/Check.h"

#include <algorithm>
#include <limits>

using namespace SeismicHorizons;

namespace
{
const LinkGrid Grid(PlaneBox({ { 0, 0 }, { 19, 19 } }));

FaultCandidate Make(int i, int j, LinkSide side, float size = 5.0F)
{
  return { Grid.LinkOf(i, j, side), size, true };
}

/// A line to the north between the columns i and i + 1.
std::vector<FaultCandidate> Upright(int i, int firstJ, int lastJ)
{
  std::vector<FaultCandidate> line;
  for (int j = firstJ; j <= lastJ; ++j)
  {
    line.push_back(Make(i, j, LinkSide::East));
  }
  return line;
}

std::size_t CountKept(const CornerGraph& graph)
{
  std::size_t kept = 0;
  for (std::int32_t edge = 0; edge < graph.NumberOfEdges(); ++edge)
  {
    kept += graph.IsKept(edge) ? 1 : 0;
  }
  return kept;
}

void PrunesShortBranches()
{
  // A line of 12 links with a branch of 3.
  std::vector<FaultCandidate> candidates = Upright(5, 0, 11);
  for (int i = 6; i < 9; ++i)
  {
    candidates.push_back(Make(i, 5, LinkSide::North, 9.0F));
  }
  CornerGraph pruned(Grid, candidates);
  KeepForest(pruned, { 8, 4, 3 });
  CHECK_EQUAL(CountKept(pruned), 12U);
  CHECK_EQUAL(ListLines(pruned).size(), 1U);
  CornerGraph whole(Grid, candidates);
  KeepForest(whole, { 8, 3, 3 });
  const std::vector<std::vector<ForestStep>> lines = ListLines(whole);
  CHECK_EQUAL(lines.size(), 2U);
  CHECK_EQUAL(lines[0].size(), 12U); // the longest way first
  CHECK_EQUAL(lines[1].size(), 3U);
}

void DropsSmallGroups()
{
  CornerGraph small(Grid, Upright(5, 0, 6));
  KeepForest(small, { 8, 0, 3 });
  CHECK_EQUAL(CountKept(small), 0U);
  CHECK_EQUAL(ListLines(small).size(), 0U);
  std::vector<FaultCandidate> weak = Upright(5, 0, 11);
  std::for_each(weak.begin() + 2, weak.end(), [](FaultCandidate& candidate) { candidate.IsStrong = false; });
  CornerGraph graph(Grid, weak);
  KeepForest(graph, { 8, 0, 3 });
  CHECK_EQUAL(CountKept(graph), 0U);
}

void OpensLoopsWhereStepsAreSmallest()
{
  // Around a single column: the smallest of four goes.
  CornerGraph ring(Grid,
    { Make(4, 5, LinkSide::East), Make(5, 5, LinkSide::East), Make(5, 4, LinkSide::North, 2.0F),
      Make(5, 5, LinkSide::North) });
  KeepForest(ring, { 0, 0, 0 });
  CHECK_EQUAL(CountKept(ring), 3U);
  CHECK(!ring.IsKept(2));
  CHECK_EQUAL(ListLines(ring).size(), 1U);
}

void BridgesEnds()
{
  std::vector<FaultCandidate> candidates = Upright(5, 0, 4);
  const std::vector<FaultCandidate> above = Upright(5, 7, 12);
  candidates.insert(candidates.end(), above.begin(), above.end());
  const auto none = [](std::int64_t) { return std::numeric_limits<float>::quiet_NaN(); };
  CHECK_EQUAL(BridgeEnds(Grid, candidates, none, 1.0F).size(), 11U); // two links are missing
  // Both step as the line does, or one of them the other way.
  const auto same = [](std::int64_t) { return 2.0F; };
  CHECK_EQUAL(BridgeEnds(Grid, candidates, same, 1.0F).size(), 13U);
  CHECK_EQUAL(BridgeEnds(Grid, candidates, same, 3.0F).size(), 11U);
  const auto turned = [](std::int64_t link) { return link == Grid.LinkOf(5, 6, LinkSide::East) ? -2.0F : 2.0F; };
  CHECK_EQUAL(BridgeEnds(Grid, candidates, turned, 1.0F).size(), 11U);
  // One link needs no step, and at the side of the lattice there is none beyond.
  candidates.push_back(Make(5, 5, LinkSide::East));
  CHECK_EQUAL(BridgeEnds(Grid, candidates, none, 1.0F).size(), 13U);
}
}

int TestFaultForest(int, char*[])
{
  PrunesShortBranches();
  DropsSmallGroups();
  OpensLoopsWhereStepsAreSmallest();
  BridgesEnds();
  return Check::Result();
}
