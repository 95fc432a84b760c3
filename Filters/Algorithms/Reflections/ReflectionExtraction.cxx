// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Picks are found by sign (ReflectionFinder.h), and signs are processed independently.
// 2. Picks are joined to surfaces (SurfaceJoining.h): best first twice, with long waveforms, then with short waveforms
// for small and narrow gaps.
// 3. Guides take their picks (GuidedJoining.h).
// 4. The first surfaces are written. Traces are read again, as keeping thicknesses and amplitudes of all picks would
// take more memory.
//
// Before these come the phase of the wavelet, the filter of noisy traces (LowPass.h), and the reflections that
// picks of guides mean.

#include "ReflectionExtraction.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Base/SideBySide.h"
#include "Common/Horizon/DataModel.h"
#include "GuideBands.h"
#include "GuidedExtraction.h"
#include "LowPass.h"
#include "SurfaceJoining.h"
#include "WaveletPhase.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Joining -------------------------------------------------------------------------------------------------------

// The half width, in dominant periods, of waveforms that fill gaps where only one layer is left.
constexpr double ShortWaveform = 1.0;

// Short waveforms join parts of fewer picks, and narrow strips, as along faults, where long waveforms reach across.
constexpr PointId LargestFilled = 100;
constexpr double LargestFilledWidth = 6.0;

// Short waveforms need this fraction of their median correlation, at most the limit.
constexpr double FillPart = 0.8;
constexpr double LargestFillCorrelation = 0.7;

// Wider parts need this fraction of the median of long waveforms, at least the limit. Means of noisy waveforms are
// alike even if the waveforms are not.
constexpr double WidePart = 0.95;
constexpr double SmallestWideCorrelation = 0.9;

// The step is in dominant periods, and at least this number of samples.
constexpr double StepPerPeriod = 0.3;
constexpr double LeastLinkStep = 2.0;

// Traces without noise have about one peak in two half periods, with noise in the band of reflections one in each, and
// white noise adds more the finer the sampling.
constexpr double PeaksOfAutomatic = 1.2;
constexpr double PeaksOfGuided = 2.5;

RawVector<PointId> JoinSurfaces(const TraceCube& cube, const ReflectionPicks& picks, const ExtractionOptions& options,
  const Extraction& figures, double& medianCorrelation, const Monitor& monitor)
{
  LinkOptions link{ options.Connectivity, InDepths(figures.LargestStep) };
  if (options.Joining == SurfaceJoining::Components)
  {
    return FindConnectedPicks(picks, link.Connectivity, link.LargestStep, monitor);
  }
  link.HalfWidth = HalfWidth(LongWaveform, figures.Period);
  JoiningRules rules;
  rules.SmallestContact = options.SmallestContact;
  BestFirstJoining joining(picks);
  {
    ReflectionLinks links(cube, picks, link, monitor.Step(0.0, 0.3));
    medianCorrelation = links.MedianCorrelation();
    links.Drop(options.SmallestCorrelation * medianCorrelation);
    joining.Run(links, rules, monitor.Step(0.3, 0.7));
  }
  rules.SmallestWideCorrelation = std::max(SmallestWideCorrelation, WidePart * medianCorrelation);
  rules.Correlate = MakeContactCorrelation(cube, picks, link.HalfWidth);
  rules.ContactSize = 1;
  rules.LargestFilled = LargestFilled;
  rules.LargestFilledWidth = LargestFilledWidth;
  link.HalfWidth = HalfWidth(ShortWaveform, figures.Period);
  const Monitor filling = monitor.Step(0.7, 1.0);
  ReflectionLinks links(cube, picks, link, filling.Step(0.0, 0.4));
  links.Drop(std::min(LargestFillCorrelation, FillPart * links.MedianCorrelation()));
  joining.Run(links, rules, filling.Step(0.4, 1.0));
  return joining.TakeSurfaces();
}

// ---- Which surfaces come out ---------------------------------------------------------------------------------------

