// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of the plan of a stack, checked with none of the code that makes it: from the horizons and the
// result alone.

#ifndef SeismicHorizonsPlanChecker_h
#define SeismicHorizonsPlanChecker_h

#include "ClosedBodies.h"
#include "LayerLattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace LayerChecker
{
using ClosedBodies::Point;

class PlanChecker
{
public:
  PlanChecker(const std::vector<Horizon>& horizons, const Layers& layers, const LayerOptions& options)
    : Horizons(horizons)
    , Result(layers)
    , Plan(layers.Plan)
    , Options(options)
    , Sign(options.Crossings.HeightsGrowDownwards ? -1.0 : 1.0)
  {
  }

  /// What is wrong with the plan first; empty when nothing is.
  std::string CheckPlan() const
  {
    std::string wrong = this->CheckStack();
    wrong = wrong.empty() ? this->CheckTriangles() : wrong;
    wrong = wrong.empty() ? this->CheckPointsOutside() : wrong;
    return wrong.empty() ? this->CheckBound() : wrong;
  }

  /// Columns where a layer has no thickness, and of them those where the plan has one.
  std::array<std::int64_t, 2> CountGhosts(std::size_t layer) const
  {
    std::set<Column> pinched;
    for (std::size_t n = 0; n < this->Result.Stack.Columns.size(); ++n)
    {
      if (this->Result.Stack.Heights[layer][n] == this->Result.Stack.Heights[layer + 1][n])
      {
        pinched.insert({ this->Result.Stack.Columns[n].X, this->Result.Stack.Columns[n].Y });
      }
    }
    std::set<Column> ghosts;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        this->ForEachColumnOf(t,
          [&](int x, int y, const std::array<double, 3>& weights)
          {
            double thickness = 0.0;
            for (std::size_t corner = 0; corner < 3; ++corner)
            {
              thickness += weights[corner] * this->Between(layer, t[corner]);
            }
            if (thickness > 0.0 && pinched.count({ x, y }) > 0)
            {
              ghosts.insert({ x, y });
            }
          });
      });
    return { std::int64_t(pinched.size()), std::int64_t(ghosts.size()) };
  }

