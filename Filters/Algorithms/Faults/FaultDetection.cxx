// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The passes are listed in FaultDetection.h. Deviations exclude the dip, so that a plane has none, nor a slope beside a
// fault. Faults often appear as bands of a few missing columns; planes through columns on both sides of a band give its
// throw.
//
// Candidates are sparse and have link numbers of the grid. Deviations and bands use the raster (ColumnHeights.h), as
// they reach four columns at most, less than ColumnHeights::Margin.

#include "FaultDetection.h"

#include "ColumnHeights.h"
#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/Median.h"
#include "FaultForest.h"
#include "FaultLines.h"
#include "FaultRamps.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "WindowMedians.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Faults through holes -------------------------------------------------------------------------------------------

// Nothing can be detected where columns are missing, so that a fault across a hole is found as
// two lines, and filling would create a ramp. Two lines that end at a hole are joined if they point at each other and
// have similar throws.

// These links of a line define its direction and throw at an end. The throw tapers towards tips of faults, but not at
// holes.
constexpr std::size_t LinksOfEnd = 20;
// Detection needs complete neighbourhoods, so that lines may end this many columns from a hole.
constexpr double FarthestEnd = 8.0;
constexpr double LargestTurn = 0.4363; // 25 degrees, between the direction of a line and the other end
constexpr double LargestRatio = 2.0;
constexpr double Step = 0.5; // columns
constexpr double WidestHole = 1000.0; // columns; wider holes are not bridged

struct LineEnd
{
  MapPlace Place;
  MapPlace Smooth; // without the stairs of links
  MapPlace Direction; // outwards, of length 1
  double LeftThrow = 0.0;
  double Height = 0.0;
  double Reach = 0.0; // columns to the other side of the hole
};

struct EndPair
{
  double Turn = 0.0;
  std::size_t First = 0;
  std::size_t Second = 0;
};

/// Returns the nearest column of the grid, or -1 outside.
std::int64_t NearestColumn(const LinkGrid& grid, const MapPlace& place)
{
  const std::int64_t x = std::int64_t(std::floor(place.X + 0.5)) - grid.Origin().X;
  const std::int64_t y = std::int64_t(std::floor(place.Y + 0.5)) - grid.Origin().Y;
  return x >= 0 && y >= 0 && x < grid.Width() && y < grid.Height() ? y * grid.Width() + x : -1;
}

/// Returns 0 without a hole nearby, or with nothing beyond it.
double FindReach(const ColumnHeights& heights, const LineEnd& end)
{
  bool isHole = false;
  for (double distance = Step;; distance += Step)
  {
    const std::int64_t column = NearestColumn(
      heights.Grid(), { end.Place.X + distance * end.Direction.X, end.Place.Y + distance * end.Direction.Y });
    if (column < 0 || distance > (isHole ? WidestHole : FarthestEnd))
    {
      return 0.0;
    }
    const bool isMissing = std::isnan(heights[column]);
    if (isHole && !isMissing)
    {
      return distance;
    }
    isHole = isHole || isMissing;
  }
}

/// The reach is 0 if the end is at no hole, or has no direction or throw.
LineEnd MeasureEnd(const ColumnHeights& heights, const FaultLines& lines, std::size_t line, bool isLast)
{
  const std::size_t start = lines.Start(line);
  const std::size_t number = std::min(LinksOfEnd, lines.End(line) - start);
  const auto link = [&](std::size_t fromEnd)
  { return lines[isLast ? lines.End(line) - 1 - fromEnd : start + fromEnd]; };
  const auto middleOf = [](const FaultedLink& cut)
  {
    const PlanePoint before = cut.Place.Column;
    const PlanePoint beyond = cut.Place.Beyond();
    return MapPlace{ 0.5 * (double(before.X) + beyond.X), 0.5 * (double(before.Y) + beyond.Y) };
  };
  LineEnd end;
  end.Place = middleOf(link(0));
  end.Height = link(0).Middle;
  // Linear regression removes the stairs of single links.
  const double half = 0.5 * double(number - 1);
  MapPlace mean;
  MapPlace slope;
  double squares = 0.0;
  double sum = 0.0;
  int known = 0;
  for (std::size_t n = 0; n < number; ++n)
  {
    const MapPlace place = middleOf(link(n));
    const double weight = half - double(n);
    mean.X += place.X / double(number);
    mean.Y += place.Y / double(number);
    slope.X += weight * place.X;
    slope.Y += weight * place.Y;
    squares += weight * weight;
    const double left = link(n).LeftThrow();
    sum += std::isnan(left) ? 0.0 : left;
    known += std::isnan(left) ? 0 : 1;
  }
  const double length = std::hypot(slope.X, slope.Y);
  if (known > 0 && length > 0.0)
  {
    end.Direction = { slope.X / length, slope.Y / length };
    end.Smooth = { mean.X + half * slope.X / squares, mean.Y + half * slope.Y / squares };
    end.LeftThrow = (isLast ? sum : -sum) / known;
    end.Reach = FindReach(heights, end);
  }
  return end;
}

