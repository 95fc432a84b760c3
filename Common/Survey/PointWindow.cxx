// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointWindow.h"

#include "Common/FixedChunks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>

namespace SeismicHorizons
{
namespace
{
using Box = Eigen::AlignedBox2d;

constexpr std::int64_t ChunkSize = 1 << 16;
// A rectangle halved as often is smaller than the last digit of its place.
constexpr int MostHalvings = 2 * 64;

Box BoxAround(const PlaneCloud& points, const Monitor& monitor)
{
  std::vector<Box> boxes(CountChunks(points.Size(), ChunkSize));
  ForEachChunk(points.Size(), ChunkSize, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        boxes[chunk].extend(points[point]);
      }
    });
  Box all;
  for (const Box& box : boxes)
  {
    all.extend(box);
  }
  return all;
}

std::int64_t CountInside(const PlaneCloud& points, const Box& box, const Monitor& monitor)
{
  std::atomic<std::int64_t> count = 0;
  ForEachChunk(points.Size(), ChunkSize, monitor,
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      std::int64_t inside = 0;
      for (std::int64_t point = first; point < last; ++point)
      {
        inside += box.contains(points[point]) ? 1 : 0;
      }
      count += inside;
    });
  return count;
}

/// The half of a box towards its lesser corner, cut across the longer side.
Box LowerHalf(const Box& box)
{
  Box half = box;
  const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
  half.max()[axis] = 0.5 * (box.min()[axis] + box.max()[axis]);
  return half;
}

/// The other half. Points on the cut belong to both.
Box UpperHalf(const Box& box)
{
  Box half = box;
  const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
  half.min()[axis] = 0.5 * (box.min()[axis] + box.max()[axis]);
  return half;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Eigen::Vector2d> CrowdedWindow(const PlaneCloud& points, std::int64_t mostPoints, const Monitor& monitor)
{
  Box box = BoxAround(points, monitor);
  std::int64_t inside = points.Size();
  for (int halvings = 0; inside > mostPoints && halvings < MostHalvings; ++halvings)
  {
    const Box lower = LowerHalf(box);
    const std::int64_t insideLower = CountInside(points, lower, monitor);
    const bool takesLower = 2 * insideLower >= inside;
    box = takesLower ? lower : UpperHalf(box);
    inside = takesLower ? insideLower : CountInside(points, box, monitor);
  }
  std::vector<Eigen::Vector2d> window;
  for (std::int64_t point = 0; point < points.Size(); ++point)
  {
    if (box.contains(points[point]))
    {
      window.push_back(points[point]);
    }
  }
  std::sort(window.begin(), window.end(),
    [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  window.erase(std::unique(window.begin(), window.end()), window.end());
  return window;
}
}
