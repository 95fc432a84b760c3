// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Narrow and small systems have a direct solution: Cholesky factors L D L^T within the envelope of each column. Sites
// are ordered row by row if the band is narrow, otherwise by reverse Cuthill-McKee, so that a hole with arms costs no
// more than its arms. Pivots show whether known columns hold the surface.
//
// Other systems use conjugate gradients, preconditioned by a multigrid cycle. Each coarser level has half the sites
// along each axis, and the Galerkin matrix P^T A P of the interpolation P, so that holes may have any shape. Time and
// memory are linear. The interpolation must span surfaces of low energy: bilinear for membranes. Bilinear plates would
// have energy in their creases that grows with each level; quadratic splines (Chaikin's weights 1 3 3 1) have no
// creases, so that the number of cycles hardly depends on the size.

#include "SiteSolver.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// A smaller pivot, relative to its diagonal element, shows that nothing holds the sites: the least pivots of plates of
/// 10^5 columns are near 1e-4 if held, and near 1e-15 otherwise.
constexpr double SmallestPivot = 1e-9;
/// For narrower bands, reordering is not faster.
constexpr std::int32_t NarrowBand = 64;
/// For wider ones, of large systems, multigrid is faster.
constexpr std::int32_t WidestBand = 160;

constexpr std::size_t CoarsestSize = 600; // A direct solution of this size is faster than another cycle.
constexpr int MostCycles = 500;
/// The residual, as the expected error in energy, must fall by this factor.
constexpr double MultigridAccuracy = 1e-11;

// ---- Direct solution ------------------------------------------------------------------------------------------------

using SiteOrder = std::vector<std::int32_t>;

/// The matrix is symmetric, so that one side of the diagonal suffices.
template <int Radius, typename Visitor>
void ForEachCoefficient(const SiteSystem<Radius>& system, Visitor&& visit)
{
  for (std::size_t site = 0; site < system.Sites.Size(); ++site)
  {
    for (int n = StencilMatrix<Radius>::Centre; n < StencilMatrix<Radius>::Length; ++n)
    {
      if (system.Matrix[site][n] != 0.0)
      {
        visit(std::int32_t(site), system.SiteAt(site, n), system.Matrix[site][n]);
      }
    }
  }
}

/// Unreached sites follow, in the same way.
template <int Radius>
SiteOrder ByStepsFrom(std::int32_t start, const SiteSystem<Radius>& system)
{
  const std::int32_t size = std::int32_t(system.Sites.Size());
  std::vector<bool> isReached(size, false);
  SiteOrder order;
  order.reserve(size);
  const auto reach = [&](std::int32_t site)
  {
    if (!isReached[site])
    {
      isReached[site] = true;
      order.push_back(site);
    }
  };
  std::size_t done = 0;
  for (std::int32_t seed = -1; seed < size; ++seed)
  {
    for (reach(seed < 0 ? start : seed); done < order.size(); ++done)
    {
      for (int n = 0; n < StencilMatrix<Radius>::Length; ++n)
      {
        if (system.Matrix[order[done]][n] != 0.0)
        {
          reach(system.SiteAt(std::size_t(order[done]), n));
        }
      }
    }
  }
  return order;
}

template <int Radius>
std::int32_t BandOf(const SiteSystem<Radius>& system, const SiteOrder& order)
{
  SiteOrder position(order.size());
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    position[std::size_t(order[n])] = std::int32_t(n);
  }
  std::int32_t width = 0;
  ForEachCoefficient(system,
    [&](std::int32_t site, std::int32_t other, double)
    { width = std::max(width, std::abs(position[std::size_t(other)] - position[std::size_t(site)])); });
  return width;
}

template <int Radius>
SiteOrder ChooseOrder(const SiteSystem<Radius>& system)
{
  SiteOrder order(system.Sites.Size());
  std::iota(order.begin(), order.end(), 0);
  if (BandOf(system, order) > NarrowBand)
  {
    order = ByStepsFrom(ByStepsFrom(0, system).back(), system); // The last site is at an end of the hole.
    std::reverse(order.begin(), order.end());
  }
  return order;
}

