// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTypes_h
#define SeismicHorizonsTypes_h

#include "Common/Base/RawVector.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// Stages take horizons of less than 2^29 points.
using PointId = std::int32_t;

constexpr PointId NoPoint = -1;

/// Of points outside all patches, in patches below the minimum size, or dropped.
constexpr std::int32_t NoPatch = -1;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

/// Coordinates are columns or sub-voxels (Lattice.h), with absolute values below 2^29, so that products of differences
/// fit 64 bits.
struct PlanePoint
{
  std::int32_t X = 0;
  std::int32_t Y = 0;

  friend bool operator==(const PlanePoint& a, const PlanePoint& b) { return a.X == b.X && a.Y == b.Y; }
  friend bool operator!=(const PlanePoint& a, const PlanePoint& b) { return !(a == b); }
  /// By x, then y. Outlines start at their least point, as in the thesis.
  friend bool operator<(const PlanePoint& a, const PlanePoint& b) { return a.X != b.X ? a.X < b.X : a.Y < b.Y; }
};

/// Order by rows.
inline bool PrecedesByRow(const PlanePoint& a, const PlanePoint& b)
{
  return a.Y != b.Y ? a.Y < b.Y : a.X < b.X;
}

/// The column of merged points, which are on none.
constexpr PlanePoint NoColumn = { -1, -1 };

/// Does not own the places.
class PlanePoints
{
public:
  PlanePoints() = default;
  PlanePoints(const std::vector<PlanePoint>& places)
    : PlanePoints(places.data(), places.size())
  {
  }
  PlanePoints(std::initializer_list<PlanePoint> places) // The list must outlive the object.
    : PlanePoints(places.begin(), places.size())
  {
  }
  PlanePoints(const PlanePoint* first, std::size_t size)
    : First(first)
    , Count(size)
  {
  }

  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  const PlanePoint* begin() const { return this->First; }
  const PlanePoint* end() const { return this->First + this->Count; }
  const PlanePoint& operator[](std::size_t n) const { return this->First[n]; }
  const PlanePoint& front() const { return *this->First; }

private:
  const PlanePoint* First = nullptr;
  std::size_t Count = 0;
};

/// lattice units
struct SpacePoint
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
};

/// A directed edge of a loop or a triangle.
struct Edge
{
  PointId From = NoPoint;
  PointId To = NoPoint;
};

/// Closed polylines over points, which form a boundary; the edge from the last point to the first is implied. Seen from
/// +z the surface is to the right of every edge: outlines of patches run clockwise, and loops of holes
/// counterclockwise.
class Loops
{
public:
  std::size_t Size() const { return this->Ends.size(); }
  std::size_t TotalLength() const { return this->Points.size(); }
  std::size_t Length(std::size_t loop) const { return this->Ends[loop] - this->Start(loop); }

  const PointId* begin(std::size_t loop) const { return this->Points.data() + this->Start(loop); }
  const PointId* end(std::size_t loop) const { return this->Points.data() + this->Ends[loop]; }

  void Append(PointId point) { this->Points.push_back(point); }
  void Close() { this->Ends.push_back(this->Points.size()); }

  void AppendLoop(const Loops& other, std::size_t loop)
  {
    this->Points.insert(this->Points.end(), other.begin(loop), other.end(loop));
    this->Close();
  }

  /// number[point] is the new index of each point.
  template <typename Numbers>
  Loops Renumbered(const Numbers& number) const
  {
    return this->RenumberedBy([&number](PointId point) { return number[std::size_t(point)]; });
  }

  template <typename Number>
  Loops RenumberedBy(Number&& number) const
  {
    Loops result(*this);
    std::transform(result.Points.begin(), result.Points.end(), result.Points.begin(), number);
    return result;
  }

  /// Points of several loops are visited repeatedly.
  template <typename Visitor>
  void ForEachPoint(Visitor&& visit) const
  {
    for (const PointId point : this->Points)
    {
      visit(point);
    }
  }

  /// Marks visited points with 1.
  std::vector<unsigned char> MarkPoints(std::size_t points) const
  {
    std::vector<unsigned char> marks(points, 0);
    this->ForEachPoint([&marks](PointId point) { marks[std::size_t(point)] = 1; });
    return marks;
  }

  std::size_t CountPoints(std::size_t points) const
  {
    const std::vector<unsigned char> marks = this->MarkPoints(points);
    return std::size_t(std::count(marks.begin(), marks.end(), 1));
  }

  /// Includes the closing edge. A loop of one point has no edge.
  template <typename Visitor>
  void ForEachEdge(Visitor&& visit) const
  {
    for (std::size_t loop = 0; loop < this->Size(); ++loop)
    {
      this->ForEachEdgeOf(loop, visit);
    }
  }

  template <typename Visitor>
  void ForEachEdgeOf(std::size_t loop, Visitor&& visit) const
  {
    const PointId* const first = this->begin(loop);
    const std::size_t length = this->Length(loop);
    for (std::size_t n = 0; length > 1 && n < length; ++n)
    {
      visit(first[n], first[n + 1 < length ? n + 1 : 0]);
    }
  }

private:
  std::size_t Start(std::size_t loop) const { return loop == 0 ? 0 : this->Ends[loop - 1]; }

  std::vector<PointId> Points;
  std::vector<std::size_t> Ends;
};

enum class PointKind : unsigned char
{
  Boundary = 0,
  Barycentre = 1,
  InputPoint = 2
};

struct PointOrigin
{
  std::int32_t Ring = 0; // Ring of the cell, 1 at the boundary; 0 without rings.
  unsigned char Level = 0; // Number of times the cell was halved.
  PointKind Kind = PointKind::Boundary;
};

/// A cell of a simplification, for inspection.
struct SimplificationCell
{
  SpacePoint Low; // least corner, in lattice units
  double Size = 0.0;
  PointOrigin Origin; // Origin of the representative; Boundary for a cell that keeps boundary points.
  double Flatness = 0.0; // 0 if the stage does not use it.
  std::int32_t Patch = 0;
  std::int32_t Points = 0; // input points
};

struct Reduction
{
  /// Output point that represents each input point.
  RawVector<PointId> Target;
  /// Input point at each output point, or nearest to it in its group.
  std::vector<PointId> Source;
  /// 1 if the output point is the barycentre of several input points. Threads cannot write bits of a std::vector<bool>.
  std::vector<unsigned char> Averaged;
  /// Position per output point: x and y in sub-voxels, height in lattice units.
  std::vector<PlanePoint> Plane;
  std::vector<double> Height;
  std::int32_t SubVoxelsPerColumn = 1;
  Loops Boundary;
  /// Empty without cells.
  std::vector<PointOrigin> Origin;
  /// Flatness of the cell's points (thesis eq. 4.5); empty if the stage does not use it.
  std::vector<double> Flatness;
  /// Empty unless requested.
  std::vector<SimplificationCell> Cells;
};
}

#endif
