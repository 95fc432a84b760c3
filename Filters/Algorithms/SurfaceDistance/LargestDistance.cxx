// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Branch and bound, as in CGAL's bounded-error Hausdorff distance (Tang, Lee and Kim 2009, "Interactive Hausdorff
// distance computation for general polygonal models"). A triangle tries bounds in this order, until one is no more than
// the largest distance found:
//
// - distances of two places differ by at most their own distance;
// - the overlay with triangles above and below (PlanOverlay);
// - the distance to a triangle is convex, and largest at a corner: triangles nearest to corners and middle are tried.
//
// Remaining triangles are halved at their longest edge, highest bound first, in rounds: the first rounds settle most of
// the rest.

#include "LargestDistance.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

namespace SeismicHorizons
{
// ---- PlanOverlay ----------------------------------------------------------------------------------------------------

namespace
{
// An end of the surface this far inside counts as rounding, relative to the raster's slack and to the height of the
// triangle. The bound is raised by as much.
constexpr double RoundingOfOutlines = 2.5e-4;
constexpr double RoundingInside = 1e-3;

// Planes are heights over plan if their area in plan is at least this, relative to the squared longest edge, which
// limits the rounding of slopes.
constexpr double LeastFlatness = 1e-3;

/// Returns 1 for counter-clockwise corners, -1 for clockwise, 0 without area in plan.
int TurnOf(const TriangleSurface& surface, const Corners& t)
{
  const double area = PlanTriangle(surface, t).DoubledArea();
  return area > 0.0 ? 1 : area < 0.0 ? -1 : 0;
}

/// A point is inside if triangles close a ring around it: each adds a random number for its first edge at the point,
/// and subtracts one for its second, so that the sum is 0.
std::vector<unsigned char> FindInside(const TriangleSurface& surface)
{
  std::vector<std::atomic<std::uint64_t>> sums(surface.Points.size());
  ParallelFor(std::int64_t(surface.Triangles.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const Corners& t = surface.Triangles[n];
        const std::uint64_t turn = std::uint64_t(std::int64_t(TurnOf(surface, t)));
        const std::uint64_t number[3] = { Scramble(std::uint64_t(t[0])), Scramble(std::uint64_t(t[1])),
          Scramble(std::uint64_t(t[2])) };
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
          sums[t[corner]].fetch_add(
            turn * (number[(corner + 1) % 3] - number[(corner + 2) % 3]), std::memory_order_relaxed);
        }
      }
    });
  std::vector<unsigned char> inside(sums.size());
  std::transform(sums.begin(), sums.end(), inside.begin(),
    [](const std::atomic<std::uint64_t>& sum) { return sum.load(std::memory_order_relaxed) == 0 ? 1 : 0; });
  return inside;
}

struct PlanSide
{
  PointId Low;
  PointId High;
  std::int32_t Triangle;
  std::int8_t Corner; // where it starts
  std::int8_t Turn; // 1 if the triangle is left, seen from Low, else -1

  bool IsSame(const PlanSide& other) const { return this->Low == other.Low && this->High == other.High; }
};

/// Sorts edges between points that are not inside.
std::vector<PlanSide> ListOuterSides(const TriangleSurface& surface, const std::vector<unsigned char>& inside)
{
  std::vector<PlanSide> sides;
  for (std::size_t n = 0; n < surface.Triangles.size(); ++n)
  {
    const Corners& t = surface.Triangles[n];
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const PointId from = t[corner];
      const PointId to = t[(corner + 1) % 3];
      if (inside[from] == 0 && inside[to] == 0)
      {
        const int turn = TurnOf(surface, t);
        sides.push_back({ std::min(from, to), std::max(from, to), std::int32_t(n), std::int8_t(corner),
          std::int8_t(from < to ? turn : -turn) });
      }
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const PlanSide& a, const PlanSide& b)
    { return std::tie(a.Low, a.High, a.Triangle) < std::tie(b.Low, b.High, b.Triangle); });
  return sides;
}

/// The surface may end at edges without one triangle on each side.
std::vector<unsigned char> FindEnds(const TriangleSurface& surface)
{
  std::vector<unsigned char> ends(surface.Triangles.size(), 0);
  const std::vector<PlanSide> sides = ListOuterSides(surface, FindInside(surface));
  for (auto first = sides.begin(); first != sides.end();)
  {
    const auto last = std::find_if(first, sides.end(), [first](const PlanSide& side) { return !side.IsSame(*first); });
    const bool isBetween = last - first == 2 && first->Turn * (first + 1)->Turn == -1;
    for (; first != last; ++first)
    {
      ends[first->Triangle] |= isBetween ? 0 : (1U << unsigned(first->Corner));
    }
  }
  return ends;
}

