// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. FindRises: means over the width of the widest ramp, and their differences, along both axes.
// 2. Peaks of rises that are steep enough mark the middle of a ramp. An oblique fault has peaks along both axes; the
// axis along which it is narrower counts.
// 3. Peaks of successive rows are joined, also across a few rows without a peak.
// 4. Lines must be long and steep on average, since a single peak may be noise on a fold.

#include "FaultRamps.h"

#include "Common/Base/FixedChunks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr float Missing = std::numeric_limits<float>::quiet_NaN();

struct RampScale
{
  explicit RampScale(int largest)
    : Mean(largest)
    , Half((largest + 1) / 2)
    , Shoulder(this->Mean + this->Half)
    , Fewest(largest / 2 + 1)
    , Reach(this->Shoulder + this->Mean)
  {
    assert(largest >= 2 && this->Reach < ColumnHeights::Margin);
  }

  const std::int64_t Mean; // columns on each side
  const std::int64_t Half; // A steep peak has fallen at this distance.
  const std::int64_t Shoulder; // A ramp is over at this distance.
  const int Fewest;
  const std::int64_t Reach; // columns that a rise depends on
};

/// The place is the mean of known columns. The height is NaN if these are too few.
struct MeanHeight
{
  double Height = std::numeric_limits<double>::quiet_NaN();
  double Place = 0.0;

  bool IsKnown() const { return !std::isnan(this->Height); }
};

struct Rise
{
  double Height = 0.0;
  double Distance = 0.0; // This is 0 if the rise is unknown.

  double Slope() const { return this->Height / this->Distance; }
};

struct NetRise
{
  double Height = std::numeric_limits<double>::quiet_NaN();
  double LeastOfSides = 0.0; // This uses the less favourable shoulder alone, and is 0 if the signs differ.
};

class RiseStrip
{
public:
  RiseStrip(const RampScale& scale, std::int64_t length)
    : Scale(scale)
    , Values(length + 2 * scale.Reach, std::numeric_limits<double>::quiet_NaN())
    , Means(this->Values.size() - scale.Mean + 1)
  {
  }

  double& operator[](std::int64_t place) { return this->Values[place + this->Scale.Reach]; }

  void FindMeans()
  {
    for (std::size_t first = 0; first < this->Means.size(); ++first)
    {
      // A new sum for each place makes the result independent of distant values.
      double sum = 0.0;
      std::int64_t places = 0;
      int points = 0;
      for (std::int64_t n = 0; n < this->Scale.Mean; ++n)
      {
        const double value = this->Values[first + n];
        if (!std::isnan(value))
        {
          sum += value;
          places += n;
          ++points;
        }
      }
      this->Means[first] = points < this->Scale.Fewest
        ? MeanHeight{}
        : MeanHeight{ sum / points, double(first) + double(places) / points };
    }
  }

  Rise At(std::int64_t place) const
  {
    const std::int64_t next = place + this->Scale.Reach + 1;
    if (next < this->Scale.Mean || next >= std::int64_t(this->Means.size()))
    {
      return {};
    }
    const MeanHeight& after = this->Means[next];
    const MeanHeight& before = this->Means[next - this->Scale.Mean];
    return after.IsKnown() && before.IsKnown() ? Rise{ after.Height - before.Height, after.Place - before.Place }
                                               : Rise{};
  }

  /// The dip at `distance` on both sides is subtracted, or on one side if the other is unknown.
  NetRise Net(std::int64_t place, std::int64_t distance) const
  {
    const Rise rise = this->At(place);
    const Rise before = this->At(place - distance);
    const Rise after = this->At(place + distance);
    if (rise.Distance == 0.0 || (before.Distance == 0.0 && after.Distance == 0.0))
    {
      return {};
    }
    const double overBefore = rise.Height - rise.Distance * (before.Distance == 0.0 ? after : before).Slope();
    const double overAfter = rise.Height - rise.Distance * (after.Distance == 0.0 ? before : after).Slope();
    const double least = overBefore * overAfter <= 0.0 ? 0.0
      : overBefore > 0.0                               ? std::min(overBefore, overAfter)
                                                       : std::max(overBefore, overAfter);
    return { 0.5 * (overBefore + overAfter), least };
  }

private:
  const RampScale& Scale;
  std::vector<double> Values;
  std::vector<MeanHeight> Means;
};

