// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The passes, in order:
//
//  1. Deviations. The deviation of a link is the height difference across it less the median of those across the links
//     of the same side within three columns, which is the dip. So a plane has none, however steep, nor has a slope next
//     to a fault.
//  2. Noise, the standard deviation of differences, by the median of the sizes of deviations.
//  3. Candidates are the links with large deviations; those with still larger ones are strong.
//  4. Gaps. A fault often shows as a band of a few missing columns, where no link has two heights. Planes through
//     columns on both sides tell how far apart the two sides are in the middle of the gap; the link there is a
//     candidate, joined to those of the next row or file.
//  5. Lines. Ends of candidates are bridged, and a forest of long and strong ones stays (FaultForest.h).
//
// A file is what a row is along j. Candidates and all that comes of them have the numbers of links in the grid, the
// bounding box, which are sparse. The first two passes and the search for gaps run over the raster (ColumnHeights.h),
// from which empty bands are left out: they look at most at four columns in each direction, fewer than
// ColumnHeights::Margin.

#include "FaultDetection.h"

#include "Common/Errors.h"
#include "Common/FixedChunks.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "Common/RawVector.h"
#include "FaultForest.h"
#include "FaultJoins.h"
#include "FaultRamps.h"
#include "WindowMedians.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
//----------------------------------------------------------------------------------------------------------------------
// 1. Deviations.

static_assert(WindowReach + 1 < ColumnHeights::Margin);

/// The differences across the links of some rows, nan where there is none. Rows come one after the other, and the last
/// seven are kept.
class DifferenceRows
{
public:
  DifferenceRows(const ColumnHeights& heights, LinkSide side)
    : Heights(heights)
    , Kind(side)
    , Width(heights.Raster().Width())
    , Values(WindowSide * this->Width, std::numeric_limits<float>::quiet_NaN())
  {
  }

  /// The row y, which may lie outside the raster.
  void Load(std::int64_t y)
  {
    const LinkGrid& raster = this->Heights.Raster();
    const bool isEast = this->Kind == LinkSide::East;
    float* const row = this->Row(y);
    std::fill(row, row + this->Width, std::numeric_limits<float>::quiet_NaN());
    if (y < 0 || y + (isEast ? 0 : 1) >= raster.Height())
    {
      return;
    }
    const double* const before = this->Heights.Row(y);
    const double* const beyond = isEast ? before + 1 : this->Heights.Row(y + 1);
    for (std::int64_t x = 0; x < this->Width - (isEast ? 1 : 0); ++x)
    {
      row[x] = float(beyond[x] - before[x]);
    }
  }

  /// The first column of a row that is kept.
  float* Row(std::int64_t y) { return this->Values.data() + (y + WindowSide) % WindowSide * this->Width; }

private:
  const ColumnHeights& Heights;
  const LinkSide Kind;
  const std::int64_t Width;
  std::vector<float> Values;
};

/// The deviations of a row, one for every other place: those of the other side come between.
void FindRow(DifferenceRows& differences, std::int64_t y, std::vector<float>& medians, float* deviations)
{
  std::array<const float*, WindowSide> rows;
  for (std::int64_t n = 0; n < WindowSide; ++n)
  {
    rows[n] = differences.Row(y - WindowReach + n);
  }
  FindWindowMedians(rows, std::int64_t(medians.size()), medians.data());
  const float* const row = rows[WindowReach];
  for (std::size_t x = 0; x < medians.size(); ++x)
  {
    deviations[2 * x] = row[x] - medians[x];
  }
}

/// By link of the raster, nan where one of the two columns has no point.
RawVector<float> FindDeviations(const ColumnHeights& heights, const Monitor& monitor)
{
  const LinkGrid& raster = heights.Raster();
  RawVector<float> deviations;
  deviations.resize(raster.NumberOfLinks());
  constexpr std::int64_t Grain = 65536; // links that a thread takes at a time
  const std::int64_t rows = std::max<std::int64_t>(2 * WindowReach, Grain / raster.Width());
  ParallelFor(raster.Height(), rows, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (const LinkSide side : { LinkSide::East, LinkSide::North })
      {
        DifferenceRows differences(heights, side);
        std::vector<float> medians(std::size_t(raster.Width()));
        for (std::int64_t y = first - WindowReach; y < first + WindowReach; ++y)
        {
          differences.Load(y);
        }
        for (std::int64_t y = first; y < last; ++y)
        {
          differences.Load(y + WindowReach);
          FindRow(differences, y, medians, deviations.data() + raster.LinkOf(0, y, side));
        }
      }
    });
  return deviations;
}