// The smallest size is a fraction of the traces within limits, as lines have few.
constexpr std::int64_t TracesPerSmallest = 20;
constexpr std::int64_t LeastSize = 10;
constexpr std::int64_t LargestLeastSize = 100;

std::int64_t ChooseSmallestSize(const ExtractionOptions& options, const std::array<int, 3>& size)
{
  return options.SmallestSize > 0
    ? options.SmallestSize
    : std::clamp(std::int64_t(size[0]) * size[1] / TracesPerSmallest, LeastSize, LargestLeastSize);
}

struct SurfaceSize
{
  int Sign = 0;
  PointId Surface = NoPoint;
  PointId Columns = 0;
  double Strength = 0.0;
};

/// Columns count their strongest pick.
std::vector<SurfaceSize> ListSizes(
  const ReflectionPicks& picks, const RawVector<PointId>& surfaces, int sign, std::int64_t smallestSize)
{
  struct Extent
  {
    PointId Columns = 0;
    std::int32_t LastColumn = -1;
    double Strength = 0.0;
    double LastStrength = 0.0;
  };
  std::vector<Extent> extents(surfaces.size());
  picks.ForEach(
    [&](PointId pick, std::int32_t column)
    {
      if (surfaces[pick] == NoPoint)
      {
        return;
      }
      Extent& extent = extents[surfaces[pick]];
      const double strength = picks.StrengthOf(pick);
      const bool isNew = extent.LastColumn != column;
      const double cube = strength * strength * strength;
      const double more = isNew ? cube : std::max(0.0, cube - extent.LastStrength);
      extent.Columns += isNew ? 1 : 0;
      extent.Strength += more;
      extent.LastStrength = isNew ? more : extent.LastStrength + more;
      extent.LastColumn = column;
    });
  std::vector<SurfaceSize> sizes;
  for (const PointId surface : surfaces)
  {
    if (surface != NoPoint && extents[surface].Columns >= smallestSize)
    {
      sizes.push_back({ sign, surface, extents[surface].Columns, extents[surface].Strength });
      extents[surface].Columns = 0; // listed
    }
  }
  return sizes;
}

std::vector<SurfaceSize> ListSizesOfBoth(
  const CubeReflections& picks, const std::array<RawVector<PointId>, 2>& surfaces, std::int64_t smallestSize)
{
  std::array<std::vector<SurfaceSize>, 2> sizes;
  ParallelFor(2, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (int sign = int(first); sign < int(last); ++sign)
      {
        sizes[sign] = ListSizes(picks.BySign[sign], surfaces[sign], sign, smallestSize);
      }
    });
  sizes[0].insert(sizes[0].end(), sizes[1].begin(), sizes[1].end());
  return sizes[0];
}

void TakeFirst(const ExtractionOptions& options, std::vector<SurfaceSize>& sizes)
{
  std::stable_sort(sizes.begin(), sizes.end(),
    [&](const SurfaceSize& a, const SurfaceSize& b)
    { return options.Order == SurfaceOrder::Strength ? a.Strength > b.Strength : a.Columns > b.Columns; });
  sizes.resize(std::min(options.LargestNumber, std::int64_t(sizes.size())));
}

void Renumber(const std::vector<SurfaceSize>& sizes, int sign, PointId first, RawVector<PointId>& surfaces)
{
  if (sizes.empty())
  {
    surfaces.assign(surfaces.size(), NoPoint);
    return;
  }
  std::vector<PointId> positions(surfaces.size(), NoPoint);
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    if (sizes[n].Sign == sign)
    {
      positions[sizes[n].Surface] = first + PointId(n);
    }
  }
  ParallelFor(std::int64_t(surfaces.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t pick = begin; pick < end; ++pick)
      {
        surfaces[pick] = surfaces[pick] == NoPoint ? NoPoint : positions[surfaces[pick]];
      }
    });
}