// Adjacent grid columns share cache lines.
constexpr std::int64_t LanesOfChunk = 8;

// ---- Peaks ----------------------------------------------------------------------------------------------------------

struct RampPeak
{
  std::int64_t Along = 0; // Along and Lane are grid coordinates.
  std::int64_t Lane = 0;
  float Throw = 0.0F;
  float Fall = 0.0F; // The rise loses this fraction half way to the shoulders.
  bool IsStrong = false;
  bool IsStep = false;
};

// If a link has this fraction of the throw, the fault is a step.
constexpr double StepShare = 0.6;
// Links beside a step have less than this fraction of it.
constexpr double MaxNeighbourShare = 0.5;
// A ramp keeps this fraction of its net rise with the dip of either shoulder, and loses MinFall half way to them.
constexpr double MinShoulderShare = 0.2;
constexpr double MinFall = 0.25;
// A rise must not be smaller than this fraction of the rise along the other axis.
constexpr double MinCrossShare = 0.85;

class PeakSearch
{
public:
  PeakSearch(const ColumnHeights& heights, const RampScale& scale, const RawVector<float>& rises,
    const RawVector<float>& deviations, const RampLimits& limits)
    : Heights(heights)
    , Scale(scale)
    , Rises(rises)
    , Deviations(deviations)
    , Limits(limits)
  {
  }

  void FindInLane(const Lanes& lanes, std::int64_t lane, std::vector<RampPeak>& peaks) const
  {
    for (std::int64_t along = 0; along + 1 < lanes.Length(); ++along)
    {
      const float rise = this->Rises[lanes.Link(along, lane)];
      if (double(std::abs(rise)) >= this->Limits.LeastRise && this->IsPeak(lanes, along, lane) &&
        this->IsAcross(lanes, along, lane))
      {
        this->Append(lanes, along, lane, peaks);
      }
    }
  }

private:
  bool IsPeak(const Lanes& lanes, std::int64_t along, std::int64_t lane) const
  {
    const float rise = this->Rises[lanes.Link(along, lane)];
    const float sign = rise < 0.0F ? -1.0F : 1.0F;
    const std::int64_t last = std::min(along + this->Scale.Half, lanes.Length() - 2);
    for (std::int64_t other = std::max<std::int64_t>(0, along - this->Scale.Half); other <= last; ++other)
    {
      const float size = sign * this->Rises[lanes.Link(other, lane)];
      if (size > sign * rise || (size == sign * rise && other < along))
      {
        return false;
      }
    }
    return true;
  }

  bool IsAcross(const Lanes& lanes, std::int64_t along, std::int64_t lane) const
  {
    const Lanes others = lanes.Others();
    double sum = 0.0;
    int number = 0;
    for (std::int64_t n = std::max<std::int64_t>(0, lane - 1); n <= std::min(lane, others.Length() - 1); ++n)
    {
      for (const std::int64_t place : { along, along + 1 })
      {
        const float rise = this->Rises[others.Link(n, place)];
        if (!std::isnan(rise))
        {
          sum += double(rise);
          ++number;
        }
      }
    }
    return number == 0 ||
      double(std::abs(this->Rises[lanes.Link(along, lane)])) >= MinCrossShare * std::abs(sum) / number;
  }

