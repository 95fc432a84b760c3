// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of layers that each have a domain of their own, checked with none of the code that makes them.

#ifndef SeismicHorizonsDomainChecker_h
#define SeismicHorizonsDomainChecker_h

#include "LayerChecker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace LayerChecker
{
class DomainChecker : public Checker
{
public:
  using Checker::Checker;

  /// What is wrong first; empty when nothing is.
  std::string CheckDomains()
  {
    this->ReadHorizons();
    std::string wrong = this->CheckTriangles();
    wrong = wrong.empty() ? this->CheckHeights() : wrong;
    wrong = wrong.empty() ? this->CheckPointsOutside() : wrong;
    const LayerCells cells = MakeLayerCells(this->Plan);
    std::vector<double> largest(this->Horizons.size(), 0.0);
    for (std::size_t layer = 0; layer + 1 < this->Horizons.size(); ++layer)
    {
      wrong = wrong.empty() ? this->CheckRegion(layer, largest) : wrong;
      wrong = wrong.empty() ? this->CheckCells(cells, layer) : wrong;
      wrong = wrong.empty() ? this->CheckBody(layer) : wrong;
    }
    for (std::size_t horizon = 0; horizon < this->Horizons.size() && wrong.empty(); ++horizon)
    {
      const double said = this->Result.LargestErrors[horizon];
      wrong = largest[horizon] <= this->Options.MaximumError + 1e-9 && std::abs(said - largest[horizon]) <= 1e-9
        ? wrong
        : "error " + std::to_string(largest[horizon]) + ", said " + std::to_string(said);
    }
    return wrong.empty() ? DivisionChecker::Check(this->Plan, cells) : wrong;
  }

  /// How many blocks layers have halves of that others have cut along the other diagonal.
  int NumberOfConflicts() const { return this->Conflicts; }

private:
  using Block = Column; // by its lower left column

  void ReadHorizons()
  {
    this->Has.resize(this->Horizons.size());
    for (std::size_t n = 0; n < this->Horizons.size(); ++n)
    {
      for (const PlanePoint& column : this->Horizons[n].Columns)
      {
        this->Has[n].insert({ column.X, column.Y });
      }
    }
  }

  bool HasLayer(std::size_t layer, const Column& column) const
  {
    return this->Has[layer].count(column) > 0 && this->Has[layer + 1].count(column) > 0;
  }

  static Column CornerOf(const Block& block, int corner)
  {
    return { block.first + corner % 2, block.second + corner / 2 };
  }

  /// The missing corner of a block with three, 4 for all four, -1 for less.
  int Missing(std::size_t layer, const Block& block) const
  {
    int missing = 4;
    int count = 0;
    for (int corner = 0; corner < 4; ++corner)
    {
      if (!this->HasLayer(layer, CornerOf(block, corner)))
      {
        missing = corner;
        ++count;
      }
    }
    return count > 1 ? -1 : missing;
  }

  /// The same without halves along another diagonal than that of the first layer with a half there.
  int PartOf(std::size_t layer, const Block& block) const
  {
    const int own = this->Missing(layer, block);
    const int left = LeftByCuts(this->Options.Cuts, block);
    if (left < 4)
    {
      return own == 4 || own == left ? left : -1;
    }
    for (std::size_t first = 0; first < layer && own >= 0 && own < 4; ++first)
    {
      const int other = this->Missing(first, block);
      if (other >= 0 && other < 4)
      {
        const bool isAlike = (own == 0 || own == 3) == (other == 0 || other == 3);
        return isAlike ? own : -1;
      }
    }
    return own;
  }

  /// Order, and heights of their own where a column has none that cross.
  std::string CheckHeights() const
  {
    std::vector<std::map<Column, double>> given(this->Horizons.size());
    std::set<Column> expected;
    for (std::size_t n = 0; n < this->Horizons.size(); ++n)
    {
      for (std::size_t point = 0; point < this->Horizons[n].Columns.size(); ++point)
      {
        const Column column = { this->Horizons[n].Columns[point].X, this->Horizons[n].Columns[point].Y };
        given[n][column] = this->Horizons[n].Heights[point];
        if (n > 0 && this->HasLayer(n - 1, column))
        {
          expected.insert(column);
        }
      }
    }
    const OrderedStack& stack = this->Result.Stack;
    for (std::size_t n = 0; n < stack.Columns.size(); ++n)
    {
      const Column column = { stack.Columns[n].X, stack.Columns[n].Y };
      expected.erase(column);
      double above = std::nan("");
      for (std::size_t horizon = 0; horizon < this->Horizons.size(); ++horizon)
      {
        const double height = stack.Heights[horizon][n];
        if (std::isnan(height) == (given[horizon].count(column) > 0) || this->Sign * (above - height) < 0.0)
        {
          return "stack is not as given or not in order";
        }
        above = std::isnan(height) ? above : height;
      }
    }
    return expected.empty() ? "" : "a column of a layer is not in the stack";
  }

  /// The triangles of a layer are those inside its blocks, which they fill, within the error; and so is its volume.
  std::string CheckRegion(std::size_t layer, std::vector<double>& largest)
  {
    const ColumnNumbers numbers = this->NumberColumns();
    std::set<Column> covered;
    double area = 0.0;
    double volume = 0.0;
    std::size_t triangle = 0;
    std::string wrong;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        const bool isIn = this->Plan.IsIn[layer][triangle++] != 0;
        wrong = isIn == this->IsInside(layer, t) ? wrong : "a triangle of a wrong layer";
        const double own = 0.5 * double(Turn(this->At(t[0]), this->At(t[1]), this->At(t[2])));
        area += isIn ? own : 0.0;
        volume += isIn
          ? own * (this->Between(layer, t[0]) + this->Between(layer, t[1]) + this->Between(layer, t[2])) / 3.0
          : 0.0;
        this->ForEachColumnOf(t,
          [&](int x, int y, const std::array<double, 3>& w)
          {
            const auto found = numbers.find({ x, y });
            if (isIn && (found == numbers.end() || !this->HasLayer(layer, { x, y })))
            {
              wrong = "a column without the layer in it";
              return;
            }
            for (std::size_t n = layer; n < layer + 2 && isIn; ++n)
            {
              const std::vector<double>& h = this->Plan.Heights[n];
              const double height = w[0] * h[t[0]] + w[1] * h[t[1]] + w[2] * h[t[2]];
              largest[n] = std::max(largest[n], std::abs(height - this->Result.Stack.Heights[n][found->second]));
              covered.insert({ x, y });
            }
          });
      });
    if (!wrong.empty())
    {
      return wrong;
    }
    return this->CompareWithBlocks(layer, area, volume, covered);
  }

  /// By the block that the middle of a triangle is in.
  bool IsInside(std::size_t layer, const std::array<std::size_t, 3>& t) const
  {
    const int x = this->At(t[0]).X + this->At(t[1]).X + this->At(t[2]).X;
    const int y = this->At(t[0]).Y + this->At(t[1]).Y + this->At(t[2]).Y;
    const Block block = { int(std::floor(x / 3.0)), int(std::floor(y / 3.0)) };
    const int partX = x - 3 * block.first;
    const int partY = y - 3 * block.second;
    const int missing = this->PartOf(layer, block);
    return missing == 4 || (missing == 0 && partX + partY >= 3) || (missing == 1 && partY >= partX) ||
      (missing == 2 && partX >= partY) || (missing == 3 && partX + partY <= 3);
  }

  std::string CompareWithBlocks(std::size_t layer, double area, double volume, const std::set<Column>& covered)
  {
    const ColumnNumbers numbers = this->NumberColumns();
    const double largest = this->LargestErrorOf(layer) + this->LargestErrorOf(layer + 1);
    std::set<Block> blocks;
    for (const auto& [column, number] : numbers)
    {
      blocks.insert({ column, { column.first - 1, column.second }, { column.first, column.second - 1 },
        { column.first - 1, column.second - 1 } });
    }
    double blockArea = 0.0;
    double blockVolume = 0.0;
    double slack = 0.0;
    for (const Block& block : blocks)
    {
      const int missing = this->PartOf(layer, block);
      const bool isWhole = LeftByCuts(this->Options.Cuts, block) == 4;
      this->Conflicts += isWhole && missing < 0 && this->Missing(layer, block) >= 0 ? 1 : 0;
      double sum = 0.0;
      std::array<double, 2> twists = { 0.0, 0.0 };
      for (int corner = 0; corner < 4 && missing >= 0; ++corner)
      {
        const Column column = CornerOf(block, corner);
        if (corner == missing)
        {
          continue;
        }
        if (covered.count(column) == 0)
        {
          return "a column of a layer outside it";
        }
        for (std::size_t n = 0; n < 2; ++n)
        {
          const double height = this->Result.Stack.Heights[layer + n][numbers.at(column)];
          sum += this->Sign * (n == 0 ? height : -height);
          twists[n] += corner == 0 || corner == 3 ? height : -height;
        }
      }
      const double own = missing < 0 ? 0.0 : missing == 4 ? 1.0 : 0.5;
      blockArea += own;
      blockVolume += own * sum / (missing == 4 ? 4.0 : 3.0);
      slack += own * largest + (missing == 4 ? 0.5 * (std::abs(twists[0]) + std::abs(twists[1])) : 0.0);
    }
    std::ostringstream text;
    if (area != blockArea || std::abs(volume - blockVolume) > slack + 1e-9 * (1.0 + blockVolume))
    {
      text << "layer " << layer << ": area " << area << " for " << blockArea << ", volume " << volume << " for "
           << blockVolume << " +- " << slack;
    }
    return text.str();
  }

  std::vector<std::set<Column>> Has; // by horizon
  int Conflicts = 0;
};
}

#endif
