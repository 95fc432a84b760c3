// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle mesh of any origin, with its edges, samples and heights.

#ifndef SeismicHorizonsTriangleSurface_h
#define SeismicHorizonsTriangleSurface_h

#include "Common/Base/CountingSort.h"
#include "Common/Horizon/Types.h"

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
}

#endif