//----------------------------------------------------------------------------------------------------------------------
// 2. Noise.

// The standard deviation of normal noise by the median and by the mean of its sizes.
constexpr double DeviationPerMedian = 1.4826;
constexpr double DeviationPerMean = 1.2533;
// What rounding to whole heights does to a difference: the square root of two twelfths.
constexpr double WholeFloor = 0.408;
constexpr double RealFloor = 0.02;

/// The median of whole numbers, were each spread evenly from half below it to half above it; `median` is that of the
/// numbers as they are. So it changes with their distribution, and does not leap from 0 to 1.
double GroupedMedian(const std::vector<float>& sizes, float median)
{
  std::size_t below = 0;
  std::size_t equal = 0;
  for (const float size : sizes)
  {
    const float whole = std::round(size);
    below += whole < median ? 1 : 0;
    equal += whole == median ? 1 : 0;
  }
  const double part = (0.5 * double(sizes.size()) - double(below)) / double(equal);
  return median == 0.0F ? 0.5 * part : double(median) - 0.5 + part;
}

double ClippedMean(const std::vector<float>& sizes, double largest)
{
  double sum = 0.0;
  for (const float size : sizes)
  {
    sum += std::min(double(size), largest);
  }
  return sum / double(sizes.size());
}

/// The sizes of deviations, of many only some, which tell as well as all: of each group of values that follow each
/// other one. It is each time another one (by the fraction of the golden ratio; Knuth, 6.4), as noise that returns
/// every few columns, such as the footprint of a survey, would else be met in some of them alone. Values are counted
/// from the first one on, so that the noise does not depend on what the raster leaves out.
std::vector<float> SampleSizes(const RawVector<float>& deviations, LinkSide side)
{
  constexpr std::int64_t Enough = 1000000;
  std::int64_t known = 0;
  for (std::size_t n = std::size_t(side); n < deviations.size(); n += 2)
  {
    known += std::isnan(deviations[n]) ? 0 : 1;
  }
  const std::int64_t groupSize = std::max<std::int64_t>(1, known / Enough);
  std::vector<float> sizes;
  sizes.reserve(std::size_t(known / groupSize + 1));
  std::uint64_t fraction = 0; // in units of 2^-64
  std::int64_t left = 0; // values of the group
  std::int64_t chosen = 0; // how many are left at the one that is taken
  for (std::size_t n = std::size_t(side); n < deviations.size(); n += 2)
  {
    const float deviation = deviations[n];
    if (std::isnan(deviation))
    {
      continue;
    }
    if (left == 0)
    {
      left = groupSize;
      fraction += 0x9E3779B97F4A7C15U;
      chosen = 1 + std::int64_t((fraction >> 32) * std::uint64_t(groupSize) >> 32);
    }
    if (left == chosen)
    {
      sizes.push_back(std::abs(deviation));
    }
    --left;
  }
  return sizes;
}

/// The standard deviation of noise in deviations: 1.4826 times the median of their sizes. Of whole heights that is the
/// median of groups, which lies between the whole numbers, and the result at least what rounding does to differences.
/// Of others, where the median is next to nothing, as in data that were smoothed or rounded, the mean of small sizes
/// is used.
double NoiseOfDifferences(const ColumnHeights& heights, std::vector<float> sizes)
{
  const double floor = heights.AreWhole() ? WholeFloor : RealFloor;
  if (sizes.empty())
  {
    return floor;
  }
  const auto middle = sizes.begin() + sizes.size() / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (heights.AreWhole())
  {
    return std::max(floor, DeviationPerMedian * GroupedMedian(sizes, std::round(*middle)));
  }
  const double noise = DeviationPerMedian * double(*middle);
  return noise >= floor ? noise : std::max(floor, DeviationPerMean * ClippedMean(sizes, 4.0 * floor));
}

