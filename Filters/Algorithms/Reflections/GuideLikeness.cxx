// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Columns learn from their neighbours which given picks are near, in two passes, as distances do.

#include "GuideLikeness.h"

#include "ReflectionLinks.h"
#include "WaveformCutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t NoGiven = -1;

/// The nearest given picks of a column, nearest first.
using NearestGiven = std::array<std::int32_t, 3>;

/// Sets the cutter to the trace of the pick.
void CutOut(const TraceCube& cube, const ReflectionPicks& picks, PointId pick, WaveformCutter& cutter,
  std::vector<float>& trace, std::int16_t* waveform)
{
  const std::int32_t column = picks.ColumnOf(pick);
  cube.Read(picks.JOf(column), picks.IOf(column), 1, trace.data());
  cutter.SetTrace(trace.data(), cube.Size[2]);
  cutter.CutOut(picks.Places[pick], waveform);
}

class GivenPicks
{
public:
  GivenPicks(const TraceCube& cube, const ReflectionPicks& picks, const std::vector<PointId>& given, int halfWidth)
    : Cube(cube)
    , Picks(picks)
    , Given(given)
    , Cutter(halfWidth)
    , Waveforms(given.size() * this->Cutter.Width())
    , Waveform(this->Cutter.Width())
  {
    std::vector<float> trace(cube.Size[2]);
    for (std::size_t n = 0; n < given.size(); ++n)
    {
      this->Columns.push_back(picks.ColumnOf(given[n]));
      CutOut(cube, picks, given[n], this->Cutter, trace, this->WaveformOf(n));
    }
    this->FindNearest();
  }

  void Compare(const std::vector<VoteSide>& sides, std::vector<Candidates>& columns)
  {
    std::vector<float> block;
    for (int j = 0; j < this->Cube.Size[1]; ++j)
    {
      ForEachTrace(this->Cube, j, block,
        [&](int i, const float* trace)
        {
          const std::int64_t column = this->Picks.ColumnAt(i, j);
          Candidates& candidates = columns[column];
          if (candidates[0].Pick == NoPoint && candidates[1].Pick == NoPoint)
          {
            return;
          }
          this->Cutter.SetTrace(trace, this->Cube.Size[2]);
          for (const VoteSide side : sides)
          {
            this->Compare(this->Nearest[column], candidates[int(side)]);
          }
        });
    }
  }

private:
  std::int16_t* WaveformOf(std::size_t given) { return this->Waveforms.data() + given * this->Cutter.Width(); }

  void Compare(const NearestGiven& nearest, Candidate& candidate)
  {
    if (candidate.Pick == NoPoint)
    {
      return;
    }
    this->Cutter.CutOut(this->Picks.Places[candidate.Pick], this->Waveform.data());
    std::int32_t best = -WaveformCutter::One;
    for (const std::int32_t given : nearest)
    {
      if (given != NoGiven)
      {
        best = std::max(best, this->Cutter.Correlate(this->Waveform.data(), this->WaveformOf(given)));
      }
    }
    candidate.Likeness = float(best) / float(WaveformCutter::One);
    candidate.Contrast =
      std::abs(std::log(this->Picks.StrengthOf(candidate.Pick) / this->Picks.StrengthOf(this->Given[nearest.front()])));
  }

  std::int64_t SquaredDistance(std::int64_t column, std::int32_t given) const
  {
    const auto at = std::int32_t(column);
    const std::int64_t i = this->Picks.IOf(at) - this->Picks.IOf(this->Columns[given]);
    const std::int64_t j = this->Picks.JOf(at) - this->Picks.JOf(this->Columns[given]);
    return i * i + j * j;
  }

  void Learn(std::int64_t column, std::int32_t given)
  {
    NearestGiven& nearest = this->Nearest[column];
    for (std::int32_t& place : nearest)
    {
      if (place == given || given == NoGiven)
      {
        return;
      }
      const std::int64_t distance = place == NoGiven ? 0 : this->SquaredDistance(column, place);
      const std::int64_t own = this->SquaredDistance(column, given);
      if (place == NoGiven || own < distance || (own == distance && given < place))
      {
        std::swap(place, given);
      }
    }
  }

  void FindNearest()
  {
    this->Nearest.assign(this->Picks.Starts.size() - 1, { NoGiven, NoGiven, NoGiven });
    for (std::size_t n = 0; n < this->Columns.size(); ++n)
    {
      this->Learn(this->Columns[n], std::int32_t(n));
    }
    const auto last = std::int32_t(this->Nearest.size()) - 1;
    for (const bool isBack : { false, true })
    {
      for (std::int32_t n = 0; n <= last; ++n)
      {
        const std::int32_t column = isBack ? last - n : n;
        ForEachNeighbour(this->Picks, column, ColumnConnectivity::Eight,
          [&](std::int64_t next)
          {
            for (const std::int32_t given : NearestGiven(this->Nearest[next]))
            {
              this->Learn(column, given);
            }
          });
      }
    }
  }