  void Append(const Lanes& lanes, std::int64_t along, std::int64_t lane, std::vector<RampPeak>& peaks) const
  {
    if (std::isnan(this->Heights.At(lanes.Column(along, lane))) ||
      std::isnan(this->Heights.At(lanes.Column(along + 1, lane))))
    {
      return;
    }
    const std::int64_t middle = this->Scale.Reach + this->Scale.Half;
    RiseStrip strip(this->Scale, 2 * middle + 2);
    for (std::int64_t n = 0; n < 2 * middle + 2; ++n)
    {
      const std::int64_t place = along - middle + n;
      strip[n] = place < 0 || place >= lanes.Length() ? std::numeric_limits<double>::quiet_NaN()
                                                      : this->Heights.At(lanes.Column(place, lane));
    }
    strip.FindMeans();
    if (strip.At(middle - this->Scale.Half).Distance == 0.0 || strip.At(middle + this->Scale.Half).Distance == 0.0)
    {
      return; // At a rim every curved slope has a peak.
    }
    const NetRise net = strip.Net(middle, this->Scale.Shoulder);
    const NetRise near = strip.Net(middle, this->Scale.Half);
    const double fall = near.Height / net.Height;
    if (net.LeastOfSides / net.Height < MinShoulderShare || !(fall >= MinFall))
    {
      return;
    }
    // A step has fallen by 4/7. Wider ramps fall less, and their means have lost more of the throw.
    const double lost = std::clamp(0.57 - fall, 0.0, 0.26);
    RampPeak peak;
    peak.Throw = float(net.Height * (1.0 + 2.2 * lost));
    peak.Fall = float(fall);
    if (double(std::abs(peak.Throw)) < this->Limits.LeastThrow)
    {
      return;
    }
    peak.IsStrong =
      std::abs(net.Height) >= this->Limits.StrongRise && double(std::abs(peak.Throw)) >= this->Limits.StrongThrow;
    std::int64_t place = along;
    if (!this->FindStep(lanes, lane, place, peak))
    {
      return; // Several faults lie side by side.
    }
    const Lanes gridLanes{ this->Heights.Grid(), lanes.Side };
    const std::int64_t column = LinkGrid::FirstColumn(this->Heights.ToGrid(lanes.Link(place, lane)));
    peak.Along = gridLanes.AlongOf(column);
    peak.Lane = gridLanes.LaneOf(column);
    peaks.push_back(peak);
  }

  /// Moves `place` to the link with most of the throw, if there is one. Returns false if most of the throw is at
  /// several separate links.
  bool FindStep(const Lanes& lanes, std::int64_t lane, std::int64_t& place, RampPeak& peak) const
  {
    const std::int64_t middle = place;
    const double least = StepShare * double(std::abs(peak.Throw));
    const float sign = peak.Throw < 0.0F ? -1.0F : 1.0F;
    double largest = 0.0;
    double alone = 0.0;
    for (std::int64_t n = middle - this->Scale.Mean; n <= middle + this->Scale.Mean; ++n)
    {
      const double step = this->StepAt(lanes, n, lane, sign);
      if (step < this->Limits.LeastStep)
      {
        continue;
      }
      if (step >= least && step > largest && std::abs(n - middle) <= this->Scale.Half)
      {
        largest = step;
        place = n;
        peak.IsStep = true;
      }
      const double beside = std::max(this->StepAt(lanes, n - 1, lane, sign), this->StepAt(lanes, n + 1, lane, sign));
      alone += beside < MaxNeighbourShare * step ? step : 0.0;
    }
    return peak.IsStep || alone < least;
  }

  double StepAt(const Lanes& lanes, std::int64_t along, std::int64_t lane, float sign) const
  {
    const bool isLink = along >= 0 && along + 1 < lanes.Length();
    const double step = isLink ? double(sign * this->Deviations[lanes.Link(along, lane)]) : 0.0;
    return std::isnan(step) ? 0.0 : step;
  }

  const ColumnHeights& Heights;
  const RampScale& Scale;
  const RawVector<float>& Rises;
  const RawVector<float>& Deviations;
  const RampLimits& Limits;
};

// ---- Joints ---------------------------------------------------------------------------------------------------------

struct RampLink
{
  std::int64_t Link = 0;
  float Throw = 0.0F;
  float Fall = 0.0F;
  bool IsPeak = false;
  bool IsStrong = false;
  bool IsStep = false;
  bool IsOfRamp = false; // Most peaks of its line are no steps.
};

// A ramp may skip two lanes.
constexpr std::int64_t LargestHop = 3;
constexpr std::int64_t LargestLaneShift = 2; // columns from lane to lane

void Join(const Lanes& lanes, const RampPeak& from, const RampPeak& to, std::vector<RampLink>& joints)
{
  const std::int64_t hop = to.Lane - from.Lane;
  const double mean = 0.5 * (double(from.Throw) + double(to.Throw));
  std::int64_t along = from.Along;
  for (std::int64_t lane = from.Lane + 1; lane <= to.Lane; ++lane)
  {
    const std::int64_t next =
      from.Along + std::int64_t(std::floor(double((to.Along - from.Along) * (lane - from.Lane)) / double(hop) + 0.5));
    for (std::int64_t column = std::min(along, next) + 1; column <= std::max(along, next); ++column)
    {
      // Where the ramp shifts, the next lane is before it while this lane is beyond.
      joints.push_back({ lanes.Across(column, lane - 1), float(next > along ? -mean : mean) });
    }
    if (lane < to.Lane)
    {
      joints.push_back({ lanes.Link(next, lane), float(mean) });
    }
    along = next;
  }
}

