// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: choose the lattice; for each horizon find the pick nearest to each column, and with it the columns that there
// are; solve for the plate over these, and those around each pick.

#include "Gridding.h"

#include "Common/Errors.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "HoleFilling/PlateEnergy.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr double MostColumnsPerPick = 1000.0;
constexpr double EnoughColumns = 1e6; // that are no matter whatever picks there are
constexpr double MostColumns = 1 << 28;
constexpr double LeastSmoothing = 1e-6;
// What holds a plate where picks leave it free, as beside a single line: too weak to show elsewhere.
constexpr double Tension = 1e-6;

/// The picks of one horizon, in columns of the lattice.
struct Picks
{
  std::vector<Eigen::Vector2d> Place;
  std::vector<double> Z;
};

//----------------------------------------------------------------------------------------------------------------------
// The lattice

/// The nearest of 1, 2 and 5 times a power of ten.
double RoundStep(double step)
{
  const double unit = std::pow(10.0, std::floor(std::log10(step)));
  double best = unit;
  for (const double factor : { 2.0, 5.0, 10.0 })
  {
    best = std::abs(std::log(factor * unit / step)) < std::abs(std::log(best / step)) ? factor * unit : best;
  }
  return best;
}

struct Box
{
  Eigen::Vector2d Least = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d Greatest = -Least;

  void Add(const Eigen::Vector2d& place)
  {
    this->Least = this->Least.cwiseMin(place);
    this->Greatest = this->Greatest.cwiseMax(place);
  }
};

/// Along x and y, with steps that make about a column for each pick of their bounding box.
SurveyLattice AutomaticLattice(const Box& box, std::size_t picks)
{
  const Eigen::Vector2d extent = box.Greatest - box.Least;
  const double area = extent.x() * extent.y();
  const double step = area > 0.0 ? std::sqrt(area / double(picks)) : std::max(extent.x(), extent.y()) / double(picks);
  const double size = step > 0.0 && std::isfinite(step) ? RoundStep(step) : 1.0;
  SurveyLattice lattice;
  lattice.ColumnStep = size * Eigen::Vector2d::UnitX();
  lattice.RowStep = size * Eigen::Vector2d::UnitY();
  lattice.Origin = size * (box.Least / size).array().floor();
  return lattice;
}

/// The lattice that is given or chosen, as large as the picks, and with a radius as it takes for that.
SurveyLattice FindGrid(const std::vector<Eigen::Vector2d>& places, const GriddingOptions& options)
{
  Box box;
  for (const Eigen::Vector2d& place : places)
  {
    box.Add(place);
  }
  SurveyLattice lattice = AutomaticLattice(box, places.size());
  if (options.Placement.Source == LatticeSource::OriginAndSteps)
  {
    lattice.Origin = options.Placement.Origin;
    lattice.ColumnStep = options.Placement.ColumnStep;
    lattice.RowStep = options.Placement.RowStep;
  }
  const Eigen::Matrix2d toColumns = lattice.Steps().inverse();
  Box columns;
  for (const Eigen::Vector2d& place : places)
  {
    columns.Add(toColumns * (place - lattice.Origin));
  }
  const Eigen::Vector2d margin = options.Radius * toColumns.rowwise().norm();
  const Eigen::Vector2d first = (columns.Least - margin).array().floor();
  const Eigen::Vector2d last = (columns.Greatest + margin).array().ceil();
  const Eigen::Vector2d size = last - first + Eigen::Vector2d::Ones();
  if (!(size.prod() <= std::min(MostColumns, std::max(EnoughColumns, MostColumnsPerPick * double(places.size())))))
  {
    std::ostringstream text;
    text.precision(12);
    text << "grid of " << size.x() << " x " << size.y() << " columns for " << places.size()
         << " picks, expected at most " << MostColumnsPerPick
         << " columns a pick and 2^28 in all: choose longer steps, or a smaller GriddingRadius";
    throw InputError(text.str());
  }
  lattice.Origin += lattice.Steps() * first;
  lattice.Columns = { int(size.x()), int(size.y()) };
  return lattice;
}

//----------------------------------------------------------------------------------------------------------------------
// Nearest picks

