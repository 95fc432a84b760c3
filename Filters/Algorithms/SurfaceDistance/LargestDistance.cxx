// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Branch and bound, as in CGAL's bounded-error Hausdorff distance (Tang, Lee and Kim 2009, "Interactive Hausdorff
// distance computation for general polygonal models"). A triangle tries bounds in this order, until one is no more than
// the largest distance found:
//
// - distances of two places differ by at most their own distance;
// - the overlay with triangles above and below (PlanOverlay.h);
// - the distance to a triangle is convex, and largest at a corner: triangles nearest to corners and middle are tried.
//
// Remaining triangles are halved at their longest edge, highest bound first, in rounds: the first rounds settle most of
// the rest.

#include "LargestDistance.h"

#include "Common/Base/FixedChunks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// Bounds may differ by this, relative to the lower bound.
constexpr double Accuracy = 0.01;

// Smaller bounds are rounding, relative to the largest coordinate.
constexpr double DistanceRounding = 8.0 * std::numeric_limits<double>::epsilon();

constexpr std::int64_t TrianglesPerChunk = 1024;
constexpr std::int64_t CutPerChunk = 4;
constexpr std::int64_t FirstRound = 32;
constexpr std::int64_t LargestRound = 8192;

// Triangles are not cut with less effort left.
constexpr double LeastLeft = 0.1;

// Visiting this number of triangles of an overlay takes the time of one distance.
constexpr double VisitsPerDistance = 16.0;

/// An edge has its last corner twice.
struct Piece
{
  Triangle Corner;
  std::array<MetricValues, 3> Distance;
  std::array<NearestTriangles, 3> Nearest;
  MetricValues Bound; // of all places
  MetricValues DistanceRounding; // rounding of the bound
  double Order = 0.0; // highest first
};

struct OpenTriangle
{
  std::int32_t Number;
  std::int32_t Side; // from this corner; -1 for the triangle
  MetricValues Bound;
};

using OpenTriangles = std::vector<OpenTriangle>;

void Raise(const MetricValues& other, MetricValues& values)
{
  std::transform(
    other.begin(), other.end(), values.begin(), values.begin(), [](double a, double b) { return std::max(a, b); });
}

/// Bounds with an excess above 1 must be lowered.
double Excess(const MetricValues& bound, const MetricValues& enough)
{
  double excess = 0.0;
  for (std::size_t metric = 0; metric < bound.size(); ++metric)
  {
    excess = std::max(excess, bound[metric] > 0.0 ? bound[metric] / enough[metric] : 0.0);
  }
  return excess;
}

class Bounder
{
public:
  Bounder(const KnownDistances& known, const MetricValues& found)
    : Known(known)
    , Metrics(known.Metrics)
    , Probe(known.To, known.Metrics)
    , Result{ found, found }
  {
  }

  void Bound(std::int32_t number, OpenTriangles& open)
  {
    const TriangleSurface& from = this->Known.From;
    const Corners& t = from.Triangles[number];
    if (from.Counts(t))
    {
      const NearestTriangles& nearest = this->Known.Nearest[t[0]];
      if (nearest == this->Known.Nearest[t[1]] && nearest == this->Known.Nearest[t[2]])
      {
        return; // the distance to it is largest at a corner
      }
      this->BoundOne({ number, -1, {} }, open);
      return;
    }
    for (std::int32_t side = 0; side < 3; ++side)
    {
      if (from.Counts(t[side]) && from.Counts(t[(side + 1) % 3]))
      {
        this->BoundOne({ number, side, {} }, open);
      }
    }
  }

