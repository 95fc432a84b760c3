// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: the lattice; nearest picks; the convex hull; the plate.

#include "Gridding.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/Errors.h"
#include "Common/Base/LeastSquares.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ConvexHull.h"
#include "Common/Survey/ColumnOrder.h"
#include "Common/Survey/PickWarnings.h"
#include "Common/Survey/StrayPicks.h"
#include "Common/Survey/SurveyMap.h"
#include "Filters/Algorithms/HoleFilling/PlateEnergy.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr double AllowedColumns = 1e6; // for any number of picks
constexpr double MostLatticeColumns = 1 << 28;
constexpr double LeastSmoothing = 1e-6;
// Tension holds a plate beside a single line, and is too weak to show elsewhere.
constexpr double Tension = 1e-6;

/// Places are in columns, ordered by x, then y, in the world, so that ties do not depend on the file.
struct Picks
{
  std::vector<Eigen::Vector2d> Place;
  std::vector<double> Z;
};

// ---- The lattice ----------------------------------------------------------------------------------------------------

double RoundLatticeStep(double step)
{
  const double unit = std::pow(10.0, std::floor(std::log10(step)));
  double best = unit;
  for (const double factor : { 2.0, 5.0, 10.0 })
  {
    best = std::abs(std::log(factor * unit / step)) < std::abs(std::log(best / step)) ? factor * unit : best;
  }
  return best;
}

SurveyLattice AutomaticLattice(const Eigen::AlignedBox2d& box, std::size_t picks)
{
  assert(!box.isEmpty());
  const Eigen::Vector2d extent = box.sizes();
  const double area = extent.x() * extent.y();
  const double step = area > 0.0 ? std::sqrt(area / double(picks)) : std::max(extent.x(), extent.y()) / double(picks);
  const double size = step > 0.0 && std::isfinite(step) ? RoundLatticeStep(step) : 1.0;
  SurveyLattice lattice;
  lattice.ColumnStep = size * Eigen::Vector2d::UnitX();
  lattice.RowStep = size * Eigen::Vector2d::UnitY();
  lattice.Origin = size * (box.min() / size).array().floor();
  return lattice;
}

/// The radius enlarges the lattice.
SurveyLattice FindGrid(
  const std::vector<Eigen::Vector2d>& places, const GriddingOptions& options, const std::string& strays)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& place : places)
  {
    box.extend(place);
  }
  SurveyLattice lattice = AutomaticLattice(box, places.size());
  if (options.Placement.Source == LatticeSource::OriginAndSteps)
  {
    lattice.Origin = options.Placement.Origin;
    lattice.ColumnStep = options.Placement.ColumnStep;
    lattice.RowStep = options.Placement.RowStep;
  }
  const Eigen::Matrix2d toColumns = lattice.Steps().inverse();
  Eigen::AlignedBox2d columns;
  for (const Eigen::Vector2d& place : places)
  {
    columns.extend(toColumns * (place - lattice.Origin));
  }
  const Eigen::Vector2d margin = options.Radius * toColumns.rowwise().norm();
  const Eigen::Vector2d first = (columns.min() - margin).array().floor();
  const Eigen::Vector2d last = (columns.max() + margin).array().ceil();
  const Eigen::Vector2d size = last - first + Eigen::Vector2d::Ones();
  if (!(size.prod() <=
        std::min(MostLatticeColumns, std::max(AllowedColumns, MostColumnsPerPick * double(places.size())))))
  {
    std::ostringstream text;
    text.precision(12);
    text << "grid of " << size.x() << " x " << size.y() << " columns for " << places.size()
         << " picks, expected at most " << MostColumnsPerPick
         << " columns a pick and 2^28 in all: choose longer steps, or a smaller GriddingRadius"
         << (strays.empty() ? "" : "; StrayPicks leaves out what is far from all others, " + strays);
    throw InputError(text.str());
  }
  lattice.Origin += lattice.Steps() * first;
  lattice.Columns = { int(size.x()), int(size.y()) };
  return lattice;
}

