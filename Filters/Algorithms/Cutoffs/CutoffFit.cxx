// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffFit.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Median.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double Doubtful = 6.0; // columns beside a fault, where picks have to agree
constexpr double Window = 10.0; // columns across, of picks that others are compared with
constexpr double HalfWindow = 5.0; // columns along, on both sides
constexpr std::size_t FewestPicks = 12;
constexpr std::array<double, 5> Widths = { 3.0, 4.5, 6.5, 9.5, 14.0 }; // columns

using Terms = Eigen::Matrix<double, 6, 1>;
using Normal = Eigen::Matrix<double, 6, 6>;

/// A surface of second order around a place, by weighted least squares. Few picks give a plane.
class LocalSurface
{
public:
  LocalSurface(double s, double n, double unit)
    : S(s)
    , N(n)
    , Unit(unit)
  {
  }

  void Add(const FaultPlace& place, double weight)
  {
    if (this->Count == 0)
    {
      this->Level = place.Z;
    }
    const Terms terms = this->TermsAt(place.S, place.N);
    this->Matrix.noalias() += weight * terms * terms.transpose();
    this->Squares.noalias() += weight * weight * terms * terms.transpose();
    this->Right += weight * (place.Z - this->Level) * terms;
    ++this->Count;
  }

  std::size_t Size() const { return this->Count; }

  void Solve()
  {
    constexpr std::size_t fewestForCurves = 12;
    constexpr double held = 1e-9, stiff = 1e6;
    const double scale = this->Matrix(0, 0);
    Normal matrix = this->Matrix;
    for (int term = 1; term < 6; ++term)
    {
      matrix(term, term) += scale * (term > 2 && this->Count < fewestForCurves ? stiff : held);
    }
    this->Inverse = matrix.ldlt().solve(Normal::Identity());
    this->Coefficients = this->Inverse * this->Right;
  }

  double At(double s, double n) const { return this->Level + this->Coefficients.dot(this->TermsAt(s, n)); }

  /// The slope across, in heights by distance.
  double SlopeAt(double s, double n) const
  {
    const double a = (s - this->S) / this->Unit, b = (n - this->N) / this->Unit;
    return (this->Coefficients(2) + a * this->Coefficients(4) + 2.0 * b * this->Coefficients(5)) / this->Unit;
  }

  /// The variance of a height, for picks of variance 1.
  double VarianceAt(double s, double n) const
  {
    const Terms row = this->Inverse * this->TermsAt(s, n);
    return row.dot(this->Squares * row);
  }

private:
  Terms TermsAt(double s, double n) const
  {
    const double a = (s - this->S) / this->Unit, b = (n - this->N) / this->Unit;
    Terms terms;
    terms << 1.0, a, b, a * a, a * b, b * b;
    return terms;
  }

  double S;
  double N;
  double Unit;
  double Level = 0.0;
  std::size_t Count = 0;
  Normal Matrix = Normal::Zero();
  Normal Squares = Normal::Zero();
  Terms Right = Terms::Zero();
  Normal Inverse = Normal::Zero();
  Terms Coefficients = Terms::Zero();
};

/// Where a surface, continued along its section across the fault, meets the fault; nothing if it does not.
std::optional<FaultPlace> Meet(const FaultPlate& fault, const LocalSurface& surface, double s, double n)
{
  constexpr int mostSteps = 50;
  constexpr double close = 1e-10, leastTurn = 0.05;
  const double reach = fault.Highest() - fault.Lowest();
  const double dz = 1e-3 * reach;
  for (int step = 0; step < mostSteps; ++step)
  {
    const double z = surface.At(s, n);
    const double off = n - fault.Offset(s, z);
    const double lean = (fault.Offset(s, z + dz) - fault.Offset(s, z - dz)) / (2.0 * dz);
    const double turn = 1.0 - lean * surface.SlopeAt(s, n);
    if (!std::isfinite(off) || std::abs(turn) < leastTurn)
    {
      return std::nullopt;
    }
    n -= off / turn;
    if (std::abs(off) <= close * (std::abs(n) + std::abs(lean) * reach))
    {
      const double height = surface.At(s, n);
      return FaultPlace{ s, fault.Offset(s, height), height };
    }
  }
  return std::nullopt;
}

