// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Cutoffs.h"

#include "Common/Base/Parallel.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double Reach = 16.0; // columns of picks that a place may use, beyond the largest gap

std::array<FaultSide, 2> ListSides(const FaultPlate& fault, const OtherFaults& others, const HorizonPicks& horizon,
  const CutoffFitOptions& options, const Monitor& monitor)
{
  const double beyond = Reach * options.Row, farthest = (Reach + options.LargestGap) * options.Column;
  const double first = fault.First() - beyond, last = fault.Last() + beyond;
  const std::size_t size = horizon.Places.size(), part = std::size_t(Grain);
  std::vector<std::vector<SidePick>> empty((size + part - 1) / part);
  std::array<std::vector<std::vector<SidePick>>, 2> sides = { empty, empty };
  ParallelFor(std::int64_t(empty.size()), 1, monitor,
    [&](std::int64_t from, std::int64_t to)
    {
      for (std::size_t number = std::size_t(from) * part; number < std::min(std::size_t(to) * part, size); ++number)
      {
        const Eigen::Vector3d& world = horizon.Places[number];
        if (fault.Box().squaredExteriorDistance(world.head<2>()) > std::pow(beyond + farthest, 2))
        {
          continue;
        }
        SidePick pick;
        pick.Number = number;
        pick.Place = fault.ToPlace(world);
        if (pick.Place.S < first || pick.Place.S > last)
        {
          continue;
        }
        const double distance = fault.Distance(pick.Place);
        pick.Distance = std::abs(distance);
        if (pick.Distance <= farthest)
        {
          others.Mark(world, pick);
          sides[distance > 0.0 ? HangingWall : Footwall][number / part].push_back(pick);
        }
      }
    });
  return { FaultSide(first, last, options.Row, sides[Footwall]),
    FaultSide(first, last, options.Row, sides[HangingWall]) };
}

bool IsKnown(const CutoffPair& pair)
{
  return !std::isnan(pair.Wall[Footwall].Height) && !std::isnan(pair.Wall[HangingWall].Height);
}

double MiddleOf(const CutoffPair& pair)
{
  return 0.5 * (pair.Wall[Footwall].Height + pair.Wall[HangingWall].Height);
}

class CutoffFinder
{
public:
  CutoffFinder(const FaultPlate& fault, const OtherFaults& others, const std::array<FaultSide, 2>& sides,
    const CutoffFitOptions& options, double leastLength)
    : Fault(fault)
    , Others(others)
    , Sides(sides)
    , Options(options)
    , LeastLength(leastLength)
  {
  }

  HorizonCutoffs Find(const Monitor& monitor)
  {
    const double row = this->Options.Row;
    const auto count = std::size_t(std::floor((this->Fault.Last() - this->Fault.First()) / row)) + 1;
    const double shift = 0.5 * (this->Fault.Last() - this->Fault.First() - double(count - 1) * row);
    std::vector<CutoffPair> pairs(count);
    ParallelFor(std::int64_t(count), 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          pairs[std::size_t(n)] = this->PairAt(this->Fault.First() + shift + double(n) * row);
        }
      });
    this->FillGaps(pairs);
    HorizonCutoffs cutoffs;
    for (std::size_t n = 0; n < count;)
    {
      if (!this->IsCut(pairs[n]))
      {
        ++n;
        continue;
      }
      std::size_t end = n;
      while (end < count && this->IsCut(pairs[end]))
      {
        ++end;
      }
      CutoffPiece piece;
      piece.Pairs.assign(pairs.begin() + std::ptrdiff_t(n), pairs.begin() + std::ptrdiff_t(end));
      n = end;
      if (double(piece.Pairs.size()) < this->LeastLength)
      {
        ++cutoffs.Short;
        continue;
      }
      for (CutoffPair& pair : piece.Pairs)
      {
        for (const FaultWall wall : { Footwall, HangingWall })
        {
          const std::vector<std::size_t> dropped = std::move(pair.Wall[wall].Dropped);
          cutoffs.Dropped[wall].insert(cutoffs.Dropped[wall].end(), dropped.begin(), dropped.end());
        }
      }
      this->EndAtTips(piece);
      cutoffs.Pieces.push_back(std::move(piece));
    }
    return cutoffs;
  }

