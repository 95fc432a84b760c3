// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnOrder.h"

#include "Common/ColumnSheets.h"
#include "Common/TextWords.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{
/// The attribute that policies look at, or null.
const std::vector<double>* FindAmplitude(const PickTable& picks)
{
  const auto found = std::find_if(picks.Attributes.begin(), picks.Attributes.end(),
    [](const PickAttribute& attribute) { return ToLower(attribute.Name) == "amplitude"; });
  return found == picks.Attributes.end() ? nullptr : &found->Values;
}

/// Says which of two picks in one column stays.
class Preference
{
public:
  Preference(const PickTable& picks, const PlacementOptions& options)
    : Z(picks.Z)
    , Amplitude(options.Policy == DuplicatePolicy::StrongestAmplitude ? FindAmplitude(picks) : nullptr)
    , PrefersSmallZ((options.Direction == VerticalDirection::Down) == (options.Policy != DuplicatePolicy::Lowest))
  {
  }

  bool Prefers(std::int32_t pick, std::int32_t other) const
  {
    const double strength = this->Strength(pick);
    const double otherStrength = this->Strength(other);
    if (strength != otherStrength)
    {
      return strength > otherStrength;
    }
    const double z = this->Z[std::size_t(pick)];
    const double otherZ = this->Z[std::size_t(other)];
    return this->PrefersSmallZ ? z < otherZ : z > otherZ;
  }

private:
  /// 0 where there is no amplitude.
  double Strength(std::int32_t pick) const
  {
    const double strength = this->Amplitude ? std::abs((*this->Amplitude)[std::size_t(pick)]) : 0.0;
    return std::isnan(strength) ? 0.0 : strength;
  }

  const std::vector<double>& Z;
  const std::vector<double>* const Amplitude;
  const bool PrefersSmallZ;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<ColumnOrder> ListPicks(const PickTable& picks)
{
  std::vector<ColumnOrder> lists(picks.Names.size());
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    ColumnOrder& list = lists[picks.Horizon.empty() ? 0 : std::size_t(picks.Horizon[pick])];
    if (std::isnan(picks.Z[pick]))
    {
      ++list.Nulls;
      continue;
    }
    list.Picks.push_back(std::int32_t(pick));
  }
  return lists;
}

//----------------------------------------------------------------------------------------------------------------------
void OrderPicks(
  ColumnOrder& order, const PickTable& picks, const std::vector<PlanePoint>& columns, const PlacementOptions& options)
{
  const auto column = [&columns](std::int32_t pick) { return std::make_pair(columns[pick].Y, columns[pick].X); };
  const Preference preference(picks, options);
  const bool keepsAll = options.Policy == DuplicatePolicy::Sheets;
  const auto isBefore = [&](std::int32_t a, std::int32_t b)
  {
    const auto columnA = column(a);
    const auto columnB = column(b);
    return columnA < columnB || (keepsAll && columnA == columnB && preference.Prefers(a, b));
  };
  // Files are often in this order already. Equal picks keep theirs, so that the first of them stays.
  if (!std::is_sorted(order.Picks.begin(), order.Picks.end(), isBefore))
  {
    std::stable_sort(order.Picks.begin(), order.Picks.end(), isBefore);
  }
  std::size_t kept = 0;
  for (const std::int32_t pick : order.Picks)
  {
    const bool isFirst = kept == 0 || column(order.Picks[kept - 1]) != column(pick);
    if (isFirst || (keepsAll && picks.Z[std::size_t(order.Picks[kept - 1])] != picks.Z[std::size_t(pick)]))
    {
      order.Picks[kept++] = pick;
      continue;
    }
    ++order.Duplicates;
    if (preference.Prefers(pick, order.Picks[kept - 1]))
    {
      order.Picks[kept - 1] = pick;
    }
  }
  order.Picks.resize(kept);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<ColumnOrder> SplitIntoSheets(
  ColumnOrder order, const PickTable& picks, const std::vector<PlanePoint>& columns)
{
  const ColumnSheets split = SplitIntoSheets(
    Gather<std::vector<PlanePoint>>(columns, order.Picks), Gather<std::vector<double>>(picks.Z, order.Picks));
  std::vector<ColumnOrder> sheets;
  for (const std::vector<std::int32_t>& points : split.Points)
  {
    sheets.push_back({ Gather<std::vector<std::int32_t>>(order.Picks, points) });
  }
  sheets.front().Duplicates = order.Duplicates + split.Dropped;
  sheets.front().Nulls = order.Nulls;
  return sheets;
}
}