class EnvelopeCholesky final : public SiteSolver
{
public:
  template <int Radius>
  EnvelopeCholesky(const SiteSystem<Radius>& system, SiteOrder order)
    : Order(std::move(order))
    , Ends(Order.size())
  {
    std::iota(this->Ends.begin(), this->Ends.end(), 1); // The diagonal belongs to the envelope even if it is 0.
    std::vector<std::size_t> position(this->Order.size());
    for (std::size_t n = 0; n < position.size(); ++n)
    {
      position[this->Order[n]] = n;
    }
    ForEachCoefficient(system,
      [&](std::int32_t site, std::int32_t other, double)
      {
        const auto [first, last] = std::minmax(position[site], position[other]);
        this->Ends[first] = std::max(this->Ends[first], last + 1);
      });
    this->Allocate();
    ForEachCoefficient(system,
      [&](std::int32_t site, std::int32_t other, double coefficient)
      {
        const auto [first, last] = std::minmax(position[site], position[other]);
        this->Column(first)[last] = coefficient;
      });
    this->Factor();
  }

  bool IsDefinite() const override { return this->Definite; }

  void Solve(std::vector<double>& values, const Monitor&) const override
  {
    assert(values.size() == this->Order.size() && this->Definite);
    std::vector<double> x(values.size());
    std::transform(this->Order.begin(), this->Order.end(), x.begin(), [&](std::int32_t site) { return values[site]; });
    for (std::size_t n = 0; n < x.size(); ++n)
    {
      const double* const column = this->Column(n);
      const double factor = x[n] / column[n];
      for (std::size_t row = n + 1; row < this->Ends[n]; ++row)
      {
        x[row] -= factor * column[row];
      }
    }
    for (std::size_t n = x.size(); n-- > 0;)
    {
      const double* const column = this->Column(n);
      double sum = x[n];
      for (std::size_t row = n + 1; row < this->Ends[n]; ++row)
      {
        sum -= column[row] * x[row];
      }
      x[n] = sum / column[n];
      values[this->Order[n]] = x[n];
    }
  }

private:
  /// A block of columns is used together, so that the columns that it changes are read and written once.
  static constexpr std::size_t Block = 4;

  /// A column reaches as far as earlier columns, which change it; the columns of a block reach equally far.
  void Allocate()
  {
    assert(this->Offsets.empty() && !this->Ends.empty());
    const std::size_t size = this->Ends.size();
    std::partial_sum(this->Ends.begin(), this->Ends.end(), this->Ends.begin(),
      [](std::size_t a, std::size_t b) { return std::max(a, b); });
    std::ptrdiff_t sum = 0;
    for (std::size_t n = 0; n < size; ++n)
    {
      this->Ends[n] = this->Ends[std::min(n | (Block - 1), size - 1)];
      this->Offsets.push_back(sum - std::ptrdiff_t(n));
      sum += std::ptrdiff_t(this->Ends[n] - n);
    }
    this->Values.assign(sum, 0.0);
  }

  void Factor()
  {
    const std::size_t size = this->Order.size();
    std::vector<double> diagonal(size);
    for (std::size_t n = 0; n < size; ++n)
    {
      diagonal[n] = this->Column(n)[n];
    }
    for (std::size_t first = 0; first < size && this->Definite; first += Block)
    {
      this->FactorBlock(first, std::min(first + Block, size), diagonal);
      if (this->Definite && first + Block < size)
      {
        this->SubtractBlock(first);
      }
    }
  }

  void FactorBlock(std::size_t first, std::size_t last, const std::vector<double>& diagonal)
  {
    for (std::size_t n = first; n < last; ++n)
    {
      const double* const column = this->Column(n);
      if (!(column[n] > SmallestPivot * diagonal[n]))
      {
        this->Definite = false;
        return;
      }
      for (std::size_t target = n + 1; target < last; ++target)
      {
        const double factor = column[target] / column[n];
        double* const changed = this->Column(target);
        for (std::size_t row = target; row < this->Ends[n]; ++row)
        {
          changed[row] -= factor * column[row];
        }
      }
    }
  }

