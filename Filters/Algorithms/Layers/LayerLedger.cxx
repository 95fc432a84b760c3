// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerLedger.h"

#include "Common/ColumnIndex.h"
#include "Common/Predicates.h"
#include "Decimation/TriangleRows.h"
#include "LayerPlan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Of a column that is covered.
LedgerEntry EntryOf(HeightOrigin top, HeightOrigin base)
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
  LedgerMaker(const LayerPlan& plan, const OrderedStack& stack, const std::vector<HorizonView>& horizons)
    : Horizons(horizons)
    , Plan(plan)
    , Stack(stack)
    , Index(stack.Columns)
    , IsCovered(plan.IsIn.empty() ? 1 : plan.IsIn.size(), std::vector<unsigned char>(stack.Columns.size(), 0))
    , Bridged(this->IsCovered.size())
  {
  }

  LayerLedgers Run(const Monitor& monitor)
  {
    this->Cover(monitor.Step(0.0, 0.7));
    const bool isAnyBridged = std::any_of(
      this->Bridged.begin(), this->Bridged.end(), [](const std::vector<BridgedColumn>& own) { return !own.empty(); });
    for (std::size_t horizon = 0; horizon < this->Horizons.size() && isAnyBridged; ++horizon)
    {
      this->OwnColumns.emplace_back(this->Horizons[horizon].Columns);
    }
    const auto horizons = double(this->Horizons.size());
    LayerLedgers result;
    for (std::size_t layer = 0; layer + 1 < this->Stack.Heights.size(); ++layer)
    {
      result.OfLayers.push_back(this->LedgerOfLayer(layer));
      monitor.Progress(0.7 + 0.15 * double(layer + 1) / horizons);
    }
    for (std::size_t horizon = 0; horizon < this->Stack.Heights.size(); ++horizon)
    {
      result.OfHorizons.push_back(this->LedgerOfHorizon(horizon));
      monitor.Progress(0.85 + 0.15 * double(horizon + 1) / horizons);
    }
    return result;
  }