struct NearPick
{
  const SidePick* Pick;
  bool IsKept = false;
};

/// One width of the last step.
struct WidthFit
{
  FaultPlace Foot;
  double Spread = 0.0;
};

std::optional<WidthFit> FitWidth(
  const std::vector<NearPick>& picks, const FaultPlate& fault, const FaultPlace& foot, double width, double noise)
{
  constexpr std::size_t fewest = 6;
  LocalSurface surface(foot.S, foot.N, width);
  for (const NearPick& near : picks)
  {
    const FaultPlace& place = near.Pick->Place;
    const double away = std::hypot(place.S - foot.S, place.N - foot.N) / width;
    if (near.IsKept && away < 1.0)
    {
      const double weight = 1.0 - away * away;
      surface.Add(place, weight * weight);
    }
  }
  if (surface.Size() < fewest)
  {
    return std::nullopt;
  }
  surface.Solve();
  const std::optional<FaultPlace> met = Meet(fault, surface, foot.S, foot.N);
  if (!met)
  {
    return std::nullopt;
  }
  return WidthFit{ *met, noise * std::sqrt(surface.VarianceAt(met->S, met->N)) };
}

/// The picks of a wall near a place along the fault.
class NearPicks
{
public:
  NearPicks(const FaultPlate& fault, const OtherFaults& others, const FaultSide& side, double s,
    const CutoffFitOptions& options)
    : Fault(fault)
    , S(s)
    , Options(options)
  {
    for (const double along : { HalfWindow, 2.0 * HalfWindow, 4.0 * HalfWindow, HalfWindow })
    {
      this->Gather(others, side, along);
      // A narrow block has no picks farther away: the last turn takes what there is.
      const bool isEnough = this->CountBeyond(this->Ring) >= FewestPicks;
      if (isEnough)
      {
        break;
      }
    }
    this->KeepOuter();
  }

  /// Where the picks that are not doubtful meet the fault.
  std::optional<FaultPlace> const& Outer() const { return this->OuterFoot; }

  /// Adds the picks nearer to the fault that agree, with the throw as far as it is known. Picks that are off by little of
  /// it follow the horizon where it bends.
  void KeepAgreeing(double shift);

  CutoffPlace Fit() const;

private:
  void Gather(const OtherFaults& others, const FaultSide& side, double along);
  std::size_t CountBeyond(double ring) const
  {
    return std::size_t(std::count_if(this->Picks.begin(), this->Picks.end(),
      [&](const NearPick& near) { return near.Pick->Distance >= ring * this->Options.Column; }));
  }
  void KeepOuter();
  std::vector<WidthFit> FitWidths(const FaultPlace& foot, double gap) const;
  LocalSurface FitWindow(double from, double width, double& deviation) const;

  const FaultPlate& Fault;
  double S;
  const CutoffFitOptions& Options;
  std::vector<NearPick> Picks;
  double Ring = 0.0; // columns; nearer picks are compared
  double Deviation = 0.0;
  std::optional<FaultPlace> OuterFoot;
};

/// Takes picks of a strip that are on the same side of other faults. The ring from which on they are not doubtful is
/// farther away where there are none near the fault.
void NearPicks::Gather(const OtherFaults& others, const FaultSide& side, double along)
{
  const double column = this->Options.Column;
  const SidePick* nearest = nullptr;
  this->Picks.clear();
  this->Ring = Doubtful;
  side.ForEach(this->S - HalfWindow * column, this->S + HalfWindow * column,
    [&](const SidePick& pick) { nearest = nearest && nearest->Distance <= pick.Distance ? nearest : &pick; });
  if (!nearest || nearest->Distance > this->Options.LargestGap * column)
  {
    return;
  }
  SidePick foot;
  foot.Place = { this->S, this->Fault.Offset(this->S, nearest->Place.Z), nearest->Place.Z };
  others.Mark(this->Fault.ToWorld(foot.Place), foot);
  const double reach = nearest->Distance + (Doubtful + Window) * column;
  side.ForEach(this->S - along * column, this->S + along * column,
    [&](const SidePick& pick)
    {
      if (pick.Distance <= reach && !OtherFaults::AreBetween(pick, foot))
      {
        this->Picks.push_back({ &pick });
      }
    });
  this->Ring = std::max(this->Ring, std::floor(nearest->Distance / column));
}