void JoinPeaks(const Lanes& lanes, const std::vector<RampPeak>& peaks, std::vector<RampLink>& joints)
{
  const auto byPlace = [](const RampPeak& a, const RampPeak& b)
  { return a.Lane != b.Lane ? a.Lane < b.Lane : a.Along < b.Along; };
  for (const RampPeak& peak : peaks)
  {
    for (std::int64_t hop = 1; hop <= LargestHop; ++hop)
    {
      RampPeak key;
      key.Lane = peak.Lane + hop;
      key.Along = peak.Along - LargestLaneShift * hop;
      const RampPeak* nearest = nullptr;
      for (auto next = std::lower_bound(peaks.begin(), peaks.end(), key, byPlace);
           next != peaks.end() && next->Lane == key.Lane && next->Along <= peak.Along + LargestLaneShift * hop; ++next)
      {
        if ((next->Throw < 0.0F) == (peak.Throw < 0.0F) &&
          (!nearest || std::abs(next->Along - peak.Along) < std::abs(nearest->Along - peak.Along)))
        {
          nearest = &*next;
        }
      }
      if (nearest)
      {
        Join(lanes, peak, *nearest, joints);
        break;
      }
    }
  }
}

// ---- Lines ----------------------------------------------------------------------------------------------------------

// The mean loss half way to the shoulders is 0.43 for ramps as wide as the means and 0.57 for steps, but at most 0.35
// for folds at least 20 columns long.
constexpr double LeastMeanFall = 0.29;

std::vector<FaultCandidate> ToCandidates(const std::vector<RampLink>& links)
{
  std::vector<FaultCandidate> candidates;
  for (const RampLink& link : links)
  {
    candidates.push_back({ link.Link, link.IsPeak ? std::abs(link.Throw) : 0.0F, link.IsStrong });
  }
  return candidates;
}

/// Returns the links of long and steep lines, in order.
std::vector<RampLink> KeepLines(const LinkGrid& grid, std::vector<RampLink> all, const ForestLimits& limits)
{
  std::stable_sort(all.begin(), all.end(),
    [](const RampLink& a, const RampLink& b) { return a.Link != b.Link ? a.Link < b.Link : a.IsPeak && !b.IsPeak; });
  all.erase(std::unique(all.begin(), all.end(), [](const RampLink& a, const RampLink& b) { return a.Link == b.Link; }),
    all.end());
  CornerGraph graph(grid, ToCandidates(all));
  KeepForest(graph, limits);
  std::vector<RampLink> kept;
  for (const std::vector<ForestStep>& line : ListLines(graph))
  {
    double falls = 0.0;
    int peaks = 0;
    int steps = 0;
    for (const ForestStep& step : line)
    {
      const RampLink& link = all[std::size_t(step.Edge)];
      falls += double(link.Fall);
      peaks += link.IsPeak ? 1 : 0;
      steps += link.IsStep ? 1 : 0;
    }
    for (std::size_t n = 0; n < line.size() && falls >= LeastMeanFall * peaks; ++n)
    {
      kept.push_back(all[std::size_t(line[n].Edge)]);
      kept.back().IsOfRamp = 2 * steps < peaks;
    }
  }
  std::sort(kept.begin(), kept.end(), [](const RampLink& a, const RampLink& b) { return a.Link < b.Link; });
  return kept;
}

void AppendBeside(const LinkGrid& grid, const RampLink& ramp, std::int64_t reach, std::vector<FaultCandidate>& beside)
{
  const Lanes lanes{ grid, LinkGrid::SideOf(ramp.Link) };
  const std::int64_t middle = lanes.AlongOf(LinkGrid::FirstColumn(ramp.Link));
  const std::int64_t lane = lanes.LaneOf(LinkGrid::FirstColumn(ramp.Link));
  const std::int64_t last = std::min(middle + reach, lanes.Length() - 1);
  const float least = float(StepShare) * std::abs(ramp.Throw);
  for (std::int64_t along = std::max<std::int64_t>(0, middle - reach); along <= last; ++along)
  {
    beside.push_back({ lanes.Link(along, lane), least, false });
    beside.push_back({ lanes.Across(along, lane), least, false });
    if (lane > 0)
    {
      beside.push_back({ lanes.Across(along, lane - 1), least, false });
    }
  }
}