private:
  CutoffPair PairAt(double s) const
  {
    constexpr double nearEnough = 2.0; // columns
    CutoffPair pair;
    pair.S = s;
    pair.Wall = FitCutoffs(this->Fault, this->Others, this->Sides, s, this->Options);
    const bool isAtOther = IsKnown(pair) && this->MeetsOther(pair);
    for (const FaultWall wall : { Footwall, HangingWall })
    {
      pair.Source[wall] = pair.Wall[wall].Gap <= nearEnough && pair.Wall[wall].IsChecked && !isAtOther
        ? HeightSource::Picks
        : HeightSource::Extrapolated;
    }
    return pair;
  }

  bool IsCut(const CutoffPair& pair) const { return IsKnown(pair) && this->Fault.Contains(pair.S, MiddleOf(pair)); }

  void Interpolate(CutoffPair& pair, FaultWall wall, double height) const
  {
    CutoffPlace& place = pair.Wall[wall];
    place.Height = height;
    place.Offset = this->Fault.Offset(pair.S, height);
    pair.Source[wall] = HeightSource::Interpolated;
  }

  /// Places without picks are between those beside them, up to the largest gap.
  void FillGaps(std::vector<CutoffPair>& pairs) const
  {
    for (const FaultWall wall : { Footwall, HangingWall })
    {
      std::size_t last = pairs.size();
      for (std::size_t n = 0; n < pairs.size(); ++n)
      {
        if (std::isnan(pairs[n].Wall[wall].Height))
        {
          continue;
        }
        if (last < n && double(n - last) <= this->Options.LargestGap)
        {
          const double from = pairs[last].Wall[wall].Height, to = pairs[n].Wall[wall].Height;
          for (std::size_t between = last + 1; between < n; ++between)
          {
            this->Interpolate(pairs[between], wall, from + (to - from) * double(between - last) / double(n - last));
          }
        }
        last = n;
      }
    }
  }

  /// A fault that dies out inside the horizon ends both cutoffs in one place. Where the horizon itself ends, or another
  /// fault is, they stay open.
  void EndAtTips(CutoffPiece& piece) const
  {
    constexpr double beyond = 4.0; // columns
    for (const std::size_t end : { 0, 1 })
    {
      const CutoffPair last = end == 0 ? piece.Pairs.front() : piece.Pairs.back();
      const double sign = end == 0 ? -1.0 : 1.0;
      const double height = MiddleOf(last);
      const CutoffPair next = this->PairAt(last.S + sign * beyond * this->Options.Row);
      const bool isInside = this->Fault.Contains(last.S + sign * this->Options.Row, height);
      if (!IsKnown(next) || isInside || this->MeetsOther(last))
      {
        continue;
      }
      double in = 0.0, out = 1.0;
      for (int step = 0; step < 30; ++step)
      {
        const double middle = 0.5 * (in + out);
        (this->Fault.Contains(last.S + sign * middle * this->Options.Row, height) ? in : out) = middle;
      }
      CutoffPair tip;
      tip.S = last.S + sign * in * this->Options.Row;
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        this->Interpolate(tip, wall, height);
      }
      piece.IsTip[end] = true;
      constexpr double none = 1e-6; // columns
      if (in < none)
      {
        (end == 0 ? piece.Pairs.front() : piece.Pairs.back()) = tip;
        continue;
      }
      piece.Pairs.insert(end == 0 ? piece.Pairs.begin() : piece.Pairs.end(), tip);
    }
  }

  bool MeetsOther(const CutoffPair& pair) const { return this->Others.IsAt(this->Fault.At(pair.S, MiddleOf(pair))); }

  const FaultPlate& Fault;
  const OtherFaults& Others;
  const std::array<FaultSide, 2>& Sides;
  const CutoffFitOptions& Options;
  double LeastLength;
};
}

