// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. The picks of all traces, by sign (ReflectionFinder.h). Positive and negative reflections have nothing to do with
//    each other: each sign is worked on by itself.
// 2. Picks are joined to surfaces, which are numbers of picks (SurfaceJoining.h). Best first does it twice: by links of
//    long waveforms, and then, for what is small or narrow, by links of short ones.
// 3. The largest surfaces are written as voxels. Only now, the traces are read once more: thicknesses and amplitudes of
//    the picks that come out are found again, as keeping those of all would take more memory than the picks themselves.

#include "ReflectionExtraction.h"

#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "SurfaceJoining.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

namespace SeismicHorizons
{
namespace
{
// ---- Joining -------------------------------------------------------------------------------------------------------

// Widths of waveforms to each side, in dominant periods. Long ones tell layers apart; short ones fill gaps where only
// one layer is left to choose from.
constexpr double LongWaveform = 3.5;
constexpr double ShortWaveform = 1.0;

// Parts that are filled in by links of short waveforms: of fewer picks, or no wider than that, as strips along faults
// are, where long waveforms reach over the fault.
constexpr PointId LargestFilled = 100;
constexpr double LargestFilledWidth = 6.0;

// What the correlation of these links is at least: a part of their median, no more than a fixed one.
constexpr double FillPart = 0.8;
constexpr double LargestFillCorrelation = 0.7;

// What the mean waveforms of wider parts correlate at least, by the long waveforms: a part of their median, no less
// than a fixed one. Means of noisy waveforms are alike even where they themselves are not.
constexpr double WidePart = 0.95;
constexpr double SmallestWideCorrelation = 0.9;

// The largest step that is chosen: a part of the dominant period, and at least so many samples.
constexpr double StepPerPeriod = 0.3;
constexpr double LeastStep = 2.0;

int HalfWidth(double periods, double period)
{
  return std::max(1, int(std::lround(periods * period)));
}

class Joiner
{
public:
  Joiner(const TraceCube& cube, const ExtractionOptions& options, const Extraction& figures)
    : Cube(cube)
    , Options(options)
    , Period(figures.Period)
  {
    this->Link.Connectivity = options.Connectivity;
    this->Link.LargestStep = Depth(std::lround(figures.LargestStep * DepthsPerSample));
  }

  /// Gives the surface of each pick, and the median correlation of its links.
  RawVector<PointId> Join(const ReflectionPicks& picks, double& medianCorrelation, const Monitor& monitor)
  {
    if (this->Options.Joining == SurfaceJoining::Components)
    {
      return FindConnectedPicks(picks, this->Link.Connectivity, this->Link.LargestStep, monitor);
    }
    this->Link.HalfWidth = HalfWidth(LongWaveform, this->Period);
    std::optional<ReflectionLinks> links(std::in_place, this->Cube, picks, this->Link, monitor.Step(0.0, 0.3));
    medianCorrelation = links->MedianCorrelation();
    links->Drop(this->Options.SmallestCorrelation * medianCorrelation);
    if (this->Options.Joining == SurfaceJoining::Continuous)
    {
      return JoinContinuously(picks, *links, monitor.Step(0.3, 1.0));
    }
    JoiningRules rules;
    rules.SmallestContact = this->Options.SmallestContact;
    BestFirstJoining joining(picks);
    joining.Run(*links, rules, monitor.Step(0.3, 0.7));
    links.reset();
    rules.SmallestWideCorrelation = std::max(SmallestWideCorrelation, WidePart * medianCorrelation);
    rules.Correlate = MakeContactCorrelation(this->Cube, picks, this->Link.HalfWidth);
    this->Fill(picks, rules, joining, monitor.Step(0.7, 1.0));
    return joining.TakeSurfaces();
  }

private:
  void Fill(const ReflectionPicks& picks, JoiningRules rules, BestFirstJoining& joining, const Monitor& monitor)
  {
    this->Link.HalfWidth = HalfWidth(ShortWaveform, this->Period);
    ReflectionLinks links(this->Cube, picks, this->Link, monitor.Step(0.0, 0.4));
    links.Drop(std::min(LargestFillCorrelation, FillPart * links.MedianCorrelation()));
    rules.ContactSize = 1;
    rules.LargestFilled = LargestFilled;
    rules.LargestFilledWidth = LargestFilledWidth;
    joining.Run(links, rules, monitor.Step(0.4, 1.0));
  }