/// Where picks come out. Guides may share picks.
class NumbersOfSurfaces
{
public:
  explicit NumbersOfSurfaces(std::array<RawVector<PointId>, 2> first)
    : First(std::move(first))
  {
  }

  void Add(int sign, PointId pick, PointId position)
  {
    PointId& first = this->First[sign][pick];
    if (first == NoPoint)
    {
      first = position;
    }
    else
    {
      this->More[sign].push_back({ pick, position });
    }
  }

  void Sort()
  {
    for (auto& more : this->More)
    {
      std::sort(more.begin(), more.end());
    }
  }

  template <typename Visit>
  void ForEachOf(int sign, PointId pick, Visit&& visit) const
  {
    const PointId first = this->First[sign][pick];
    if (first == NoPoint)
    {
      return;
    }
    visit(first);
    const auto& more = this->More[sign];
    for (auto next = std::lower_bound(more.begin(), more.end(), std::pair<PointId, PointId>(pick, 0));
         next != more.end() && next->first == pick; ++next)
    {
      visit(next->second);
    }
  }

private:
  std::array<RawVector<PointId>, 2> First; // by sign and pick
  std::array<std::vector<std::pair<PointId, PointId>>, 2> More; // pick and position
};

// ---- Picks ---------------------------------------------------------------------------------------------------------

bool AreSameReflections(const ReflectionOptions& a, const ReflectionOptions& b)
{
  const auto tie = [](const ReflectionOptions& options)
  {
    return std::tie(
      options.Polarity, options.Position, options.Threshold, options.AmplitudeThreshold, options.AmplitudePercentile);
  };
  return tie(a) == tie(b);
}

/// Guidance, and what is taken of the surfaces, do not count.
bool JoinAlike(const ExtractionOptions& a, const ExtractionOptions& b)
{
  const auto tie = [](const ExtractionOptions& options)
  {
    return std::tie(options.PhaseRotation, options.Joining, options.Connectivity, options.LargestStep,
      options.SmallestCorrelation, options.SmallestContact);
  };
  return AreSameReflections(a.Reflections, b.Reflections) && tie(a) == tie(b);
}

/// Seeds have the tolerance.
bool FollowAlike(const GuidanceOptions& a, const GuidanceOptions& b)
{
  return a.GrowthCorrelation == b.GrowthCorrelation && a.GrowthReach == b.GrowthReach &&
    a.LeastConfidence == b.LeastConfidence;
}
}

/// What a horizon has of a pick besides its place.
struct PickValues
{
  std::int32_t Thickness = 0; // 0 until it is known
  float Amplitude = 0.0F;
};

struct JoinedReflections
{
  ExtractionOptions Options;
  double GivenPeriod = 0.0; // before smoothing
  Extraction Figures;
  CubeReflections Picks;
  // By sign, once they are needed:
  std::array<std::optional<RawVector<PointId>>, 2> Surfaces;
  std::array<double, 2> MedianCorrelations = { 0.0, 0.0 };
  std::array<std::optional<SurfaceMembers>, 2> Members;
  std::array<std::optional<GrowthLinks>, 2> Links;
  std::array<std::vector<FollowedGuide>, 2> Followed;
  std::array<std::vector<PickValues>, 2> Values; // by sign and pick; empty unless they are kept

  void KeepValues()
  {
    for (const int sign : { 0, 1 })
    {
      this->Values[sign].resize(std::size_t(this->Picks.BySign[sign].Size()));
    }
  }

  /// Starts of picks remain.
  void Free(int sign)
  {
    this->Picks.BySign[sign].FreePicks();
    this->Surfaces[sign].reset();
    this->Members[sign].reset();
    this->Links[sign].reset();
    this->Followed[sign].clear();
  }
};