// ---- Nearest picks --------------------------------------------------------------------------------------------------

/// Nodes are medians along the longer axis of their box.
class PickSearch
{
public:
  explicit PickSearch(const std::vector<Eigen::Vector2d>& places)
    : Places(places)
    , Order(places.size())
    , Boxes(places.size())
  {
    assert(!places.empty());
    std::iota(this->Order.begin(), this->Order.end(), 0);
    this->Build(0, this->Order.size());
  }

  struct Found
  {
    std::int32_t Pick = -1; // the first of equally near picks
    double Distance = std::numeric_limits<double>::infinity();
  };

  Found Find(const Eigen::Vector2d& place) const
  {
    Found found;
    this->Look(0, this->Order.size(), place, found);
    return found;
  }

private:
  static int LongAxis(const Eigen::AlignedBox2d& box) { return box.sizes().y() > box.sizes().x() ? 1 : 0; }

  const Eigen::Vector2d& PlaceAt(std::size_t node) const { return this->Places[std::size_t(this->Order[node])]; }

  void Build(std::size_t first, std::size_t last)
  {
    if (first == last)
    {
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    for (std::size_t node = first; node < last; ++node)
    {
      this->Boxes[middle].extend(this->PlaceAt(node));
    }
    const int axis = LongAxis(this->Boxes[middle]);
    const auto begin = this->Order.begin();
    std::nth_element(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(middle), begin + std::ptrdiff_t(last),
      [&](std::int32_t a, std::int32_t b)
      { return this->Places[std::size_t(a)][axis] < this->Places[std::size_t(b)][axis]; });
    this->Build(first, middle);
    this->Build(middle + 1, last);
  }

  void Look(std::size_t first, std::size_t last, const Eigen::Vector2d& place, Found& found) const
  {
    const std::size_t middle = first + (last - first) / 2;
    if (first == last || this->Boxes[middle].exteriorDistance(place) > found.Distance)
    {
      return;
    }
    const std::int32_t pick = this->Order[middle];
    const double distance = (this->PlaceAt(middle) - place).norm();
    if (distance < found.Distance || (distance == found.Distance && pick < found.Pick))
    {
      found = { pick, distance };
    }
    const int axis = LongAxis(this->Boxes[middle]);
    const bool isBelow = place[axis] < this->PlaceAt(middle)[axis];
    for (const bool looksBelow : { isBelow, !isBelow })
    {
      this->Look(looksBelow ? first : middle + 1, looksBelow ? middle : last, place, found);
    }
  }

  const std::vector<Eigen::Vector2d>& Places;
  std::vector<std::int32_t> Order;
  std::vector<Eigen::AlignedBox2d> Boxes;
};

// ---- The convex hull ------------------------------------------------------------------------------------------------

/// Returns the first and last column within the hull.
std::array<int, 2> SpanOf(const std::vector<Eigen::Vector2d>& hull, double row)
{
  constexpr double rounding = 1e-9; // of a step
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (std::size_t n = 0; n < hull.size(); ++n)
  {
    const Eigen::Vector2d& a = hull[n];
    const Eigen::Vector2d& b = hull[(n + 1) % hull.size()];
    if (std::min(a.y(), b.y()) <= row + rounding && std::max(a.y(), b.y()) >= row - rounding)
    {
      const double part = a.y() == b.y() ? 0.0 : std::clamp((row - a.y()) / (b.y() - a.y()), 0.0, 1.0);
      const double x = a.x() + part * (b.x() - a.x());
      least = std::min(least, a.y() == b.y() ? std::min(a.x(), b.x()) : x);
      greatest = std::max(greatest, a.y() == b.y() ? std::max(a.x(), b.x()) : x);
    }
  }
  return least <= greatest
    ? std::array<int, 2>{ int(std::ceil(least - rounding)), int(std::floor(greatest + rounding)) }
    : std::array<int, 2>{ 0, -1 };
}

// ---- One horizon ----------------------------------------------------------------------------------------------------

/// Noise of picks on a line, or in two wells, would tilt the plane across. It is level where places deviate by less
/// than half a step, or a fiftieth of the other direction; if none is off by a step, picks move onto the line.
struct Trend
{
  Eigen::Vector3d Plane; // z at column (0, 0), and slopes
  std::vector<Eigen::Vector2d> Places; // in columns

