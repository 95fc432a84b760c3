// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointWindow.h"

#include "Common/Base/FixedChunks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// After more halvings the rectangle is below the precision of doubles.
constexpr int MostWindowHalvings = 2 * 64;

struct WindowBox : Eigen::AlignedBox2d
{
  void Add(const WindowBox& other) { this->extend(other); }
};

struct PointCount
{
  std::int64_t Points = 0;

  void Add(const PointCount& other) { this->Points += other.Points; }
};

WindowBox BoxAround(const PlaneCloud& points, const Monitor& monitor)
{
  return AddUpChunks<WindowBox>(points.Size(), ChunkSize, monitor,
    [&](WindowBox& box, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        box.extend(points[point]);
      }
    });
}

std::int64_t CountInside(const PlaneCloud& points, const WindowBox& box, const Monitor& monitor)
{
  const auto count = AddUpChunks<PointCount>(points.Size(), ChunkSize, monitor,
    [&](PointCount& inside, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        inside.Points += box.contains(points[point]) ? 1 : 0;
      }
    });
  return count.Points;
}

/// Cuts across the longer side. Points on the cut belong to both halves.
std::pair<WindowBox, WindowBox> Halve(const WindowBox& box)
{
  std::pair<WindowBox, WindowBox> halves = { box, box };
  const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
  const double middle = 0.5 * (box.min()[axis] + box.max()[axis]);
  halves.first.max()[axis] = middle;
  halves.second.min()[axis] = middle;
  return halves;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<Eigen::Vector2d> CrowdedWindow(const PlaneCloud& points, std::int64_t mostPoints, const Monitor& monitor)
{
  WindowBox box = BoxAround(points, monitor);
  std::int64_t inside = points.Size();
  for (int halvings = 0; inside > mostPoints && halvings < MostWindowHalvings; ++halvings)
  {
    const auto [lower, upper] = Halve(box);
    const std::int64_t insideLower = CountInside(points, lower, monitor);
    const bool takesLower = 2 * insideLower >= inside;
    box = takesLower ? lower : upper;
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
