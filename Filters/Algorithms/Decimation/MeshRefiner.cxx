// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshRefiner.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
// To what part of the largest error the limit falls.
constexpr double LimitPart = 0.6;

// How many triangles a thread measures at a time.
constexpr std::int64_t Grain = 64;
}

//----------------------------------------------------------------------------------------------------------------------
MeshRefiner::MeshRefiner(HeightMesh& mesh, std::size_t mostVertices, EdgeFlips* flips, ErrorPower power)
  : Mesh(mesh)
  , MostVertices(mostVertices)
  , Flips(flips)
  , Power(power)
{
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertWhereFar(double error, const Monitor& monitor)
{
  if (this->IsFull())
  {
    return;
  }
  const double bound = error + this->Mesh.Rounding();
  const auto measure = [this](TriangleId triangle) { return this->Mesh.Measure(triangle, this->Power); };
  this->AddAllAsNew();
  this->MeasureNew(monitor.Step(0.0, 0.1), measure);
  const double first = this->FindLargest();
  for (double largest = first; largest > bound && !this->IsFull(); largest = this->FindLargest())
  {
    const double limit = std::max(bound, LimitPart * largest);
    while (!this->IsFull() && this->InsertRound(this->FindAbove(limit)))
    {
      this->MeasureNew(Monitor(), measure);
      // From one limit to the next the number of triangles grows by a factor: by the last rounds most is still to come.
      monitor.Progress(1.0 - 0.9 * limit / first);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertAtSides(double error, const Monitor& monitor)
{
  if (this->IsFull())
  {
    return;
  }
  const auto measure = [this](TriangleId triangle) { return this->Mesh.MeasureWithSides(triangle, this->Power); };
  this->AddAllAsNew();
  this->MeasureNew(monitor, measure);
  while (!this->IsFull() && this->InsertRound(this->FindAbove(error + this->Mesh.Rounding())))
  {
    this->MeasureNew(Monitor(), measure);
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Inserts the worst points of triangles, but for those that an insertion before has changed. False when there is none.
bool MeshRefiner::InsertRound(const std::vector<TriangleId>& triangles)
{
  this->New.clear();
  this->IsNew.assign(std::size_t(this->Mesh.Triangles().Size()) + 2 * triangles.size(), 0);
  for (const TriangleId triangle : triangles)
  {
    const PointId point = this->Mesh.Error(triangle).Point;
    if (this->Mesh.IsVertex(point))
    {
      this->AddNew(triangle); // the point, beside a side, was inserted from another triangle
    }
    else if (this->IsNew[std::size_t(triangle)] == 0 && !this->IsFull())
    {
      this->Insert(point, this->Mesh.Triangles().Locate(point, triangle));
    }
  }
  if (this->Flips)
  {
    this->Flips->RunAround(this->New, Monitor());
    std::sort(this->New.begin(), this->New.end());
    this->New.erase(std::unique(this->New.begin(), this->New.end()), this->New.end());
  }
  return !this->New.empty();
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::Insert(PointId point, TriangleId triangle)
{
  if (triangle == NoTriangle || this->IsNew[std::size_t(triangle)] != 0)
  {
    return;
  }
  PlaneMesh& triangles = this->Mesh.Triangles();
  triangles.Insert(point, triangle, this->Around);
  if (this->Around.empty())
  {
    throw InputError(
      "point " + std::to_string(point) + " lies on the boundary, expected it inside or on a loop's line");
  }
  this->Mesh.MarkVertex(point, true);
  if (!this->Flips)
  {
    triangles.Legalize(this->Around);
  }
  std::for_each(this->Around.begin(), this->Around.end(), [this](TriangleId changedOne) { this->AddNew(changedOne); });
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::AddNew(TriangleId triangle)
{
  if (this->IsNew[std::size_t(triangle)] == 0)
  {
    this->IsNew[std::size_t(triangle)] = 1;
    this->New.push_back(triangle);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::AddAllAsNew()
{
  this->New.resize(std::size_t(this->Mesh.Triangles().Size()));
  std::iota(this->New.begin(), this->New.end(), 0);
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Measure>
void MeshRefiner::MeasureNew(const Monitor& monitor, Measure&& measure)
{
  this->Mesh.ResizeErrors();
  ParallelFor(std::int64_t(this->New.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const TriangleId triangle = this->New[std::size_t(n)];
        this->Mesh.SetError(triangle, measure(triangle));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// The triangles with an error above a limit, from the largest down.
std::vector<TriangleId> MeshRefiner::FindAbove(double limit) const
{
  std::vector<TriangleId> above;
  for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
  {
    if (this->Mesh.Error(triangle).Largest > limit)
    {
      above.push_back(triangle);
    }
  }
  const auto error = [this](TriangleId triangle) { return this->Mesh.Error(triangle).Largest; };
  std::sort(above.begin(), above.end(),
    [&error](TriangleId a, TriangleId b) { return error(a) != error(b) ? error(a) > error(b) : a < b; });
  return above;
}

//----------------------------------------------------------------------------------------------------------------------
double MeshRefiner::FindLargest() const
{
  double largest = 0.0;
  for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
  {
    largest = std::max(largest, this->Mesh.Error(triangle).Largest);
  }
  return largest;
}
}