  const TraceCube& Cube;
  const ReflectionPicks& Picks;
  const std::vector<PointId>& Given;
  WaveformCutter Cutter;
  std::vector<std::int16_t> Waveforms; // of given picks
  std::vector<std::int16_t> Waveform;
  std::vector<std::int32_t> Columns; // of given picks
  std::vector<NearestGiven> Nearest; // by column
};

// Half the width of waveforms across jumps, in quarters of the period, is that of long waveforms.
constexpr int QuartersAcrossJump = 14;

// Beside a fault the surface may jump some columns too early, or late, as growth from both sides meets in its gap.
constexpr int ColumnsBesideJump = 4;

class JumpWaveforms
{
public:
  JumpWaveforms(const TraceCube& cube, const ReflectionPicks& picks, PickDepth quarter)
    : Cube(cube)
    , Picks(picks)
    , Quarter(quarter)
    , Cutter(std::max(1, NearestSample(QuartersAcrossJump * quarter)))
    , Trace(cube.Size[2])
  {
  }

  /// Picks are of the surface, on both sides of a jump.
  bool IsSeam(PointId a, PointId b)
  {
    const Waveform onA = this->Cut(a);
    const Waveform onB = this->Cut(b);
    const std::int32_t straight = this->MostAlike(onA, b, a) / 2 + this->MostAlike(onB, a, b) / 2;
    return straight > this->Cutter.Correlate(onA.data(), onB.data());
  }

private:
  using Waveform = std::vector<std::int16_t>;

  Waveform Cut(PointId pick)
  {
    Waveform waveform(this->Cutter.Width());
    CutOut(this->Cube, this->Picks, pick, this->Cutter, this->Trace, waveform.data());
    return waveform;
  }

  /// Returns the largest correlation with picks in the column of one pick, at about the place of the other.
  std::int32_t MostAlike(const Waveform& waveform, PointId one, PointId other)
  {
    const std::int32_t column = this->Picks.ColumnOf(one);
    std::int32_t most = 0;
    for (PointId pick = this->Picks.Begin(column); pick < this->Picks.End(column); ++pick)
    {
      if (std::abs(this->Picks.Places[pick] - this->Picks.Places[other]) <= 2 * this->Quarter)
      {
        most = std::max(most, this->Cutter.Correlate(waveform.data(), this->Cut(pick).data()));
      }
    }
    return most;
  }

  const TraceCube& Cube;
  const ReflectionPicks& Picks;
  const PickDepth Quarter;
  WaveformCutter Cutter;
  std::vector<float> Trace;
};
}

//----------------------------------------------------------------------------------------------------------------------
void CompareWithGiven(const TraceCube& cube, const ReflectionPicks& picks, const std::vector<PointId>& given,
  int halfWidth, const std::vector<VoteSide>& sides, std::vector<Candidates>& columns)
{
  GivenPicks(cube, picks, given, halfWidth).Compare(sides, columns);
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t CountSeams(
  const TraceCube& cube, const ReflectionPicks& picks, const std::vector<PointId>& surface, PickDepth quarter)
{
  JumpWaveforms waveforms(cube, picks, quarter);
  const auto place = [&](std::int64_t column) { return picks.Places[surface[column]]; };
  std::int64_t seams = 0;
  const std::array<int, 2> size = picks.Columns;
  for (const int axis : { 0, 1 })
  {
    const std::int64_t step = axis == 0 ? 1 : size[0];
    for (std::int64_t column = 0; column < std::int64_t(surface.size()) - step; ++column)
    {
      const int along = axis == 0 ? picks.IOf(std::int32_t(column)) : picks.JOf(std::int32_t(column));
      if (along + 1 == size[axis] || surface[column] == NoPoint || surface[column + step] == NoPoint ||
        std::abs(place(column + step) - place(column)) <= 2 * quarter)
      {
        continue;
      }
      std::int64_t first = column;
      std::int64_t last = column + step;
      for (int n = 1; n <= ColumnsBesideJump; ++n)
      {
        first = along - n >= 0 && surface[first - step] != NoPoint ? first - step : first;
        last = along + 1 + n < size[axis] && surface[last + step] != NoPoint ? last + step : last;
      }
      seams += waveforms.IsSeam(surface[first], surface[last]) ? 1 : 0;
    }
  }
  return seams;
}
}
