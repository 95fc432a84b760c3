// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SheetNormals.h"

#include "Common/Horizon/Median.h"
#include "SheetBlocks.h"

#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace SeismicHorizons
{
namespace
{
using Vector = std::array<double, 3>;

constexpr double MostLevels = 400.0; ///< Up and down.

template <class Function>
void ForRows(const SheetBlocks& blocks, const Function& function)
{
  vtkSMPTools::For(0, vtkIdType(blocks.Count[1]),
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::int64_t j = first; j < last; ++j)
      {
        for (std::int64_t i = 0; i < blocks.Count[0]; ++i)
        {
          function(i, j);
        }
      }
    });
}

/// What heights of neighbours along rows differ by.
struct NeighbourSteps
{
  double Usual = 0.0; ///< The median of differences other than zero.
  bool AreCoarse = false; ///< Heights at full precision repeat in few neighbours, vertical indices in many.
};

NeighbourSteps MeasureSteps(const SheetBlocks& blocks)
{
  std::vector<double> steps;
  std::size_t pairs = 0;
  for (std::int64_t j = 0; j < blocks.Count[1]; ++j)
  {
    for (std::int64_t i = 0; i + 1 < blocks.Count[0]; ++i)
    {
      const vtkIdType a = blocks.At(i, j), b = blocks.At(i + 1, j);
      if (a >= 0 && b >= 0)
      {
        ++pairs;
        steps.push_back(std::fabs(blocks.Places[std::size_t(a)][2] - blocks.Places[std::size_t(b)][2]));
      }
    }
  }
  steps.erase(std::remove(steps.begin(), steps.end(), 0.0), steps.end());
  if (steps.empty())
  {
    return {};
  }
  return { UpperMedian(steps), 5 * (pairs - steps.size()) > pairs };
}

/// Returns the median height.
double FindMiddle(const SheetBlocks& blocks)
{
  std::vector<double> heights;
  for (const vtkIdType shown : blocks.Shown)
  {
    if (shown >= 0)
    {
      heights.push_back(blocks.Places[std::size_t(shown)][2]);
    }
  }
  return UpperMedian(heights);
}

/// Averages heights over pairs of neighbours on opposite sides, so that planes remain, also beside gaps, and scarps of
/// more than `largestStep`.
std::vector<double> SmoothHeights(const SheetBlocks& blocks, double largestStep)
{
  constexpr int radius = 3, passes = 2, across = 2 * radius + 1;
  std::vector<double> heights(blocks.Places.size()), averages;
  std::transform(blocks.Places.begin(), blocks.Places.end(), std::back_inserter(averages),
    [](const Vector& place) { return place[2]; });
  for (int pass = 0; pass < passes; ++pass)
  {
    heights = averages;
    ForRows(blocks,
      [&](std::int64_t i, std::int64_t j)
      {
        const vtkIdType here = blocks.At(i, j);
        if (here < 0)
        {
          return;
        }
        const double height = heights[std::size_t(here)];
        double sum = height, count = 1.0;
        for (std::int64_t n = 0; n < across * across / 2; ++n) // the other half are those opposite
        {
          const std::int64_t di = n % across - radius, dj = n / across - radius;
          const vtkIdType a = blocks.At(i + di, j + dj), b = blocks.At(i - di, j - dj);
          if (a >= 0 && b >= 0 && std::fabs(heights[std::size_t(a)] - height) <= largestStep &&
            std::fabs(heights[std::size_t(b)] - height) <= largestStep)
          {
            sum += heights[std::size_t(a)] + heights[std::size_t(b)];
            count += 2.0;
          }
        }
        averages[std::size_t(here)] = sum / count;
      });
  }
  return averages;
}

/// Returns unit vectors, upwards, by differences of neighbours, in their heights or in `smooth` heights.
std::vector<Vector> FindNormals(const SheetBlocks& blocks, const std::vector<double>& smooth)
{
  std::vector<Vector> normals(blocks.Places.size(), Vector{ 0.0, 0.0, 1.0 });
  const auto place = [&](vtkIdType n)
  {
    Vector found = blocks.Places[std::size_t(n)];
    found[2] = smooth.empty() ? found[2] : smooth[std::size_t(n)];
    return found;
  };
  ForRows(blocks,
    [&](std::int64_t i, std::int64_t j)
    {
      const vtkIdType here = blocks.At(i, j);
      const auto side = [&](std::int64_t di, std::int64_t dj)
      {
        const vtkIdType next = blocks.At(i + di, j + dj), last = blocks.At(i - di, j - dj);
        const Vector a = place(last >= 0 ? last : here), b = place(next >= 0 ? next : here);
        return Vector{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      };
      const Vector u = here >= 0 ? side(1, 0) : Vector(), v = here >= 0 ? side(0, 1) : Vector();
      const Vector normal = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
      const double length = std::copysign(std::hypot(normal[0], normal[1], normal[2]), normal[2]);
      if (length != 0.0)
      {
        normals[std::size_t(here)] = { normal[0] / length, normal[1] / length, normal[2] / length };
      }
    });
  return normals;
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> MakeNormals(const SheetBlocks& blocks, double interval)
{
  const NeighbourSteps steps = MeasureSteps(blocks);
  const bool hasLevels = interval > 0.0;
  const std::vector<double> smooth = hasLevels || steps.AreCoarse
    ? SmoothHeights(blocks, std::max(interval / 2.0, 3.0 * steps.Usual))
    : std::vector<double>();
  const std::vector<Vector> unit = FindNormals(blocks, steps.AreCoarse ? smooth : std::vector<double>());
  // Contours of whole heights are at the edges of terraces, not on all of one.
  const double shift = steps.AreCoarse ? steps.Usual / 2.0 : 0.0;
  const double first = hasLevels ? 5.0 * std::floor(FindMiddle(blocks) / interval / 5.0) : 0.0;
  const auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("HorizonSheetNormals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(vtkIdType(unit.size()));
  for (std::size_t n = 0; n < unit.size(); ++n)
  {
    const double level = hasLevels ? (smooth[n] + shift) / interval - first : 0.0;
    const double length =
      hasLevels && std::isfinite(level) ? SheetLevels + std::clamp(level, -MostLevels, MostLevels) : 1.0;
    normals->SetTuple3(vtkIdType(n), length * unit[n][0], length * unit[n][1], length * unit[n][2]);
  }
  return normals;
}
}
