// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshRefiner.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "RoundInsertion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// A round refines triangles above this fraction of the largest error; sums of squares take its square.
constexpr double FractionOfLargest = 0.6;
constexpr double FractionOfSum = FractionOfLargest * FractionOfLargest;

// A place may see fixed edges under 90 degrees (Ruppert 1995, "A Delaunay refinement algorithm for quality 2-dimensional
// mesh generation"); those of even meshes, which are short, under 130.
constexpr double CosineOfEven = -0.642787609686539;

// Where the boundary is in the way, places beside slivers below this angle (degrees) are tried down to this part of their
// distance; for others this would add more triangles than it mends.
constexpr double AngleOfMoreTries = 2.0;
constexpr double LeastPart = 1.0 / 16;

constexpr std::int64_t ErrorsPerChunk = 4096;
}

//----------------------------------------------------------------------------------------------------------------------
MeshRefiner::MeshRefiner(HeightMesh& mesh, std::size_t mostVertices, DecimationPriority priority)
  : Mesh(mesh)
  , MostVertices(mostVertices)
  , Priority(priority)
{
  if (priority == DecimationPriority::SumOfSquares)
  {
    this->Squares = { true, mesh.HeightRange() };
  }
}

//----------------------------------------------------------------------------------------------------------------------
MeshRefiner::MeshRefiner(HeightMesh& mesh, std::vector<TriangleId> examined)
  : MeshRefiner(mesh, 0, DecimationPriority::LargestError)
{
  this->AreAllExamined = false;
  this->Seen = std::move(examined);
}