  void SubtractBlock(std::size_t first)
  {
    static_assert(Block == 4, "one name for each column");
    const double* const a = this->Column(first);
    const double* const b = this->Column(first + 1);
    const double* const c = this->Column(first + 2);
    const double* const d = this->Column(first + 3);
    const std::size_t end = this->Ends[first];
    for (std::size_t target = first + Block; target < end; ++target)
    {
      if (a[target] == 0.0 && b[target] == 0.0 && c[target] == 0.0 && d[target] == 0.0)
      {
        continue; // The target belongs to another arm of the hole.
      }
      const double byA = a[target] / a[first];
      const double byB = b[target] / b[first + 1];
      const double byC = c[target] / c[first + 2];
      const double byD = d[target] / d[first + 3];
      double* const changed = this->Column(target);
      for (std::size_t row = target; row < end; ++row)
      {
        changed[row] = changed[row] - byA * a[row] - byB * b[row] - byC * c[row] - byD * d[row];
      }
    }
  }

  double* Column(std::size_t n) { return this->Values.data() + this->Offsets[n]; }
  const double* Column(std::size_t n) const { return this->Values.data() + this->Offsets[n]; }

  const SiteOrder Order;
  std::vector<std::size_t> Ends;
  std::vector<std::ptrdiff_t> Offsets;
  std::vector<double> Values;
  bool Definite = true;
};

// ---- The matrix of a level ------------------------------------------------------------------------------------------

/// Most rows, inside the hole, are equal and stored once, so that they stay in the cache. Sites are grouped in
/// stretches whose neighbours are at equal offsets.
template <int Radius>
class StencilTable
{
public:
  static constexpr int Side = StencilMatrix<Radius>::Side;
  using Steps = std::array<std::ptrdiff_t, std::size_t(Side)>;

  struct Row
  {
    typename StencilMatrix<Radius>::Row Coefficients;
    double InverseCentre = 0.0;

    double operator[](int dx) const { return this->Coefficients[std::size_t(StencilMatrix<Radius>::Centre + dx)]; }

    double Rows(int first, int last, const Steps& steps, const double* values) const
    {
      double sum = 0.0;
      for (int dy = first; dy <= last; ++dy)
      {
        const double* const coefficients = this->Coefficients.data() + (dy + Radius) * Side + Radius;
        const double* const beside = values + steps[std::size_t(dy + Radius)];
        double part = 0.0;
        for (int dx = -Radius; dx <= Radius; ++dx)
        {
          part += coefficients[dx] * beside[dx];
        }
        sum += part;
      }
      return sum;
    }

    double Before(const Steps& steps, const double* values) const
    {
      double sum = this->Rows(-Radius, -1, steps, values);
      for (int dx = -Radius; dx < 0; ++dx)
      {
        sum += (*this)[dx] * values[dx]; // The nearest value comes last, as it was computed last.
      }
      return sum;
    }
    double After(const Steps& steps, const double* values) const
    {
      double sum = this->Rows(1, Radius, steps, values);
      for (int dx = Radius; dx > 0; --dx)
      {
        sum += (*this)[dx] * values[dx];
      }
      return sum;
    }
  };

  explicit StencilTable(const SiteSystem<Radius>& system)
  {
    this->FindStretches(system.Sites);
    this->FindRows(system);
  }

  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    for (const Stretch& stretch : this->Stretches)
    {
      for (std::size_t site = stretch.First; site < stretch.End; ++site)
      {
        visit(
          site, stretch.Place + std::int64_t(site - stretch.First), this->Distinct[this->RowOf[site]], stretch.Next);
      }
    }
  }

  template <typename Visitor>
  void ForEachBackwards(Visitor&& visit) const
  {
    for (auto stretch = this->Stretches.rbegin(); stretch != this->Stretches.rend(); ++stretch)
    {
      for (std::size_t site = stretch->End; site-- > stretch->First;)
      {
        visit(
          site, stretch->Place + std::int64_t(site - stretch->First), this->Distinct[this->RowOf[site]], stretch->Next);
      }
    }
  }