/// Finds a surface through most of the outer picks, by weights of the inverse distance, which strays do not move. Keeps
/// the picks near it.
void NearPicks::KeepOuter()
{
  const double column = this->Options.Column;
  while (this->Ring > this->Options.DropDistance && this->CountBeyond(this->Ring) < FewestPicks)
  {
    this->Ring -= 1.0;
  }
  this->Ring = std::max(this->Ring, this->Options.DropDistance);
  std::vector<NearPick*> outer;
  double middle = 0.0;
  for (NearPick& near : this->Picks)
  {
    const double away = near.Pick->Distance / column - this->Ring;
    if (away >= 0.0 && away <= Window)
    {
      outer.push_back(&near);
      middle += near.Pick->Place.N;
    }
  }
  if (outer.empty())
  {
    return;
  }
  middle /= double(outer.size());
  std::vector<double> off(outer.size(), 0.0);
  LocalSurface surface(this->S, middle, HalfWindow * column);
  constexpr int rounds = 8;
  constexpr double normal = 1.4826; // of the median of absolute values
  constexpr double least = 1e-3;
  for (int round = 0; round < rounds; ++round)
  {
    LocalSurface next(this->S, middle, HalfWindow * column);
    for (std::size_t n = 0; n < outer.size(); ++n)
    {
      const double distance = std::max({ off[n], this->Options.Noise, least * this->Deviation });
      next.Add(outer[n]->Pick->Place, round > 0 && distance > 0.0 ? 1.0 / distance : 1.0);
    }
    next.Solve();
    surface = next;
    for (std::size_t n = 0; n < outer.size(); ++n)
    {
      const FaultPlace& place = outer[n]->Pick->Place;
      off[n] = std::abs(place.Z - surface.At(place.S, place.N));
    }
    std::vector<double> sorted = off;
    this->Deviation = normal * UpperMedian(sorted);
  }
  const double limit = this->Options.DropNoise * std::hypot(this->Options.Noise, this->Deviation);
  for (std::size_t n = 0; n < outer.size(); ++n)
  {
    outer[n]->IsKept = this->Options.DropNoise == 0.0 || off[n] <= limit;
  }
  this->OuterFoot = Meet(this->Fault, surface, this->S, this->Fault.Offset(this->S, outer.front()->Pick->Place.Z));
}

/// Through the picks kept from a distance on.
LocalSurface NearPicks::FitWindow(double from, double width, double& deviation) const
{
  std::vector<const FaultPlace*> window;
  double middle = 0.0;
  for (const NearPick& near : this->Picks)
  {
    if (near.IsKept && near.Pick->Distance >= from && near.Pick->Distance <= from + width)
    {
      window.push_back(&near.Pick->Place);
      middle += near.Pick->Place.N;
    }
  }
  LocalSurface surface(this->S, window.empty() ? 0.0 : middle / double(window.size()), width);
  for (const FaultPlace* place : window)
  {
    surface.Add(*place, 1.0);
  }
  deviation = 0.0;
  if (!window.empty())
  {
    surface.Solve();
    for (const FaultPlace* place : window)
    {
      const double off = place->Z - surface.At(place->S, place->N);
      deviation += off * off / double(window.size());
    }
  }
  deviation = std::sqrt(deviation);
  return surface;
}