class HeightPlane
{
public:
  explicit HeightPlane(const Triangle& t)
    : Origin(t[0])
  {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double longest =
      std::max({ (t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm() });
    this->IsFlat = std::abs(normal.z()) > LeastFlatness * longest;
    this->Slope = -normal.head<2>() / normal.z();
  }

  /// Returns infinity for a triangle that is too steep.
  double LargestGap(const Triangle& t) const
  {
    return this->IsFlat ? std::max({ this->Gap(t[0]), this->Gap(t[1]), this->Gap(t[2]) })
                        : std::numeric_limits<double>::infinity();
  }

  Eigen::Vector2d Slope;

private:
  bool IsFlat = false;

  double Gap(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d offset = place - this->Origin;
    return std::abs(offset.z() - this->Slope.x() * offset.x() - this->Slope.y() * offset.y());
  }

  Eigen::Vector3d Origin;
};

class CutPolygon
{
public:
  explicit CutPolygon(const Triangle& corners)
    : Size(3)
  {
    std::copy(corners.begin(), corners.end(), this->Place.begin());
  }

  /// Keeps the left of a line in plan, or its right if `turn` is negative.
  void Cut(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double turn)
  {
    const Eigen::Vector2d along = turn * (to - from).head<2>();
    const auto side = [&](const Eigen::Vector3d& place)
    { return along.x() * (place.y() - from.y()) - along.y() * (place.x() - from.x()); };
    std::array<Eigen::Vector3d, Most> kept;
    std::size_t count = 0;
    for (std::size_t n = 0; n < this->Size; ++n)
    {
      const Eigen::Vector3d& place = this->Place[n];
      const Eigen::Vector3d& next = this->Place[n + 1 < this->Size ? n + 1 : 0];
      const double here = side(place);
      const double there = side(next);
      if (here >= 0.0)
      {
        kept[count++] = place;
      }
      if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0))
      {
        kept[count++] = place + here / (here - there) * (next - place);
      }
    }
    this->Place = kept;
    this->Size = count;
  }

  const Eigen::Vector3d* begin() const { return this->Place.data(); }
  const Eigen::Vector3d* end() const { return this->Place.data() + this->Size; }

private:
  static constexpr std::size_t Most = 9; // each cut adds one, and rounding perhaps another
  std::array<Eigen::Vector3d, Most> Place;
  std::size_t Size;
};

bool IsWithin(const Eigen::Vector2d& place, const PlanTriangle& triangle, double area)
{
  const double turn = area < 0.0 ? -1.0 : 1.0;
  return turn * triangle.DoubledArea(0, place) >= 0.0 && turn * triangle.DoubledArea(1, place) >= 0.0 &&
    turn * triangle.DoubledArea(2, place) >= 0.0;
}

Triangle TriangleOf(const TriangleSurface& surface, const Corners& t)
{
  return { surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]) };
}
}

//----------------------------------------------------------------------------------------------------------------------
class PlanOverlay::Measure
{
public:
  Measure(const PlanOverlay& overlay, const Triangle& corners, const std::vector<Metric>& metrics,
    const MetricValues& enough, const MetricValues& bounds)
    : Surface(overlay.Raster.GetSurface())
    , Ends(overlay.Ends)
    , Corner(corners)
    , Metrics(metrics)
    , Enough(enough)
    , Bounds(bounds)
    , Plan(corners)
    , Plane(corners)
    , Low(this->Plan.Low(0), this->Plan.Low(1))
    , High(this->Plan.High(0), this->Plan.High(1))
    , Middle(((corners[0] + corners[1] + corners[2]) / 3.0).head<2>())
    , Turn(this->Plan.DoubledArea() < 0.0 ? -1.0 : 1.0)
    , LongestOverHeight(this->Plan.SquaredLongest() / std::abs(this->Plan.DoubledArea()))
    , MostOutside(std::min(RoundingOfOutlines * overlay.Raster.Slack(),
        RoundingInside * std::sqrt(this->Plan.SquaredLongest()) / this->LongestOverHeight))
  {
    for (std::size_t metric = 0; metric < metrics.size(); ++metric)
    {
      if (this->IsOpen(metric))
      {
        this->GapEnough = std::min(this->GapEnough, enough[metric] / metrics[metric].Weights()[2]);
      }
    }
  }

