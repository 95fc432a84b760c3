// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: gaps and radius; search for an error; points beside slivers; the methods in sequence.

#include "Surface.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/Decimation/EdgeSizes.h"
#include "SurfaceParts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double SpannedShare = 0.95; // along either axis
constexpr std::int32_t NoRow = std::numeric_limits<std::int32_t>::max();

std::vector<PlanePoint> SortByRows(PlanePoints columns, const PlaneBox& box)
{
  using Lines = ItemLists<PlanePoint, std::uint32_t>;
  const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
  const std::int64_t height = std::int64_t(box.Greatest.Y) - box.Least.Y + 1;
  const Lines byX(width,
    [&](auto&& add)
    {
      std::for_each(
        columns.begin(), columns.end(), [&](const PlanePoint& column) { add(column.X - box.Least.X, column); });
    });
  const Lines byY(height,
    [&](auto&& add)
    {
      std::for_each(
        byX.begin(0), byX.end(width - 1), [&](const PlanePoint& column) { add(column.Y - box.Least.Y, column); });
    });
  return { byY.begin(0), byY.end(height - 1) };
}

GapHistograms Count(PlanePoints columns)
{
  const ColumnRows all = ColumnRows::Of(columns);
  const PlaneBox& box = all.Box;
  std::vector<PlanePoint> sorted;
  if (!all.AreAscending)
  {
    sorted = SortByRows(columns, box);
    columns = sorted;
  }
  GapCounter gaps(box);
  gaps.Add(columns);
  return gaps.Counted();
}

int LeastSpanning(const GapHistogram& steps)
{
  const std::int64_t all = std::accumulate(steps.begin(), steps.end(), std::int64_t(0));
  int radius = 1;
  std::int64_t spanned = steps[0] + steps[1];
  while (radius < LargestRadius && double(spanned) < SpannedShare * double(all))
  {
    spanned += steps[++radius];
  }
  return radius;
}
}

//----------------------------------------------------------------------------------------------------------------------
GapHistograms CountGaps(PlanePoints columns)
{
  if (columns.empty())
  {
    return {};
  }
  return AreScattered(columns) ? Count(NarrowEmptyBands(columns, LargestRadius)) : Count(columns);
}

//----------------------------------------------------------------------------------------------------------------------
GapCounter::GapCounter(const PlaneBox& box)
  : Last(NoColumn)
  , FirstX(box.Least.X)
  , Rows(std::size_t(std::int64_t(box.Greatest.X) - box.Least.X + 1), NoRow)
{
}

//----------------------------------------------------------------------------------------------------------------------
void GapCounter::Add(PlanePoints columns)
{
  for (const PlanePoint& column : columns)
  {
    std::int32_t& row = this->Rows[std::size_t(column.X - this->FirstX)];
    if (this->IsAny && this->Last.Y == column.Y)
    {
      ++this->Gaps.AlongRows[std::min(column.X - this->Last.X, LargestRadius + 1)];
    }
    if (row < column.Y)
    {
      ++this->Gaps.AlongColumns[std::min(column.Y - row, LargestRadius + 1)];
    }
    row = column.Y;
    this->Last = column;
    this->IsAny = true;
  }
}

//----------------------------------------------------------------------------------------------------------------------
int ChooseRadius(PlanePoints columns)
{
  return ChooseRadius(CountGaps(columns));
}

//----------------------------------------------------------------------------------------------------------------------
int ChooseRadius(const GapHistograms& gaps)
{
  return std::max(LeastSpanning(gaps.AlongRows), LeastSpanning(gaps.AlongColumns));
}

namespace
{
constexpr double UsualPower = 1.5; // see the search in Surface.h

/// Values are logarithms; Part is relative to the number wanted.
struct Sample
{
  bool IsKnown = false;
  double Error = 0.0;
  double Part = 0.0;
};

class Search
{
public:
  Search(std::size_t most, double first, double largest)
    : Most(double(most))
    , Least(std::log(SmallestSearchedError))
    , Largest(std::max(std::log(largest), this->Least))
    , Next(std::clamp(std::log(first), this->Least, this->Largest))
  {
  }

