// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "AdvancingFront.h"
#include "CellGrid.h"
#include "Errors.h"
#include "FullBlocks.h"
#include "ThirdPointSearch.h"

#include <algorithm>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// One patch with its own numbers for its points.
struct Patch
{
  std::vector<PointId> Points; // for each of its points the number in the horizon
  std::vector<PlanePoint> Places;
  Loops Boundary;
};

/// Moves the places to the origin and drops the factor of two they share, so that on whole columns numbers are as
/// small as the patch: neither changes any answer.
void Normalise(std::vector<PlanePoint>& places)
{
  PlanePoint least = places.front();
  for (const PlanePoint& place : places)
  {
    least = { std::min(least.X, place.X), std::min(least.Y, place.Y) };
  }
  std::int32_t bits = 0;
  for (PlanePoint& place : places)
  {
    place = { place.X - least.X, place.Y - least.Y };
    bits |= place.X | place.Y;
  }
  int shift = 0;
  while (bits != 0 && ((bits >> shift) & 1) == 0)
  {
    ++shift;
  }
  for (PlanePoint& place : places)
  {
    place = { place.X >> shift, place.Y >> shift };
  }
}

/// Deals points and loops out to their patches.
class PatchList
{
public:
  explicit PatchList(const BoundedHorizon& horizon)
    : Horizon(horizon)
    , Patches(CountPatches(horizon.Patch))
    , Points(this->Patches, [&](auto&& add) { this->ForEachPoint(add); })
    , LoopsOf(this->Patches, [&](auto&& add) { this->ForEachLoop(add); })
    , LocalNumber(horizon.Patch.size(), NoPoint)
  {
  }

  std::int64_t Size() const { return this->Patches; }

  Patch Get(std::int64_t number)
  {
    Patch patch;
    patch.Points.assign(this->Points.begin(number), this->Points.end(number));
    for (const PointId point : patch.Points)
    {
      this->LocalNumber[std::size_t(point)] = PointId(patch.Places.size());
      patch.Places.push_back(this->Horizon.Plane[std::size_t(point)]);
    }
    if (!patch.Places.empty())
    {
      Normalise(patch.Places);
    }
    for (const std::size_t* loop = this->LoopsOf.begin(number); loop != this->LoopsOf.end(number); ++loop)
    {
      this->AddLoop(*loop, std::int32_t(number), patch);
    }
    return patch;
  }

private:
  static std::int64_t CountPatches(const std::vector<std::int32_t>& patches)
  {
    const auto range = std::minmax_element(patches.begin(), patches.end());
    if (*range.first < 0 || std::size_t(*range.second) >= patches.size())
    {
      throw InputError("patch numbers from " + std::to_string(*range.first) + " to " + std::to_string(*range.second) +
        ", expected numbers from 0 that are less than the " + std::to_string(patches.size()) + " points");
    }
    return std::int64_t(*range.second) + 1;
  }

  template <typename Add>
  void ForEachPoint(Add&& add) const
  {
    for (std::size_t point = 0; point < this->Horizon.Patch.size(); ++point)
    {
      add(this->Horizon.Patch[point], PointId(point));
    }
  }

  template <typename Add>
  void ForEachLoop(Add&& add) const
  {
    const Loops& boundary = this->Horizon.Boundary;
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      add(this->Horizon.Patch[std::size_t(*boundary.begin(loop))], loop);
    }
  }

  void AddLoop(std::size_t loop, std::int32_t number, Patch& patch) const
  {
    const Loops& boundary = this->Horizon.Boundary;
    for (const PointId* point = boundary.begin(loop); point != boundary.end(loop); ++point)
    {
      if (this->Horizon.Patch[std::size_t(*point)] != number)
      {
        throw InputError("boundary loop " + std::to_string(loop) + " runs from patch " + std::to_string(number) +
          " to patch " + std::to_string(this->Horizon.Patch[std::size_t(*point)]) + " at point " +
          std::to_string(*point) + ", expected loops that stay in one patch");
      }
      patch.Boundary.Append(this->LocalNumber[std::size_t(*point)]);
    }
    patch.Boundary.Close();
  }

  const BoundedHorizon& Horizon;
  const std::int64_t Patches;
  const PointLists Points;
  const CellLists<std::size_t> LoopsOf;
  std::vector<PointId> LocalNumber; // of the patches that were asked for already
};

