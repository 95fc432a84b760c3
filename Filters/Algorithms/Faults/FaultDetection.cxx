// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultDetection.h"

#include "Common/Errors.h"
#include "Common/FixedChunks.h"
#include "Common/Parameters.h"
#include "FaultForest.h"
#include "GapSteps.h"
#include "LinkDeviations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// By noise alone one link in a hundred is a candidate, and hardly any a strong one.
constexpr double LowFactor = 2.5; // standard deviations
constexpr double HighFactor = 4.0;
// How far the planes beside a gap have to be apart: they are extended, and so vary more than a difference does.
constexpr double GapFactor = 3.0;
constexpr int FewestStrong = 5;
// Rounding to whole heights makes steps of 1, but none of 2.
constexpr double LeastWholeStep = 1.5;

/// The links with large deviations.
std::vector<FaultCandidate> FindSteep(
  const RawVector<float>& deviations, double low, double high, const Monitor& monitor)
{
  constexpr std::int64_t ChunkSize = 1 << 18; // links
  std::vector<std::vector<FaultCandidate>> parts(CountChunks(std::int64_t(deviations.size()), ChunkSize));
  ForEachChunk(std::int64_t(deviations.size()), ChunkSize, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t link = first; link < last; ++link)
      {
        const float size = std::abs(deviations[std::size_t(link)]);
        if (double(size) >= low) // not nan
        {
          parts[chunk].push_back({ link, size, double(size) >= high });
        }
      }
    });
  std::vector<FaultCandidate> candidates;
  for (const std::vector<FaultCandidate>& part : parts)
  {
    candidates.insert(candidates.end(), part.begin(), part.end());
  }
  return candidates;
}

bool ByLink(const FaultCandidate& a, const FaultCandidate& b)
{
  return a.Link < b.Link;
}

/// Candidates by their link, of which there are several in a row that a gap may touch.
std::vector<std::int64_t> FindNear(
  const std::vector<FaultCandidate>& candidates, std::int64_t first, std::int64_t last, std::int64_t step)
{
  std::vector<std::int64_t> near;
  for (std::int64_t link = first; link <= last; link += step)
  {
    if (std::binary_search(candidates.begin(), candidates.end(), FaultCandidate{ link }, ByLink))
    {
      near.push_back(link);
    }
  }
  return near;
}

/// Adds the links that join the cut of a gap to those of candidates in the next row, or file, that lie beside the gap:
///
///     o   o   o   .   o      The fault is cut above at a, in the gap below at g. The links from the row below to that
///       a-----+              above, at the two columns between, join both.
///     o   .   . g .   o
void JoinBesideGap(const LinkGrid& grid, const GapStep& gap, const std::vector<FaultCandidate>& candidates,
  std::vector<FaultCandidate>& joints)
{
  const LinkSide side = LinkGrid::SideOf(gap.Middle);
  const bool isEast = side == LinkSide::East;
  const std::int64_t along = isEast ? 1 : grid.Width(); // from a column of the gap to the next
  const std::int64_t across = isEast ? grid.Width() : 1;
  const std::int64_t first = LinkGrid::FirstColumn(gap.Middle);
  const std::int64_t strip = isEast ? first / grid.Width() : first % grid.Width();
  const LinkSide other = isEast ? LinkSide::North : LinkSide::East;
  for (const std::int64_t next : { strip - 1, strip + 1 })
  {
    if (next < 0 || next >= (isEast ? grid.Height() : grid.Width()))
    {
      continue;
    }
    const std::int64_t shift = 2 * (next - strip) * across;
    for (const std::int64_t link : FindNear(candidates, gap.First + shift, gap.Last + shift, 2 * along))
    {
      const std::int64_t target = LinkGrid::FirstColumn(link - shift);
      for (std::int64_t column = std::min(first, target) + along; column <= std::max(first, target); column += along)
      {
        joints.push_back({ grid.LinkOf(next < strip ? column - across : column, other), 0.0F, false });
      }
    }
  }
}