bool IsMostlyMissing(const ColumnHeights& heights, const MapPlace& from, double x, double y, double length)
{
  const int steps = int(std::ceil(length / Step));
  int missing = 0;
  for (int n = 1; n < steps; ++n)
  {
    const double part = double(n) / steps;
    const std::int64_t column = NearestColumn(heights.Grid(), { from.X + part * x, from.Y + part * y });
    assert(column >= 0);
    missing += std::isnan(heights[column]) ? 1 : 0;
  }
  return 2 * missing >= steps - 1;
}

/// Returns the sum of turns at both ends, or a large angle if the ends do not match.
double TurnBetween(const ColumnHeights& heights, const LineEnd& a, const LineEnd& b)
{
  constexpr double none = 10.0;
  const double x = b.Place.X - a.Place.X;
  const double y = b.Place.Y - a.Place.Y;
  const double length = std::hypot(x, y);
  const double throwBeyond = -b.LeftThrow;
  const double ratio = throwBeyond / a.LeftThrow;
  if (length == 0.0 || length > 2.0 * a.Reach || length > 2.0 * b.Reach ||
    !(ratio >= 1.0 / LargestRatio && ratio <= LargestRatio))
  {
    return none;
  }
  const auto angleOf = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
  const double atA = angleOf((a.Direction.X * x + a.Direction.Y * y) / length);
  const double atB = angleOf(-(b.Direction.X * x + b.Direction.Y * y) / length);
  return atA > LargestTurn || atB > LargestTurn || !IsMostlyMissing(heights, a.Place, x, y, length) ? none : atA + atB;
}

std::vector<LineEnd> FindEnds(const ColumnHeights& heights, const FaultLines& lines)
{
  std::vector<LineEnd> ends;
  for (std::size_t n = 0; n < 2 * lines.Size(); ++n)
  {
    const LineEnd end = MeasureEnd(heights, lines, n / 2, n % 2 == 0);
    if (end.Reach > 0.0)
    {
      ends.push_back(end);
    }
  }
  std::stable_sort(ends.begin(), ends.end(), [](const LineEnd& a, const LineEnd& b) { return a.Place.X < b.Place.X; });
  return ends;
}