class PatchTriangulator
{
public:
  PatchTriangulator(const Patch& patch, std::vector<PointId>& triangles)
    : TriangulatedPatch(patch)
    , Triangles(triangles)
    , Search(patch.Places, patch.Boundary, patch.Points)
    , Front(patch.Places.size())
    , Used(patch.Places.size(), false)
  {
  }

  void Run(const Monitor& monitor)
  {
    this->AddBoundary();
    this->AddFullBlocks();
    monitor.Progress(0.5);
    const std::size_t expected = 2 * this->Used.size();
    const std::size_t begin = this->Triangles.size();
    Hop edge;
    while (this->Front.TakeNewest(edge))
    {
      const std::size_t made = (this->Triangles.size() - begin) / 3;
      if (made % 4096 == 0)
      {
        monitor.Progress(std::min(1.0, 0.5 + 0.5 * double(made) / double(expected)));
      }
      const PointId third = this->Search.Find(edge.From, edge.To);
      // By Euler's formula a plane mesh has less than two triangles per point.
      if (third == NoPoint || made > expected)
      {
        throw InputError("no surface to the left of the edge from point " + this->Name(edge.From) + " to point " +
          this->Name(edge.To) + ", expected closed boundary loops with the surface to their right");
      }
      this->AddTriangle(edge.From, edge.To, third);
    }
    this->CheckAllUsed();
  }

private:
  std::string Name(PointId point) const { return std::to_string(this->TriangulatedPatch.Points[std::size_t(point)]); }

  /// The surface lies to the right of each boundary hop, so its reverse waits for a triangle. Of a hop that the
  /// boundary walks in both directions neither side has surface.
  void AddBoundary()
  {
    this->TriangulatedPatch.Boundary.ForEachHop(
      [this](PointId from, PointId to)
      {
        this->Used[std::size_t(from)] = true;
        this->AddSide(from, to);
      });
    for (std::size_t loop = 0; loop < this->TriangulatedPatch.Boundary.Size(); ++loop)
    {
      this->Used[std::size_t(*this->TriangulatedPatch.Boundary.begin(loop))] = true;
    }
  }

  void AddFullBlocks()
  {
    const FullBlocks blocks(this->TriangulatedPatch.Places, this->TriangulatedPatch.Boundary);
    blocks.Visit([this](PointId a, PointId b, PointId c) { this->AddCorners(a, b, c); },
      [this](PointId from, PointId to) { this->AddSide(from, to); });
  }

  void AddTriangle(PointId a, PointId b, PointId c)
  {
    this->AddCorners(a, b, c);
    this->AddSide(b, c);
    this->AddSide(c, a);
  }

  void AddCorners(PointId a, PointId b, PointId c)
  {
    for (const PointId point : { a, b, c })
    {
      this->Used[std::size_t(point)] = true;
      this->Triangles.push_back(this->TriangulatedPatch.Points[std::size_t(point)]);
    }
  }

  /// A side of a triangle to its left: either it waited for this triangle, or its reverse waits for another one now.
  void AddSide(PointId from, PointId to)
  {
    if (!this->Front.Remove(from, to))
    {
      this->Front.Add(to, from);
    }
  }

  void CheckAllUsed() const
  {
    const auto unused = std::find(this->Used.begin(), this->Used.end(), false);
    if (unused != this->Used.end())
    {
      throw InputError("point " + this->Name(PointId(unused - this->Used.begin())) +
        " lies outside the boundary of its patch, expected all points inside");
    }
  }

  const Patch& TriangulatedPatch;
  std::vector<PointId>& Triangles;
  const ThirdPointSearch Search;
  AdvancingFront Front;
  std::vector<bool> Used;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> Triangulate(const BoundedHorizon& horizon, const Monitor& monitor)
{
  std::vector<PointId> triangles;
  triangles.reserve(6 * horizon.Plane.size());
  PatchList patches(horizon);
  std::size_t pointsDone = 0;
  for (std::int64_t number = 0; number < patches.Size(); ++number)
  {
    const Patch patch = patches.Get(number);
    if (patch.Points.empty())
    {
      continue;
    }
    const double first = double(pointsDone) / double(horizon.Plane.size());
    pointsDone += patch.Points.size();
    const double last = double(pointsDone) / double(horizon.Plane.size());
    PatchTriangulator(patch, triangles).Run(monitor.Step(first, last));
  }
  return triangles;
}
}