  /// Returns false if no lower bound is possible.
  bool Add(std::int32_t number)
  {
    ++this->Visits;
    const Corners& t = this->Surface.Triangles[number];
    const Triangle other = TriangleOf(this->Surface, t);
    const unsigned ends = this->Ends[number];
    const bool isNear = this->IsSmall(this->Plane.LargestGap(other));
    if (isNear && this->IsTouched && ends == 0)
    {
      return true;
    }
    const PlanTriangle plan(other);
    const double area = plan.DoubledArea();
    if (area == 0.0 || !this->MayOverlap(plan))
    {
      return true; // covers nothing
    }
    if (ends != 0 && !this->AllowsSides(other, ends))
    {
      return false;
    }
    this->IsTouched = this->IsTouched || IsWithin(this->Middle, plan, area);
    return isNear || this->IsSmall(HeightPlane(other).LargestGap(this->Corner)) || !Overlap(this->Plan, plan) ||
      this->AddPolygon(t, other, area < 0.0 ? -1.0 : 1.0);
  }

  void Lower(MetricValues& bounds) const
  {
    for (std::size_t metric = 0; metric < this->Metrics.size() && this->IsTouched; ++metric)
    {
      if (this->IsOpen(metric))
      {
        const Metric& in = this->Metrics[metric];
        // along the plane of the triangle, to places just outside
        const double stretch = std::sqrt(in.SquaredPlanNorm()) + in.Weights()[2] * this->Plane.Slope.norm();
        const double largest = std::max(in.Weights()[2] * this->LargestGap, this->Largest[metric]);
        bounds[metric] = std::min(bounds[metric], this->Outside > 0.0 ? largest + this->Outside * stretch : largest);
      }
    }
  }

  std::int64_t Visits = 0;

private:
  /// Small gaps need no distances.
  bool IsSmall(double gap)
  {
    const bool isSmall = gap <= this->GapEnough;
    this->LargestGap = isSmall ? std::max(this->LargestGap, gap) : this->LargestGap;
    return isSmall;
  }

  bool IsOpen(std::size_t metric) const { return this->Bounds[metric] > this->Enough[metric]; }

  bool MayOverlap(const PlanTriangle& plan) const
  {
    const auto& [a, b, c] = plan.Corner;
    return (a.array().min(b.array()).min(c.array()) < this->High).all() &&
      (a.array().max(b.array()).max(c.array()) > this->Low).all();
  }

  /// Edges where the surface may end must not pass through this triangle.
  bool AllowsSides(const Triangle& other, unsigned ends)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      if ((ends >> n & 1U) != 0 && !this->AllowsSide(other[n].head<2>(), other[(n + 1) % 3].head<2>()))
      {
        return false;
      }
    }
    return true;
  }

  bool AllowsSide(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    const Eigen::Vector2d along = to - from;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    double depth = std::numeric_limits<double>::infinity(); // inside the edge that it is least inside of
    for (std::size_t n = 0; n < 3; ++n)
    {
      const Eigen::Vector2d& corner = this->Plan.Corner[n];
      const Eigen::Vector2d side = this->Plan.Corner[(n + 1) % 3] - corner;
      const double inside =
        std::max(this->Turn * this->Plan.DoubledArea(n, from), this->Turn * this->Plan.DoubledArea(n, to));
      depth = std::min(depth, inside <= 0.0 ? 0.0 : inside / side.norm());
      const double left = along.x() * (corner.y() - from.y()) - along.y() * (corner.x() - from.x());
      least = std::min(least, left);
      most = std::max(most, left);
    }
    const double length = along.norm();
    depth = std::min(depth, std::max(0.0, std::min(most, -least)) / length);
    if (depth > this->MostOutside)
    {
      return false;
    }
    this->Outside = std::max(this->Outside, depth * this->LongestOverHeight);
    return true;
  }

  bool AddPolygon(const Corners& t, const Triangle& other, double turn)
  {
    CutPolygon polygon(this->Corner);
    polygon.Cut(other[0], other[1], turn);
    polygon.Cut(other[1], other[2], turn);
    polygon.Cut(other[2], other[0], turn);
    bool isLower = false;
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      if (!this->IsOpen(metric))
      {
        continue;
      }
      double squared = 0.0;
      for (const Eigen::Vector3d& place : polygon)
      {
        squared = std::max(squared, this->Metrics[metric].SquaredDistance(this->Surface, t, place));
      }
      this->Largest[metric] = std::max(this->Largest[metric], std::sqrt(squared));
      isLower = isLower || this->Largest[metric] < this->Bounds[metric];
    }
    return isLower;
  }

  const TriangleSurface& Surface;
  const std::vector<unsigned char>& Ends;
  const Triangle& Corner;
  const std::vector<Metric>& Metrics;
  const MetricValues& Enough;
  const MetricValues& Bounds;
  PlanTriangle Plan;
  HeightPlane Plane;
  Eigen::Array2d Low;
  Eigen::Array2d High;
  Eigen::Vector2d Middle;
  double Turn;
  double LongestOverHeight; // bounds distance from the triangle by distance from an edge
  double MostOutside;
  double GapEnough = std::numeric_limits<double>::infinity();
  double LargestGap = 0.0; // of small gaps
  MetricValues Largest = {}; // at corners of polygons with larger gaps
  double Outside = 0.0; // by rounding, where the surface ends within the triangle
  bool IsTouched = false; // at the middle
};

