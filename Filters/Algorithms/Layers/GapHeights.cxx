// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapHeights.h"

#include "Common/ColumnIndex.h"
#include "Common/Parallel.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
namespace
{
class GapHeights
{
public:
  GapHeights(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns)
    : Horizon(horizon)
    , Cuts(cuts)
    , Columns(columns)
    , Known(horizon.Columns)
    , Missing(columns)
  {
  }

  /// Puts a height in where there is nan.
  void Fill(std::vector<double>& heights)
  {
    std::vector<std::size_t> waiting;
    for (std::size_t n = 0; n < heights.size(); ++n)
    {
      if (std::isnan(heights[n]))
      {
        waiting.push_back(n);
      }
    }
    const auto fill = [&](bool areSides)
    {
      for (std::size_t before = waiting.size() + 1; !waiting.empty() && waiting.size() < before;)
      {
        before = waiting.size();
        this->FillOnce(waiting, areSides, heights);
      }
    };
    fill(true);
    fill(false);
    this->Cuts = nullptr; // of what is between cuts
    fill(false);
  }

private:
  struct Found
  {
    double Height = std::nan("");
    double Distance = 0.0;
  };

  void FillOnce(std::vector<std::size_t>& waiting, bool areSides, std::vector<double>& heights) const
  {
    std::vector<double> found(waiting.size());
    ParallelFor(std::int64_t(waiting.size()), GapGrain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto n = std::size_t(first); n < std::size_t(last); ++n)
        {
          found[n] = this->HeightAt(this->Columns[waiting[n]], areSides, heights);
        }
      });
    std::vector<std::size_t> left;
    for (std::size_t n = 0; n < waiting.size(); ++n)
    {
      heights[waiting[n]] = found[n];
      if (std::isnan(found[n]))
      {
        left.push_back(waiting[n]);
      }
    }
    waiting.swap(left);
  }

  double HeightAt(const PlanePoint& column, bool areSides, const std::vector<double>& heights) const
  {
    double sum = 0.0;
    double weights = 0.0;
    const auto add = [&](double height, double distance)
    {
      sum += height / distance;
      weights += 1.0 / distance;
    };
    for (const PlanePoint& step : { PlanePoint{ 1, 0 }, PlanePoint{ 0, 1 }, PlanePoint{ 1, 1 }, PlanePoint{ 1, -1 } })
    {
      const double length = step.X != 0 && step.Y != 0 ? std::sqrt(2.0) : 1.0;
      const Found a = this->Look(column, step, heights);
      const Found b = this->Look(column, { -step.X, -step.Y }, heights);
      const bool areBoth = !std::isnan(a.Height) && !std::isnan(b.Height);
      if (areBoth)
      {
        add((a.Height * b.Distance + b.Height * a.Distance) / (a.Distance + b.Distance),
          length * (a.Distance + b.Distance));
      }
      for (const Found& one : { a, b })
      {
        if (!areSides && !areBoth && !std::isnan(one.Height))
        {
          add(one.Height, length * one.Distance);
        }
      }
    }
    return sum / weights; // nan where nothing was found
  }

  /// The nearest height in a direction.
  Found Look(PlanePoint column, const PlanePoint& step, const std::vector<double>& heights) const
  {
    for (int distance = 1; distance <= Farthest && !this->IsCut(column, step); ++distance)
    {
      column = { column.X + step.X, column.Y + step.Y };
      const PointId known = this->Known.PointAt(column);
      if (known != NoPoint)
      {
        return { this->Horizon.Heights[known], double(distance) };
      }
      const PointId filled = this->Missing.PointAt(column);
      if (filled != NoPoint && !std::isnan(heights[std::size_t(filled)]))
      {
        return { heights[std::size_t(filled)], double(distance) };
      }
    }
    return {};
  }

  bool IsCut(const PlanePoint& column, const PlanePoint& step) const
  {
    return this->Cuts && this->Cuts->IsCutBeside(column, step);
  }

  static constexpr int Farthest = 256; // columns
  static constexpr std::int64_t GapGrain = 1024; // columns that a thread takes at a time

  const HorizonView& Horizon;
  const LinkCuts* Cuts;
  PlanePoints Columns;
  const ColumnIndex Known;
  const ColumnIndex Missing;
};
}

//----------------------------------------------------------------------------------------------------------------------
void FillGaps(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns, std::vector<double>& heights)
{
  GapHeights(horizon, cuts, columns).Fill(heights);
}
}