//----------------------------------------------------------------------------------------------------------------------
void NearPicks::KeepAgreeing(double shift)
{
  constexpr double harmless = 0.2; // of the throw; picks of the wrong side are off by all of it
  const double column = this->Options.Column;
  if (this->Options.DropNoise == 0.0)
  {
    for (NearPick& near : this->Picks)
    {
      near.IsKept = near.Pick->Distance >= this->Options.DropDistance * column;
    }
    return;
  }
  while (this->Ring > this->Options.DropDistance)
  {
    const double next = std::max(this->Ring - 1.0, this->Options.DropDistance);
    for (const double width : { Window, 0.4 * Window })
    {
      double deviation = 0.0;
      const LocalSurface surface = this->FitWindow(this->Ring * column, width * column, deviation);
      const double scatter = std::max(this->Options.Noise, deviation);
      const double most = std::max(0.5 * shift, this->Options.DropNoise * scatter);
      for (NearPick& near : this->Picks)
      {
        if (surface.Size() >= FewestPicks && near.Pick->Distance < this->Ring * column &&
          near.Pick->Distance >= next * column)
        {
          const FaultPlace& place = near.Pick->Place;
          const double limit =
            this->Options.DropNoise * scatter * std::sqrt(1.0 + surface.VarianceAt(place.S, place.N));
          near.IsKept = near.IsKept ||
            std::abs(place.Z - surface.At(place.S, place.N)) <= std::max(harmless * shift, std::min(limit, most));
        }
      }
      constexpr double plain = 1.5;
      if (deviation <= plain * this->Options.Noise)
      {
        break; // A shorter window bends more with noise.
      }
    }
    this->Ring = next;
  }
}

//----------------------------------------------------------------------------------------------------------------------
CutoffPlace NearPicks::Fit() const
{
  const double column = this->Options.Column;
  const double infinity = std::numeric_limits<double>::infinity();
  CutoffPlace cutoff;
  double gap = infinity, height = 0.0;
  std::array<double, 2> along = { infinity, -infinity };
  for (const NearPick& near : this->Picks)
  {
    const SidePick& pick = *near.Pick;
    const bool isDoubtful = pick.Distance >= this->Options.DropDistance * column && pick.Distance <= Doubtful * column;
    cutoff.Dropped += !near.IsKept && isDoubtful && std::abs(pick.Place.S - this->S) <= 0.5 * column ? 1 : 0;
    if (!near.IsKept)
    {
      continue;
    }
    along = { std::min(along[0], pick.Place.S), std::max(along[1], pick.Place.S) };
    const double away = std::hypot(pick.Place.S - this->S, pick.Distance);
    if (away < gap)
    {
      gap = away;
      height = pick.Place.Z;
    }
  }
  const bool isBetween = along[0] <= this->S + 0.5 * column && along[1] >= this->S - 0.5 * column;
  if (!isBetween || gap > this->Options.LargestGap * column)
  {
    return CutoffPlace();
  }
  const FaultPlace foot = { this->S, this->Fault.Offset(this->S, height), height };
  const std::vector<WidthFit> fits = this->FitWidths(foot, gap);
  double least = -infinity, largest = infinity;
  for (const WidthFit& fit : fits)
  {
    constexpr double confidence = 2.0; // deviations
    least = std::max(least, fit.Foot.Z - confidence * fit.Spread);
    largest = std::min(largest, fit.Foot.Z + confidence * fit.Spread);
    if (least > largest)
    {
      break;
    }
    cutoff.Height = fit.Foot.Z;
    cutoff.Offset = fit.Foot.N;
    cutoff.Spread = fit.Spread;
    cutoff.Gap = gap;
  }
  return cutoff;
}

//----------------------------------------------------------------------------------------------------------------------
// A width with too few picks to average noise gives way to the next.
std::vector<WidthFit> NearPicks::FitWidths(const FaultPlace& foot, double gap) const
{
  constexpr double most = 2.0; // in units of the noise
  std::vector<WidthFit> fits;
  for (const double width : Widths)
  {
    const std::optional<WidthFit> fit =
      FitWidth(this->Picks, this->Fault, foot, gap + width * this->Options.Column, this->Options.Noise);
    if (fit && (fit->Spread <= most * this->Options.Noise || (fits.empty() && width == Widths.back())))
    {
      fits.push_back(*fit);
    }
  }
  return fits;
}
}