  /// Halves pieces until bounds are low or `allowed` distances are measured. Returns their number, and lowers the bound
  /// of the triangle.
  double Cut(OpenTriangle& triangle, double allowed)
  {
    this->Spent = 0.0;
    std::vector<Piece> pieces = { this->MakePiece(triangle) };
    pieces[0].Bound = triangle.Bound;
    const auto isLower = [](const Piece& a, const Piece& b) { return a.Order < b.Order; };
    while (!pieces.empty() && this->Spent < allowed)
    {
      std::pop_heap(pieces.begin(), pieces.end(), isLower);
      const Piece piece = pieces.back();
      pieces.pop_back();
      if (this->IsDone(piece))
      {
        continue;
      }
      for (Piece& half : this->Halve(piece))
      {
        if (!this->IsDone(half))
        {
          half.Order = this->Excess(half);
          pieces.push_back(half);
          std::push_heap(pieces.begin(), pieces.end(), isLower);
        }
      }
    }
    triangle.Bound = {};
    for (const Piece& piece : pieces)
    {
      Raise(piece.Bound, triangle.Bound);
    }
    return this->Spent;
  }

  const LargestDistance& Get() const { return this->Result; }

private:
  Piece MakePiece(const OpenTriangle& triangle) const
  {
    const Corners& t = this->Known.From.Triangles[triangle.Number];
    Piece piece;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const std::size_t corner = triangle.Side < 0 ? n : (std::size_t(triangle.Side) + std::min<std::size_t>(n, 1)) % 3;
      const PointId point = t[corner];
      piece.Corner[n] = this->Known.From.Point(point);
      for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
      {
        piece.Distance[n][metric] = (*this->Known.Distance[metric])[point];
      }
      piece.Nearest[n] = this->Known.Nearest[point];
    }
    piece.Bound = {};
    piece.DistanceRounding = {};
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      piece.Bound[metric] = std::numeric_limits<double>::infinity();
      piece.DistanceRounding[metric] = DistanceRounding * this->LargestCoordinate(piece.Corner, metric);
    }
    return piece;
  }

  void BoundOne(OpenTriangle triangle, OpenTriangles& open)
  {
    Piece piece = this->MakePiece(triangle);
    this->Lower(piece);
    if (!this->IsDone(piece))
    {
      triangle.Bound = piece.Bound;
      open.push_back(triangle);
    }
  }

  /// Counts the bound if it is low enough.
  bool IsDone(const Piece& piece)
  {
    const bool isDone = this->Excess(piece) <= 1.0;
    if (isDone)
    {
      Raise(piece.Bound, this->Result.Most);
    }
    return isDone;
  }

  double LargestCoordinate(const Triangle& corners, std::size_t metric) const
  {
    double largest = 0.0;
    for (const Eigen::Vector3d& corner : corners)
    {
      largest = std::max(largest, this->Metrics[metric](corner).cwiseAbs().maxCoeff());
    }
    return largest;
  }

  MetricValues Limits(const Piece& piece, double times) const
  {
    MetricValues limits = {};
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      limits[metric] = std::max(times * this->Result.Found[metric], piece.DistanceRounding[metric]);
    }
    return limits;
  }

  double Excess(const Piece& piece) const
  {
    return SeismicHorizons::Excess(piece.Bound, this->Limits(piece, 1.0 + Accuracy));
  }

  /// Stops at the largest distance found.
  void Lower(Piece& piece)
  {
    this->Spent += 1.0;
    const MetricValues limits = this->Limits(piece, 1.0);
    const auto isOpen = [&](std::size_t metric) { return piece.Bound[metric] > limits[metric]; };
    bool isAnyOpen = false;
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      if (isOpen(metric))
      {
        this->LowerByLength(piece, metric);
        isAnyOpen = isAnyOpen || isOpen(metric);
      }
    }
    if (isAnyOpen && this->Known.Overlay != nullptr)
    {
      this->Spent +=
        double(this->Known.Overlay->Lower(piece.Corner, this->Metrics, limits, piece.Bound)) / VisitsPerDistance;
    }
    isAnyOpen = false;
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      for (std::size_t corner = 0; corner < 3 && isOpen(metric); ++corner)
      {
        this->LowerByTriangle(piece, metric, piece.Nearest[corner][metric]);
      }
      isAnyOpen = isAnyOpen || isOpen(metric);
    }
    if (isAnyOpen && this->Excess(piece) > 1.0)
    {
      this->LowerFromMiddle(piece);
    }
  }

  /// A circle of radius 1/sqrt(3) of the longest edge encloses a triangle, whose places are as near to a corner.
  void LowerByLength(Piece& piece, std::size_t metric) const
  {
    const double distance[3] = { piece.Distance[0][metric], piece.Distance[1][metric], piece.Distance[2][metric] };
    const double largest = std::max({ distance[0], distance[1], distance[2] });
    double& bound = piece.Bound[metric];
    if (piece.Nearest[0][metric] == piece.Nearest[1][metric] && piece.Nearest[0][metric] == piece.Nearest[2][metric])
    {
      bound = std::min(bound, largest);
      return;
    }
    const std::array<double, 3> length = this->Lengths(piece, metric);
    bound = std::min(bound, largest + std::max({ length[0], length[1], length[2] }) / std::sqrt(3.0));
    for (std::size_t n = 0; n < 3; ++n)
    {
      bound = std::min(bound, distance[n] + std::max(length[n], length[(n + 2) % 3]));
    }
  }

  void LowerByTriangle(Piece& piece, std::size_t metric, std::int32_t triangle) const
  {
    const TriangleSurface& surface = this->Known.To.GetSurface();
    double squared = 0.0;
    for (std::size_t n = 0; n < 3; ++n)
    {
      squared =
        std::max(squared, this->Metrics[metric].SquaredDistance(surface, surface.Triangles[triangle], piece.Corner[n]));
    }
    piece.Bound[metric] = std::min(piece.Bound[metric], std::sqrt(squared));
  }

  void LowerFromMiddle(Piece& piece)
  {
    this->Spent += 1.0;
    const MetricValues limits = this->Limits(piece, 1.0);
    const Eigen::Vector3d middle = (piece.Corner[0] + piece.Corner[1] + piece.Corner[2]) / 3.0;
    const MetricValues distance = this->Probe(middle);
    Raise(distance, this->Result.Found);
    for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
    {
      if (piece.Bound[metric] > limits[metric])
      {
        double farthest = 0.0;
        for (const Eigen::Vector3d& corner : piece.Corner)
        {
          farthest = std::max(farthest, this->Metrics[metric].Length(corner - middle));
        }
        piece.Bound[metric] = std::min(piece.Bound[metric], distance[metric] + farthest);
        this->LowerByTriangle(piece, metric, this->Probe.Triangles()[metric]);
      }
    }
  }

  std::array<double, 3> Lengths(const Piece& piece, std::size_t metric) const
  {
    std::array<double, 3> lengths;
    for (std::size_t n = 0; n < 3; ++n)
    {
      lengths[n] = this->Metrics[metric].Length(piece.Corner[(n + 1) % 3] - piece.Corner[n]);
    }
    return lengths;
  }

  /// Cuts the longest edge in the metric whose bound is worst.
  std::array<Piece, 2> Halve(const Piece& piece)
  {
    const MetricValues limits = this->Limits(piece, 1.0);
    const bool isSecond = this->Metrics.size() > 1 && piece.Bound[1] * limits[0] > piece.Bound[0] * limits[1];
    const std::array<double, 3> lengths = this->Lengths(piece, isSecond ? 1 : 0);
    const std::size_t from = std::size_t(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const std::size_t to = (from + 1) % 3;
    const Eigen::Vector3d middle = 0.5 * (piece.Corner[from] + piece.Corner[to]);
    this->Spent += 1.0;
    const MetricValues distance = this->Probe(middle);
    Raise(distance, this->Result.Found);
    const NearestTriangles nearest = this->Probe.Triangles();
    std::array<Piece, 2> halves = { piece, piece };
    for (std::size_t n = 0; n < 2; ++n)
    {
      // An edge has two corners at one end.
      const Eigen::Vector3d& moved = piece.Corner[n == 0 ? to : from];
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        if (piece.Corner[corner] == moved)
        {
          halves[n].Corner[corner] = middle;
          halves[n].Distance[corner] = distance;
          halves[n].Nearest[corner] = nearest;
        }
      }
      this->Lower(halves[n]);
    }
    return halves;
  }

  const KnownDistances& Known;
  const std::vector<Metric>& Metrics;
  DistanceProbe Probe;
  LargestDistance Result; // Most is of finished triangles and pieces
  double Spent = 0.0;
};