/// Candidates with those of gaps, by link.
std::vector<FaultCandidate> AddGaps(
  const LinkGrid& grid, std::vector<FaultCandidate> candidates, const std::vector<GapStep>& gaps, double high)
{
  for (const GapStep& gap : gaps)
  {
    candidates.push_back({ gap.Middle, float(std::abs(gap.Throw)), std::abs(gap.Throw) >= high });
  }
  std::sort(candidates.begin(), candidates.end(), ByLink);
  std::vector<FaultCandidate> joints;
  for (const GapStep& gap : gaps)
  {
    JoinBesideGap(grid, gap, candidates, joints);
  }
  // Of a candidate and a joint in one place the candidate stays.
  candidates.insert(candidates.end(), joints.begin(), joints.end());
  std::stable_sort(candidates.begin(), candidates.end(), ByLink);
  candidates.erase(std::unique(candidates.begin(), candidates.end(),
                     [](const FaultCandidate& a, const FaultCandidate& b) { return a.Link == b.Link; }),
    candidates.end());
  return candidates;
}

/// The throw and the height of links.
class LinkMeter
{
public:
  LinkMeter(const ColumnHeights& heights, const std::vector<GapStep>& gaps)
    : Heights(heights)
    , Gaps(gaps)
  {
  }

  CutLink Measure(std::int64_t link, bool isForward) const
  {
    CutLink cut = MeasureCut(this->Heights, link, isForward);
    const auto gap = std::lower_bound(this->Gaps.begin(), this->Gaps.end(), link,
      [](const GapStep& step, std::int64_t place) { return step.Middle < place; });
    if (gap != this->Gaps.end() && gap->Middle == link)
    {
      cut.Throw = gap->Throw;
      cut.Middle = gap->Height;
    }
    return cut;
  }

private:
  const ColumnHeights& Heights;
  const std::vector<GapStep>& Gaps;
};

FaultLines TraceLines(const CornerGraph& graph, const LinkMeter& meter)
{
  FaultLines lines;
  for (const std::vector<ForestStep>& line : ListLines(graph))
  {
    for (const ForestStep& step : line)
    {
      lines.Append(meter.Measure(graph.Edge(step.Edge).Link, step.IsForward));
    }
    lines.Close();
  }
  return lines;
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const FaultDetectionOptions& options)
{
  CheckAtLeast("smallest throw", options.SmallestThrow, 0.0, " vertical indices");
  CheckAtLeast("noise", options.Noise, 0.0, " vertical indices");
  CheckAtLeast("smallest extent", options.SmallestExtent, 0, " columns");
  CheckAtLeast("smallest branch", options.SmallestBranch, 0, " links");
  CheckAtLeast("largest gap", options.LargestGap, 0, " columns");
}

//----------------------------------------------------------------------------------------------------------------------
FaultDetection DetectFaults(const ColumnHeights& heights, const FaultDetectionOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  const LinkGrid& grid = heights.Grid();
  FaultDetection detection;
  const RawVector<float> deviations = FindDeviations(heights, monitor.Step(0.0, 0.7));
  detection.Noise = options.Noise > 0.0 ? options.Noise : MeasureNoise(deviations, heights.AreWhole());
  detection.Low = std::max(LowFactor * detection.Noise, 0.5 * options.SmallestThrow);
  if (heights.AreWhole())
  {
    detection.Low = std::max(detection.Low, LeastWholeStep);
  }
  detection.High = std::max(HighFactor * detection.Noise, options.SmallestThrow);
  const std::vector<GapStep> gaps = FindGapSteps(heights, options.LargestGap,
    std::max(GapFactor * detection.Noise, 0.5 * options.SmallestThrow), monitor.Step(0.7, 0.8));
  std::vector<FaultCandidate> candidates = FindSteep(deviations, detection.Low, detection.High, monitor.Step(0.8, 0.9));
  candidates = AddGaps(grid, std::move(candidates), gaps, detection.High);
  if (candidates.size() > std::size_t(std::numeric_limits<std::int32_t>::max() / 4))
  {
    throw InputError(
      std::to_string(candidates.size()) + " links with steps, expected less than 2^29: try a larger smallest throw");
  }
  candidates = BridgeEnds(
    grid, std::move(candidates), [&deviations](std::int64_t link) { return deviations[std::size_t(link)]; },
    float(0.5 * detection.Low));
  CornerGraph graph(grid, std::move(candidates));
  monitor.Progress(0.95);
  KeepForest(graph, { options.SmallestExtent, options.SmallestBranch, FewestStrong });
  detection.Lines = TraceLines(graph, LinkMeter(heights, gaps));
  return detection;
}
}
