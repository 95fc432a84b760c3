// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThirdPointSearch.h"

#include "Errors.h"
#include "Predicates.h"

#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// The size of cells that hold one point each on average.
std::int64_t CellSizeFor(const std::vector<PlanePoint>& points)
{
  PlanePoint size;
  for (const PlanePoint& point : points)
  {
    size.X = std::max(size.X, point.X);
    size.Y = std::max(size.Y, point.Y);
  }
  const double area = (double(size.X) + 1.0) * (double(size.Y) + 1.0);
  return std::max(std::int64_t(1), std::int64_t(std::ceil(std::sqrt(area / double(points.size())))));
}

PlanePoint Doubled(const PlanePoint& p)
{
  return { 2 * p.X, 2 * p.Y };
}

std::string Name(const Hop& hop, const std::vector<PointId>& names)
{
  return "boundary edge " + std::to_string(names[std::size_t(hop.From)]) + " - " +
    std::to_string(names[std::size_t(hop.To)]);
}
}

//----------------------------------------------------------------------------------------------------------------------
struct ThirdPointSearch::Edge
{
  PlanePoint A;
  PlanePoint B;
  /// The middle of the edge in doubled coordinates, where it is a whole number.
  PlanePoint DoubledMiddle() const { return { this->A.X + this->B.X, this->A.Y + this->B.Y }; }
};

/// A block of cells, the last row and column included.
struct ThirdPointSearch::Box
{
  std::int64_t FirstX;
  std::int64_t FirstY;
  std::int64_t LastX;
  std::int64_t LastY;

  bool Contains(const Box& other) const
  {
    return this->FirstX <= other.FirstX && this->FirstY <= other.FirstY && this->LastX >= other.LastX &&
      this->LastY >= other.LastY;
  }
  bool HasRow(std::int64_t row) const { return this->FirstY <= row && row <= this->LastY; }
};

