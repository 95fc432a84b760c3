// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plain data the algorithms work on.

#ifndef SeismicHorizonsTypes_h
#define SeismicHorizonsTypes_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace SeismicHorizons
{
/// The index of a point of one horizon. Stages take horizons of less than 2^29 points.
using PointId = std::int32_t;

constexpr PointId NoPoint = -1;

/// A place in the plane of the lattice, in whole columns or in sub-voxels (Lattice.h); names and comments of variables
/// tell in which. The size of both coordinates is below 2^29, so that products of differences fit 64 bits.
struct PlanePoint
{
  std::int32_t X = 0;
  std::int32_t Y = 0;

  friend bool operator==(const PlanePoint& a, const PlanePoint& b) { return a.X == b.X && a.Y == b.Y; }
  friend bool operator!=(const PlanePoint& a, const PlanePoint& b) { return !(a == b); }
  /// By x, and where that is the same by y. Outlines start at the least of their points, as in the thesis.
  friend bool operator<(const PlanePoint& a, const PlanePoint& b) { return a.X != b.X ? a.X < b.X : a.Y < b.Y; }
};

/// The column of points that have left theirs, as those that a simplification merged.
constexpr PlanePoint NoColumn = { -1, -1 };

/// Places of points that others own, as a std::vector or an array of VTK.
class PlanePoints
{
public:
  PlanePoints() = default;
  PlanePoints(const std::vector<PlanePoint>& places)
    : PlanePoints(places.data(), places.size())
  {
  }
  PlanePoints(std::initializer_list<PlanePoint> places) // which have to outlive it
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

/// A point of the plane with its height, in lattice units.
struct SpacePoint
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
};

/// A side of a loop or of a triangle, in one of its two directions.
struct Edge
{
  PointId From = NoPoint;
  PointId To = NoPoint;
};

/// Loops, which are closed polylines over the points of a horizon, one after the other; the edge from the last point of
/// a loop to its first is implied. Together they are a boundary. Seen from +z the surface lies to the right of every
/// edge: outlines of patches run clockwise, and the loops of holes counter-clockwise.
class Loops
{
public:
  std::size_t Size() const { return this->Ends.size(); }
  std::size_t TotalLength() const { return this->Points.size(); }
  std::size_t Length(std::size_t loop) const { return this->Ends[loop] - this->Start(loop); }

  const PointId* begin(std::size_t loop) const { return this->Points.data() + this->Start(loop); }
  const PointId* end(std::size_t loop) const { return this->Points.data() + this->Ends[loop]; }

  /// Appends to the loop that is being built.
  void Append(PointId point) { this->Points.push_back(point); }
  /// Ends the loop that is being built; the next point starts another one.
  void Close() { this->Ends.push_back(this->Points.size()); }

  /// Appends a whole loop of another set.
  void AppendLoop(const Loops& other, std::size_t loop)
  {
    this->Points.insert(this->Points.end(), other.begin(loop), other.end(loop));
    this->Close();
  }

  /// The same loops over points that have other numbers: number[point] for each point.
  Loops Renumbered(const std::vector<PointId>& number) const
  {
    return this->RenumberedBy([&number](PointId point) { return number[std::size_t(point)]; });
  }

  /// The same with number(point).
  template <typename Number>
  Loops RenumberedBy(Number&& number) const
  {
    Loops result(*this);
    std::transform(result.Points.begin(), result.Points.end(), result.Points.begin(), number);
    return result;
  }

  /// Calls visit(point) for each point of each loop, as often as loops visit it.
  template <typename Visitor>
  void ForEachPoint(Visitor&& visit) const
  {
    for (const PointId point : this->Points)
    {
      visit(point);
    }
  }

  /// For each of `points` points 1 when a loop visits it, else 0.
  std::vector<unsigned char> MarkPoints(std::size_t points) const
  {
    std::vector<unsigned char> marks(points, 0);
    this->ForEachPoint([&marks](PointId point) { marks[std::size_t(point)] = 1; });
    return marks;
  }

  /// How many of `points` points loops visit.
  std::size_t CountPoints(std::size_t points) const
  {
    const std::vector<unsigned char> marks = this->MarkPoints(points);
    return std::size_t(std::count(marks.begin(), marks.end(), 1));
  }

  /// Calls visit(from, to) for each edge, the closing one included. A loop of one point has none.
  template <typename Visitor>
  void ForEachEdge(Visitor&& visit) const
  {
    for (std::size_t loop = 0; loop < this->Size(); ++loop)
    {
      this->ForEachEdgeOf(loop, visit);
    }
  }

  /// The same for one loop.
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

/// Where a point of a simplified horizon comes from. The numbers go into an array (Documentation/DataModel.md).
enum class PointKind : unsigned char
{
  Boundary = 0,
  Barycentre = 1,
  InputPoint = 2
};

struct PointOrigin
{
  std::int32_t Ring = 0; // of its cell: 1 at the boundary; 0 where cells have no rings
  unsigned char Level = 0; // how many times the cell was halved
  PointKind Kind = PointKind::Boundary;
};

/// One of the cells that a horizon was cut into, for inspection.
struct SimplificationCell
{
  SpacePoint Low; // its least corner, in lattice units
  double Size = 0.0;
  PointOrigin Origin; // that of the representative of the cell; Boundary for a cell that keeps boundary points
  double Flatness = 0.0; // of its points; 0 where a stage does not look at it
  std::int32_t Patch = 0;
  std::int32_t Points = 0; // how many input points it holds
};

/// What a simplification made of the points of a horizon.
struct Reduction
{
  /// For each input point the output point that represents it: itself, or the one it was merged into.
  std::vector<PointId> Target;
  /// For each output point the input point it is, or the input point of its group that lies nearest to it.
  std::vector<PointId> Source;
  /// For each output point: 1 when it is the barycentre of several input points, else 0. Bytes, because the bits of a
  /// std::vector<bool> cannot be written by several threads at a time.
  std::vector<unsigned char> Averaged;
  /// For each output point its place: in the plane in sub-voxels, of which a column has so many, in lattice units
  /// upwards.
  std::vector<PlanePoint> Plane;
  std::vector<double> Height;
  std::int32_t SubVoxelsPerColumn = 1;
  /// The loops over the output points.
  Loops Boundary;
  /// For each output point the cell it comes from. Empty where a stage has no cells.
  std::vector<PointOrigin> Origin;
  /// For each output point how flat the points of that cell were (thesis eq. 4.5). Empty where a stage does not look at
  /// it.
  std::vector<double> Flatness;
  /// The cells, when they were asked for.
  std::vector<SimplificationCell> Cells;
};
}

#endif
