// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StrayPicks.h"

#include <algorithm>
#include <iterator>

namespace SeismicHorizons
{
namespace
{
/// The range of all values but the outer fiftieths, and as much on both sides.
struct WideRange
{
  double Least = 0.0;
  double Greatest = 0.0;

  WideRange(const std::vector<PickPlace>& picks, int axis)
  {
    std::vector<double> values;
    for (const PickPlace& pick : picks)
    {
      values.push_back(pick.Column[axis]);
    }
    const std::size_t outer = values.size() / 50;
    std::sort(values.begin(), values.end());
    const double low = values[outer];
    const double high = values[values.size() - 1 - outer];
    constexpr double fewest = 10.0; // columns
    const double width = std::max(fewest, high - low);
    this->Least = low - width;
    this->Greatest = high + width;
  }

  bool Has(double value) const { return value >= this->Least && value <= this->Greatest; }
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> FindStrays(const std::vector<PickPlace>& picks, double tolerance)
{
  const WideRange x(picks, 0);
  const WideRange y(picks, 1);
  const auto farthest = std::max_element(
    picks.begin(), picks.end(), [](const PickPlace& a, const PickPlace& b) { return a.Distance < b.Distance; });
  const double largest = std::max(tolerance, 0.5 * farthest->Distance);
  std::vector<std::size_t> strays;
  for (std::size_t pick = 0; pick < picks.size(); ++pick)
  {
    const PickPlace& place = picks[pick];
    if (!(place.Distance <= largest) || !x.Has(place.Column.x()) || !y.Has(place.Column.y()))
    {
      strays.push_back(pick);
    }
  }
  return strays;
}

//----------------------------------------------------------------------------------------------------------------------
std::string SayPicks(const PickTable& picks, const std::vector<std::size_t>& numbers)
{
  constexpr std::size_t mostNamed = 5;
  std::string text = picks.Lines.empty() ? "pick" : "line";
  text += numbers.size() > 1 ? "s " : " ";
  for (std::size_t n = 0; n < std::min(mostNamed, numbers.size()); ++n)
  {
    const auto next = std::upper_bound(picks.Lines.begin(), picks.Lines.end(), numbers[n],
      [](std::size_t pick, const PickLine& line) { return pick < line.Pick; });
    const std::int64_t number = next == picks.Lines.begin()
      ? std::int64_t(numbers[n]) + 1
      : std::prev(next)->Line + std::int64_t(numbers[n] - std::prev(next)->Pick);
    text += (n == 0 ? "" : ", ") + std::to_string(number);
  }
  return text + (numbers.size() > mostNamed ? ", ..." : "");
}

//----------------------------------------------------------------------------------------------------------------------
PickTable WithoutPicks(PickTable picks, const std::vector<std::size_t>& dropped)
{
  const auto drop = [&dropped](auto& values)
  {
    std::size_t kept = 0;
    auto next = dropped.begin();
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      if (next != dropped.end() && *next == n)
      {
        ++next;
        continue;
      }
      values[kept++] = values[n];
    }
    values.resize(kept);
  };
  drop(picks.Horizon);
  drop(picks.X);
  drop(picks.Y);
  drop(picks.Inline);
  drop(picks.Crossline);
  drop(picks.Z);
  for (PickAttribute& attribute : picks.Attributes)
  {
    drop(attribute.Values);
  }
  return picks;
}
}