  Trend(const Picks& picks, const Eigen::Matrix2d& steps)
  {
    assert(!picks.Z.empty() && picks.Place.size() == picks.Z.size());
    constexpr double leastSteps = 0.5;
    constexpr double leastPart = 0.02;
    const double count = double(picks.Z.size());
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double mean = 0.0;
    for (std::size_t n = 0; n < picks.Z.size(); ++n)
    {
      middle += picks.Place[n] / count;
      mean += picks.Z[n] / count;
    }
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Eigen::Vector2d side = Eigen::Vector2d::Zero();
    for (std::size_t n = 0; n < picks.Z.size(); ++n)
    {
      const Eigen::Vector2d off = steps * (picks.Place[n] - middle);
      spread += off * off.transpose() / count;
      side += off * (picks.Z[n] - mean) / count;
    }
    const PrincipalAxes<2> axes = FindPrincipalAxes(spread);
    const Eigen::Vector2d deviation = axes.Values.cwiseMax(0.0).cwiseSqrt();
    const double step = std::sqrt(std::abs(steps.determinant()));
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    this->Places = picks.Place;
    for (const int n : { 0, 1 })
    {
      const Eigen::Vector2d axis = axes.Axes.col(n);
      if (deviation[n] >= std::max(leastSteps * step, leastPart * deviation[1]))
      {
        slope += axis * (axis.dot(side) / axes.Values[n]);
        continue;
      }
      const auto off = [&](const Eigen::Vector2d& place) { return axis.dot(steps * (place - middle)); };
      if (std::all_of(picks.Place.begin(), picks.Place.end(),
            [&](const Eigen::Vector2d& place) { return std::abs(off(place)) <= step; }))
      {
        const Eigen::Vector2d across = steps.inverse() * axis;
        for (Eigen::Vector2d& place : this->Places)
        {
          place -= off(place) * across;
        }
      }
    }
    slope = steps.transpose() * slope; // in columns
    this->Plane = { mean - slope.dot(middle), slope.x(), slope.y() };
  }
};

struct Spring
{
  Eigen::Vector2d Place = Eigen::Vector2d::Zero();
  double Z = 0.0; // above the plane
  double Picks = 0.0;
};

/// Picks within a tenth of a column share a spring, as their noise would tilt the plate, for example in a well.
std::vector<Spring> MakeSprings(const std::vector<double>& z, const Trend& trend)
{
  assert(trend.Places.size() == z.size());
  constexpr double near = 0.1;
  std::vector<Spring> springs;
  std::vector<Eigen::Vector2d> firsts;
  std::unordered_multimap<std::int64_t, std::size_t> found; // by squares of side `near`
  const auto square = [](double x, double y) { return (std::int64_t(y) << 32) + std::int64_t(x); };
  for (std::size_t pick = 0; pick < z.size(); ++pick)
  {
    const Eigen::Vector2d& place = trend.Places[pick];
    const Eigen::Vector2d at = (place / near).array().floor();
    std::size_t best = springs.size();
    for (int n = 0; n < 9; ++n)
    {
      const auto range = found.equal_range(square(at.x() + n % 3 - 1, at.y() + n / 3 - 1));
      for (auto spring = range.first; spring != range.second; ++spring)
      {
        best = (firsts[spring->second] - place).norm() < near ? std::min(best, spring->second) : best;
      }
    }
    if (best == springs.size())
    {
      found.emplace(square(at.x(), at.y()), best);
      firsts.push_back(place);
      springs.emplace_back();
    }
    springs[best].Place += place;
    springs[best].Z += z[pick] - trend.Plane[0] - trend.Plane[1] * place.x() - trend.Plane[2] * place.y();
    springs[best].Picks += 1.0;
  }
  for (Spring& spring : springs)
  {
    spring.Place = (spring.Place / spring.Picks).cwiseMax(0.0);
    spring.Z /= spring.Picks;
  }
  return springs;
}

/// All places need sites.
template <typename Left, typename Right>
void AddProduct(SiteSystem<2>& system, std::int64_t place, const Left& left, const Right& right, double weight)
{
  const auto add = [&](const PlateTerm& from, const PlateTerm& to)
  {
    const std::int32_t site = system.Sites.Number[std::size_t(system.Sites.Near->Beside(place, from.X, from.Y))];
    assert(site != NoSite);
    system.Matrix[std::size_t(site)][StencilMatrix<2>::Index(to.X - from.X, to.Y - from.Y)] +=
      0.5 * weight * from.Coefficient * to.Coefficient;
  };
  for (const PlateTerm& a : left)
  {
    for (const PlateTerm& b : right)
    {
      add(a, b);
      add(b, a);
    }
  }
}

class HorizonGridder
{
public:
  HorizonGridder(const Picks& picks, const SurveyLattice& lattice, const GriddingOptions& options)
    : Given(picks)
    , Lattice(lattice)
    , Options(options)
    , Width(lattice.Columns[0])
    , Height(lattice.Columns[1])
  {
  }