namespace
{
/// Noise leads automatic surfaces astray, and breaks peaks up where traces are finely sampled.
TraceCube Smoothed(const TraceCube& cube, const JoinedReflections& joined)
{
  return joined.Figures.IsSmoothed ? LowPass(cube, joined.GivenPeriod) : cube;
}

void ChooseSmoothing(
  const TraceCube& cube, bool isGuided, const TraceLimits& limits, JoinedReflections& joined, const Monitor& monitor)
{
  ReflectionOptions all;
  all.AmplitudePercentile = 0.0;
  const CubeReflections reflections = FindReflections(cube, all, monitor, limits);
  joined.GivenPeriod = reflections.Period;
  // Biased amplitudes have runs as long as a trace, whatever their reflections.
  const double traces = double(cube.Size[0]) * cube.Size[1];
  joined.Figures.IsBiased = traces * reflections.Period > double(reflections.Samples);
  const double halfPeriods = 2.0 * double(reflections.LiveSamples) / reflections.Period;
  joined.Figures.IsSmoothed = !joined.Figures.IsBiased &&
    double(reflections.CountPicks()) > (isGuided ? PeaksOfGuided : PeaksOfAutomatic) * halfPeriods;
}

ReflectionOptions PickOptions(const ExtractionOptions& options, bool isGuided)
{
  ReflectionOptions own = options.Reflections;
  if (isGuided)
  {
    own.AmplitudePercentile = 0.0; // interpreters follow weak reflections
  }
  return own;
}

std::shared_ptr<JoinedReflections> FindPicks(const TraceCube& cube, const ExtractionOptions& options, bool isGuided,
  const TraceLimits& limits, const Monitor& monitor)
{
  auto joined = std::make_shared<JoinedReflections>();
  joined->Options = options;
  if (options.Joining == SurfaceJoining::BestFirst)
  {
    ChooseSmoothing(cube, isGuided, limits, *joined, monitor.Step(0.0, 0.4));
  }
  const TraceCube smoothed = Smoothed(cube, *joined);
  joined->Picks = FindReflections(smoothed, PickOptions(options, isGuided), monitor.Step(0.4, 1.0), limits);
  Extraction& figures = joined->Figures;
  figures.Samples = joined->Picks.Samples;
  figures.Picks = joined->Picks.CountPicks();
  figures.Threshold = joined->Picks.Threshold;
  figures.Period = joined->Picks.Period;
  figures.Phase = EstimatePhase(smoothed);
  figures.LargestStep =
    options.LargestStep > 0.0 ? options.LargestStep : std::max(LeastLinkStep, StepPerPeriod * figures.Period);
  return joined;
}

// ---- Large cubes ---------------------------------------------------------------------------------------------------

// Some rows of a large cube show its noise, period and phase.
constexpr std::int64_t SamplesThatShow = std::int64_t(1) << 25;

// In dominant periods. Rough paths may be some periods off.
constexpr double HalfBand = 4.0;
constexpr double HalfPathWindow = 1.5;
constexpr double StepOfPaths = 0.32;

std::int64_t CountSamples(const TraceCube& cube)
{
  return std::int64_t(cube.Size[0]) * cube.Size[1] * cube.Size[2];
}

TraceLimits LimitsOfRows(const TraceLimits& limits, int columns, const std::vector<int>& rows)
{
  TraceLimits some;
  for (const int row : limits.AreNone() ? std::vector<int>() : rows)
  {
    const std::ptrdiff_t begin = std::ptrdiff_t(row) * columns;
    some.First.insert(some.First.end(), limits.First.begin() + begin, limits.First.begin() + begin + columns);
    some.Last.insert(some.Last.end(), limits.Last.begin() + begin, limits.Last.begin() + begin + columns);
  }
  return some;
}

/// Only picks in bands around the guides, which become limits.
std::shared_ptr<JoinedReflections> FindPicksNear(const std::vector<Guide>& guides, const TraceCube& cube,
  const ExtractionOptions& options, TraceLimits& limits, const Monitor& monitor)
{
  const int step = int((CountSamples(cube) - 1) / SamplesThatShow) + 1;
  const std::vector<int> rows = ChooseRows(cube.Size[1], step, guides);
  std::shared_ptr<JoinedReflections> joined =
    FindPicks(TakeRows(cube, rows), options, true, LimitsOfRows(limits, cube.Size[0], rows), monitor.Step(0.0, 0.1));
  const double period = joined->Picks.Period;
  const TraceCube smoothed = Smoothed(cube, *joined);
  const BandOptions ofPaths{ HalfWidth(HalfPathWindow, period), HalfWidth(StepOfPaths, period) };
  limits.Middles = FollowRoughly(smoothed, guides, ofPaths, monitor.Step(0.1, 0.6));
  limits.HalfBand = std::ceil(HalfBand * period);
  joined->Picks = FindReflections(smoothed, PickOptions(options, true), monitor.Step(0.6, 1.0), limits);
  joined->Picks.Period = period;
  joined->Figures.Samples = joined->Picks.Samples;
  joined->Figures.Picks = joined->Picks.CountPicks();
  joined->Figures.HalfBand = limits.HalfBand;
  return joined;
}

void CheckJoining(const std::vector<Guide>& guides, SurfaceJoining joining)
{
  if (!guides.empty() && joining == SurfaceJoining::Components)
  {
    throw InputError("guides and Joining Components, whose surfaces pass columns twice, expected BestFirst");
  }
}

std::shared_ptr<JoinedReflections> StartFrom(std::shared_ptr<JoinedReflections> joined, const TraceCube& cube,
  const ExtractionOptions& options, bool isGuided, const TraceLimits& limits, const Monitor& monitor)
{
  if (!joined || !JoinAlike(joined->Options, options))
  {
    joined = FindPicks(cube, options, isGuided, limits, monitor);
  }
  if (!FollowAlike(joined->Options.Guidance, options.Guidance))
  {
    joined->Followed = {};
  }
  joined->Options = options;
  return joined;
}

/// Signs are joined side by side, as the last links of each are tried on one thread.
void JoinSigns(const TraceCube& cube, const std::array<bool, 2>& areWanted, const ExtractionOptions& options,
  JoinedReflections& joined, const Monitor& monitor)
{
  RunSideBySide(2, 2, monitor,
    [&](std::int64_t sign, const Monitor& step)
    {
      if (areWanted[sign] && !joined.Surfaces[sign])
      {
        joined.Surfaces[sign] =
          JoinSurfaces(cube, joined.Picks.BySign[sign], options, joined.Figures, joined.MedianCorrelations[sign], step);
      }
    });
}

/// Returns the automatic surfaces, without picks that guides took.
RawVector<PointId> TakeSurfaces(const TraceCube& cube, int sign, GuidedExtraction& guided, bool isKept,
  JoinedReflections& joined, const Monitor& monitor)
{
  const ReflectionPicks& picks = joined.Picks.BySign[sign];
  std::optional<RawVector<PointId>>& automatic = joined.Surfaces[sign];
  RawVector<PointId> surfaces = isKept ? *automatic : std::move(*automatic);
  if (guided.HasAny(sign))
  {
    std::optional<GrowthLinks>& links = joined.Links[sign];
    if (!links)
    {
      links = guided.FindLinks(cube, picks, monitor.Step(0.0, 0.7));
    }
    std::optional<SurfaceMembers>& members = joined.Members[sign];
    if (!members)
    {
      members.emplace(picks, surfaces);
    }
    guided.Follow(cube, sign, picks, *members, *links, surfaces, joined.Followed[sign], monitor.Step(0.7, 1.0));
  }
  if (!isKept)
  {
    joined.Links[sign].reset();
    joined.Members[sign].reset();
  }
  return surfaces;
}

// ---- Writing -------------------------------------------------------------------------------------------------------

struct Taken
{
  int I = 0;
  PointId Position = NoPoint;
  Reflection Pick;
  int Sign = 0;
  PointId Number = NoPoint; // of the pick
};

/// Without traces. Returns false if the values of a pick are not known.
bool ReadKnownRow(const JoinedReflections& joined, const NumbersOfSurfaces& positions, int j, std::vector<Taken>& row)
{
  row.clear();
  const std::array<ReflectionPicks, 2>& picks = joined.Picks.BySign;
  bool areKnown = !joined.Values[0].empty() || !joined.Values[1].empty();
  for (int i = 0; i < picks[0].Columns[0] && areKnown; ++i)
  {
    const std::int64_t column = picks[0].ColumnAt(i, j);
    const std::size_t first = row.size();
    for (const int sign : { 0, 1 })
    {
      for (PointId pick = picks[sign].Begin(column); pick < picks[sign].End(column); ++pick)
      {
        positions.ForEachOf(sign, pick,
          [&](PointId position)
          {
            const PickValues& values = joined.Values[sign][pick];
            areKnown = areKnown && values.Thickness > 0;
            const Reflection known = { picks[sign].Places[pick], values.Thickness, values.Amplitude, 0.0F };
            row.push_back({ i, position, known, sign, pick });
          });
      }
    }
    std::stable_sort(row.begin() + std::ptrdiff_t(first), row.end(),
      [](const Taken& a, const Taken& b) { return a.Pick.Place < b.Pick.Place; });
  }
  return areKnown;
}

void ReadRow(const TraceCube& cube, const CubeReflections& reflections, const TraceLimits& limits,
  const NumbersOfSurfaces& positions, int j, std::vector<Taken>& row)
{
  row.clear();
  std::vector<float> block;
  std::vector<Reflection> found;
  ForEachTrace(cube, j, block,
    [&](int i, const float* trace)
    {
      found.clear();
      const std::array<ReflectionPicks, 2>& picks = reflections.BySign;
      const std::int64_t column = picks[0].ColumnAt(i, j);
      FindReflections(trace, cube.Size[2], reflections.Rules, found);
      LeaveOutBeyond(limits, column, 0, found);
      std::array<PointId, 2> next = { picks[0].Begin(column), picks[1].Begin(column) };
      for (const Reflection& reflection : found)
      {
        const int sign = reflections.SignOf(reflection);
        if (sign >= 0)
        {
          const PointId pick = next[sign]++;
          positions.ForEachOf(sign, pick,
            [&](PointId position) {
              row.push_back({ i, position, reflection, sign, pick });
            });
        }
      }
      assert(next[0] == picks[0].End(column) && next[1] == picks[1].End(column));
    });
}

/// Smoothing weakens thin reflections, so amplitudes and thicknesses are those of the trace itself, where it has the
/// reflection within `reach`.
void TakeUnsmoothed(
  const TraceCube& cube, const ReflectionRules& rules, PickDepth reach, int j, std::vector<Taken>& row)
{
  auto next = row.begin();
  std::vector<float> block;
  std::vector<Reflection> found;
  ForEachTrace(cube, j, block,
    [&](int i, const float* trace)
    {
      found.clear();
      if (next != row.end() && next->I == i)
      {
        FindReflections(trace, cube.Size[2], rules, found);
      }
      for (; next != row.end() && next->I == i; ++next)
      {
        PickDepth nearest = reach;
        const Reflection smoothed = next->Pick;
        for (const Reflection& own : found)
        {
          const PickDepth distance = std::abs(own.Place - smoothed.Place);
          if (distance <= nearest && std::signbit(own.Amplitude) == std::signbit(smoothed.Amplitude))
          {
            nearest = distance;
            next->Pick.Thickness = own.Thickness;
            next->Pick.Amplitude = own.Amplitude;
          }
        }
      }
    });
}

void MakeRoom(
  std::size_t guides, const GuidedExtraction& guided, const std::vector<SurfaceSize>& sizes, Extraction& result)
{
  result.Surfaces.resize(guides + sizes.size());
  for (std::size_t n = 0; n < result.Surfaces.size(); ++n)
  {
    result.Surfaces[n].SurfaceId = int(n) + 1;
    const std::size_t size = n < guides ? guided.SizeOf(n) : sizes[n - guides].Columns;
    ForEachVoxelArray(result.Surfaces[n], [size](auto& values) { values.Reserve(size); });
  }
}

void AddPick(LatticeHorizon& horizon, const Taken& taken, int j)
{
  const Reflection& pick = taken.Pick;
  if (!horizon.Column.empty() && horizon.Column.back() == PlanePoint{ taken.I, j })
  {
    ++horizon.DroppedDuplicates;
    if (std::abs(pick.Amplitude) <= std::abs(horizon.Amplitude.back()))
    {
      return;
    }
    ForEachVoxelArray(horizon, [](auto& values) { values.pop_back(); });
  }
  horizon.Column.push_back({ taken.I, j });
  horizon.K.push_back(NearestSample(pick.Place));
  horizon.Thickness.push_back(pick.Thickness);
  horizon.Amplitude.push_back(pick.Amplitude);
  horizon.RealZ.push_back(InSamples(pick.Place));
}

/// Traces are read only where values of picks are not known.
void TakeRow(const TraceCube& cube, const TraceCube* unsmoothed, const TraceLimits& limits,
  const NumbersOfSurfaces& positions, int j, JoinedReflections& joined, std::vector<Taken>& row)
{
  if (ReadKnownRow(joined, positions, j, row))
  {
    return;
  }
  const CubeReflections& reflections = joined.Picks;
  ReadRow(cube, reflections, limits, positions, j, row);
  if (unsmoothed)
  {
    TakeUnsmoothed(*unsmoothed, reflections.Rules, InDepths(reflections.Period / 4.0), j, row);
  }
  for (const Taken& taken : row)
  {
    if (!joined.Values[taken.Sign].empty())
    {
      joined.Values[taken.Sign][taken.Number] = { taken.Pick.Thickness, taken.Pick.Amplitude };
    }
  }
}

/// Threads read blocks of rows, while one of them writes the block before.
void WriteSurfaces(const TraceCube& cube, const TraceCube* unsmoothed, const TraceLimits& limits,
  const NumbersOfSurfaces& positions, JoinedReflections& joined, std::vector<LatticeHorizon>& horizons,
  const Monitor& monitor)
{
  constexpr int rowsAtATime = 32;
  using Rows = std::vector<std::vector<Taken>>;
  Rows before;
  Rows rows;
  const auto write = [&](int firstRow)
  {
    for (std::size_t n = 0; n < before.size(); ++n)
    {
      for (const Taken& taken : before[n])
      {
        AddPick(horizons[taken.Position], taken, firstRow + int(n));
      }
    }
  };
  for (int first = 0; first < cube.Size[1] + rowsAtATime; first += rowsAtATime)
  {
    monitor.Progress(std::min(1.0, double(first) / double(cube.Size[1])));
    const int count = std::clamp(cube.Size[1] - first, 0, rowsAtATime);
    rows.resize(std::size_t(count));
    ParallelFor(count + 1, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          n == 0 ? write(first - rowsAtATime)
                 : TakeRow(cube, unsmoothed, limits, positions, first + int(n) - 1, joined, rows[std::size_t(n) - 1]);
        }
      });
    before.swap(rows);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const ExtractionOptions& options)
{
  CheckOptions(options.Reflections);
  CheckWithin("PhaseRotation", options.PhaseRotation, -180.0, 180.0, " degrees");
  CheckWithin("LargestStep", options.LargestStep, 0.0, double(MostSamples), " samples");
  CheckWithin("SmallestCorrelation", options.SmallestCorrelation, 0.0, 1.0, "");
  CheckWithin("SmallestContact", options.SmallestContact, 0.0, 1.0, "");
  CheckAtLeast<std::int64_t>("SmallestSize", options.SmallestSize, 0, " picks");
  CheckAtLeast<std::int64_t>("LargestNumber", options.LargestNumber, 1, " surface");
  CheckWithin("GuideTolerance", options.Guidance.Tolerance, 0.0, double(MostSamples), " samples");
  CheckWithin("GrowthCorrelation", options.Guidance.GrowthCorrelation, 0.0, 1.0, "");
  CheckAtLeast("GrowthReach", options.Guidance.GrowthReach, 0, " columns");
  CheckWithin("LeastConfidence", options.Guidance.LeastConfidence, 0.0, 1.0, "");
}