protected:
  const PlanePoint& At(std::size_t vertex) const { return this->Plan.Columns[vertex]; }
  double Between(std::size_t layer, std::size_t vertex) const
  {
    return this->Sign * (this->Plan.Heights[layer][vertex] - this->Plan.Heights[layer + 1][vertex]);
  }
  Point PointAt(std::size_t vertex, double height) const
  {
    return { double(this->At(vertex).X), double(this->At(vertex).Y), height };
  }

  template <typename Visitor>
  void ForEachTriangle(Visitor&& visit) const
  {
    for (std::size_t n = 0; n + 2 < this->Plan.Triangles.size(); n += 3)
    {
      visit({ std::size_t(this->Plan.Triangles[n]), std::size_t(this->Plan.Triangles[n + 1]),
        std::size_t(this->Plan.Triangles[n + 2]) });
    }
  }

  /// Those in a triangle and on its sides, with the weights of the corners, of which the sum is 1.
  template <typename Visitor>
  void ForEachColumnOf(const std::array<std::size_t, 3>& t, Visitor&& visit) const
  {
    const PlanePoint &a = this->At(t[0]), &b = this->At(t[1]), &c = this->At(t[2]);
    const auto area = double(Turn(a, b, c));
    for (int y = std::min({ a.Y, b.Y, c.Y }); y <= std::max({ a.Y, b.Y, c.Y }); ++y)
    {
      for (int x = std::min({ a.X, b.X, c.X }); x <= std::max({ a.X, b.X, c.X }); ++x)
      {
        const PlanePoint p{ x, y };
        if (Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0 && Turn(a, b, p) >= 0)
        {
          visit(x, y, { double(Turn(b, c, p)) / area, double(Turn(c, a, p)) / area, double(Turn(a, b, p)) / area });
        }
      }
    }
  }

  /// The stack has the columns that all have, and others with a horizon, in order, and heights of its own only where
  /// horizons cross or have no point.
  std::string CheckStack() const
  {
    std::map<Column, std::map<std::size_t, double>> given;
    for (std::size_t n = 0; n < this->Horizons.size(); ++n)
    {
      for (std::size_t point = 0; point < this->Horizons[n].Columns.size(); ++point)
      {
        const PlanePoint& column = this->Horizons[n].Columns[point];
        given[{ column.X, column.Y }][n] = this->Horizons[n].Heights[point];
      }
    }
    const OrderedStack& stack = this->Result.Stack;
    auto missing = std::count_if(
      given.begin(), given.end(), [&](const auto& entry) { return entry.second.size() == this->Horizons.size(); });
    std::size_t completed = 0;
    for (std::size_t n = 0; n < stack.Columns.size(); ++n)
    {
      const std::map<std::size_t, double>& own = given[{ stack.Columns[n].X, stack.Columns[n].Y }];
      missing -= own.size() == this->Horizons.size() ? 1 : 0;
      completed += own.size() == this->Horizons.size() ? 0 : 1;
      bool isInOrder = !own.empty();
      bool isAsGiven = true;
      for (auto next = own.begin(); next != own.end(); ++next)
      {
        const double below = next == own.begin() ? 0.0 : this->Sign * (std::prev(next)->second - next->second);
        isInOrder = isInOrder && below >= 0.0 && (below == 0.0 || below >= this->Options.Crossings.MinimumThickness);
        isAsGiven = isAsGiven && stack.Heights[next->first][n] == next->second;
      }
      for (std::size_t horizon = 1; horizon < this->Horizons.size(); ++horizon)
      {
        if (!(this->Sign * (stack.Heights[horizon - 1][n] - stack.Heights[horizon][n]) >= 0.0))
        {
          return "stack is not in order";
        }
      }
      if (own.empty() || (isInOrder && !isAsGiven))
      {
        return own.empty() ? "a column without a horizon" : "heights moved where nothing crosses";
      }
    }
    return missing == 0 && completed == stack.Completed ? "" : "wrong number of common columns";
  }

  /// Of points of horizons in columns that the stack does not have: infinite for those inside the plan, and for those
  /// on its outline how far they are from it.
  std::vector<double> ErrorsOnEdges() const
  {
    const ColumnNumbers numbers = this->NumberColumns();
    std::map<Column, std::map<std::size_t, double>> others;
    for (std::size_t n = 0; n < this->Horizons.size(); ++n)
    {
      for (std::size_t point = 0; point < this->Horizons[n].Columns.size(); ++point)
      {
        const PlanePoint& column = this->Horizons[n].Columns[point];
        if (numbers.count({ column.X, column.Y }) == 0)
        {
          others[{ column.X, column.Y }][n] = this->Horizons[n].Heights[point];
        }
      }
    }
    std::vector<double> errors(this->Horizons.size(), 0.0);
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        this->ForEachColumnOf(t,
          [&](int x, int y, const std::array<double, 3>& w)
          {
            const auto found = others.find({ x, y });
            if (found == others.end())
            {
              return;
            }
            for (const auto& [horizon, given] : found->second)
            {
              const std::vector<double>& h = this->Plan.Heights[horizon];
              const double error = std::abs(w[0] * h[t[0]] + w[1] * h[t[1]] + w[2] * h[t[2]] - given);
              const bool isInside = std::min({ w[0], w[1], w[2] }) > 0.0;
              errors[horizon] = std::max(errors[horizon], isInside ? HUGE_VAL : error);
            }
          });
      });
    return errors;
  }

  /// Points of horizons that no triangle of theirs has.
  std::string CheckPointsOutside() const
  {
    for (std::size_t n = 0; n < this->Horizons.size(); ++n)
    {
      std::set<Column> inside;
      std::size_t triangle = 0;
      this->ForEachTriangle(
        [&](const std::array<std::size_t, 3>& t)
        {
          const auto has = [&](std::size_t layer) {
            return layer + 1 < this->Horizons.size() &&
              (this->Plan.IsIn.empty() || this->Plan.IsIn[layer][triangle] != 0);
          };
          if (has(n) || (n > 0 && has(n - 1)))
          {
            this->ForEachColumnOf(t, [&](int x, int y, const std::array<double, 3>&) { inside.insert({ x, y }); });
          }
          ++triangle;
        });
      const PlanePoints points = this->Horizons[n].Columns;
      const auto outside = std::count_if(points.begin(), points.end(),
        [&](const PlanePoint& column) {
          return inside.count({ column.X, column.Y }) == 0;
        });
      if (outside != this->Result.Ledgers.PointsOutside[n])
      {
        return "horizon " + std::to_string(n) + " has " + std::to_string(outside) + " points outside, said " +
          std::to_string(this->Result.Ledgers.PointsOutside[n]);
      }
    }
    return "";
  }

  /// Triangles turn to the left, fit together, and no vertex lies in another triangle or on its sides.
  std::string CheckTriangles() const
  {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::set<Column> places;
    std::string wrong;
    for (const PlanePoint& place : this->Plan.Columns)
    {
      wrong = places.insert({ place.X, place.Y }).second ? wrong : "two vertices in one column";
    }
    std::vector<bool> isUsed(this->Plan.Columns.size(), false);
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        wrong = Turn(this->At(t[0]), this->At(t[1]), this->At(t[2])) > 0 ? wrong : "triangle not counter-clockwise";
        std::set<Column> corners;
        for (std::size_t n = 0; n < 3; ++n)
        {
          isUsed[t[n]] = true;
          corners.insert({ this->At(t[n]).X, this->At(t[n]).Y });
          wrong = edges.insert({ t[n], t[(n + 1) % 3] }).second ? wrong : "triangles on each other";
        }
        this->ForEachColumnOf(t,
          [&](int x, int y, const std::array<double, 3>&) {
            wrong = places.count({ x, y }) > 0 && corners.count({ x, y }) == 0 ? "vertex in a triangle" : wrong;
          });
      });
    for (const PointId vertex : this->Plan.FaultTriangles)
    {
      isUsed[std::size_t(vertex)] = true;
    }
    wrong = std::count(isUsed.begin(), isUsed.end(), false) == 0 ? wrong : "vertex without triangle";
    for (std::size_t horizon = 0; horizon + 1 < this->Horizons.size(); ++horizon)
    {
      for (std::size_t vertex = 0; vertex < this->Plan.Columns.size(); ++vertex)
      {
        wrong = this->Between(horizon, vertex) >= 0.0 ? wrong : "vertex not in order";
      }
    }
    return wrong;
  }

  using ColumnNumbers = std::map<Column, std::size_t>;

  /// The columns of the stack.
  ColumnNumbers NumberColumns() const
  {
    ColumnNumbers numbers;
    for (std::size_t n = 0; n < this->Result.Stack.Columns.size(); ++n)
    {
      numbers[{ this->Result.Stack.Columns[n].X, this->Result.Stack.Columns[n].Y }] = n;
    }
    return numbers;
  }

  /// Of all columns in triangles, each counted in one that it is strictly inside of, once.
  std::string CheckBound() const
  {
    const ColumnNumbers numbers = this->NumberColumns();
    std::vector<double> largest = this->ErrorsOnEdges();
    double thickness = 0.0;
    std::set<Column> inside;
    std::ostringstream text;
    this->ForEachTriangle(
      [&](const std::array<std::size_t, 3>& t)
      {
        this->ForEachColumnOf(t,
          [&](int x, int y, const std::array<double, 3>& w)
          {
            if (std::min({ w[0], w[1], w[2] }) > 0.0 && !inside.insert({ x, y }).second)
            {
              text << "column in two triangles; ";
            }
            const auto found = numbers.find({ x, y });
            double above = 0.0; // the error of the horizon above
            for (std::size_t n = 0; n < this->Horizons.size() && found != numbers.end(); ++n)
            {
              const std::vector<double>& h = this->Plan.Heights[n];
              const double height = w[0] * h[t[0]] + w[1] * h[t[1]] + w[2] * h[t[2]];
              const double error = height - this->Result.Stack.Heights[n][found->second];
              largest[n] = std::max(largest[n], std::abs(error));
              thickness = n > 0 ? std::max(thickness, std::abs(error - above)) : thickness;
              above = error;
            }
          });
      });
    for (std::size_t n = 0; n < this->Horizons.size(); ++n)
    {
      if (largest[n] > this->Options.MaximumError + 1e-9 || std::abs(largest[n] - this->Result.LargestErrors[n]) > 1e-9)
      {
        text << "horizon " << n << ": error " << largest[n] << ", said " << this->Result.LargestErrors[n] << ", bound "
             << this->Options.MaximumError << "; ";
      }
    }
    const std::vector<double>& said = this->Result.LargestThicknessErrors;
    const double saidThickness = said.empty() ? thickness : *std::max_element(said.begin(), said.end());
    if (thickness > (this->Options.BoundThickness ? 1.0 : 2.0) * this->Options.MaximumError + 1e-9 ||
      std::abs(thickness - saidThickness) > 1e-9)
    {
      text << "error of the thickness " << thickness << ", said " << saidThickness;
    }
    return text.str();
  }

  const std::vector<Horizon>& Horizons;
  const Layers& Result;
  const LayerPlan& Plan;
  const LayerOptions& Options;
  const double Sign; // heights upwards
};
}

#endif