//----------------------------------------------------------------------------------------------------------------------
FaultSide::FaultSide(double first, double last, double width)
  : First(first)
  , Width(width)
  , Strips(std::size_t(std::max(0.0, std::floor((last - first) / width))) + 1)
{
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t FaultSide::StripOf(double s) const
{
  return std::size_t(std::clamp(std::floor((s - this->First) / this->Width), 0.0, double(this->Strips - 1)));
}

//----------------------------------------------------------------------------------------------------------------------
void FaultSide::Add(const SidePick& pick)
{
  this->Picks.push_back(pick);
}

//----------------------------------------------------------------------------------------------------------------------
void FaultSide::Finish()
{
  std::stable_sort(this->Picks.begin(), this->Picks.end(),
    [this](const SidePick& a, const SidePick& b) { return this->StripOf(a.Place.S) < this->StripOf(b.Place.S); });
  this->Begins.assign(this->Strips + 1, this->Picks.size());
  for (std::size_t n = this->Picks.size(); n-- > 0;)
  {
    this->Begins[this->StripOf(this->Picks[n].Place.S)] = n;
  }
  for (std::size_t strip = this->Strips; strip-- > 0;)
  {
    this->Begins[strip] = std::min(this->Begins[strip], this->Begins[strip + 1]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
OtherFaults::OtherFaults(const FaultPlate& fault, const std::vector<const FaultPlate*>& others, double margin)
  : Margin(margin)
{
  const auto touches = [&](const FaultPlate& other)
  {
    const auto isNear = [&](double s, double z)
    {
      const FaultPlace place = other.ToPlace(fault.At(s, z));
      return place.S >= other.First() - margin && place.S <= other.Last() + margin && place.Z >= other.Lowest() &&
        place.Z <= other.Highest();
    };
    for (std::size_t level = 0; level + 1 < fault.Levels(); ++level)
    {
      const double z = fault.Height(level), step = std::max(margin, fault.StepAlong());
      for (double s = fault.First(); s <= fault.Last(); s += step)
      {
        if (isNear(s, z))
        {
          return true;
        }
      }
    }
    return false;
  };
  std::copy_if(others.begin(), others.end(), std::back_inserter(this->Faults),
    [&](const FaultPlate* other) { return other != &fault && touches(*other); });
  if (this->Faults.size() > Most)
  {
    throw InputError("fault " + fault.Name() + " with " + std::to_string(this->Faults.size()) +
      " faults beside it, expected at most " + std::to_string(Most));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void OtherFaults::Mark(const Eigen::Vector3d& world, SidePick& pick) const
{
  pick.Near = pick.Hanging = 0;
  for (std::size_t n = 0; n < this->Faults.size(); ++n)
  {
    const FaultPlace place = this->Faults[n]->ToPlace(world);
    const std::uint64_t bit = std::uint64_t(1) << n;
    pick.Near |= this->Faults[n]->Contains(place.S, place.Z, this->Margin) ? bit : 0;
    pick.Hanging |= this->Faults[n]->Distance(place) > 0.0 ? bit : 0;
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool OtherFaults::IsAt(const Eigen::Vector3d& world) const
{
  return std::any_of(this->Faults.begin(), this->Faults.end(),
    [&](const FaultPlate* other)
    {
      const FaultPlace place = other->ToPlace(world);
      return other->Contains(place.S, place.Z, this->Margin) && std::abs(other->Distance(place)) <= this->Margin;
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::array<CutoffPlace, 2> FitCutoffs(const FaultPlate& fault, const OtherFaults& others,
  const std::array<FaultSide, 2>& sides, double s, const CutoffFitOptions& options)
{
  std::array<NearPicks, 2> picks = { NearPicks(fault, others, sides[0], s, options),
    NearPicks(fault, others, sides[1], s, options) };
  const bool areKnown = picks[0].Outer() && picks[1].Outer();
  const double shift = areKnown ? std::abs(picks[0].Outer()->Z - picks[1].Outer()->Z) : 0.0;
  std::array<CutoffPlace, 2> cutoffs;
  for (const std::size_t wall : { 0, 1 })
  {
    picks[wall].KeepAgreeing(shift);
    cutoffs[wall] = picks[wall].Fit();
  }
  return cutoffs;
}
}