  double NextError() const { return std::exp(this->Next); }

  void Add(std::size_t triangles)
  {
    const double part = std::log(double(std::max<std::size_t>(triangles, 1)) / this->Most);
    Sample& side = part > 0.0 ? this->Fine : this->Coarse;
    const Sample before = side;
    side = { true, this->Next, part };
    this->Next = this->Fine.IsKnown && this->Coarse.IsKnown ? this->Secant() : this->GoBeyond(before, side);
  }

  bool IsDone() const
  {
    if (!this->Coarse.IsKnown)
    {
      return this->Fine.IsKnown && this->Fine.Error == this->Largest;
    }
    return this->Coarse.Part >= std::log(EnoughOfNumber) || this->Coarse.Error == this->Least ||
      (this->Fine.IsKnown && this->Coarse.Error - this->Fine.Error <= std::log(NearEnough));
  }

  bool HasFound() const { return this->Coarse.IsKnown; }
  double Found() const { return std::exp(this->Coarse.Error); }

private:
  // The first guess overshoots by this factor, to reach the other side of the number.
  static constexpr double Beyond = 1.3;
  // While all errors are on one side, steps grow up to this factor, squared each time. Below the least power, the
  // search jumps to the end.
  static constexpr double FarthestStep = 8.0;
  static constexpr double LeastPower = 0.2;
  // Below this error, in lattice units, nearly all points are vertices; above, outlines are left, and numbers rise
  // faster.
  static constexpr double ErrorOfAllPoints = 0.1;
  static constexpr double PowerOfOutlines = 0.75;
  // A tenth of the number is some hundredths of the error, which only outlines use. Secants aim half-way to the number.
  static constexpr double EnoughOfNumber = 0.9;
  static constexpr double Aim = 0.95;
  static constexpr double NearEnough = 1.05;
  // Secants keep this fraction away from their ends, as the line is not quite straight.
  static constexpr double KeptAway = 0.1;

  double GoBeyond(const Sample& before, const Sample& last)
  {
    double power = before.IsKnown ? (before.Part - last.Part) / (last.Error - before.Error) : UsualPower;
    const bool isFine = last.Part > 0.0;
    if (power < LeastPower && (isFine || last.Error < std::log(ErrorOfAllPoints)))
    {
      return isFine ? this->Largest : this->Least;
    }
    if (!isFine && last.Error > std::log(ErrorOfAllPoints))
    {
      power = std::max(power, PowerOfOutlines);
    }
    const double beyond = std::log(last.Part > 0.0 ? Beyond : 1.0 / Beyond);
    double step = last.Part / power + beyond;
    if (before.IsKnown)
    {
      step = std::clamp(step, -this->Farthest, this->Farthest);
      this->Farthest *= 2.0;
    }
    return std::clamp(last.Error + step, this->Least, this->Largest);
  }

  double Secant() const
  {
    const double way = (this->Fine.Part - std::log(Aim)) / (this->Fine.Part - this->Coarse.Part);
    return this->Fine.Error + std::clamp(way, KeptAway, 1.0 - KeptAway) * (this->Coarse.Error - this->Fine.Error);
  }

  const double Most;
  const double Least;
  const double Largest;
  double Next;
  double Farthest = std::log(FarthestStep);
  Sample Fine; // largest error with too many triangles
  Sample Coarse; // least error with few enough
};
}

//----------------------------------------------------------------------------------------------------------------------
double FindErrorForTriangles(std::size_t most, double first, double largest, const TriangleCounter& count)
{
  Search search(most, first, largest);
  std::size_t triangles = 0;
  for (int run = 0; run < MostSearchRuns && !search.IsDone(); ++run)
  {
    triangles = count(search.NextError());
    search.Add(triangles);
  }
  if (!search.HasFound())
  {
    throw TooFewTriangles(most, triangles);
  }
  return search.Found();
}