private:
  /// A column that the stack does not have, and a triangle over it.
  struct BridgedColumn
  {
    PlanePoint Column;
    std::size_t Triangle;

    friend bool operator<(const BridgedColumn& a, const BridgedColumn& b)
    {
      return std::tie(a.Column.Y, a.Column.X, a.Triangle) < std::tie(b.Column.Y, b.Column.X, b.Triangle);
    }
    friend bool operator==(const BridgedColumn& a, const BridgedColumn& b) { return a.Column == b.Column; }
  };

  /// Columns, by the index, in which a layer is missing, and what it would have there.
  struct MissingColumns
  {
    std::vector<PlanePoint> Columns;
    std::vector<double> Thickness;
    std::optional<ColumnIndex> Index; // of these
  };

  /// Layers that are all alike share one list.
  std::size_t ListOf(std::size_t layer) const { return std::min(layer, this->IsCovered.size() - 1); }

  std::array<PlanePoint, 3> CornersOf(std::size_t triangle) const
  {
    const auto at = [&](std::size_t corner)
    { return this->Plan.Columns[std::size_t(this->Plan.Triangles[3 * triangle + corner])]; };
    return { at(0), at(1), at(2) };
  }

  void Cover(const Monitor& monitor)
  {
    constexpr std::size_t StepOfProgress = 1 << 12;
    for (std::size_t triangle = 0; triangle < this->Plan.NumberOfTriangles(); ++triangle)
    {
      if (triangle % StepOfProgress == 0)
      {
        monitor.Progress(double(triangle) / double(this->Plan.NumberOfTriangles()));
      }
      ForEachRow(this->CornersOf(triangle),
        [&](std::int32_t y, std::int32_t first, std::int32_t last)
        {
          for (std::int32_t x = first; x <= last; ++x)
          {
            this->CoverColumn({ x, y }, triangle);
          }
        });
    }
    for (std::vector<BridgedColumn>& own : this->Bridged)
    {
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
    }
  }

  void CoverColumn(const PlanePoint& column, std::size_t triangle)
  {
    const PointId point = this->Index.PointAt(column);
    for (std::size_t list = 0; list < this->IsCovered.size(); ++list)
    {
      if (!this->Plan.HasLayer(list, triangle))
      {
        continue;
      }
      if (point == NoPoint)
      {
        this->Bridged[list].push_back({ column, triangle });
      }
      else
      {
        this->IsCovered[list][std::size_t(point)] = 1;
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
    MissingColumns missing;
    const auto miss = [&](const PlanePoint& column, double thickness)
    {
      add(LedgerEntry::LeftOut, thickness);
      missing.Columns.push_back(column);
      missing.Thickness.push_back(thickness);
    };
    const std::size_t list = this->ListOf(layer);
    for (std::size_t point = 0; point < this->Stack.Columns.size(); ++point)
    {
      const std::optional<double> thickness = this->ThicknessAt(layer, point);
      if (thickness && this->IsCovered[list][point] != 0)
      {
        add(EntryOf(this->Stack.Origins[layer][point], this->Stack.Origins[layer + 1][point]), *thickness);
      }
      else if (thickness)
      {
        miss(this->Stack.Columns[point], *thickness);
      }
    }
    for (const BridgedColumn& column : this->Bridged[list])
    {
      add(EntryOf(this->OriginAt(layer, column), this->OriginAt(layer + 1, column)), this->ThicknessIn(layer, column));
    }
    const LeftOutColumns& leftOut = this->Stack.LeftOut[layer];
    for (std::size_t n = 0; n < leftOut.Columns.size(); ++n)
    {
      const PointId point = this->Index.PointAt(leftOut.Columns[n]); // of the stack where it was completed there
      const bool isDone = point != NoPoint && this->ThicknessAt(layer, std::size_t(point));
      if (!isDone && !this->IsIn(list, leftOut.Columns[n]))
      {
        miss(leftOut.Columns[n], leftOut.Thickness[n]);
      }
    }
    missing.Index.emplace(missing.Columns);
    this->MeasureMissing(layer, missing, ledger);
    return ledger;
  }

  /// Of a column that the stack does not have, as not all horizons do.
  HeightOrigin OriginAt(std::size_t horizon, const BridgedColumn& column) const
  {
    const PointId point = this->OwnColumns[horizon].PointAt(column.Column);
    return point == NoPoint ? HeightOrigin::Bridged : ReadOrigin(this->Horizons[horizon], point);
  }

  /// Where both horizons have a height.
  std::optional<double> ThicknessAt(std::size_t layer, std::size_t point) const
  {
    const double thickness = std::abs(this->Stack.Heights[layer][point] - this->Stack.Heights[layer + 1][point]);
    return std::isnan(thickness) ? std::nullopt : std::optional<double>(thickness);
  }

  /// Of the plan.
  double ThicknessIn(std::size_t layer, const BridgedColumn& column) const
  {
    const auto [a, b, c] = this->CornersOf(column.Triangle);
    const std::array<std::int64_t, 3> parts = { SignedArea(column.Column, b, c), SignedArea(a, column.Column, c),
      SignedArea(a, b, column.Column) };
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      sum += double(parts[corner]) * this->Plan.Thickness(layer, this->Plan.Triangles[3 * column.Triangle + corner]);
    }
    return sum / double(SignedArea(a, b, c));
  }

  /// Whether a list covers a column.
  bool IsIn(std::size_t list, const PlanePoint& column) const
  {
    const PointId point = this->Index.PointAt(column);
    return point != NoPoint
      ? this->IsCovered[list][std::size_t(point)] != 0
      : std::binary_search(this->Bridged[list].begin(), this->Bridged[list].end(), BridgedColumn{ column, 0 },
          [](const BridgedColumn& a, const BridgedColumn& b)
          { return std::tie(a.Column.Y, a.Column.X) < std::tie(b.Column.Y, b.Column.X); });
  }

  /// In blocks of four columns, and halves of blocks of three (LayerRegions.h).
  void MeasureMissing(std::size_t layer, const MissingColumns& missing, LayerLedger& ledger) const
  {
    for (std::size_t n = 0; n < missing.Columns.size(); ++n)
    {
      for (std::int32_t corner = 0; corner < 4; ++corner) // that the column is of a block
      {
        const PlanePoint& column = missing.Columns[n];
        this->MeasureBlock(layer, missing, { column.X - (corner & 1), column.Y - (corner >> 1) }, corner, ledger);
      }
    }
  }

  /// A block counts once, for the first of its corners that are missing.
  void MeasureBlock(std::size_t layer, const MissingColumns& missing, const PlanePoint& least, std::int32_t own,
    LayerLedger& ledger) const
  {
    std::array<std::optional<double>, 4> thickness;
    int missed = 0; // corners, with bits
    int there = 0;
    for (std::int32_t corner = 0; corner < 4; ++corner)
    {
      const PlanePoint column = { least.X + (corner & 1), least.Y + (corner >> 1) };
      const PointId other = missing.Index->PointAt(column);
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
    // Of a block with a single missing corner, cells have the other half.
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

  Ledger LedgerOfHorizon(std::size_t horizon) const
  {
    Ledger ledger;
    const HorizonView& own = this->Horizons[horizon];
    std::int64_t leftOut = 0;
    for (std::size_t point = 0; point < own.Columns.size(); ++point)
    {
      leftOut += ReadOrigin(own, PointId(point)) == HeightOrigin::Known ? 1 : 0;
    }
    const auto add = [&](HeightOrigin origin)
    {
      ++ledger[EntryOf(origin, origin)];
      leftOut -= origin == HeightOrigin::Known ? 1 : 0;
    };
    const std::size_t layers = this->Stack.Heights.size() - 1;
    const std::size_t above = this->ListOf(horizon > 0 ? horizon - 1 : 0);
    const std::size_t below = this->ListOf(std::min(horizon, layers - 1));
    for (std::size_t point = 0; point < this->Stack.Columns.size(); ++point)
    {
      const HeightOrigin origin = this->Stack.Origins[horizon][point];
      if (origin != HeightOrigin::None && (this->IsCovered[above][point] | this->IsCovered[below][point]) != 0)
      {
        add(origin);
      }
    }
    std::vector<BridgedColumn> bridged = this->Bridged[above];
    if (below != above)
    {
      bridged.insert(bridged.end(), this->Bridged[below].begin(), this->Bridged[below].end());
      std::sort(bridged.begin(), bridged.end());
    }
    bridged.erase(std::unique(bridged.begin(), bridged.end()), bridged.end());
    for (const BridgedColumn& column : bridged)
    {
      add(this->OriginAt(horizon, column));
    }
    ledger[LedgerEntry::LeftOut] = leftOut;
    return ledger;
  }

  const std::vector<HorizonView>& Horizons;
  const LayerPlan& Plan;
  const OrderedStack& Stack;
  const ColumnIndex Index;
  std::vector<ColumnIndex> OwnColumns; // of the horizons, where they are needed
  std::vector<std::vector<unsigned char>> IsCovered; // by layer, or for all: 1 for columns of the stack
  std::vector<std::vector<BridgedColumn>> Bridged; // by layer, or for all, in order
};
}

//----------------------------------------------------------------------------------------------------------------------
LayerLedgers MakeLayerLedgers(
  const LayerPlan& plan, const OrderedStack& stack, const std::vector<HorizonView>& horizons, const Monitor& monitor)
{
  return LedgerMaker(plan, stack, horizons).Run(monitor);
}
}
