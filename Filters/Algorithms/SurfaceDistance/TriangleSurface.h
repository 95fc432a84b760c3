// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle mesh of any origin, with its edges, samples and heights, and distances of places from its triangles.

#ifndef SeismicHorizonsTriangleSurface_h
#define SeismicHorizonsTriangleSurface_h

#include "Common/Base/CountingSort.h"
#include "Common/Horizon/Types.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
using Corners = std::array<PointId, 3>;

/// Triangles may have any orientation, or no area. Points are relative to a place near them, so that differences are
/// exact.
struct TriangleSurface
{
  std::vector<Eigen::Vector3d> Points;
  std::vector<Corners> Triangles;
  /// Figures leave out marked points and their triangles; distances to these are measured.
  std::vector<unsigned char> LeftOut;

  const Eigen::Vector3d& Point(PointId point) const { return this->Points[point]; }

  bool Counts(PointId point) const { return this->LeftOut.empty() || this->LeftOut[point] == 0; }
  bool Counts(const Corners& t) const { return this->Counts(t[0]) && this->Counts(t[1]) && this->Counts(t[2]); }

  double Area(const Corners& t) const
  {
    return 0.5 * (this->Point(t[1]) - this->Point(t[0])).cross(this->Point(t[2]) - this->Point(t[0])).norm();
  }

  Eigen::AlignedBox3d Box(const Corners& t) const
  {
    Eigen::AlignedBox3d box(this->Point(t[0]));
    return box.extend(this->Point(t[1])).extend(this->Point(t[2]));
  }
};

/// Searches square coordinates in single precision, which limits their range.
constexpr double LargestCoordinate = 1e16;

/// Throws InputError, beginning with `name`, on surfaces without area, invalid corners, and too large coordinates.
void CheckSurface(const TriangleSurface& surface, const char* name);

double MeasureDiagonal(const TriangleSurface& surface);

// ---- Edges ----------------------------------------------------------------------------------------------------------

class SurfaceEdges
{
public:
  /// Takes linear time, 4 bytes per point and 12 per triangle.
  explicit SurfaceEdges(const TriangleSurface& surface);

  /// Calls visit(low, high, triangles) for edges whose lower end is in the range. A triangle with two equal corners
  /// counts twice.
  template <typename Visitor>
  void ForEach(std::int64_t firstPoint, std::int64_t lastPoint, Visitor&& visit) const
  {
    for (std::int64_t low = firstPoint; low < lastPoint; ++low)
    {
      const PointId* const end = this->Highs.end(low);
      for (const PointId* first = this->Highs.begin(low); first != end;)
      {
        const PointId* const next = std::find_if(first, end, [first](PointId high) { return high != *first; });
        visit(PointId(low), *first, std::uint32_t(next - first));
        first = next;
      }
    }
  }

private:
  ItemLists<PointId, std::uint32_t> Highs; // by lower end: other ends, sorted, per triangle
};

/// Edges of single triangles become flat triangles in plan (z = 0), with points of their own.
TriangleSurface FindOutline(const TriangleSurface& surface, const SurfaceEdges& edges);

// ---- Samples --------------------------------------------------------------------------------------------------------
// Places follow from random numbers by triangle or edge, whatever the number of threads.

/// The last step of SplitMix64 (Steele, Lea and Flood 2014) makes a number of 64 bits.
inline std::uint64_t Scramble(std::uint64_t counter)
{
  std::uint64_t bits = counter * 0x9e3779b97f4a7c15ULL;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31U);
}

/// Returns 0 to below 1.
inline double Fraction(std::uint64_t bits)
{
  return double(bits >> 11U) * 0x1.0p-53;
}

/// Places are from the sequence R2 (Roberts 2018), even for any count, shifted at random and folded onto the triangle.
template <typename Visitor>
void SampleTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, std::int64_t count,
  std::uint64_t random, Visitor&& visit)
{
  constexpr double StepU = 0.7548776662466927; // 1 / g and 1 / g^2, where g^3 = g + 1
  constexpr double StepV = 0.5698402909980532;
  double u = Fraction(random);
  double v = Fraction(Scramble(random));
  for (std::int64_t n = 0; n < count; ++n)
  {
    const bool beyond = u + v > 1.0; // in the folded half of the square
    visit(Eigen::Vector3d(a + (beyond ? 1.0 - u : u) * (b - a) + (beyond ? 1.0 - v : v) * (c - a)));
    u += u + StepU < 1.0 ? StepU : StepU - 1.0;
    v += v + StepV < 1.0 ? StepV : StepV - 1.0;
  }
}

/// Places are random within `count` equal pieces.
template <typename Visitor>
void SampleEdge(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, std::int64_t count, std::uint64_t random, Visitor&& visit)
{
  for (std::int64_t n = 0; n < count; ++n)
  {
    const double fraction = (double(n) + Fraction(Scramble(random + std::uint64_t(n)))) / double(count);
    visit(Eigen::Vector3d(a + fraction * (b - a)));
  }
}