namespace
{
class DroppedPlaces
{
public:
  DroppedPlaces(PlanePoints columns, const Loops& before, const Loops& after)
    : Columns(columns)
  {
    const std::vector<unsigned char> kept = after.MarkPoints(columns.size());
    before.ForEachPoint(
      [&](PointId point)
      {
        if (kept[std::size_t(point)] == 0)
        {
          this->Points.push_back(point);
        }
      });
    std::sort(this->Points.begin(), this->Points.end(),
      [&](PointId a, PointId b) { return PrecedesByRow(columns[a], columns[b]); });
  }

  /// Returns NoPoint if none is within reach.
  PointId FindNearest(const PlanePoint& place, std::int32_t reach) const
  {
    PointId nearest = NoPoint;
    std::int64_t least = std::int64_t(reach) * reach;
    for (std::int32_t y = place.Y - reach; y <= place.Y + reach; ++y)
    {
      auto point = std::lower_bound(this->Points.begin(), this->Points.end(), PlanePoint{ place.X - reach, y },
        [this](PointId one, const PlanePoint& other) { return PrecedesByRow(this->Columns[one], other); });
      for (; point != this->Points.end() && !PrecedesByRow({ place.X + reach, y }, this->Columns[*point]); ++point)
      {
        const std::int64_t distance = SquaredDistance(place, this->Columns[*point]);
        if (distance < least || (distance == least && nearest == NoPoint))
        {
          least = distance;
          nearest = *point;
        }
      }
    }
    return nearest;
  }

private:
  const PlanePoints Columns;
  std::vector<PointId> Points; // row by row
};

/// A sliver is split near its obtuse corner or, without one, half-way along the longer edge at its largest angle.
PlanePoint PlaceToSplit(const std::array<PlanePoint, 3>& corners)
{
  const auto opposite = [&](std::size_t n) { return SquaredDistance(corners[(n + 1) % 3], corners[(n + 2) % 3]); };
  std::size_t corner = opposite(1) > opposite(0) ? 1 : 0;
  corner = opposite(2) > opposite(corner) ? 2 : corner;
  const PlanePoint& here = corners[corner];
  const std::size_t next = (corner + 1) % 3;
  const std::size_t last = (corner + 2) % 3;
  if (-2 * ScalarProduct(here, corners[next], corners[last]) > std::min(opposite(next), opposite(last)))
  {
    return here;
  }
  const PlanePoint& end = corners[opposite(last) > opposite(next) ? next : last];
  return { (here.X + end.X) / 2, (here.Y + end.Y) / 2 };
}

// Within an error, efforts leave about these shares of the inner points that are inserted one by one.
constexpr double ShareOfBest = 0.42;
constexpr double ShareForSquares = 0.4;
constexpr double ShareOfFast = 0.8;
// Where near outlines need more of the triangles than this, whatever the error, they may be far.
constexpr double LargestShareOfOutlines = 0.5;
// Outlines for errors up to this factor away leave about the same inner points.
constexpr double FarFromOutlines = 3.0;
// Points that outlines keep can leave new slivers. The last reviews of slivers keep all points that were found; as many
// more are for points in the way alone.
constexpr int MostReviews = 6;
constexpr int LastReviews = 2;
// Meshes within an error do not keep larger angles (degrees) either.
constexpr double LargestKeptAngle = 10.0;
// Points of outlines this far (columns) do nothing for a sliver.
constexpr double FarthestReach = 16.0;

class SurfaceMaker
{
public:
  SurfaceMaker(SurfacePoints points, const SurfaceOptions& options)
    : Points(std::move(points))
    , Options(options)
  {
    this->Result.Parameters.Radius = options.Radius ? *options.Radius : ChooseRadius(this->Points.Columns);
  }

  SurfaceMaker(SurfacePoints points, const SurfaceOptions& options, KnownBoundary part)
    : SurfaceMaker(std::move(points), options)
  {
    this->IsPart = true;
    this->Part = std::move(part);
    this->Result.Boundary.Boundary = std::move(this->Part.Boundary);
    this->Result.Boundary.Patch.assign(this->Points.Columns.size(), 0);
    this->Result.Kept = KeptPoints::All(this->Points.Columns.size());
    this->Result.Parameters = ParametersFor(options, this->Radius(), options.MaximumError);
    this->HasBoundary = true;
  }

