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
#include <numeric>
#include <optional>
#include <string>
#include <utility>

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

/// Of two coordinates. A product of two terms is one of the powers up to the fourth degree, whose first six they are.
Terms TermsOf(const std::array<double, 2>& place)
{
  const auto [a, b] = place;
  return (Terms() << 1.0, a, b, a * a, a * b, b * b).finished();
}

struct NearPick
{
  const SidePick* Pick;
  double Weight = 0.0; // 0 if it does not agree
};

/// Coordinates in columns from a place.
struct LocalFrame
{
  FaultPlace Middle;
  double Row;
  double Column;

  std::array<double, 2> At(const FaultPlace& place) const
  {
    return { (place.S - this->Middle.S) / this->Row, (place.N - this->Middle.N) / this->Column };
  }
};

/// Picks around a place, with all that sums for surfaces of second order are made of.
struct LocalPicks : LocalFrame
{
  static constexpr int Powers = 15;

  LocalPicks(const std::vector<NearPick*>& picks, const FaultPlace& middle, const CutoffFitOptions& options)
    : LocalFrame({ middle, options.Row, options.Column })
    , Products(std::ptrdiff_t(picks.size()), Powers + 6)
    , Agreement(std::ptrdiff_t(picks.size()))
  {
    for (std::ptrdiff_t n = 0; n < this->Products.rows(); ++n)
    {
      this->Agreement(n) = picks[std::size_t(n)]->Weight;
      const FaultPlace& place = picks[std::size_t(n)]->Pick->Place;
      const auto [a, b] = this->At(place);
      const double aa = a * a, ab = a * b, bb = b * b;
      const Terms terms = TermsOf({ a, b });
      this->Products.row(n) << terms.transpose(), a * aa, a * ab, a * bb, b * bb, aa * aa, aa * ab, ab * ab, ab * bb,
        bb * bb, (place.Z - middle.Z) * terms.transpose();
    }
  }

  Eigen::Matrix<double, Eigen::Dynamic, Powers + 6> Products; // by pick: powers, and terms times the height
  Eigen::ArrayXd Agreement; // weights
};

/// A surface of second order by weighted least squares. Few picks give a plane.
class LocalSurface : public LocalFrame
{
public:
  /// `unit` is the size of the surface in columns.
  LocalSurface(const LocalPicks& picks, const Eigen::VectorXd& weights, double unit, bool isPlane = false)
    : LocalFrame(picks)
  {
    constexpr std::ptrdiff_t fewestForCurves = 12;
    constexpr double held = 1e-13, stiff = 1e6;
    const Eigen::Matrix<double, LocalPicks::Powers + 6, 1> sums = picks.Products.transpose() * weights;
    Normal matrix = Expand(sums.head<LocalPicks::Powers>());
    const bool isFlat = isPlane || (weights.array() > 0.0).count() < fewestForCurves;
    for (int term = 1; term < 6; ++term)
    {
      matrix(term, term) += sums(0) * (term > 2 && isFlat ? stiff : held) * std::pow(unit, term > 2 ? 4 : 2);
    }
    this->Factor.compute(matrix);
    this->Coefficients = this->Factor.solve(sums.tail<6>());
  }

  double HeightAt(const FaultPlace& place) const
  {
    const Terms& c = this->Coefficients;
    const auto [a, b] = this->At(place);
    return this->Middle.Z + c(0) + a * (c(1) + a * c(3) + b * c(4)) + b * (c(2) + b * c(5));
  }

  /// Distances of heights from it.
  Eigen::VectorXd Off(const LocalPicks& picks) const
  {
    return (picks.Products.col(LocalPicks::Powers) - picks.Products.leftCols<6>() * this->Coefficients).cwiseAbs();
  }

  /// The slope across, in heights by distance.
  double SlopeAt(const FaultPlace& place) const
  {
    const auto [a, b] = this->At(place);
    return (this->Coefficients(2) + a * this->Coefficients(4) + 2.0 * b * this->Coefficients(5)) / this->Column;
  }

  /// With the weights it has.
  void MeasureSpread(const LocalPicks& picks, const Eigen::VectorXd& weights)
  {
    const Normal inverse = this->Factor.solve(Normal::Identity());
    const Normal squares = Expand(picks.Products.leftCols<LocalPicks::Powers>().transpose() * weights.cwiseAbs2());
    this->Covariance = inverse * squares * inverse;
  }

  /// The variance of a height, for picks of variance 1, once it is measured.
  double VarianceAt(const FaultPlace& place) const
  {
    const Terms terms = TermsOf(this->At(place));
    return terms.dot(this->Covariance * terms);
  }

private:
  /// From sums of powers to those of products of terms.
  static Normal Expand(const Eigen::Matrix<double, LocalPicks::Powers, 1>& sums)
  {
    constexpr std::array<int, 6> degree = { 0, 1, 1, 2, 2, 2 }, across = { 0, 0, 1, 0, 1, 2 };
    Normal matrix;
    for (std::size_t row = 0; row < 6; ++row)
    {
      for (std::size_t column = 0; column < 6; ++column)
      {
        const int both = degree[row] + degree[column];
        matrix(int(row), int(column)) = sums(both * (both + 1) / 2 + across[row] + across[column]);
      }
    }
    return matrix;
  }