void Raise(const LargestDistance& other, LargestDistance& largest)
{
  Raise(other.Found, largest.Found);
  Raise(other.Most, largest.Most);
}

OpenTriangles BoundAll(const KnownDistances& known, LargestDistance& largest, const Monitor& monitor)
{
  const std::int64_t size = std::int64_t(known.From.Triangles.size());
  std::vector<OpenTriangles> open(CountChunks(size, TrianglesPerChunk));
  std::vector<LargestDistance> parts(open.size());
  ForEachChunk(size, TrianglesPerChunk, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      Bounder bounder(known, known.Found);
      for (std::int64_t n = first; n < last; ++n)
      {
        bounder.Bound(std::int32_t(n), open[chunk]);
      }
      parts[chunk] = bounder.Get();
    });
  OpenTriangles all;
  for (std::size_t chunk = 0; chunk < open.size(); ++chunk)
  {
    all.insert(all.end(), open[chunk].begin(), open[chunk].end());
    Raise(parts[chunk], largest);
  }
  return all;
}

double CutRound(
  const KnownDistances& known, OpenTriangle* triangles, std::int64_t size, double allowed, LargestDistance& largest)
{
  std::vector<LargestDistance> parts(CountChunks(size, CutPerChunk));
  std::vector<double> spent(parts.size(), 0.0);
  const MetricValues found = largest.Found;
  ForEachChunk(size, CutPerChunk, Monitor(),
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      Bounder bounder(known, found);
      for (std::int64_t n = first; n < last; ++n)
      {
        spent[chunk] += bounder.Cut(triangles[n], allowed);
      }
      parts[chunk] = bounder.Get();
    });
  for (const LargestDistance& part : parts)
  {
    Raise(part, largest);
  }
  return std::accumulate(spent.begin(), spent.end(), 0.0);
}