  LatticeHorizon Run(const Monitor& monitor)
  {
    this->FindNearest(monitor.Step(0.0, 0.4));
    this->CountPicks();
    this->ChooseColumns();
    if (this->Options.Method == GriddingMethod::Plate)
    {
      this->SolvePlate(monitor.Step(0.4, 1.0));
    }
    else
    {
      for (const std::size_t column : this->Kept)
      {
        this->Result[column] = this->Given.Z[std::size_t(this->Nearest[column].Pick)];
      }
    }
    return this->MakeHorizon();
  }

private:
  std::size_t CellOf(int i, int j) const { return std::size_t(j) * std::size_t(this->Width) + std::size_t(i); }

  std::array<int, 2> ColumnOf(std::size_t pick) const
  {
    const Eigen::Vector2d& place = this->Given.Place[pick];
    return { std::clamp(int(std::lround(place.x())), 0, this->Width - 1),
      std::clamp(int(std::lround(place.y())), 0, this->Height - 1) };
  }

  void FindNearest(const Monitor& monitor)
  {
    const Eigen::Matrix2d steps = this->Lattice.Steps();
    std::vector<Eigen::Vector2d> places;
    for (const Eigen::Vector2d& place : this->Given.Place)
    {
      places.push_back(steps * place);
    }
    const PickSearch search(places);
    this->Nearest.resize(std::size_t(this->Width) * std::size_t(this->Height));
    ParallelFor(this->Height, 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (int j = int(first); j < int(last); ++j)
        {
          for (int i = 0; i < this->Width; ++i)
          {
            this->Nearest[this->CellOf(i, j)] = search.Find(steps * Eigen::Vector2d(i, j));
          }
        }
      });
  }

  void CountPicks()
  {
    this->Count.assign(this->Nearest.size(), 0);
    for (std::size_t pick = 0; pick < this->Given.Z.size(); ++pick)
    {
      const auto [i, j] = this->ColumnOf(pick);
      ++this->Count[this->CellOf(i, j)];
    }
  }

  void ChooseColumns()
  {
    const std::vector<Eigen::Vector2d> hull = FindHull(this->Given.Place);
    for (int j = 0; j < this->Height; ++j)
    {
      const std::array<int, 2>& span = this->Spans.emplace_back(SpanOf(hull, j));
      for (int i = 0; i < this->Width; ++i)
      {
        const std::size_t column = this->CellOf(i, j);
        const bool isNear = this->Options.Radius > 0.0 ? this->Nearest[column].Distance <= this->Options.Radius
                                                       : i >= span[0] && i <= span[1];
        if (isNear || this->Count[column] > 0)
        {
          this->Kept.push_back(column);
        }
      }
    }
    this->Result.assign(this->Nearest.size(), 0.0);
  }