//----------------------------------------------------------------------------------------------------------------------
const std::vector<TriangleId>& MeshRefiner::Examined()
{
  if (this->AreAllExamined)
  {
    this->Seen = this->Mesh.AllTriangles();
    return this->Seen;
  }
  std::sort(this->Seen.begin(), this->Seen.end());
  this->Seen.erase(std::unique(this->Seen.begin(), this->Seen.end()), this->Seen.end());
  return this->Seen;
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertWhereFar(double error, const Monitor& monitor)
{
  const double bound = error + this->Mesh.Rounding();
  this->Mesh.Measure(this->Examined(), this->Squares, bound, monitor.Step(0.0, 0.1));
  this->StartWith(bound);
  double first = 0.0;
  double fraction = 0.1;
  double limit = std::numeric_limits<double>::infinity();
  for (std::vector<TriangleId> urgent; !this->IsFull() && this->FindUrgent(limit, urgent);)
  {
    // Triangles multiply as the error falls, so the last rounds take longest.
    first = std::max(first, this->Mesh.Error(urgent.front()).Largest);
    fraction = std::max(fraction, 1.0 - 0.9 * this->Mesh.Error(urgent.front()).Largest / first);
    monitor.Progress(fraction);
    this->Mesh.FindPoints(urgent, bound);
    if (!this->InsertRound(urgent, true))
    {
      throw InputError("point " + std::to_string(this->Mesh.Error(urgent.front()).Point) +
        " in several triangles, expected loops that enclose it once");
    }
    this->SortNew();
    this->Mesh.Measure(this->New, this->Squares, bound, Monitor());
    this->KeepFar(bound);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertAtEdges(double error, double crossingError, const Monitor& monitor)
{
  if (crossingError == std::numeric_limits<double>::infinity())
  {
    return;
  }
  const double bound = error + this->Mesh.Rounding();
  const double boundOfEdges = crossingError + this->Mesh.Rounding();
  this->Mesh.MeasureEdges(this->Examined(), boundOfEdges, this->AreAllExamined, monitor.Step(0.0, 0.8));
  this->StartWith(0.0); // only errors above their bounds are stored
  double limit = 0.0;
  for (std::vector<TriangleId> far; !this->IsFull() && this->FindUrgent(limit, far);)
  {
    monitor.Progress(0.8);
    this->Mesh.FindPoints(far, bound);
    this->InsertRound(far, false);
    if (this->New.empty()) // all points lie beyond the boundary
    {
      std::for_each(
        far.begin(), far.end(), [this](TriangleId triangle) { this->Mesh.SetError(triangle, HeightError()); });
    }
    this->Mesh.Measure(this->New, ErrorSquares(), bound, Monitor());
    this->Mesh.MeasureEdges(this->New, boundOfEdges, false, Monitor());
    this->KeepFar(0.0);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertAtSlivers(double smallestAngle, const EdgeSizes* sizes)
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  const double sine = SineOfDegrees(smallestAngle);
  std::vector<TriangleId> slivers = this->Examined();
  while (!slivers.empty())
  {
    this->New.clear();
    this->IsNew.assign(std::size_t(mesh.Size()) + 2 * slivers.size(), 0);
    std::vector<TriangleId> left;
    for (const TriangleId sliver : slivers)
    {
      if (this->IsNew[sliver] != 0 || (mesh.SineOf(sliver) >= sine && !(sizes && this->IsTooLong(sliver, *sizes))))
      {
        continue;
      }
      bool isDone = false;
      const bool hasMoreTries = sizes || mesh.SineOf(sliver) < SineOfDegrees(AngleOfMoreTries);
      for (double part = 1.0; part >= (hasMoreTries ? LeastPart : 1.0) && !isDone; part *= 0.5)
      {
        const PlanePoint place = this->PlaceBeside(sliver, smallestAngle, part);
        const TriangleId triangle = mesh.Locate(place, sliver);
        if (triangle != NoTriangle && this->IsNew[triangle] != 0)
        {
          left.push_back(sliver);
          isDone = true;
        }
        else if (triangle != NoTriangle && this->CanInsert(place, triangle, sizes ? CosineOfEven : 0.0))
        {
          this->Insert(this->Mesh.RasterOf(triangle).PointAt(place), triangle, this->Mesh.AddRoom(1));
          isDone = true;
        }
      }
    }
    this->SeeNew();
    slivers = this->New;
    std::copy_if(left.begin(), left.end(), std::back_inserter(slivers),
      [this](TriangleId triangle) { return this->IsNew[triangle] == 0; });
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Takes the column nearest to the circumcentre or, if nearer, to the place that sees the shortest edge under the
// smallest angle (Ungor 2004, "Off-centers").
PlanePoint MeshRefiner::PlaceBeside(TriangleId sliver, double smallestAngle, double part) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  const auto place = [&](int corner) { return mesh.Place(mesh.Corner(sliver, corner)); };
  const auto length = [&](int edge) { return SquaredDistance(place(edge), place(NextCorner(edge))); };
  int shortest = length(1) < length(0) ? 1 : 0;
  shortest = length(2) < length(shortest) ? 2 : shortest;
  const PlanePoint a = place(shortest);
  const PlanePoint b = place(NextCorner(shortest));
  const PlanePoint c = place(PreviousCorner(shortest));
  // Distances from the middle of the edge are in lengths of the edge.
  const double ofCentre = 0.5 * double(ScalarProduct(c, a, b)) / double(SignedArea(a, b, c));
  const double ofAngle = 0.5 / std::tan(0.5 * smallestAngle * std::atan(1.0) / 45.0);
  const double across = part * std::min(ofCentre, ofAngle);
  const double dx = double(b.X) - a.X;
  const double dy = double(b.Y) - a.Y;
  constexpr double farthest = 1 << 30; // beyond all columns
  const auto round = [&](double value) { return std::int32_t(std::clamp(std::round(value), -farthest, farthest)); };
  return { round(0.5 * (double(a.X) + b.X) - across * dy), round(0.5 * (double(a.Y) + b.Y) + across * dx) };
}

//----------------------------------------------------------------------------------------------------------------------
// Edges that cannot be parted do not count.
bool MeshRefiner::IsTooLong(TriangleId triangle, const EdgeSizes& sizes) const
{
  const PlaneMesh& mesh = this->Mesh.Triangles();
  double longest = 0.0;
  for (int edge = 0; edge < 3; ++edge)
  {
    if (mesh.Neighbour(triangle, edge) != NoTriangle && !mesh.IsKeptEdge(triangle, edge))
    {
      longest = std::max(longest,
        double(SquaredDistance(
          mesh.Place(mesh.Corner(triangle, edge)), mesh.Place(mesh.Corner(triangle, NextCorner(edge))))));
    }
  }
  const PlanePoint& a = mesh.Place(mesh.Corner(triangle, 0));
  const PlanePoint& b = mesh.Place(mesh.Corner(triangle, 1));
  const PlanePoint& c = mesh.Place(mesh.Corner(triangle, 2));
  const double most =
    sizes.At(this->Mesh.PatchOf(mesh.Corner(triangle, 0)), { (a.X + b.X + c.X) / 3, (a.Y + b.Y + c.Y) / 3 });
  return longest > most * most;
}

//----------------------------------------------------------------------------------------------------------------------
// Refuses a place that sees a fixed edge under a large angle.
bool MeshRefiner::CanInsert(const PlanePoint& place, TriangleId triangle, double leastCosine) const
{
  const PointId point = this->Mesh.RasterOf(triangle).PointAt(place);
  if (point == NoPoint || this->Mesh.IsVertex(point))
  {
    return false;
  }
  const PlaneMesh& mesh = this->Mesh.Triangles();
  const auto corner = [&](TriangleId one, int n) { return mesh.Place(mesh.Corner(one, n)); };
  std::vector<TriangleId> inCircle = { triangle };
  for (std::size_t n = 0; n < inCircle.size(); ++n)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      const TriangleId other = mesh.Neighbour(inCircle[n], edge);
      if (other == NoTriangle || mesh.IsKeptEdge(inCircle[n], edge))
      {
        const PlanePoint& from = corner(inCircle[n], edge);
        const PlanePoint& to = corner(inCircle[n], NextCorner(edge));
        const double lengths = std::sqrt(double(SquaredDistance(place, from)) * double(SquaredDistance(place, to)));
        if (double(ScalarProduct(place, from, to)) <= leastCosine * lengths)
        {
          return false;
        }
      }
      else if (std::find(inCircle.begin(), inCircle.end(), other) == inCircle.end() &&
        InCircle(corner(other, 0), corner(other, 1), corner(other, 2), place) > 0)
      {
        inCircle.push_back(other);
      }
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertMarked(const std::vector<unsigned char>& marks)
{
  assert(marks.size() == this->Mesh.NumberOfAllPoints() && this->MostVertices == 0);
  constexpr double Bound = 0.5;
  this->Mesh.MeasureMarked(this->Mesh.AllTriangles(), marks);
  this->StartWith(Bound);
  double limit = Bound;
  for (std::vector<TriangleId> marked; this->FindUrgent(limit, marked);)
  {
    this->InsertRound(marked, true);
    this->Mesh.MeasureMarked(this->New, marks);
    this->KeepFar(Bound);
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The order of points, row by row, saves a fifth of the time of measuring large horizons.
void MeshRefiner::SortNew()
{
  const auto place = [this](TriangleId triangle)
  { return std::make_pair(this->Mesh.SourceOf(this->Mesh.Triangles().Corner(triangle, 2)), triangle); };
  ParallelSort(this->New, [&place](TriangleId a, TriangleId b) { return place(a) < place(b); });
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::StartWith(double bound)
{
  this->New.clear();
  this->Far = this->Mesh.AllTriangles();
  this->IsNew.assign(this->Far.size(), 0);
  this->KeepFar(bound);
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::KeepFar(double bound)
{
  const auto before = std::int64_t(this->Far.size());
  this->Far = CollectChunks<TriangleId>(before + std::int64_t(this->New.size()), ErrorsPerChunk, Monitor(),
    [&](std::vector<TriangleId>& far, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const TriangleId triangle = n < before ? this->Far[n] : this->New[n - before];
        const bool isKept = n >= before || this->IsNew[triangle] == 0;
        if (isKept && this->Mesh.Error(triangle).Largest > bound)
        {
          far.push_back(triangle);
        }
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// If no triangle reaches the limit, it falls. Returns false if none is above the bound.
bool MeshRefiner::FindUrgent(double& limit, std::vector<TriangleId>& urgent) const
{
  struct Most
  {
    double Urgency = 0.0;

    void Add(const Most& other) { this->Urgency = std::max(this->Urgency, other.Urgency); }
  };
  const auto size = std::int64_t(this->Far.size());
  const double most = AddUpChunks<Most>(size, ErrorsPerChunk, Monitor(),
    [this](Most& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        part.Add({ this->UrgencyOf(this->Far[n]) });
      }
    }).Urgency;
  if (most < limit)
  {
    limit = most * (this->Priority == DecimationPriority::LargestError ? FractionOfLargest : FractionOfSum);
  }
  urgent = CollectChunks<TriangleId>(size, ErrorsPerChunk, Monitor(),
    [&](std::vector<TriangleId>& found, std::int64_t first, std::int64_t last)
    {
      std::copy_if(this->Far.begin() + first, this->Far.begin() + last, std::back_inserter(found),
        [&](TriangleId triangle) { return this->UrgencyOf(triangle) >= limit; });
    });
  ParallelSort(urgent,
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
// A round fills at most half of the vertices left, as new errors can be more urgent than its last.
bool MeshRefiner::InsertRound(const std::vector<TriangleId>& triangles, bool arePointsInside)
{
  bool isAnyPutBack = false;
  const std::size_t before = this->Mesh.NumberOfVertices();
  const std::size_t most =
    this->MostVertices > 0 ? (this->MostVertices - before + 1) / 2 : std::numeric_limits<std::size_t>::max();
  const bool areBySquares = arePointsInside && triangles.size() >= RoundInsertion::LeastPoints &&
    this->MostVertices == 0 && !this->Mesh.Triangles().HasKept();
  const PlaneMesh::Room room = this->Mesh.AddRoom(areBySquares ? triangles.size() : 0);
  this->New.clear();
  this->IsNew.assign(std::size_t(this->Mesh.Triangles().Size()) + (areBySquares ? 0 : 2 * triangles.size()), 0);
  std::vector<std::size_t> waiting;
  if (areBySquares)
  {
    RoundInsertion insertion(this->Mesh, triangles, room, this->IsNew);
    waiting = insertion.Run(this->New);
    isAnyPutBack = insertion.IsAnyPutBack();
  }
  else
  {
    waiting.resize(triangles.size());
    std::iota(waiting.begin(), waiting.end(), std::size_t(0));
  }
  std::size_t inserted = 0;
  for (const std::size_t n : waiting)
  {
    const TriangleId triangle = triangles[n];
    const PointId point = this->Mesh.Error(triangle).Point;
    const VertexId corner = this->Mesh.CornerOf(triangle, point);
    if (corner != NoVertex)
    {
      this->PutBack(corner, triangle);
      isAnyPutBack = true;
    }
    else if (this->Mesh.IsVertex(point))
    {
      this->AddNew(triangle); // inserted from another triangle
    }
    else if (this->IsNew[triangle] == 0 && inserted < most)
    {
      this->Before.push_back(this->Mesh.Error(triangle).Largest);
      const TriangleId in = this->Mesh.Triangles().Locate(this->Mesh.Column(point), triangle);
      if (in != NoTriangle && this->IsNew[in] == 0)
      {
        this->Insert(point, in, areBySquares ? room.At(n) : this->Mesh.AddRoom(1));
        ++inserted;
      }
    }
  }
  if (areBySquares)
  {
    this->Mesh.CloseGaps(room, this->New, this->IsNew);
  }
  this->SeeNew();
  return isAnyPutBack || this->Mesh.NumberOfVertices() > before;
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::Insert(PointId point, TriangleId triangle, const PlaneMesh::Room& room)
{
  this->Mesh.Insert(point, triangle, room, this->Around);
  if (this->Around.empty())
  {
    throw InputError(
      "point " + std::to_string(point) + " lies on the boundary, expected it inside or on a loop's line");
  }
  std::for_each(this->Around.begin(), this->Around.end(), [this](TriangleId changedOne) { this->AddNew(changedOne); });
}

//----------------------------------------------------------------------------------------------------------------------
// A vertex that is too far from its column cannot be inserted again.
void MeshRefiner::PutBack(VertexId vertex, TriangleId triangle)
{
  this->Mesh.PutBack(vertex);
  this->Mesh.Triangles().FindRing(vertex, triangle, this->Around);
  std::for_each(this->Around.begin(), this->Around.end(), [this](TriangleId around) { this->AddNew(around); });
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::AddNew(TriangleId triangle)
{
  if (this->IsNew[triangle] == 0)
  {
    this->IsNew[triangle] = 1;
    this->New.push_back(triangle);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::SeeNew()
{
  if (!this->AreAllExamined)
  {
    this->Seen.insert(this->Seen.end(), this->New.begin(), this->New.end());
  }
}
}
