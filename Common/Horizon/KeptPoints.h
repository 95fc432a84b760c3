// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsKeptPoints_h
#define SeismicHorizonsKeptPoints_h

#include "Common/Base/LargePages.h"
#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Stored as runs of consecutive points: if few points are dropped, this takes little memory, and arrays are copied by
/// runs.
class KeptPoints
{
public:
  KeptPoints() = default;

  explicit KeptPoints(std::size_t total)
    : Total(total)
  {
  }

  static KeptPoints All(std::size_t total)
  {
    KeptPoints all(total);
    all.AppendRun(0, total);
    return all;
  }

  /// Those for which keep(point) is true.
  template <typename Keep>
  static KeptPoints If(std::size_t total, Keep&& keep)
  {
    KeptPoints kept(total);
    for (std::size_t point = 0; point < total; ++point)
    {
      kept.AppendRun(PointId(point), keep(point) ? 1 : 0);
    }
    return kept;
  }

  void Append(PointId point) { this->AppendRun(point, 1); }

  void AppendRun(PointId first, std::size_t length)
  {
    const bool goesOn =
      !this->Runs.empty() && std::size_t(first - this->Runs.back().First) == this->Count - this->Runs.back().Position;
    if (length > 0 && !goesOn)
    {
      this->Runs.push_back({ this->Count, first });
    }
    this->Count += length;
  }

  bool empty() const { return this->Count == 0; }
  std::size_t size() const { return this->Count; }
  /// All points are kept in their order.
  bool AreAll() const
  {
    return this->Count == this->Total && (this->empty() || (this->Runs.size() == 1 && this->Runs.front().First == 0));
  }

  PointId operator[](std::size_t n) const
  {
    const Run& run = this->Runs[this->RunOf(n)];
    return run.First + PointId(n - run.Position);
  }

  /// Calls visit(n, point, length) for runs from position `first` to before `last`.
  template <typename Visitor>
  void ForEachRun(std::size_t first, std::size_t last, Visitor&& visit) const
  {
    for (std::size_t run = first < last ? this->RunOf(first) : 0; first < last; ++run)
    {
      const std::size_t end = std::min(last, run + 1 < this->Runs.size() ? this->Runs[run + 1].Position : last);
      visit(first, this->Runs[run].First + PointId(first - this->Runs[run].Position), end - first);
      first = end;
    }
  }

  template <typename Values>
  auto Select(const Values& values) const
  {
    std::vector<std::decay_t<decltype(values[0])>> selected;
    selected.reserve(this->Count);
    this->ForEachRun(0, this->Count,
      [&](std::size_t, PointId point, std::size_t length)
      { selected.insert(selected.end(), values.begin() + point, values.begin() + point + std::ptrdiff_t(length)); });
    return selected;
  }

  /// Calls visit(point) for the points that are not kept, in their order.
  template <typename Visitor>
  void ForEachDropped(Visitor&& visit) const
  {
    std::vector<std::pair<PointId, PointId>> kept; // first, and behind the last
    this->ForEachRun(0, this->Count,
      [&](std::size_t, PointId point, std::size_t length) {
        kept.push_back({ point, point + PointId(length) });
      });
    std::sort(kept.begin(), kept.end());
    kept.push_back({ PointId(this->Total), PointId(this->Total) });
    PointId point = 0;
    for (const auto& [first, end] : kept)
    {
      for (; point < first; ++point)
      {
        visit(point);
      }
      point = end;
    }
  }

  std::vector<PointId> Numbers() const
  {
    std::vector<PointId> numbers = LargeVector(this->Total, NoPoint);
    this->ForEachRun(0, this->Count,
      [&](std::size_t n, PointId point, std::size_t length)
      { std::iota(numbers.begin() + point, numbers.begin() + point + std::ptrdiff_t(length), PointId(n)); });
    return numbers;
  }

private:
  struct Run
  {
    std::size_t Position; // Position in the selection.
    PointId First;
  };

  std::size_t RunOf(std::size_t n) const
  {
    const auto after = std::upper_bound(
      this->Runs.begin(), this->Runs.end(), n, [](std::size_t value, const Run& run) { return value < run.Position; });
    return std::size_t(after - this->Runs.begin()) - 1;
  }

  std::vector<Run> Runs;
  std::size_t Count = 0;
  std::size_t Total = 0;
};
}

#endif
