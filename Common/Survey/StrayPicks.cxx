// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StrayPicks.h"

#include "Common/Base/FixedChunks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<std::int64_t, 4> Divisors = { 2, 3, 5, 7 };

struct RemainderCounts
{
  std::array<std::array<std::int64_t, 7>, Divisors.size()> Picks = {};

  void Add(std::int64_t line)
  {
    for (std::size_t n = 0; n < Divisors.size(); ++n)
    {
      ++this->Picks[n][std::size_t(line % Divisors[n])];
    }
  }

  void Add(const RemainderCounts& other)
  {
    for (std::size_t n = 0; n < Divisors.size(); ++n)
    {
      for (std::size_t remainder = 0; remainder < this->Picks[n].size(); ++remainder)
      {
        this->Picks[n][remainder] += other.Picks[n][remainder];
      }
    }
  }
};

std::vector<std::size_t> FindBetween(
  const std::vector<double>& lines, double first, double step, const Monitor& monitor)
{
  const auto index = [&](std::size_t pick) { return std::llround((lines[pick] - first) / step); };
  const auto counts = AddUpChunks<RemainderCounts>(std::int64_t(lines.size()), 1 << 16, monitor,
    [&](RemainderCounts& part, std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t pick = begin; pick < end; ++pick)
      {
        part.Add(index(std::size_t(pick)));
      }
    });
  constexpr double nearlyAll = 0.98;
  for (std::size_t n = 0; n < Divisors.size(); ++n)
  {
    const auto most = std::max_element(counts.Picks[n].begin(), counts.Picks[n].end());
    if (double(*most) < nearlyAll * double(lines.size()) || *most == std::int64_t(lines.size()))
    {
      continue;
    }
    constexpr std::size_t fewest = 4;
    std::set<std::int64_t> different;
    std::vector<std::size_t> between;
    for (std::size_t pick = 0; pick < lines.size(); ++pick)
    {
      if (index(pick) % Divisors[n] != most - counts.Picks[n].begin())
      {
        between.push_back(pick);
      }
      else if (different.size() < fewest)
      {
        different.insert(index(pick));
      }
    }
    if (different.size() == fewest)
    {
      return between;
    }
  }
  return {};
}

/// Both are in order.
template <typename Value>
void Drop(const std::vector<std::size_t>& dropped, std::vector<Value>& values)
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
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> FindFarPlaces(const std::vector<Eigen::Vector2d>& places)
{
  constexpr std::size_t fewest = 8;
  if (places.size() < fewest)
  {
    return {};
  }
  Eigen::Matrix2d least = Eigen::Matrix2d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Matrix2d greatest = -least;
  std::vector<double> along(places.size());
  const std::array<std::size_t, 2> outer = { places.size() / 50, std::max<std::size_t>(1, places.size() / 10) };
  for (const int rule : { 0, 1 })
  {
    Eigen::Vector2d low;
    Eigen::Vector2d high;
    for (const int axis : { 0, 1 })
    {
      std::transform(places.begin(), places.end(), along.begin(), [&](const auto& place) { return place[axis]; });
      std::sort(along.begin(), along.end());
      low[axis] = along[outer[std::size_t(rule)]];
      high[axis] = along[along.size() - 1 - outer[std::size_t(rule)]];
    }
    const double length = (rule == 0 ? 1.0 : 10.0) * (high - low).maxCoeff();
    if (length > 0.0)
    {
      least.col(rule) = low.array() - length;
      greatest.col(rule) = high.array() + length;
    }
  }
  const Eigen::Vector2d first = least.rowwise().maxCoeff();
  const Eigen::Vector2d last = greatest.rowwise().minCoeff();
  std::vector<std::size_t> far;
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    if ((places[n].array() < first.array()).any() || (places[n].array() > last.array()).any())
    {
      far.push_back(n);
    }
  }
  return far.size() <= std::max<std::size_t>(1, places.size() / 10) ? far : std::vector<std::size_t>();
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> FindBetweenLines(
  const PickPlaces& picks, const std::optional<LineNumbering>& lines, const Monitor& monitor)
{
  if (!lines)
  {
    return {};
  }
  const std::vector<std::size_t> between =
    FindBetween(picks.Crossline, lines->FirstCrossline, lines->CrosslineStep, monitor);
  return between.empty() ? FindBetween(picks.Inline, lines->FirstInline, lines->InlineStep, monitor) : between;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> OriginalNumbers(std::vector<std::size_t> numbers, const std::vector<std::size_t>& dropped)
{
  std::size_t before = 0; // of the dropped
  for (std::size_t& number : numbers)
  {
    while (before < dropped.size() && dropped[before] <= number + before)
    {
      ++before;
    }
    number += before;
  }
  return numbers;
}

//----------------------------------------------------------------------------------------------------------------------
std::string PicksText(const PickTable& picks, std::vector<std::size_t> numbers)
{
  constexpr std::size_t mostNamed = 5;
  std::string text = picks.Lines.empty() ? "pick" : "line";
  text += numbers.size() > 1 ? "s " : " ";
  const bool areMore = numbers.size() > mostNamed;
  numbers.resize(std::min(mostNamed, numbers.size()));
  for (const std::size_t pick : OriginalNumbers(std::move(numbers), picks.Dropped))
  {
    const auto next = std::upper_bound(picks.Lines.begin(), picks.Lines.end(), pick,
      [](std::size_t number, const PickLine& line) { return number < line.Pick; });
    const std::int64_t number = next == picks.Lines.begin()
      ? std::int64_t(pick) + 1
      : std::prev(next)->Line + std::int64_t(pick - std::prev(next)->Pick);
    text += (text.back() == ' ' ? "" : ", ") + std::to_string(number);
  }
  return text + (areMore ? ", ..." : "");
}

//----------------------------------------------------------------------------------------------------------------------
PickPlaces WithoutPicks(PickPlaces picks, const std::vector<std::size_t>& dropped)
{
  for (std::vector<double>* values : { &picks.X, &picks.Y, &picks.Inline, &picks.Crossline })
  {
    Drop(dropped, *values);
  }
  return picks;
}

//----------------------------------------------------------------------------------------------------------------------
PickTable WithoutPicks(PickTable picks, const std::vector<std::size_t>& dropped)
{
  assert(picks.Dropped.empty());
  static_cast<PickPlaces&>(picks) = WithoutPicks(PickPlaces(std::move(picks)), dropped);
  Drop(dropped, picks.Horizon);
  Drop(dropped, picks.Z);
  for (PickAttribute& attribute : picks.Attributes)
  {
    Drop(dropped, attribute.Values);
  }
  picks.Dropped = dropped;
  return picks;
}
}