/// Links beside a ramp belong to it if their size is below the listed size.
std::vector<FaultCandidate> ListBeside(const LinkGrid& grid, const std::vector<RampLink>& links, std::int64_t reach)
{
  std::vector<FaultCandidate> beside;
  for (const RampLink& ramp : links)
  {
    if (ramp.IsPeak && !ramp.IsStep && ramp.IsOfRamp)
    {
      AppendBeside(grid, ramp, reach, beside);
    }
  }
  std::sort(beside.begin(), beside.end(),
    [](const FaultCandidate& a, const FaultCandidate& b)
    { return a.Link != b.Link ? a.Link < b.Link : a.Size > b.Size; });
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  return beside;
}
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<float> FindRises(const ColumnHeights& heights, int largest, const Monitor& monitor)
{
  const RampScale scale(largest);
  RawVector<float> rises;
  rises.resize(heights.Raster().NumberOfLinks());
  for (const LinkSide side : { LinkSide::East, LinkSide::North })
  {
    const Lanes lanes{ heights.Raster(), side };
    ForEachChunk(lanes.Number(), LanesOfChunk, monitor,
      [&](std::size_t, std::int64_t first, std::int64_t last)
      {
        std::vector<RiseStrip> strips(std::size_t(last - first), RiseStrip(scale, lanes.Length()));
        for (std::int64_t along = 0; along < lanes.Length(); ++along)
        {
          for (std::int64_t lane = first; lane < last; ++lane)
          {
            strips[lane - first][along] = heights.At(lanes.Column(along, lane));
          }
        }
        for (RiseStrip& strip : strips)
        {
          strip.FindMeans();
        }
        for (std::int64_t along = 0; along < lanes.Length(); ++along)
        {
          for (std::int64_t lane = first; lane < last; ++lane)
          {
            rises[lanes.Link(along, lane)] =
              along + 1 < lanes.Length() ? float(strips[lane - first].Net(along, scale.Shoulder).Height) : Missing;
          }
        }
      });
  }
  return rises;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FaultCandidate> AddRamps(const ColumnHeights& heights, int largest, const RawVector<float>& rises,
  const RawVector<float>& deviations, const RampLimits& limits, std::vector<FaultCandidate> candidates,
  std::vector<LinkThrow>& throws, const Monitor& monitor)
{
  const RampScale scale(largest);
  std::vector<RampLink> all;
  for (const LinkSide side : { LinkSide::East, LinkSide::North })
  {
    const Lanes lanes{ heights.Raster(), side };
    const PeakSearch search(heights, scale, rises, deviations, limits);
    const std::vector<RampPeak> peaks = CollectChunks<RampPeak>(lanes.Number(), LanesOfChunk, monitor,
      [&](std::vector<RampPeak>& part, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t lane = first; lane < last; ++lane)
        {
          search.FindInLane(lanes, lane, part);
        }
      });
    const Lanes gridLanes{ heights.Grid(), side };
    for (const RampPeak& peak : peaks)
    {
      all.push_back(
        { gridLanes.Link(peak.Along, peak.Lane), peak.Throw, peak.Fall, true, peak.IsStrong, peak.IsStep, false });
    }
    JoinPeaks(gridLanes, peaks, all);
  }
  ForestLimits forest = limits.Forest;
  forest.SmallestExtent = std::max(forest.SmallestExtent, 2 * largest);
  const std::vector<RampLink> ramps = KeepLines(heights.Grid(), std::move(all), forest);
  const std::vector<FaultCandidate> beside = ListBeside(heights.Grid(), ramps, scale.Half);
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [&beside](const FaultCandidate& candidate)
                     {
                       const auto place = std::lower_bound(beside.begin(), beside.end(), candidate);
                       return place != beside.end() && place->Link == candidate.Link && candidate.Size < place->Size;
                     }),
    candidates.end());
  AddCandidates(candidates, ToCandidates(ramps));
  for (const RampLink& ramp : ramps)
  {
    throws.push_back({ ramp.Link, double(ramp.Throw) });
  }
  return candidates;
}
}
