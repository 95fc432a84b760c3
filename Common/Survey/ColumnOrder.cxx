// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnOrder.h"

#include "ColumnSheets.h"
#include "Common/Text/TextWords.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
const std::vector<double>* FindAmplitude(const PickTable& picks)
{
  const auto found = std::find_if(picks.Attributes.begin(), picks.Attributes.end(),
    [](const PickAttribute& attribute) { return ToLower(attribute.Name) == "amplitude"; });
  return found == picks.Attributes.end() ? nullptr : &found->Values;
}

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
  double Strength(std::int32_t pick) const
  {
    const double strength = this->Amplitude ? std::abs((*this->Amplitude)[std::size_t(pick)]) : 0.0;
    return std::isnan(strength) ? 0.0 : strength;
  }

  const std::vector<double>& Z;
  const std::vector<double>* const Amplitude;
  const bool PrefersSmallZ;
};

using PickRun = std::vector<std::int32_t>::const_iterator;

std::size_t CountRepeats(const std::vector<double>& z, PickRun first, PickRun last)
{
  std::vector<double> values;
  std::transform(first, last, std::back_inserter(values), [&z](std::int32_t pick) { return z[std::size_t(pick)]; });
  std::sort(values.begin(), values.end());
  const auto end = std::unique(values.begin(), values.end());
  return std::size_t(values.end() - end);
}

/// The first pick gets the means of z and of each attribute, without null values.
void Average(PickTable& picks, PickRun first, PickRun last)
{
  const auto average = [&](std::vector<double>& values)
  {
    double base = std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0; // The mean of equal values is exact.
    double count = 0.0;
    for (auto pick = first; pick != last; ++pick)
    {
      const double value = values[std::size_t(*pick)];
      base = std::isnan(base) ? value : base;
      sum += std::isnan(value) ? 0.0 : value - base;
      count += std::isnan(value) ? 0.0 : 1.0;
    }
    values[std::size_t(*first)] = base + sum / count;
  };
  average(picks.Z);
  for (PickAttribute& attribute : picks.Attributes)
  {
    average(attribute.Values);
  }
}
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
  ColumnOrder& order, PickTable& picks, const std::vector<PlanePoint>& columns, const PlacementOptions& options)
{
  const auto column = [&columns](std::int32_t pick) { return std::make_pair(columns[pick].Y, columns[pick].X); };
  const Preference preference(picks, options);
  const bool keepsAll = options.Policy == DuplicatePolicy::Sheets;
  const bool isSorted = keepsAll || options.Policy == DuplicatePolicy::Mean; // Sums depend on the order.
  const auto isBefore = [&](std::int32_t a, std::int32_t b)
  {
    const auto columnA = column(a);
    const auto columnB = column(b);
    return columnA < columnB || (isSorted && columnA == columnB && preference.Prefers(a, b));
  };
  // Many files are sorted already. The sort is stable, so that the first of equal picks stays.
  if (!std::is_sorted(order.Picks.begin(), order.Picks.end(), isBefore))
  {
    std::stable_sort(order.Picks.begin(), order.Picks.end(), isBefore);
  }
  const auto z = [&picks](std::int32_t pick) { return picks.Z[std::size_t(pick)]; };
  auto kept = order.Picks.begin();
  for (auto first = order.Picks.begin(), last = first; first != order.Picks.end(); first = last)
  {
    last = std::find_if(first, order.Picks.end(), [&](std::int32_t pick) { return column(pick) != column(*first); });
    if (last - first == 1)
    {
      *kept++ = *first;
      continue;
    }
    const std::size_t repeats = CountRepeats(picks.Z, first, last);
    order.Repeats += std::int64_t(repeats);
    if (keepsAll)
    {
      order.Duplicates += std::int64_t(repeats);
      const auto end = std::unique(first, last, [&](std::int32_t a, std::int32_t b) { return z(a) == z(b); });
      kept = std::copy(first, end, kept);
      continue;
    }
    order.Duplicates += last - first - 1;
    const auto ends = std::minmax_element(first, last, [&](std::int32_t a, std::int32_t b) { return z(a) < z(b); });
    if (z(*ends.first) != z(*ends.second))
    {
      order.Conflicts.push_back({ columns[std::size_t(*first)], z(*ends.second) - z(*ends.first) });
    }
    if (options.Policy == DuplicatePolicy::Mean)
    {
      Average(picks, first, last);
      *kept++ = *first;
      continue;
    }
    *kept++ = *std::min_element(first, last, [&](std::int32_t a, std::int32_t b) { return preference.Prefers(a, b); });
  }
  order.Picks.erase(kept, order.Picks.end());
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
    sheets.emplace_back().Picks = Gather<std::vector<std::int32_t>>(order.Picks, points);
  }
  sheets.front().Duplicates = order.Duplicates + split.Dropped;
  sheets.front().Repeats = order.Repeats;
  sheets.front().Nulls = order.Nulls;
  return sheets;
}
}
