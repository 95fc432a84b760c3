// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// With a radius of 1, loops are what OpenCV finds: the same points in the same order, up to start and direction.

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Tools/Check.h"
#include "Tools/OpenCvContours.h"
#include "Tools/Patches.h"
#include "Tools/RealHorizons.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
using Path = std::vector<PlanePoint>;

/// The one of all cyclic shifts of a path, forwards and backwards, that comes first in the order of the alphabet.
Path Canonical(const Path& path)
{
  Path best;
  Path directed = path;
  for (int direction = 0; direction < 2; ++direction)
  {
    const PlanePoint least = *std::min_element(directed.begin(), directed.end());
    for (std::size_t n = 0; n < directed.size(); ++n)
    {
      if (directed[n] == least)
      {
        Path shifted = directed;
        std::rotate(shifted.begin(), shifted.begin() + std::ptrdiff_t(n), shifted.end());
        best = best.empty() ? shifted : std::min(best, shifted);
      }
    }
    std::reverse(directed.begin(), directed.end());
  }
  return best;
}

std::vector<Path> Sorted(std::vector<Path> paths)
{
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The exterior loops, or those of holes.
std::vector<Path> Ours(const Path& columns, const ExteriorBoundary& boundary, bool holes)
{
  std::vector<Path> paths;
  const std::size_t first = holes ? boundary.NumberOfPatches : 0;
  const std::size_t last = holes ? boundary.Boundary.Size() : boundary.NumberOfPatches;
  for (std::size_t loop = first; loop < last; ++loop)
  {
    Path path;
    std::for_each(boundary.Boundary.begin(loop), boundary.Boundary.end(loop),
      [&](PointId point) { path.push_back(columns[std::size_t(point)]); });
    paths.push_back(Canonical(path));
  }
  return Sorted(paths);
}

/// With a tree of two levels a contour that has a parent is that of a hole.
std::vector<Path> Theirs(const Path& columns, int mode, bool holes)
{
  OpenCvContours::Contours contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(OpenCvContours::ToImage(columns), contours, hierarchy, mode, cv::CHAIN_APPROX_NONE);
  std::vector<Path> paths;
  for (std::size_t n = 0; n < contours.size(); ++n)
  {
    if ((hierarchy[n][3] >= 0) == holes)
    {
      Path path;
      for (const cv::Point& point : contours[n])
      {
        path.push_back({ point.x, point.y });
      }
      paths.push_back(Canonical(path));
    }
  }
  return Sorted(paths);
}

void Compare(const std::string& name, const Path& columns)
{
  BoundaryOptions options;
  bool isEqual =
    Ours(columns, FindExteriorBoundary(columns, options), false) == Theirs(columns, cv::RETR_EXTERNAL, false);
  options.KeepHoles = true;
  const ExteriorBoundary all = FindExteriorBoundary(columns, options);
  isEqual = isEqual && Ours(columns, all, false) == Theirs(columns, cv::RETR_CCOMP, false);
  isEqual = isEqual && Ours(columns, all, true) == Theirs(columns, cv::RETR_CCOMP, true);
  if (!CHECK(isEqual))
  {
    std::cerr << name << '\n';
  }
}
}

int TestOpenCvContours(int, char*[])
{
  Patches::Random random(17);
  for (int n = 0; n < 10000; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    Compare("patch " + std::to_string(n), columns);
  }
  for (const std::filesystem::path& file : RealHorizons::Files())
  {
    Compare(file.string(), RealHorizons::Read(file));
  }
  return Check::Result();
}
