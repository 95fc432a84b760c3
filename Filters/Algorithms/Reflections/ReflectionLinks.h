// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Links picks of neighbouring columns if each is the best match of the other, and compares parts of surfaces.

#ifndef SeismicHorizonsReflectionLinks_h
#define SeismicHorizonsReflectionLinks_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "ReflectionFinder.h"
#include "TraceCube.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Eight includes diagonal neighbours.
enum class ColumnConnectivity
{
  Four = 4,
  Eight = 8
};

struct ColumnStep
{
  int I = 0;
  int J = 0;
};

/// The first two, or all, lead to half of the neighbours; their opposites to the rest.
constexpr std::array<ColumnStep, 4> TraceSteps = { { { 1, 0 }, { 0, 1 }, { 1, 1 }, { -1, 1 } } };

/// Calls visit(column) with those beside a column, inside of the survey.
template <typename Visit>
void ForEachNeighbour(const ReflectionPicks& picks, std::int32_t column, ColumnConnectivity connectivity, Visit&& visit)
{
  const int i = picks.IOf(column);
  const int j = picks.JOf(column);
  for (int direction = 0; direction < int(connectivity) / 2; ++direction)
  {
    for (const int sign : { 1, -1 })
    {
      const int nextI = i + sign * TraceSteps[direction].I;
      const int nextJ = j + sign * TraceSteps[direction].J;
      if (nextI >= 0 && nextI < picks.Columns[0] && nextJ >= 0 && nextJ < picks.Columns[1])
      {
        visit(picks.ColumnAt(nextI, nextJ));
      }
    }
  }
}

/// The half width, in dominant periods, of waveforms that distinguish layers.
constexpr double LongWaveform = 3.5;

/// In samples.
inline int HalfWidth(double periods, double period)
{
  return std::max(1, int(std::lround(periods * period)));
}

struct LinkOptions
{
  ColumnConnectivity Connectivity = ColumnConnectivity::Four;
  PickDepth LargestStep = 2 * DepthsPerSample; // from pick to pick
  int HalfWidth = 25; // of waveforms, in samples
};

using LinkId = std::uint32_t;

class ReflectionLinks
{
public:
  /// The upper picks win ties.
  ReflectionLinks(const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options,
    const Monitor& monitor = Monitor());

  PointId Size() const { return this->Picks.Size(); }
  int Directions() const { return int(this->Correlations.size()); }

  /// Both return NoPoint without a link.
  PointId Next(PointId pick, int direction) const { return this->Partners[this->PlaceOf(pick, direction)]; }
  PointId Previous(PointId pick, int direction) const { return this->Partners[this->PlaceOf(pick, direction) + 1]; }

  /// Calls visit(other, owner, direction): links lead along the step from their owner, the pick or the other.
  template <typename Visit>
  void ForEachOf(PointId pick, Visit&& visit) const
  {
    for (int direction = 0; direction < this->Directions(); ++direction)
    {
      if (const PointId next = this->Next(pick, direction); next != NoPoint)
      {
        visit(next, pick, direction);
      }
      if (const PointId previous = this->Previous(pick, direction); previous != NoPoint)
      {
        visit(previous, previous, direction);
      }
    }
  }

  template <typename Visit>
  void ForEach(PointId first, PointId last, Visit&& visit) const
  {
    for (PointId pick = first; pick < last; ++pick)
    {
      for (int direction = 0; direction < this->Directions(); ++direction)
      {
        if (this->Next(pick, direction) != NoPoint)
        {
          visit(pick, direction);
        }
      }
    }
  }

  double Correlation(PointId pick, int direction) const { return this->Rounded(pick, direction) / LargestRounded; }

  double Score(PointId pick, int direction) const;

  /// Ranks fall with the score, in steps of 2e-5, and are below 2^16.
  std::int64_t Rank(PointId pick, int direction) const;

  LinkId MakeId(PointId pick, int direction) const
  {
    assert(direction < this->Directions());
    return LinkId(pick) * LinkId(this->Directions()) + LinkId(direction);
  }
  PointId PickOf(LinkId link) const { return PointId(link / LinkId(this->Directions())); }
  int DirectionOf(LinkId link) const { return int(link % LinkId(this->Directions())); }

  /// Returns 0 without links.
  double MedianCorrelation() const;
  /// Drops links between very different strengths, too.
  void Drop(double smallestCorrelation);

private:
  static constexpr double LargestRounded = 32767.0;
  std::int16_t Rounded(PointId pick, int direction) const { return this->Correlations[direction][pick]; }

  std::size_t PlaceOf(PointId pick, int direction) const
  {
    return 2 * (std::size_t(pick) * this->Correlations.size() + direction);
  }

  const ReflectionPicks& Picks;
  RawVector<PointId> Partners; // by pick, then direction: along the step, and against it
  std::vector<RawVector<std::int16_t>> Correlations; // by direction, then pick
};

/// The best match of each pick in each of the eight neighbouring columns, which may match another pick better: growth
/// from one side needs no more, as it takes free columns only.
class GrowthLinks
{
public:
  /// The options must be for diagonal neighbours.
  GrowthLinks(const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options,
    const Monitor& monitor = Monitor());

  /// Calls visit(other, correlation).
  template <typename Visit>
  void ForEachOf(PointId pick, Visit&& visit) const
  {
    for (std::size_t link = Neighbours * std::size_t(pick); link < Neighbours * (std::size_t(pick) + 1); ++link)
    {
      if (this->Partners[link] != NoPoint)
      {
        visit(this->Partners[link], this->Correlations[link] / LargestRounded);
      }
    }
  }

private:
  static constexpr std::size_t Neighbours = 2 * TraceSteps.size();
  static constexpr double LargestRounded = 32767.0;

  RawVector<PointId> Partners; // by pick, then neighbour
  RawVector<std::int16_t> Correlations;
};

/// Links are joined by correlation less 0.05 per sample of their step.
double LinkScore(double correlation, PickDepth step);

/// Picks whose strengths differ more are noise, or another reflection, beside the end of a strong one, as at a fault.
bool AreOfLikeStrength(const ReflectionPicks& picks, PointId a, PointId b);

/// Correlates mean waveforms of both sides of a contact, in which noise cancels out, -1 to 1.
using ContactCorrelation = std::function<double(std::vector<Edge> pairs)>;

/// About 64 pairs, spread over all, are compared. Threads may call it in parallel.
ContactCorrelation MakeContactCorrelation(const TraceCube& cube, const ReflectionPicks& picks, int halfWidth);
}

#endif
