// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A raster measures a place in steps, each only if needed:
//
// 1. The triangle above or below is kept as a Facet. If the ball that touches its plane is within the triangle in plan,
// and nothing overlaps it, it is nearest.
// 2. The distance to it, or to the last nearest triangle, is a bound.
// 3. The raster is searched within the bound.
//
// A tree is searched from the last nearest triangle.

#include "DistanceProbe.h"

#include "Common/Base/Parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
// These are squares: the width of needles, and rounding at their ends, relative to their length.
constexpr double LeastWidth = 1e-12;
constexpr double RoundingAtEnds = 1e-17;
}

//----------------------------------------------------------------------------------------------------------------------
TriangleSearch::TriangleSearch(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
  , Raster(std::make_unique<TriangleRaster>(surface, monitor.Step(0.0, 0.5)))
{
  if (!this->Raster->IsWorthwhile())
  {
    this->Raster.reset();
    this->Tree = std::make_unique<TriangleTree>(surface, monitor.Step(0.5, 1.0));
  }
}

// ---- Facet ----------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
void Facet::Set(const TriangleRaster& raster, std::int32_t number, const std::vector<Metric>& metrics)
{
  const TriangleSurface& surface = raster.GetSurface();
  const Corners& t = surface.Triangles[number];
  this->Number = number;
  this->IsAlone = raster.IsAlone(number);
  this->Slack = raster.Slack();
  this->Corner = { surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]) };
  const Eigen::Vector3d sides[3] = { this->Corner[2] - this->Corner[1], this->Corner[0] - this->Corner[2],
    this->Corner[1] - this->Corner[0] };
  this->Turn = sides[0].x() * sides[1].y() - sides[0].y() * sides[1].x() < 0.0 ? -1.0 : 1.0;
  for (std::size_t metric = 0; metric < metrics.size(); ++metric)
  {
    this->SetPlane(metrics[metric], sides, this->Planes[metric]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void Facet::SetPlane(const Metric& metric, const Eigen::Vector3d (&sides)[3], Plane& plane) const
{
  const Eigen::Vector3d mapped[3] = { metric(sides[0]), metric(sides[1]), metric(sides[2]) };
  const Eigen::Vector3d normal = mapped[0].cross(mapped[1]);
  const double longest = std::max(std::max(mapped[0].squaredNorm(), mapped[1].squaredNorm()), mapped[2].squaredNorm());
  plane.Normal = metric.Transposed(normal);
  plane.SquaredNormal = normal.squaredNorm();
  for (std::size_t side = 0; side < 3; ++side)
  {
    plane.SquaredSides[side] = mapped[side].head<2>().squaredNorm();
  }
  plane.Shrinkage = metric.SquaredPlanShrinkage();
  plane.SquaredSlack = MuchMore * this->Slack * this->Slack * metric.SquaredPlanNorm();
  plane.IsWide = plane.SquaredNormal > SquaredWidthOfNeedle * longest * longest;
  // Rounding tilts the plane of a needle; at its ends, the error must be less than the slack.
  const bool isRightAtEnds =
    plane.SquaredNormal > LeastWidth * longest * longest && RoundingAtEnds * longest <= plane.SquaredSlack;
  plane.IsSure = this->IsAlone && (plane.IsWide || isRightAtEnds);
}

//----------------------------------------------------------------------------------------------------------------------
double Facet::Height() const
{
  return (this->Areas[0] * this->Corner[0].z() + this->Areas[1] * this->Corner[1].z() +
           this->Areas[2] * this->Corner[2].z()) /
    (this->Areas[0] + this->Areas[1] + this->Areas[2]);
}

//----------------------------------------------------------------------------------------------------------------------
bool Facet::IsOnlyOne(double distance) const
{
  const double squared = (distance + this->Slack) * (distance + this->Slack);
  const auto isFar = [&](std::size_t n)
  {
    const auto side = (this->Corner[(n + 1) % 3] - this->Corner[(n + 2) % 3]).head<2>();
    return this->Areas[n] * this->Areas[n] > squared * side.squaredNorm();
  };
  return this->IsAlone && isFar(0) && isFar(1) && isFar(2);
}

// ---- Probe ----------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
DistanceProbe::DistanceProbe(const TriangleSearch& to, const std::vector<Metric>& metrics)
  : To(to)
  , Metrics(metrics)
{
  assert(metrics.size() >= 1 && metrics.size() <= MostMetrics);
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t DistanceProbe::FindAcross(const TriangleRaster& raster, const Eigen::Vector3d& place)
{
  this->IsAcross = this->Across.Contains(place);
  if (this->IsAcross)
  {
    return this->Across.GetNumber();
  }
  const std::int32_t across = raster.FindAcross(place);
  if (across >= 0 && across != this->Across.GetNumber())
  {
    this->Across.Set(raster, across, this->Metrics);
    this->IsAcross = this->Across.Contains(place);
  }
  return across;
}

//----------------------------------------------------------------------------------------------------------------------
double DistanceProbe::MeasureByRaster(
  const TriangleRaster& raster, const Eigen::Vector3d& place, std::int32_t across, std::size_t metric)
{
  std::int32_t& nearest = this->Nearest[metric];
  nearest = across >= 0 ? across : nearest;
  double squared = 0.0;
  const bool isFound = this->IsAcross && this->Across.IsNearest(metric, place, squared);
  if (!isFound || !this->Across.IsWide(metric))
  {
    const TriangleSurface& surface = raster.GetSurface();
    squared = this->Metrics[metric].SquaredDistance(surface, surface.Triangles[nearest], place);
  }
  if (!isFound)
  {
    raster.Search(place, this->Metrics[metric], nearest, squared);
  }
  return squared;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename IsWanted>
void DistanceProbe::Measure(const Eigen::Vector3d& place, IsWanted&& isWanted)
{
  const TriangleRaster* const raster = this->To.GetRaster();
  const std::int32_t across = raster != nullptr ? this->FindAcross(*raster, place) : -1;
  for (std::size_t metric = 0; metric < this->Metrics.size(); ++metric)
  {
    if (isWanted(metric))
    {
      const double squared = raster != nullptr
        ? this->MeasureByRaster(*raster, place, across, metric)
        : this->To.GetTree().SquaredDistance(place, this->Nearest[metric], this->Metrics[metric]);
      this->Found[metric] = std::sqrt(squared);
      this->Largest[metric] = std::max(this->Largest[metric], this->Found[metric]);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
const MetricValues& DistanceProbe::operator()(const Eigen::Vector3d& place)
{
  this->Measure(place, [](std::size_t) { return true; });
  return this->Found;
}

//----------------------------------------------------------------------------------------------------------------------
void DistanceProbe::RaiseLargest(const Eigen::Vector3d& place)
{
  // The nearest place is no farther than the place above or below.
  double gap = std::numeric_limits<double>::quiet_NaN();
  this->Measure(place,
    [&](std::size_t metric)
    {
      gap = this->IsAcross && std::isnan(gap) ? std::abs(this->Across.Height() - place.z()) : gap;
      return !(gap * this->Metrics[metric].Weights()[2] <= this->Largest[metric]);
    });
}

//----------------------------------------------------------------------------------------------------------------------
double DistanceProbe::FindHeight(const Eigen::Vector3d& place, double tolerance) const
{
  const TriangleRaster* const raster = this->To.GetRaster();
  if (raster == nullptr)
  {
    return this->To.GetTree().FindHeight(place, tolerance);
  }
  return this->IsAcross && this->Across.IsOnlyOne(2.0 * tolerance) ? this->Across.Height()
                                                                   : raster->FindHeight(place, tolerance);
}

// ---- TriangleTree ---------------------------------------------------------------------------------------------------
//
// The tree is made top-down, and filled bottom-up:
//
// MakeLevels: the number of nodes per level
// Sort: halves of triangles by the middles of their boxes
// FillNodes: boxes, from triangles or children
//
//
// Boxes in single precision are widened, and searches exceed the best distance slightly, so that rounding hides no
// triangle.

namespace
{
constexpr std::int64_t TrianglesPerSplit = 4096;
constexpr std::int64_t GrainOfNodes = 256;

// Box and point are rounded by up to 2^-24, and the box again when widened: four times is enough.
constexpr double RoundingOfCoordinates = 4 * 0x1p-24;

// A box adds three to the stack per level; numbers of 32 bits fit 16 levels.
constexpr std::size_t MostWaitingNodes = 64;

// Squared distances in single precision are wrong by less than 1e-6. Boxes beyond the best by this factor have nothing
// nearer.
constexpr double SlackOfDistances = 1.0 + 1e-5;

struct Middle
{
  float Doubled[3];
  std::int32_t Triangle;
};

Middle MiddleOf(const TriangleSurface& surface, std::int64_t triangle)
{
  const Eigen::AlignedBox3d box = surface.Box(surface.Triangles[triangle]);
  const Eigen::Vector3f doubled = (box.min() + box.max()).cast<float>();
  return { { doubled.x(), doubled.y(), doubled.z() }, std::int32_t(triangle) };
}

int LongestSide(const Middle* first, const Middle* last)
{
  Eigen::AlignedBox3f box;
  for (const Middle* middle = first; middle < last; ++middle)
  {
    box.extend(Eigen::Vector3f(middle->Doubled[0], middle->Doubled[1], middle->Doubled[2]));
  }
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  return axis;
}

/// The first `count` triangles are least along the longest side.
void SplitNode(Middle* first, std::size_t count, Middle* last)
{
  if (count < std::size_t(last - first))
  {
    const int axis = LongestSide(first, last);
    std::nth_element(first, first + count, last,
      [axis](const Middle& a, const Middle& b)
      { return a.Doubled[axis] != b.Doubled[axis] ? a.Doubled[axis] < b.Doubled[axis] : a.Triangle < b.Triangle; });
  }
}

void SplitIntoChildren(Middle* first, Middle* last, std::size_t capacity)
{
  const std::size_t children = (std::size_t(last - first) + capacity - 1) / capacity;
  Middle* const half = std::min(last, first + (children + 1) / 2 * capacity);
  SplitNode(first, half - first, last);
  SplitNode(first, capacity, half);
  SplitNode(half, capacity, last);
}

/// On the level below the last, nodes are leaves.
struct Waiting
{
  float SquaredDistance;
  std::uint32_t Node;
  std::uint32_t Level;
};
}

//----------------------------------------------------------------------------------------------------------------------
TriangleTree::TriangleTree(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
{
  assert(
    !surface.Triangles.empty() && surface.Triangles.size() <= std::size_t(std::numeric_limits<std::int32_t>::max()));
  double largest = 0.0;
  for (const Eigen::Vector3d& point : surface.Points)
  {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  this->Margin = float(RoundingOfCoordinates * largest);
  this->MakeLevels();
  this->Sort(monitor);
  this->FillNodes();
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::MakeLevels()
{
  std::vector<std::size_t> sizes; // from the lowest level to the root
  std::size_t size = (this->Surface.Triangles.size() + Fan - 1) / Fan; // leaves
  do
  {
    size = (size + Fan - 1) / Fan;
    sizes.push_back(size);
  } while (size > 1);
  this->LevelStart.assign(1, 0);
  for (auto level = sizes.rbegin(); level != sizes.rend(); ++level)
  {
    this->LevelStart.push_back(this->LevelStart.back() + *level);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::Sort(const Monitor& monitor)
{
  const std::size_t size = this->Surface.Triangles.size();
  std::vector<Middle> middles(size);
  ParallelFor(std::int64_t(size), TrianglesPerSplit,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        middles[n] = MiddleOf(this->Surface, n);
      }
    });
  std::size_t capacity = Fan; // triangles of a child
  for (std::size_t level = 1; level < this->Levels(); ++level)
  {
    capacity *= Fan;
  }
  for (std::size_t level = 0; level < this->Levels(); ++level, capacity /= Fan)
  {
    monitor.Progress(double(level) / double(this->Levels()));
    const auto split = [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const std::size_t begin = std::size_t(node) * Fan * capacity;
        SplitIntoChildren(middles.data() + begin, middles.data() + std::min(size, begin + Fan * capacity), capacity);
      }
    };
    ParallelFor(std::int64_t(this->NodesOf(level)), TrianglesPerSplit / std::int64_t(capacity) + 1, split);
  }
  this->Triangles.reserve(size);
  this->Numbers.reserve(size);
  for (const Middle& middle : middles)
  {
    this->Numbers.push_back(middle.Triangle);
    this->Triangles.push_back(this->Surface.Triangles[middle.Triangle]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::SetBox(Node& node, int child, const Eigen::AlignedBox3d& box) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    node.Low[axis][child] = float(box.min()[axis]) - this->Margin;
    node.High[axis][child] = float(box.max()[axis]) + this->Margin;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::FillLowest(std::size_t node)
{
  Node& filled = this->Nodes[this->LevelStart[this->Levels() - 1] + node];
  for (std::size_t child = 0; child < Fan; ++child)
  {
    Eigen::AlignedBox3d box;
    const std::size_t leaf = node * Fan + child;
    for (std::size_t triangle = leaf * Fan; triangle < this->EndOf(leaf); ++triangle)
    {
      box.extend(this->Surface.Box(this->Triangles[triangle]));
    }
    if (!box.isEmpty())
    {
      this->SetBox(filled, int(child), box);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::FillFromChildren(std::size_t level, std::size_t node)
{
  Node& filled = this->Nodes[this->LevelStart[level] + node];
  for (std::size_t child = 0; child < Fan && node * Fan + child < this->NodesOf(level + 1); ++child)
  {
    const Node& below = this->Nodes[this->LevelStart[level + 1] + node * Fan + child];
    for (int axis = 0; axis < 3; ++axis)
    {
      filled.Low[axis][Eigen::Index(child)] = below.Low[axis].minCoeff();
      filled.High[axis][Eigen::Index(child)] = below.High[axis].maxCoeff();
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::FillNodes()
{
  Node empty;
  std::fill_n(empty.Low, 3, Eigen::Array4f::Constant(std::numeric_limits<float>::infinity()));
  std::fill_n(empty.High, 3, Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity()));
  this->Nodes.assign(this->LevelStart.back(), empty);
  for (std::size_t level = this->Levels(); level-- > 0;)
  {
    const bool lowest = level + 1 == this->Levels();
    ParallelFor(std::int64_t(this->NodesOf(level)), GrainOfNodes,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t node = first; node < last; ++node)
        {
          lowest ? this->FillLowest(node) : this->FillFromChildren(level, node);
        }
      });
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Calls searchLeaf(leaf), which returns a new bound, for leaves within the bound, nearest first.
template <typename DistancesOf, typename LeafSearch>
void TriangleTree::Descend(float bound, DistancesOf&& distancesOf, LeafSearch&& searchLeaf) const
{
  const std::uint32_t levels = std::uint32_t(this->Levels());
  Waiting stack[MostWaitingNodes];
  std::size_t size = 1;
  stack[0] = { 0.0F, 0, 0 };
  while (size > 0)
  {
    const Waiting box = stack[--size];
    if (box.SquaredDistance >= bound)
    {
      continue;
    }
    if (box.Level == levels)
    {
      bound = searchLeaf(box.Node);
      continue;
    }
    const Eigen::Array4f distances = distancesOf(this->Nodes[this->LevelStart[box.Level] + box.Node]);
    assert(size + Fan <= MostWaitingNodes);
    const std::size_t oldSize = size;
    for (std::uint32_t child = 0; child < Fan; ++child)
    {
      if (distances[child] < bound)
      {
        stack[size++] = { distances[child], box.Node * std::uint32_t(Fan) + child, box.Level + 1 };
      }
    }
    SortByDistance(stack + oldSize, stack + size);
  }
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleTree::SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint, const Metric& metric) const
{
  assert(hint >= 0 && std::size_t(hint) < this->Triangles.size());
  const Eigen::Vector3f place = point.cast<float>();
  const Eigen::Array3f weights = metric.Weights().cast<float>();
  double best = metric.SquaredDistance(this->Surface, this->Triangles[hint], point);
  this->Descend(
    float(SlackOfDistances * best),
    [&](const Node& node)
    {
      Eigen::Array4f distances = Eigen::Array4f::Zero();
      for (int axis = 0; axis < 3; ++axis)
      {
        distances +=
          (weights[axis] * (node.Low[axis] - place[axis]).max(place[axis] - node.High[axis]).max(0.0F)).square();
      }
      return distances;
    },
    [&](std::size_t leaf)
    {
      for (std::size_t n = leaf * Fan; n < this->EndOf(leaf); ++n)
      {
        KeepNearer(this->Surface, this->Triangles[n], std::int32_t(n), point, metric, hint, best);
      }
      return float(SlackOfDistances * best);
    });
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleTree::FindHeight(const Eigen::Vector3d& point, double tolerance) const
{
  const Eigen::Vector3f place = point.cast<float>();
  const float reach = std::max(this->Margin, float(2.0 * tolerance)); // twice, as the tolerance is rounded, too
  double best = std::numeric_limits<double>::quiet_NaN();
  // Boxes on the vertical through the point have distance 0, all other boxes are out of bounds.
  constexpr float Bound = 1.0F;
  this->Descend(
    Bound,
    [&](const Node& node) -> Eigen::Array4f
    {
      return (node.Low[0] <= place.x() + reach && node.High[0] >= place.x() - reach &&
        node.Low[1] <= place.y() + reach && node.High[1] >= place.y() - reach)
        .select(Eigen::Array4f::Zero(), Eigen::Array4f::Constant(Bound));
    },
    [&](std::size_t leaf)
    {
      for (std::size_t n = leaf * Fan; n < this->EndOf(leaf); ++n)
      {
        best = NearerHeight(this->Surface, this->Triangles[n], point, tolerance, best);
      }
      return Bound;
    });
  return best;
}
}
