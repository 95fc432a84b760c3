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
constexpr double LeastDoubtful = 3.0; // the same in narrow blocks
constexpr double Window = 10.0; // columns across, of picks that others are compared with
constexpr double HalfWindow = 5.0; // columns along, on both sides
constexpr std::size_t FewestPicks = 12;
constexpr double Harmless = 0.1; // of the throw, per column: what climbs a fault within ten columns is off by more
constexpr std::array<double, 5> Widths = { 3.0, 4.5, 6.5, 9.5, 14.0 }; // columns

using Terms = Eigen::Matrix<double, 6, 1>;
using Normal = Eigen::Matrix<double, 6, 6>;

/// A surface of second order around a place, by weighted least squares. Few picks give a plane.
class LocalSurface
{
public:
  /// Coordinates are counted in units of both axes from a place.
  LocalSurface(double s, double n, double unitS, double unitN, bool isPlane = false)
    : S(s)
    , N(n)
    , UnitS(unitS)
    , UnitN(unitN)
    , IsPlane(isPlane)
  {
  }

  void Add(const FaultPlace& place, double weight)
  {
    if (this->Count == 0)
    {
      this->Level = place.Z;
    }
    const Terms terms = this->TermsAt(place.S, place.N);
    this->Matrix.selfadjointView<Eigen::Lower>().rankUpdate(terms, weight);
    this->Squares.selfadjointView<Eigen::Lower>().rankUpdate(terms, weight * weight);
    this->Right += weight * (place.Z - this->Level) * terms;
    ++this->Count;
  }

  std::size_t Size() const { return this->Count; }

  void Solve()
  {
    constexpr std::size_t fewestForCurves = 12;
    constexpr double held = 1e-13, stiff = 1e6;
    const double scale = this->Matrix(0, 0);
    Normal matrix = this->Matrix;
    for (int term = 1; term < 6; ++term)
    {
      matrix(term, term) += scale * (term > 2 && (this->IsPlane || this->Count < fewestForCurves) ? stiff : held);
    }
    this->Inverse = matrix.selfadjointView<Eigen::Lower>().ldlt().solve(Normal::Identity());
    this->Coefficients = this->Inverse * this->Right;
  }

  double At(double s, double n) const { return this->Level + this->Coefficients.dot(this->TermsAt(s, n)); }

  /// The slope across, in heights by distance.
  double SlopeAt(double s, double n) const
  {
    const double a = (s - this->S) / this->UnitS, b = (n - this->N) / this->UnitN;
    return (this->Coefficients(2) + a * this->Coefficients(4) + 2.0 * b * this->Coefficients(5)) / this->UnitN;
  }

  /// The variance of a height, for picks of variance 1.
  double VarianceAt(double s, double n) const
  {
    const Terms row = this->Inverse * this->TermsAt(s, n);
    return row.dot(this->Squares.selfadjointView<Eigen::Lower>() * row);
  }

private:
  Terms TermsAt(double s, double n) const
  {
    const double a = (s - this->S) / this->UnitS, b = (n - this->N) / this->UnitN;
    Terms terms;
    terms << 1.0, a, b, a * a, a * b, b * b;
    return terms;
  }