  Surface Run(const Monitor& monitor)
  {
    const bool isByNumber = this->Options.MaximumNumberOfTriangles > 0;
    const double last = isByNumber ? 0.6 : 0.0;
    const double error = isByNumber ? this->FindError(monitor.Step(0.0, last)) : this->Options.MaximumError;
    this->Simplify(error, monitor.Step(last, last + 0.3 * (1.0 - last)));
    if (!this->Result.Kept.empty())
    {
      this->Decimate(monitor.Step(last + 0.3 * (1.0 - last), 1.0));
    }
    return std::move(this->Result);
  }

  int Radius() const { return this->Result.Parameters.Radius; }

  Surface RunInParts(const PlaneBox& box, std::int32_t rowsOfPart, const Monitor& monitor)
  {
    this->SetParameters(this->Options.MaximumError);
    this->FindBoundary(monitor.Step(0.0, 0.1));
    if (!this->Result.Kept.empty())
    {
      const RowsInMemory rows(this->Columns(), this->Height(), box);
      const TakeTargets take = [this](PointId, const std::vector<PointId>& targets)
      {
        RawVector<PointId>& all = this->Result.Mesh.Points.Target;
        all.insert(all.end(), targets.begin(), targets.end());
      };
      MakeInParts(rows, rowsOfPart, this->Options, this->Result, take, monitor.Step(0.1, 1.0));
    }
    return std::move(this->Result);
  }

private:
  /// Returns 0 if no tolerance depends on the error.
  double FindError(const Monitor& monitor)
  {
    if (this->Options.OutlineTolerance && this->Options.DistanceThreshold)
    {
      return 0.0;
    }
    int run = 0;
    const std::size_t most = this->Options.MaximumNumberOfTriangles;
    const PlaneBox box(this->Points.Columns);
    const double width = double(box.Greatest.X) - box.Least.X + double(box.Greatest.Y) - box.Least.Y;
    const auto heights = std::minmax_element(this->Points.Height.begin(), this->Points.Height.end());
    const double height = *heights.second - *heights.first;
    this->Simplify(width + height, Monitor());
    this->AreOutlinesFar = double(this->CountTrianglesOfLoops()) > LargestShareOfOutlines * double(most);
    double known = 0.0; // outlines of the errors found
    std::vector<double> errors;
    // Rough horizons need about the first error, smooth horizons less, and large errors are fast. No points are farther
    // apart than the largest.
    return FindErrorForTriangles(most, height / std::sqrt(double(most)), width + height,
      [&](double error)
      {
        const Monitor step = monitor.Step(double(run) / MostSearchRuns, double(run + 1) / MostSearchRuns);
        ++run;
        this->Simplify(error, step.Step(0.0, 0.5));
        const std::size_t least = this->CountTrianglesOfLoops();
        if (least >= most)
        {
          return least;
        }
        const double share = this->Options.Effort == DecimationEffort::Fast ? ShareOfFast
          : this->Options.Priority == DecimationPriority::LargestError      ? ShareOfBest
                                                                            : ShareForSquares;
        if (error > FarFromOutlines * known || error < known / FarFromOutlines)
        {
          known = error;
          errors = FindErrors(this->CopyHorizon(), least + std::size_t(double(most - least) / share),
            error / FarFromOutlines, step.Step(0.5, 1.0));
        }
        return least + std::size_t(2.0 * share * NumberAbove(error, errors));
      });
  }

  static double NumberAbove(double error, const std::vector<double>& errors)
  {
    const auto end = std::upper_bound(errors.begin(), errors.end(), error, std::greater<>());
    return double(end - errors.begin()) * std::pow(std::max(1.0, errors.back() / error), UsualPower);
  }

  /// Follows from Euler's formula, also where loops touch.
  std::size_t CountTrianglesOfLoops() const
  {
    std::size_t edges = 0;
    for (std::size_t loop = 0; loop < this->Outlines.Size(); ++loop)
    {
      edges += this->Outlines.Length(loop) > 1 ? this->Outlines.Length(loop) : 0;
    }
    const std::size_t points = this->Outlines.CountPoints(this->Result.Kept.size());
    return 2 * (points + this->Outlines.Size()) - edges - 4 * this->Result.Boundary.NumberOfPatches;
  }

