// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes of horizons that were cut into parts at some rows, joined again, and what must be true of them.

#ifndef SeismicHorizonsSurfaceParts_h
#define SeismicHorizonsSurfaceParts_h

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Algorithms/Surface/SurfaceJoin.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/ExactPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceParts
{
using namespace SeismicHorizons;

/// The points of a surface with the memory for them.
struct Points
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Height;

  operator SurfacePoints() const { return { this->Columns, this->Height }; }
};

inline Points Select(const Points& points, std::int32_t first, std::int32_t last)
{
  Points part;
  for (std::size_t n = 0; n < points.Columns.size(); ++n)
  {
    if (points.Columns[n].Y >= first && points.Columns[n].Y <= last)
    {
      part.Columns.push_back(points.Columns[n]);
      part.Height.push_back(points.Height[n]);
    }
  }
  return part;
}

/// The mesh of a part with vertices on whole columns, as it is joined.
inline SurfacePart ToPart(const Points& points, const Surface& surface, const SeamRows& seams)
{
  SurfacePart part;
  part.Seams = seams;
  const Reduction& vertices = surface.Mesh.Points;
  for (std::size_t vertex = 0; vertex < vertices.Plane.size(); ++vertex)
  {
    part.Vertices.push_back(vertices.Plane[vertex]);
  }
  part.Height = vertices.Height;
  part.Count.assign(part.Vertices.size(), 0);
  for (std::size_t point = 0; point < vertices.Target.size(); ++point)
  {
    const bool isOnLower = seams.Lower && points.Columns[std::size_t(surface.Kept[point])].Y == *seams.Lower;
    part.Count[std::size_t(vertices.Target[point])] += isOnLower ? 0 : 1;
  }
  part.Boundary = vertices.Boundary;
  part.Triangles = surface.Mesh.Triangles;
  for (const PointId gap : surface.OpenGaps)
  {
    part.OpenGaps.push_back(vertices.Target[std::size_t(gap)]);
  }
  return part;
}

/// Columns of points that are on outlines, but not on seams: those that are dropped are near the new outline, and may
/// be farther above or below the mesh.
using Columns = std::set<std::pair<std::int32_t, std::int32_t>>;

inline void AddOutlines(const Points& points, const Surface& surface, const SeamRows& seams, Columns& onOutlines)
{
  surface.Boundary.Boundary.ForEachPoint(
    [&](PointId point)
    {
      const PlanePoint& column = points.Columns[std::size_t(surface.Kept[std::size_t(point)])];
      if (column.Y != seams.Lower && column.Y != seams.Upper)
      {
        onOutlines.insert({ column.X, column.Y });
      }
    });
}

/// The parts between rows where the horizon is cut, ascending.
inline std::vector<SurfacePart> MakeParts(
  const Points& points, const std::vector<std::int32_t>& cuts, SurfaceOptions options, Columns& onOutlines)
{
  options.Radius = options.Radius ? *options.Radius : 1;
  std::vector<SurfacePart> parts;
  for (std::size_t n = 0; n <= cuts.size(); ++n)
  {
    const bool isFirst = n == 0;
    const bool isLast = n == cuts.size();
    options.Seams.Lower = isFirst ? std::optional<std::int32_t>() : cuts[n - 1];
    options.Seams.Upper = isLast ? std::optional<std::int32_t>() : cuts[n];
    const Points part = Select(points, isFirst ? std::numeric_limits<std::int32_t>::min() : cuts[n - 1],
      isLast ? std::numeric_limits<std::int32_t>::max() : cuts[n]);
    const Surface surface = part.Columns.empty() ? Surface() : MakeSurface(part, options);
    AddOutlines(part, surface, options.Seams, onOutlines);
    parts.push_back(ToPart(part, surface, options.Seams));
  }
  return parts;
}

/// The heights of the vertices of a joined mesh.
inline std::vector<double> HeightsOf(const std::vector<SurfacePart>& parts, const JoinedSurface& joined)
{
  std::vector<double> heights;
  for (const PartItem& source : joined.Sources)
  {
    heights.push_back(parts[std::size_t(source.Part)].Height[std::size_t(source.Item)]);
  }
  return heights;
}

inline BoundedHorizon ToHorizon(const JoinedSurface& joined, const std::vector<double>& heights)
{
  BoundedHorizon horizon;
  horizon.Plane = joined.Vertices;
  horizon.Height = heights;
  horizon.Patch = joined.Patch;
  horizon.Count = joined.Count;
  horizon.Boundary = joined.Boundary;
  return horizon;
}

/// How far points are from a mesh.
struct Fit
{
  double LargestError = 0.0; // of points under or above a triangle, but for those of outlines
  double FarthestOutside = 0.0; // in plan, from an edge of the mesh or of a loop, of the others
  std::size_t Outside = 0;
};

/// Distance in plan to a segment.
inline double DistanceTo(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  const double x = double(b.X) - a.X;
  const double y = double(b.Y) - a.Y;
  const double length = x * x + y * y;
  const double part =
    length > 0.0 ? std::clamp((x * (double(p.X) - a.X) + y * (double(p.Y) - a.Y)) / length, 0.0, 1.0) : 0.0;
  return std::hypot(a.X + part * x - p.X, a.Y + part * y - p.Y);
}