// ---- Heights --------------------------------------------------------------------------------------------------------

/// Areas are opposite to corners; inside, all have the sign of their sum.
inline std::array<double, 3> DoubledAreas(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double ax = a.x() - p.x();
  const double ay = a.y() - p.y();
  const double bx = b.x() - p.x();
  const double by = b.y() - p.y();
  const double cx = c.x() - p.x();
  const double cy = c.y() - p.y();
  return { bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx };
}

/// Returns NaN where NearerHeight has none.
inline double HeightAt(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners, double tolerance)
{
  std::array<double, 3> area = DoubledAreas(p, corners[0], corners[1], corners[2]);
  const double sum = area[0] + area[1] + area[2];
  const double turn = sum < 0.0 ? -1.0 : 1.0;
  double height = 0.0;
  double inside = 0.0;
  for (std::size_t n = 0; n < 3; ++n)
  {
    const double square = (corners[(n + 2) % 3] - corners[(n + 1) % 3]).head<2>().squaredNorm() * tolerance * tolerance;
    if (!(sum * sum > square) || (turn * area[n] < 0.0 && area[n] * area[n] > square))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    area[n] = std::max(0.0, turn * area[n]);
    inside += area[n];
    height += area[n] * corners[n].z();
  }
  return height / inside;
}

/// Returns the z above or below the place if nearer than `best`, else `best`; NaN means none. Places up to `tolerance`
/// outside count; narrower triangles have no z.
inline double NearerHeight(
  const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place, double tolerance, double best)
{
  const double height = HeightAt(place, { surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]) }, tolerance);
  // The first comparison is false for NaN.
  return std::abs(height - place.z()) >= std::abs(best - place.z()) || std::isnan(height) ? best : height;
}

// ---- Metrics --------------------------------------------------------------------------------------------------------
// Distances from a place to a triangle can be measured on the lattice or in the world, which a linear map relates. One
// search structure serves both.

/// The segment may be a point.
inline double SquaredDistanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d along = b - a;
  const double length = along.squaredNorm();
  const double fraction = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - a - fraction * along).squaredNorm();
}

/// The squared doubled area of a needle is at most this fraction of the fourth power of the longer edge at `a`. It is a
/// hundred times longer than wide: differences of products of four lengths lose 4 of 16 digits.
constexpr double SquaredWidthOfNeedle = 1e-4;

/// No corner may be nearest. Cross products lose half as many digits of needles as scalar products.
inline double SquaredDistanceToNeedle(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  // Rounding of the cross product along the longest edge would be multiplied by the distance, so it is removed.
  const Eigen::Vector3d sides[3] = { b - a, c - b, a - c };
  const Eigen::Vector3d& longest = *std::max_element(
    sides, sides + 3, [](const auto& one, const auto& other) { return one.squaredNorm() < other.squaredNorm(); });
  Eigen::Vector3d normal = sides[0].cross(-sides[2]);
  normal -= longest.squaredNorm() > 0.0 ? Eigen::Vector3d(normal.dot(longest) / longest.squaredNorm() * longest)
                                        : Eigen::Vector3d::Zero();
  const double square = normal.squaredNorm();
  const auto isLeft = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  { return normal.dot((to - from).cross(p - from)) > 0.0; };
  if (square > 0.0 && isLeft(a, b) && isLeft(b, c) && isLeft(c, a))
  {
    const double distance = normal.dot(p - a);
    return distance * distance / square;
  }
  return std::min(
    { SquaredDistanceToSegment(p, a, b), SquaredDistanceToSegment(p, b, c), SquaredDistanceToSegment(p, c, a) });
}

/// Signs of scalar products show whether a corner, an edge or the face is nearest (Ericson 2005, "Real-Time Collision
/// Detection", 5.1.5).
inline double SquaredDistanceToTriangle(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return ap.squaredNorm();
  }
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return bp.squaredNorm();
  }
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return cp.squaredNorm();
  }
  // With q the projection of p, onC is four times the signed area of a, b, q, times the signed area of a, b, c, and so
  // on. The sum is the squared cross product of ab and ac.
  const double onC = d1 * d4 - d3 * d2;
  const double onB = d5 * d2 - d1 * d6;
  const double onA = d3 * d6 - d5 * d4;
  const double sum = onA + onB + onC;
  const double longer = std::max(d1 - d3, d2 - d6);
  if (!(sum > SquaredWidthOfNeedle * longer * longer))
  {
    return SquaredDistanceToNeedle(p, a, b, c);
  }
  if (onC <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return SquaredDistanceToSegment(p, a, b);
  }
  if (onB <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return SquaredDistanceToSegment(p, a, c);
  }
  if (onA <= 0.0 && d4 >= d3 && d5 >= d6)
  {
    return SquaredDistanceToSegment(p, b, c);
  }
  return (ap - onB / sum * ab - onC / sum * ac).squaredNorm();
}

