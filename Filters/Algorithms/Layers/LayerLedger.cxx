// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerPlan.h"

#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/Decimation/TriangleRows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
LedgerEntry EntryOfOrigin(HeightOrigin top, HeightOrigin base)
{
  const auto isAny = [&](HeightOrigin origin) { return top == origin || base == origin; };
  return Follows(top) || Follows(base) || isAny(HeightOrigin::ExtrapolatedBefore) ? LedgerEntry::Extrapolated
    : isAny(HeightOrigin::Bridged)                                                ? LedgerEntry::Bridged
    : isAny(HeightOrigin::Filled) || isAny(HeightOrigin::FilledBefore)            ? LedgerEntry::Filled
                                                                                  : LedgerEntry::Known;
}

class LedgerMaker
{
public:
  LedgerMaker(const LayerPlan& plan, const OrderedStack& stack, const std::vector<HorizonView>& horizons,
    const std::vector<ColumnIndex>& indices)
    : Plan(plan)
    , Stack(stack)
    , Horizons(horizons)
    , Indices(indices)
    , Index(stack.Columns)
    , Covers(plan.IsIn.empty() ? 1 : plan.IsIn.size(), { std::vector<unsigned char>(stack.Columns.size(), 0), {} })
  {
  }

  LayerLedgers Run(const Monitor& monitor)
  {
    this->CoverAll(monitor.Step(0.0, 0.7));
    const auto horizons = double(this->Horizons.size());
    LayerLedgers result;
    for (std::size_t layer = 0; layer + 1 < this->Horizons.size(); ++layer)
    {
      result.OfLayers.push_back(this->LedgerOfLayer(layer));
      monitor.Progress(0.7 + 0.15 * double(layer + 1) / horizons);
    }
    for (std::size_t horizon = 0; horizon < this->Horizons.size(); ++horizon)
    {
      this->AddHorizon(horizon, result);
      monitor.Progress(0.85 + 0.15 * double(horizon + 1) / horizons);
    }
    return result;
  }

private:
  /// A column that the stack does not have, below a triangle.
  struct BridgedColumn
  {
    PlanePoint Column;
    std::size_t Triangle;

    friend bool operator<(const BridgedColumn& a, const BridgedColumn& b)
    {
      return std::tie(a.Column.Y, a.Column.X, a.Triangle) < std::tie(b.Column.Y, b.Column.X, b.Triangle);
    }
  };

  using BridgedColumns = std::vector<BridgedColumn>; // in order, each column once

  struct Cover
  {
    std::vector<unsigned char> IsCovered; // by column of the stack
    BridgedColumns Bridged;
  };

  static void Sort(BridgedColumns& columns)
  {
    std::sort(columns.begin(), columns.end());
    const auto areSame = [](const BridgedColumn& a, const BridgedColumn& b) { return a.Column == b.Column; };
    columns.erase(std::unique(columns.begin(), columns.end(), areSame), columns.end());
  }

  /// Layers share one cover where all of them are everywhere.
  const Cover& CoverOf(std::size_t layer) const { return this->Covers[std::min(layer, this->Covers.size() - 1)]; }

  void CoverAll(const Monitor& monitor)
  {
    constexpr std::size_t StepOfProgress = 1 << 12;
    for (std::size_t triangle = 0; triangle < this->Plan.NumberOfTriangles(); ++triangle)
    {
      if (triangle % StepOfProgress == 0)
      {
        monitor.Progress(double(triangle) / double(this->Plan.NumberOfTriangles()));
      }
      ForEachRow(this->Plan.CornersOf(triangle),
        [&](std::int32_t y, std::int32_t first, std::int32_t last)
        {
          for (std::int32_t x = first; x <= last; ++x)
          {
            this->CoverColumn({ x, y }, triangle);
          }
        });
    }
    for (Cover& cover : this->Covers)
    {
      Sort(cover.Bridged);
    }
  }

  void CoverColumn(const PlanePoint& column, std::size_t triangle)
  {
    const PointId point = this->Index.PointAt(column);
    for (std::size_t n = 0; n < this->Covers.size(); ++n)
    {
      if (this->Plan.HasLayer(n, triangle) && point == NoPoint)
      {
        this->Covers[n].Bridged.push_back({ column, triangle });
      }
      else if (this->Plan.HasLayer(n, triangle))
      {
        this->Covers[n].IsCovered[std::size_t(point)] = 1;
      }
    }
  }