/// Of all, or of those along rows or along files alone where these are much rougher: heights that were interpolated
/// between lines are smooth one way.
double NoiseOfDifferences(const ColumnHeights& heights, const RawVector<float>& deviations)
{
  constexpr double Rougher = 1.5;
  std::vector<float> east = SampleSizes(deviations, LinkSide::East);
  std::vector<float> north = SampleSizes(deviations, LinkSide::North);
  const double noiseEast = NoiseOfDifferences(heights, east);
  const double noiseNorth = NoiseOfDifferences(heights, north);
  const double larger = std::max(noiseEast, noiseNorth);
  // Rounding of a dip is not the same both ways.
  if (larger > Rougher * std::min(noiseEast, noiseNorth) && (!heights.AreWhole() || larger > 2.0 * WholeFloor))
  {
    return larger;
  }
  east.insert(east.end(), north.begin(), north.end());
  return NoiseOfDifferences(heights, std::move(east));
}

/// The same of rises, which means of many columns make: white noise leaves 0.46 of that of differences, but what rows
/// have in common and folds leave more.
double MeasureRiseNoise(const RawVector<float>& rises, double noise, bool isGiven)
{
  const double ofWhite = 0.46 * noise;
  std::vector<float> sizes = SampleSizes(rises, LinkSide::East);
  const std::vector<float> north = SampleSizes(rises, LinkSide::North);
  sizes.insert(sizes.end(), north.begin(), north.end());
  if (isGiven || sizes.empty())
  {
    return ofWhite;
  }
  const auto middle = sizes.begin() + sizes.size() / 2;
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::max(ofWhite, DeviationPerMedian * double(*middle));
}

//----------------------------------------------------------------------------------------------------------------------
// 3. Candidates.

// By noise alone one link in a hundred is a candidate, and hardly any a strong one.
constexpr double LowFactor = 2.5; // standard deviations
constexpr double HighFactor = 4.0;
// How far the planes beside a gap have to be apart: they are extended, and so vary more than a difference does.
constexpr double GapFactor = 3.0;
constexpr int FewestStrong = 5;
// Rounding to whole heights makes steps of 1, but none of 2.
constexpr double LeastWholeStep = 1.5;