  const TraceCube& Cube;
  const ExtractionOptions& Options;
  const double Period;
  LinkOptions Link;
};

// ---- Writing -------------------------------------------------------------------------------------------------------

struct SurfaceSize
{
  int Sign = 0;
  PointId Surface = NoPoint;
  PointId Columns = 0;
};

/// Appends the surfaces of at least that many columns, in the order of their first picks.
void ListSizes(const ReflectionPicks& picks, const RawVector<PointId>& surfaces, int sign, std::int64_t smallestSize,
  std::vector<SurfaceSize>& sizes)
{
  struct Extent
  {
    PointId Columns = 0;
    std::int32_t LastColumn = -1;
  };
  std::vector<Extent> extents(surfaces.size());
  picks.ForEach(
    [&](PointId pick, std::int32_t column)
    {
      if (surfaces[pick] != NoPoint)
      {
        Extent& extent = extents[surfaces[pick]];
        extent.Columns += extent.LastColumn == column ? 0 : 1;
        extent.LastColumn = column;
      }
    });
  for (const PointId surface : surfaces)
  {
    if (surface != NoPoint && extents[surface].Columns >= smallestSize)
    {
      sizes.push_back({ sign, surface, extents[surface].Columns });
      extents[surface].Columns = 0; // it is listed
    }
  }
}

/// Gives each pick the position of its surface among those that are taken, or NoPoint.
void Renumber(const std::vector<SurfaceSize>& sizes, int sign, RawVector<PointId>& surfaces)
{
  std::vector<PointId> positions(surfaces.size(), NoPoint);
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    if (sizes[n].Sign == sign)
    {
      positions[sizes[n].Surface] = PointId(n);
    }
  }
  for (PointId& surface : surfaces)
  {
    surface = surface == NoPoint ? NoPoint : positions[surface];
  }
}

/// A pick of a surface that is taken.
struct Taken
{
  int I = 0;
  PointId Position = NoPoint;
  Reflection Pick;
};

class Writer
{
public:
  Writer(const TraceCube& cube, const CubeReflections& reflections, const std::array<RawVector<PointId>, 2>& positions)
    : Cube(cube)
    , Reflections(reflections)
    , Positions(positions)
  {
  }

  /// Rows are read by all threads, some at a time, and written one after the other.
  void Write(std::vector<LatticeHorizon>& horizons, const Monitor& monitor) const
  {
    constexpr int rowsAtATime = 32;
    std::array<std::vector<Taken>, rowsAtATime> rows;
    for (int first = 0; first < this->Cube.Size[1]; first += rowsAtATime)
    {
      monitor.Progress(double(first) / double(this->Cube.Size[1]));
      const int count = std::min(rowsAtATime, this->Cube.Size[1] - first);
      ParallelFor(count, 1,
        [&](std::int64_t begin, std::int64_t end)
        {
          for (std::int64_t n = begin; n < end; ++n)
          {
            this->ReadRow(first + int(n), rows[n]);
          }
        });
      for (int n = 0; n < count; ++n)
      {
        for (const Taken& taken : rows[n])
        {
          Add(horizons[taken.Position], taken, first + n);
        }
      }
    }
  }

private:
  void ReadRow(int j, std::vector<Taken>& row) const
  {
    row.clear();
    std::vector<float> block;
    std::vector<Reflection> found;
    ForEachTrace(this->Cube, j, block,
      [&](int i, const float* trace)
      {
        found.clear();
        FindReflections(trace, this->Cube.Size[2], this->Reflections.Rules, found);
        const std::array<ReflectionPicks, 2>& picks = this->Reflections.BySign;
        const std::int64_t column = picks[0].ColumnAt(i, j);
        std::array<PointId, 2> next = { picks[0].Begin(column), picks[1].Begin(column) };
        for (const Reflection& reflection : found)
        {
          const int sign = this->Reflections.SignOf(reflection);
          if (sign >= 0)
          {
            const PointId position = this->Positions[sign][next[sign]++];
            if (position != NoPoint)
            {
              row.push_back({ i, position, reflection });
            }
          }
        }
        assert(next[0] == picks[0].End(column) && next[1] == picks[1].End(column)); // the same as before
      });
  }