std::vector<EndPair> FindPairs(const ColumnHeights& heights, const std::vector<LineEnd>& ends)
{
  std::vector<EndPair> pairs;
  for (std::size_t first = 0; first < ends.size(); ++first)
  {
    for (std::size_t second = first + 1;
         second < ends.size() && ends[second].Place.X - ends[first].Place.X <= 2.0 * ends[first].Reach; ++second)
    {
      const double turn = TurnBetween(heights, ends[first], ends[second]);
      if (turn <= 2.0 * LargestTurn)
      {
        pairs.push_back({ turn, first, second });
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const EndPair& a, const EndPair& b) { return a.Turn < b.Turn; });
  return pairs;
}

/// A cubic leaves both ends in their directions.
FaultPolyline Bend(const LineEnd& from, const LineEnd& to)
{
  const double length = std::hypot(to.Smooth.X - from.Smooth.X, to.Smooth.Y - from.Smooth.Y);
  const int parts = std::max(1, int(std::ceil(length)));
  // The line starts just outside the last link, which is cut already.
  constexpr double outside = 1e-3;
  const auto start = [](const LineEnd& end) {
    return MapPlace{ end.Place.X + outside * end.Direction.X, end.Place.Y + outside * end.Direction.Y };
  };
  FaultPolyline line = { start(from) };
  for (int n = 1; n < parts; ++n)
  {
    const double t = double(n) / parts;
    const double u = 1.0 - t;
    const double first = u * u * (1.0 + 2.0 * t);
    const double last = t * t * (1.0 + 2.0 * u);
    const double out = u * u * t * length;
    const double in = u * t * t * length;
    line.push_back({ first * from.Smooth.X + last * to.Smooth.X + out * from.Direction.X + in * to.Direction.X,
      first * from.Smooth.Y + last * to.Smooth.Y + out * from.Direction.Y + in * to.Direction.Y });
  }
  line.push_back(start(to));
  return line;
}

FaultLines Join(const ColumnHeights& heights, const LineEnd& from, const LineEnd& to)
{
  const FaultLines path = CutAlong(heights, { Bend(from, to) });
  FaultLines joined;
  const double links = double(path.NumberOfLinks());
  for (std::size_t n = 0; n < path.NumberOfLinks(); ++n)
  {
    FaultedLink cut = path[n];
    if (std::isnan(cut.Throw))
    {
      const double part = (double(n) + 0.5) / links;
      const double left = (1.0 - part) * from.LeftThrow - part * to.LeftThrow;
      cut.Throw = IsLeftBeyond(cut.Place.Side, cut.IsForward) ? left : -left;
      cut.Middle = (1.0 - part) * from.Height + part * to.Height;
    }
    joined.Append(cut);
  }
  joined.Close();
  return joined;
}

/// Appends a curved line for each pair; at least half of its columns are missing. Throws and heights are
/// interpolated there. Each end is joined once, straightest pairs first.
void JoinThroughHoles(const ColumnHeights& heights, FaultLines& lines)
{
  const std::vector<LineEnd> ends = FindEnds(heights, lines);
  std::vector<bool> isJoined(ends.size(), false);
  FaultLines joins;
  for (const EndPair& pair : FindPairs(heights, ends))
  {
    if (!isJoined[pair.First] && !isJoined[pair.Second])
    {
      isJoined[pair.First] = true;
      isJoined[pair.Second] = true;
      joins.Append(Join(heights, ends[pair.First], ends[pair.Second]));
    }
  }
  lines.Append(joins);
}

// ---- Deviations -----------------------------------------------------------------------------------------------------

static_assert(WindowReach + 1 < ColumnHeights::Margin);

void LoadDifferences(const ColumnHeights& heights, LinkSide side, std::int64_t y, float* row)
{
  const LinkGrid& raster = heights.Raster();
  const bool isEast = side == LinkSide::East;
  std::fill(row, row + raster.Width(), std::numeric_limits<float>::quiet_NaN());
  if (y < 0 || y + (isEast ? 0 : 1) >= raster.Height())
  {
    return;
  }
  const double* const before = heights.Row(y);
  const double* const beyond = isEast ? before + 1 : heights.Row(y + 1);
  for (std::int64_t x = 0; x < raster.Width() - (isEast ? 1 : 0); ++x)
  {
    row[x] = float(beyond[x] - before[x]);
  }
}

/// East and north links alternate in `deviations`, which are found for rows `first` to before `last`.
void FindDeviationsOfRows(
  const ColumnHeights& heights, LinkSide side, std::int64_t first, std::int64_t last, RawVector<float>& deviations)
{
  const std::int64_t width = heights.Raster().Width();
  std::vector<float> ring(WindowSide * width);
  const auto rowAt = [&](std::int64_t y) { return ring.data() + (y + WindowSide) % WindowSide * width; };
  for (std::int64_t y = first - WindowReach; y < first + WindowReach; ++y)
  {
    LoadDifferences(heights, side, y, rowAt(y));
  }
  std::vector<float> medians(std::size_t(width), 0.0F);
  for (std::int64_t y = first; y < last; ++y)
  {
    LoadDifferences(heights, side, y + WindowReach, rowAt(y + WindowReach));
    std::array<const float*, WindowSide> rows;
    for (std::int64_t n = 0; n < WindowSide; ++n)
    {
      rows[n] = rowAt(y - WindowReach + n);
    }
    FindWindowMedians(rows, width, medians.data());
    float* const deviationsOfRow = deviations.data() + heights.Raster().LinkOf(0, y, side);
    for (std::int64_t x = 0; x < width; ++x)
    {
      deviationsOfRow[2 * x] = rows[WindowReach][x] - medians[x];
    }
  }
}

/// The result is by link of the raster, or NaN.
RawVector<float> FindDeviations(const ColumnHeights& heights, const Monitor& monitor)
{
  const LinkGrid& raster = heights.Raster();
  RawVector<float> deviations;
  deviations.resize(raster.NumberOfLinks());
  constexpr std::int64_t Grain = 65536;
  const std::int64_t rows = std::max<std::int64_t>(2 * WindowReach, Grain / raster.Width());
  ParallelFor(raster.Height(), rows, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (const LinkSide side : { LinkSide::East, LinkSide::North })
      {
        FindDeviationsOfRows(heights, side, first, last, deviations);
      }
    });
  return deviations;
}