  Eigen::LDLT<Normal> Factor;
  Terms Coefficients;
  Normal Covariance; // of the coefficients
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
    const double z = surface.HeightAt({ s, n });
    const double off = n - fault.Offset(s, z);
    const double lean = (fault.Offset(s, z + dz) - fault.Offset(s, z - dz)) / (2.0 * dz);
    const double turn = 1.0 - lean * surface.SlopeAt({ s, n });
    if (!std::isfinite(off) || std::abs(turn) < leastTurn)
    {
      return std::nullopt;
    }
    n -= off / turn;
    if (std::abs(off) <= close * (std::abs(n) + std::abs(lean) * reach))
    {
      const double height = surface.HeightAt({ s, n });
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

/// The height, offset and spread of one width, in columns.
std::optional<CutoffPlace> FitWidth(const LocalPicks& picks, const FaultPlate& fault, double width, double noise)
{
  constexpr std::ptrdiff_t fewest = 6;
  const Eigen::ArrayXd away = (picks.Products.col(3) + picks.Products.col(5)) / (width * width); // squared
  const Eigen::VectorXd weights = picks.Agreement * (1.0 - away).max(0.0).square();
  if ((weights.array() > 0.0).count() < fewest)
  {
    return std::nullopt;
  }
  LocalSurface surface(picks, weights, width);
  const std::optional<FaultPlace> met = Meet(fault, surface, picks.Middle.S, picks.Middle.N);
  if (!met)
  {
    return std::nullopt;
  }
  surface.MeasureSpread(picks, weights);
  CutoffPlace cutoff;
  cutoff.Height = met->Z;
  cutoff.Offset = met->N;
  cutoff.Spread = noise * std::sqrt(surface.VarianceAt(*met));
  return cutoff;
}

/// The widest of surfaces that meet the fault within the confidence of all narrower ones; nothing if none does.
CutoffPlace FitWidths(const LocalPicks& picks, const FaultPlate& fault, double gap, const CutoffFitOptions& options)
{
  constexpr double most = 2.0, confidence = 2.0; // in units of the noise, and of the spread
  const auto heights = picks.Products.col(LocalPicks::Powers);
  const double lowest = picks.Middle.Z + heights.minCoeff(), highest = picks.Middle.Z + heights.maxCoeff();
  double least = -std::numeric_limits<double>::infinity(), largest = -least;
  CutoffPlace cutoff;
  for (const double width : Widths)
  {
    const std::optional<CutoffPlace> fit = FitWidth(picks, fault, gap + width, options.Noise);
    // A width with too few picks to average noise gives way to the next.
    const bool isLast = width == Widths.back() && std::isnan(cutoff.Height);
    // What leaves the heights of all picks far behind is no continuation of them.
    const double reach = (2.0 + gap) * std::max(highest - lowest, options.Noise);
    const bool isFar = fit && (fit->Height < lowest - reach || fit->Height > highest + reach);
    if (!fit || isFar || (fit->Spread > most * options.Noise && !isLast))
    {
      continue;
    }
    least = std::max(least, fit->Height - confidence * fit->Spread);
    largest = std::min(largest, fit->Height + confidence * fit->Spread);
    if (least > largest)
    {
      break;
    }
    cutoff = *fit;
    cutoff.Spread = std::max(fit->Spread, options.LeastSpread);
    cutoff.Gap = gap;
  }
  return cutoff;
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
      if (this->HasOuter(true))
      {
        this->KeepOuter();
        return;
      }
    }
    if (this->HasOuter(false))
    {
      this->Picks.clear(); // The horizon ends here: what is beside the fault cannot be compared.
      return;
    }
    // A narrow block has no picks farther away.
    this->Gather(others, side, HalfWindow);
    while (this->Ring > options.DropDistance && !this->HasOuter(false))
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

  CutoffPlace Fit();

private:
  void Gather(const OtherFaults& others, const FaultSide& side, double along);
  bool HasOuter(bool isOnBothSides) const;
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

/// Whether there are enough picks that are not doubtful: over several columns, and before and behind the place along the
/// fault, if they have to be.
bool NearPicks::HasOuter(bool isOnBothSides) const
{
  constexpr double leastWidth = 3.0; // columns
  constexpr std::size_t fewestOnSide = 3;
  double largest = 0.0;
  std::size_t count = 0, before = 0, behind = 0;
  for (const NearPick& near : this->Picks)
  {
    const double away = near.Pick->Distance / this->Options.Column;
    if (away >= this->Ring)
    {
      const double along = (near.Pick->Place.S - this->S) / this->Options.Row;
      largest = std::max(largest, away);
      ++count;
      before += along <= 0.5 ? 1 : 0;
      behind += along >= -0.5 ? 1 : 0;
    }
  }
  return count >= FewestPicks && largest >= this->Ring + leastWidth &&
    (!isOnBothSides || std::min(before, behind) >= fewestOnSide);
}

/// Finds a surface through most of the outer picks, by weights of the inverse distance, which strays do not move. Keeps
/// the picks near it.
void NearPicks::KeepOuter(double width, bool isPlane)
{
  const double column = this->Options.Column;
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
  const LocalPicks table(window, { this->S, middle, window.front()->Pick->Place.Z }, this->Options);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(table.Products.rows());
  constexpr int rounds = 8;
  constexpr double close = 0.02;
  constexpr double normal = 1.4826; // of the median of absolute values
  constexpr double least = 1e-3;
  double scatter = 0.0;
  for (int round = 1;; ++round)
  {
    LocalSurface surface(table, weights, HalfWindow, isPlane);
    const Eigen::VectorXd off = surface.Off(table);
    std::vector<double> sorted(off.begin(), off.end());
    const double before = std::exchange(scatter, normal * UpperMedian(sorted));
    if (round < rounds && (round < 3 || std::abs(scatter - before) > close * scatter))
    {
      const Eigen::ArrayXd distance = off.array().max(std::max(this->Options.Noise, least * scatter));
      weights = (distance > 0.0).select(distance.inverse(), 1.0);
      continue;
    }
    const double deviation = std::hypot(scatter, this->Options.Noise);
    for (std::size_t n = 0; n < window.size(); ++n)
    {
      this->Weigh(off[std::ptrdiff_t(n)], this->Options.DropNoise * deviation, *window[n]);
    }
    const double start = this->Fault.Offset(this->S, window.front()->Pick->Place.Z);
    if (const std::optional<FaultPlace> foot = Meet(this->Fault, surface, this->S, start))
    {
      this->Heights.push_back(foot->Z);
    }
    surface.MeasureSpread(table, weights);
    this->Outer.push_back({ surface, deviation });
    return;
  }
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
  const auto middleOf = [](const std::vector<NearPick*>& ring, auto&& valueOf)
  {
    std::vector<double> values(ring.size());
    std::transform(ring.begin(), ring.end(), values.begin(), valueOf);
    return UpperMedian(values);
  };
  const auto nearness = [column](const NearPick* near) { return -near->Pick->Distance / column; };
  for (const OuterSurface& outer : this->Outer)
  {
    const auto offOf = [&outer](const NearPick* near)
    { return near->Pick->Place.Z - outer.Surface.HeightAt(near->Pick->Place); };
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
      bend[ring] = middleOf(rings[ring], offOf);
      const double distance = -middleOf(rings[ring], nearness);
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
        const double noise =
          this->Options.DropNoise * outer.Scatter * std::sqrt(1.0 + outer.Surface.VarianceAt(near->Pick->Place));
        const double limit = std::max(std::min(noise, most), isBend ? Harmless * shift : 0.0);
        this->Weigh(offOf(near) - (isBend ? bend[ring] : 0.0), limit, *near);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
CutoffPlace NearPicks::Fit()
{
  const double column = this->Options.Column, row = this->Options.Row;
  const double infinity = std::numeric_limits<double>::infinity();
  double gap = infinity, height = 0.0;
  std::array<double, 2> along = { infinity, -infinity };
  std::vector<std::size_t> dropped;
  std::vector<NearPick*> agreeing;
  for (NearPick& near : this->Picks)
  {
    const SidePick& pick = *near.Pick;
    const bool isDoubtful = pick.Distance >= this->Options.DropDistance * column && pick.Distance <= Doubtful * column;
    if (near.Weight == 0.0 && isDoubtful && std::abs(pick.Place.S - this->S) <= 0.5 * row)
    {
      dropped.push_back(pick.Number);
    }
    if (near.Weight == 0.0)
    {
      continue;
    }
    agreeing.push_back(&near);
    along = { std::min(along[0], pick.Place.S), std::max(along[1], pick.Place.S) };
    const double away = Eigen::Vector2d((pick.Place.S - this->S) / row, pick.Distance / column).norm();
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
  CutoffPlace cutoff = FitWidths({ agreeing, foot, this->Options }, this->Fault, gap, this->Options);
  cutoff.IsChecked = this->Ring >= LeastDoubtful;
  cutoff.Dropped = std::move(dropped);
  return cutoff;
}
}

//----------------------------------------------------------------------------------------------------------------------
FaultSide::FaultSide(double first, double last, double width, const std::vector<std::vector<SidePick>>& parts)
  : First(first)
  , Width(width)
  , Strips(std::size_t(std::max(0.0, std::floor((last - first) / width))) + 1)
  , Begins(this->Strips + 2, 0)
{
  const auto forEach = [&parts, this](auto&& visit)
  {
    for (const std::vector<SidePick>& part : parts)
    {
      for (const SidePick& pick : part)
      {
        visit(pick, this->StripOf(pick.Place.S));
      }
    }
  };
  forEach([this](const SidePick&, std::size_t strip) { ++this->Begins[strip + 2]; });
  std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
  this->Picks.resize(this->Begins.back());
  forEach([this](const SidePick& pick, std::size_t strip) { this->Picks[this->Begins[strip + 1]++] = pick; });
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t FaultSide::StripOf(double s) const
{
  return std::size_t(std::clamp((s - this->First) / this->Width, 0.0, double(this->Strips - 1)));
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