  /// Areas without a spring would float, and are left out.
  std::vector<BoxRun> PlateRuns(const std::vector<Spring>& springs)
  {
    std::vector<char> isIn(this->Nearest.size(), 0);
    for (const std::size_t column : this->Kept)
    {
      isIn[column] = 1;
    }
    for (const Spring& spring : springs)
    {
      const auto [i, j] = Corner(spring.Place);
      for (const int dj : { 0, 1 })
      {
        for (const int di : { 0, 1 })
        {
          isIn[this->CellOf(std::min(i + di, this->Width - 1), std::min(j + dj, this->Height - 1))] = 1;
        }
      }
    }
    this->DropLoose(isIn, springs);
    std::vector<BoxRun> runs;
    for (int j = 0; j < this->Height; ++j)
    {
      for (int i = 0; i < this->Width; ++i)
      {
        if (isIn[this->CellOf(i, j)] && (i == 0 || !isIn[this->CellOf(i - 1, j)]))
        {
          runs.push_back({ j, i, i });
        }
        if (isIn[this->CellOf(i, j)])
        {
          runs.back().Last = i;
        }
      }
    }
    return runs;
  }

  void DropLoose(std::vector<char>& isIn, const std::vector<Spring>& springs)
  {
    DisjointSets pieces(isIn.size());
    for (std::size_t cell = 0; cell < isIn.size(); ++cell)
    {
      if (isIn[cell] && (cell + 1) % std::size_t(this->Width) != 0 && isIn[cell + 1])
      {
        pieces.Join(std::int32_t(cell), std::int32_t(cell + 1));
      }
      if (isIn[cell] && cell + std::size_t(this->Width) < isIn.size() && isIn[cell + std::size_t(this->Width)])
      {
        pieces.Join(std::int32_t(cell), std::int32_t(cell + std::size_t(this->Width)));
      }
    }
    std::vector<char> isHeld(isIn.size(), 0);
    for (const Spring& spring : springs)
    {
      const auto [i, j] = Corner(spring.Place);
      isHeld[std::size_t(pieces.Find(std::int32_t(this->CellOf(i, j))))] = 1;
    }
    for (std::size_t cell = 0; cell < isIn.size(); ++cell)
    {
      isIn[cell] = isIn[cell] && isHeld[std::size_t(pieces.Find(std::int32_t(cell)))] ? 1 : 0;
    }
    this->Kept.erase(
      std::remove_if(this->Kept.begin(), this->Kept.end(), [&](std::size_t cell) { return !isIn[cell]; }),
      this->Kept.end());
  }

  static std::array<int, 2> Corner(const Eigen::Vector2d& place)
  {
    return { int(std::floor(place.x())), int(std::floor(place.y())) };
  }

  void SolvePlate(const Monitor& monitor)
  {
    const Trend trend(this->Given, this->Lattice.Steps());
    const std::vector<Spring> springs = MakeSprings(this->Given.Z, trend);
    SiteSystem<2> plate(SiteBox::Fill(this->PlateRuns(springs)));
    this->AddEnergy(plate);
    std::vector<double> values = this->AddSprings(plate, springs);
    MakeSiteSolver(plate)->Solve(values, monitor);
    // Rounding errors would become vertical steps of level areas.
    const double largest = std::max(std::abs(*std::min_element(this->Given.Z.begin(), this->Given.Z.end())),
      std::abs(*std::max_element(this->Given.Z.begin(), this->Given.Z.end())));
    const double unit = largest > 0.0 ? std::exp2(std::ceil(std::log2(largest)) - 32.0) : 1.0;
    for (const std::size_t column : this->Kept)
    {
      const int i = int(column % std::size_t(this->Width));
      const int j = int(column / std::size_t(this->Width));
      const double z = trend.Plane[0] + trend.Plane[1] * i + trend.Plane[2] * j +
        values[std::size_t(plate.Sites.Number[std::size_t(plate.Sites.Near->Find({ i, j }))])];
      this->Result[column] = unit * std::round(z / unit);
    }
  }