//----------------------------------------------------------------------------------------------------------------------
ThirdPointSearch::ThirdPointSearch(
  const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names)
  : Points(points)
  , Grid(points, 1, CellSizeFor(points))
  , PointsInCell(SortByCell(this->Grid, points))
  , HopsInCell(SortByCell(this->Grid, points, boundary))
{
  this->CheckPlaces(names);
  this->CheckEdges(names);
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::CheckPlaces(const std::vector<PointId>& names) const
{
  const auto isBefore = [this](PointId a, PointId b) { return this->At(a) < this->At(b); };
  const auto coincide = [this](PointId a, PointId b) { return this->At(a) == this->At(b); };
  std::vector<PointId> points;
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    points.assign(this->PointsInCell.begin(cell), this->PointsInCell.end(cell));
    std::sort(points.begin(), points.end(), isBefore);
    const auto twin = std::adjacent_find(points.begin(), points.end(), coincide);
    if (twin != points.end())
    {
      throw InputError("points " + std::to_string(names[std::size_t(*twin)]) + " and " +
        std::to_string(names[std::size_t(*(twin + 1))]) +
        " in one place in plan, expected at most one point of a horizon above each place");
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::CheckEdges(const std::vector<PointId>& names) const
{
  for (std::int64_t cell = 0; cell < this->Grid.Size(); ++cell)
  {
    for (const Hop* hop = this->HopsInCell.begin(cell); hop != this->HopsInCell.end(cell); ++hop)
    {
      const PlanePoint& from = this->At(hop->From);
      const PlanePoint& to = this->At(hop->To);
      const Hop* const crossing = std::find_if(this->HopsInCell.begin(cell), hop,
        [&](const Hop& other) { return ProperlyCross(from, to, this->At(other.From), this->At(other.To)); });
      if (crossing != hop)
      {
        throw InputError(
          Name(*hop, names) + " crosses " + Name(*crossing, names) + ", expected edges that meet only at their ends");
      }
      const PointId* const point = std::find_if(this->PointsInCell.begin(cell), this->PointsInCell.end(cell),
        [&](PointId other) { return OnOpenSegment(from, to, this->At(other)); });
      if (point != this->PointsInCell.end(cell))
      {
        throw InputError("point " + std::to_string(names[std::size_t(*point)]) + " lies on " + Name(*hop, names) +
          ", expected no point between the ends of a boundary edge");
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
PointId ThirdPointSearch::Find(PointId a, PointId b) const
{
  const Edge edge{ this->At(a), this->At(b) };
  const Box everything = this->Everything();
  PointId best = NoPoint;
  Box done{ 0, 0, -1, -1 };
  for (std::int64_t radius = 0; best == NoPoint && !done.Contains(everything); radius = 2 * radius + 1)
  {
    const Box square = this->SquareAround(edge, radius);
    this->SearchBox(edge, square, done, best);
    done = square;
  }
  if (best != NoPoint)
  {
    // The part to the left of an edge of the circle through a better point lies inside that of a worse one.
    const Box circle = this->LeftPartOfCircle(edge, best);
    if (!done.Contains(circle))
    {
      this->SearchBox(edge, circle, done, best);
    }
  }
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPointSearch::Box ThirdPointSearch::Everything() const
{
  return { 0, 0, this->Grid.SizeX() - 1, this->Grid.SizeY() - 1 };
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPointSearch::Box ThirdPointSearch::SquareAround(const Edge& edge, std::int64_t radius) const
{
  const std::int64_t x = this->Grid.CellX(0.5 * edge.DoubledMiddle().X);
  const std::int64_t y = this->Grid.CellY(0.5 * edge.DoubledMiddle().Y);
  return { std::max<std::int64_t>(x - radius, 0), std::max<std::int64_t>(y - radius, 0),
    std::min(x + radius, this->Grid.SizeX() - 1), std::min(y + radius, this->Grid.SizeY() - 1) };
}

//----------------------------------------------------------------------------------------------------------------------
// The box of the circle's part to the left of the edge: around its ends, and those of the circle's four outermost
// points that are to the left. Plain doubles, and as much wider as their rounding can be wrong.
ThirdPointSearch::Box ThirdPointSearch::LeftPartOfCircle(const Edge& edge, PointId third) const
{
  const double bx = double(edge.B.X) - edge.A.X;
  const double by = double(edge.B.Y) - edge.A.Y;
  const double cx = double(this->At(third).X) - edge.A.X;
  const double cy = double(this->At(third).Y) - edge.A.Y;
  const double area = 2.0 * double(SignedArea(edge.A, edge.B, this->At(third)));
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / area;
  const double y = (bx * c2 - cx * b2) / area;
  const double radius = std::hypot(x, y);
  const double margin =
    1.0 + 1e-14 * ((std::abs(cx) + std::abs(cy)) * b2 + (std::abs(bx) + std::abs(by)) * c2) / area + 1e-14 * radius;

  double minX = std::min(0.0, bx);
  double minY = std::min(0.0, by);
  double maxX = std::max(0.0, bx);
  double maxY = std::max(0.0, by);
  const double outermost[4][2] = { { x - radius, y }, { x + radius, y }, { x, y - radius }, { x, y + radius } };
  const double nearlyLeft = -2.0 * margin * (std::abs(bx) + std::abs(by));
  for (const auto& point : outermost)
  {
    if (bx * point[1] - by * point[0] > nearlyLeft)
    {
      minX = std::min(minX, point[0]);
      maxX = std::max(maxX, point[0]);
      minY = std::min(minY, point[1]);
      maxY = std::max(maxY, point[1]);
    }
  }
  return { this->Grid.CellX(edge.A.X + minX - margin), this->Grid.CellY(edge.A.Y + minY - margin),
    this->Grid.CellX(edge.A.X + maxX + margin), this->Grid.CellY(edge.A.Y + maxY + margin) };
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::SearchBox(const Edge& edge, const Box& box, const Box& done, PointId& best) const
{
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
  {
    if (done.HasRow(row))
    {
      this->SearchRow(edge, row, box.FirstX, std::min(box.LastX, done.FirstX - 1), best);
      this->SearchRow(edge, row, std::max(box.FirstX, done.LastX + 1), box.LastX, best);
    }
    else
    {
      this->SearchRow(edge, row, box.FirstX, box.LastX, best);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The cells of a row stand one after the other, and so do their points.
void ThirdPointSearch::SearchRow(
  const Edge& edge, std::int64_t row, std::int64_t first, std::int64_t last, PointId& best) const
{
  if (first > last)
  {
    return;
  }
  const PointId* const end = this->PointsInCell.end(this->Grid.Index(last, row));
  for (const PointId* point = this->PointsInCell.begin(this->Grid.Index(first, row)); point != end; ++point)
  {
    if (this->IsBetter(edge, *point, best) && this->IsVisible(edge, *point))
    {
      best = *point;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool ThirdPointSearch::IsBetter(const Edge& edge, PointId candidate, PointId best) const
{
  const PlanePoint& place = this->At(candidate);
  return SignedArea(edge.A, edge.B, place) > 0 &&
    (best == NoPoint || InCircle(edge.A, edge.B, this->At(best), place) > 0);
}

//----------------------------------------------------------------------------------------------------------------------
// A segment that runs through the end of a boundary edge does not cross it. That does no harm: the end is nearer, so
// that the circle of the point behind it can not be empty.
bool ThirdPointSearch::IsVisible(const Edge& edge, PointId candidate) const
{
  const PlanePoint middle = edge.DoubledMiddle();
  const PlanePoint target = Doubled(this->At(candidate));
  bool visible = true;
  const auto blocks = [&](const Hop& hop)
  { return ProperlyCross(Doubled(this->At(hop.From)), Doubled(this->At(hop.To)), middle, target); };
  this->Grid.ForEachCellAlong({ 0.5 * middle.X, 0.5 * middle.Y }, this->At(candidate),
    [&](std::int64_t cell)
    { visible = visible && std::none_of(this->HopsInCell.begin(cell), this->HopsInCell.end(cell), blocks); });
  return visible;
}
}