/// Picks in square buckets of the world, of about two each.
class PickSearch
{
public:
  explicit PickSearch(const std::vector<Eigen::Vector2d>& places)
    : Places(places)
  {
    Box box;
    for (const Eigen::Vector2d& place : places)
    {
      box.Add(place);
    }
    const Eigen::Vector2d extent = box.Greatest - box.Least;
    const double area = extent.x() * extent.y();
    const double count = double(places.size());
    this->Size = std::max({ std::sqrt(2.0 * area / count), 2.0 * extent.maxCoeff() / count, 1e-9 * extent.maxCoeff() });
    this->Size = this->Size > 0.0 ? this->Size : 1.0;
    this->First = box.Least;
    this->Columns = std::int64_t(extent.x() / this->Size) + 1;
    this->Rows = std::int64_t(extent.y() / this->Size) + 1;
    this->Begin.assign(std::size_t(this->Columns * this->Rows) + 1, 0);
    const auto bucket = [&](const Eigen::Vector2d& place)
    {
      const auto x = std::int64_t((place.x() - this->First.x()) / this->Size);
      const auto y = std::int64_t((place.y() - this->First.y()) / this->Size);
      return std::size_t(std::min(y, this->Rows - 1) * this->Columns + std::min(x, this->Columns - 1));
    };
    for (const Eigen::Vector2d& place : places)
    {
      ++this->Begin[bucket(place) + 1];
    }
    for (std::size_t n = 1; n < this->Begin.size(); ++n)
    {
      this->Begin[n] += this->Begin[n - 1];
    }
    this->Order.resize(places.size());
    std::vector<std::int32_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (std::size_t pick = 0; pick < places.size(); ++pick)
    {
      this->Order[std::size_t(next[bucket(places[pick])]++)] = std::int32_t(pick);
    }
  }

  struct Found
  {
    std::int32_t Pick = -1; // of equally near ones the first
    double Distance = std::numeric_limits<double>::infinity();
  };

  Found Find(const Eigen::Vector2d& place) const
  {
    const auto x = std::int64_t(std::floor((place.x() - this->First.x()) / this->Size));
    const auto y = std::int64_t(std::floor((place.y() - this->First.y()) / this->Size));
    const std::int64_t outside = std::max({ -x, x - this->Columns + 1, -y, y - this->Rows + 1, std::int64_t(0) });
    const std::int64_t last = outside + std::max(this->Columns, this->Rows);
    Found found;
    // Buckets so many rings away have nothing nearer than one ring less.
    for (std::int64_t ring = outside; ring <= last && found.Distance >= double(ring - 1) * this->Size; ++ring)
    {
      for (std::int64_t row = std::max<std::int64_t>(y - ring, 0); row <= std::min(y + ring, this->Rows - 1); ++row)
      {
        const bool isWhole = row == y - ring || row == y + ring;
        for (std::int64_t column = x - ring; column <= x + ring;
             column += isWhole ? 1 : std::max<std::int64_t>(2 * ring, 1))
        {
          if (column >= 0 && column < this->Columns)
          {
            this->Look(std::size_t(row * this->Columns + column), place, found);
          }
        }
      }
    }
    return found;
  }

private:
  void Look(std::size_t bucket, const Eigen::Vector2d& place, Found& found) const
  {
    for (std::int32_t n = this->Begin[bucket]; n < this->Begin[bucket + 1]; ++n)
    {
      const std::int32_t pick = this->Order[std::size_t(n)];
      const double distance = (this->Places[std::size_t(pick)] - place).norm();
      if (distance < found.Distance || (distance == found.Distance && pick < found.Pick))
      {
        found = { pick, distance };
      }
    }
  }

  const std::vector<Eigen::Vector2d>& Places;
  double Size = 1.0;
  Eigen::Vector2d First = Eigen::Vector2d::Zero();
  std::int64_t Columns = 1;
  std::int64_t Rows = 1;
  std::vector<std::int32_t> Begin;
  std::vector<std::int32_t> Order;
};

