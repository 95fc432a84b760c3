// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeSizes.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// Edges of the lattice are shorter, as those between it and loops are longer.
constexpr double PartOfLongest = 0.75;
// Where edges grow, the next lattice is this much finer.
constexpr double StepOfLattices = 0.7;
// Nearer to loops, points of the lattice would leave flat triangles.
constexpr double PartFromLoops = 0.6;
constexpr double LengthAtLoops = 3.0;
constexpr double AngleOfEvenMeshes = 25.0; // degrees
}

//----------------------------------------------------------------------------------------------------------------------
double SmallestAngleOf(const MeshQuality& options)
{
  return options.EdgeLength > 0.0 ? std::max(options.SmallestAngle, AngleOfEvenMeshes) : options.SmallestAngle;
}

//----------------------------------------------------------------------------------------------------------------------
double LongestAtLoops(const MeshQuality& options)
{
  const double longest = PartOfLongest * options.EdgeLength;
  return options.EdgeGrowth == 0.0 ? longest : std::min(longest, LengthAtLoops);
}

//----------------------------------------------------------------------------------------------------------------------
EdgeSizes::EdgeSizes(const HeightMesh& mesh, double longest, double growth)
  : Mesh(mesh)
  , Longest(longest)
  , Growth(growth)
{
  for (std::size_t patch = 0; patch < mesh.NumberOfPatches(); ++patch)
  {
    Distances& distances = this->Patches.emplace_back();
    distances.Box = mesh.RasterOfPatch(patch).Area();
    distances.Width = std::int64_t(distances.Box.Greatest.X) - distances.Box.Least.X + 1;
    const std::int64_t rows = std::int64_t(distances.Box.Greatest.Y) - distances.Box.Least.Y + 1;
    distances.Values.assign(std::size_t(distances.Width * rows), float(distances.Width + rows));
  }
  this->MarkLoops();
  std::for_each(this->Patches.begin(), this->Patches.end(), &Spread);
}

//----------------------------------------------------------------------------------------------------------------------
double EdgeSizes::At(std::int32_t patch, const PlanePoint& place) const
{
  return this->Growth == 0.0
    ? this->Longest
    : std::min(this->Longest, LengthAtLoops + this->Growth * double(this->Patches[std::size_t(patch)].At(place)));
}

//----------------------------------------------------------------------------------------------------------------------
void EdgeSizes::MarkLoops()
{
  const PlaneMesh& triangles = this->Mesh.Triangles();
  for (TriangleId triangle = 0; triangle < triangles.Size(); ++triangle)
  {
    Distances& distances = this->Patches[std::size_t(this->Mesh.PatchOf(triangles.Corner(triangle, 0)))];
    for (int edge = 0; edge < 3; ++edge)
    {
      if (triangles.Neighbour(triangle, edge) != NoTriangle && !triangles.IsKeptEdge(triangle, edge))
      {
        continue;
      }
      const PlanePoint& from = triangles.Place(triangles.Corner(triangle, edge));
      const PlanePoint& to = triangles.Place(triangles.Corner(triangle, NextCorner(edge)));
      const std::int32_t steps = std::max({ std::abs(to.X - from.X), std::abs(to.Y - from.Y), 1 });
      for (std::int32_t step = 0; step <= steps; ++step)
      {
        const double part = double(step) / steps;
        distances.At(std::llround(from.X + part * (to.X - from.X)), std::llround(from.Y + part * (to.Y - from.Y))) =
          0.0F;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Two passes, from neighbours before and after (Borgefors 1986, "Distance transformations in digital images").
void EdgeSizes::Spread(Distances& distances)
{
  const PlaneBox& box = distances.Box;
  const auto lower = [&](std::int64_t x, std::int64_t y, std::int64_t from, std::int64_t row, float step)
  {
    if (from >= box.Least.X && from <= box.Greatest.X && row >= box.Least.Y && row <= box.Greatest.Y)
    {
      distances.At(x, y) = std::min(distances.At(x, y), distances.At(from, row) + step);
    }
  };
  constexpr float diagonal = 1.41421356F;
  const auto lowerAt = [&](std::int64_t x, std::int64_t y, std::int64_t back)
  {
    lower(x, y, x + back, y, 1.0F);
    lower(x, y, x, y + back, 1.0F);
    lower(x, y, x - 1, y + back, diagonal);
    lower(x, y, x + 1, y + back, diagonal);
  };
  for (std::int64_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
  {
    for (std::int64_t x = box.Least.X; x <= box.Greatest.X; ++x)
    {
      lowerAt(x, y, -1);
    }
  }
  for (std::int64_t y = box.Greatest.Y; y >= box.Least.Y; --y)
  {
    for (std::int64_t x = box.Greatest.X; x >= box.Least.X; --x)
    {
      lowerAt(x, y, 1);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<unsigned char> EdgeSizes::MarkPoints() const
{
  std::vector<unsigned char> marks(this->Mesh.NumberOfAllPoints(), 0);
  for (std::size_t patch = 0; patch < this->Patches.size(); ++patch)
  {
    double spacing = PartOfLongest * this->Longest;
    do
    {
      this->MarkLattice(patch, spacing, marks);
      spacing *= StepOfLattices;
    } while (this->Growth > 0.0 && spacing >= PartOfLongest * LengthAtLoops);
  }
  return marks;
}

//----------------------------------------------------------------------------------------------------------------------
void EdgeSizes::MarkLattice(std::size_t patch, double spacing, std::vector<unsigned char>& marks) const
{
  const Distances& distances = this->Patches[patch];
  const PlaneBox& box = distances.Box;
  const double rise = spacing * std::sqrt(0.75);
  for (std::int64_t row = std::int64_t(std::ceil(box.Least.Y / rise)); row * rise <= box.Greatest.Y; ++row)
  {
    const double shift = row % 2 == 0 ? 0.0 : 0.5;
    for (std::int64_t n = std::int64_t(std::ceil(box.Least.X / spacing - shift));
         (n + shift) * spacing <= box.Greatest.X; ++n)
    {
      const PlanePoint place = { std::int32_t(std::lround((n + shift) * spacing)),
        std::int32_t(std::lround(row * rise)) };
      const PointId point = this->Mesh.RasterOfPatch(patch).PointAt(place);
      const double length = PartOfLongest * (point == NoPoint ? 0.0 : this->At(std::int32_t(patch), place));
      const bool isHere = spacing <= length && (length * StepOfLattices < spacing || this->Growth == 0.0);
      if (isHere && distances.At(place) >= PartFromLoops * spacing)
      {
        marks[std::size_t(point)] = 1;
      }
    }
  }
}
}