//----------------------------------------------------------------------------------------------------------------------
PlanOverlay::PlanOverlay(const TriangleRaster& raster)
  : Raster(raster)
  , Ends(FindEnds(raster.GetSurface()))
{
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t PlanOverlay::Lower(
  const Triangle& corners, const std::vector<Metric>& metrics, const MetricValues& enough, MetricValues& bounds) const
{
  Measure measure(*this, corners, metrics, enough, bounds);
  if (PlanTriangle(corners).DoubledArea() != 0.0 &&
    this->Raster.ForEachNear(PlanTriangle(corners), [&](std::int32_t triangle) { return measure.Add(triangle); }))
  {
    measure.Lower(bounds);
  }
  return measure.Visits;
}

// ---- LargestDistance ------------------------------------------------------------------------------------------------

namespace
{
// Bounds may differ by this, relative to the lower bound.
constexpr double Accuracy = 0.01;

// Smaller bounds are rounding, relative to the largest coordinate.
constexpr double DistanceRounding = 8.0 * std::numeric_limits<double>::epsilon();

constexpr std::int64_t TrianglesPerChunk = 1024;
constexpr std::int64_t CutPerChunk = 4;
constexpr std::int64_t FirstRound = 32;
constexpr std::int64_t LargestRound = 8192;

// Triangles are not cut with less effort left.
constexpr double LeastLeft = 0.1;

// Visiting this number of triangles of an overlay takes the time of one distance.
constexpr double VisitsPerDistance = 16.0;

/// An edge has its last corner twice.
struct Piece
{
  Triangle Corner;
  std::array<MetricValues, 3> Distance;
  std::array<NearestTriangles, 3> Nearest;
  MetricValues Bound; // of all places
  MetricValues DistanceRounding; // rounding of the bound
  double Order = 0.0; // highest first
};

struct OpenTriangle
{
  std::int32_t Number;
  std::int32_t Side; // from this corner; -1 for the triangle
  MetricValues Bound;
};

using OpenTriangles = std::vector<OpenTriangle>;

/// Bounds with an excess above 1 must be lowered.
double Excess(const MetricValues& bound, const MetricValues& enough)
{
  double excess = 0.0;
  for (std::size_t metric = 0; metric < bound.size(); ++metric)
  {
    excess = std::max(excess, bound[metric] > 0.0 ? bound[metric] / enough[metric] : 0.0);
  }
  return excess;
}

class Bounder
{
public:
  Bounder(const KnownDistances& known, const MetricValues& found)
    : Known(known)
    , Metrics(known.Metrics)
    , Probe(known.To, known.Metrics)
    , Result{ found, found }
  {
  }

  void Bound(std::int32_t number, OpenTriangles& open)
  {
    const TriangleSurface& from = this->Known.From;
    const Corners& t = from.Triangles[number];
    if (from.Counts(t))
    {
      const NearestTriangles& nearest = this->Known.Nearest[t[0]];
      if (nearest == this->Known.Nearest[t[1]] && nearest == this->Known.Nearest[t[2]])
      {
        return; // the distance to it is largest at a corner
      }
      this->BoundOne({ number, -1, {} }, open);
      return;
    }
    for (std::int32_t side = 0; side < 3; ++side)
    {
      if (from.Counts(t[side]) && from.Counts(t[(side + 1) % 3]))
      {
        this->BoundOne({ number, side, {} }, open);
      }
    }
  }

  /// Halves pieces until bounds are low or `allowed` distances are measured. Returns their number, and lowers the bound
  /// of the triangle.
  double Cut(OpenTriangle& triangle, double allowed)
  {
    this->Spent = 0.0;
    std::vector<Piece> pieces = { this->MakePiece(triangle) };
    pieces[0].Bound = triangle.Bound;
    const auto isLower = [](const Piece& a, const Piece& b) { return a.Order < b.Order; };
    while (!pieces.empty() && this->Spent < allowed)
    {
      std::pop_heap(pieces.begin(), pieces.end(), isLower);
      const Piece piece = pieces.back();
      pieces.pop_back();
      if (this->IsDone(piece))
      {
        continue;
      }
      for (Piece& half : this->Halve(piece))
      {
        if (!this->IsDone(half))
        {
          half.Order = this->Excess(half);
          pieces.push_back(half);
          std::push_heap(pieces.begin(), pieces.end(), isLower);
        }
      }
    }
    triangle.Bound = {};
    for (const Piece& piece : pieces)
    {
      KeepLarger(piece.Bound, triangle.Bound);
    }
    return this->Spent;
  }

  const LargestDistance& Get() const { return this->Result; }

private:
  Piece MakePiece(const OpenTriangle& triangle) const
  {
    const Corners& t = this->Known.From.Triangles[triangle.Number];
    Piece piece;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const std::size_t corner = triangle.Side < 0 ? n : (std::size_t(triangle.Side) + std::min<std::size_t>(n, 1)) % 3;
      const PointId point = t[corner];
      piece.Corner[n] = this->Known.From.Point(point);
      for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
      {
        piece.Distance[n][metric] = this->Known.Points[metric].Distance[point];
      }
      piece.Nearest[n] = this->Known.Nearest[point];
    }
    piece.Bound = {};
    piece.DistanceRounding = {};
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      piece.Bound[metric] = std::numeric_limits<double>::infinity();
      piece.DistanceRounding[metric] = DistanceRounding * this->LargestCoordinate(piece.Corner, metric);
    }
    return piece;
  }

  void BoundOne(OpenTriangle triangle, OpenTriangles& open)
  {
    Piece piece = this->MakePiece(triangle);
    this->Lower(piece);
    if (!this->IsDone(piece))
    {
      triangle.Bound = piece.Bound;
      open.push_back(triangle);
    }
  }

  /// Counts the bound if it is low enough.
  bool IsDone(const Piece& piece)
  {
    const bool isDone = this->Excess(piece) <= 1.0;
    if (isDone)
    {
      KeepLarger(piece.Bound, this->Result.Most);
    }
    return isDone;
  }

  double LargestCoordinate(const Triangle& corners, std::size_t metric) const
  {
    double largest = 0.0;
    for (const Eigen::Vector3d& corner : corners)
    {
      largest = std::max(largest, this->Metrics[metric](corner).cwiseAbs().maxCoeff());
    }
    return largest;
  }

  MetricValues Limits(const Piece& piece, double times) const
  {
    MetricValues limits = {};
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      limits[metric] = std::max(times * this->Result.Found[metric], piece.DistanceRounding[metric]);
    }
    return limits;
  }

  double Excess(const Piece& piece) const
  {
    return SeismicHorizons::Excess(piece.Bound, this->Limits(piece, 1.0 + Accuracy));
  }

  /// Stops at the largest distance found.
  void Lower(Piece& piece)
  {
    this->Spent += 1.0;
    const MetricValues limits = this->Limits(piece, 1.0);
    const auto isOpen = [&](std::size_t metric) { return piece.Bound[metric] > limits[metric]; };
    bool isAnyOpen = false;
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      if (isOpen(metric))
      {
        this->LowerByLength(piece, metric);
        isAnyOpen = isAnyOpen || isOpen(metric);
      }
    }
    if (isAnyOpen && this->Known.Overlay != nullptr)
    {
      this->Spent +=
        double(this->Known.Overlay->Lower(piece.Corner, this->Metrics, limits, piece.Bound)) / VisitsPerDistance;
    }
    isAnyOpen = false;
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      for (std::size_t corner = 0; corner < 3 && isOpen(metric); ++corner)
      {
        this->LowerByTriangle(piece, metric, piece.Nearest[corner][metric]);
      }
      isAnyOpen = isAnyOpen || isOpen(metric);
    }
    if (isAnyOpen && this->Excess(piece) > 1.0)
    {
      this->LowerFromMiddle(piece);
    }
  }

  /// A circle of radius 1/sqrt(3) of the longest edge encloses a triangle, whose places are as near to a corner.
  void LowerByLength(Piece& piece, std::size_t metric) const
  {
    const double distance[3] = { piece.Distance[0][metric], piece.Distance[1][metric], piece.Distance[2][metric] };
    const double largest = std::max({ distance[0], distance[1], distance[2] });
    double& bound = piece.Bound[metric];
    if (piece.Nearest[0][metric] == piece.Nearest[1][metric] && piece.Nearest[0][metric] == piece.Nearest[2][metric])
    {
      bound = std::min(bound, largest);
      return;
    }
    const std::array<double, 3> length = this->Lengths(piece, metric);
    bound = std::min(bound, largest + std::max({ length[0], length[1], length[2] }) / std::sqrt(3.0));
    for (std::size_t n = 0; n < 3; ++n)
    {
      bound = std::min(bound, distance[n] + std::max(length[n], length[(n + 2) % 3]));
    }
  }

  void LowerByTriangle(Piece& piece, std::size_t metric, std::int32_t triangle) const
  {
    const TriangleSurface& surface = this->Known.To.GetSurface();
    double squared = 0.0;
    for (std::size_t n = 0; n < 3; ++n)
    {
      squared =
        std::max(squared, this->Metrics[metric].SquaredDistance(surface, surface.Triangles[triangle], piece.Corner[n]));
    }
    piece.Bound[metric] = std::min(piece.Bound[metric], std::sqrt(squared));
  }

  void LowerFromMiddle(Piece& piece)
  {
    this->Spent += 1.0;
    const MetricValues limits = this->Limits(piece, 1.0);
    const Eigen::Vector3d middle = (piece.Corner[0] + piece.Corner[1] + piece.Corner[2]) / 3.0;
    const MetricValues distance = this->Probe(middle);
    KeepLarger(distance, this->Result.Found);
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      if (piece.Bound[metric] > limits[metric])
      {
        double farthest = 0.0;
        for (const Eigen::Vector3d& corner : piece.Corner)
        {
          farthest = std::max(farthest, this->Metrics[metric].Length(corner - middle));
        }
        piece.Bound[metric] = std::min(piece.Bound[metric], distance[metric] + farthest);
        this->LowerByTriangle(piece, metric, this->Probe.Triangles()[metric]);
      }
    }
  }

  std::array<double, 3> Lengths(const Piece& piece, std::size_t metric) const
  {
    std::array<double, 3> lengths;
    for (std::size_t n = 0; n < 3; ++n)
    {
      lengths[n] = this->Metrics[metric].Length(piece.Corner[(n + 1) % 3] - piece.Corner[n]);
    }
    return lengths;
  }

  /// Cuts the longest edge in the metric whose bound is worst.
  std::array<Piece, 2> Halve(const Piece& piece)
  {
    const MetricValues limits = this->Limits(piece, 1.0);
    const bool isSecond = this->Metrics.size() > 1 && piece.Bound[1] * limits[0] > piece.Bound[0] * limits[1];
    const std::array<double, 3> lengths = this->Lengths(piece, isSecond ? 1 : 0);
    const std::size_t from = std::size_t(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const std::size_t to = (from + 1) % 3;
    const Eigen::Vector3d middle = 0.5 * (piece.Corner[from] + piece.Corner[to]);
    this->Spent += 1.0;
    const MetricValues distance = this->Probe(middle);
    KeepLarger(distance, this->Result.Found);
    const NearestTriangles nearest = this->Probe.Triangles();
    std::array<Piece, 2> halves = { piece, piece };
    for (std::size_t n = 0; n < 2; ++n)
    {
      // An edge has two corners at one end.
      const Eigen::Vector3d& moved = piece.Corner[n == 0 ? to : from];
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        if (piece.Corner[corner] == moved)
        {
          halves[n].Corner[corner] = middle;
          halves[n].Distance[corner] = distance;
          halves[n].Nearest[corner] = nearest;
        }
      }
      this->Lower(halves[n]);
    }
    return halves;
  }

  const KnownDistances& Known;
  const std::vector<Metric>& Metrics;
  DistanceProbe Probe;
  LargestDistance Result; // Most is of finished triangles and pieces
  double Spent = 0.0;
};