/// Highest bounds come first. Keeps triangles with high bounds, and returns the number of measured distances.
double CutAll(
  const KnownDistances& known, OpenTriangles& open, double allowed, LargestDistance& largest, const Monitor& monitor)
{
  const auto excess = [&](const OpenTriangle& triangle) { return Excess(triangle.Bound, largest.Found); };
  std::stable_sort(
    open.begin(), open.end(), [&](const OpenTriangle& a, const OpenTriangle& b) { return excess(a) > excess(b); });
  const std::int64_t size = std::int64_t(open.size());
  double left = allowed;
  std::int64_t round = FirstRound;
  for (std::int64_t first = 0; first < size; first += round, round = std::min(2 * round, LargestRound))
  {
    monitor.Progress(double(first) / double(size));
    // Half of the rest keeps the highest bounds from using all.
    const std::int64_t count = std::min(round, size - first);
    const double share = first + count < size ? 0.5 * left : left;
    left -= CutRound(known, &open[first], count, share / double(count), largest);
  }
  const auto isDone = [&](const OpenTriangle& triangle) { return triangle.Bound == MetricValues(); };
  open.erase(std::remove_if(open.begin(), open.end(), isDone), open.end());
  return allowed - left;
}
}

//----------------------------------------------------------------------------------------------------------------------
LargestDistance FindLargestDistance(const KnownDistances& known, std::int64_t effort, const Monitor& monitor)
{
  LargestDistance largest{ known.Found, known.Found };
  OpenTriangles open = BoundAll(known, largest, monitor.Step(0.0, 0.5));
  double left = double(effort);
  for (double part = 0.5; !open.empty() && left > LeastLeft * double(effort); part *= 0.5)
  {
    left -= CutAll(known, open, left, largest, monitor.Step(1.0 - part, 1.0 - 0.5 * part));
  }
  for (const OpenTriangle& triangle : open)
  {
    Raise(triangle.Bound, largest.Most);
  }
  Raise(largest.Found, largest.Most);
  return largest;
}
}