private:
  struct Stretch
  {
    std::size_t First;
    std::size_t End;
    std::int64_t Place;
    Steps Next;
  };

  void FindStretches(const SiteBox& sites)
  {
    for (std::size_t site = 0; site < sites.Size(); ++site)
    {
      const std::int64_t place = sites.Place[site];
      Steps next;
      for (int dy = -Radius; dy <= Radius; ++dy)
      {
        next[std::size_t(dy + Radius)] = sites.Near->Beside(place, 0, dy) - place;
      }
      if (site == 0 || sites.Place[site - 1] != place - 1 || this->Stretches.back().Next != next)
      {
        this->Stretches.push_back({ site, site, place, next });
      }
      this->Stretches.back().End = site + 1;
    }
  }

  /// A small hash table of recent rows replaces a full search.
  void FindRows(const SiteSystem<Radius>& system)
  {
    constexpr int hashBits = 12;
    std::vector<std::int32_t> recent(std::size_t(1) << hashBits, 0);
    this->RowOf.reserve(system.Sites.Size());
    for (std::size_t site = 0; site < system.Sites.Size(); ++site)
    {
      const typename StencilMatrix<Radius>::Row& row = system.Matrix[site];
      if (site > 0 && this->Distinct[this->RowOf.back()].Coefficients == row)
      {
        this->RowOf.push_back(this->RowOf.back());
        continue;
      }
      std::uint64_t hash = 0;
      for (const double coefficient : row)
      {
        hash = (hash ^ std::hash<double>()(coefficient)) * 0x9E3779B97F4A7C15U; // The multiplier is the golden ratio.
      }
      std::int32_t& known = recent[hash >> (64 - hashBits)];
      if (this->Distinct.empty() || this->Distinct[known].Coefficients != row)
      {
        known = std::int32_t(this->Distinct.size());
        this->Distinct.push_back({ row, 1.0 / row[StencilMatrix<Radius>::Centre] });
      }
      this->RowOf.push_back(known);
    }
  }

  std::vector<Stretch> Stretches;
  std::vector<std::int32_t> RowOf; // by site, in Distinct
  std::vector<Row> Distinct;
};

// ---- Multigrid ------------------------------------------------------------------------------------------------------

struct CoarsePair
{
  std::int64_t Low;
  double LowWeight;
  double HighWeight;
};

/// Interpolation is linear for membranes, and by quadratic splines for plates.
template <int Radius>
CoarsePair Coarsened(std::int64_t x)
{
  if constexpr (Radius == 1)
  {
    const std::int64_t low = (x >> 1) + SiteBox::Margin;
    return x % 2 == 0 ? CoarsePair{ low, 1.0, 0.0 } : CoarsePair{ low, 0.5, 0.5 };
  }
  else
  {
    const std::int64_t low = ((x + 1) >> 1) - 1 + SiteBox::Margin;
    return x % 2 == 0 ? CoarsePair{ low, 0.25, 0.75 } : CoarsePair{ low, 0.75, 0.25 };
  }
}

template <int Radius, typename Visitor>
void ForEachCoarse(const PlanePoint& column, std::int64_t low, const BoxPlaces& coarser, Visitor&& visit)
{
  const CoarsePair along = Coarsened<Radius>(column.X);
  const CoarsePair across = Coarsened<Radius>(column.Y);
  for (int high = 0; high < 2; ++high)
  {
    const double weight = high == 0 ? across.LowWeight : across.HighWeight;
    if (weight > 0.0)
    {
      const std::int64_t place = high == 0 ? low : coarser.Above(low);
      visit(place, weight * along.LowWeight);
      if (along.HighWeight > 0.0)
      {
        visit(place + 1, weight * along.HighWeight);
      }
    }
  }
}

constexpr int CoarseReach = 4;
using CoarseRow = std::array<double, CoarseReach>;

template <int Radius>
CoarseRow ToCoarse(const double* values, std::int64_t first)
{
  CoarseRow result{};
  const std::int64_t begin = Coarsened<Radius>(first).Low;
  for (int n = 0; n < StencilMatrix<Radius>::Side; ++n)
  {
    const CoarsePair coarse = Coarsened<Radius>(first + n);
    result[coarse.Low - begin] += coarse.LowWeight * values[n];
    if (coarse.HighWeight > 0.0)
    {
      result[coarse.Low - begin + 1] += coarse.HighWeight * values[n];
    }
  }
  return result;
}

