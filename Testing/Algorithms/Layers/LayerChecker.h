// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of the cells, volumes and bodies of layers, checked with none of the code that makes them.

#ifndef SeismicHorizonsLayerChecker_h
#define SeismicHorizonsLayerChecker_h

#include "ClosedBodies.h"
#include "DivisionChecker.h"
#include "FaultWallChecker.h"
#include "Filters/Algorithms/Layers/LayerCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace LayerChecker
{
class Checker : public FaultWallChecker
{
public:
  using FaultWallChecker::FaultWallChecker;

  /// What is wrong first; empty when nothing is.
  std::string Check()
  {
    std::string wrong = this->CheckPlan();
    wrong = wrong.empty() ? this->CheckSides() : wrong;
    const LayerCells cells = MakeLayerCells(this->Plan);
    for (std::size_t layer = 0; layer + 1 < this->Horizons.size(); ++layer)
    {
      wrong = wrong.empty() ? this->CheckCells(cells, layer) : wrong;
      wrong = wrong.empty() ? this->CheckBody(layer) : wrong;
    }
    return wrong.empty() ? DivisionChecker::Check(this->Plan, cells) : wrong;
  }

  /// For outlines that are kept as they are: area and volume against blocks of the lattice.
  std::string CheckLattice() const
  {
    std::ostringstream text;
    for (std::size_t layer = 0; layer + 1 < this->Horizons.size(); ++layer)
    {
      const auto [volume, slack, area] = this->LatticeVolume(layer);
      double planArea = 0.0;
      double planVolume = 0.0;
      this->ForEachTriangle(
        [&](const std::array<std::size_t, 3>& t)
        {
          const double one = 0.5 * double(Turn(this->At(t[0]), this->At(t[1]), this->At(t[2])));
          planArea += one;
          planVolume +=
            one * (this->Between(layer, t[0]) + this->Between(layer, t[1]) + this->Between(layer, t[2])) / 3;
        });
      if (planArea != area || std::abs(planVolume - volume) > slack + 1e-9 * (1.0 + volume))
      {
        text << "layer " << layer << ": area " << planArea << " for " << area << ", volume " << planVolume << " for "
             << volume << " +- " << slack;
      }
    }
    const std::string wrong = text.str();
    return wrong.empty() ? this->CheckFaultWalls() : wrong;
  }

  /// Over blocks of four columns, cut in two either way, and halves of three: the volume, by how much that of a plan
  /// within the error may differ, and the area.
  std::array<double, 3> LatticeVolume(std::size_t layer) const
  {
    std::map<Column, std::array<double, 2>> heights;
    for (std::size_t n = 0; n < this->Result.Stack.Columns.size(); ++n)
    {
      heights[{ this->Result.Stack.Columns[n].X, this->Result.Stack.Columns[n].Y }] = {
        this->Result.Stack.Heights[layer][n], this->Result.Stack.Heights[layer + 1][n]
      };
    }
    const double largest = this->LargestErrorOf(layer) + this->LargestErrorOf(layer + 1);
    std::array<double, 3> sums = { 0.0, 0.0, 0.0 };
    std::set<Column> blocks;
    for (const auto& entry : heights)
    {
      const auto [x, y] = entry.first;
      blocks.insert({ { x, y }, { x - 1, y }, { x, y - 1 }, { x - 1, y - 1 } });
    }
    for (const auto& [x, y] : blocks)
    {
      const std::array<Column, 4> corners = { Column{ x, y }, { x + 1, y }, { x, y + 1 }, { x + 1, y + 1 } };
      double sum = 0.0;
      std::array<double, 2> twist = { 0.0, 0.0 };
      int count = 0;
      const int left = LeftByCuts(this->Options.Cuts, { x, y });
      for (std::size_t n = 0; n < 4 && left >= 0; ++n)
      {
        const auto found = heights.find(corners[n]);
        if (found != heights.end() && int(n) != left)
        {
          ++count;
          sum += this->Sign * (found->second[0] - found->second[1]);
          twist[0] += (n == 0 || n == 3 ? 0.5 : -0.5) * found->second[0];
          twist[1] += (n == 0 || n == 3 ? 0.5 : -0.5) * found->second[1];
        }
      }
      if (count >= 3)
      {
        const double area = count == 4 ? 1.0 : 0.5;
        sums[0] += area * sum / count; // the mean of both ways to cut four
        // Inside a block, a surface is between what it is along the lines around.
        sums[1] += area * largest;
        sums[1] += count == 4 ? std::abs(twist[0]) + std::abs(twist[1]) : 0.0;
        sums[2] += area;
      }
    }
    return sums;
  }

protected:
  using SideCounts = std::map<std::pair<std::size_t, std::size_t>, int>;

  /// How many triangles each side has.
  SideCounts CountSides() const
  {
    SideCounts sides;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        for (std::size_t n = 0; n < 3; ++n)
        {
          ++sides[std::minmax(t[n], t[(n + 1) % 3])];
        }
      });
    return sides;
  }

  /// Without those outside the plan, and those on its outline that are no vertices: the mesh does not know these.
  ColumnNumbers NumberInnerColumns() const
  {
    const ColumnNumbers all = this->NumberColumns();
    const SideCounts sides = this->CountSides();
    ColumnNumbers inner;
    std::set<Column> onOutline;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        this->ForEachColumnOf(t,
          [&](int x, int y, const std::array<double, 3>& w)
          {
            const auto found = all.find({ x, y });
            if (found != all.end())
            {
              inner.insert(*found);
            }
            for (std::size_t n = 0; n < 3; ++n)
            {
              const auto side = std::minmax(t[(n + 1) % 3], t[(n + 2) % 3]);
              if (w[n] == 0.0 && w[(n + 1) % 3] > 0.0 && w[(n + 2) % 3] > 0.0 && sides.at(side) == 1)
              {
                onOutline.insert({ x, y });
              }
            }
          });
      });
    for (const Column& column : onOutline)
    {
      inner.erase(column);
    }
    return inner;
  }

  /// The largest error of inner sides where they cross the lines between two of some columns that are neighbours.
  double LargestSideError(std::size_t horizon, const ColumnNumbers& numbers, const SideCounts& sides) const
  {
    double largest = 0.0;
    for (const auto& [side, triangles] : sides)
    {
      largest =
        triangles == 2 ? std::max(largest, this->SideError(horizon, side.first, side.second, numbers)) : largest;
    }
    return largest;
  }

  std::string CheckSides() const
  {
    const ColumnNumbers numbers = this->NumberInnerColumns();
    const SideCounts sides = this->CountSides();
    std::ostringstream text;
    for (std::size_t horizon = 0; horizon < this->Horizons.size(); ++horizon)
    {
      const double largest = this->LargestSideError(horizon, numbers, sides);
      if (std::abs(largest - this->Result.LargestSideErrors[horizon]) > 1e-9)
      {
        text << "error of sides " << largest << ", said " << this->Result.LargestSideErrors[horizon] << "; ";
      }
    }
    return text.str();
  }

  double SideError(std::size_t horizon, std::size_t a, std::size_t b, const ColumnNumbers& numbers) const
  {
    double largest = 0.0;
    const auto heightAt = [&](int x, int y)
    {
      const auto found = numbers.find({ x, y });
      return found == numbers.end() ? std::nan("") : this->Result.Stack.Heights[horizon][found->second];
    };
    const double dx = this->At(b).X - this->At(a).X;
    const double dy = this->At(b).Y - this->At(a).Y;
    const auto add = [&](double part, double lineHeight)
    {
      const double height = (1.0 - part) * this->Plan.Heights[horizon][a] + part * this->Plan.Heights[horizon][b];
      largest = std::isnan(lineHeight) ? largest : std::max(largest, std::abs(height - lineHeight));
    };
    for (int y = std::min(this->At(a).Y, this->At(b).Y) + 1; y < std::max(this->At(a).Y, this->At(b).Y); ++y)
    {
      const double part = (y - this->At(a).Y) / dy;
      const double x = this->At(a).X + part * dx;
      const int left = int(std::floor(x));
      if (std::abs(x - std::round(x)) > 1e-9 && !(this->Options.Cuts && this->Options.Cuts->IsCutEast({ left, y })))
      {
        add(part, heightAt(left, y) + (x - left) * (heightAt(left + 1, y) - heightAt(left, y)));
      }
    }
    for (int x = std::min(this->At(a).X, this->At(b).X) + 1; x < std::max(this->At(a).X, this->At(b).X); ++x)
    {
      const double part = (x - this->At(a).X) / dx;
      const double y = this->At(a).Y + part * dy;
      const int below = int(std::floor(y));
      if (std::abs(y - std::round(y)) > 1e-9 && !(this->Options.Cuts && this->Options.Cuts->IsCutNorth({ x, below })))
      {
        add(part, heightAt(x, below) + (y - below) * (heightAt(x, below + 1) - heightAt(x, below)));
      }
    }
    return largest;
  }

  double LargestErrorOf(std::size_t horizon) const
  {
    return std::max(
      this->Result.LargestErrors[horizon], this->LargestSideError(horizon, this->NumberColumns(), this->CountSides()));
  }

  /// One cell over each triangle with a thickness, turned the right way, and as large as the layer is there.
  std::string CheckCells(const LayerCells& cells, std::size_t layer) const
  {
    std::vector<double> volumes(this->Plan.Triangles.size() / 3, 0.0);
    std::array<std::int64_t, 4> kinds = {};
    double sum = 0.0;
    double above = 0.0;
    const double contact = this->Plan.Heights[layer].empty() ? 0.0 : this->Plan.Heights[layer].front();
    for (std::size_t cell = 0; cell < cells.Size(); ++cell)
    {
      if (std::size_t(cells.Layers[cell]) != layer)
      {
        continue;
      }
      std::vector<Point> points;
      for (std::int64_t n = cell == 0 ? 0 : cells.Ends[cell - 1]; n < cells.Ends[cell]; ++n)
      {
        const auto point = std::size_t(cells.Corners[std::size_t(n)]);
        points.push_back(this->PointAt(std::size_t(cells.Vertices[point]), cells.Heights[point]));
      }
      double volume = 0.0;
      for (const auto& t : ClosedBodies::CutIntoTetrahedra(points))
      {
        const double part = ClosedBodies::TetrahedronVolume(t[0], t[1], t[2], t[3]);
        if (!(part > 0.0))
        {
          return "cell turned inside out";
        }
        volume += part;
        const double high = ClosedBodies::VolumeAbove(t, contact);
        above += this->Sign > 0.0 ? high : part - high;
      }
      if (std::abs(volume - cells.Volumes[cell]) > 1e-9 * (1.0 + volume) ||
        volumes[std::size_t(cells.Triangles[cell])] > 0)
      {
        return "cell of a wrong volume, or twice";
      }
      volumes[std::size_t(cells.Triangles[cell])] = volume;
      ++kinds[points.size() - 3];
      sum += volume;
    }
    std::size_t triangle = 0;
    std::int64_t members = 0; // triangles where the layer is
    std::string wrong;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        const double thickness = this->Between(layer, t[0]) + this->Between(layer, t[1]) + this->Between(layer, t[2]);
        const bool isIn = this->Plan.IsIn.empty() || this->Plan.IsIn[layer][triangle] != 0;
        const double area = isIn ? 0.5 * double(Turn(this->At(t[0]), this->At(t[1]), this->At(t[2]))) : 0.0;
        const double volume = area * thickness / 3.0;
        members += isIn ? 1 : 0;
        wrong = std::abs(volumes[triangle] - volume) <= 1e-9 * (1.0 + volume) ? wrong : "a cell is missing";
        ++triangle;
      });
    const LayerVolume measured = MeasureLayer(this->Plan, layer);
    kinds[0] = members - kinds[1] - kinds[2] - kinds[3];
    wrong = std::abs(measured.Volume - sum) <= 1e-10 * (1.0 + sum) ? wrong : "sum of volumes";
    wrong = measured.Triangles == kinds ? wrong : "numbers of wedges, pyramids and tetrahedra";
    const double said = VolumeAbove(this->Plan, layer, contact);
    return std::abs(said - above) <= 1e-8 * (1.0 + sum) ? wrong : "volume above a contact";
  }

  /// Closed, as large as the cells, and of the faces that it must have.
  std::string CheckBody(std::size_t layer) const
  {
    const LayerBody body = MakeLayerBody(this->Plan, layer);
    std::vector<Point> points;
    for (std::size_t n = 0; n < body.Vertices.size(); ++n)
    {
      points.push_back(this->PointAt(std::size_t(body.Vertices[n]), body.Heights[n]));
    }
    std::vector<ClosedBodies::Corners> triangles;
    std::array<double, 2> areas = { 0.0, 0.0 }; // in plan, upwards
    for (std::size_t n = 0; n + 2 < body.Triangles.size(); n += 3)
    {
      triangles.push_back({ body.Triangles[n], body.Triangles[n + 1], body.Triangles[n + 2] });
      const auto at = [&](std::size_t corner) { return body.Vertices[std::size_t(body.Triangles[n + corner])]; };
      const BodyFace face = body.Faces[n / 3];
      const auto area =
        double(Turn(this->At(std::size_t(at(0))), this->At(std::size_t(at(1))), this->At(std::size_t(at(2)))));
      if ((face == BodyFace::Outline || face == BodyFace::Fault) != (area == 0.0))
      {
        return "a wall that is not upright";
      }
      areas[face == BodyFace::Base ? 1 : 0] += 0.5 * area;
      for (std::size_t corner = 0; corner < 3 && area != 0.0; ++corner)
      {
        const std::size_t horizon = face == BodyFace::Top ? layer : layer + 1;
        if (body.Heights[std::size_t(body.Triangles[n + corner])] !=
          this->Plan.Heights[horizon][std::size_t(at(corner))])
        {
          return "a face off its horizon";
        }
      }
    }
    const LayerVolume measured = MeasureLayer(this->Plan, layer);
    if (std::abs(this->Sign * areas[0] - measured.Area) > 1e-9 || areas[1] != -areas[0])
    {
      return "top and base of a wrong area";
    }
    const std::string wrong = ClosedBodies::CheckClosed(points, triangles);
    const double volume = ClosedBodies::EnclosedVolume(points, triangles);
    return !wrong.empty() || std::abs(volume - measured.Volume) <= 1e-9 * (1.0 + measured.Volume) ? wrong
                                                                                                  : "volume of a body";
  }
};
}

#endif