//----------------------------------------------------------------------------------------------------------------------
double CutoffPiece::Length(const FaultPlate& fault, FaultWall wall) const
{
  double length = 0.0;
  for (std::size_t n = 1; n < this->Pairs.size(); ++n)
  {
    length += (this->Pairs[n].Place(fault, wall) - this->Pairs[n - 1].Place(fault, wall)).norm();
  }
  return length;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonCutoffs FindCutoffs(const FaultPlate& fault, const std::vector<const FaultPlate*>& faults,
  const HorizonPicks& horizon, CutoffFitOptions options, double leastLength, const Monitor& monitor)
{
  constexpr double margin = 3.0; // columns
  constexpr double across = 2.0; // deviations of heights, which put a pick on the other side of a flat fault
  const Eigen::Matrix2d toColumns = horizon.Steps.inverse();
  options.Column = 1.0 / (toColumns * fault.AcrossOnMap()).norm();
  options.Row = 1.0 / (toColumns * fault.AlongOnMap()).norm();
  options.Noise = horizon.Noise;
  options.DropDistance = std::max(options.DropDistance, across * horizon.Noise * fault.Lean() / options.Column);
  options.LeastSpread = horizon.IsRounded ? horizon.Noise : 0.0;
  const OtherFaults others(fault, faults, margin * options.Row, (Reach + options.LargestGap) * options.Column);
  const std::array<FaultSide, 2> sides = ListSides(fault, others, horizon, options, monitor.Step(0.0, 0.2));
  return CutoffFinder(fault, others, sides, options, leastLength).Find(monitor.Step(0.2, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
double SumOfThrows(const HorizonCutoffs& cutoffs)
{
  double sum = 0.0;
  for (const CutoffPiece& piece : cutoffs.Pieces)
  {
    for (const CutoffPair& pair : piece.Pairs)
    {
      sum += pair.Throw();
    }
  }
  return sum;
}

//----------------------------------------------------------------------------------------------------------------------
void SwapWalls(HorizonCutoffs& cutoffs)
{
  std::swap(cutoffs.Dropped[Footwall], cutoffs.Dropped[HangingWall]);
  for (CutoffPiece& piece : cutoffs.Pieces)
  {
    for (CutoffPair& pair : piece.Pairs)
    {
      std::swap(pair.Wall[Footwall], pair.Wall[HangingWall]);
      std::swap(pair.Source[Footwall], pair.Source[HangingWall]);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> SimplifyCutoff(
  const CutoffPiece& piece, FaultWall wall, double heightError, double offsetError)
{
  const std::vector<CutoffPair>& pairs = piece.Pairs;
  const auto isWithin = [&](std::size_t from, std::size_t to)
  {
    const CutoffPlace &a = pairs[from].Wall[wall], &b = pairs[to].Wall[wall];
    for (std::size_t n = from + 1; n < to; ++n)
    {
      const double part = (pairs[n].S - pairs[from].S) / (pairs[to].S - pairs[from].S);
      const CutoffPlace& own = pairs[n].Wall[wall];
      if (pairs[n].Source[wall] != pairs[n - 1].Source[wall] || pairs[n].Source[wall] != pairs[n + 1].Source[wall] ||
        std::abs(a.Height + part * (b.Height - a.Height) - own.Height) > heightError ||
        std::abs(a.Offset + part * (b.Offset - a.Offset) - own.Offset) > offsetError)
      {
        return false;
      }
    }
    return true;
  };
  std::vector<std::size_t> kept = { 0 };
  while (kept.back() + 1 < pairs.size())
  {
    std::size_t next = kept.back() + 1;
    for (std::size_t n = next + 1; n < pairs.size() && isWithin(kept.back(), n); ++n)
    {
      next = n;
    }
    kept.push_back(next);
  }
  return kept;
}
}