/// A row of A P is computed along x, then along y.
template <int Radius>
std::array<CoarseRow, CoarseReach> CoarseImage(const double* row, std::int64_t x, std::int64_t y)
{
  constexpr int side = StencilMatrix<Radius>::Side;
  std::array<CoarseRow, std::size_t(side)> alongX;
  for (int n = 0; n < side; ++n)
  {
    alongX[n] = ToCoarse<Radius>(row + n * side, x - Radius);
  }
  std::array<CoarseRow, CoarseReach> image;
  for (int column = 0; column < CoarseReach; ++column)
  {
    std::array<double, std::size_t(side)> values;
    std::transform(
      alongX.begin(), alongX.end(), values.begin(), [column](const CoarseRow& sums) { return sums[column]; });
    const CoarseRow sums = ToCoarse<Radius>(values.data(), y - Radius);
    for (int n = 0; n < CoarseReach; ++n)
    {
      image[n][column] = sums[n];
    }
  }
  return image;
}

/// Vectors have a number for each place of the box, 0 without a site, so that rows of the matrix need no indices.
template <int Radius>
class GridLevel
{
public:
  explicit GridLevel(const SiteSystem<Radius>& system)
    : Solution(system.Sites.Number.size(), 0.0)
    , System(system)
    , Table(system)
  {
  }

  explicit GridLevel(std::unique_ptr<SiteSystem<Radius>> system)
    : Solution(system->Sites.Number.size(), 0.0)
    , Own(std::move(system))
    , System(*this->Own)
    , Table(*this->Own)
  {
  }

  std::size_t Size() const { return this->System.Sites.Size(); }

  std::unique_ptr<SiteSystem<Radius>> MakeCoarser()
  {
    SiteBox sites = SiteBox::Fill(this->CoarseRuns());
    this->CoarseOf.reserve(this->Size());
    for (std::size_t site = 0; site < this->Size(); ++site)
    {
      const PlanePoint column = this->ColumnOf(site);
      this->CoarseOf.push_back(sites.Near->Find(
        { std::int32_t(Coarsened<Radius>(column.X).Low), std::int32_t(Coarsened<Radius>(column.Y).Low) }));
    }
    auto coarse = std::make_unique<SiteSystem<Radius>>(std::move(sites));
    for (std::size_t site = 0; site < this->Size(); ++site)
    {
      this->AddCoarseRows(site, *coarse);
    }
    return coarse;
  }

  /// Coarse surfaces that agree on all fine sites make the matrix singular, which is harmless; a slightly larger
  /// diagonal makes it regular.
  void Factor()
  {
    constexpr double trifle = 1e-8;
    SiteSystem<Radius> regular = this->System;
    for (std::size_t site = 0; site < this->Size(); ++site)
    {
      regular.Matrix[site][StencilMatrix<Radius>::Centre] *= 1.0 + trifle;
    }
    this->Direct.emplace(regular, ChooseOrder(regular));
  }

  void Multiply(const std::vector<double>& values, std::vector<double>& product) const
  {
    this->Table.ForEach([&](std::size_t, std::int64_t place, const Row& row, const Steps& steps)
      { product[place] = row.Rows(-Radius, Radius, steps, values.data() + place); });
  }

  // A cycle is a Gauss-Seidel sweep from 0, restriction of the residual, interpolation of the coarser solution, and a
  // sweep in reverse order.

  /// Sites after the current one are still 0.
  void SmoothFromNothing()
  {
    this->Table.ForEach(
      [this](std::size_t, std::int64_t place, const Row& row, const Steps& steps)
      {
        double* const value = this->Solution.data() + place;
        *value = (this->Side[place] - row.Before(steps, value)) * row.InverseCentre;
      });
  }

  /// After that sweep, the residual comes from later sites alone.
  void RestrictResidual(GridLevel& coarser) const
  {
    coarser.Side.assign(coarser.System.Sites.Number.size(), 0.0);
    this->Table.ForEach(
      [&](std::size_t site, std::int64_t place, const Row& row, const Steps& steps)
      {
        const double rest = -row.After(steps, this->Solution.data() + place);
        this->ForEachCoarseOf(site, coarser.System.Sites,
          [&](std::int64_t coarse, double weight) { coarser.Side[coarse] += weight * rest; });
      });
  }