  /// Bending in the world is trace(G H G H), H the second differences, G the inverse products of steps times their
  /// area. Multigrid hardly converges beyond steps of 1 to 4, which limit its metric.
  Eigen::Matrix2d Metric(std::size_t sites) const
  {
    const double most = sites < MultigridSize ? 100.0 : 4.0;
    const Eigen::Matrix2d steps = this->Lattice.Steps();
    const Eigen::Matrix2d squares = steps.transpose() * steps / std::abs(steps.determinant());
    const PrincipalAxes<2> axes = FindPrincipalAxes(Eigen::Matrix2d(squares.inverse()));
    return axes.Axes * axes.Values.cwiseMax(1.0 / most).cwiseMin(most).asDiagonal() * axes.Axes.transpose();
  }

  void AddEnergy(SiteSystem<2>& plate) const
  {
    const Eigen::Matrix2d metric = this->Metric(plate.Sites.Size());
    const double x = metric(0, 0);
    const double y = metric(1, 1);
    const double shear = std::abs(metric(0, 1)) > 1e-9 * std::max(x, y) ? metric(0, 1) : 0.0;
    const auto isIn = [&](std::int64_t place) { return plate.Sites.Number[std::size_t(place)] != NoSite; };
    ForEachPlateStencil(
      *plate.Sites.Near, isIn, [](std::int64_t, std::int64_t) { return true; }, [](std::int64_t) { return true; },
      [&](std::int64_t place, const auto& terms, double weight)
      {
        const double square = terms.size() == 4 ? x * y + shear * shear : terms[0].X != 0 ? x * x : y * y;
        AddSquare(plate, place, terms, weight * square);
      });
    static constexpr std::array<PlateTerm, 2> alongX = { { { 0, 0, -1.0 }, { 1, 0, 1.0 } } };
    static constexpr std::array<PlateTerm, 2> alongY = { { { 0, 0, -1.0 }, { 0, 1, 1.0 } } };
    for (std::size_t site = 0; site < plate.Sites.Size(); ++site)
    {
      const std::int64_t place = plate.Sites.Place[site];
      if (isIn(place + 1))
      {
        AddSquare(plate, place, alongX, Tension * x);
      }
      if (isIn(plate.Sites.Near->Above(place)))
      {
        AddSquare(plate, place, alongY, Tension * y);
      }
      if (shear != 0.0)
      {
        AddShear(plate, place, x, y, shear);
      }
    }
  }

  /// The twist averages four blocks, so that the energy stays a sum of squares.
  static void AddShear(SiteSystem<2>& plate, std::int64_t place, double x, double y, double shear)
  {
    static constexpr std::array<PlateTerm, 4> twist = { { { 1, 1, 0.25 }, { -1, 1, -0.25 }, { 1, -1, -0.25 },
      { -1, -1, 0.25 } } };
    for (int n = 0; n < 9; ++n)
    {
      if (plate.Sites.Number[std::size_t(plate.Sites.Near->Beside(place, n % 3 - 1, n / 3 - 1))] == NoSite)
      {
        return;
      }
    }
    AddProduct(plate, place, PlateAlongX, twist, 4.0 * x * shear);
    AddProduct(plate, place, PlateAlongY, twist, 4.0 * y * shear);
    AddProduct(plate, place, PlateAlongX, PlateAlongY, 2.0 * shear * shear);
  }