struct BoundedTriangles
{
  LargestDistance Largest;
  OpenTriangles Open;

  void Add(const BoundedTriangles& other)
  {
    this->Largest.Add(other.Largest);
    this->Open.insert(this->Open.end(), other.Open.begin(), other.Open.end());
  }
};

BoundedTriangles BoundAll(const KnownDistances& known, const Monitor& monitor)
{
  return AddUpChunks<BoundedTriangles>(std::int64_t(known.From.Triangles.size()), TrianglesPerChunk, monitor,
    [&](BoundedTriangles& part, std::int64_t first, std::int64_t last)
    {
      Bounder bounder(known, known.Found);
      for (std::int64_t n = first; n < last; ++n)
      {
        bounder.Bound(std::int32_t(n), part.Open);
      }
      part.Largest = bounder.Get();
    });
}

struct RoundSums
{
  LargestDistance Largest;
  double Spent = 0.0;

  void Add(const RoundSums& other)
  {
    this->Largest.Add(other.Largest);
    this->Spent += other.Spent;
  }
};

double CutRound(
  const KnownDistances& known, OpenTriangle* triangles, std::int64_t size, double allowed, LargestDistance& largest)
{
  const MetricValues found = largest.Found;
  const RoundSums sums = AddUpChunks<RoundSums>(size, CutPerChunk, Monitor(),
    [&](RoundSums& part, std::int64_t first, std::int64_t last)
    {
      Bounder bounder(known, found);
      for (std::int64_t n = first; n < last; ++n)
      {
        part.Spent += bounder.Cut(triangles[n], allowed);
      }
      part.Largest = bounder.Get();
    });
  largest.Add(sums.Largest);
  return sums.Spent;
}

