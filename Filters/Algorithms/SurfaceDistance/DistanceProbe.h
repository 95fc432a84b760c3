// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures distances of places to a surface, in all metrics at once.

#ifndef SeismicHorizonsDistanceProbe_h
#define SeismicHorizonsDistanceProbe_h

#include "Common/Base/Monitor.h"
#include "TriangleRaster.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
// Finds the nearest triangle of a surface, and heights, by a tree of boxes.
//
// A node is halved across its longest side, and each half again, to four children; leaves hold four triangles. The
// shape follows from the number of triangles without pointers: node n of a level has children 4 n to 4 n + 3. Boxes of
// children are stored side by side in single precision, so that one instruction compares all.
class TriangleTree
{
public:
  /// The surface must pass CheckSurface(), but needs no area, and outlive the tree. Takes n log n time and 23 bytes per
  /// triangle.
  explicit TriangleTree(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  /// Returns the number in the surface; neighbours in the tree are close.
  std::int32_t NumberOf(std::size_t sorted) const { return this->Numbers[sorted]; }

  /// `hint` is the sorted triangle to begin with, and becomes the nearest. A result for a place near by makes a query
  /// fast.
  double SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint, const Metric& metric = Metric()) const;

  /// Returns the z nearest to the point's, or NaN. Places within `tolerance` of an edge in plan count; vertical
  /// triangles do not.
  double FindHeight(const Eigen::Vector3d& point, double tolerance) const;

private:
  static constexpr std::size_t Fan = 4; // children of a node, and triangles of a leaf

  /// Low is above High without a child.
  struct Node
  {
    Eigen::Array4f Low[3];
    Eigen::Array4f High[3];
  };

  void MakeLevels();
  void Sort(const Monitor& monitor);
  void FillNodes();
  void FillLowest(std::size_t node);
  void FillFromChildren(std::size_t level, std::size_t node);
  void SetBox(Node& node, int child, const Eigen::AlignedBox3d& box) const;
  std::size_t NodesOf(std::size_t level) const { return this->LevelStart[level + 1] - this->LevelStart[level]; }
  std::size_t Levels() const { return this->LevelStart.size() - 1; }

  /// Returns the end of its triangles, which begin at Fan times its number.
  std::size_t EndOf(std::size_t leaf) const { return std::min((leaf + 1) * Fan, this->Triangles.size()); }
  template <typename DistancesOf, typename LeafSearch>
  void Descend(float bound, DistancesOf&& distancesOf, LeafSearch&& searchLeaf) const;

  const TriangleSurface& Surface;
  std::vector<Corners> Triangles;
  std::vector<std::int32_t> Numbers; // in the surface, by sorted triangle
  std::vector<Node> Nodes;
  std::vector<std::size_t> LevelStart; // first node per level, the root first, and the end
  float Margin = 0.0F; // exceeds rounding to single precision
};

/// The search uses a raster for near height fields, else a tree; distances are the same. A raster alone took 1.3 to 10
/// times as long as the tree on steep faults, 21 times on 30 sheets one above the other, and cannot hold vertical walls.
class TriangleSearch
{
public:
  /// The surface must pass CheckSurface() and outlive the search.
  explicit TriangleSearch(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  const TriangleSurface& GetSurface() const { return this->Surface; }

  /// The raster is null if there is a tree.
  const TriangleRaster* GetRaster() const { return this->Raster.get(); }
  const TriangleTree& GetTree() const { return *this->Tree; }

  /// Pieces are cells or single triangles; neighbouring triangles follow each other.
  static constexpr std::int64_t PiecesPerChunk = 512;
  std::int64_t Pieces() const
  {
    return this->Raster ? this->Raster->Cells() : std::int64_t(this->Surface.Triangles.size());
  }

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

class Facet
{
  // (a + b)^2 <= LittleMore a^2 + MuchMore b^2 bounds squares of sums.
  static constexpr double LittleMore = 1.01;
  static constexpr double MuchMore = 101.0;

public:
  void Set(const TriangleRaster& raster, std::int32_t number, const std::vector<Metric>& metrics);

  /// The number is -1 without a triangle.
  std::int32_t GetNumber() const { return this->Number; }

  bool Contains(const Eigen::Vector3d& place)
  {
    const std::array<double, 3> areas = DoubledAreas(place, this->Corner[0], this->Corner[1], this->Corner[2]);
    this->Areas = { this->Turn * areas[0], this->Turn * areas[1], this->Turn * areas[2] };
    return this->Number >= 0 && this->Areas[0] >= 0.0 && this->Areas[1] >= 0.0 && this->Areas[2] >= 0.0;
  }

  /// The place must be contained. Its nearest place is surely on this face if the ball that touches the plane is well
  /// within the triangle in plan.
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

  /// Needles measure less exactly than SquaredDistanceToTriangle().
  bool IsWide(std::size_t metric) const { return this->Planes[metric].IsWide; }

  /// The place must be contained.
  double Height() const;

  /// Returns whether no other triangle is within `distance` of a contained place in plan.
  bool IsOnlyOne(double distance) const;

private:
  struct Plane
  {
    Eigen::Vector3d Normal = Eigen::Vector3d::Zero(); // its product with a difference is distance times length
    double SquaredNormal = 1.0;
    std::array<double, 3> SquaredSides = {}; // in plan
    double Shrinkage = 1.0;
    double SquaredSlack = 0.0;
    bool IsSure = false; // IsNearest may be true
    bool IsWide = false;
  };

  void SetPlane(const Metric& metric, const Eigen::Vector3d (&sides)[3], Plane& plane) const;

  std::int32_t Number = -1;
  bool IsAlone = false; // nothing overlaps it by more than Slack
  double Slack = 0.0;
  std::array<Eigen::Vector3d, 3> Corner = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() };
  double Turn = 1.0; // -1 for clockwise corners
  std::array<double, 3> Areas = {};
  std::array<Plane, MostMetrics> Planes;
};

using NearestTriangles = std::array<std::int32_t, MostMetrics>; // by metric

/// Searches begin with the last result, so the same places in the same order find the same triangles: a probe serves
/// one chunk.
class DistanceProbe
{
public:
  /// Both arguments must outlive the probe; there are one or two metrics.
  DistanceProbe(const TriangleSearch& to, const std::vector<Metric>& metrics);

  const MetricValues& operator()(const Eigen::Vector3d& place);

  /// Skips places that are surely not the farthest.
  void RaiseLargest(const Eigen::Vector3d& place);

  /// Triangles are the nearest to the last place.
  const NearestTriangles& Triangles() const { return this->Nearest; }

  /// The place must be the last measured (TriangleTree::FindHeight).
  double FindHeight(const Eigen::Vector3d& place, double tolerance) const;

  MetricValues Largest = {}; // of all places

private:
  template <typename IsWanted>
  void Measure(const Eigen::Vector3d& place, IsWanted&& isWanted);
  std::int32_t FindAcross(const TriangleRaster& raster, const Eigen::Vector3d& place);
  double MeasureByRaster(
    const TriangleRaster& raster, const Eigen::Vector3d& place, std::int32_t across, std::size_t metric);

  const TriangleSearch& To;
  const std::vector<Metric>& Metrics;
  Facet Across;
  bool IsAcross = false;
  NearestTriangles Nearest = {};
  MetricValues Found = {};
};
}

#endif