// ---- Noise ----------------------------------------------------------------------------------------------------------

// For normal noise, the median and the mean of sizes give the standard deviation by these factors.
constexpr double DeviationPerMedian = 1.4826;
constexpr double DeviationPerMean = 1.2533;
// Rounding to integers gives differences a standard deviation of the square root of 2 / 12.
constexpr double WholeFloor = 0.408;
constexpr double RealFloor = 0.02;

/// Each integer is spread from half below to half above it, so that the median varies continuously.
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

/// The sampled position in each group follows the golden ratio (Knuth, 6.4), so that periodic noise, such as an
/// acquisition footprint, is sampled evenly. Only values count, so that omitted rows have no effect.
std::vector<float> SampleSizes(const RawVector<float>& deviations, LinkSide side)
{
  constexpr std::int64_t enough = 1000000;
  std::int64_t known = 0;
  for (std::size_t n = std::size_t(side); n < deviations.size(); n += 2)
  {
    known += std::isnan(deviations[n]) ? 0 : 1;
  }
  const std::int64_t groupSize = std::max<std::int64_t>(1, known / enough);
  std::vector<float> sizes;
  sizes.reserve(std::size_t(known / groupSize + 1));
  std::uint64_t fraction = 0;
  std::int64_t left = 0;
  std::int64_t chosen = 0;
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

/// Integer heights have a grouped median and at least the noise of rounding. Otherwise, if the median is nearly zero,
/// as in smoothed or rounded data, the mean of small sizes is used.
double NoiseOfDifferences(const ColumnHeights& heights, std::vector<float> sizes)
{
  const double floor = heights.AreWhole() ? WholeFloor : RealFloor;
  if (sizes.empty())
  {
    return floor;
  }
  const float median = UpperMedian(sizes);
  if (heights.AreWhole())
  {
    return std::max(floor, DeviationPerMedian * GroupedMedian(sizes, std::round(median)));
  }
  const double noise = DeviationPerMedian * double(median);
  return noise >= floor ? noise : std::max(floor, DeviationPerMean * ClippedMean(sizes, 4.0 * floor));
}

/// One direction alone counts if it is much rougher: heights interpolated between lines are smooth along one axis.
double NoiseOfDifferences(const ColumnHeights& heights, const RawVector<float>& deviations)
{
  constexpr double Rougher = 1.5;
  std::vector<float> east = SampleSizes(deviations, LinkSide::East);
  std::vector<float> north = SampleSizes(deviations, LinkSide::North);
  const double noiseEast = NoiseOfDifferences(heights, east);
  const double noiseNorth = NoiseOfDifferences(heights, north);
  const double larger = std::max(noiseEast, noiseNorth);
  // Rounding of an integer dip differs between the axes.
  if (larger > Rougher * std::min(noiseEast, noiseNorth) && (!heights.AreWhole() || larger > 2.0 * WholeFloor))
  {
    return larger;
  }
  east.insert(east.end(), north.begin(), north.end());
  return NoiseOfDifferences(heights, std::move(east));
}

/// Means of many columns reduce white noise to 0.46 of the noise of differences; noise common to rows, and folds, leave
/// more.
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
  return std::max(ofWhite, DeviationPerMedian * double(UpperMedian(sizes)));
}

// ---- Candidates -----------------------------------------------------------------------------------------------------

// By noise alone about 1 % of links are candidates, and hardly any are strong. The unit is the standard deviation.
constexpr double LowFactor = 2.5;
constexpr double HighFactor = 4.0;
constexpr double GapFactor = 3.0; // Extended planes vary more than differences.
constexpr int FewestStrong = 5;
// Rounding to integers creates steps of 1, but not of 2.
constexpr double LeastWholeStep = 1.5;