//----------------------------------------------------------------------------------------------------------------------
Extraction ExtractReflections(const TraceCube& given, const ExtractionOptions& options, const Monitor& monitor,
  const std::vector<Guide>& guides, const TraceLimits& givenLimits, std::shared_ptr<JoinedReflections>* kept)
{
  CheckOptions(options);
  CheckJoining(guides, options.Joining);
  const TraceCube turned = options.PhaseRotation != 0.0 ? TurnPhase(given, options.PhaseRotation) : given;
  const bool isGuided = !guides.empty();
  const bool isNearOnly =
    isGuided && !options.Guidance.KeepOthers && CountSamples(turned) > options.Guidance.LargestWhole;
  const bool isKept = kept && isGuided && !isNearOnly;
  const Monitor finding = monitor.Step(0.0, 0.3);
  TraceLimits limits = givenLimits;
  const std::shared_ptr<JoinedReflections> joined = isNearOnly
    ? FindPicksNear(guides, turned, options, limits, finding)
    : StartFrom(isKept ? *kept : nullptr, turned, options, isGuided, limits, finding);
  const TraceCube cube = Smoothed(turned, *joined);
  Extraction result = joined->Figures;
  result.SmallestSize = ChooseSmallestSize(options, cube.Size);
  const bool hasOthers = !isGuided || options.Guidance.KeepOthers;
  std::array<RawVector<PointId>, 2> surfaces;
  GuidedExtraction guided(guides, joined->Picks, cube.Size[2], options, result);
  const std::array<bool, 2> areWanted = { hasOthers || guided.HasAny(0), hasOthers || guided.HasAny(1) };
  JoinSigns(cube, areWanted, options, *joined, monitor.Step(0.3, isGuided ? 0.7 : 0.9));
  for (const int sign : { 0, 1 })
  {
    surfaces[sign] = areWanted[sign]
      ? TakeSurfaces(cube, sign, guided, isKept, *joined, monitor.Step(0.7 + 0.1 * sign, 0.8 + 0.1 * sign))
      : RawVector<PointId>(std::size_t(joined->Picks.BySign[sign].Size()), NoPoint);
    result.MedianCorrelation = std::max(result.MedianCorrelation, joined->MedianCorrelations[sign]);
  }
  std::vector<SurfaceSize> sizes =
    hasOthers ? ListSizesOfBoth(joined->Picks, surfaces, result.SmallestSize) : std::vector<SurfaceSize>();
  if (!isKept)
  {
    joined->Free(0);
    joined->Free(1);
  }
  result.NumberOfSurfaces = std::int64_t(sizes.size());
  TakeFirst(options, sizes);
  for (const int sign : { 0, 1 })
  {
    Renumber(sizes, sign, PointId(guides.size()), surfaces[sign]);
  }
  NumbersOfSurfaces positions(std::move(surfaces));
  guided.JoinSigns(joined->Picks);
  guided.ForEachPick([&positions](std::size_t n, int sign, PointId pick) { positions.Add(sign, pick, PointId(n)); });
  positions.Sort();
  MakeRoom(guides.size(), guided, sizes, result);
  if (isKept)
  {
    joined->KeepValues();
  }
  WriteSurfaces(
    cube, result.IsSmoothed ? &turned : nullptr, limits, positions, *joined, result.Surfaces, monitor.Step(0.9, 1.0));
  guided.AddAttributes();
  if (kept)
  {
    *kept = isKept ? joined : nullptr;
  }
  return result;
}
}