  double S;
  double N;
  double UnitS;
  double UnitN;
  bool IsPlane;
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

/// From 1 at 0 to 0 at 1.
double Bisquare(double value)
{
  const double rest = std::max(0.0, 1.0 - value * value);
  return rest * rest;
}

struct NearPick
{
  const SidePick* Pick;
  double Weight = 0.0; // 0 if it does not agree
};

/// One width of the last step.
struct WidthFit
{
  FaultPlace Foot;
  double Spread = 0.0;
};

/// `width` is in columns.
std::optional<WidthFit> FitWidth(const std::vector<NearPick>& picks, const FaultPlate& fault, const FaultPlace& foot,
  double width, const CutoffFitOptions& options)
{
  constexpr std::size_t fewest = 6;
  const double unitS = width * options.Row, unitN = width * options.Column;
  LocalSurface surface(foot.S, foot.N, unitS, unitN);
  for (const NearPick& near : picks)
  {
    const FaultPlace& place = near.Pick->Place;
    const double s = (place.S - foot.S) / unitS, n = (place.N - foot.N) / unitN;
    const double rest = 1.0 - s * s - n * n;
    if (near.Weight > 0.0 && rest > 0.0)
    {
      surface.Add(place, near.Weight * rest * rest);
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
  return WidthFit{ *met, options.Noise * std::sqrt(surface.VarianceAt(met->S, met->N)) };
}

struct OuterSurface
{
  LocalSurface Surface;
  double Scatter = 0.0; // of its picks, at least their noise
};

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
    for (const double along : { HalfWindow, 2.0 * HalfWindow, 4.0 * HalfWindow })
    {
      this->Gather(others, side, along);
      if (this->HasOuter(-along, along) && this->HasOuter(-along, 0.5) && this->HasOuter(-0.5, along))
      {
        this->KeepOuter();
        return;
      }
    }
    if (this->HasOuter(-4.0 * HalfWindow, 4.0 * HalfWindow))
    {
      this->Picks.clear(); // The horizon ends here: what is beside the fault cannot be compared.
      return;
    }
    // A narrow block has no picks farther away.
    this->Gather(others, side, HalfWindow);
    while (this->Ring > options.DropDistance && !this->HasOuter(-HalfWindow, HalfWindow))
    {
      this->Ring -= 1.0;
    }
    this->Ring = std::max(this->Ring, options.DropDistance);
    this->KeepOuter();
  }

  /// Where surfaces through the picks that are not doubtful meet the fault: a curved one, and a plane through the nearest.
  const std::vector<double>& OuterHeights() const { return this->Heights; }

  /// Adds the picks nearer to the fault that agree with one of these surfaces, with the throw as far as it is known: picks
  /// that are off by little of it follow the horizon where it bends, others the wrong side, or the fault.
  void KeepAgreeing(double shift);

  CutoffPlace Fit() const;

private:
  void Gather(const OtherFaults& others, const FaultSide& side, double along);
  bool HasOuter(double from, double to) const;
  void KeepOuter()
  {
    this->KeepOuter(Window, false);
    this->KeepOuter(0.5 * Window, true);
  }
  void KeepOuter(double width, bool isPlane);
  void Weigh(double off, double limit, NearPick& near) const
  {
    const double weight = this->Options.DropNoise == 0.0 || off == 0.0 ? 1.0 : Bisquare(off / limit);
    near.Weight = std::max(near.Weight, weight);
  }

  const FaultPlate& Fault;
  double S;
  const CutoffFitOptions& Options;
  std::vector<NearPick> Picks;
  double Ring = 0.0; // columns; nearer picks are compared
  std::vector<OuterSurface> Outer;
  std::vector<double> Heights;
};

/// Takes picks of a strip that are on the same side of other faults. The ring from which on they are not doubtful is
/// farther away where there are none near the fault.
void NearPicks::Gather(const OtherFaults& others, const FaultSide& side, double along)
{
  const double column = this->Options.Column, row = this->Options.Row;
  const SidePick* nearest = nullptr;
  this->Picks.clear();
  this->Ring = std::max(Doubtful, this->Options.DropDistance);
  side.ForEach(this->S - HalfWindow * row, this->S + HalfWindow * row,
    [&](const SidePick& pick) { nearest = nearest && nearest->Distance <= pick.Distance ? nearest : &pick; });
  if (!nearest || nearest->Distance > this->Options.LargestGap * column)
  {
    return;
  }
  SidePick foot;
  foot.Place = { this->S, this->Fault.Offset(this->S, nearest->Place.Z), nearest->Place.Z };
  others.Mark(this->Fault.ToWorld(foot.Place), foot);
  const double reach = nearest->Distance + (Doubtful + Window) * column;
  side.ForEach(this->S - along * row, this->S + along * row,
    [&](const SidePick& pick)
    {
      if (pick.Distance <= reach && !OtherFaults::AreBetween(pick, foot))
      {
        this->Picks.push_back({ &pick });
      }
    });
  this->Ring = std::max(this->Ring, std::floor(nearest->Distance / column));
}

/// Whether there are enough picks that are not doubtful, between two places along the fault in columns from the own one:
/// over several columns, or on one side some.
bool NearPicks::HasOuter(double from, double to) const
{
  constexpr double leastWidth = 3.0; // columns
  constexpr std::size_t fewestOnSide = 3;
  const bool isWhole = from < -0.5 && to > 0.5;
  double largest = 0.0;
  std::size_t count = 0;
  for (const NearPick& near : this->Picks)
  {
    const double along = (near.Pick->Place.S - this->S) / this->Options.Row;
    const double away = near.Pick->Distance / this->Options.Column;
    if (away >= this->Ring && along >= from && along <= to)
    {
      largest = std::max(largest, away);
      ++count;
    }
  }
  return isWhole ? count >= FewestPicks && largest >= this->Ring + leastWidth : count >= fewestOnSide;
}

/// Finds a surface through most of the outer picks, by weights of the inverse distance, which strays do not move. Keeps
/// the picks near it.
void NearPicks::KeepOuter(double width, bool isPlane)
{
  const double column = this->Options.Column, row = this->Options.Row;
  std::vector<NearPick*> window;
  double middle = 0.0;
  for (NearPick& near : this->Picks)
  {
    const double away = near.Pick->Distance / column - this->Ring;
    if (away >= 0.0 && away <= width)
    {
      window.push_back(&near);
      middle += near.Pick->Place.N;
    }
  }
  if (window.size() < FewestPicks)
  {
    return;
  }
  middle /= double(window.size());
  OuterSurface outer{ LocalSurface(this->S, middle, HalfWindow * row, HalfWindow * column, isPlane) };
  std::vector<double> off(window.size(), 0.0);
  constexpr int rounds = 8;
  constexpr double close = 0.02;
  constexpr double normal = 1.4826; // of the median of absolute values
  constexpr double least = 1e-3;
  for (int round = 0; round < rounds; ++round)
  {
    LocalSurface next(this->S, middle, HalfWindow * row, HalfWindow * column, isPlane);
    for (std::size_t n = 0; n < window.size(); ++n)
    {
      const double distance = std::max({ off[n], this->Options.Noise, least * outer.Scatter });
      next.Add(window[n]->Pick->Place, round > 0 && distance > 0.0 ? 1.0 / distance : 1.0);
    }
    next.Solve();
    outer.Surface = next;
    for (std::size_t n = 0; n < window.size(); ++n)
    {
      const FaultPlace& place = window[n]->Pick->Place;
      off[n] = std::abs(place.Z - next.At(place.S, place.N));
    }
    std::vector<double> sorted = off;
    const double scatter = normal * UpperMedian(sorted);
    const bool isDone = round > 1 && std::abs(scatter - outer.Scatter) <= close * scatter;
    outer.Scatter = scatter;
    if (isDone)
    {
      break;
    }
  }
  outer.Scatter = std::hypot(outer.Scatter, this->Options.Noise);
  for (std::size_t n = 0; n < window.size(); ++n)
  {
    this->Weigh(off[n], this->Options.DropNoise * outer.Scatter, *window[n]);
  }
  const double start = this->Fault.Offset(this->S, window.front()->Pick->Place.Z);
  if (const std::optional<FaultPlace> foot = Meet(this->Fault, outer.Surface, this->S, start))
  {
    this->Heights.push_back(foot->Z);
  }
  this->Outer.push_back(outer);
}

//----------------------------------------------------------------------------------------------------------------------
void NearPicks::KeepAgreeing(double shift)
{
  const double column = this->Options.Column;
  const auto outermost = std::size_t(std::ceil(this->Ring));
  std::vector<std::vector<NearPick*>> rings(outermost + 1); // by columns; of the last one picks are not doubtful
  for (NearPick& near : this->Picks)
  {
    const double away = near.Pick->Distance / column;
    if (away >= this->Options.DropDistance && away < double(rings.size()))
    {
      rings[away < this->Ring ? std::min(std::size_t(away), outermost - 1) : outermost].push_back(&near);
    }
  }
  for (const OuterSurface& outer : this->Outer)
  {
    const auto offOf = [&outer](const NearPick* near)
    { return near->Pick->Place.Z - outer.Surface.At(near->Pick->Place.S, near->Pick->Place.N); };
    // How far the horizon is from the surface, ring by ring: it may bend slowly, but what climbs does so at once.
    std::vector<double> bend(rings.size(), 0.0);
    bool isBend = true;
    double last = 0.0, lastStep = 0.0; // distance from the fault
    for (std::size_t ring = rings.size(); ring-- > 0;)
    {
      const double before = ring < outermost ? bend[ring + 1] : 0.0;
      bend[ring] = before;
      if (rings[ring].empty())
      {
        continue;
      }
      std::vector<double> off, nearness;
      for (const NearPick* const near : rings[ring])
      {
        off.push_back(offOf(near));
        nearness.push_back(-near->Pick->Distance / column);
      }
      bend[ring] = UpperMedian(off);
      const double distance = -UpperMedian(nearness);
      const double step = std::abs(bend[ring] - before);
      const double slow = Harmless * shift * std::max(1.0, last - distance);
      // What begins in the last column is no bend yet.
      const double sudden = std::max(2.0 * lastStep, 0.3 * slow);
      const bool isSlow = step <= std::max(ring > 0 ? slow : std::min(slow, sudden), outer.Scatter);
      isBend = isBend && (ring == outermost || isSlow);
      lastStep = ring == outermost ? 0.0 : step;
      last = distance;
    }
    for (std::size_t ring = 0; ring < outermost; ++ring)
    {
      for (NearPick* const near : rings[ring])
      {
        const double most = std::max(0.5 * shift, this->Options.DropNoise * outer.Scatter);
        const double noise = this->Options.DropNoise * outer.Scatter *
          std::sqrt(1.0 + outer.Surface.VarianceAt(near->Pick->Place.S, near->Pick->Place.N));
        const double limit = std::max(std::min(noise, most), isBend ? Harmless * shift : 0.0);
        this->Weigh(offOf(near) - (isBend ? bend[ring] : 0.0), limit, *near);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
CutoffPlace NearPicks::Fit() const
{
  const double column = this->Options.Column, row = this->Options.Row;
  const double infinity = std::numeric_limits<double>::infinity();
  CutoffPlace cutoff;
  cutoff.IsChecked = this->Ring >= LeastDoubtful;
  double gap = infinity, height = 0.0;
  std::array<double, 2> along = { infinity, -infinity }, heights = { infinity, -infinity };
  for (const NearPick& near : this->Picks)
  {
    const SidePick& pick = *near.Pick;
    const bool isDoubtful = pick.Distance >= this->Options.DropDistance * column && pick.Distance <= Doubtful * column;
    if (near.Weight == 0.0 && isDoubtful && std::abs(pick.Place.S - this->S) <= 0.5 * row)
    {
      cutoff.Dropped.push_back(pick.Number);
    }
    if (near.Weight == 0.0)
    {
      continue;
    }
    along = { std::min(along[0], pick.Place.S), std::max(along[1], pick.Place.S) };
    heights = { std::min(heights[0], pick.Place.Z), std::max(heights[1], pick.Place.Z) };
    const double away = std::hypot((pick.Place.S - this->S) / row, pick.Distance / column);
    if (away < gap)
    {
      gap = away;
      height = pick.Place.Z;
    }
  }
  const bool isBetween = along[0] <= this->S + 0.5 * row && along[1] >= this->S - 0.5 * row;
  if (!isBetween || gap > this->Options.LargestGap)
  {
    return CutoffPlace();
  }
  const FaultPlace foot = { this->S, this->Fault.Offset(this->S, height), height };
  constexpr double most = 2.0, confidence = 2.0; // in units of the noise, and of the spread
  double least = -infinity, largest = infinity;
  for (const double width : Widths)
  {
    const std::optional<WidthFit> fit = FitWidth(this->Picks, this->Fault, foot, gap + width, this->Options);
    // A width with too few picks to average noise gives way to the next.
    const bool isLast = width == Widths.back() && std::isnan(cutoff.Height);
    // What leaves the heights of all picks far behind is no continuation of them.
    const double reach = (2.0 + gap) * std::max(heights[1] - heights[0], this->Options.Noise);
    const bool isFar = fit && (fit->Foot.Z < heights[0] - reach || fit->Foot.Z > heights[1] + reach);
    if (!fit || isFar || (fit->Spread > most * this->Options.Noise && !isLast))
    {
      continue;
    }
    least = std::max(least, fit->Foot.Z - confidence * fit->Spread);
    largest = std::min(largest, fit->Foot.Z + confidence * fit->Spread);
    if (least > largest)
    {
      break;
    }
    cutoff.Height = fit->Foot.Z;
    cutoff.Offset = fit->Foot.N;
    cutoff.Spread = std::max(fit->Spread, this->Options.LeastSpread);
    cutoff.Gap = gap;
  }
  return cutoff;
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
OtherFaults::OtherFaults(
  const FaultPlate& fault, const std::vector<const FaultPlate*>& others, double margin, double reach)
  : Margin(margin)
{
  const auto touches = [&](const FaultPlate& other)
  {
    if (fault.Box().exteriorDistance(other.Box()) > reach + margin)
    {
      return false;
    }
    constexpr int heights = 16;
    const double low = std::max(fault.Lowest() + fault.Datum(), other.Lowest() + other.Datum());
    const double high = std::min(fault.Highest() + fault.Datum(), other.Highest() + other.Datum());
    for (int level = 0; level <= heights && low <= high; ++level)
    {
      const double z = low + (high - low) * level / heights - fault.Datum();
      for (double s = fault.First(); s <= fault.Last() + margin; s += margin)
      {
        const FaultPlace place = other.ToPlace(fault.At(std::min(s, fault.Last()), z));
        if (place.S >= other.First() - margin && place.S <= other.Last() + margin &&
          std::abs(other.Distance(place)) <= reach)
        {
          return true;
        }
      }
    }
    return false;
  };
  std::copy_if(others.begin(), others.end(), std::back_inserter(this->Faults),
    [&](const FaultPlate* other) { return other != &fault && touches(*other); });
  if (this->Faults.size() > MostOthers)
  {
    throw InputError("fault " + fault.Name() + " with " + std::to_string(this->Faults.size()) +
      " other faults beside it, expected at most " + std::to_string(MostOthers));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void OtherFaults::Mark(const Eigen::Vector3d& world, SidePick& pick) const
{
  pick.Near.reset();
  pick.Hanging.reset();
  for (std::size_t n = 0; n < this->Faults.size(); ++n)
  {
    const FaultPlace place = this->Faults[n]->ToPlace(world);
    pick.Near.set(n, this->Faults[n]->Contains(place.S, place.Z, this->Margin));
    pick.Hanging.set(n, this->Faults[n]->Distance(place) > 0.0);
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
  double shift = std::numeric_limits<double>::infinity();
  for (const double foot : picks[0].OuterHeights())
  {
    for (const double hanging : picks[1].OuterHeights())
    {
      shift = std::min(shift, std::abs(foot - hanging));
    }
  }
  shift = std::isfinite(shift) ? shift : 0.0;
  std::array<CutoffPlace, 2> cutoffs;
  for (const std::size_t wall : { 0, 1 })
  {
    picks[wall].KeepAgreeing(shift);
    cutoffs[wall] = picks[wall].Fit();
  }
  return cutoffs;
}
}