std::vector<FaultCandidate> FindSteep(
  const ColumnHeights& heights, const RawVector<float>& deviations, double low, double high, const Monitor& monitor)
{
  constexpr std::int64_t ChunkSize = 1 << 18;
  return CollectChunks<FaultCandidate>(std::int64_t(deviations.size()), ChunkSize, monitor,
    [&](std::vector<FaultCandidate>& candidates, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t link = first; link < last; ++link)
      {
        const float size = std::abs(deviations[link]);
        if (double(size) >= low) // false for NaN
        {
          candidates.push_back({ heights.ToGrid(link), size, double(size) >= high });
        }
      }
    });
}

// ---- Bands of missing columns ---------------------------------------------------------------------------------------

/// Throw is the plane beyond the band minus the plane before, Height their mean.
struct GapStep
{
  std::int64_t First = 0;
  std::int64_t Middle = 0;
  std::int64_t Last = 0;
  double Throw = 0.0;
  double Height = 0.0;
};

// A plane is fitted to this number of columns along the line, and to each side across it.
constexpr std::int64_t Along = 4;
constexpr std::int64_t Across = 1;
constexpr int FewestFitted = 6;
static_assert(Along < ColumnHeights::Margin);

/// The plane through columns from `first` on is evaluated `distance` before the first. The result is NaN with too few
/// columns, or with columns in a line.
double ExtendPlane(const ColumnHeights& heights, const Lanes& lanes, std::int64_t lane, std::int64_t first,
  std::int64_t step, double distance)
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  int points = 0;
  for (std::int64_t n = 0; n < Along; ++n)
  {
    const std::int64_t along = first + n * step;
    for (std::int64_t across = -Across; across <= Across; ++across)
    {
      const bool isInside =
        along >= 0 && along < lanes.Length() && lane + across >= 0 && lane + across < lanes.Number();
      const double height = isInside ? heights.At(lanes.Column(along, lane + across)) : NoValue;
      if (!std::isnan(height))
      {
        const Eigen::Vector3d row(1.0, double(step) * (distance + double(n)), double(across));
        matrix += row * row.transpose();
        right += row * height;
        ++points;
      }
    }
  }
  // The values are multiples of one half, so that the determinant for points in a line is rounding alone.
  constexpr double Nothing = 1e-6;
  return points < FewestFitted || matrix.determinant() < Nothing ? NoValue : matrix.ldlt().solve(right)[0];
}

void FindStepsInLane(const ColumnHeights& heights, const Lanes& lanes, std::int64_t lane, int longest, double smallest,
  std::vector<GapStep>& steps)
{
  const Lanes gridLanes{ heights.Grid(), lanes.Side };
  const auto toGrid = [&](std::int64_t along)
  { return LinkGrid::FirstColumn(heights.ToGrid(lanes.Link(along, lane))); };
  std::int64_t before = -1;
  for (std::int64_t along = 0; along < lanes.Length(); ++along)
  {
    if (std::isnan(heights.At(lanes.Column(along, lane))))
    {
      continue;
    }
    if (before >= 0 && along - before > 1)
    {
      const std::int64_t gridLane = gridLanes.LaneOf(toGrid(along));
      const std::int64_t gridBefore = gridLanes.AlongOf(toGrid(before));
      const std::int64_t gridAlong = gridLanes.AlongOf(toGrid(along));
      if (gridAlong - gridBefore - 1 <= longest)
      {
        const double half = 0.5 * double(gridAlong - gridBefore);
        const double low = ExtendPlane(heights, lanes, lane, before, -1, half);
        const double high = ExtendPlane(heights, lanes, lane, along, 1, half);
        if (std::abs(high - low) >= smallest)
        {
          steps.push_back(
            { gridLanes.Link(gridBefore, gridLane), gridLanes.Link((gridBefore + gridAlong) / 2, gridLane),
              gridLanes.Link(gridAlong - 1, gridLane), high - low, 0.5 * (low + high) });
        }
      }
    }
    before = along;
  }
}

std::vector<GapStep> FindGapSteps(const ColumnHeights& heights, int longest, double smallest, const Monitor& monitor)
{
  constexpr std::int64_t lanesPerChunk = 16;
  std::vector<GapStep> all;
  for (const LinkSide side : { LinkSide::East, LinkSide::North })
  {
    const Lanes lanes{ heights.Raster(), side };
    const std::vector<GapStep> steps = CollectChunks<GapStep>(lanes.Number(), lanesPerChunk, monitor,
      [&](std::vector<GapStep>& part, std::int64_t first, std::int64_t last)
      {
        for (std::int64_t lane = first; lane < last; ++lane)
        {
          FindStepsInLane(heights, lanes, lane, longest, smallest, part);
        }
      });
    all.insert(all.end(), steps.begin(), steps.end());
  }
  std::sort(all.begin(), all.end(), [](const GapStep& a, const GapStep& b) { return a.Middle < b.Middle; });
  return all;
}