  LayerLedger LedgerOfLayer(std::size_t layer) const
  {
    LayerLedger ledger;
    const auto add = [&ledger](LedgerEntry entry, double thickness)
    {
      ++ledger.Columns[entry];
      ledger.Volumes[std::size_t(entry)] += thickness;
    };
    LeftOutColumns missing;
    const auto miss = [&](const PlanePoint& column, double thickness)
    {
      add(LedgerEntry::LeftOut, thickness);
      missing.Columns.push_back(column);
      missing.Thickness.push_back(thickness);
    };
    const Cover& cover = this->CoverOf(layer);
    for (std::size_t point = 0; point < this->Stack.Columns.size(); ++point)
    {
      const std::optional<double> thickness = this->ThicknessAt(layer, point);
      if (thickness && cover.IsCovered[point] != 0)
      {
        add(EntryOfOrigin(this->Stack.Origins[layer][point], this->Stack.Origins[layer + 1][point]), *thickness);
      }
      else if (thickness)
      {
        miss(this->Stack.Columns[point], *thickness);
      }
    }
    for (const BridgedColumn& column : cover.Bridged)
    {
      add(EntryOfOrigin(this->OriginAt(layer, column), this->OriginAt(layer + 1, column)),
        this->ThicknessIn(layer, column));
    }
    const LeftOutColumns& leftOut = this->Stack.LeftOut[layer];
    for (std::size_t n = 0; n < leftOut.Columns.size(); ++n)
    {
      const PointId point = this->Index.PointAt(leftOut.Columns[n]); // where the stack was completed there
      const bool isDone = point != NoPoint && this->ThicknessAt(layer, std::size_t(point));
      if (!isDone && !IsCovered(cover, leftOut.Columns[n], point))
      {
        miss(leftOut.Columns[n], leftOut.Thickness[n]);
      }
    }
    const ColumnIndex index(missing.Columns);
    for (std::size_t n = 0; n < missing.Columns.size(); ++n)
    {
      for (std::int32_t corner = 0; corner < 4; ++corner)
      {
        this->MeasureBlock(layer, missing, index, n, corner, ledger);
      }
    }
    return ledger;
  }

  static bool IsCovered(const Cover& cover, const PlanePoint& column, PointId point)
  {
    const auto found = std::lower_bound(cover.Bridged.begin(), cover.Bridged.end(), BridgedColumn{ column, 0 });
    return point != NoPoint ? cover.IsCovered[std::size_t(point)] != 0
                            : found != cover.Bridged.end() && found->Column == column;
  }

  /// The origin in a column that the stack does not have.
  HeightOrigin OriginAt(std::size_t horizon, const BridgedColumn& column) const
  {
    const PointId point = this->Indices[horizon].PointAt(column.Column);
    return this->Horizons[horizon].Knows(point) ? ReadOrigin(this->Horizons[horizon], point) : HeightOrigin::Bridged;
  }

  /// None where a horizon has no height.
  std::optional<double> ThicknessAt(std::size_t layer, std::size_t point) const
  {
    const double thickness = std::abs(this->Stack.Heights[layer][point] - this->Stack.Heights[layer + 1][point]);
    return std::isnan(thickness) ? std::nullopt : std::optional<double>(thickness);
  }

