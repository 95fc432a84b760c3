// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a mesh is from the points that it was made of, without the code that makes it.

#ifndef SeismicHorizonsSurfaceFit_h
#define SeismicHorizonsSurfaceFit_h

#include "SurfaceInputs.h"
#include "Tools/ExactPlane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace SurfaceFit
{
using namespace SeismicHorizons;
using SurfaceInputs::Points;
using Places = std::map<std::pair<std::int32_t, std::int32_t>, std::size_t>;

inline Places PlacesOf(const Points& points)
{
  Places places;
  for (std::size_t n = 0; n < points.Columns.size(); ++n)
  {
    places[{ points.Columns[n].X, points.Columns[n].Y }] = n;
  }
  return places;
}

struct Fit
{
  double Largest = 0.0; // of points under or above a triangle, but for those of outlines
  double LargestOfEdges = 0.0; // where inner edges cross links between such points
  std::size_t Uncovered = 0; // of points on no outline
};

class Measure
{
public:
  Measure(const Points& points, const Surface& surface)
    : Given(points)
    , Mesh(surface.Mesh)
    , PointAt(PlacesOf(points))
    , IsOnOutline(points.Columns.size(), false)
    , IsCovered(points.Columns.size(), false)
  {
    surface.Boundary.Boundary.ForEachPoint(
      [&](PointId point) { this->IsOnOutline[std::size_t(surface.Kept[std::size_t(point)])] = true; });
  }

  Fit Run()
  {
    std::map<std::pair<PointId, PointId>, int> edges;
    for (std::size_t corner = 0; corner < this->Mesh.Triangles.size(); corner += 3)
    {
      const PointId* const ids = this->Mesh.Triangles.data() + corner;
      this->MeasureTriangle(ids);
      for (int n = 0; n < 3; ++n)
      {
        ++edges[std::minmax(ids[n], ids[(n + 1) % 3])];
      }
    }
    for (const auto& [edge, triangles] : edges)
    {
      if (triangles == 2)
      {
        this->MeasureEdge(std::size_t(edge.first), std::size_t(edge.second));
      }
    }
    for (std::size_t n = 0; n < this->IsCovered.size(); ++n)
    {
      this->Result.Uncovered += this->IsCovered[n] || this->IsOnOutline[n] ? 0 : 1;
    }
    return this->Result;
  }

private:
  void MeasureTriangle(const PointId* ids)
  {
    const auto at = [&](int n) { return this->Mesh.Points.Plane[std::size_t(ids[n])]; };
    const auto heightAt = [&](int n) { return this->Mesh.Points.Height[std::size_t(ids[n])]; };
    const double area = double(ExactPlane::Turn(at(0), at(1), at(2)));
    for (std::int32_t y = std::min({ at(0).Y, at(1).Y, at(2).Y }); y <= std::max({ at(0).Y, at(1).Y, at(2).Y }); ++y)
    {
      for (std::int32_t x = std::min({ at(0).X, at(1).X, at(2).X }); x <= std::max({ at(0).X, at(1).X, at(2).X }); ++x)
      {
        const double a = double(ExactPlane::Turn(at(1), at(2), { x, y }));
        const double b = double(ExactPlane::Turn(at(2), at(0), { x, y }));
        const double c = double(ExactPlane::Turn(at(0), at(1), { x, y }));
        const auto found = this->PointAt.find({ x, y });
        if (a >= 0.0 && b >= 0.0 && c >= 0.0 && found != this->PointAt.end())
        {
          const double height = (a * heightAt(0) + b * heightAt(1) + c * heightAt(2)) / area;
          const double off = std::abs(height - this->Given.Height[found->second]);
          this->IsCovered[found->second] = true;
          this->Result.Largest = std::max(this->Result.Largest, this->IsOnOutline[found->second] ? 0.0 : off);
        }
      }
    }
  }

  void MeasureEdge(std::size_t from, std::size_t to)
  {
    for (const bool isTurned : { false, true })
    {
      const auto place = [&](std::size_t vertex)
      {
        const PlanePoint& own = this->Mesh.Points.Plane[vertex];
        return isTurned ? PlanePoint{ own.Y, own.X } : own;
      };
      const bool isUp = place(from).Y < place(to).Y;
      const std::size_t low = isUp ? from : to;
      const std::size_t high = isUp ? to : from;
      for (std::int32_t row = place(low).Y + 1; row < place(high).Y; ++row)
      {
        const double part = double(row - place(low).Y) / double(place(high).Y - place(low).Y);
        const double x = place(low).X + part * (double(place(high).X) - place(low).X);
        const auto left = std::int32_t(std::floor(x + 1e-9));
        const auto pointAt = [&](std::int32_t column)
        { return this->PointAt.find(isTurned ? std::make_pair(row, column) : std::make_pair(column, row)); };
        const auto first = pointAt(left);
        const auto second = pointAt(left + 1);
        if (x - left < 1e-6 || first == this->PointAt.end() || second == this->PointAt.end() ||
          this->IsOnOutline[first->second] || this->IsOnOutline[second->second])
        {
          continue;
        }
        const double onLink = this->Given.Height[first->second] +
          (x - left) * (this->Given.Height[second->second] - this->Given.Height[first->second]);
        const double onEdge =
          this->Mesh.Points.Height[low] + part * (this->Mesh.Points.Height[high] - this->Mesh.Points.Height[low]);
        this->Result.LargestOfEdges = std::max(this->Result.LargestOfEdges, std::abs(onEdge - onLink));
      }
    }
  }

  const Points& Given;
  const Decimation& Mesh;
  const Places PointAt;
  std::vector<bool> IsOnOutline;
  std::vector<bool> IsCovered;
  Fit Result;
};
}

#endif