  /// A long outline edge beside rough ground leaves only slivers in between, or edges far from links to points that were
  /// dropped. Outlines keep such points, until the mesh is good. Meshes by number come before the error of edges.
  std::optional<MovedLoops> Review(const LoopTriangles& seen)
  {
    const bool isEven = this->Options.EdgeLength > 0.0;
    std::vector<PointId> found;
    std::vector<PointId> corners;
    if (seen.Reviews < MostReviews)
    {
      found = isEven ? this->DivideNarrow(seen) : this->FindAtSlivers(seen, corners);
    }
    std::copy_if(seen.InTheWay.begin(), seen.InTheWay.end(), std::back_inserter(found),
      [this](PointId point) { return !this->IsBesidePart(point); });
    const double error = this->Result.Parameters.MaximumError;
    const bool isFiner = seen.Error < error && this->HasHolesFor(seen.Error);
    if ((found.empty() && !isFiner) || seen.Reviews == MostReviews + LastReviews)
    {
      return {};
    }
    const bool isForMiddle = !isEven && seen.Reviews < MostReviews - LastReviews;
    const std::vector<PointId> before = this->Result.AddedToOutlines;
    const std::size_t points = this->Outlines.TotalLength();
    this->Heights = &seen.Heights;
    this->AddToOutlines(isForMiddle ? this->MiddleOf(found) : found);
    this->Simplify(isFiner ? seen.Error : error, Monitor());
    const std::size_t most = this->Options.MaximumNumberOfTriangles;
    const bool areTooMany = most > 0 && seen.TrianglesOfLoops + this->Outlines.TotalLength() > most + points;
    if (areTooMany) // the number comes before angles
    {
      this->Result.AddedToOutlines = before;
      this->Simplify(error, Monitor());
    }
    this->Heights = nullptr;
    if (areTooMany || (this->Result.AddedToOutlines.size() == before.size() && !isFiner))
    {
      return {};
    }
    corners.insert(corners.end(), found.begin(), found.end());
    return MovedLoops{ this->Outlines, this->Dropped, std::move(corners) };
  }

  bool IsBesidePart(PointId point) const
  {
    return std::binary_search(this->Part.Dropped.begin(), this->Part.Dropped.end(), DroppedPoint{ point, NoPoint },
      [](const DroppedPoint& a, const DroppedPoint& b) { return a.Point < b.Point; });
  }

  /// For even meshes, points that part edges of outlines at triangles with small angles.
  std::vector<PointId> DivideNarrow(const LoopTriangles& seen)
  {
    const std::vector<unsigned char> isEnd = this->Outlines.MarkPoints(this->Columns().size());
    const double sine = SineOfDegrees(SmallestAngleOf(this->Options));
    std::vector<std::array<PointId, 2>> narrow;
    for (const std::array<PointId, 3>& corners : seen.Corners)
    {
      const auto at = [&](std::size_t n) { return this->Columns()[corners[n]]; };
      const bool isNarrow = SineOfSmallestAngle(at(0), at(1), at(2)) < sine;
      for (std::size_t edge = 0; edge < 3 && isNarrow; ++edge)
      {
        const std::array<PointId, 2> ends = { corners[edge], corners[edge == 2 ? 0 : edge + 1] };
        if (isEnd[ends[0]] != 0 && isEnd[ends[1]] != 0)
        {
          narrow.push_back(ends);
          narrow.push_back({ ends[1], ends[0] });
        }
      }
    }
    if (narrow.empty())
    {
      return {};
    }
    std::sort(narrow.begin(), narrow.end());
    return DivideEdges(SpacePoints(this->Columns(), seen.Heights, 1), this->Result.Boundary.Boundary, this->Outlines,
      [&](PointId from, PointId to) {
        return std::binary_search(narrow.begin(), narrow.end(), std::array<PointId, 2>{ from, to }) ? 2.0 : 1.0;
      });
  }