/// Rotations and reflections keep distances, so a triangular matrix serves for any map: x to (Plan(0, 0) x, 0), y to
/// (Plan(0, 1), Plan(1, 1)) y, z to Vertical z.
class Metric
{
public:
  Metric() = default;

  /// Neither map may be singular.
  Metric(const Eigen::Matrix2d& plan, double vertical)
    : XtoX(plan.col(0).norm())
    , YtoX(plan.col(0).dot(plan.col(1)) / this->XtoX)
    , YtoY(std::abs(plan.determinant()) / this->XtoX)
    , ZtoZ(std::abs(vertical))
  {
    // With c for the cosine between the images of x and y, |image|^2 >= (1 - |c|) (|x image|^2 + |y image|^2).
    const double yLength = plan.col(1).norm();
    const double least = std::sqrt(std::max(0.0, 1.0 - std::abs(this->YtoX) / yLength));
    this->AxisWeights = { least * this->XtoX, least * yLength, this->ZtoZ };
    this->Shrinkage = 1.0 / (this->XtoX * this->YtoY * this->XtoX * this->YtoY);
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const
  {
    return { this->XtoX * v.x() + this->YtoX * v.y(), this->YtoY * v.y(), this->ZtoZ * v.z() };
  }

  Eigen::Vector3d Transposed(const Eigen::Vector3d& v) const
  {
    return { this->XtoX * v.x(), this->YtoX * v.x() + this->YtoY * v.y(), this->ZtoZ * v.z() };
  }

  /// Differences are at least as long as their coordinates times these weights.
  const Eigen::Array3d& Weights() const { return this->AxisWeights; }

  /// Returns the squared ratio of an area in plan to the area of its image.
  double SquaredPlanShrinkage() const { return this->Shrinkage; }

  /// Returns the square of the largest stretch of a difference in plan.
  double SquaredPlanNorm() const { return this->XtoX * this->XtoX + this->YtoX * this->YtoX + this->YtoY * this->YtoY; }

  double Length(const Eigen::Vector3d& v) const { return (*this)(v).norm(); }

  double Area(const TriangleSurface& surface, const Corners& t) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    return 0.5 * (*this)(surface.Point(t[1]) - a).cross((*this)(surface.Point(t[2]) - a)).norm();
  }

  double SquaredDistance(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    return SquaredDistanceToTriangle(
      (*this)(place - a), Eigen::Vector3d::Zero(), (*this)(surface.Point(t[1]) - a), (*this)(surface.Point(t[2]) - a));
  }

  /// Never exceeds SquaredDistance().
  double SquaredDistanceToBox(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    const Eigen::Vector3d& b = surface.Point(t[1]);
    const Eigen::Vector3d& c = surface.Point(t[2]);
    // Vectorized by two coordinates.
    const auto plan = [](const Eigen::Vector3d& v) { return v.head<2>().array(); };
    const Eigen::Array2d low = plan(a).min(plan(b)).min(plan(c)) - plan(place);
    const Eigen::Array2d high = plan(place) - plan(a).max(plan(b)).max(plan(c));
    const Eigen::Array2d gap = low.max(high).max(0.0) * this->AxisWeights.head<2>();
    const double below = std::min(std::min(a.z(), b.z()), c.z()) - place.z();
    const double above = place.z() - std::max(std::max(a.z(), b.z()), c.z());
    const double height = std::max(std::max(below, above), 0.0) * this->AxisWeights[2];
    return gap.square().sum() + height * height;
  }

private:
  double XtoX = 1.0;
  double YtoX = 0.0;
  double YtoY = 1.0;
  double ZtoZ = 1.0;
  double Shrinkage = 1.0;
  Eigen::Array3d AxisWeights = { 1.0, 1.0, 1.0 };
};

constexpr std::size_t MostMetrics = 2;

using MetricValues = std::array<double, MostMetrics>; // by metric

inline void KeepLarger(const MetricValues& other, MetricValues& largest)
{
  std::transform(
    other.begin(), other.end(), largest.begin(), largest.begin(), [](double a, double b) { return std::max(a, b); });
}

/// Boxes rule out most triangles faster. `best` is the squared distance from the triangle `nearest`.
inline void KeepNearer(const TriangleSurface& surface, const Corners& t, std::int32_t triangle,
  const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best)
{
  if (triangle != nearest && metric.SquaredDistanceToBox(surface, t, place) < best)
  {
    const double distance = metric.SquaredDistance(surface, t, place);
    nearest = distance < best ? triangle : nearest;
    best = std::min(best, distance);
  }
}
}

#endif
