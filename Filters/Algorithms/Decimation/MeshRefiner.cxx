// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshRefiner.h"

#include <algorithm>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
// Of the largest error, what part is still inserted in the same rounds; and of sums of squares.
constexpr double PartOfLargest = 0.6;
constexpr double PartOfSum = PartOfLargest * PartOfLargest;
}

//----------------------------------------------------------------------------------------------------------------------
MeshRefiner::MeshRefiner(HeightMesh& mesh, std::size_t mostVertices, DecimationPriority priority)
  : Mesh(mesh)
  , MostVertices(mostVertices)
  , Priority(priority)
{
  if (priority == DecimationPriority::SumOfSquares)
  {
    this->Power = { 2, mesh.HeightRange() };
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertWhereFar(double error, const Monitor& monitor)
{
  this->Mesh.MeasureAll(this->Power, monitor.Step(0.0, 0.1));
  const double bound = error + this->Mesh.Rounding();
  const double first = this->Mesh.LargestError();
  double part = 0.1;
  double limit = std::numeric_limits<double>::infinity();
  for (std::vector<TriangleId> urgent; !this->IsFull() && this->FindUrgent(bound, limit, urgent);)
  {
    // While the error falls, the number of triangles grows by factors: by the last rounds most is still to come.
    part = std::max(part, 1.0 - 0.9 * this->Mesh.Error(urgent.front()).Largest / first);
    monitor.Progress(part);
    this->InsertRound(urgent);
    this->SortNew();
    this->Mesh.Measure(this->New, this->Power, Monitor());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertAtSides(double error, const Monitor& monitor)
{
  this->Mesh.MeasureAllWithSides(monitor.Step(0.0, 0.8));
  const double bound = error + this->Mesh.Rounding();
  double limit = 0.0;
  for (std::vector<TriangleId> far; !this->IsFull() && this->FindUrgent(bound, limit, far);)
  {
    monitor.Progress(0.8);
    this->InsertRound(far);
    this->Mesh.MeasureWithSides(this->New, Monitor());
  }
}

//----------------------------------------------------------------------------------------------------------------------
// By the points that made them, which come row by row: what is measured next is near then, for large horizons a fifth
// of the time.
void MeshRefiner::SortNew()
{
  const auto point = [this](TriangleId triangle) { return this->Mesh.Triangles().Corner(triangle, 2); };
  std::sort(this->New.begin(), this->New.end(), [&point](TriangleId a, TriangleId b) { return point(a) < point(b); });
}

//----------------------------------------------------------------------------------------------------------------------
// The triangles with an error above a bound whose urgency is not below a limit, the most urgent ones first. When there
// is none, the limit falls; false when no error is above the bound.
bool MeshRefiner::FindUrgent(double bound, double& limit, std::vector<TriangleId>& urgent) const
{
  urgent.clear();
  double most = -1.0;
  const auto add = [&]()
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
    {
      if (this->Mesh.Error(triangle).Largest > bound)
      {
        most = std::max(most, this->UrgencyOf(triangle));
        if (this->UrgencyOf(triangle) >= limit)
        {
          urgent.push_back(triangle);
        }
      }
    }
  };
  add();
  if (urgent.empty() && most >= 0.0)
  {
    limit = most * (this->Priority == DecimationPriority::LargestError ? PartOfLargest : PartOfSum);
    add();
  }
  std::sort(urgent.begin(), urgent.end(),
    [this](TriangleId a, TriangleId b)
    {
      const double one = this->UrgencyOf(a);
      const double other = this->UrgencyOf(b);
      return one != other ? one > other : a < b;
    });
  return !urgent.empty();
}

//----------------------------------------------------------------------------------------------------------------------
double MeshRefiner::UrgencyOf(TriangleId triangle) const
{
  const HeightError& error = this->Mesh.Error(triangle);
  return this->Priority == DecimationPriority::LargestError ? error.Largest : error.Sum;
}

//----------------------------------------------------------------------------------------------------------------------
// Inserts the worst points of triangles, but for those that an insertion before has changed. Of as many as there may
// still be half at most: what an insertion brings about can be more urgent than the last ones of a round.
void MeshRefiner::InsertRound(const std::vector<TriangleId>& triangles)
{
  const std::size_t room =
    this->MostVertices > 0 ? this->MostVertices - this->Mesh.NumberOfVertices() : triangles.size();
  const std::size_t most = this->Mesh.NumberOfVertices() + (this->MostVertices > 0 ? (room + 1) / 2 : room);
  this->New.clear();
  this->IsNew.assign(std::size_t(this->Mesh.Triangles().Size()) + 2 * triangles.size(), 0);
  for (const TriangleId triangle : triangles)
  {
    const PointId point = this->Mesh.Error(triangle).Point;
    if (this->Mesh.IsVertex(point))
    {
      this->AddNew(triangle); // the point, beside a side, was inserted from another triangle
    }
    else if (this->IsNew[std::size_t(triangle)] == 0 && this->Mesh.NumberOfVertices() < most)
    {
      this->Insert(point, this->Mesh.Triangles().Locate(point, triangle));
    }
  }
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
  triangles.Legalize(this->Around);
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
}