  void AddInterpolated(const GridLevel& coarser)
  {
    for (std::size_t site = 0; site < this->Size(); ++site)
    {
      const std::int64_t place = this->System.Sites.Place[site];
      this->ForEachCoarseOf(site, coarser.System.Sites,
        [&](std::int64_t coarse, double weight) { this->Solution[place] += weight * coarser.Solution[coarse]; });
    }
  }

  void SmoothBackwards()
  {
    this->Table.ForEachBackwards(
      [this](std::size_t, std::int64_t place, const Row& row, const Steps& steps)
      {
        double* const value = this->Solution.data() + place;
        const double before = this->Side[place] - row.Before(steps, value);
        *value = (before - row.After(steps, value)) * row.InverseCentre;
      });
  }

  void SolveDirectly()
  {
    std::vector<double> values = this->AtSites(this->Side);
    this->Direct->Solve(values, Monitor());
    this->Solution = this->AtPlaces(values);
  }

  std::vector<double> AtPlaces(const std::vector<double>& atSites) const
  {
    std::vector<double> result(this->System.Sites.Number.size(), 0.0);
    for (std::size_t site = 0; site < atSites.size(); ++site)
    {
      result[this->System.Sites.Place[site]] = atSites[site];
    }
    return result;
  }

  std::vector<double> AtSites(const std::vector<double>& atPlaces) const
  {
    std::vector<double> result(this->Size());
    std::transform(this->System.Sites.Place.begin(), this->System.Sites.Place.end(), result.begin(),
      [&](std::int64_t place) { return atPlaces[place]; });
    return result;
  }

  std::vector<double> Side;
  std::vector<double> Solution;

private:
  using Row = typename StencilTable<Radius>::Row;
  using Steps = typename StencilTable<Radius>::Steps;

  template <typename Visitor>
  void ForEachCoarseOf(std::size_t site, const SiteBox& coarse, Visitor&& visit) const
  {
    ForEachCoarse<Radius>(this->ColumnOf(site), this->CoarseOf[site], *coarse.Near, visit);
  }

  PlanePoint ColumnOf(std::size_t site) const
  {
    return this->System.Sites.Near->Column(this->System.Sites.Place[site]);
  }

  std::vector<BoxRun> CoarseRuns() const
  {
    std::vector<BoxRun> fine;
    fine.reserve(this->Size());
    for (std::size_t site = 0; site < this->Size(); ++site)
    {
      const PlanePoint column = this->ColumnOf(site);
      fine.push_back({ column.Y, column.X, column.X });
    }
    std::vector<BoxRun> coarse;
    for (const BoxRun& run : Merged(std::move(fine)))
    {
      const CoarsePair last = Coarsened<Radius>(run.Last);
      const CoarsePair across = Coarsened<Radius>(run.Row);
      const BoxRun low = { std::int32_t(across.Low), std::int32_t(Coarsened<Radius>(run.First).Low),
        std::int32_t(last.Low + (last.HighWeight > 0.0 ? 1 : 0)) };
      coarse.push_back(low);
      if (across.HighWeight > 0.0)
      {
        coarse.push_back({ low.Row + 1, low.First, low.Last });
      }
    }
    return Merged(std::move(coarse));
  }

  void AddCoarseRows(std::size_t site, SiteSystem<Radius>& coarse) const
  {
    const PlanePoint column = this->ColumnOf(site);
    const std::array<CoarseRow, CoarseReach> image =
      CoarseImage<Radius>(this->System.Matrix[site].data(), column.X, column.Y);
    const std::int64_t beginX = Coarsened<Radius>(column.X - Radius).Low;
    const std::int64_t beginY = Coarsened<Radius>(column.Y - Radius).Low;
    this->ForEachCoarseOf(site, coarse.Sites,
      [&](std::int64_t place, double weight)
      {
        typename StencilMatrix<Radius>::Row& target = coarse.Matrix[coarse.Sites.Number[place]];
        const PlanePoint centre = coarse.Sites.Near->Column(place);
        const std::int64_t dx = beginX - centre.X;
        const std::int64_t dy = beginY - centre.Y;
        for (int row = 0; row < CoarseReach; ++row)
        {
          for (int file = 0; file < CoarseReach; ++file)
          {
            if (image[row][file] != 0.0)
            {
              target[StencilMatrix<Radius>::Index(dx + file, dy + row)] += weight * image[row][file];
            }
          }
        }
      });
  }