inline Fit Measure(
  const Points& points, const JoinedSurface& joined, const std::vector<double>& heights, const Columns& onOutlines)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> pointAt;
  for (std::size_t n = 0; n < points.Columns.size(); ++n)
  {
    pointAt[{ points.Columns[n].X, points.Columns[n].Y }] = n;
  }
  std::vector<bool> isCovered(points.Columns.size(), false);
  Fit fit;
  for (std::size_t corner = 0; corner < joined.Triangles.size(); corner += 3)
  {
    const PointId* const ids = joined.Triangles.data() + corner;
    const PlanePoint& a = joined.Vertices[std::size_t(ids[0])];
    const PlanePoint& b = joined.Vertices[std::size_t(ids[1])];
    const PlanePoint& c = joined.Vertices[std::size_t(ids[2])];
    const double area = double(ExactPlane::Turn(a, b, c));
    for (std::int32_t y = std::min({ a.Y, b.Y, c.Y }); y <= std::max({ a.Y, b.Y, c.Y }); ++y)
    {
      for (std::int32_t x = std::min({ a.X, b.X, c.X }); x <= std::max({ a.X, b.X, c.X }); ++x)
      {
        const double weightA = double(ExactPlane::Turn(b, c, { x, y }));
        const double weightB = double(ExactPlane::Turn(c, a, { x, y }));
        const double weightC = double(ExactPlane::Turn(a, b, { x, y }));
        const auto found = pointAt.find({ x, y });
        if (weightA >= 0.0 && weightB >= 0.0 && weightC >= 0.0 && found != pointAt.end())
        {
          const double height = (weightA * heights[std::size_t(ids[0])] + weightB * heights[std::size_t(ids[1])] +
                                  weightC * heights[std::size_t(ids[2])]) /
            area;
          const double off = onOutlines.count({ x, y }) ? 0.0 : std::abs(height - points.Height[found->second]);
          fit.LargestError = std::max(fit.LargestError, off);
          isCovered[found->second] = true;
        }
      }
    }
  }
  for (std::size_t n = 0; n < points.Columns.size(); ++n)
  {
    if (!isCovered[n])
    {
      ++fit.Outside;
      double nearest = std::numeric_limits<double>::infinity();
      joined.Boundary.ForEachEdge(
        [&](PointId from, PointId to)
        {
          nearest = std::min(nearest,
            DistanceTo(joined.Vertices[std::size_t(from)], joined.Vertices[std::size_t(to)], points.Columns[n]));
        });
      joined.Boundary.ForEachPoint(
        [&](PointId vertex)
        {
          const PlanePoint& place = joined.Vertices[std::size_t(vertex)];
          nearest = std::min(nearest, DistanceTo(place, place, points.Columns[n]));
        });
      fit.FarthestOutside = std::max(fit.FarthestOutside, nearest);
    }
  }
  return fit;
}

/// What is wrong with a joined mesh; empty when nothing is.
inline std::string Check(const Points& points, const std::vector<SurfacePart>& parts, const JoinedSurface& joined,
  const Columns& onOutlines, double error)
{
  const std::vector<double> heights = HeightsOf(parts, joined);
  const BoundedHorizon horizon = ToHorizon(joined, heights);
  std::string wrong = MeshChecker::CheckMesh(horizon, joined.Triangles, MeshChecker::Kind::Any);
  wrong = wrong.empty() ? BoundaryChecker::CheckCrossings(horizon) : wrong;
  std::int64_t count = joined.DroppedPoints;
  for (const std::int64_t n : joined.Count)
  {
    count += n;
  }
  std::ostringstream text;
  if (wrong.empty() && count != std::int64_t(points.Columns.size()))
  {
    text << "counts of " << count << " for " << points.Columns.size() << " points";
    wrong = text.str();
  }
  const Fit fit = Measure(points, joined, heights, onOutlines);
  if (wrong.empty() && (fit.LargestError > error + 1e-6 || fit.FarthestOutside > error + 1e-6))
  {
    text << "error " << fit.LargestError << ", " << fit.FarthestOutside << " outside";
    wrong = text.str();
  }
  return wrong;
}

/// The mesh as a text.
inline std::string Tell(const std::vector<SurfacePart>& parts, const JoinedSurface& joined)
{
  const std::vector<double> heights = HeightsOf(parts, joined);
  std::ostringstream text;
  text.precision(17);
  for (std::size_t vertex = 0; vertex < heights.size(); ++vertex)
  {
    text << joined.Vertices[vertex].X << ' ' << joined.Vertices[vertex].Y << ' ' << heights[vertex] << ' '
         << joined.Count[vertex] << ' ' << joined.Patch[vertex] << '\n';
  }
  for (const PointId vertex : joined.Triangles)
  {
    text << vertex << ' ';
  }
  for (std::size_t loop = 0; loop < joined.Boundary.Size(); ++loop)
  {
    text << "\nloop";
    std::for_each(
      joined.Boundary.begin(loop), joined.Boundary.end(loop), [&](PointId vertex) { text << ' ' << vertex; });
  }
  return text.str();
}
}

#endif