/// Links beside the band join its cut to candidates of the next line:
///
///    o   o   o   .   o      The fault is cut at a above, and in the band below at g. The links between the rows, at
///      a-----+              two columns, join both.
///    o   .   . g .   o
void JoinBesideGap(const LinkGrid& grid, const GapStep& gap, const std::vector<FaultCandidate>& candidates,
  std::vector<FaultCandidate>& joints)
{
  assert(gap.First <= gap.Middle && gap.Middle <= gap.Last);
  assert(LinkGrid::SideOf(gap.First) == LinkGrid::SideOf(gap.Middle));
  const Lanes lanes{ grid, LinkGrid::SideOf(gap.Middle) };
  const std::int64_t lane = lanes.LaneOf(LinkGrid::FirstColumn(gap.Middle));
  const std::int64_t middle = lanes.AlongOf(LinkGrid::FirstColumn(gap.Middle));
  const std::int64_t last = lanes.AlongOf(LinkGrid::FirstColumn(gap.Last));
  for (const std::int64_t next : { lane - 1, lane + 1 })
  {
    if (next < 0 || next >= lanes.Number())
    {
      continue;
    }
    for (std::int64_t target = lanes.AlongOf(LinkGrid::FirstColumn(gap.First)); target <= last; ++target)
    {
      const bool isNear =
        std::binary_search(candidates.begin(), candidates.end(), FaultCandidate{ lanes.Link(target, next) });
      for (std::int64_t along = std::min(middle, target) + 1; isNear && along <= std::max(middle, target); ++along)
      {
        joints.push_back({ lanes.Across(along, std::min(lane, next)), 0.0F, false });
      }
    }
  }
}

std::vector<FaultCandidate> AddGaps(
  const LinkGrid& grid, std::vector<FaultCandidate> candidates, const std::vector<GapStep>& gaps, double high)
{
  for (const GapStep& gap : gaps)
  {
    candidates.push_back({ gap.Middle, float(std::abs(gap.Throw)), std::abs(gap.Throw) >= high });
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<FaultCandidate> joints;
  for (const GapStep& gap : gaps)
  {
    JoinBesideGap(grid, gap, candidates, joints);
  }
  AddCandidates(candidates, joints);
  return candidates;
}

// ---- Lines ----------------------------------------------------------------------------------------------------------

FaultedLink MeasureLink(const ColumnHeights& heights, const std::vector<GapStep>& gaps,
  const std::vector<LinkThrow>& ramps, std::int64_t link, bool isForward)
{
  FaultedLink cut = MeasureCut(heights, link, isForward);
  const auto gap = std::lower_bound(
    gaps.begin(), gaps.end(), link, [](const GapStep& step, std::int64_t place) { return step.Middle < place; });
  if (gap != gaps.end() && gap->Middle == link)
  {
    cut.Throw = gap->Throw;
    cut.Middle = gap->Height;
  }
  const auto ramp = std::lower_bound(
    ramps.begin(), ramps.end(), link, [](const LinkThrow& step, std::int64_t place) { return step.Link < place; });
  // A crack through a ramp keeps its own, larger throw.
  if (ramp != ramps.end() && ramp->Link == link && !(std::abs(cut.Throw) > std::abs(ramp->Throw)))
  {
    cut.Throw = ramp->Throw;
  }
  return cut;
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
double ThrowAboveNoise(PlanePoints columns, const std::vector<double>& heights, double noiseOfDifferences)
{
  constexpr double factor = 8.0;
  // Differences of heights have sqrt(2) times the noise of heights.
  return factor * (noiseOfDifferences > 0.0 ? noiseOfDifferences / std::sqrt(2.0) : MeasureNoise(columns, heights));
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
  for (const std::vector<ForestStep>& line : ListLines(graph))
  {
    for (const ForestStep& step : line)
    {
      detection.Lines.Append(MeasureLink(heights, gaps, ramps, graph.Edge(step.Edge).Link, step.IsForward));
    }
    detection.Lines.Close();
  }
  if (options.JoinThroughHoles)
  {
    JoinThroughHoles(heights, detection.Lines);
  }
  return detection;
}
}