  const std::unique_ptr<SiteSystem<Radius>> Own; // null on the finest level
  const SiteSystem<Radius>& System;
  const StencilTable<Radius> Table;
  std::vector<std::int64_t> CoarseOf;
  std::optional<EnvelopeCholesky> Direct;
};

double Product(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void AddTo(std::vector<double>& a, double factor, const std::vector<double>& b)
{
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    a[n] += factor * b[n];
  }
}

template <int Radius>
class Multigrid final : public SiteSolver
{
public:
  explicit Multigrid(const SiteSystem<Radius>& system)
  {
    this->Levels.push_back(std::make_unique<GridLevel<Radius>>(system));
    bool isSmaller = true;
    while (isSmaller && this->Levels.back()->Size() > CoarsestSize)
    {
      auto coarser = this->Levels.back()->MakeCoarser();
      isSmaller = coarser->Sites.Size() < this->Levels.back()->Size();
      this->Levels.push_back(std::make_unique<GridLevel<Radius>>(std::move(coarser)));
    }
    this->Levels.back()->Factor();
  }

  void Solve(std::vector<double>& values, const Monitor& monitor) const override
  {
    assert(!this->Levels.empty());
    const GridLevel<Radius>& finest = *this->Levels.front();
    std::vector<double> residual = finest.AtPlaces(values);
    std::vector<double> solution(residual.size(), 0.0);
    std::vector<double> corrected(residual.size(), 0.0);
    std::vector<double> direction(residual.size(), 0.0);
    std::vector<double> image(residual.size(), 0.0);
    this->Cycle(residual, corrected);
    double energy = Product(residual, corrected);
    const double enough = MultigridAccuracy * MultigridAccuracy * energy;
    double before = 0.0;
    int cycle = 0;
    for (; energy > enough && cycle < MostCycles; ++cycle)
    {
      monitor.Progress(1.0 - 1.0 / (1.0 + 0.1 * cycle));
      const double part = before > 0.0 ? energy / before : 0.0;
      for (std::size_t n = 0; n < direction.size(); ++n)
      {
        direction[n] = corrected[n] + part * direction[n];
      }
      finest.Multiply(direction, image);
      const double step = energy / Product(direction, image);
      AddTo(solution, step, direction);
      AddTo(residual, -step, image);
      this->Cycle(residual, corrected);
      before = energy;
      energy = Product(residual, corrected);
    }
    if (!(energy <= enough))
    {
      throw InputError("the surface over a hole of " + std::to_string(finest.Size()) +
        " unknowns did not converge in " + std::to_string(MostCycles) +
        " cycles, expected a few dozen at most; Membrane converges faster than Plate");
    }
    values = finest.AtSites(solution);
  }

private:
  /// The cycle is symmetric, as conjugate gradients require.
  void Cycle(const std::vector<double>& side, std::vector<double>& solution) const
  {
    this->Levels.front()->Side = side;
    this->Descend(0);
    solution.swap(this->Levels.front()->Solution);
  }

  void Descend(std::size_t n) const
  {
    GridLevel<Radius>& level = *this->Levels[n];
    if (n + 1 == this->Levels.size())
    {
      level.SolveDirectly();
      return;
    }
    GridLevel<Radius>& coarser = *this->Levels[n + 1];
    level.SmoothFromNothing();
    level.RestrictResidual(coarser);
    this->Descend(n + 1);
    level.AddInterpolated(coarser);
    level.SmoothBackwards();
  }

  std::vector<std::unique_ptr<GridLevel<Radius>>> Levels;
};

}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
std::unique_ptr<const SiteSolver> MakeSiteSolver(const SiteSystem<Radius>& system)
{
  SiteOrder order = ChooseOrder(system);
  if (system.Sites.Size() < MultigridSize || BandOf(system, order) <= WidestBand)
  {
    return std::make_unique<const EnvelopeCholesky>(system, std::move(order));
  }
  return std::make_unique<const Multigrid<Radius>>(system);
}

template std::unique_ptr<const SiteSolver> MakeSiteSolver(const SiteSystem<1>& system);
template std::unique_ptr<const SiteSolver> MakeSiteSolver(const SiteSystem<2>& system);
}
