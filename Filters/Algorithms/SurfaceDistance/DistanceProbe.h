// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of places to a surface, in all metrics at one visit.

#ifndef SeismicHorizonsDistanceProbe_h
#define SeismicHorizonsDistanceProbe_h

#include "TriangleRaster.h"
#include "TriangleTree.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// A surface that is searched for its nearest triangle, in the structure that is quickest for it: a raster where it is
/// about a height field, else a tree. Both give the same distances.
class TriangleSearch
{
public:
  /// `surface` is one that CheckSurface takes, and must outlive the search.
  explicit TriangleSearch(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  const TriangleSurface& GetSurface() const { return this->Surface; }

  /// The raster, or nothing: then there is a tree.
  const TriangleRaster* GetRaster() const { return this->Raster.get(); }
  const TriangleTree& GetTree() const { return *this->Tree; }

  /// The triangles in an order in which neighbours follow each other, in pieces: cells, or single triangles. Loops take
  /// a fixed number of pieces at a time.
  static constexpr std::int64_t PiecesPerChunk = 512;
  std::int64_t Pieces() const
  {
    return this->Raster ? this->Raster->Cells() : std::int64_t(this->Surface.Triangles.size());
  }

  /// Calls visit(triangle) for the triangles of a range of pieces. Each triangle is in one piece.
  template <typename Visitor>
  void ForEachTriangle(std::int64_t first, std::int64_t last, Visitor&& visit) const
  {
    if (this->Raster)
    {
      this->Raster->ForEachTriangle(first, last, visit);
      return;
    }
    for (std::int64_t n = first; n < last; ++n)
    {
      visit(this->Tree->NumberOf(n));
    }
  }

private:
  const TriangleSurface& Surface;
  std::unique_ptr<TriangleRaster> Raster;
  std::unique_ptr<TriangleTree> Tree;
};

/// A triangle of a raster that many places are above or below, one after the other.
class Facet
{
  // Squares of sums: (a + b)^2 is at most LittleMore a^2 + MuchMore b^2.
  static constexpr double LittleMore = 1.01;
  static constexpr double MuchMore = 101.0;

public:
  /// Becomes another triangle.
  void Set(const TriangleRaster& raster, std::int32_t number, const std::vector<Metric>& metrics);

  /// -1 for no triangle.
  std::int32_t GetNumber() const { return this->Number; }

  /// Takes a place: whether it is above or below the triangle.
  bool Contains(const Eigen::Vector3d& place)
  {
    const std::array<double, 3> areas = DoubledAreas(place, this->Corner[0], this->Corner[1], this->Corner[2]);
    this->Areas = { this->Turn * areas[0], this->Turn * areas[1], this->Turn * areas[2] };
    return this->Number >= 0 && this->Areas[0] >= 0.0 && this->Areas[1] >= 0.0 && this->Areas[2] >= 0.0;
  }

  /// Of a place that it contains: whether the nearest place of the surface is known to be on this triangle's face, as
  /// the ball around the place that touches its plane is well within the triangle in plan; with the squared distance.
  bool IsNearest(std::size_t metric, const Eigen::Vector3d& place, double& squared) const
  {
    const Plane& plane = this->Planes[metric];
    const double height = plane.Normal.dot(place - this->Corner[0]);
    squared = height * height / plane.SquaredNormal;
    const double grown = (LittleMore * squared + plane.SquaredSlack) * plane.Shrinkage;
    return this->Areas[0] * this->Areas[0] >= grown * plane.SquaredSides[0] &&
      this->Areas[1] * this->Areas[1] >= grown * plane.SquaredSides[1] &&
      this->Areas[2] * this->Areas[2] >= grown * plane.SquaredSides[2] && plane.IsSure;
  }

  /// Whether that squared distance is as exact as SquaredDistanceToTriangle; not so for a needle.
  bool IsWide(std::size_t metric) const { return this->Planes[metric].IsWide; }

  /// Of a place that it contains: the z of the triangle there.
  double Height() const;

  /// Of a place that it contains: whether no other triangle is within that distance of the place in plan.
  bool IsOnlyOne(double distance) const;

private:
  /// The plane of the triangle in a metric.
  struct Plane
  {
    Eigen::Vector3d Normal = Eigen::Vector3d::Zero(); // times the difference of places: the distance, times its length
    double SquaredNormal = 1.0; // the square of that length
    std::array<double, 3> SquaredSides = {}; // in plan
    double Shrinkage = 1.0; // Metric::SquaredPlanShrinkage
    double SquaredSlack = 0.0; // of a sum of squares, see IsNearest
    bool IsSure = false; // whether IsNearest may be true
    bool IsWide = false;
  };

  void SetPlane(const Metric& metric, const Eigen::Vector3d (&sides)[3], Plane& plane) const;

  std::int32_t Number = -1;
  bool IsAlone = false; // no other triangle overlaps it in plan, but for a strip along its sides narrower than Slack
  double Slack = 0.0;
  std::array<Eigen::Vector3d, 3> Corner = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() };
  double Turn = 1.0; // -1 where corners go to the right
  std::array<double, 3> Areas = {}; // DoubledAreas of the last place, positive inside
  std::array<Plane, MostMetrics> Planes;
};

using NearestTriangles = std::array<std::int32_t, MostMetrics>; // by metric

/// Each search begins with what the one before found, so that a probe serves one chunk: with the same places in the
/// same order it finds the same triangles.
class DistanceProbe
{
public:
  /// There are one or two metrics. Both must outlive the probe.
  DistanceProbe(const TriangleSearch& to, const std::vector<Metric>& metrics);

  /// The distances of a place.
  const MetricValues& operator()(const Eigen::Vector3d& place);

  /// The same where only the largest distance is asked for: places that are surely nearer are not measured.
  void RaiseLargest(const Eigen::Vector3d& place);

  /// The numbers of the triangles that are nearest to that place.
  const NearestTriangles& Triangles() const { return this->Nearest; }

  /// The height of the surface at the place that was measured last, as TriangleTree::FindHeight.
  double FindHeight(const Eigen::Vector3d& place, double tolerance) const;

  /// Of all places so far, and of those that are known to be as far.
  const MetricValues& Largest() const { return this->Farthest; }
  void SetLargest(const MetricValues& largest) { this->Farthest = largest; }

private:
  template <typename IsWanted>
  void Measure(const Eigen::Vector3d& place, IsWanted&& isWanted);
  std::int32_t FindAcross(const TriangleRaster& raster, const Eigen::Vector3d& place);
  double MeasureByRaster(
    const TriangleRaster& raster, const Eigen::Vector3d& place, std::int32_t across, std::size_t metric);

  const TriangleSearch& To;
  const std::vector<Metric>& Metrics;
  std::size_t NumberOfMetrics;
  Facet Across; // the last one above or below a place
  bool IsAcross = false; // whether it is above or below the last place
  NearestTriangles Nearest = {};
  MetricValues Found = {};
  MetricValues Farthest = {};
};
}

#endif