/// What find(items, first, last) appends for each chunk of the indices 0 to `size`, in the order of chunks.
template <typename Item, typename Find>
std::vector<Item> CollectChunks(std::int64_t size, std::int64_t chunkSize, const Monitor& monitor, Find&& find)
{
  std::vector<std::vector<Item>> parts(CountChunks(size, chunkSize));
  ForEachChunk(size, chunkSize, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last) { find(parts[chunk], first, last); });
  std::vector<Item> all;
  for (const std::vector<Item>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::vector<FaultCandidate> FindSteep(
  const ColumnHeights& heights, const RawVector<float>& deviations, double low, double high, const Monitor& monitor)
{
  constexpr std::int64_t ChunkSize = 1 << 18; // links
  return CollectChunks<FaultCandidate>(std::int64_t(deviations.size()), ChunkSize, monitor,
    [&](std::vector<FaultCandidate>& candidates, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t link = first; link < last; ++link)
      {
        const float size = std::abs(deviations[link]);
        if (double(size) >= low) // not nan
        {
          candidates.push_back({ heights.ToGrid(link), size, double(size) >= high });
        }
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// 4. Gaps.

/// Missing columns in a row or file between two that are not, as seen by its links.
struct GapStep
{
  std::int64_t First = 0; // link from the last column before the gap
  std::int64_t Middle = 0; // link in the middle of the gap
  std::int64_t Last = 0; // link to the first column beyond the gap
  double Throw = 0.0; // how much higher the plane beyond the gap is there than that before it
  double Height = 0.0; // half way between the planes
};

// A plane goes through the points of this many columns, along the row and across it.
constexpr std::int64_t Along = 4;
constexpr std::int64_t Across = 1; // to each side of the row
constexpr int FewestPoints = 6; // of twelve
static_assert(Along < ColumnHeights::Margin);

/// The raster as seen along rows to the east, or along files to the north: both are strips.
class Strips
{
public:
  Strips(const ColumnHeights& heights, LinkSide side)
    : Heights(heights)
    , Kind(side)
  {
  }

  std::int64_t Length() const { return this->IsEast() ? this->Raster().Width() : this->Raster().Height(); }
  std::int64_t Number() const { return this->IsEast() ? this->Raster().Height() : this->Raster().Width(); }

  bool Has(std::int64_t along, std::int64_t strip) const
  {
    return along >= 0 && along < this->Length() && strip >= 0 && strip < this->Number() &&
      !std::isnan(this->Height(along, strip));
  }

  double Height(std::int64_t along, std::int64_t strip) const
  {
    return this->Heights.At(
      this->IsEast() ? strip * this->Raster().Width() + along : along * this->Raster().Width() + strip);
  }

  /// Where a column is along the strips of the grid.
  std::int64_t GridAlong(std::int64_t along) const
  {
    return this->IsEast() ? this->Heights.GridX(along) : this->Heights.GridY(along);
  }

  /// The link from such a column of the grid to the next one.
  std::int64_t GridLink(std::int64_t gridAlong, std::int64_t strip) const
  {
    const LinkGrid& grid = this->Heights.Grid();
    return this->IsEast() ? grid.LinkOf(gridAlong, this->Heights.GridY(strip), this->Kind)
                          : grid.LinkOf(this->Heights.GridX(strip), gridAlong, this->Kind);
  }

private:
  const LinkGrid& Raster() const { return this->Heights.Raster(); }
  bool IsEast() const { return this->Kind == LinkSide::East; }

  const ColumnHeights& Heights;
  const LinkSide Kind;
};

/// The height of the plane through columns from `first` on, in the direction of `step`, at `distance` columns before
/// the first; nan where there are too few of them, or all in a line.
double ExtendPlane(const Strips& strips, std::int64_t strip, std::int64_t first, std::int64_t step, double distance)
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  int points = 0;
  for (std::int64_t n = 0; n < Along; ++n)
  {
    const std::int64_t along = first + n * step;
    for (std::int64_t across = -Across; across <= Across; ++across)
    {
      if (strips.Has(along, strip + across))
      {
        const Eigen::Vector3d row(1.0, double(step) * (distance + double(n)), double(across));
        matrix += row * row.transpose();
        right += row * strips.Height(along, strip + across);
        ++points;
      }
    }
  }
  // Whole numbers, but for halves: the determinant of points in a line is nothing but rounding.
  constexpr double Nothing = 1e-6;
  if (points < FewestPoints || matrix.determinant() < Nothing)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return matrix.ldlt().solve(right)[0];
}

void FindStripSteps(const Strips& strips, std::int64_t strip, int longest, double smallest, std::vector<GapStep>& steps)
{
  std::int64_t before = -1; // the last column that is there
  for (std::int64_t along = 0; along < strips.Length(); ++along)
  {
    if (!strips.Has(along, strip))
    {
      continue;
    }
    if (before >= 0 && along - before > 1)
    {
      const std::int64_t gridBefore = strips.GridAlong(before);
      const std::int64_t gridAlong = strips.GridAlong(along);
      if (gridAlong - gridBefore - 1 <= longest)
      {
        const double half = 0.5 * double(gridAlong - gridBefore);
        const double low = ExtendPlane(strips, strip, before, -1, half);
        const double high = ExtendPlane(strips, strip, along, 1, half);
        if (std::abs(high - low) >= smallest)
        {
          steps.push_back({ strips.GridLink(gridBefore, strip), strips.GridLink((gridBefore + gridAlong) / 2, strip),
            strips.GridLink(gridAlong - 1, strip), high - low, 0.5 * (low + high) });
        }
      }
    }
    before = along;
  }
}

/// The steps across all gaps of 1 to `longest` columns that are at least `smallest` high, by their links in the middle.
std::vector<GapStep> FindGapSteps(const ColumnHeights& heights, int longest, double smallest, const Monitor& monitor)
{
  std::vector<GapStep> all;
  for (const LinkSide side : { LinkSide::East, LinkSide::North })
  {
    const Strips strips(heights, side);
    constexpr std::int64_t ChunkSize = 16; // strips
    const std::vector<GapStep> steps = CollectChunks<GapStep>(strips.Number(), ChunkSize, monitor,
      [&](std::vector<GapStep>& part, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t strip = first; strip < last; ++strip)
        {
          FindStripSteps(strips, strip, longest, smallest, part);
        }
      });
    all.insert(all.end(), steps.begin(), steps.end());
  }
  std::sort(all.begin(), all.end(), [](const GapStep& a, const GapStep& b) { return a.Middle < b.Middle; });
  return all;
}

bool ByLink(const FaultCandidate& a, const FaultCandidate& b)
{
  return a.Link < b.Link;
}

/// The candidates among every `step`-th link from `first` to `last`.
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
  assert(gap.First <= gap.Middle && gap.Middle <= gap.Last && LinkGrid::SideOf(gap.First) == side);
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

//----------------------------------------------------------------------------------------------------------------------
// 5. Lines.

/// The throw and the height of links.
class LinkMeter
{
public:
  LinkMeter(const ColumnHeights& heights, const std::vector<GapStep>& gaps, const std::vector<LinkThrow>& ramps)
    : Heights(heights)
    , Gaps(gaps)
    , Ramps(ramps)
  {
  }

  FaultedLink Measure(std::int64_t link, bool isForward) const
  {
    FaultedLink cut = MeasureCut(this->Heights, link, isForward);
    const auto gap = std::lower_bound(this->Gaps.begin(), this->Gaps.end(), link,
      [](const GapStep& step, std::int64_t place) { return step.Middle < place; });
    if (gap != this->Gaps.end() && gap->Middle == link)
    {
      cut.Throw = gap->Throw;
      cut.Middle = gap->Height;
    }
    const auto ramp = std::lower_bound(this->Ramps.begin(), this->Ramps.end(), link,
      [](const LinkThrow& step, std::int64_t place) { return step.Link < place; });
    // A crack through a ramp keeps what is its own.
    if (ramp != this->Ramps.end() && ramp->Link == link && !(std::abs(cut.Throw) > std::abs(ramp->Throw)))
    {
      cut.Throw = ramp->Throw;
    }
    return cut;
  }

private:
  const ColumnHeights& Heights;
  const std::vector<GapStep>& Gaps;
  const std::vector<LinkThrow>& Ramps;
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
  CheckWithin("largest ramp", options.LargestRamp, 0, LargestLargestRamp, " columns");
}

//----------------------------------------------------------------------------------------------------------------------
FaultDetection DetectFaults(const ColumnHeights& heights, const FaultDetectionOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  const LinkGrid& grid = heights.Grid();
  FaultDetection detection;
  const RawVector<float> deviations = FindDeviations(heights, monitor.Step(0.0, 0.7));
  detection.Noise = options.Noise > 0.0 ? options.Noise : NoiseOfDifferences(heights, deviations);
  detection.Low = std::max(LowFactor * detection.Noise, 0.5 * options.SmallestThrow);
  if (heights.AreWhole())
  {
    detection.Low = std::max(detection.Low, LeastWholeStep);
  }
  detection.High = std::max(HighFactor * detection.Noise, options.SmallestThrow);
  const std::vector<GapStep> gaps = FindGapSteps(heights, options.LargestGap,
    std::max(GapFactor * detection.Noise, 0.5 * options.SmallestThrow), monitor.Step(0.7, 0.8));
  std::vector<FaultCandidate> candidates =
    FindSteep(heights, deviations, detection.Low, detection.High, monitor.Step(0.8, 0.85));
  std::vector<LinkThrow> ramps;
  if (options.LargestRamp > 1)
  {
    const RawVector<float> rises = FindRises(heights, options.LargestRamp, monitor.Step(0.85, 0.87));
    const double noise = MeasureRiseNoise(rises, detection.Noise, options.Noise > 0.0);
    RampLimits limits;
    limits.LeastRise = LowFactor * noise;
    limits.LeastThrow = 0.5 * options.SmallestThrow;
    limits.StrongRise = HighFactor * noise;
    limits.StrongThrow = options.SmallestThrow;
    limits.LeastStep = detection.Low;
    limits.Forest = { options.SmallestExtent, options.SmallestBranch, FewestStrong };
    candidates = AddRamps(
      heights, options.LargestRamp, rises, deviations, limits, std::move(candidates), ramps, monitor.Step(0.87, 0.9));
  }
  candidates = AddGaps(grid, std::move(candidates), gaps, detection.High);
  if (candidates.size() > std::numeric_limits<std::int32_t>::max() / 4)
  {
    throw InputError(
      std::to_string(candidates.size()) + " links with steps, expected less than 2^29: try a larger smallest throw");
  }
  const auto deviationAcross = [&](std::int64_t link)
  {
    const std::int64_t inRaster = heights.ToRaster(link);
    return inRaster < 0 ? std::numeric_limits<float>::quiet_NaN() : deviations[inRaster];
  };
  candidates = BridgeEnds(grid, std::move(candidates), deviationAcross, float(0.5 * detection.Low));
  CornerGraph graph(grid, std::move(candidates));
  monitor.Progress(0.95);
  KeepForest(graph, { options.SmallestExtent, options.SmallestBranch, FewestStrong });
  detection.Lines = TraceLines(graph, LinkMeter(heights, gaps, ramps));
  if (options.JoinThroughHoles)
  {
    JoinThroughHoles(heights, detection.Lines);
  }
  return detection;
}
}