  /// Of several on one edge, only the middle one, which may do for the others.
  std::vector<PointId> MiddleOf(const std::vector<PointId>& found) const
  {
    std::vector<unsigned char> isFound(this->Columns().size(), 0);
    std::for_each(found.begin(), found.end(), [&](PointId point) { isFound[std::size_t(point)] = 1; });
    std::vector<PointId> middle;
    ForEachChain(this->Result.Boundary.Boundary, this->Outlines, isFound.size(),
      [&](const std::vector<PointId>& chain)
      {
        std::vector<PointId> here;
        std::copy_if(chain.begin(), chain.end(), std::back_inserter(here),
          [&](PointId point) { return isFound[std::size_t(point)] != 0; });
        if (!here.empty())
        {
          middle.push_back(here[here.size() / 2]);
        }
      });
    return middle;
  }

  void AddToOutlines(const std::vector<PointId>& points)
  {
    std::vector<PointId>& all = this->Result.AddedToOutlines;
    all.insert(all.end(), points.begin(), points.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  /// Finds a corner of each of these slivers, too.
  std::vector<PointId> FindAtSlivers(const LoopTriangles& seen, std::vector<PointId>& cornersOfSlivers) const
  {
    std::vector<PointId> found;
    if (this->Result.Parameters.MaximumError == 0.0)
    {
      return found;
    }
    const SurfaceParameters& parameters = this->Result.Parameters;
    const double reach = std::min(parameters.OutlineTolerance, FarthestReach) + 2.0 * parameters.Radius;
    const double sine = SineOfDegrees(this->Options.Effort == DecimationEffort::Best
        ? std::min(this->Options.SmallestAngle, LargestKeptAngle)
        : this->Options.SmallestAngle);
    const DroppedPlaces dropped(this->Columns(), this->Result.Boundary.Boundary, this->Outlines);
    for (const auto& [a, b, c] : seen.Corners)
    {
      const std::array<PlanePoint, 3> corners = { this->Columns()[a], this->Columns()[b], this->Columns()[c] };
      if (SineOfSmallestAngle(corners[0], corners[1], corners[2]) < sine)
      {
        const PointId nearest = dropped.FindNearest(PlaceToSplit(corners), std::int32_t(std::ceil(reach)));
        if (nearest != NoPoint)
        {
          found.push_back(nearest);
          cornersOfSlivers.push_back(a);
        }
      }
    }
    return found;
  }

  void Simplify(double error, const Monitor& monitor)
  {
    if (this->Result.Parameters.MaximumError != error)
    {
      this->KnownChains.clear();
    }
    this->SetParameters(error);
    this->FindBoundary(monitor.Step(0.0, 0.5));
    if (this->Result.Kept.empty())
    {
      return;
    }
    BoundarySimplification simplified = this->SimplifyLoops(monitor.Step(0.5, 1.0));
    this->Result.BoundaryDeviation = simplified.Deviation;
    this->Result.OutlineDeviation = simplified.OutlineDeviation;
    this->Result.OutlineHeightDeviation = simplified.HeightDeviation;
    this->Result.NumberOutside = simplified.NumberOutside;
    for (DroppedPoint& dropped : this->Part.Dropped)
    {
      dropped.Target = *simplified.Boundary.begin(0); // any point that stays
    }
    this->Dropped.clear();
    std::merge(simplified.Dropped.begin(), simplified.Dropped.end(), this->Part.Dropped.begin(),
      this->Part.Dropped.end(), std::back_inserter(this->Dropped),
      [](const DroppedPoint& a, const DroppedPoint& b) { return a.Point < b.Point; });
    this->Outlines = std::move(simplified.Boundary);
  }

  /// The boundary is found again only if its smallest hole changes.
  void SetParameters(double error)
  {
    const std::int64_t before = this->Result.Parameters.SmallestHoleSize;
    this->Result.Parameters = ParametersFor(this->Options, this->Radius(), error, this->AreOutlinesFar);
    this->HasBoundary = this->HasBoundary && this->Result.Parameters.SmallestHoleSize == before;
  }

  /// Outlines for this error are of the holes at hand.
  bool HasHolesFor(double error) const
  {
    return ParametersFor(this->Options, this->Radius(), error, this->AreOutlinesFar).SmallestHoleSize ==
      this->Result.Parameters.SmallestHoleSize;
  }

  PlanePoints Columns() const
  {
    return this->Result.Kept.AreAll() ? this->Points.Columns : PlanePoints(this->KeptColumns);
  }
  std::vector<double>& Height() { return this->Result.Kept.AreAll() ? this->Points.Height : this->KeptHeight; }
  /// The mesh has taken them while it is reviewed.
  const std::vector<double>& HeightNow() { return this->Heights ? *this->Heights : this->Height(); }

  /// Points dropped from outlines have no patch.
  BoundedHorizon MakeHorizon(std::vector<double> height) const
  {
    BoundedHorizon horizon;
    horizon.Columns = this->Columns();
    horizon.Height = std::move(height);
    horizon.Patch = this->Result.Boundary.Patch;
    for (const DroppedPoint& dropped : this->Dropped)
    {
      horizon.Patch[dropped.Point] = NoPatch;
    }
    horizon.Dropped = this->Dropped;
    horizon.Boundary = this->Outlines;
    for (const DroppedPoint& dropped : this->Part.Dropped)
    {
      horizon.Beside.push_back(dropped.Point);
    }
    horizon.Locked = this->Part.Locked;
    horizon.Cuts = this->FaultedLinks();
    return horizon;
  }

  /// The options own the links.
  std::shared_ptr<const LinkCuts> FaultedLinks() const
  {
    return { std::shared_ptr<const LinkCuts>(), this->Options.Cuts };
  }

  BoundedHorizon CopyHorizon() { return this->MakeHorizon(this->Height()); }
  BoundedHorizon MoveHorizon() { return this->MakeHorizon(std::move(this->Height())); }

  BoundarySimplification SimplifyLoops(const Monitor& monitor)
  {
    const SurfaceParameters& parameters = this->Result.Parameters;
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.OutlineTolerance = parameters.OutlineTolerance;
    options.DistanceThreshold = parameters.DistanceThreshold;
    options.LongestEdge = LongestAtLoops(this->Options);
    options.Fixed = this->Result.Boundary.OpenCracks.PointsOfOpenEnds();
    options.Fixed.insert(options.Fixed.end(), this->Part.Fixed.begin(), this->Part.Fixed.end());
    options.Fixed.insert(options.Fixed.end(), this->Result.AddedToOutlines.begin(), this->Result.AddedToOutlines.end());
    options.Index = this->Result.Kept.AreAll() && this->Index ? &*this->Index : nullptr;
    options.Known = &this->KnownChains;
    return SimplifyBoundary(
      SpacePoints(this->Columns(), this->HeightNow(), 1), this->Result.Boundary.Boundary, options, monitor);
  }

  void FindBoundary(const Monitor& monitor)
  {
    if (this->HasBoundary)
    {
      return;
    }
    const BoundaryOptions options = BoundaryOptionsFor(this->Options, this->Result.Parameters);
    if (!this->Index)
    {
      this->Index.emplace(IndexForBoundary(this->Points.Columns, options));
    }
    this->Result.Boundary = FindExteriorBoundary(this->Points.Columns, *this->Index, options, monitor);
    this->Result.Kept = DropPointsWithoutPatch(this->Result.Boundary);
    if (!this->Result.Kept.AreAll())
    {
      this->KeptColumns = this->Result.Kept.Select(this->Points.Columns);
      this->KeptHeight = this->Result.Kept.Select(this->Points.Height);
    }
    this->HasBoundary = true;
  }

  void Decimate(const Monitor& monitor)
  {
    SurfaceParameters& parameters = this->Result.Parameters;
    DecimationOptions options;
    static_cast<DecimationQuality&>(options) = this->Options;
    options.MaximumError = parameters.MaximumError;
    options.MaximumNumberOfTriangles = this->Options.MaximumNumberOfTriangles;
    options.IsMeasured = !this->IsPart;
    this->Result.Mesh = SeismicHorizons::Decimate(
      this->MoveHorizon(), options, monitor, [this](const LoopTriangles& seen) { return this->Review(seen); });
    parameters.MaximumNumberOfPoints = this->Result.Mesh.MaximumNumberOfPoints;
    RawVector<PointId>& target = this->Result.Mesh.Points.Target;
    for (const DroppedPoint& dropped : this->Dropped)
    {
      target[dropped.Point] = target[dropped.Target];
    }
    this->Result.Dropped = std::move(this->Dropped);
  }

  SurfacePoints Points; // moved away by the last run
  const SurfaceOptions& Options;
  Surface Result;
  bool IsPart = false;
  KnownBoundary Part;
  std::optional<ColumnIndex> Index;
  bool HasBoundary = false;
  std::vector<PlanePoint> KeptColumns; // empty if all points have a patch
  std::vector<double> KeptHeight;
  DroppedPoints Dropped;
  Loops Outlines;
  bool AreOutlinesFar = false;
  KeptOfChains KnownChains; // within this error
  const std::vector<double>* Heights = nullptr;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ChooseSmallestHoleSize(int radius, double outlineTolerance)
{
  constexpr double Widest = 1 << 14; // no lattice has as many columns as its square
  const double narrow = std::ceil(std::min(2.0 * outlineTolerance, Widest));
  const std::int64_t span = 2 * std::int64_t(std::min(radius, LargestRadius)) + 1; // larger radii are refused
  const std::int64_t side = std::max(span, std::int64_t(narrow));
  return side * side;
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceParameters ParametersFor(const SurfaceOptions& options, int radius, double error, bool areOutlinesFar)
{
  SurfaceParameters parameters;
  parameters.Radius = radius;
  parameters.MaximumError = error;
  parameters.OutlineTolerance = options.OutlineTolerance.value_or(areOutlinesFar ? error : ToleranceOfOutlines(error));
  parameters.DistanceThreshold = options.DistanceThreshold.value_or(error);
  parameters.SmallestHoleSize = options.SmallestHoleSize
    ? *options.SmallestHoleSize
    : ChooseSmallestHoleSize(parameters.Radius, parameters.OutlineTolerance);
  return parameters;
}

//----------------------------------------------------------------------------------------------------------------------
BoundaryOptions BoundaryOptionsFor(const SurfaceOptions& options, const SurfaceParameters& parameters)
{
  BoundaryOptions ofBoundary;
  ofBoundary.Radius = parameters.Radius;
  ofBoundary.Growth = options.Growth;
  ofBoundary.KeepHoles = options.KeepHoles;
  ofBoundary.MinimumPatchSize = options.MinimumPatchSize;
  ofBoundary.SmallestHoleSize = parameters.SmallestHoleSize;
  ofBoundary.Cuts = options.Cuts;
  return ofBoundary;
}

//----------------------------------------------------------------------------------------------------------------------
Surface MakeSurface(SurfacePoints points, const SurfaceOptions& options, const Monitor& monitor)
{
  CheckQuality(options, options.MaximumNumberOfTriangles > 0);
  if (options.MaximumNumberOfTriangles == 0)
  {
    CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  }
  CheckAtLeast("outline tolerance", options.OutlineTolerance.value_or(0.0), 0.0, " columns");
  CheckAtLeast("distance threshold", options.DistanceThreshold.value_or(0.0), 0.0, " lattice units");
  const ColumnRows rows = ColumnRows::Of(points.Columns);
  SurfaceMaker maker(std::move(points), options);
  const std::int32_t rowsOfPart = rows.AreAscending ? RowsOfPart(rows.Box, options, maker.Radius()) : 0;
  return rowsOfPart > 0 ? maker.RunInParts(rows.Box, rowsOfPart, monitor) : maker.Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
Surface MakePart(SurfacePoints points, const SurfaceOptions& options, KnownBoundary part, const Monitor& monitor)
{
  return SurfaceMaker(std::move(points), options, std::move(part)).Run(monitor);
}
}