/// Highest bounds come first. Keeps triangles with high bounds, and returns the number of measured distances.
double CutAll(
  const KnownDistances& known, OpenTriangles& open, double allowed, LargestDistance& largest, const Monitor& monitor)
{
  const auto excess = [&](const OpenTriangle& triangle) { return Excess(triangle.Bound, largest.Found); };
  std::stable_sort(
    open.begin(), open.end(), [&](const OpenTriangle& a, const OpenTriangle& b) { return excess(a) > excess(b); });
  const std::int64_t size = std::int64_t(open.size());
  double left = allowed;
  std::int64_t round = FirstRound;
  for (std::int64_t first = 0; first < size; first += round, round = std::min(2 * round, LargestRound))
  {
    monitor.Progress(double(first) / double(size));
    // Half of the rest keeps the highest bounds from using all.
    const std::int64_t count = std::min(round, size - first);
    const double share = first + count < size ? 0.5 * left : left;
    left -= CutRound(known, &open[first], count, share / double(count), largest);
  }
  const auto isDone = [&](const OpenTriangle& triangle) { return triangle.Bound == MetricValues(); };
  open.erase(std::remove_if(open.begin(), open.end(), isDone), open.end());
  return allowed - left;
}
}

//----------------------------------------------------------------------------------------------------------------------
LargestDistance FindLargestDistance(const KnownDistances& known, std::int64_t effort, const Monitor& monitor)
{
  assert(known.Points.size() == known.Metrics.size());
  assert(known.Nearest.size() == known.From.Points.size());
  auto [largest, open] = BoundAll(known, monitor.Step(0.0, 0.5));
  largest.Add({ known.Found, known.Found });
  double left = double(effort);
  for (double part = 0.5; !open.empty() && left > LeastLeft * double(effort); part *= 0.5)
  {
    left -= CutAll(known, open, left, largest, monitor.Step(1.0 - part, 1.0 - 0.5 * part));
  }
  for (const OpenTriangle& triangle : open)
  {
    KeepLarger(triangle.Bound, largest.Most);
  }
  KeepLarger(largest.Found, largest.Most);
  return largest;
}
}