  /// Springs act on bilinear values. Returns the right side.
  std::vector<double> AddSprings(SiteSystem<2>& plate, const std::vector<Spring>& springs) const
  {
    const double strength = 1.0 / std::max(this->Options.Smoothing, LeastSmoothing);
    std::vector<double> side(plate.Sites.Size(), 0.0);
    for (const Spring& spring : springs)
    {
      const auto [i, j] = Corner(spring.Place);
      const double x = spring.Place.x() - i;
      const double y = spring.Place.y() - j;
      const std::array<PlateTerm, 4> terms = { { { 0, 0, (1.0 - x) * (1.0 - y) }, { 1, 0, x * (1.0 - y) },
        { 0, 1, (1.0 - x) * y }, { 1, 1, x * y } } };
      const std::int64_t at = plate.Sites.Near->Find({ i, j });
      const double weight = std::min(spring.Picks * strength, 1.0 / LeastSmoothing);
      AddSquare(plate, at, terms, weight);
      for (const PlateTerm& term : terms)
      {
        const std::int32_t site = plate.Sites.Number[std::size_t(plate.Sites.Near->Beside(at, term.X, term.Y))];
        if (site != NoSite)
        {
          side[std::size_t(site)] += weight * term.Coefficient * spring.Z;
        }
      }
    }
    return side;
  }

  LatticeHorizon MakeHorizon() const
  {
    LatticeHorizon horizon;
    HeapArray<double> filled;
    HeapArray<double> counts;
    HeapArray<double> distances;
    for (const std::size_t column : this->Kept)
    {
      const PlanePoint at = { int(column % std::size_t(this->Width)), int(column / std::size_t(this->Width)) };
      horizon.Column.push_back(at);
      horizon.RealZ.push_back(this->Result[column]);
      const std::array<int, 2>& span = this->Spans[std::size_t(at.Y)];
      filled.push_back(this->Count[column] > 0 ? 0.0 : at.X >= span[0] && at.X <= span[1] ? 1.0 : 2.0);
      counts.push_back(this->Count[column]);
      distances.push_back(this->Nearest[column].Distance);
    }
    horizon.Attributes.emplace_back("Filled", std::move(filled));
    horizon.Attributes.emplace_back("PickCount", std::move(counts));
    horizon.Attributes.emplace_back("PickDistance", std::move(distances));
    return horizon;
  }

  const Picks& Given;
  const SurveyLattice& Lattice;
  const GriddingOptions& Options;
  const int Width;
  const int Height;
  std::vector<PickSearch::Found> Nearest; // by column
  std::vector<std::int32_t> Count; // picks by column
  std::vector<std::array<int, 2>> Spans; // first and last column in the hull, by row
  std::vector<std::size_t> Kept;
  std::vector<double> Result;
};

void CheckGriddingOptions(const GriddingOptions& options)
{
  CheckPlacement(options.Placement);
  CheckWithin("GriddingRadius", options.Radius, 0.0, 1e12, " world units");
  CheckWithin("GriddingSmoothing", options.Smoothing, 0.0, LargestSmoothing, "");
  if (options.Placement.Source == LatticeSource::CornerPoints)
  {
    throw InputError("LatticeSource CornerPoints with Gridding, expected FromPoints or OriginAndSteps");
  }
}

std::vector<Eigen::Vector2d> PlacesOf(const PickTable& picks)
{
  std::vector<Eigen::Vector2d> places;
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    places.emplace_back(picks.HasPlaces() ? Eigen::Vector2d(picks.X[pick], picks.Y[pick])
                                          : Eigen::Vector2d(picks.Crossline[pick], picks.Inline[pick]));
  }
  return places;
}

/// Equal places, numbered by x, then y, are duplicates; the order does not depend on the file.
std::vector<PlanePoint> NumberPlaces(const std::vector<Eigen::Vector2d>& places)
{
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto isBefore = [&](std::size_t a, std::size_t b)
  { return std::tie(places[a].x(), places[a].y()) < std::tie(places[b].x(), places[b].y()); };
  std::sort(order.begin(), order.end(), isBefore);
  std::vector<PlanePoint> numbers(places.size(), PlanePoint{ 0, 0 });
  for (std::size_t n = 1; n < order.size(); ++n)
  {
    numbers[order[n]].X = numbers[order[n - 1]].X + (isBefore(order[n - 1], order[n]) ? 1 : 0);
  }
  return numbers;
}