  double ThicknessIn(std::size_t layer, const BridgedColumn& column) const
  {
    const auto [a, b, c] = this->Plan.CornersOf(column.Triangle);
    const std::array<std::int64_t, 3> parts = { SignedArea(column.Column, b, c), SignedArea(a, column.Column, c),
      SignedArea(a, b, column.Column) };
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      sum += double(parts[corner]) * this->Plan.Thickness(layer, this->Plan.Triangles[3 * column.Triangle + corner]);
    }
    return sum / double(SignedArea(a, b, c));
  }

  /// Adds the block (LayerRegions.h) of which a missing column is the corner `own`, unless an earlier one is missing.
  void MeasureBlock(std::size_t layer, const LeftOutColumns& missing, const ColumnIndex& index, std::size_t n,
    std::int32_t own, LayerLedger& ledger) const
  {
    const PlanePoint least = { missing.Columns[n].X - (own & 1), missing.Columns[n].Y - (own >> 1) };
    std::array<std::optional<double>, 4> thickness;
    int missed = 0; // bits of corners
    int there = 0;
    for (std::int32_t corner = 0; corner < 4; ++corner)
    {
      const PlanePoint column = { least.X + (corner & 1), least.Y + (corner >> 1) };
      const PointId other = index.PointAt(column);
      const PointId point = this->Index.PointAt(column);
      if (other != NoPoint)
      {
        missed |= 1 << corner;
        thickness[std::size_t(corner)] = missing.Thickness[std::size_t(other)];
      }
      else if (point != NoPoint)
      {
        thickness[std::size_t(corner)] = this->ThicknessAt(layer, std::size_t(point));
      }
      there += thickness[std::size_t(corner)] ? 1 : 0;
    }
    if ((missed & ((1 << own) - 1)) != 0 || there < 3)
    {
      return;
    }
    // Cells have the other half of a block with a single missing corner.
    const bool isHalf = there == 4 && missed == 1 << own;
    const double area = there == 3 || isHalf ? 0.5 : 1.0;
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const bool isOpposite = isHalf && corner == std::size_t(3 - own);
      sum += isOpposite ? 0.0 : thickness[corner].value_or(0.0);
    }
    ledger.AreaWithout += area;
    ledger.VolumeWithout += area * sum / (area < 1.0 ? 3.0 : 4.0);
  }

  void AddHorizon(std::size_t horizon, LayerLedgers& ledgers) const
  {
    const HorizonView& own = this->Horizons[horizon];
    Ledger ledger;
    auto outside = std::int64_t(own.NumberOfKnown());
    for (PointId point = 0; point < PointId(own.NumberOfKnown()); ++point)
    {
      ledger[LedgerEntry::LeftOut] += ReadOrigin(own, point) == HeightOrigin::Known ? 1 : 0;
    }
    const auto add = [&](HeightOrigin origin)
    {
      ++ledger[EntryOfOrigin(origin, origin)];
      ledger[LedgerEntry::LeftOut] -= origin == HeightOrigin::Known ? 1 : 0;
      outside -= IsRead(origin) ? 1 : 0;
    };
    const Cover& above = this->CoverOf(horizon > 0 ? horizon - 1 : 0);
    const Cover& below = this->CoverOf(std::min(horizon, this->Horizons.size() - 2));
    for (std::size_t point = 0; point < this->Stack.Columns.size(); ++point)
    {
      const HeightOrigin origin = this->Stack.Origins[horizon][point];
      if (origin != HeightOrigin::None && (above.IsCovered[point] | below.IsCovered[point]) != 0)
      {
        add(origin);
      }
    }
    BridgedColumns bridged = above.Bridged;
    if (&below != &above)
    {
      bridged.insert(bridged.end(), below.Bridged.begin(), below.Bridged.end());
      Sort(bridged);
    }
    for (const BridgedColumn& column : bridged)
    {
      add(this->OriginAt(horizon, column));
    }
    ledgers.OfHorizons.push_back(ledger);
    ledgers.PointsOutside.push_back(outside);
  }

  const LayerPlan& Plan;
  const OrderedStack& Stack;
  const std::vector<HorizonView>& Horizons;
  const std::vector<ColumnIndex>& Indices; // of the horizons
  const ColumnIndex Index; // of the stack
  std::vector<Cover> Covers; // by layer, or one for all
};
}

//----------------------------------------------------------------------------------------------------------------------
LayerLedgers MakeLayerLedgers(const LayerPlan& plan, const OrderedStack& stack,
  const std::vector<HorizonView>& horizons, const std::vector<ColumnIndex>& indices, const Monitor& monitor)
{
  assert(indices.size() == horizons.size() && HaveAll(stack.Heights, stack.Columns.size()));
  return LedgerMaker(plan, stack, horizons, indices).Run(monitor);
}
}