  static void Add(LatticeHorizon& horizon, const Taken& taken, int j)
  {
    const Reflection& pick = taken.Pick;
    if (!horizon.Column.empty() && horizon.Column.back().X == taken.I && horizon.Column.back().Y == j)
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

  const TraceCube& Cube;
  const CubeReflections& Reflections;
  const std::array<RawVector<PointId>, 2>& Positions;
};

/// Writes the largest surfaces, and their number, to the result. `surfaces` has for each pick of a sign the number of a
/// pick that its surface is named by, or NoPoint; it is used up. Of the picks of a surface in one column that of the
/// largest mean amplitude stays, of equal ones the upper.
void WriteSurfaces(const TraceCube& cube, const CubeReflections& reflections,
  std::array<RawVector<PointId>, 2>& surfaces, const ExtractionOptions& options, Extraction& result,
  const Monitor& monitor)
{
  std::vector<SurfaceSize> sizes;
  for (const int sign : { 0, 1 })
  {
    ListSizes(reflections.BySign[sign], surfaces[sign], sign, options.SmallestSize, sizes);
  }
  std::stable_sort(
    sizes.begin(), sizes.end(), [](const SurfaceSize& a, const SurfaceSize& b) { return a.Columns > b.Columns; });
  result.NumberOfSurfaces = std::int64_t(sizes.size());
  sizes.resize(std::min(options.LargestNumber, result.NumberOfSurfaces));
  result.Surfaces.resize(sizes.size());
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    result.Surfaces[n].SurfaceId = int(n) + 1;
    const std::size_t size = sizes[n].Columns;
    ForEachVoxelArray(result.Surfaces[n], [size](auto& values) { values.Reserve(size); });
  }
  for (const int sign : { 0, 1 })
  {
    Renumber(sizes, sign, surfaces[sign]);
  }
  Writer(cube, reflections, surfaces).Write(result.Surfaces, monitor);
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const ExtractionOptions& options)
{
  CheckOptions(options.Reflections);
  CheckWithin("LargestStep", options.LargestStep, 0.0, double(MostSamples), " samples");
  CheckWithin("SmallestCorrelation", options.SmallestCorrelation, 0.0, 1.0, "");
  CheckWithin("SmallestContact", options.SmallestContact, 0.0, 1.0, "");
  CheckAtLeast<std::int64_t>("SmallestSize", options.SmallestSize, 1, " pick");
  CheckAtLeast<std::int64_t>("LargestNumber", options.LargestNumber, 1, " surface");
}

//----------------------------------------------------------------------------------------------------------------------
Extraction ExtractReflections(const TraceCube& cube, const ExtractionOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  CubeReflections reflections = FindReflections(cube, options.Reflections, monitor.Step(0.0, 0.3));
  Extraction result;
  result.Samples = reflections.Samples;
  result.Picks = reflections.CountPicks();
  result.Threshold = reflections.Threshold;
  result.Period = reflections.Period;
  result.LargestStep =
    options.LargestStep > 0.0 ? options.LargestStep : std::max(LeastStep, StepPerPeriod * result.Period);
  std::array<double, 2> medians = { 0.0, 0.0 };
  std::array<RawVector<PointId>, 2> surfaces;
  for (const int sign : { 0, 1 })
  {
    const double begin = sign == 0 ? 0.3 : 0.6;
    surfaces[sign] =
      Joiner(cube, options, result).Join(reflections.BySign[sign], medians[sign], monitor.Step(begin, begin + 0.3));
    reflections.BySign[sign].FreePicks();
  }
  result.MedianCorrelation = std::max(medians[0], medians[1]);
  WriteSurfaces(cube, reflections, surfaces, options, result, monitor.Step(0.9, 1.0));
  return result;
}
}