//----------------------------------------------------------------------------------------------------------------------
// The convex hull

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The corners one after the other (Andrew's chains).
std::vector<Eigen::Vector2d> FindHull(std::vector<Eigen::Vector2d> places)
{
  std::sort(places.begin(), places.end(),
    [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Eigen::Vector2d> hull;
  for (const bool isLower : { true, false })
  {
    const std::size_t begin = hull.size();
    for (const Eigen::Vector2d& place : places)
    {
      while (hull.size() >= begin + 2 && Cross(hull[hull.size() - 2], hull.back(), place) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(place);
    }
    hull.pop_back();
    if (isLower)
    {
      std::reverse(places.begin(), places.end());
    }
  }
  return hull.empty() ? places : hull;
}

/// The columns of a row within a hull: first and last.
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

//----------------------------------------------------------------------------------------------------------------------
// One horizon

/// The plane next to all picks by least squares: z at (0, 0), and its slopes. Across a line of picks it is level.
Eigen::Vector3d FitPlane(const Picks& picks)
{
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double mean = 0.0;
  const double count = double(picks.Z.size());
  for (std::size_t n = 0; n < picks.Z.size(); ++n)
  {
    middle += picks.Place[n] / count;
    mean += picks.Z[n] / count;
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d side = Eigen::Vector2d::Zero();
  for (std::size_t n = 0; n < picks.Z.size(); ++n)
  {
    const Eigen::Vector2d place = picks.Place[n] - middle;
    spread += place * place.transpose();
    side += place * (picks.Z[n] - mean);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix2d> solver;
  solver.setThreshold(1e-12);
  solver.compute(spread);
  const Eigen::Vector2d slope = solver.solve(side);
  return { mean - slope.dot(middle), slope.x(), slope.y() };
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

  /// In the world, where distances are.
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
    const std::vector<Eigen::Vector2d> hull =
      this->Options.Radius > 0.0 ? std::vector<Eigen::Vector2d>() : FindHull(this->Given.Place);
    for (int j = 0; j < this->Height; ++j)
    {
      const std::array<int, 2> span = SpanOf(hull, j);
      for (int i = 0; i < this->Width; ++i)
      {
        const std::size_t column = this->CellOf(i, j);
        const bool isIn = this->Options.Radius > 0.0 ? this->Nearest[column].Distance <= this->Options.Radius
                                                     : this->Count[column] > 0 || (i >= span[0] && i <= span[1]);
        if (isIn)
        {
          this->Kept.push_back(column);
        }
      }
    }
    this->Result.assign(this->Nearest.size(), 0.0);
  }

  /// The columns of the plate: those that are kept, and the four around each pick.
  std::vector<BoxRun> PlateRuns() const
  {
    std::vector<char> isIn(this->Nearest.size(), 0);
    for (const std::size_t column : this->Kept)
    {
      isIn[column] = 1;
    }
    for (const Eigen::Vector2d& place : this->Given.Place)
    {
      const int i = int(std::floor(place.x()));
      const int j = int(std::floor(place.y()));
      for (const int dj : { 0, 1 })
      {
        for (const int di : { 0, 1 })
        {
          isIn[this->CellOf(std::min(i + di, this->Width - 1), std::min(j + dj, this->Height - 1))] = 1;
        }
      }
    }
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

  void SolvePlate(const Monitor& monitor)
  {
    const std::vector<BoxRun> runs = this->PlateRuns();
    const auto near = std::make_shared<const BoxPlaces>(runs, SiteBox::Margin);
    SiteBox sites(near);
    for (const BoxRun& run : runs)
    {
      const std::int64_t first = near->Find({ run.First, run.Row });
      for (int i = run.First; i <= run.Last; ++i)
      {
        sites.Add(first + i - run.First);
      }
    }
    SiteSystem<2> plate(std::move(sites));
    this->AddEnergy(plate);
    const Eigen::Vector3d plane = FitPlane(this->Given);
    std::vector<double> values = this->AddPicks(plate, plane);
    SiteSolver<2>(plate).Solve(values, monitor);
    for (const std::size_t column : this->Kept)
    {
      const int i = int(column % std::size_t(this->Width));
      const int j = int(column / std::size_t(this->Width));
      this->Result[column] = plane[0] + plane[1] * i + plane[2] * j +
        values[std::size_t(plate.Sites.Number[std::size_t(near->Find({ i, j }))])];
    }
  }

  static void AddEnergy(SiteSystem<2>& plate)
  {
    const auto isIn = [&](std::int64_t place) { return plate.Sites.Number[std::size_t(place)] != NoSite; };
    ForEachPlateStencil(
      *plate.Sites.Near, isIn, [](std::int64_t, std::int64_t) { return true; }, [](std::int64_t) { return true; },
      [&](std::int64_t place, const auto& terms, double weight) { AddSquare(plate, place, terms, weight); });
    static constexpr std::array<PlateTerm, 2> alongX = { { { 0, 0, -1.0 }, { 1, 0, 1.0 } } };
    static constexpr std::array<PlateTerm, 2> alongY = { { { 0, 0, -1.0 }, { 0, 1, 1.0 } } };
    for (std::size_t site = 0; site < plate.Sites.Size(); ++site)
    {
      const std::int64_t place = plate.Sites.Place[site];
      if (isIn(place + 1))
      {
        AddSquare(plate, place, alongX, Tension);
      }
      if (isIn(plate.Sites.Near->Above(place)))
      {
        AddSquare(plate, place, alongY, Tension);
      }
    }
  }

  /// A spring between each pick and the plate, bilinear between its four columns. Returns the right side.
  std::vector<double> AddPicks(SiteSystem<2>& plate, const Eigen::Vector3d& plane) const
  {
    const double weight = 1.0 / std::max(this->Options.Smoothing, LeastSmoothing);
    std::vector<double> side(plate.Sites.Size(), 0.0);
    for (std::size_t pick = 0; pick < this->Given.Z.size(); ++pick)
    {
      const Eigen::Vector2d& place = this->Given.Place[pick];
      const int i = int(std::floor(place.x()));
      const int j = int(std::floor(place.y()));
      const double x = place.x() - i;
      const double y = place.y() - j;
      const std::array<PlateTerm, 4> terms = { { { 0, 0, (1.0 - x) * (1.0 - y) }, { 1, 0, x * (1.0 - y) },
        { 0, 1, (1.0 - x) * y }, { 1, 1, x * y } } };
      const std::int64_t at = plate.Sites.Near->Find({ i, j });
      const double z = this->Given.Z[pick] - plane[0] - plane[1] * place.x() - plane[2] * place.y();
      AddSquare(plate, at, terms, weight);
      for (const PlateTerm& term : terms)
      {
        const std::int32_t site = plate.Sites.Number[std::size_t(plate.Sites.Near->Beside(at, term.X, term.Y))];
        if (site != NoSite)
        {
          side[std::size_t(site)] += weight * term.Coefficient * z;
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
      horizon.Column.push_back({ int(column % std::size_t(this->Width)), int(column / std::size_t(this->Width)) });
      horizon.RealZ.push_back(this->Result[column]);
      filled.push_back(this->Count[column] == 0 ? 1.0 : 0.0);
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
  std::vector<PickSearch::Found> Nearest; // of each column of the box
  std::vector<std::int32_t> Count; // picks in each
  std::vector<std::size_t> Kept; // columns that there are
  std::vector<double> Result;
};

void CheckOptions(const GriddingOptions& options)
{
  CheckPlacement(options.Placement);
  CheckWithin("GriddingRadius", options.Radius, 0.0, 1e12, " world units");
  CheckWithin("GriddingSmoothing", options.Smoothing, 0.0, LargestSmoothing, "");
  if (options.Placement.Source == LatticeSource::CornerPoints)
  {
    throw InputError("LatticeSource CornerPoints with Gridding, expected FromPoints or OriginAndSteps");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
SurveyHorizons GridPicks(PickTable picks, const GriddingOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  std::vector<Eigen::Vector2d> places;
  std::vector<std::size_t> withZ;
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    if (!std::isnan(picks.Z[pick]))
    {
      withZ.push_back(pick);
      places.emplace_back(picks.HasPlaces() ? Eigen::Vector2d(picks.X[pick], picks.Y[pick])
                                            : Eigen::Vector2d(picks.Crossline[pick], picks.Inline[pick]));
    }
  }
  if (places.empty() || places.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
  {
    throw InputError(std::to_string(places.size()) + " picks with z, expected at least 1 and less than 2^31");
  }
  SurveyHorizons gridded;
  gridded.Survey = picks.Survey;
  gridded.Doubts = std::move(picks.Doubts);
  gridded.Lattice = FindGrid(places, options);
  const Eigen::Matrix2d toColumns = gridded.Lattice.Steps().inverse();
  std::vector<Picks> horizons(picks.Names.size());
  for (std::size_t n = 0; n < withZ.size(); ++n)
  {
    const std::size_t horizon = picks.Horizon.empty() ? 0 : std::size_t(picks.Horizon[withZ[n]]);
    const Eigen::Vector2d place = toColumns * (places[n] - gridded.Lattice.Origin);
    horizons[horizon].Place.push_back(place.cwiseMax(0.0));
    horizons[horizon].Z.push_back(picks.Z[withZ[n]]);
    const Eigen::Vector2d off = place.array() - place.array().round();
    gridded.LargestDistance = std::max(gridded.LargestDistance, off.cwiseAbs().maxCoeff());
  }
  const std::vector<std::int64_t> counts = picks.CountPicks();
  for (std::size_t number = 0; number < horizons.size(); ++number)
  {
    const double done = double(number) / double(horizons.size());
    LatticeHorizon horizon;
    if (!horizons[number].Z.empty())
    {
      horizon = HorizonGridder(horizons[number], gridded.Lattice, options)
                  .Run(monitor.Step(done, done + 1.0 / double(horizons.size())));
    }
    horizon.SurfaceId = int(number) + 1;
    horizon.DroppedNulls = counts[number] - std::int64_t(horizons[number].Z.size());
    gridded.Horizons.push_back(std::move(horizon));
  }
  return gridded;
}
}
