// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of layers at faults, checked from the faulted links and the result alone.

#ifndef SeismicHorizonsFaultWallChecker_h
#define SeismicHorizonsFaultWallChecker_h

#include "Filters/Algorithms/Layers/LayerBody.h"
#include "Filters/Algorithms/Layers/LayerCells.h"
#include "PlanChecker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

namespace LayerChecker
{
class FaultWallChecker : public PlanChecker
{
public:
  using PlanChecker::PlanChecker;

  /// Also for outlines that are kept: walls are at a fault where the first block beyond them, with three columns at
  /// least, is cut.
  std::string CheckFaultWalls() const
  {
    const ColumnNumbers numbers = this->NumberColumns();
    const double area = this->AreaInCutBlocks(numbers);
    for (std::size_t layer = 0; layer + 1 < this->Horizons.size(); ++layer)
    {
      if (MeasureLayer(this->Plan, layer).FaultArea != area)
      {
        return "the area left out at faults";
      }
      const LayerBody body = MakeLayerBody(this->Plan, layer);
      for (std::size_t n = 0; n < body.Faces.size(); ++n)
      {
        const bool isFault = body.Faces[n] == BodyFace::Fault;
        if (!isFault && body.Faces[n] != BodyFace::Outline)
        {
          continue;
        }
        const std::array<PlanePoint, 2> wall = this->WallInPlan(body, n);
        const int dx = wall[1].X - wall[0].X;
        const int dy = wall[1].Y - wall[0].Y;
        const int steps = std::max(std::abs(dx), std::abs(dy));
        // The middle of the first step, and somewhat to the right of it.
        const double x = wall[0].X + (0.5 * dx + 0.25 * dy) / steps;
        const double y = wall[0].Y + (0.5 * dy - 0.25 * dx) / steps;
        const Column block = { int(std::floor(x)), int(std::floor(y)) };
        int present = 0;
        int missing = -2;
        for (int corner = 0; corner < 4; ++corner)
        {
          const bool isThere = numbers.count({ block.first + corner % 2, block.second + corner / 2 }) > 0;
          present += isThere ? 1 : 0;
          missing = isThere ? missing : corner;
        }
        const int left = LeftByCuts(this->Options.Cuts, block);
        if (isFault != (left < 4 && present >= 3 && left != missing)) // a corner that is cut off, but not there
        {
          return isFault ? "a wall at a fault where there is none" : "a wall at a fault that is told of the outline";
        }
      }
    }
    return "";
  }

  /// What cuts take of blocks and halves of blocks.
  double AreaInCutBlocks(const ColumnNumbers& numbers) const
  {
    std::map<Column, int> present;
    for (const auto& [column, number] : numbers)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        present[{ column.first - corner % 2, column.second - corner / 2 }] += 1 << corner;
      }
    }
    double area = 0.0;
    for (const auto& [block, corners] : present)
    {
      const int left = LeftByCuts(this->Options.Cuts, block);
      const bool areAll = corners == 15;
      const bool areThree = corners == 14 || corners == 13 || corners == 11 || corners == 7;
      const double half = left >= 0 && left < 4 && (corners | 1 << left) == 15 ? 0.5 : 0.0; // what is not cut off
      area += left == 4 ? 0.0 : areAll ? 1.0 - half : areThree ? 0.5 - half : 0.0;
    }
    return area;
  }

  /// The ends of a wall, with the layer to the left.
  std::array<PlanePoint, 2> WallInPlan(const LayerBody& body, std::size_t face) const
  {
    const auto vertex = [&](std::size_t n)
    { return std::size_t(body.Vertices[std::size_t(body.Triangles[3 * face + n % 3])]); };
    for (std::size_t n = 0; n < 3; ++n)
    {
      for (const auto& [from, to] : { std::pair(vertex(n), vertex(n + 1)), std::pair(vertex(n + 1), vertex(n)) })
      {
        if (this->HasSide(from, to))
        {
          return { this->At(from), this->At(to) };
        }
      }
    }
    return {};
  }

  /// Whether a triangle of the plan has a side, with itself to the left.
  bool HasSide(std::size_t from, std::size_t to) const
  {
    bool has = false;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        for (std::size_t n = 0; n < 3; ++n)
        {
          has = has || (t[n] == from && t[(n + 1) % 3] == to);
        }
      });
    return has;
  }
};
}

#endif