/// Removes distant picks, refuses them, or, with a given lattice, warns, as they would stretch the steps. Returns a
/// text about picks that stay.
std::string TreatStrays(PickTable& picks, const PlacementOptions& options, std::vector<std::string>& warnings)
{
  std::vector<std::size_t> withZ;
  std::vector<Eigen::Vector2d> places = PlacesOf(picks);
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    if (!std::isnan(picks.Z[pick]))
    {
      places[withZ.size()] = places[pick];
      withZ.push_back(pick);
    }
  }
  places.resize(withZ.size());
  std::vector<std::size_t> strays = FindFarPlaces(places);
  std::transform(strays.begin(), strays.end(), strays.begin(), [&](std::size_t n) { return withZ[n]; });
  if (strays.empty())
  {
    return {};
  }
  const std::string said = PicksText(picks, strays);
  const std::string number = std::to_string(strays.size()) + (strays.size() == 1 ? " pick" : " picks");
  if (options.LeaveOutStrays)
  {
    warnings.push_back(number + " left out as strays: " + said);
    picks = WithoutPicks(std::move(picks), strays);
    return {};
  }
  if (options.Source != LatticeSource::OriginAndSteps)
  {
    throw InputError(std::to_string(strays.size()) + " of " + std::to_string(picks.Size()) +
      " picks far from all others, " + said + "; expected StrayPicks LeaveOut, or LatticeSource OriginAndSteps");
  }
  warnings.push_back(number + " far from all others, " + said + ": StrayPicks leaves them out");
  return said;
}
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons GridPicks(PickTable picks, const GriddingOptions& options, const Monitor& monitor)
{
  CheckGriddingOptions(options);
  PlaceRows(picks, options.Placement);
  SurveyHorizons gridded;
  gridded.Survey = picks.Survey;
  gridded.Warnings = std::move(picks.Warnings);
  const std::string strays = TreatStrays(picks, options.Placement, gridded.Warnings);
  const std::vector<Eigen::Vector2d> places = PlacesOf(picks);
  std::vector<ColumnOrder> orders = ListPicks(picks);
  const std::vector<PlanePoint> numbers = NumberPlaces(places);
  std::vector<Eigen::Vector2d> used;
  for (ColumnOrder& order : orders)
  {
    WarnOfNulls(Gather<std::vector<double>>(picks.Z, order.Picks), gridded.Warnings);
    OrderPicks(order, picks, numbers, options.Placement);
    gridded.Conflicts.push_back(CountConflicts(order));
    gridded.Conflicts.back().InLines = 0; // places have no lines
    for (const std::int32_t pick : order.Picks)
    {
      used.push_back(places[std::size_t(pick)]);
    }
  }
  if (used.empty() || picks.Size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
  {
    throw InputError(std::to_string(used.size()) + " picks with z, expected at least 1 and less than 2^31");
  }
  gridded.Lattice = FindGrid(used, options, strays);
  const Eigen::Matrix2d toColumns = gridded.Lattice.Steps().inverse();
  for (std::size_t number = 0; number < orders.size(); ++number)
  {
    Picks given;
    for (const std::int32_t pick : orders[number].Picks)
    {
      const Eigen::Vector2d place = toColumns * (places[std::size_t(pick)] - gridded.Lattice.Origin);
      given.Place.push_back(place.cwiseMax(0.0));
      given.Z.push_back(picks.Z[std::size_t(pick)]);
      const Eigen::Vector2d off = place.array() - place.array().round();
      gridded.LargestDistance = std::max(gridded.LargestDistance, off.cwiseAbs().maxCoeff());
    }
    const double done = double(number) / double(orders.size());
    LatticeHorizon horizon;
    if (!given.Z.empty())
    {
      horizon =
        HorizonGridder(given, gridded.Lattice, options).Run(monitor.Step(done, done + 1.0 / double(orders.size())));
    }
    horizon.SurfaceId = int(number) + 1;
    horizon.DroppedDuplicates = orders[number].Duplicates;
    horizon.DroppedNulls = orders[number].Nulls;
    gridded.Horizons.push_back(std::move(horizon));
  }
  return gridded;
}
}
