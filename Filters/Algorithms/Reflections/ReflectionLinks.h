// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Links between picks of neighbouring columns that look alike: pairs of which each is the best the other has there. And
// how much alike two parts of surfaces look.

#ifndef SeismicHorizonsReflectionLinks_h
#define SeismicHorizonsReflectionLinks_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "ReflectionFinder.h"
#include "TraceCube.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Which columns are neighbours: those beside each other along i and j, or the diagonal ones too.
enum class ColumnConnectivity
{
  Four = 4,
  Eight = 8
};

/// A step to a neighbouring column.
struct ColumnStep
{
  int I = 0;
  int J = 0;
};

/// The first two, or all of them, lead to half of the neighbours of a column; the opposite ones to the other half.
constexpr std::array<ColumnStep, 4> NeighbourSteps = { { { 1, 0 }, { 0, 1 }, { 1, 1 }, { -1, 1 } } };

struct LinkOptions
{
  ColumnConnectivity Connectivity = ColumnConnectivity::Four;
  Depth LargestStep = 2 * DepthsPerSample; // from a pick to the one it is linked with
  int HalfWidth = 25; // of the waveforms, in samples
};

/// A link from a pick along one of the steps.
using LinkId = std::uint32_t;

class ReflectionLinks
{
public:
  /// Links the picks of a sign. Of several pairs as good, that of the upper picks is the best.
  ReflectionLinks(const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options,
    const Monitor& monitor = Monitor());

  int Directions() const { return int(this->Correlations.size()); }

  /// The pick that a pick is linked with along a step, or against it; NoPoint without one.
  PointId Next(PointId pick, int direction) const { return this->Partners[this->PlaceOf(pick, direction)]; }
  PointId Previous(PointId pick, int direction) const { return this->Partners[this->PlaceOf(pick, direction) + 1]; }

  /// Calls visit(other, owner, direction) for the links of a pick, which lead to another from their owner on, along the
  /// step: the pick itself, or the other.
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

  /// Calls visit(pick, direction) for all links, in the order of their numbers.
  template <typename Visit>
  void ForEach(Visit&& visit) const
  {
    for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
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

  /// The correlation of a link, -1 to 1.
  double Correlation(PointId pick, int direction) const { return this->Rounded(pick, direction) / LargestRounded; }

  /// What links are joined by, the best first: the correlation, less 0.05 for each sample of the step between them.
  double Score(PointId pick, int direction) const;

  /// The better the score, the lower; below 2^16. Scores are told apart by 2e-5.
  std::int64_t Rank(PointId pick, int direction) const;

  LinkId MakeId(PointId pick, int direction) const
  {
    assert(direction < this->Directions());
    return LinkId(pick) * LinkId(this->Directions()) + LinkId(direction);
  }
  PointId PickOf(LinkId link) const { return PointId(link / LinkId(this->Directions())); }
  int DirectionOf(LinkId link) const { return int(link % LinkId(this->Directions())); }

  std::int64_t Size() const;
  /// Of the correlations of all links; 0 without any.
  double MedianCorrelation() const;
  /// Drops links of less correlation, and those of picks of which one is much stronger.
  void Drop(double smallestCorrelation);

private:
  // Correlations are kept in 16 bits.
  static constexpr double LargestRounded = 32767.0;
  std::int16_t Rounded(PointId pick, int direction) const { return this->Correlations[direction][pick]; }

  bool AreOfLikeStrength(PointId a, PointId b) const;

  std::size_t PlaceOf(PointId pick, int direction) const
  {
    return 2 * (std::size_t(pick) * this->Correlations.size() + direction);
  }

  class RowLinker;

  const ReflectionPicks& Picks;
  RawVector<PointId> Partners; // by pick, then by direction: along the step, and against it
  std::vector<RawVector<std::int16_t>> Correlations; // by direction, then by pick
};

/// How much alike two parts look along their contact, -1 to 1: the correlation of the mean waveform of the picks that
/// the pairs come from with that of the picks they lead to. Noise cancels out in means.
using ContactCorrelation = std::function<double(std::vector<Edge> pairs)>;

/// Of about 64 of the pairs, spread over all of them. For one thread.
ContactCorrelation MakeContactCorrelation(const TraceCube& cube, const ReflectionPicks& picks, int halfWidth);
}

#endif
